#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Pressed from when the forces of its geoms' contacts sum to at least MinForce until they sum to less than ReleaseForce. Uses the contacts of the
/// last step.
class TouchSensor final : public Device, public TouchSensorSignals {
public:
    static void describe(Describe<TouchSensor>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    std::vector<std::string> m_geomPaths;
    double m_minForceN = 0;
    std::optional<double> m_releaseForceN;

    std::vector<GeomId> m_geoms;
    std::vector<TrundleContact> m_contacts;
    bool m_isPressed = false;
};

} // namespace trundle
