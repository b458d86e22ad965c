#include "devices/gps.h"

namespace trundle {

namespace {

// Numbers of the draws in a tick.
enum : std::uint64_t { kDropout = 0, kPosition = 1, kVelocity = 4 };

} // namespace

void Gps::describe(Describe<Gps>& d) {
    d.help("Measures position and velocity in the world.");
    describeSensor(d);
    d.field("Noise", &Gps::m_noise, metres().within(0, 1e6).counted(1, 3),
            "Standard deviation of the position: of all axes, of x, y and of z, or of x, y, z.");
    d.field("CorrelationTime", &Gps::m_correlationTime, seconds().within(0, 1e6),
            "The position's error is similar for about so long; 0: each is a new one.");
    d.field("VelocityNoise", &Gps::m_velocityNoise, metresPerSecond().within(0, 1e6),
            "Standard deviation of each axis of the velocity.");
    d.field("Dropouts", &Gps::m_dropouts, number().within(0, 1), "Share of readings that are missed; the last one stays.");
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
    const Vec3 place = at * mounting().position + m_error;
    for (int i = 0; i < 3; ++i) reading.push_back(roundedTo(place[i], m_resolution));
    for (std::uint64_t i = 0; i < 3; ++i) {
        const double error = m_velocityNoise > 0 ? m_velocityNoise * normalDeviate(world.randomBits(kVelocity + i)) : 0;
        reading.push_back(velocity[static_cast<Eigen::Index>(i)] + error);
    }
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
