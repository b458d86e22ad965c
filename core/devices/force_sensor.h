#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Force and torque that act across a joint: of its parent on its child, all constraints and motors of the joint together, over the last
/// tick. In the sensor's frame; the torque is about the sensor's place, wherever it is fixed.
class ForceSensor final : public Sensor, public ForceSensorSignals {
public:
    static void describe(Describe<ForceSensor>& d);

private:
    void begin(Mount& mount) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;
    [[nodiscard]] Quat turnedInTick(const Sensing& world) const;
    [[nodiscard]] double measured(std::size_t part, int axis, double truth, const Services& world) const;

    std::string m_jointName;
    // Each first for forces (N), then for torques (N m).
    std::array<double, 2> m_noise{0, 0}, m_range{0, 0}, m_resolution{0, 0};
    std::array<double, 3> m_forceBias{0, 0, 0}, m_torqueBias{0, 0, 0};

    JointId m_joint;
};

} // namespace trundle
