#pragma once
// Vectors of doubles, one number for each of several beams. TRUNDLE_LANES is their count; all operations are element by element, so
// that a beam's result does not depend on it. Compilers make one instruction of each of the loops. Included only by the files of the
// kernels; everything has internal linkage.

namespace trundle {
namespace {

using Lanes = double __attribute__((vector_size(TRUNDLE_LANES * 8)));
using Mask = decltype(Lanes{} < Lanes{});

constexpr double kFar = __builtin_huge_val();
constexpr double kTiny = 1e-30;

inline Lanes all(double x) { return Lanes{} + x; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
inline Lanes least(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes most(Lanes a, Lanes b) { return a > b ? a : b; }
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

/// A number that can be divided by.
inline Lanes nonZero(Lanes d) { return select(size(d) < kTiny, all(kTiny), d); }

struct Lanes3 {
    Lanes x, y, z;
};
inline Lanes dot(const double* a, const Lanes3& d) { return a[0] * d.x + a[1] * d.y + a[2] * d.z; }
inline double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline void cross(const double* a, const double* b, double* out) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

} // namespace
} // namespace trundle
