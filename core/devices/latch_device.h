#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// A coupling, a magnet or a suction cup: on command it holds the nearest thing along its axis rigidly as it is to it. Commands are read in
/// the act phase; what is within Reach is that of the poses before the tick.
class Latch final : public Device, public LatchSignals {
public:
    static void describe(Describe<Latch>& d);
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    /// What is there; an empty id: nothing.
    [[nodiscard]] GeomId find(const Services& world) const;

    std::string m_bodyName;
    std::array<double, 3> m_position{0, 0, 0}, m_hpr{0, 0, 0};
    double m_reach = 0.02;            ///< m
    std::optional<double> m_maxForce; ///< N

    BodyId m_body;
    Pose m_pose;            ///< in the body; its axis is x
    bool m_tornOff = false; ///< until engage ends
};

} // namespace trundle
