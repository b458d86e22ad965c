#pragma once
// Numbers of several vehicles in the lanes of vector registers: TRUNDLE_LANES at once, all operations element by element.
// Included only by the files of the kernels; everything has internal linkage.

#include "world/wheeled/vehicle_block.h"

namespace trundle {
namespace {

using Lanes = double __attribute__((vector_size(TRUNDLE_LANES * 8)));
using Mask = decltype(Lanes{} < Lanes{});

enum { VX, VY, WX, WY, WZ, VZ };

inline Lanes all(double x) { return Lanes{} + x; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
inline Lanes least(Lanes a, Lanes b) { return b < a ? b : a; }
inline Lanes most(Lanes a, Lanes b) { return a < b ? b : a; }
inline Lanes size(Lanes a) { return select(a < 0.0, -a, a); }
inline Lanes root(Lanes a) {
    for (int i = 0; i < TRUNDLE_LANES; ++i) a[i] = __builtin_sqrt(a[i]);
    return a;
}
inline bool any(Mask m) {
    bool found = false;
    for (int i = 0; i < TRUNDLE_LANES; ++i) found = found || m[i];
    return found;
}
inline Lanes load(const double* p) {
    Lanes v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
inline void store(double* p, Lanes v) { __builtin_memcpy(p, &v, sizeof v); }
/// To the nearest whole number, for sizes up to 2^51.
inline Lanes whole(Lanes a) {
    constexpr double kShift = 6755399441055744.0; // 1.5 * 2^52
    return (a + kShift) - kShift;
}

struct Lanes3 {
    Lanes x, y, z;
};
inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
struct Symmetric {
    Lanes xx, xy, xz, yy, yz, zz;
};
inline Lanes3 times(const Symmetric& m, const Lanes3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z, m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
struct Axes {
    Lanes3 x, y, z; // rows
};
inline Lanes3 times(const Axes& m, const Lanes3& v) { return {dot(m.x, v), dot(m.y, v), dot(m.z, v)}; }

inline Axes axesOf(Lanes w, Lanes x, Lanes y, Lanes z) {
    return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

} // namespace
} // namespace trundle
