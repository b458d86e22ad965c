#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Counts of an encoder disc on a joint: floor(angle CPR / 2 pi), four edges per line if Quadrature is set. It publishes only
/// counted values; the angle between two counts is lost, as on real hardware.
class Encoder final : public Device, public EncoderSignals {
public:
    static void describe(Describe<Encoder>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    std::string m_jointName;
    double m_countsPerRevolution = 512;
    bool m_quadrature = false;
    bool m_hasIndex = false;

    JointId m_joint;
    double m_lastCount = 0;
    double m_lastTurn = 0;
};

/// The count at an angle (rad). Edges are shifted 1e-9 counts early, so that rounding does not toggle the count at rest on an
/// edge.
[[nodiscard]] double encoderCount(double angle, double countsPerTurn);

} // namespace trundle
