#pragma once
// Which robots are in the regions of a world.

#include <cstdint>
#include <vector>

#include "world/device_texts.h"
#include "world/world_objects.h"

namespace trundle {

class WorldRegions {
public:
    /// Both outlive this.
    WorldRegions(const ExperimentSpec& experiment, DeviceTexts& texts) : m_experiment(experiment), m_texts(texts) {}

    /// After each step, and at the start with `ticks` 0: finds who is inside, and prints who has entered and left since.
    void update(const WorldObjects& objects, const Engine& engine, std::uint64_t ticks);
    /// A robot is moved at the start of a step: it does not pass through what is in between.
    void placed(std::size_t robot);
    /// In the order of planBetweenRobots().
    void write(double* to) const;

private:
    struct Region {
        double count = 0, entered = 0, left = 0;
        std::vector<std::uint8_t> inside; ///< by its robots
        std::vector<Vec3> last; ///< by its robots, in its frame: where they were after the last step; not finite: unknown
    };
    void cross(const RegionSpec& spec, Region& region, const std::string& robot, bool inwards);

    const ExperimentSpec& m_experiment;
    DeviceTexts& m_texts;
    std::vector<Region> m_regions;
};

} // namespace trundle
