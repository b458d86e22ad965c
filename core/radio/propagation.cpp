// Needs: places of two antennas. Assumptions: flat ground at z = 0 for the two rays, both of which get the gain of the direct one.
// Method for shadowing: a sum of cosines whose wave vectors follow the spectrum of exp(-|d|/dc) in space, which is a Cauchy distribution
// (Rahimi and Recht, Random Features for Large-Scale Kernel Machines, 2007). A function, not a state: looking at a link changes nothing.
#include "radio/propagation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/rng.h"

namespace trundle {

namespace {

constexpr double kLight = 299792458.0;
constexpr int kWaves = 32;
constexpr double kMostSigmas = 4;
constexpr std::uint64_t kShadowSalt = 0x5348414457ull;

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
    const double strength = std::max(std::abs(field), 1e-12); // of a perfect null
    return -20 * std::log10(lambda / (4 * std::numbers::pi) * strength);
}

double logDistanceLoss(double distance, double lambda, double exponent) {
    return freeSpaceLoss(1, lambda) + 10 * exponent * std::log10(std::max(distance, kNearest));
}

double shadowing(std::uint64_t seed, std::uint64_t pair, const Vec3& first, const Vec3& second, double correlation) {
    double sum = 0;
    for (int wave = 0; wave < kWaves; ++wave) {
        std::uint64_t index = static_cast<std::uint64_t>(wave) * 32;
        const auto normal = [&] {
            const double n = toNormal(randomBits(seed, pair, kShadowSalt, index), randomBits(seed, pair, kShadowSalt, index + 1));
            index += 2;
            return n;
        };
        double phase = 2 * std::numbers::pi * toUnit(randomBits(seed, pair, kShadowSalt, index++));
        if (correlation > 0) {
            for (const Vec3* end : {&first, &second}) {
                const Vec3 direction(normal(), normal(), normal());
                const double stretch = std::max(std::abs(normal()), 1e-9);
                phase += direction.dot(*end) / (stretch * correlation);
            }
        }
        sum += std::cos(phase);
    }
    return std::clamp(sum * std::sqrt(2.0 / kWaves), -kMostSigmas, kMostSigmas);
}

} // namespace trundle
