#pragma once
#include <optional>

namespace trundle {

/// Thermal data of a motor as in its data sheet: the winding heats the housing, and that the air.
struct ThermalConstants {
    double windingResistance = 0, housingResistance = 0;        ///< K/W: winding to housing, housing to air; both 0: no heating
    double windingTimeConstant = 10, housingTimeConstant = 600; ///< s
    double ambient = 25;                                        ///< degC
    std::optional<double> highest;                              ///< degC, of the winding

    [[nodiscard]] bool any() const { return windingResistance > 0 && housingResistance > 0; }
};

/// Temperatures of winding and housing.
class WindingHeat {
public:
    void start(double ambient) { m_winding = m_housing = ambient; }
    /// Heated with `watts` for `h` seconds. Implicit Euler, stable at any tick length.
    void heat(const ThermalConstants& constants, double watts, double h);
    [[nodiscard]] double winding() const { return m_winding; } ///< degC

    /// Factor of the resistance, which the data sheet has at 25 degC.
    [[nodiscard]] double resistanceFactor() const;
    /// Share of the current limit that the driver still gives: falls to nothing over the last kDerating kelvin.
    [[nodiscard]] double currentShare(const ThermalConstants& constants) const;

private:
    double m_winding = 25, m_housing = 25;
};

} // namespace trundle
