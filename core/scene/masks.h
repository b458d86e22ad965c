#pragma once
#include <cstdint>

namespace trundle {

/// What of a scene a picture shows. Sensors see no more than is there.
enum SceneMask : std::uint32_t {
    kMaskRobots = 1u << 0,
    kMaskStatics = 1u << 1,
    kMaskFloor = 1u << 2,
    kMaskSky = 1u << 3,
    kMaskShadows = 1u << 4,      ///< one sharp shadow: cheap
    kMaskSoftShadows = 1u << 5,  ///< shadows that soften with their distance from what casts them: for stills
    kMaskCollision = 1u << 6,    ///< what collides, as lines
    kMaskGhosts = 1u << 7,       ///< the last whole drawing of what the text no longer says
    kMaskData = 1u << 8,         ///< distances and numbers of objects in place of colours
    kMaskGuide = 1u << 9,        ///< the lines of a floor at z = 0 where there is none, for whoever builds there
    kMaskOverlay = 1u << 10,     ///< what a window lays over the scene
    kMaskSolid = 1u << 11,       ///< robots and statics, without what one can see through
    kMaskLampShadows = 1u << 12, ///< those of lamps alone; they are part of kMaskShadows and of kMaskSoftShadows too

    kMaskWorld = kMaskRobots | kMaskStatics | kMaskFloor | kMaskSky,
    kMaskSensor = kMaskWorld | kMaskShadows,
    kMaskStill = kMaskWorld | kMaskSoftShadows,
};

} // namespace trundle
