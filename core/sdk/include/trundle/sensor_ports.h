// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// A controller's ports of the sensors that come with Trundle. Since 1.6.

#include <span>

#include <trundle/geometry.h>
#include <trundle/port.h>
#include <trundle/sensor_signals.h>

namespace trundle {
inline namespace sdk1 {

/// The port of a sensor with a signal `time`.
template <class S> class SensorPort : public Port<S> {
public:
    [[nodiscard]] double time() const {
        return this->m_signals.time.get();
    } ///< when the reading was measured, s; -1 before the first
    /// True if there is a reading newer than at the last call.
    [[nodiscard]] bool fresh() {
        const bool isNew = time() != m_seen;
        m_seen = time();
        return isNew;
    }

protected:
    [[nodiscard]] static Vec3 vector(const Slot& slot) { return {slot.get(0), slot.get(1), slot.get(2)}; }

private:
    double m_seen = -1;
};

class RangePort : public SensorPort<RangeSensorSignals> {
public:
    [[nodiscard]] double range() const { return m_signals.range.get(); }     ///< m
    [[nodiscard]] double voltage() const { return m_signals.voltage.get(); } ///< V; of infrared sensors
};

class LidarPort : public SensorPort<LidarSignals> {
public:
    /// m, layer by layer from below, each from -FieldOfView/2 counter-clockwise.
    [[nodiscard]] std::span<const double> ranges() const { return m_signals.ranges.values(); }
    [[nodiscard]] double range(std::uint32_t beam) const { return m_signals.ranges.get(beam); } ///< m
    /// Share of light that is returned, in the order of ranges(); zeros unless Intensity is set. Since 1.11.
    [[nodiscard]] std::span<const double> intensities() const { return m_signals.intensities.values(); }
};

class ImuPort : public SensorPort<ImuSignals> {
public:
    [[nodiscard]] Vec3 angularVelocity() const { return vector(m_signals.angularVelocity); } ///< rad/s in its own frame
    [[nodiscard]] Vec3 acceleration() const { return vector(m_signals.acceleration); }       ///< m/s^2 in its own frame
    /// In the world; identity unless Orientation is set.
    [[nodiscard]] Quat orientation() const {
        const Slot& q = m_signals.orientation;
        const Quat turned(q.get(0), q.get(1), q.get(2), q.get(3));
        return turned.squaredNorm() > 0 ? turned : Quat(Quat::Identity());
    }
};

class CompassPort : public SensorPort<CompassSignals> {
public:
    [[nodiscard]] double heading() const { return m_signals.heading.get(); } ///< rad, from -pi to pi
};

class GpsPort : public SensorPort<GpsSignals> {
public:
    [[nodiscard]] Vec3 position() const { return vector(m_signals.position); } ///< m in the world
    [[nodiscard]] Vec3 velocity() const { return vector(m_signals.velocity); } ///< m/s in the world
};

/// Since 1.7.
class GroundPort : public SensorPort<GroundSensorSignals> {
public:
    [[nodiscard]] double reflectance() const { return m_signals.reflectance.get(); } ///< from 0 (black) to 1 (white)
};

/// Since 1.7.
class LightPort : public SensorPort<LightSensorSignals> {
public:
    [[nodiscard]] double illuminance() const { return m_signals.illuminance.get(); } ///< lx
};

/// Since 1.11.
class ForcePort : public SensorPort<ForceSensorSignals> {
public:
    [[nodiscard]] Vec3 force() const { return vector(m_signals.force); }   ///< N in its own frame, of the joint's parent on its child
    [[nodiscard]] Vec3 torque() const { return vector(m_signals.torque); } ///< N m in its own frame, about its place
};

} // namespace sdk1
} // namespace trundle
