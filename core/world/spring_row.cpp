// Method: one step of m (v' - v) = -h (k q + give v' + carry v), q' = q + h v', has the eigenvalues exp(-p) and exp(-r) of the
// continuous oscillator, p + r = h c / m and p r = h^2 k / m, if 1 + h give / m = p r / ((1 - exp(-p)) (1 - exp(-r))) and
// 1 - h carry / m = exp(-p - r) (1 + h give / m). Rest positions are exact because only the old q appears.
#include "world/spring_row.h"

#include <cmath>

namespace trundle {

namespace {

constexpr double kSmall = 1e-5; // below it the series is more accurate

/// x / (1 - exp(-x)).
double ratio(double x) { return x < 1e-9 ? 1 + x / 2 : -x / std::expm1(-x); }

} // namespace

double springTurn(double stiffness, double damping, double inertia, double h) {
    const double decay = h * damping / (2 * inertia), square = h * h * stiffness / inertia - decay * decay;
    return square > 0 ? std::sqrt(square) : 0;
}

SpringRow springRow(double stiffness, double damping, double inertia, double h) {
    const double turn = springTurn(stiffness, damping, inertia, h);
    if (!(inertia > 0) || !(turn <= kMaxSpringTurn)) return {h * stiffness + damping, 0};
    const double sum = h * damping / inertia, product = h * h * stiffness / inertia;
    if (sum < kSmall && product < kSmall) {
        const double give = damping / 2 + sum * damping / 12 + h * stiffness / 12;
        return {give, damping - give};
    }
    double grown = 1; // 1 + h give / m
    if (turn > 0) {
        const double shrunk = std::exp(-sum / 2), lost = -std::expm1(-sum / 2), half = std::sin(turn / 2);
        grown = product / (lost * lost + 4 * shrunk * half * half);
    } else {
        const double root = std::sqrt(std::fmax(0, sum * sum / 4 - product)), fast = sum / 2 + root, slow = product / fast;
        grown = ratio(fast) * ratio(slow);
    }
    const double scale = inertia / h;
    return {scale * (grown - 1), scale * (1 - std::exp(-sum) * grown)};
}

} // namespace trundle
