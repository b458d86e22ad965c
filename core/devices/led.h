#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// A light-emitting diode on a body, or a lamp of any other make: cameras see its lens, light sensors its light. Commands are read in the act
/// phase, and sensors of the same tick see the light.
class Led final : public Device, public LedSignals {
public:
    static void describe(Describe<Led>& d);
    /// Commands start as the properties say.
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    std::string m_bodyName;
    std::array<double, 3> m_position{0, 0, 0}, m_hpr{0, 0, 0}, m_color{1, 1, 1};
    double m_intensity = 1;            ///< cd along its axis, of white
    std::optional<double> m_halfAngle; ///< rad
    double m_diameter = 0.005;         ///< m
    bool m_on = true;
    double m_power = 0; ///< W

    BodyId m_body;
    TrundleBeam m_beam{{1, 0, 0}, 0, 0};
    bool m_shines = false;
};

} // namespace trundle
