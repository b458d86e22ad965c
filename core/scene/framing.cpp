#include "scene/framing.h"

#include "scene/extents.h"

namespace trundle {
namespace {

// Statics up to this many times the extent of the robots are framed whole; of larger ones only what is near the robots.
constexpr double kWholeRoom = 20, kSurroundings = 7;

Bounds shownBounds(const GeomSpec& geom, const Pose& owner) { return geom.visible ? boundsOf(geom, owner) : Bounds{}; }

} // namespace

CameraView defaultView(const ExperimentSpec& experiment, const BodyPoses& poses, std::uint32_t width, std::uint32_t height) {
    Bounds robots, statics;
    std::size_t body = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& spec : robot.config->bodies) {
            if (body >= poses.size()) break;
            for (const GeomSpec& geom : spec.geoms) robots.add(shownBounds(geom, poses[body]));
            ++body;
        }
    }
    for (const StaticSpec& fixed : experiment.statics) {
        if (fixed.geoms)
            for (const GeomSpec& geom : *fixed.geoms) statics.add(shownBounds(geom, fixed.pose));
    }
    Bounds all = robots;
    if (robots.empty()) {
        all = statics;
    } else if (!statics.empty()) {
        const double extent = std::max(robots.radius(), 0.05);
        Bounds near = robots;
        near.grow(extent * (statics.radius() <= kWholeRoom * extent ? 2 * kWholeRoom : kSurroundings));
        all.add(Bounds{statics.low.cwiseMax(near.low).cwiseMin(near.high), statics.high.cwiseMin(near.high).cwiseMax(near.low)});
    }
    return viewOf(all, width, height);
}

} // namespace trundle
