// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Ports as in ports.h: of servos, grippers, batteries, lights.

#include <trundle/equipment_signals.h>
#include <trundle/port.h>

namespace trundle {
inline namespace sdk1 {

/// Of a Servo or a LinearMotor. Since 1.7.
template <class S> class JointServoPort : public Port<S> {
public:
    /// rad or m, with Mode=speed rad/s or m/s.
    void setTarget(double target) { this->m_signals.target.set(target); }
    [[nodiscard]] double position() const { return this->m_signals.position.get(); }      ///< rad or m
    [[nodiscard]] double rate() const { return this->m_signals.rate.get(); }              ///< rad/s or m/s
    [[nodiscard]] bool saturated() const { return this->m_signals.saturated.get() != 0; } ///< not enough torque, force or speed
};
using ServoPort = JointServoPort<ServoSignals>;
using LinearMotorPort = JointServoPort<LinearMotorSignals>;

/// Since 1.8.
class BatteryPort : public Port<BatterySignals> {
public:
    [[nodiscard]] double voltage() const { return m_signals.voltage.get(); }             ///< V
    [[nodiscard]] double current() const { return m_signals.current.get(); }             ///< A
    [[nodiscard]] double charge() const { return m_signals.charge.get(); }               ///< C that is left
    [[nodiscard]] double level() const { return m_signals.level.get(); }                 ///< share that is left, from 0 to 1
    [[nodiscard]] double chargeCurrent() const { return m_signals.chargeCurrent.get(); } ///< A from a Charger
    [[nodiscard]] bool charging() const { return chargeCurrent() > 0; }
};

/// Since 1.8.
class GripperPort : public Port<GripperSignals> {
public:
    void setOpening(double opening) { m_signals.opening.set(opening); }         ///< m from the start pose; negative closes
    [[nodiscard]] double position() const { return m_signals.position.get(); }  ///< m
    [[nodiscard]] double force() const { return m_signals.force.get(); }        ///< N between its jaws
    [[nodiscard]] bool holding() const { return m_signals.holding.get() != 0; } ///< something is between its jaws
};

/// Of a Belt or a Track. Since 1.10.
template <class S> class SurfacePort : public Port<S> {
public:
    void setSpeed(double speed) { this->m_signals.speed.set(speed); }            ///< m/s
    [[nodiscard]] double rate() const { return this->m_signals.rate.get(); }     ///< m/s
    [[nodiscard]] double travel() const { return this->m_signals.travel.get(); } ///< m
};
using BeltPort = SurfacePort<BeltSignals>;
using TrackPort = SurfacePort<TrackSignals>;

/// Since 1.10.
class PenPort : public Port<PenSignals> {
public:
    void setDown(bool down) { m_signals.down.set(down); }
    [[nodiscard]] double length() const { return m_signals.length.get(); } ///< m, of all that it has drawn
};

/// Since 1.10.
class LedPort : public Port<LedSignals> {
public:
    void setOn(bool on) { m_signals.on.set(on); }
    /// From 0 to 1, as in pictures.
    void setColor(double red, double green, double blue) {
        m_signals.color.set(0, red);
        m_signals.color.set(1, green);
        m_signals.color.set(2, blue);
    }
    [[nodiscard]] bool lit() const { return m_signals.lit.get() != 0; } ///< it is on and has power
};

/// Since 1.10.
class ChargerPort : public Port<ChargerSignals> {
public:
    [[nodiscard]] bool connected() const { return m_signals.connected.get() != 0; } ///< a battery takes power
    [[nodiscard]] double voltage() const { return m_signals.voltage.get(); }        ///< V
    [[nodiscard]] double current() const { return m_signals.current.get(); }        ///< A
    [[nodiscard]] double energy() const { return m_signals.energy.get(); }          ///< J since the start
};

/// Since 1.11.
class LatchPort : public Port<LatchSignals> {
public:
    void setEngage(bool engage) { m_signals.engage.set(engage); }
    [[nodiscard]] bool engaged() const { return m_signals.engaged.get() != 0; } ///< it holds something
    [[nodiscard]] bool inReach() const { return m_signals.inReach.get() != 0; } ///< something that it could hold is within Reach
    [[nodiscard]] double force() const { return m_signals.force.get(); }        ///< N between it and what it holds
};

} // namespace sdk1
} // namespace trundle
