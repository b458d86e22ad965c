#pragma once
#include <optional>
#include <string>
#include <vector>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// The battery of a robot: a voltage that falls with its charge, behind a resistance. All devices of the robot draw from it; what they drew
/// in a tick lowers the voltage of the next one. What it gives, voltage x current, is what they drew. Empty, it gives nothing until it is
/// charged: by a Charger that its Contact touches.
class Battery final : public Device, public BatterySignals {
public:
    static void describe(Describe<Battery>& d);
    /// Fails if the robot has another one, or if DischargeCurve is no curve.
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    [[nodiscard]] double openVoltageAt(double level) const;
    /// Of what was drawn at `volts`, A. Warns once if that is more than it can give.
    [[nodiscard]] double currentOf(const TrundleLoad& load, double volts, double open, const Services& world);
    /// From the charger that it touches, A, while its devices draw `drawn`. Constant current, then constant voltage.
    [[nodiscard]] double chargingCurrent(Sensing& world, double drawn, double open);

    double m_capacity = 0, m_startLevel = 1; ///< C, 1
    std::optional<double> m_voltage;         ///< V
    std::optional<int> m_cells;
    std::string m_chemistry = "NiMH";
    std::vector<double> m_curve;             ///< level, voltage of a cell (V) ...; empty: that of the chemistry
    double m_resistance = 0, m_baseLoad = 0; ///< ohm, W
    std::vector<std::string> m_contactPaths;

    double m_charge = 0; ///< C
    bool m_reported = false;
    std::vector<GeomId> m_contacts;
    std::vector<TrundleContact> m_touched;
};

} // namespace trundle
