// Needs: RSSI over the antenna's heading. Assumptions: near its peak the main lobe is symmetric and, in dB, nearly a parabola;
// the sender does not move.
// Method: start from the mean direction of the samples weighted by signal strength, fit a parabola by least squares to the
// samples within half a window of it, and fit again around the resulting peak. Rounding of the readings averages out over the
// window.
#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr double kHalfWindow = 50 * std::numbers::pi / 180;
constexpr std::size_t kLeastSamples = 6;
constexpr int kRounds = 6;

/// Fits a + b x + c x^2 by least squares; false if the samples have no peak.
bool fitParabola(const std::vector<Sweep::Sample>& samples, double centre, double& peak, double& rssi) {
    double s[5] = {}, t[3] = {};
    for (const Sweep::Sample& sample : samples) {
        const double x = wrapAngle(sample.heading - centre);
        if (std::abs(x) > kHalfWindow) continue;
        double power = 1;
        for (int i = 0; i < 5; ++i) {
            s[i] += power;
            if (i < 3) t[i] += power * sample.rssi;
            power *= x;
        }
    }
    if (s[0] < kLeastSamples) return false;
    const double d = s[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * s[3] - s[2] * s[2]);
    if (std::abs(d) < 1e-12) return false;
    const double a =
        (t[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (t[1] * s[4] - t[2] * s[3]) + s[2] * (t[1] * s[3] - t[2] * s[2])) / d;
    const double b =
        (s[0] * (t[1] * s[4] - t[2] * s[3]) - t[0] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * t[2] - s[2] * t[1])) / d;
    const double c =
        (s[0] * (s[2] * t[2] - s[3] * t[1]) - s[1] * (s[1] * t[2] - s[2] * t[1]) + t[0] * (s[1] * s[3] - s[2] * s[2])) / d;
    if (c >= -1e-6) return false;
    peak = std::clamp(-b / (2 * c), -kHalfWindow, kHalfWindow);
    rssi = a + b * peak + c * peak * peak;
    return true;
}

} // namespace

double wrapAngle(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

std::optional<Sweep::Bearing> Sweep::bearing(std::uint32_t sender) const {
    const auto it = m_samples.find(sender);
    if (it == m_samples.end() || it->second.size() < kLeastSamples) return std::nullopt;
    const std::vector<Sample>& samples = it->second;
    const auto best =
        std::max_element(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.rssi < b.rssi; });
    double x = 0, y = 0;
    for (const Sample& s : samples) {
        const double weight = std::pow(10, (s.rssi - best->rssi) / 20);
        x += weight * std::cos(s.heading);
        y += weight * std::sin(s.heading);
    }
    double centre = std::atan2(y, x), rssi = best->rssi;
    if (std::abs(wrapAngle(centre - best->heading)) > kHalfWindow) centre = best->heading;
    for (int round = 0; round < kRounds; ++round) {
        double peak = 0;
        if (!fitParabola(samples, centre, peak, rssi)) return Bearing{wrapAngle(best->heading), best->rssi};
        centre += peak;
        if (std::abs(peak) < 1e-4) break;
    }
    return Bearing{wrapAngle(centre), rssi};
}
