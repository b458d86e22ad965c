// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Everything a sensor or an actuator needs. A device belongs to a robot, accesses the world only through these services and
// publishes signals. It never sets a pose or a velocity directly.

#include <string>
#include <utility>
#include <vector>

#include <trundle/describe.h>
#include <trundle/geometry.h>
#include <trundle/module.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// Id of an object of the world; valid as long as the world exists.
template <class Tag> struct WorldId {
    std::uint32_t index = 0xffffffffu;
    [[nodiscard]] explicit operator bool() const { return index != 0xffffffffu; }
    bool operator==(const WorldId&) const = default;
};
using JointId = WorldId<struct JointTag>;
using BodyId = WorldId<struct BodyTag>;
using GeomId = WorldId<struct GeomTag>;
using RadioId = WorldId<struct RadioTag>;

/// Access to the robot and the world during setup of a device. If a requested object is missing, setup fails with a message that
/// lists the available names; until then the call returns an empty value.
class Mount {
public:
    explicit Mount(const TrundleMount& mount) : m_mount(mount) {}

    [[nodiscard]] std::string path() const { return m_mount.path; } ///< "robot0/leftMotor"
    [[nodiscard]] Seconds tick() const { return {m_mount.tick}; }

    /// A described signal of this device.
    [[nodiscard]] Slot signal(const char* name, std::uint32_t count = 1) {
        return Slot(m_mount.signal(m_mount.context, name), count);
    }
    [[nodiscard]] JointId joint(const std::string& name) { return find<JointId>(m_mount.joint, "joint", name); }
    [[nodiscard]] BodyId body(const std::string& name) { return find<BodyId>(m_mount.body, "body", name); }
    [[nodiscard]] GeomId geom(const std::string& path) { return find<GeomId>(m_mount.geom, "geom", path); } ///< "body.geom"

    /// A signal of another device of the robot. As a consequence this device acts before the other one and senses after it.
    [[nodiscard]] Slot peer(const char* kind, const std::string& device, const char* signal, std::uint32_t count = 1) {
        double* first = m_mount.peerSignal(m_mount.context, kind, device.c_str(), signal);
        if (!first) note("there is no " + std::string(kind) + " '" + device + "' with a signal '" + signal + "'");
        return Slot(first, count);
    }
    /// A numeric field of another device, in SI units; `otherwise` if it is not set.
    [[nodiscard]] double peerNumber(const std::string& device, const char* field, double otherwise) const {
        double value = otherwise;
        return m_mount.peerNumber(m_mount.context, device.c_str(), field, &value) == 0 ? value : otherwise;
    }
    [[nodiscard]] std::string peerText(const std::string& device, const char* field) const {
        const char* text = m_mount.peerText(m_mount.context, device.c_str(), field);
        return text ? text : "";
    }
    /// Adds inertia (kg m^2) about the joint's axis to its child, for example a geared rotor that turns with it.
    void addAxialInertia(JointId joint, double inertia) {
        const bool done = m_mount.addAxialInertia && m_mount.addAxialInertia(m_mount.context, joint.index, inertia) == 0;
        if (!done) fail("this joint can take no additional inertia");
    }
    /// Opens the device's radio with the given antenna and limits.
    [[nodiscard]] RadioId radio(const TrundleRadioSettings& settings) {
        RadioId id;
        if (m_mount.radio && m_mount.radio->open(m_mount.context, &settings, &id.index) == 0) return id;
        note("the radio could not be opened");
        return {};
    }
    void warn(const std::string& text) const {
        if (m_mount.print) m_mount.print(m_mount.context, TRUNDLE_WARNING, text.c_str());
    }
    /// Reports why the device cannot be set up.
    void fail(const std::string& text) {
        note(text);
        m_mount.fail(m_mount.context, text.c_str());
    }
    [[nodiscard]] const std::string& failure() const { return m_failure; } ///< the first failure; empty: none

private:
    void note(std::string text) {
        if (m_failure.empty()) m_failure = std::move(text);
    }
    template <class Id, class Find> Id find(Find* find, const char* what, const std::string& name) {
        Id id;
        if (find(m_mount.context, name.c_str(), &id.index) != 0) {
            id = {};
            note("there is no " + std::string(what) + " '" + name + "'");
        }
        return id;
    }
    const TrundleMount& m_mount;
    std::string m_failure;
};

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
    void contacts(GeomId geom, std::vector<TrundleContact>& out) const;
    /// Nearest hit along a unit direction within `range` (m); geoms of the own robot are ignored unless `own`.
    bool ray(const Vec3& origin, const Vec3& direction, double range, TrundleHit& hit, bool own = false) const {
        return m_services.ray(m_services.context, origin.data(), direction.data(), range, own ? 1 : 0, &hit) != 0;
    }
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
    using Services::Services;
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
    void jointTorque(JointId joint, double torque) { m_services.jointTorque(m_services.context, joint.index, torque); }
    void bodyForce(BodyId body, const Vec3& force, const Vec3& point) {
        m_services.bodyForce(m_services.context, body.index, force.data(), point.data());
    }
    /// Surface velocity in m/s in the geom's frame, as of a conveyor belt.
    void surfaceVelocity(GeomId geom, const Vec3& velocity) {
        m_services.surfaceVelocity(m_services.context, geom.index, velocity.data());
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

inline void Services::contacts(GeomId geom, std::vector<TrundleContact>& out) const {
    out.resize(out.capacity() < 8 ? 8 : out.capacity());
    auto room = static_cast<std::uint32_t>(out.size());
    std::uint32_t there = m_services.contacts(m_services.context, geom.index, out.data(), room);
    if (there > room) {
        out.resize(room = there);
        there = m_services.contacts(m_services.context, geom.index, out.data(), room);
    }
    out.resize(there < room ? there : room);
}

} // namespace sdk1
} // namespace trundle
