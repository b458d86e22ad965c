#include "world/world_regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trundle {

namespace {

const Vec3 kUnknown = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// Whether a way in the frame of a box of this size, between two points outside, leads through it. Only of a way that is longer
/// than the box is thin: what is slower counts where it is at the end of a tick.
bool leadsThrough(const Vec3& from, const Vec3& to, const Vec3& size) {
    const Vec3 way = to - from;
    const double thin = size.minCoeff();
    if (!(way.squaredNorm() > thin * thin)) return false; // also if `from` is not finite
    double enters = 0, leaves = 1;                        // parts of the way
    for (int axis = 0; axis < 3; ++axis) {
        const double half = size[axis] / 2;
        if (way[axis] == 0 && std::abs(from[axis]) > half) return false;
        if (way[axis] == 0) continue;
        const auto [near, far] = std::minmax({(-half - from[axis]) / way[axis], (half - from[axis]) / way[axis]});
        enters = std::max(enters, near);
        leaves = std::min(leaves, far);
    }
    return enters <= leaves;
}

} // namespace

void WorldRegions::update(const WorldObjects& objects, const Engine& engine, std::uint64_t ticks) {
    m_regions.resize(m_experiment.regions.size());
    for (std::size_t i = 0; i < m_regions.size(); ++i) {
        const RegionSpec& spec = m_experiment.regions[i];
        Region& region = m_regions[i];
        region.inside.resize(spec.robots.size());
        region.last.resize(spec.robots.size(), kUnknown);
        const Pose toRegion = spec.pose.inverse();
        for (std::size_t k = 0; k < spec.robots.size(); ++k) {
            const BuiltRobot& robot = objects.robots()[spec.robots[k]];
            const Vec3 at = toRegion * WorldObjects::reportedPose(robot, engine, ticks).position;
            const Vec3 from = std::exchange(region.last[k], at);
            const bool isInside = (at.cwiseAbs() - spec.size / 2).maxCoeff() <= 0, wasInside = region.inside[k] != 0;
            if (isInside == wasInside) {
                if (isInside || !leadsThrough(from, at, spec.size)) continue;
                cross(spec, region, robot.spec->name, true);
                cross(spec, region, robot.spec->name, false);
                continue;
            }
            region.inside[k] = isInside;
            region.count += isInside ? 1 : -1;
            if (ticks > 0) cross(spec, region, robot.spec->name, isInside); // else it is there from the start
        }
    }
}

void WorldRegions::cross(const RegionSpec& spec, Region& region, const std::string& robot, bool inwards) {
    ++(inwards ? region.entered : region.left);
    m_texts.print(spec.name, TRUNDLE_INFO, (robot + (inwards ? " entered" : " left")).c_str());
}

void WorldRegions::placed(std::size_t robot) {
    for (std::size_t i = 0; i < m_regions.size(); ++i) {
        const auto& robots = m_experiment.regions[i].robots;
        for (std::size_t k = 0; k < robots.size(); ++k)
            if (robots[k] == robot) m_regions[i].last[k] = kUnknown;
    }
}

void WorldRegions::write(double* to) const {
    for (const Region& region : m_regions) {
        *to++ = region.count;
        *to++ = region.entered;
        *to++ = region.left;
        to = std::copy(region.inside.begin(), region.inside.end(), to);
        if (region.inside.empty()) *to++ = 0;
    }
}

} // namespace trundle
