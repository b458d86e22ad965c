#pragma once
// A robot without physics engine: joints that turn freely, each with its own inertia, and devices called through the C tables as the
// world calls them. No ground; the only contacts are those that a test sets.

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <trundle/abi.h>

#include "devices/builtin.h"

namespace trundle::test {

struct BenchJoint {
    double inertia = 1e-3; ///< kg m^2
    double position = 0, rate = 0, effort = 0;
    bool driven = false;
    double rowRate = 0, rowSoftness = 0, rowLimit = 0, rowDamping = 0;
    double anchor[3] = {0, 0, 0};
};

struct BenchDevice {
    std::string kind, name;
    std::map<std::string, std::vector<double>> numbers; ///< SI
    std::map<std::string, std::vector<std::string>> texts;
    const TrundleKind* code = nullptr;
    void* instance = nullptr;
    std::string failure;
};

class BenchRobot {
public:
    explicit BenchRobot(double tick) : m_tick(tick) {}
    ~BenchRobot() {
        for (BenchDevice& d : devices)
            if (d.instance) d.code->destroy(d.instance);
    }
    BenchRobot(const BenchRobot&) = delete;
    BenchRobot& operator=(const BenchRobot&) = delete;

    BenchJoint& joint(const std::string& name) {
        for (std::size_t i = 0; i < m_jointNames.size(); ++i)
            if (m_jointNames[i] == name) return m_joints[i];
        m_jointNames.push_back(name);
        return m_joints.emplace_back();
    }
    BenchDevice& device(const std::string& kind, const std::string& name) {
        BenchDevice& d = devices.emplace_back();
        d.kind = kind;
        d.name = name;
        d.code = findBuiltInDevice(kind);
        return d;
    }
    /// Creates and mounts all devices; returns the first failure, or "".
    std::string setup() {
        for (BenchDevice& d : devices)
            if (std::string why = setup(d); !why.empty()) return why;
        return "";
    }
    /// act in text order, step, sense in reverse order; a device that binds a peer's signals must precede that peer.
    void tick() {
        for (BenchJoint& j : m_joints) j.driven = false;
        TrundleServices services = table();
        for (BenchDevice& d : devices)
            if (d.code->act) d.code->act(d.instance, &services);
        step();
        ++m_ticks;
        services.time = m_tick * m_ticks;
        for (std::size_t i = devices.size(); i-- > 0;)
            if (devices[i].code->sense) devices[i].code->sense(devices[i].instance, &services);
    }
    void run(double seconds) {
        for (int i = 0, n = static_cast<int>(std::lround(seconds / m_tick)); i < n; ++i) tick();
    }
    std::vector<double>& signal(const std::string& path) {
        auto& values = m_signals[path];
        if (values.empty()) values.resize(8);
        return values;
    }

