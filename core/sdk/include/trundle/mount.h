// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What a device can bind in its setup: its signals, objects of its robot, other devices.

#include <cstddef>
#include <string>
#include <utility>

#include <trundle/abi.h>
#include <trundle/geometry.h>
#include <trundle/port.h>
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
    /// Binds the members that describe() gives to signals; called by the SDK before setup.
    template <class T> void bindSignals(T& device) {
        const Describe<T>& d = descriptionOf<T>();
        for (const SignalInfo& s : d.signals())
            if (s.bind) s.bind(&device, signal(s.name.c_str(), d.countOf(s, device)), s.name.c_str());
    }
    [[nodiscard]] JointId joint(const std::string& name) { return find<JointId>(m_mount.joint, "joint", name); }
    /// A joint of any kind, across which force and torque are measured from now on (Services::jointWrench). Since 1.10.
    [[nodiscard]] JointId measuredJoint(const std::string& name) {
        if (m_mount.size >= offsetof(TrundleMount, measureJoint) + sizeof m_mount.measureJoint)
            return find<JointId>(m_mount.measureJoint, "joint", name);
        fail("this version of Trundle measures no joints");
        return {};
    }
    /// By its name, or by the path of one of its geoms.
    [[nodiscard]] BodyId body(const std::string& name) { return find<BodyId>(m_mount.body, "body", name); }
    [[nodiscard]] GeomId geom(const std::string& path) { return find<GeomId>(m_mount.geom, "geom", path); } ///< "body.geom"

    /// A signal of another device of the robot. As a consequence this device acts before the other one and senses after it.
    [[nodiscard]] Slot peer(const char* kind, const std::string& device, const char* signal, std::uint32_t count = 1) {
        double* first = m_mount.peerSignal(m_mount.context, kind, device.c_str(), signal);
        if (!first) note("there is no " + std::string(kind) + " '" + device + "' with a signal '" + signal + "'");
        return Slot(first, count);
    }
    /// All signals of another device, by their table (since 1.5): peer<RotaryMotorSignals>("leftMotor"). The order of the devices
    /// is as above.
    template <class S> [[nodiscard]] Port<S> peer(const std::string& device) {
        Port<S> port;
        port.bind([](const SignalInfo&) { return true; },
                  [&](const SignalInfo& s) {
                      double count = s.count;
                      for (const std::string& field : s.countFields) count *= peerNumber(device, field.c_str(), 0);
                      return peer(S::kKind, device, s.name.c_str(), static_cast<std::uint32_t>(count));
                  });
        return port;
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
    /// The experiment's Gravity, m/s^2 in the world (since 1.6).
    [[nodiscard]] Vec3 gravity() const {
        return {peerNumber("", "Gravity.x", 0), peerNumber("", "Gravity.y", 0), peerNumber("", "Gravity.z", -9.81)};
    }
    /// Adds inertia (kg m^2) about the joint's axis to its child, for example a geared rotor that turns with it.
    void addAxialInertia(JointId joint, double inertia) {
        const bool done = m_mount.addAxialInertia && m_mount.addAxialInertia(m_mount.context, joint.index, inertia) == 0;
        if (!done) fail("this joint can take no additional inertia");
    }
    /// Adds a rotor with this inertia (kg m^2) on the joint's parent, which turns `ratio` times as far against it as the child does, about
    /// the same axis. It adds ratio^2 inertias to what the joint moves, and gives the parent ratio inertias of reaction. Fails for a slider.
    /// Since 1.13; in an older Trundle the child alone has its inertia.
    void addRotor(JointId joint, double inertia, double ratio) {
        if (m_mount.size < offsetof(TrundleMount, addRotor) + sizeof m_mount.addRotor)
            return addAxialInertia(joint, ratio * ratio * inertia);
        if (m_mount.addRotor(m_mount.context, joint.index, inertia, ratio) != 0)
            fail("this joint can take no additional inertia");
    }
    /// Opens the device's radio with the given antenna and limits.
    [[nodiscard]] RadioId radio(const TrundleRadioSettings& settings) {
        RadioId id;
        if (m_mount.radio && m_mount.radio->open(m_mount.context, &settings, &id.index) == 0) return id;
        note("the radio could not be opened");
        return {};
    }
    /// Makes the device the battery of its robot, at first with `voltage` (V); drivers are set up for `nominal` (V). Fails if the robot has
    /// another one. The device senses after all others of the robot. Since 1.8.
    void provideSupply(double nominal, double voltage) {
        const bool known = m_mount.size >= offsetof(TrundleMount, provideSupply) + sizeof m_mount.provideSupply;
        if (!known || m_mount.provideSupply(m_mount.context, nominal, voltage) != 0)
            fail(known ? "the robot has another battery" : "this version of Trundle has no batteries");
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

} // namespace sdk1
} // namespace trundle
