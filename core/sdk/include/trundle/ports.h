// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Ports: a controller's access to the devices of its robot. A port is bound once, in Controller::setup, by type and name; after
// that, access costs as much as a variable. An unbound port reads 0 and ignores writes. SI units and radians throughout.
// A port reads what the devices published at the end of the last tick; what it writes takes effect in this tick.

#include <string>

#include <trundle/abi.h>
#include <trundle/camera.h>
#include <trundle/device_signals.h>
#include <trundle/drive_ports.h>
#include <trundle/equipment_ports.h>
#include <trundle/geometry.h>
#include <trundle/port.h>
#include <trundle/port_binder.h>
#include <trundle/radio.h>
#include <trundle/sensor_ports.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

class MotorPort : public Port<RotaryMotorSignals> {
public:
    void setVoltage(double volts) {
        m_signals.servo.set(0);
        m_signals.voltage.set(volts);
    }
    [[nodiscard]] double current() const { return m_signals.current.get(); } ///< A
    [[nodiscard]] double torque() const { return m_signals.torque.get(); }   ///< N m at the joint
    [[nodiscard]] double rate() const { return m_signals.rate.get(); }       ///< rad/s of the joint
};

class EncoderPort : public Port<EncoderSignals> {
public:
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(m_signals.count.get()); }
    [[nodiscard]] double angle() const { return m_signals.angle.get(); } ///< rad, from encoder counts
    [[nodiscard]] double rate() const { return m_signals.rate.get(); }   ///< rad/s, from encoder counts over the last tick
    [[nodiscard]] bool index() const { return m_signals.index.get() != 0; }
};

class TouchPort : public Port<TouchSensorSignals> {
public:
    [[nodiscard]] bool pressed() const { return m_signals.pressed.get() != 0; }
    [[nodiscard]] double force() const { return m_signals.force.get(); } ///< N
    [[nodiscard]] int contacts() const { return static_cast<int>(m_signals.count.get()); }
};

/// Exact state that a real robot cannot measure; for experiments that evaluate a controller, not for control.
class GroundTruthPort : private Port<GroundTruthSignals> {
public:
    /// Pose of the robot's config frame in the world.
    [[nodiscard]] Pose pose() const {
        const Slot& now = m_signals.pose;
        return {{now.get(0), now.get(1), now.get(2)}, {now.get(3), now.get(4), now.get(5), now.get(6)}};
    }
    [[nodiscard]] Vec3 linearVelocity() const { return {velocity(0), velocity(1), velocity(2)}; }  ///< m/s
    [[nodiscard]] Vec3 angularVelocity() const { return {velocity(3), velocity(4), velocity(5)}; } ///< rad/s

private:
    friend class RobotPorts;
    [[nodiscard]] double velocity(std::uint32_t element) const { return m_signals.velocity.get(element); }
};

/// Any signal of any device, by name. Only commands can be written.
class SignalPort {
public:
    [[nodiscard]] std::uint32_t count() const { return m_slot.count(); }
    [[nodiscard]] double get(std::uint32_t element = 0) const { return m_slot.get(element); }
    void set(double value) { set(0, value); }
    void set(std::uint32_t element, double value) {
        if (m_writable) m_slot.set(element, value);
    }

private:
    friend class RobotPorts;
    Slot m_slot;
    bool m_writable = false;
};

/// Passed to Controller::setup to bind ports. If a name is unknown, setup fails with a message that lists the available names;
/// until then the returned port is unbound.
class RobotPorts : public EquipmentPorts {
public:
    using EquipmentPorts::EquipmentPorts;

    [[nodiscard]] std::string name() const { return m_robot.name; }
    [[nodiscard]] Seconds tick() const { return {m_robot.tick}; }
    /// Whether the robot has a device with this name (and, if given, the device a signal with that name).
    [[nodiscard]] bool has(const char* device, const char* signal = "") const;

    template <class = void> [[nodiscard]] DifferentialDrivePort differentialDrive(PortName name);
    template <class = void> [[nodiscard]] MotorPort motor(PortName name);
    template <class = void> [[nodiscard]] EncoderPort encoder(PortName name);
    template <class = void> [[nodiscard]] TouchPort touch(PortName name);
    template <class = void> [[nodiscard]] CameraPort camera(PortName name);
    template <class = void> [[nodiscard]] RadioPort radio(PortName name);
    // since 1.6
    template <class = void> [[nodiscard]] RangePort rangeSensor(PortName name);
    template <class = void> [[nodiscard]] LidarPort lidar(PortName name);
    template <class = void> [[nodiscard]] ImuPort imu(PortName name);
    template <class = void> [[nodiscard]] CompassPort compass(PortName name);
    template <class = void> [[nodiscard]] GpsPort gps(PortName name);
    // since 1.7
    template <class = void> [[nodiscard]] GroundPort groundSensor(PortName name);
    template <class = void> [[nodiscard]] LightPort lightSensor(PortName name);
    // since 1.8
    template <class = void> [[nodiscard]] SkidDrivePort skidDrive(PortName name);
    // since 1.11
    /// Name of an object by its number in a ground truth signal, "box1/block"; empty if no object has it.
    [[nodiscard]] std::string objectName(std::uint32_t object) const;
    template <class = void> [[nodiscard]] ForcePort forceSensor(PortName name);
    /// A device of a module by the table of its signals (since 1.5): robot.port<SonarSignals>("front").
    template <class S> [[nodiscard]] Port<S> port(PortName name) { return bindPort<Port<S>, S>(name); }
    [[nodiscard]] SignalPort signal(const char* device, const char* signal);
    template <class = void> [[nodiscard]] GroundTruthPort groundTruth();
    /// A signal published by this controller and described as output() in describe(): logs, summaries and the window show it as
    /// robot0/brain/<name>. Set it in setup and update; it keeps its value in between.
    [[nodiscard]] Slot publish(const char* name);
    /// A ground truth signal of a device, for example "base/pose"; read only.
    [[nodiscard]] SignalPort groundTruth(const char* path);

    /// Binds the members that describe() gives to outputs of the controller; called by the SDK before setup.
    template <class T> void publishOutputs(T& controller) {
        for (const SignalInfo& s : descriptionOf<T>().signals())
            if (s.bind) s.bind(&controller, publish(s.name.c_str()), s.name.c_str());
    }
};

} // namespace sdk1
} // namespace trundle
#include <trundle/ports_inl.h>
