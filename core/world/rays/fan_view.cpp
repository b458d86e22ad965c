#include "world/rays/fan_view.h"

#include <algorithm>
#include <numbers>

namespace trundle {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kError = 2e-4; // rad: of roughBearing
constexpr BearingSector kFullTurn{-kPi, kPi + 1e-9};

/// atan2 within kError, by a polynomial of degree 7 on an eighth of a turn.
double roughBearing(double y, double x) {
    const double ax = std::abs(x), ay = std::abs(y), a = std::min(ax, ay) / std::max({ax, ay, 1e-30}), s = a * a;
    double r = ((-0.0464964749 * s + 0.15931422) * s - 0.327622764) * s * a + a;
    if (ay > ax) r = kPi / 2 - r;
    if (x < 0) r = kPi - r;
    return y < 0 ? -r : r;
}

/// At least asin(x), for 0 <= x <= 1.
double arcSineBound(double x) { return x + 0.571 * x * x * x; }

} // namespace

FanView::FanView(const RayFan& fan, const BeamTable& table)
    : m_fan(fan), m_table(table), m_flat(table.layers.size() == 1 && table.elevations[0] == 0) {
    const double first = table.firstBearing, last = first + (table.count - 1) * table.bearingStep;
    m_lowest = std::min(first, last);
    m_highest = std::max(first, last);
    m_perStep = table.bearingStep != 0 && table.count > 1 ? 1 / table.bearingStep : 0;
}

bool FanView::aim(const GeomBall& ball, Aim& aim) const {
    const Vec3 p(ball.x - m_fan.origin.x(), ball.y - m_fan.origin.y(), ball.z - m_fan.origin.z());
    const double x = p.dot(m_fan.axes.col(0)), y = p.dot(m_fan.axes.col(1));
    aim.height = p.dot(m_fan.axes.col(2));
    double r2 = ball.r * ball.r;
    if (m_flat && (r2 -= aim.height * aim.height) < 0) return false; // only a disc of the ball is in its plane
    const double rho2 = x * x + y * y;
    aim.rho = std::sqrt(rho2);
    aim.holds = rho2 <= r2;
    if (aim.holds) {
        aim.sector = kFullTurn;
    } else {
        const double half = arcSineBound(std::sqrt(r2 / rho2)) + 2 * kError, middle = roughBearing(y, x);
        aim.sector = {middle - half, middle + half};
    }
    return true;
}

/// Measured from its point nearest to the fan, from which all corners are within a right angle.
BearingSector FanView::sectorOf(const Vec3& centre, const Mat3& axes, const Vec3& half) const {
    const Vec3 from = axes.transpose() * (m_fan.origin - centre);
    const Vec3 nearest = centre + axes * from.cwiseMax(-half).cwiseMin(half) - m_fan.origin;
    const Vec3 forwards = m_fan.axes.col(0), left = m_fan.axes.col(1);
    const double u = nearest.dot(forwards), v = nearest.dot(left);
    if (u * u + v * v < 1e-12) return kFullTurn;
    // Along the direction to the nearest point and to its left, both by its distance: of the box's middle, and how far its corners are from it.
    const Vec3 to = u * forwards + v * left, aside = u * left - v * forwards, middle = centre - m_fan.origin;
    const Vec3 halfTo = half.cwiseProduct(axes.transpose() * to), halfAside = half.cwiseProduct(axes.transpose() * aside);
    const double middleTo = middle.dot(to), middleAside = middle.dot(aside);
    if (middleTo - halfTo.cwiseAbs().sum() <= 1e-9) return kFullTurn;
    double least = 1e300, most = -1e300;
    for (int k = 0; k < 8; ++k) {
        const Vec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        const double slope = (middleAside + sign.dot(halfAside)) / (middleTo + sign.dot(halfTo));
        least = std::min(least, slope);
        most = std::max(most, slope);
    }
    const double bearing = roughBearing(v, u);
    return {bearing + roughBearing(least, 1) - 3 * kError, bearing + roughBearing(most, 1) + 3 * kError};
}

void FanView::bounds(Vec3& lo, Vec3& hi) const {
    const Vec3 reach = Vec3::Constant(m_fan.range);
    lo = m_fan.origin - reach;
    hi = m_fan.origin + reach;
    const bool wide = m_highest - m_lowest > 2; // rad: reaches nearly everywhere
    if (wide || m_fan.size() > 64) return;
    lo = hi = m_fan.origin;
    for (std::size_t layer = 0; layer < m_table.layers.size(); ++layer)
        for (std::uint32_t k = 0; k < m_table.count; ++k) {
            const Vec3 end = m_fan.origin + m_fan.range * (m_fan.axes * m_table.direction(layer, k));
            lo = lo.cwiseMin(end);
            hi = hi.cwiseMax(end);
        }
    lo.array() -= 1e-9;
    hi.array() += 1e-9;
}

} // namespace trundle
