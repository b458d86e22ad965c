#pragma once
#include <trundle/sensor.h>
#include <trundle/sensor_signals.h>

namespace trundle {

/// Gyroscope and accelerometer at a place on a body. The acceleration is the specific force at that place, without gravity, along
/// the sensor's own axes at the end of the tick. It is found from the change of velocity in the last tick by taking it as
/// constant in the turning body, but for what gravity does: exact in free fall, at constant acceleration and in a steady turn
/// about the vertical, which a plain difference of velocities is not. The robot starts at rest.
class Imu final : public Sensor, public ImuSignals {
public:
    static void describe(Describe<Imu>& d);

private:
    void begin(Mount& mount) override;
    void follow(Sensing& world) override;
    void measure(Sensing& world, std::vector<double>& reading) override;
    void publish(std::span<const double> reading, double time) override;
    [[nodiscard]] double measured(int part, int axis, double truth, const Services& world);

    // Each first for the gyroscope (rad/s), then for the accelerometer (m/s^2).
    std::vector<double> m_noise{0, 0};
    std::array<double, 2> m_noiseDensity{0, 0}, m_randomWalk{0, 0}, m_scaleError{0, 0}, m_range{0, 0}, m_resolution{0, 0};
    std::array<double, 3> m_gyroscopeBias{0, 0, 0}, m_accelerometerBias{0, 0, 0};
    bool m_orientation = false;

    Vec3 m_gravity = Vec3::Zero();                          ///< in the world
    Vec3 m_velocity = Vec3::Zero(), m_place = Vec3::Zero(); ///< of the sensor after the last tick, in the world
    Vec3 m_rate = Vec3::Zero(), m_force = Vec3::Zero();     ///< in its own frame, without errors
    Quat m_rotation = Quat::Identity();                     ///< in the world
    std::array<Vec3, 2> m_bias;                             ///< now
};

/// The specific force (m/s^2, own frame) of a sensor that ended a tick of `tick` s with the rotation and the angular rate (rad/s,
/// own frame), whose velocity in the world changed by `change` and is `ahead` of its mean velocity in the tick (m/s).
///
/// A centre of mass has one velocity for the whole tick, along a chord of its path; the arm from there to the sensor turns, with
/// the velocity of the end. So the change is a whole tick old for the one and half a tick for the other, and `ahead`, which only
/// the arm has, separates them. Both turn with the sensor, but for what the centre of mass falls and what carries it against
/// gravity. The inverse left Jacobian of SO(3) turns them on to the end (Sola, Deray, Atchuthan: A micro Lie theory, 2018, eq.
/// 146).
[[nodiscard]] Vec3 specificForce(const Vec3& change, const Vec3& ahead, const Vec3& gravity, const Quat& rotation,
                                 const Vec3& rate, double tick);

} // namespace trundle
