// Compiled for AVX2 where the compiler's target has it (CMakeLists.txt), without fused multiply-add.
#include "world/rays/ray_kernel.h"

#ifdef __AVX2__
#define TRUNDLE_LANES 4
#include "world/rays/ray_packets.h"

namespace trundle {

const RayKernel* avx2RayKernel() {
    static const RayKernel kernel{
        "AVX2", TRUNDLE_LANES, {castPlane, castBox, castSphere, castCylinder, castCapsule, castHull, castMesh, castHeights}};
    return __builtin_cpu_supports("avx2") ? &kernel : nullptr;
}

} // namespace trundle
#else
namespace trundle {
const RayKernel* avx2RayKernel() { return nullptr; }
} // namespace trundle
#endif
