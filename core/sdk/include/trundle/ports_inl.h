// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <cstddef>

namespace trundle {
inline namespace sdk1 {

inline bool RobotPorts::has(const char* device, const char* signal) const {
    std::uint32_t count = 0, direction = 0;
    return m_robot.signalInfo && m_robot.signalInfo(m_robot.context, device, signal, &count, &direction) == 0;
}

template <class> DifferentialDrivePort RobotPorts::differentialDrive(PortName name) {
    return bindPort<DifferentialDrivePort, DifferentialDriveSignals>(name);
}
template <class> MotorPort RobotPorts::motor(PortName name) { return bindPort<MotorPort, RotaryMotorSignals>(name); }
template <class> EncoderPort RobotPorts::encoder(PortName name) { return bindPort<EncoderPort, EncoderSignals>(name); }
template <class> TouchPort RobotPorts::touch(PortName name) { return bindPort<TouchPort, TouchSensorSignals>(name); }
template <class> RangePort RobotPorts::rangeSensor(PortName name) { return bindPort<RangePort, RangeSensorSignals>(name); }
template <class> LidarPort RobotPorts::lidar(PortName name) { return bindPort<LidarPort, LidarSignals>(name); }
template <class> ImuPort RobotPorts::imu(PortName name) { return bindPort<ImuPort, ImuSignals>(name); }
template <class> CompassPort RobotPorts::compass(PortName name) { return bindPort<CompassPort, CompassSignals>(name); }
template <class> GpsPort RobotPorts::gps(PortName name) { return bindPort<GpsPort, GpsSignals>(name); }
template <class> GroundPort RobotPorts::groundSensor(PortName name) { return bindPort<GroundPort, GroundSensorSignals>(name); }
template <class> LightPort RobotPorts::lightSensor(PortName name) { return bindPort<LightPort, LightSensorSignals>(name); }
inline std::string RobotPorts::objectName(std::uint32_t object) const {
    const bool known = m_robot.size >= offsetof(TrundleRobot, cameras) + sizeof m_robot.cameras && m_robot.cameras;
    const char* name = known ? m_robot.cameras->objectName(m_robot.cameras->context, object) : nullptr;
    return name ? name : "";
}

template <class> ForcePort RobotPorts::forceSensor(PortName name) { return bindPort<ForcePort, ForceSensorSignals>(name); }

template <class> SkidDrivePort RobotPorts::skidDrive(PortName name) { return bindPort<SkidDrivePort, SkidDriveSignals>(name); }

template <class> CameraPort RobotPorts::camera(PortName name) {
    auto port = bindPort<CameraPort, CameraSignals>(name);
    port.m_name = name;
    // The table of an older program is shorter.
    if (m_robot.size >= offsetof(TrundleRobot, cameras) + sizeof m_robot.cameras) port.m_cameras = m_robot.cameras;
    return port;
}

template <class> RadioPort RobotPorts::radio(PortName name) {
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

template <class> GroundTruthPort RobotPorts::groundTruth() {
    GroundTruthPort port;
    port.bind([](const SignalInfo&) { return true; },
              [&](const SignalInfo& s) { return bind(GroundTruthSignals::kKind, "groundTruth", s.name.c_str(), s.count); });
    return port;
}

inline SignalPort RobotPorts::groundTruth(const char* path) {
    SignalPort port;
    std::uint32_t count = 1, direction = TRUNDLE_TRUTH;
    if (m_robot.signalInfo) m_robot.signalInfo(m_robot.context, "", path, &count, &direction);
    port.m_slot = bind(GroundTruthSignals::kKind, "groundTruth", path, count);
    return port;
}

} // namespace sdk1
} // namespace trundle
