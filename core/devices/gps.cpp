#include "devices/gps.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace trundle {

namespace {

// Numbers of the draws in a tick.
enum : std::uint64_t { kDropout = 0, kPosition = 1, kVelocity = 4 };

constexpr std::size_t kSkyRays = 64;
constexpr double kSkyRange = 1000, kLowestElevation = std::numbers::pi / 12; // m, rad: receivers leave out lower satellites

} // namespace

void Gps::describe(Describe<Gps>& d) {
    d.help("Measures position and velocity in the world.").independent();
    describeSensor(d);
    d.field("Noise", &Gps::m_noise, metres().within(0, 1e6).counted(1, 3),
            "Standard deviation of the position: of all axes, of x, y and of z, or of x, y, z.");
    d.field("CorrelationTime", &Gps::m_correlationTime, seconds().within(0, 1e6),
            "The position's error is similar for about so long; 0: each is a new one.");
    d.field("VelocityNoise", &Gps::m_velocityNoise, metresPerSecond().within(0, 1e6),
            "Standard deviation of each axis of the velocity.");
    d.field("Dropouts", &Gps::m_dropouts, number().within(0, 1), "Share of readings that are missed; the last one stays.");
    d.field("MinSky", &Gps::m_minSky, number().within(0, 1),
            "Share of the sky, from 15 deg above the horizon, that it must see: under roofs and close to walls its readings are "
            "missed.");
    d.field("Resolution", &Gps::m_resolution, metres().within(0, 1e6), "Positions are multiples of it; 0: exact.");
    GpsSignals::describe(d);
}

void Gps::begin(Mount&) {
    time.set(-1);
    const double last = m_noise.back();
    if (m_noise.size() == 2) m_noise.insert(m_noise.begin(), m_noise[0]);
    m_noise.resize(3, last);
}

void Gps::measure(Sensing& world, std::vector<double>& reading) {
    moveError(world); // also when the reading is missed
    if (m_dropouts > 0 && world.random(kDropout) < m_dropouts) return;
    const TrundleBodyState state = world.bodyState(body());
    const Pose at = poseOf(state);
    const Vec3 velocity = Vec3(state.linear) + Vec3(state.angular).cross(at.rotation * mounting().position);
    const Vec3 antenna = at * mounting().position, place = antenna + m_error;
    if (m_minSky > 0 && !seesSky(world, antenna)) return;
    for (int i = 0; i < 3; ++i) reading.push_back(roundedTo(place[i], m_resolution));
    for (std::uint64_t i = 0; i < 3; ++i) {
        const double error = m_velocityNoise > 0 ? m_velocityNoise * normalDeviate(world.randomBits(kVelocity + i)) : 0;
        reading.push_back(velocity[static_cast<Eigen::Index>(i)] + error);
    }
}

/// By rays that each stand for an equal part of the sky (a Fibonacci lattice; Gonzalez, Mathematical Geosciences 42, 2010).
bool Gps::seesSky(Sensing& world, const Vec3& antenna) const {
    std::array<Ray, kSkyRays> rays;
    std::array<double, kSkyRays> distances;
    const double lowest = std::sin(kLowestElevation);
    for (std::size_t i = 0; i < kSkyRays; ++i) {
        const double up = lowest + (1 - lowest) * (static_cast<double>(i) + 0.5) / kSkyRays, out = std::sqrt(1 - up * up);
        const double around = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0));
        rays[i] = {antenna, {out * std::cos(around), out * std::sin(around), up}, kSkyRange};
    }
    if (!world.castRays(rays, {distances})) return true;
    const auto open = std::ranges::count_if(distances, [](double d) { return d >= kSkyRange; });
    return static_cast<double>(open) >= m_minSky * kSkyRays;
}

/// The variance of the error stays that of Noise from the first reading on.
void Gps::moveError(const Services& world) {
    const double share = m_hasError && m_correlationTime > 0 ? std::exp(-interval(world.tick()) / m_correlationTime) : 0;
    const double fresh = std::sqrt(1 - share * share);
    for (std::uint64_t i = 0; i < 3; ++i) {
        if (!(m_noise[i] > 0)) continue;
        double& error = m_error[static_cast<Eigen::Index>(i)];
        error = share * error + fresh * m_noise[i] * normalDeviate(world.randomBits(kPosition + i));
    }
    m_hasError = true;
}

void Gps::publish(std::span<const double> reading, double measured) {
    for (std::uint32_t i = 0; i < 3; ++i) {
        position.set(i, reading[i]);
        velocity.set(i, reading[3 + i]);
    }
    time.set(measured);
}

} // namespace trundle
