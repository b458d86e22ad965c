// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <cstddef>

namespace trundle {
inline namespace sdk1 {

inline Slot RobotPorts::bind(const char* kind, const char* device, const char* signal, std::uint32_t count) {
    if (m_missing) return {}; // a missing name is reported once, not for each signal of its port
    double* first = m_robot.bind(m_robot.context, kind, device, signal);
    if (!first) m_missing = true;
    return Slot(first, count);
}

inline bool RobotPorts::has(const char* device, const char* signal) const {
    std::uint32_t count = 0, direction = 0;
    return m_robot.signalInfo && m_robot.signalInfo(m_robot.context, device, signal, &count, &direction) == 0;
}

inline DifferentialDrivePort RobotPorts::differentialDrive(const char* name) {
    constexpr const char* kind = "DifferentialDrive";
    DifferentialDrivePort port;
    port.m_linear = bind(kind, name, "linearVelocity");
    port.m_angular = bind(kind, name, "angularVelocity");
    port.m_linearAmount = bind(kind, name, "linearAmount");
    port.m_angularAmount = bind(kind, name, "angularAmount");
    port.m_sequence = bind(kind, name, "sequence");
    port.m_finished = bind(kind, name, "finished");
    port.m_odometry = bind(kind, name, "odometry", 3);
    return port;
}

inline MotorPort RobotPorts::motor(const char* name) {
    constexpr const char* kind = "RotaryMotor";
    MotorPort port;
    port.m_voltage = bind(kind, name, "voltage");
    port.m_servo = bind(kind, name, "servo");
    port.m_current = bind(kind, name, "current");
    port.m_torque = bind(kind, name, "torque");
    port.m_rate = bind(kind, name, "rate");
    return port;
}

inline EncoderPort RobotPorts::encoder(const char* name) {
    constexpr const char* kind = "Encoder";
    EncoderPort port;
    port.m_count = bind(kind, name, "count");
    port.m_angle = bind(kind, name, "angle");
    port.m_rate = bind(kind, name, "rate");
    port.m_index = bind(kind, name, "index");
    return port;
}

inline TouchPort RobotPorts::touch(const char* name) {
    constexpr const char* kind = "TouchSensor";
    TouchPort port;
    port.m_pressed = bind(kind, name, "pressed");
    port.m_force = bind(kind, name, "force");
    port.m_count = bind(kind, name, "count");
    return port;
}

inline CameraPort RobotPorts::camera(const char* name) {
    CameraPort port;
    port.m_name = name;
    port.m_frame = bind("Camera", name, "frame");
    // The table of an older program is shorter.
    if (m_robot.size >= offsetof(TrundleRobot, cameras) + sizeof m_robot.cameras) port.m_cameras = m_robot.cameras;
    return port;
}

inline RadioPort RobotPorts::radio(const char* name) {
    RadioPort port;
    if (m_missing) return port;
    const TrundleRobotRadio* border = m_robot.radio;
    m_missing = !border || border->find(m_robot.context, name, &port.m_radio) != 0;
    if (m_missing) return port;
    port.m_border = border;
    port.m_context = m_robot.context;
    return port;
}

inline SignalPort RobotPorts::signal(const char* device, const char* signal) {
    SignalPort port;
    std::uint32_t count = 1, direction = TRUNDLE_OUTPUT;
    if (m_robot.signalInfo) m_robot.signalInfo(m_robot.context, device, signal, &count, &direction);
    port.m_slot = bind("", device, signal, count);
    port.m_writable = direction == TRUNDLE_COMMAND;
    return port;
}

inline Slot RobotPorts::publish(const char* name) {
    if (m_missing) return {};
    std::uint32_t count = 0;
    double* first = m_robot.publish(m_robot.context, name, &count);
    if (!first) m_missing = true;
    return Slot(first, count);
}

inline GroundTruthPort RobotPorts::groundTruth() {
    GroundTruthPort port;
    port.m_pose = bind("GroundTruth", "groundTruth", "pose", 7);
    port.m_velocity = bind("GroundTruth", "groundTruth", "velocity", 6);
    return port;
}

inline SignalPort RobotPorts::groundTruth(const char* path) {
    SignalPort port;
    std::uint32_t count = 1, direction = TRUNDLE_TRUTH;
    if (m_robot.signalInfo) m_robot.signalInfo(m_robot.context, "", path, &count, &direction);
    port.m_slot = bind("GroundTruth", "groundTruth", path, count);
    return port;
}

} // namespace sdk1
} // namespace trundle
