// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// How ports are bound to the devices of a robot.

#include <cstdint>
#include <string>

#include <trundle/abi.h>
#include <trundle/drive_ports.h>
#include <trundle/equipment_ports.h>
#include <trundle/port.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// The name of a device: a literal, or a std::string as stored in fields.
class PortName {
public:
    PortName(const char* name) : m_name(name) {}
    template <class Text> PortName(const Text& name) : m_name(name.c_str()) {}
    operator const char*() const { return m_name; }

private:
    const char* m_name;
};

class PortBinder {
public:
    explicit PortBinder(const TrundleRobot& robot) : m_robot(robot) {}
    [[nodiscard]] bool complete() const { return !m_missing; } ///< all names were found so far

protected:
    Slot bind(const char* kind, const char* device, const char* signal, std::uint32_t count = 1) {
        if (m_missing) return {}; // a missing name is reported once, not for each signal of its port
        double* first = m_robot.bind(m_robot.context, kind, device, signal);
        if (!first) m_missing = true;
        return Slot(first, count);
    }
    /// The table of the device and that of the port are compiled into two modules: a different one is reported instead of being read
    /// beyond its end or written where the device publishes.
    template <class S> Slot bindAs(const SignalInfo& described, const char* device) {
        std::uint32_t count = described.count, direction = described.direction;
        const bool known =
            m_robot.signalInfo && m_robot.signalInfo(m_robot.context, device, described.name.c_str(), &count, &direction) == 0;
        const bool sized = !described.countFields.empty(); // as many as the device's fields say
        const Slot slot = bind(S::kKind, device, described.name.c_str(), sized ? count : described.count);
        if (!slot.bound() || !known || ((sized || count == described.count) && direction == described.direction)) return slot;
        const std::string text = "the signal '" + described.name + "' of '" + device +
                                 "' has another count or direction than the table " + S::kKind +
                                 " that the controller was compiled with; build both modules with the same table";
        m_robot.fail(m_robot.context, text.c_str());
        m_missing = true;
        return {};
    }
    template <class P, class S> P bindPort(const char* device) {
        P port;
        port.bind([](const SignalInfo& s) { return s.direction != TRUNDLE_TRUTH; },
                  [&](const SignalInfo& s) { return bindAs<S>(s, device); });
        return port;
    }

    const TrundleRobot& m_robot;
    bool m_missing = false;
};

/// Ports of what has its signals in equipment_signals.h and drive_signals.h. Templates, so that only the ones that a controller uses are
/// compiled.
class EquipmentPorts : public PortBinder {
public:
    using PortBinder::PortBinder;
    // since 1.7
    template <class = void> [[nodiscard]] ServoPort servo(PortName name) { return bindPort<ServoPort, ServoSignals>(name); }
    template <class = void> [[nodiscard]] LinearMotorPort linearMotor(PortName name) { return bindPort<LinearMotorPort, LinearMotorSignals>(name); }
    // since 1.8
    template <class = void> [[nodiscard]] BatteryPort battery(PortName name) { return bindPort<BatteryPort, BatterySignals>(name); }
    template <class = void> [[nodiscard]] GripperPort gripper(PortName name) { return bindPort<GripperPort, GripperSignals>(name); }
    template <class = void> [[nodiscard]] OmniDrivePort omniDrive(PortName name) { return bindPort<OmniDrivePort, OmniDriveSignals>(name); }
    template <class = void> [[nodiscard]] MecanumDrivePort mecanumDrive(PortName name) { return bindPort<MecanumDrivePort, MecanumDriveSignals>(name); }
    template <class = void> [[nodiscard]] AckermannDrivePort ackermannDrive(PortName name) {
        return bindPort<AckermannDrivePort, AckermannDriveSignals>(name);
    }
    // since 1.10
    template <class = void> [[nodiscard]] BeltPort belt(PortName name) { return bindPort<BeltPort, BeltSignals>(name); }
    template <class = void> [[nodiscard]] TrackPort track(PortName name) { return bindPort<TrackPort, TrackSignals>(name); }
    template <class = void> [[nodiscard]] TrackDrivePort trackDrive(PortName name) { return bindPort<TrackDrivePort, TrackDriveSignals>(name); }
    template <class = void> [[nodiscard]] PenPort pen(PortName name) { return bindPort<PenPort, PenSignals>(name); }
    template <class = void> [[nodiscard]] LedPort led(PortName name) { return bindPort<LedPort, LedSignals>(name); }
    template <class = void> [[nodiscard]] ChargerPort charger(PortName name) { return bindPort<ChargerPort, ChargerSignals>(name); }
    template <class = void> [[nodiscard]] LatchPort latch(PortName name) { return bindPort<LatchPort, LatchSignals>(name); }
};

} // namespace sdk1
} // namespace trundle
