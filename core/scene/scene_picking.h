#pragma once
#include <string>
#include <vector>

#include <osg/Node>

#include "scene/queries/camera_view.h"

namespace trundle {

struct SceneHit {
    std::string path; ///< "robot0/chassis/hull", "arena/north"
    Vec3 point = Vec3::Zero();
    double distance = 0; ///< m from the ray's origin
};

/// All geoms of a scene that a ray hits, nearest first, each once. `mask` selects robots, statics and floors.
[[nodiscard]] std::vector<SceneHit> pickAll(osg::Node& scene, const ViewRay& ray, std::uint32_t mask);

} // namespace trundle
