#include "devices/imu.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kGyroscope = 0, kAccelerometer = 1;

/// The coefficient of [a]^2 in the inverse Jacobian: 1/a^2 - cot(a/2) / (2a), by its series where that cancels.
double squareTerm(double angle) {
    const double a2 = angle * angle;
    if (a2 < 0.25) return 1.0 / 12 + a2 * (1.0 / 720 + a2 * (1.0 / 30240 + a2 * (1.0 / 1209600 + a2 / 47900160)));
    return 1 / a2 - std::cos(angle / 2) / std::sin(angle / 2) / (2 * angle);
}

constexpr double kMostTurn = 3;    // rad in a tick; beyond it the directions within the tick are unknown
constexpr double kLongestArm = 10; // m, from a centre of mass to a sensor: one that seems longer is of a robot that was placed

/// What half a tick of the turn adds to a vector that is constant in the turning frame, by its mean over the tick.
Vec3 halfTurned(const Vec3& turn, const Vec3& mean) {
    const Vec3 across = turn.cross(mean);
    return 0.5 * across + squareTerm(turn.norm()) * turn.cross(across);
}

/// The mean acceleration of an arm that turns steadily, whose velocity at the end of the tick is `ahead` of its mean: it solves
/// halfTurned(turn, x) = turn.cross(ahead / tick).
Vec3 swingOf(const Vec3& ahead, const Vec3& turn, double tick) {
    const double share = 2 * squareTerm(turn.norm());
    return 2 / tick / (1 + share * share * turn.squaredNorm()) * (ahead - share * turn.cross(ahead));
}

} // namespace

Vec3 specificForce(const Vec3& change, const Vec3& ahead, const Vec3& gravity, const Quat& rotation, const Vec3& rate,
                   double tick) {
    const Quat back = rotation.conjugate();
    const Vec3 mean = back * (change / tick - gravity), turn = rate * tick;
    if (turn.norm() > kMostTurn) return mean;
    const Vec3 whole = back * (change / tick), down = back * gravity, centre = whole - swingOf(back * ahead, turn, tick);
    const double share = gravity.isZero(0) ? 0 : std::clamp(centre.dot(down) / down.squaredNorm(), 0., 1.);
    const Vec3 fall = share * down, led = centre - fall;
    return mean + halfTurned(turn, whole - fall) + halfTurned(turn, led + halfTurned(turn, led));
}

void Imu::describe(Describe<Imu>& d) {
    d.help("Measures angular velocity and acceleration at its place on a body.").independent();
    describeSensor(d);
    const Quantity size = number().within(0, 1e9);
    d.field("Noise", &Imu::m_noise, size.counted(1, 2),
            "Standard deviations of a reading: gyroscope [rad/s], accelerometer [m/s^2]; one number is for both.");
    d.field("NoiseDensity", &Imu::m_noiseDensity, size,
            "As data sheets give it: gyroscope [rad/s/sqrt(Hz)], accelerometer [m/s^2/sqrt(Hz)]; adds to Noise.");
    d.field("RandomWalk", &Imu::m_randomWalk, size, "Of the biases: gyroscope [rad/s/sqrt(s)], accelerometer [m/s^2/sqrt(s)].");
    d.field("GyroscopeBias", &Imu::m_gyroscopeBias, radiansPerSecond().within(-1e6, 1e6), "Added to x, y, z at the start.");
    d.field("AccelerometerBias", &Imu::m_accelerometerBias, metresPerSecondSquared().within(-1e6, 1e6),
            "Added to x, y, z at the start.");
    d.field("ScaleError", &Imu::m_scaleError, number().within(-1, 1), "Gyroscope, accelerometer: 0.01 reads 1 % too much.");
    d.field("Range", &Imu::m_range, size, "Largest reading: gyroscope [rad/s], accelerometer [m/s^2]; 0: any.");
    d.field("Resolution", &Imu::m_resolution, size,
            "Readings are multiples of it: gyroscope [rad/s], accelerometer [m/s^2]; 0: exact.");
    d.field("Orientation", &Imu::m_orientation, flag(), "Whether it gives its orientation too, without errors.");
    ImuSignals::describe(d);
}

void Imu::begin(Mount& mount) {
    m_gravity = mount.gravity();
    m_noise.resize(2, m_noise[0]);
    time.set(-1);
    m_bias = {Vec3(m_gyroscopeBias.data()), Vec3(m_accelerometerBias.data())};
}

void Imu::follow(Sensing& world) {
    const TrundleBodyState state = world.bodyState(body());
    const Pose at = poseOf(state);
    const Vec3 arm = at.rotation * mounting().position, place = at.position + arm, rate(state.angular);
    const Vec3 velocity = Vec3(state.linear) + rate.cross(arm);
    Vec3 ahead = velocity - (place - m_place) / world.tick();
    if (ahead.norm() > 0.5 * world.tick() * rate.squaredNorm() * kLongestArm) ahead.setZero();
    m_rotation = (at.rotation * mounting().rotation).normalized();
    m_rate = m_rotation.conjugate() * rate;
    m_force = specificForce(velocity - m_velocity, ahead, m_gravity, m_rotation, m_rate, world.tick());
    m_velocity = velocity;
    m_place = place;
}

void Imu::measure(Sensing& world, std::vector<double>& reading) {
    for (const int part : {kGyroscope, kAccelerometer})
        for (int axis = 0; axis < 3; ++axis)
            reading.push_back(measured(part, axis, (part == kGyroscope ? m_rate : m_force)[axis], world));
    const Quat& q = m_rotation;
    const double given = m_orientation ? 1 : 0;
    reading.insert(reading.end(), {given * q.w(), given * q.x(), given * q.y(), given * q.z()});
}

/// The bias walks from reading to reading; noise of a density is larger the more often it is read.
double Imu::measured(int part, int axis, double truth, const Services& world) {
    const auto p = static_cast<std::size_t>(part);
    const std::uint64_t draw = 2 * (3 * p + static_cast<std::uint64_t>(axis));
    const double seconds = interval(world.tick());
    if (m_randomWalk[p] > 0) m_bias[p][axis] += m_randomWalk[p] * std::sqrt(seconds) * normalDeviate(world.randomBits(draw));
    const double dense = m_noiseDensity[p] / std::sqrt(seconds), sigma = std::sqrt(m_noise[p] * m_noise[p] + dense * dense);
    double value = truth * (1 + m_scaleError[p]) + m_bias[p][axis];
    if (sigma > 0) value += sigma * normalDeviate(world.randomBits(draw + 1));
    const double most = m_range[p] > 0 ? m_range[p] : HUGE_VAL;
    return roundedWithin(value, -most, most, m_resolution[p]);
}

void Imu::publish(std::span<const double> reading, double measuredAt) {
    for (std::uint32_t i = 0; i < 3; ++i) {
        angularVelocity.set(i, reading[i]);
        acceleration.set(i, reading[3 + i]);
    }
    for (std::uint32_t i = 0; i < 4; ++i) orientation.set(i, reading[6 + i]);
    time.set(measuredAt);
}

} // namespace trundle
