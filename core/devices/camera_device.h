#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Publishes the time of its newest image. The image itself is rendered only on request, from the same fields.
class Camera final : public Device, public CameraSignals {
public:
    static void describe(Describe<Camera>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    std::string m_bodyName;
    std::array<double, 3> m_position{0, 0, 0}, m_turn{0, 0, 0};
    std::array<double, 2> m_resolution{320, 240}, m_distortion{0, 0};
    double m_fieldOfView, m_near = 0.05, m_far = 100, m_noise = 0, m_exposure = 1, m_updatePeriod = 0, m_power = 0;
    std::string m_mode = "color";
    bool m_seesSelf = true;

    double m_taken = 0; ///< number of images so far

public:
    Camera();
};

} // namespace trundle
