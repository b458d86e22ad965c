// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Ports as in ports.h: of bases with driven wheels.

#include <cmath>
#include <cstdint>

#include <trundle/device_signals.h>
#include <trundle/drive_signals.h>
#include <trundle/port.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// A pose on the floor.
struct Pose2 {
    double x = 0, y = 0; ///< m
    double heading = 0;  ///< rad, positive to the left
};

/// What the ports of all bases have: amounts with an end, and odometry.
template <class S> class BasePort : public Port<S> {
public:
    /// True once the last amount that this port commanded has finished or was refused.
    [[nodiscard]] bool done() const { return this->m_signals.finished.get() >= m_number; }
    /// Pose of the base's centre, as in `pose` of its kind, from wheel odometry, relative to the start; m and rad.
    [[nodiscard]] Pose2 odometry() const {
        const Slot& now = this->m_signals.odometry;
        return {now.get(0), now.get(1), now.get(2)};
    }

protected:
    void begin() {
        m_number = this->m_signals.sequence.get() + 1;
        this->m_signals.sequence.set(m_number);
    }

private:
    double m_number = 0;
};

/// A base with driven wheels on both sides: a DifferentialDrive or, since 1.8, a SkidDrive.
template <class S> class DrivePort : public BasePort<S> {
public:
    /// Drives at `linear` m/s and turns left at `angular` rad/s until the next command. Cancels a running drive().
    void move(double linear, double angular) { command(linear, angular, 0, 0); }
    void stop() { move(0, 0); }
    /// Drives `linearAmount` m and turns `angularAmount` rad, at most at the given speeds (m/s, rad/s). An amount of 0 means no
    /// limit: drive(0.3, 1, 0, pi) is a half circle of radius 0.3 m. Each amount must have the sign of its speed.
    void drive(double linear, double angular, double linearAmount, double angularAmount) {
        command(linear, angular, linearAmount, angularAmount);
        this->begin();
    }
    /// Turns in place by `angle` rad at `speed` rad/s; the sign is that of the angle. An angle of 0 is no turn.
    void turn(double speed, double angle) { drive(0, angle == 0 ? 0 : std::copysign(speed, angle), 0, angle); }

private:
    void command(double linear, double angular, double linearAmount, double angularAmount) {
        this->m_signals.linearVelocity.set(linear);
        this->m_signals.angularVelocity.set(angular);
        this->m_signals.linearAmount.set(linearAmount);
        this->m_signals.angularAmount.set(angularAmount);
    }
};
class DifferentialDrivePort : public DrivePort<DifferentialDriveSignals> {};
class SkidDrivePort : public DrivePort<SkidDriveSignals> {};

/// Since 1.10.
class TrackDrivePort : public DrivePort<TrackDriveSignals> {};

/// A base that moves in any direction: an OmniDrive or a MecanumDrive. Since 1.9.
template <class S> class HolonomicPort : public BasePort<S> {
public:
    /// Moves at `forward` and `left` m/s, in its own frame, and turns left at `angular` rad/s until the next command. Cancels a running
    /// drive().
    void move(double forward, double left, double angular) { command(forward, left, angular, 0, 0); }
    void stop() { move(0, 0, 0); }
    /// Goes `linearAmount` m along the velocity and turns `angularAmount` rad, at most at the given speeds. An amount of 0 means no limit.
    /// The way is positive; the angle has the sign of its speed.
    void drive(double forward, double left, double angular, double linearAmount, double angularAmount) {
        command(forward, left, angular, linearAmount, angularAmount);
        this->begin();
    }
    /// Turns in place by `angle` rad at `speed` rad/s; the sign is that of the angle. An angle of 0 is no turn.
    void turn(double speed, double angle) { drive(0, 0, angle == 0 ? 0 : std::copysign(speed, angle), 0, angle); }

private:
    void command(double forward, double left, double angular, double linearAmount, double angularAmount) {
        this->m_signals.linearVelocity.set(forward);
        this->m_signals.lateralVelocity.set(left);
        this->m_signals.angularVelocity.set(angular);
        this->m_signals.linearAmount.set(linearAmount);
        this->m_signals.angularAmount.set(angularAmount);
    }
};
class OmniDrivePort : public HolonomicPort<OmniDriveSignals> {};
class MecanumDrivePort : public HolonomicPort<MecanumDriveSignals> {};

/// A base that steers its front wheels. Since 1.9.
class AckermannDrivePort : public BasePort<AckermannDriveSignals> {
public:
    /// Drives at `linear` m/s with the wheels steered by `steeringAngle` rad, positive to the left, until the next command. Cancels a
    /// running drive().
    void move(double linear, double steeringAngle) { command(linear, steeringAngle, 0); }
    /// Brakes, and keeps its wheels as they are steered.
    void stop() { move(0, m_signals.steeringAngle.get()); }
    /// Drives `linearAmount` m, which has the sign of `linear`, at most at that speed.
    void drive(double linear, double steeringAngle, double linearAmount) {
        command(linear, steeringAngle, linearAmount);
        begin();
    }
    [[nodiscard]] double steering() const { return m_signals.steering.get(); } ///< rad, the angle that it has

private:
    void command(double linear, double steeringAngle, double linearAmount) {
        m_signals.linearVelocity.set(linear);
        m_signals.steeringAngle.set(steeringAngle);
        m_signals.linearAmount.set(linearAmount);
    }
};

} // namespace sdk1
} // namespace trundle
