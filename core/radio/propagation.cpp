// Needs: positions of two antennas. Assumptions: flat ground at z = 0 for the two-ray model, both rays with the gain of the
// direct one. Method for shadowing: a sum of cosines whose wave vectors follow the spectrum of exp(-|d|/dc) in space, which is a
// Cauchy distribution (Rahimi and Recht, Random Features for Large-Scale Kernel Machines, 2007). It is a pure function:
// evaluating a link changes no state.
#include "radio/propagation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "base/rng.h"

namespace trundle {

namespace {

constexpr double kLight = 299792458.0;
constexpr int kWaves = 32;
constexpr double kMaxSigmas = 4;
constexpr std::uint64_t kShadowSalt = 0x5348414457ull;

/// The cosines whose sum is the shadowing of one pair.
class ShadowWaves {
public:
    ShadowWaves(std::uint64_t seed, std::uint64_t pair, double correlation)
        : m_seed(seed), m_pair(pair), m_correlation(correlation) {
        for (int number = 0; number < kWaves; ++number) {
            std::uint64_t index = static_cast<std::uint64_t>(number) * 32;
            const auto normal = [&] {
                const double n =
                    toNormal(randomBits(seed, pair, kShadowSalt, index), randomBits(seed, pair, kShadowSalt, index + 1));
                index += 2;
                return n;
            };
            Wave& wave = m_waves[static_cast<std::size_t>(number)];
            wave.phase = 2 * std::numbers::pi * toUnit(randomBits(seed, pair, kShadowSalt, index++));
            if (correlation > 0) {
                for (std::size_t end = 0; end < 2; ++end) {
                    wave.direction[end] = Vec3(normal(), normal(), normal());
                    wave.length[end] = std::max(std::abs(normal()), 1e-9) * correlation;
                }
            }
        }
    }

    [[nodiscard]] bool belongTo(std::uint64_t seed, std::uint64_t pair, double correlation) const {
        return seed == m_seed && pair == m_pair && correlation == m_correlation;
    }
    [[nodiscard]] double at(const Vec3& first, const Vec3& second) const {
        double sum = 0;
        for (const Wave& wave : m_waves) {
            double phase = wave.phase;
            if (m_correlation > 0)
                phase = phase + wave.direction[0].dot(first) / wave.length[0] + wave.direction[1].dot(second) / wave.length[1];
            sum += std::cos(phase);
        }
        return std::clamp(sum * std::sqrt(2.0 / kWaves), -kMaxSigmas, kMaxSigmas);
    }

private:
    struct Wave {
        double phase = 0;
        std::array<Vec3, 2> direction;
        std::array<double, 2> length{};
    };
    std::uint64_t m_seed, m_pair;
    double m_correlation;
    std::array<Wave, kWaves> m_waves;
};

} // namespace

double wavelength(double frequency) { return kLight / frequency; }

double freeSpaceLoss(double distance, double lambda) {
    return 20 * std::log10(4 * std::numbers::pi * std::max(distance, kNearest) / lambda);
}

double twoRayLoss(const Vec3& a, const Vec3& b, double lambda, double permittivity) {
    const double across = std::hypot(a.x() - b.x(), a.y() - b.y()), sum = std::abs(a.z() + b.z());
    const double direct = std::max(std::hypot(across, a.z() - b.z()), kNearest),
                 bounced = std::max(std::hypot(across, sum), kNearest);
    double reflected = -1;
    if (permittivity > 0) {
        const double sine = sum / bounced, cosine2 = 1 - sine * sine, root = std::sqrt(std::max(0.0, permittivity - cosine2));
        reflected = (permittivity * sine - root) / (permittivity * sine + root);
    }
    const double k = 2 * std::numbers::pi / lambda;
    const std::complex<double> field = std::polar(1 / direct, -k * direct) + reflected * std::polar(1 / bounced, -k * bounced);
    const double strength = std::max(std::abs(field), 1e-12); // avoids the logarithm of 0 at total cancellation
    return -20 * std::log10(lambda / (4 * std::numbers::pi) * strength);
}

double logDistanceLoss(double distance, double lambda, double exponent) {
    return freeSpaceLoss(std::min(distance, 1.0), lambda) + 10 * exponent * std::log10(std::max(distance, 1.0));
}

double shadowing(std::uint64_t seed, std::uint64_t pair, const Vec3& first, const Vec3& second, double correlation) {
    // Radio maps evaluate one pair at thousands of positions, and setting up the waves is most of the work. Caching does not
    // change the result.
    thread_local std::optional<ShadowWaves> waves;
    if (!waves || !waves->belongTo(seed, pair, correlation)) waves.emplace(seed, pair, correlation);
    return waves->at(first, second);
}

} // namespace trundle
