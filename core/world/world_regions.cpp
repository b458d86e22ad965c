#include "world/world_regions.h"

#include <algorithm>

namespace trundle {

void WorldRegions::update(const WorldObjects& objects, const Engine& engine, std::uint64_t ticks) {
    m_regions.resize(m_experiment.regions.size());
    for (std::size_t i = 0; i < m_regions.size(); ++i) {
        const RegionSpec& spec = m_experiment.regions[i];
        Region& region = m_regions[i];
        region.inside.resize(spec.robots.size());
        const Pose toRegion = spec.pose.inverse();
        for (std::size_t k = 0; k < spec.robots.size(); ++k) {
            const BuiltRobot& robot = objects.robots()[spec.robots[k]];
            const Vec3 at = toRegion * WorldObjects::reportedPose(robot, engine, ticks).position;
            const bool isInside = (at.cwiseAbs() - spec.size / 2).maxCoeff() <= 0;
            if (isInside == (region.inside[k] != 0)) continue;
            region.inside[k] = isInside;
            region.count += isInside ? 1 : -1;
            if (ticks == 0) continue; // it is there from the start
            ++(isInside ? region.entered : region.left);
            m_texts.print(spec.name, TRUNDLE_INFO, (robot.spec->name + (isInside ? " entered" : " left")).c_str());
        }
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