    std::deque<BenchDevice> devices;
    std::map<std::string, std::vector<TrundleContact>> contacts; ///< by geom path
    std::vector<std::string> warnings;
    std::map<std::string, double> addedInertia;

private:
    std::string setup(BenchDevice& d) {
        d.instance = d.code->create();
        for (std::uint32_t i = 0; i < d.code->fieldCount; ++i) setField(d, i);
        m_now = &d;
        m_path = "robot0/" + d.name;
        TrundleMount mount{};
        mount.size = sizeof mount;
        mount.context = this;
        mount.path = m_path.c_str();
        mount.tick = m_tick;
        mount.signal = [](void* c, const char* name) { return self(c).signal(self(c).m_now->name + "/" + name).data(); };
        mount.joint = [](void* c, const char* name, std::uint32_t* id) { return find(self(c).m_jointNames, name, id); };
        mount.body = [](void*, const char*, std::uint32_t*) -> std::int32_t { return 1; };
        mount.geom = [](void* c, const char* path, std::uint32_t* id) -> std::int32_t {
            if (!self(c).contacts.contains(path)) return 1;
            return find(self(c).m_geomNames, path, id) == 0
                       ? 0
                       : (self(c).m_geomNames.push_back(path), *id = self(c).m_geomNames.size() - 1, 0);
        };
        mount.peerSignal = [](void* c, const char* kind, const char* device, const char* signal) -> double* {
            const BenchDevice* peer = self(c).peer(device);
            return peer && peer->kind == kind ? self(c).signal(std::string(device) + "/" + signal).data() : nullptr;
        };
        mount.peerNumber = [](void* c, const char* device, const char* field, double* value) -> std::int32_t {
            const BenchDevice* peer = self(c).peer(device);
            if (!peer || !peer->numbers.contains(field)) return 1;
            *value = peer->numbers.at(field).at(0);
            return 0;
        };
        mount.peerText = [](void* c, const char* device, const char* field) -> const char* {
            const BenchDevice* peer = self(c).peer(device);
            return peer && peer->texts.contains(field) ? peer->texts.at(field).at(0).c_str() : nullptr;
        };
        mount.fail = [](void* c, const char* text) { self(c).m_now->failure = text; };
        mount.addAxialInertia = [](void* c, std::uint32_t joint, double inertia) -> std::int32_t {
            self(c).m_joints[joint].inertia += inertia;
            return 0;
        };
        mount.addRotor = [](void* c, std::uint32_t joint, double inertia, double ratio) -> std::int32_t {
            self(c).m_joints[joint].inertia += ratio * ratio * inertia;
            return 0;
        };
        if (d.code->setupDevice(d.instance, &mount) == 0) return d.failure;
        return d.failure.empty() ? d.code->lastError(d.instance) : d.failure;
    }
    void setField(BenchDevice& d, std::uint32_t index) {
        const std::string name = d.code->fields[index].name;
        if (d.numbers.contains(name)) {
            const auto& n = d.numbers[name];
            const TrundleValue value{n.data(), nullptr, static_cast<std::uint32_t>(n.size())};
            d.code->set(d.instance, index, &value);
        } else if (d.texts.contains(name)) {
            std::vector<const char*> texts;
            for (const std::string& t : d.texts[name]) texts.push_back(t.c_str());
            const TrundleValue value{nullptr, texts.data(), static_cast<std::uint32_t>(texts.size())};
            d.code->set(d.instance, index, &value);
        }
    }
    /// Solves the motor constraint of each joint: I (w' - w) / h = T, T = (rate - w') / softness within the limit, and of a servo
    /// within limit - damping |w'| along w'.
    void step() {
        for (BenchJoint& j : m_joints) {
            double torque = 0;
            if (j.driven)
                torque = std::clamp((j.rowRate - j.rate) / (j.rowSoftness + m_tick / j.inertia), -j.rowLimit, j.rowLimit);
            if (const double next = j.rate + torque * m_tick / j.inertia; torque * next > 0 && j.rowDamping > 0) {
                const double side = torque > 0 ? 1 : -1;
                const double most = (j.rowLimit - j.rowDamping * side * j.rate) / (1 + j.rowDamping * m_tick / j.inertia);
                torque = side * std::min(side * torque, most);
            }
            j.effort = torque;
            j.rate += torque * m_tick / j.inertia;
            j.position += j.rate * m_tick;
        }
    }
    TrundleServices table() {
        TrundleServices s{};
        s.size = sizeof s;
        s.context = this;
        s.tick = m_tick;
        s.time = m_tick * m_ticks;
        s.motorRow = [](void* c, std::uint32_t joint, double rate, double softness, double limit) {
            BenchJoint& j = self(c).m_joints[joint];
            j.driven = true;
            j.rowRate = rate;
            j.rowSoftness = softness;
            j.rowLimit = limit;
            j.rowDamping = 0;
        };
        s.servoRow = [](void* c, std::uint32_t joint, double rate, double limit, double damping) {
            BenchJoint& j = self(c).m_joints[joint];
            j.driven = true;
            j.rowRate = rate;
            j.rowSoftness = 0;
            j.rowLimit = limit;
            j.rowDamping = damping;
        };
        s.jointPosition = [](void* c, std::uint32_t joint) { return self(c).m_joints[joint].position; };
        s.jointRate = [](void* c, std::uint32_t joint) { return self(c).m_joints[joint].rate; };
        s.jointMotorEffort = [](void* c, std::uint32_t joint) { return self(c).m_joints[joint].effort; };
        s.jointAnchor = [](void* c, std::uint32_t joint, double anchor[3], double axis[3]) {
            for (int i = 0; i < 3; ++i) anchor[i] = self(c).m_joints[joint].anchor[i], axis[i] = i == 1;
        };
        s.contacts = [](void* c, std::uint32_t geom, TrundleContact* out, std::uint32_t capacity) {
            const auto& there = self(c).contacts[self(c).m_geomNames[geom]];
            for (std::size_t i = 0; i < there.size() && i < capacity; ++i) out[i] = there[i];
            return static_cast<std::uint32_t>(there.size());
        };
        s.print = [](void* c, std::int32_t, const char* text) { self(c).warnings.push_back(text); };
        return s;
    }
    const BenchDevice* peer(const std::string& name) const {
        for (const BenchDevice& d : devices)
            if (d.name == name) return &d;
        return nullptr;
    }
    static BenchRobot& self(void* context) { return *static_cast<BenchRobot*>(context); }
    static std::int32_t find(const std::vector<std::string>& names, const char* name, std::uint32_t* id) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) return *id = static_cast<std::uint32_t>(i), 0;
        return 1;
    }

    double m_tick;
    int m_ticks = 0;
    std::vector<std::string> m_jointNames, m_geomNames;
    std::deque<BenchJoint> m_joints;
    std::map<std::string, std::vector<double>> m_signals;
    BenchDevice* m_now = nullptr;
    std::string m_path;
};

/// Adds motor M0 of the physics notes to a joint.
inline BenchDevice& addMotor(BenchRobot& robot, const std::string& name, const std::string& joint) {
    robot.joint(joint);
    BenchDevice& motor = robot.device("RotaryMotor", name);
    motor.texts = {{"Joint", {joint}}};
    motor.numbers = {
        {"TorqueConstant", {0.03}}, {"BackEmfConstant", {0.03}}, {"Resistance", {2}}, {"GearRatio", {30}}, {"MaxVoltage", {12}}};
    return motor;
}

} // namespace trundle::test
