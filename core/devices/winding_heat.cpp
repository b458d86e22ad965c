#include "devices/winding_heat.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kSheetTemperature = 25; // degC
constexpr double kCopper = 0.0039;       // 1/K: of copper, as the catalogues of maxon and Faulhaber have it
constexpr double kDerating = 10;         // K

} // namespace

/// Heat capacities follow from the time constants: C = tau / R.
void WindingHeat::heat(const ThermalConstants& c, double watts, double h) {
    const double inner = h / c.windingTimeConstant,
                 outer = h / c.housingTimeConstant;                          // of the winding; of the housing to the air
    const double passed = outer * c.housingResistance / c.windingResistance; // of the housing from the winding
    // (1 + inner) Tw - inner Th = Tw' + inner R P;  -passed Tw + (1 + passed + outer) Th = Th' + outer Ta
    const double a = 1 + inner, d = 1 + passed + outer;
    const double p = m_winding + inner * c.windingResistance * watts, q = m_housing + outer * c.ambient;
    const double det = a * d - inner * passed;
    m_winding = (d * p + inner * q) / det;
    m_housing = (a * q + passed * p) / det;
}

double WindingHeat::resistanceFactor() const { return 1 + kCopper * (m_winding - kSheetTemperature); }

double WindingHeat::currentShare(const ThermalConstants& c) const {
    return c.highest ? std::clamp((*c.highest - m_winding) / kDerating, 0.0, 1.0) : 1;
}

} // namespace trundle
