#pragma once
#include <cstdint>

namespace trundle {

/// Node masks: what an image shows. Sensor images contain only physical objects, no editor aids.
enum SceneMask : std::uint32_t {
    kMaskRobots = 1u << 0,
    kMaskStatics = 1u << 1,
    kMaskFloor = 1u << 2,
    kMaskSky = 1u << 3,
    kMaskShadows = 1u << 4,      ///< one hard shadow, cheap to draw
    kMaskSoftShadows = 1u << 5,  ///< shadows that soften with the distance to their caster; for still images
    kMaskCollision = 1u << 6,    ///< collision shapes as lines
    kMaskGhosts = 1u << 7,       ///< last valid geometry of blocks that no longer resolve
    kMaskData = 1u << 8,         ///< depth and object numbers instead of colours
    kMaskGuide = 1u << 9,        ///< grid at z = 0 where there is no floor, as an editing aid
    kMaskOverlay = 1u << 10,     ///< viewport overlays
    kMaskSolid = 1u << 11,       ///< robots and statics, without transparent surfaces
    kMaskLampShadows = 1u << 12, ///< lamp shadows only; also included in kMaskShadows and kMaskSoftShadows

    kMaskWorld = kMaskRobots | kMaskStatics | kMaskFloor | kMaskSky,
    kMaskSensor = kMaskWorld | kMaskShadows,
    kMaskStill = kMaskWorld | kMaskSoftShadows,
};

} // namespace trundle
