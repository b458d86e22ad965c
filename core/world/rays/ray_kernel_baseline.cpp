// For every processor that the program runs on.
#define TRUNDLE_LANES 2
#include "world/rays/ray_packets.h"

namespace trundle {

const RayKernel& baselineRayKernel() {
    static const RayKernel kernel{
        "baseline", TRUNDLE_LANES, {castPlane, castBox, castSphere, castCylinder, castCapsule, castHull, castMesh, castHeights}};
    return kernel;
}

const RayKernel& rayKernel() {
    const RayKernel* fast = avx2RayKernel();
    return fast ? *fast : baselineRayKernel();
}

} // namespace trundle
