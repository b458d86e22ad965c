// Antenna models in closed form. Needs: a direction in the antenna's frame. Gives: dBi. Method: a relative power per model,
// scaled so that its mean over the sphere is 1 (no losses) or its peak is the given gain. A half-wave dipole along z: (cos(pi/2
// cos t) / sin t)^2 (Balanis, Antenna Theory, 4-84). Inverted F: two short currents at right angles in space and phase, so that
// their powers add. Patch: a cosine lobe and a back lobe of -20 dB. Yagi: a dipole times an end-fire array with quarter-wave
// spacing (Balanis, 6-10).
#include "radio/antenna_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trundle {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDipoleDirectivity = 1.640922376984585;
constexpr double kSecondCurrent = 0.3; ///< fraction of an inverted F's power in the current along y
constexpr double kBackLobe = 0.01;     ///< of a patch
constexpr double kPatchBeam = 80 * kPi / 180, kYagiBeam = 60 * kPi / 180;

constexpr std::array<std::string_view, 6> kWords{"isotropic", "dipole", "inverted_f", "patch", "yagi", "cosine"};

/// The exponent n for which cos^n falls to one half at half the beam width.
double lobeExponent(double beamWidth) { return std::log(0.5) / std::log(std::cos(std::min(beamWidth, 0.999 * kPi) / 2)); }

double dipole(double cosine) {
    const double square = 1 - cosine * cosine;
    if (square < 1e-12) return 0;
    const double c = std::cos(kPi / 2 * cosine);
    return c * c / square;
}

/// Relative power of an end-fire array of `elements` with quarter-wave spacing; `cosine` of the angle to its axis.
double endFire(double elements, double cosine) {
    const double half = kPi / 4 * (cosine - 1);
    if (std::abs(half) < 1e-9) return 1;
    const double f = std::sin(elements * half) / (elements * std::sin(half));
    return f * f;
}

/// The number of elements that gives a beam of this width.
double yagiElements(double beamWidth) {
    const double cosine = std::cos(std::clamp(beamWidth, 0.02, 0.999 * kPi) / 2);
    double few = 1, many = 1;
    while (many < 1e5 && endFire(many, cosine) > 0.5) many *= 1.2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (few + many) / 2;
        (endFire(middle, cosine) > 0.5 ? few : many) = middle;
    }
    return (few + many) / 2;
}

template <class Gain> double meanOverSphere(const Gain& gain, int rings, int spokes) {
    double sum = 0;
    for (int r = 0; r < rings; ++r) {
        const double z = (2.0 * r + 1) / rings - 1, across = std::sqrt(1 - z * z);
        double ring = 0;
        for (int s = 0; s < spokes; ++s) {
            const double azimuth = 2 * kPi * (s + 0.5) / spokes;
            ring += gain(Vec3(across * std::cos(azimuth), across * std::sin(azimuth), z));
        }
        sum += ring / spokes;
    }
    return sum / rings;
}

} // namespace

std::optional<AntennaModel> antennaModelNamed(std::string_view word) {
    const auto it = std::find(kWords.begin(), kWords.end(), word);
    if (it == kWords.end()) return std::nullopt;
    return static_cast<AntennaModel>(it - kWords.begin());
}

AntennaPattern AntennaPattern::of(AntennaModel model, std::optional<double> peakGain, std::optional<double> beamWidth) {
    AntennaPattern p;
    p.m_model = model;
    if (model == AntennaModel::Patch) p.m_power = lobeExponent(beamWidth.value_or(kPatchBeam));
    if (model == AntennaModel::Yagi) p.m_power = yagiElements(beamWidth.value_or(kYagiBeam));
    if (model == AntennaModel::Cosine) {
        p.m_power = 2;
        if (beamWidth) p.m_power = lobeExponent(*beamWidth);
        else if (peakGain) p.m_power = std::max(0.0, std::pow(10, *peakGain / 10) / 2 - 1); // 2 (n + 1) is the gain of cos^n
    }
    p.normalise(peakGain);
    return p;
}

double AntennaPattern::shape(const Vec3& d) const {
    switch (m_model) {
    case AntennaModel::Isotropic: return 1;
    case AntennaModel::Dipole: return dipole(d.z());
    case AntennaModel::InvertedF: return (1 - kSecondCurrent) * (1 - d.z() * d.z()) + kSecondCurrent * (1 - d.y() * d.y());
    case AntennaModel::Patch: return std::max(kBackLobe, d.x() > 0 ? std::pow(d.x(), m_power) : 0.0);
    case AntennaModel::Yagi: return endFire(m_power, d.x()) * dipole(d.z());
    case AntennaModel::Cosine: return d.x() > 0 ? std::pow(d.x(), m_power) : 0.0;
    }
    return 1;
}

void AntennaPattern::normalise(std::optional<double> peakGain) {
    double directivity = 1; // every model has relative power 1 along +x
    switch (m_model) {
    case AntennaModel::Isotropic: break;
    case AntennaModel::Dipole: directivity = kDipoleDirectivity; break;
    case AntennaModel::InvertedF: directivity = 1.5; break;
    case AntennaModel::Cosine: directivity = 2 * (m_power + 1); break;
    case AntennaModel::Patch:
    case AntennaModel::Yagi: directivity = 1 / meanOverSphere([this](const Vec3& d) { return shape(d); }, 180, 360); break;
    }
    m_peak = m_offset = peakGain ? std::max(*peakGain, kFloor) : 10 * std::log10(directivity);
}

double AntennaPattern::gain(const Vec3& direction) const {
    if (m_model == AntennaModel::Isotropic && !m_table) return m_offset;
    const double length = direction.norm();
    if (!(length > 0)) return m_peak;
    const Vec3 d = direction / length;
    if (m_table) return std::max(kFloor, m_table->at(std::atan2(d.y(), d.x()), std::asin(std::clamp(d.z(), -1.0, 1.0))));
    const double power = shape(d);
    return power > 0 ? std::max(kFloor, m_offset + 10 * std::log10(power)) : kFloor;
}

double AntennaPattern::gain(double azimuth, double elevation) const {
    const double across = std::cos(elevation);
    return gain(Vec3(across * std::cos(azimuth), across * std::sin(azimuth), std::sin(elevation)));
}

double AntennaPattern::radiated() const {
    return meanOverSphere([this](const Vec3& d) { return std::pow(10, gain(d) / 10); }, 120, 240);
}

} // namespace trundle
