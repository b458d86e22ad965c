#pragma once
// The radio medium of a world: where its radios are, and the obstacles between them.

#include <vector>

#include "radio/medium.h"
#include "world/world_objects.h"

namespace trundle {

/// Position of a radio on its robot.
struct RadioMount {
    std::uint32_t body = 0, robot = 0; ///< body: engine body
    Pose mount;                        ///< pose of the antenna in the body's frame
};

class WorldRadio {
public:
    /// All of these outlive this.
    WorldRadio(const ExperimentSpec& experiment, const Engine& engine, const WorldObjects& objects);
    WorldRadio(const WorldRadio&) = delete;
    WorldRadio& operator=(const WorldRadio&) = delete;

    RadioId open(RadioDefinition definition, const RadioMount& mount);
    /// Moves the antennas to where their bodies are.
    void place();
    /// The radios of a robot whose battery is empty.
    void switchOff(std::uint32_t robot);
    /// Advances the medium by the tick that is about to be stepped, with the poses at its start.
    void advance(double until);

    [[nodiscard]] Medium& medium() { return m_medium; }
    [[nodiscard]] const Medium& medium() const { return m_medium; }

private:
    [[nodiscard]] int solids(RadioId first, const Vec3& a, RadioId second, const Vec3& b) const;

    const Engine& m_engine;
    const WorldObjects& m_objects;
    Medium m_medium;
    std::vector<RadioMount> m_mounts; ///< by radio
};

} // namespace trundle
