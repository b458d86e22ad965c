// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Everything a sensor or an actuator needs. A device belongs to a robot, accesses the world only through these services and
// publishes signals. It never sets a pose or a velocity directly.

#include <string>
#include <vector>

#include <trundle/describe.h>
#include <trundle/geometry.h>
#include <trundle/joints.h>
#include <trundle/latch.h>
#include <trundle/light.h>
#include <trundle/module.h>
#include <trundle/mount.h>
#include <trundle/rays.h>
#include <trundle/slot.h>
#include <trundle/supply.h>

namespace trundle {
inline namespace sdk1 {

/// Read access to the world for a device at any time of a tick.
class Services {
public:
    explicit Services(const TrundleServices& services) : m_services(services) {}

    [[nodiscard]] Seconds tick() const { return {m_services.tick}; }
    /// Simulated time: of the last completed tick in act, of the tick just stepped in sense.
    [[nodiscard]] Seconds time() const { return {m_services.time}; }
    /// In rad or m, unwrapped, 0 at the start pose.
    [[nodiscard]] double jointPosition(JointId joint) const { return m_services.jointPosition(m_services.context, joint.index); }
    [[nodiscard]] double jointRate(JointId joint) const { return m_services.jointRate(m_services.context, joint.index); }
    /// Effort of the joint's motor in the last step, N m or N.
    [[nodiscard]] double jointMotorEffort(JointId joint) const {
        return m_services.jointMotorEffort(m_services.context, joint.index);
    }
    /// Of the friction of the joint's drive in the last step, N m or N, positive along the positive motion. Since 1.10.
    [[nodiscard]] double jointFrictionEffort(JointId joint) const { return detail::frictionEffort(m_services, joint.index); }
    /// What acts across a joint of Mount::measuredJoint, in the last step. False if it is not measured. Since 1.10.
    bool jointWrench(JointId joint, Wrench& out) const { return detail::wrench(m_services, joint.index, out); }
    /// Anchor (m) and unit axis of the joint in the world frame, moving with its parent body. False if not available.
    bool jointAnchor(JointId joint, Vec3& anchor, Vec3& axis) const {
        if (!m_services.jointAnchor) return false;
        m_services.jointAnchor(m_services.context, joint.index, anchor.data(), axis.data());
        return true;
    }
    [[nodiscard]] TrundleBodyState bodyState(BodyId body) const {
        TrundleBodyState state{};
        m_services.bodyState(m_services.context, body.index, &state);
        return state;
    }
    [[nodiscard]] TrundleRadioState radioState(RadioId radio) const {
        TrundleRadioState state{};
        state.size = sizeof state;
        if (m_services.radio) m_services.radio->state(m_services.context, radio.index, &state);
        return state;
    }
    /// Contacts of the geom in the last step; `out` is overwritten.
    void contacts(GeomId geom, std::vector<TrundleContact>& out) const { detail::contacts(m_services, geom.index, out); }
    /// Nearest hit along a unit direction within `range` (m); geoms of the own robot are ignored unless `own`.
    bool ray(const Vec3& origin, const Vec3& direction, double range, TrundleHit& hit, bool own = false) const {
        return m_services.ray(m_services.context, origin.data(), direction.data(), range, own ? 1 : 0, &hit) != 0;
    }
    // Since 1.6. False: an invalid value, or too little room for the results, which are left as they were.
    /// All beams of a fan from a pose in the world (m). Results are layer by layer, in the order of the elevations.
    bool castFan(const Fan& fan, const Pose& pose, const RayResults& results) const {
        return detail::castFan(m_services, fan, pose, results);
    }
    /// Any rays; geoms of the own robot are ignored unless `own`.
    bool castRays(std::span<const Ray> rays, const RayResults& results, bool own = false) const {
        return detail::castRays(m_services, rays, own, results);
    }
    /// Path and material of a geom. False, with empty texts and zeros, if it is unknown or the program is older.
    bool geomInfo(GeomId geom, TrundleGeomInfo& info) const { return detail::geomInfo(m_services, geom, info); }
    /// Share of light that a geom returns at a point of its surface (world frame), 0..1, by the picture or colour of its material; the
    /// normal points outwards. 0 if it is unknown or the program is older. Since 1.7.
    [[nodiscard]] double reflectance(GeomId geom, const Vec3& point, const Vec3& normal) const {
        return detail::reflectance(m_services, geom, point, normal);
    }
    /// The lights of the experiment: sun, sky, ground and lamps; `out` is overwritten. None if the program is older. Since 1.7.
    void lights(std::vector<TrundleLight>& out) const { detail::lights(m_services, out); }
    /// How the lights shine, in the order of lights(); `out` is overwritten. None if the program is older: all around. Since 1.10.
    void beams(std::vector<TrundleBeam>& out) const { detail::beams(m_services, out); }
    /// The battery of the robot. Since 1.8.
    [[nodiscard]] Supply supply() const { return detail::supply(m_services); }
    /// Whether the latch of the device holds something, and what acted on that in the last step: N, and N m about its centre of mass.
    /// Since 1.11.
    bool held(Wrench& out) const { return detail::latchHeld(m_services, out); }
    /// A function of (seed, device, tick, index): the same in every run.
    [[nodiscard]] std::uint64_t randomBits(std::uint64_t index) const { return m_services.random(m_services.context, index); }
    [[nodiscard]] double random(std::uint64_t index) const {
        return static_cast<double>(randomBits(index) >> 11) * 0x1p-53;
    } ///< [0, 1)
    void warn(const std::string& text) const {
        if (m_services.print) m_services.print(m_services.context, TRUNDLE_WARNING, text.c_str());
    }

protected:
    const TrundleServices& m_services;
};

/// Services in sense, after the step.
class Sensing : public Services {
public:
    using Services::Services;
    // Since 1.8. They do nothing in a robot without a battery.
    /// What the device drew from the battery in this tick, W; negative: what it gave back. If its current grows with the voltage of the
    /// battery, `conductance` says by how much, A/V.
    void draw(double watts, double conductance = 0) {
        if (const TrundleServicesSupply* supply = detail::supplyOf(m_services))
            supply->draw(m_services.context, watts, conductance);
    }
    /// For the device that called Mount::provideSupply: what all others drew in this tick.
    [[nodiscard]] TrundleLoad load() const {
        TrundleLoad load{};
        if (const TrundleServicesSupply* supply = detail::supplyOf(m_services)) supply->load(m_services.context, &load);
        return load;
    }
    /// For the device that called Mount::provideSupply: the voltage of the next tick, V.
    void setSupplyVoltage(double voltage) {
        if (const TrundleServicesSupply* supply = detail::supplyOf(m_services)) supply->setVoltage(m_services.context, voltage);
    }
    // Since 1.10.
    /// For the device that called Mount::provideSupply: what a geom that it touches offers to it. 0 A: nothing.
    [[nodiscard]] TrundleOffer offered(GeomId geom) const {
        TrundleOffer offer{};
        if (const TrundleServicesSupply* supply = detail::chargingOf(m_services))
            supply->offered(m_services.context, geom.index, &offer);
        return offer;
    }
    /// For the same device: it took `amperes` at `volts` in this tick.
    void takePower(GeomId geom, double volts, double amperes) {
        if (const TrundleServicesSupply* supply = detail::chargingOf(m_services))
            supply->take(m_services.context, geom.index, volts, amperes);
    }
    /// For a device that offers power: what was taken from it in the tick before.
    [[nodiscard]] TrundleTaken taken() const {
        TrundleTaken taken{};
        if (const TrundleServicesSupply* supply = detail::chargingOf(m_services)) supply->taken(m_services.context, &taken);
        return taken;
    }
};

/// Services in act, before the step.
class Actuation : public Services {
public:
    using Services::Services;
    /// Drives the joint towards `rate` with an effort of (rate - new rate) / softness, at most `limit`. Solved as a constraint
    /// within the step, so it is stable at any tick length. Softness 0: as stiff as the solver allows.
    void motorRow(JointId joint, double rate, double softness, double limit) {
        m_services.motorRow(m_services.context, joint.index, rate, softness, limit);
    }
    /// Keeps the joint at `rate` with at most the effort of a motor at its highest voltage: `limit` at rest and against the motion,
    /// limit - damping * |joint rate| along it.
    void servoRow(JointId joint, double rate, double limit, double damping) {
        m_services.servoRow(m_services.context, joint.index, rate, limit, damping);
    }
    /// Both of these in one, with friction of the drive. An older program has no such friction. Since 1.10.
    void driveJoint(JointId joint, const JointDrive& drive) { detail::driveJoint(m_services, joint.index, drive); }
    void jointTorque(JointId joint, double torque) { m_services.jointTorque(m_services.context, joint.index, torque); }
    void bodyForce(BodyId body, const Vec3& force, const Vec3& point) {
        m_services.bodyForce(m_services.context, body.index, force.data(), point.data());
    }
    /// Surface velocity in m/s in the geom's frame, as of a conveyor belt.
    void surfaceVelocity(GeomId geom, const Vec3& velocity) {
        m_services.surfaceVelocity(m_services.context, geom.index, velocity.data());
    }
    /// The device is a lamp from now on, at a point of a body (m, in its frame). `light` is that of a TrundleLight: 1 is 1000 lx at 1 m; 0: it
    /// is dark. Light sensors see it until it is changed. Since 1.8.
    void emitLight(BodyId body, const Vec3& point, double light) { detail::emitLight(m_services, body, point, light); }
    /// The same with a beam, whose axis is in the frame of the body; an older program lets it shine all around. Since 1.10.
    void emitLight(BodyId body, const Vec3& point, double light, const TrundleBeam& beam) {
        detail::emitBeam(m_services, body, point, light, beam);
    }
    /// Holds the body of a geom, or the scenery that it is part of, rigidly to a body of the own robot, as they are, until it is released or
    /// one of them is placed elsewhere. A device holds one thing. False: it cannot. Since 1.11.
    bool hold(BodyId body, GeomId geom) { return detail::latchHold(m_services, body.index, geom.index); }
    void release() { detail::latchRelease(m_services); }
    /// What touches the geom can take power from the device: in all at most `amperes`, at most at `volts`; 0 A: none. It is offered until it
    /// is changed. Since 1.10.
    void offerPower(GeomId geom, double volts, double amperes) {
        if (const TrundleServicesSupply* supply = detail::chargingOf(m_services))
            supply->offer(m_services.context, geom.index, volts, amperes);
    }
};

/// A sensor or an actuator. Override act, sense or both; a phase that is not overridden has no cost.
class Device {
public:
    virtual ~Device() = default;
    virtual void setup(Mount& mount) = 0;
    virtual void act(Actuation&) {}
    virtual void sense(Sensing&) {}
};

} // namespace sdk1
} // namespace trundle
