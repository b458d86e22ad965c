#pragma once
#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// A charging station with constant current, then constant voltage: it charges the batteries whose Contact touches its geoms. Its power is
/// from outside: its own robot needs no battery.
class Charger final : public Device, public ChargerSignals {
public:
    static void describe(Describe<Charger>& d);
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    /// Publishes what was taken from it in the tick before.
    void sense(Sensing& world) override;

private:
    std::vector<std::string> m_geomPaths;
    double m_voltage = 0, m_maxCurrent = 0; ///< V, A

    std::vector<GeomId> m_geoms;
};

} // namespace trundle
