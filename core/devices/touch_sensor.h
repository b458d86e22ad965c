#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Pressed while its geoms have contacts whose forces sum to at least MinForce. Uses the contacts of the last step.
class TouchSensor final : public Device, public TouchSensorSignals {
public:
    static void describe(Describe<TouchSensor>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    std::vector<std::string> m_geomPaths;
    double m_minForceN = 0;

    std::vector<GeomId> m_geoms;
    std::vector<TrundleContact> m_contacts;
};

} // namespace trundle
