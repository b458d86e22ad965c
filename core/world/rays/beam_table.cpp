#include "world/rays/beam_table.h"

#include <algorithm>
#include <cmath>

#include "world/rays/ray_kernel.h"

namespace trundle {

namespace {

// Kernel polynomials of fdlibm (k_sin.c, k_cos.c) for |x| <= pi/4, and pi/2 in two parts, of which the first has 33 bits (e_rem_pio2.c).
constexpr double kSin[] = {-1.66666666666666324348e-01, 8.33333333332248946124e-03,  -1.98412698298579493134e-04,
                           2.75573137070700676789e-06,  -2.50507602534068634195e-08, 1.58969099521155010221e-10};
constexpr double kCos[] = {4.16666666666666019037e-02,  -1.38888888888741095749e-03, 2.48015872894767294178e-05,
                           -2.75573143513906633035e-07, 2.08757232129817482790e-09,  -1.13596475577881948265e-11};
constexpr double kQuarter = 1.57079632673412561417e+00, kQuarterRest = 6.07710050650619224932e-11;
constexpr double kPerQuarter = 6.36619772367581382433e-01;

double polynomial(const double (&c)[6], double z) { return c[0] + z * (c[1] + z * (c[2] + z * (c[3] + z * (c[4] + z * c[5])))); }

} // namespace

Direction directionOf(double angle) {
    const double quarters = std::floor(angle * kPerQuarter + 0.5);
    const double x = (angle - quarters * kQuarter) - quarters * kQuarterRest, z = x * x;
    const double s = x + x * z * polynomial(kSin, z), c = 1 - (0.5 * z - z * z * polynomial(kCos, z));
    switch (static_cast<long long>(quarters) & 3) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
    }
}

BeamTable::BeamTable(const RayFan& fan)
    : firstBearing(fan.firstBearing), bearingStep(fan.bearingStep), count(fan.count),
      elevations(fan.elevations.begin(), fan.elevations.end()) {
    for (std::uint32_t k = 0; k < count + kBeamPadding; ++k) {
        const Direction d = directionOf(firstBearing + bearingStep * std::min(k, count - 1));
        cosines.push_back(d.cosine);
        sines.push_back(d.sine);
    }
    for (const double e : elevations) layers.push_back(directionOf(e));
}

bool BeamTable::fits(const RayFan& fan) const {
    return count == fan.count && firstBearing == fan.firstBearing && bearingStep == fan.bearingStep &&
           std::equal(elevations.begin(), elevations.end(), fan.elevations.begin(), fan.elevations.end());
}

const BeamTable& BeamTables::of(const RayFan& fan) {
    if (m_tables[m_last] && m_tables[m_last]->fits(fan)) return *m_tables[m_last];
    for (std::size_t i = 0; i < m_tables.size() && m_tables[i]; ++i)
        if (m_tables[i]->fits(fan)) return *m_tables[m_last = i];
    m_last = m_next;
    m_next = (m_next + 1) % m_tables.size();
    m_tables[m_last] = std::make_unique<BeamTable>(fan);
    return *m_tables[m_last];
}

} // namespace trundle
