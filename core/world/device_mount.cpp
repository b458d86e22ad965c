// Creation of devices: instantiated from their kind's table, initialised with their fields, bound to joints, geoms and each
// other.
#include <algorithm>
#include <cstring>

#include "base/platform/module_text.h"
#include "base/rng.h"
#include "base/spelling.h"
#include "world/built_world.h"
#include "world/device_order.h"
#include "world/signal_plan.h"

namespace trundle {

namespace {

constexpr std::size_t kMaxEarlyTexts = 1000;

std::string errorOf(const TrundleKind& kind, void* instance) {
    const std::string text = kind.lastError ? moduleMessage(kind.lastError(instance)) : std::string();
    return text.empty() ? "it reported no reason" : text;
}

/// Message for an unknown name: "has no joint leftAxel; did you mean leftAxle? (leftAxle, rightAxle)"
template <class List> std::string unknownName(const std::string& what, std::string_view name, const List& list) {
    std::vector<std::string> names;
    for (const auto& item : list) names.push_back(item.name);
    std::string text = "there is no " + what + " " + std::string(name);
    const auto near = nearestWords(name, names, 1);
    if (!near.empty()) text += ", did you mean " + near[0] + "?";
    return text + " (there are: " + namesOf(list) + ")";
}

template <class List> int indexOf(const List& list, std::string_view name) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].name == name) return static_cast<int>(i);
    return -1;
}

int signalIndex(const TrundleKind& kind, std::string_view name) {
    for (std::uint32_t i = 0; i < kind.signalCount; ++i)
        if (name == kind.signals[i].name) return static_cast<int>(i);
    return -1;
}

std::string signalNames(const TrundleKind& kind) {
    std::string out;
    for (std::uint32_t i = 0; i < kind.signalCount; ++i) out += (i ? ", " : "") + std::string(kind.signals[i].name);
    return out.empty() ? "none" : out;
}

} // namespace

/// Implementation of TrundleMount; the context is the device.
struct MountCalls {
    static Device& device(void* context) { return *static_cast<Device*>(context); }
    static const BuiltRobot& robot(Device& d) { return d.world->m_robots[d.robot]; }
    static const RobotConfigSpec& config(Device& d) { return *robot(d).spec->config; }

    static double* signal(void* context, const char* name) {
        Device& d = device(context);
        const std::string asked = moduleName(name);
        const int i = signalIndex(*d.kind, asked);
        if (i < 0) {
            d.note("it has no signal " + asked + " (there are: " + signalNames(*d.kind) + ")");
            return nullptr;
        }
        return d.world->m_block->slots().data() + d.slots[static_cast<std::size_t>(i)];
    }

    static std::int32_t joint(void* context, const char* name, std::uint32_t* out) {
        Device& d = device(context);
        const auto& joints = config(d).joints;
        const std::string asked = moduleName(name);
        const int i = indexOf(joints, asked);
        if (i < 0) {
            d.note(unknownName("joint", asked, joints));
            return -1;
        }
        if (!hasPosition(joints[static_cast<std::size_t>(i)].type)) {
            d.note("the joint " + asked + " has no axis to turn about or slide along");
            return -1;
        }
        if (out) *out = robot(d).handles.joints[static_cast<std::size_t>(i)].index;
        return 0;
    }

    static std::int32_t body(void* context, const char* name, std::uint32_t* out) {
        Device& d = device(context);
        const std::string asked = moduleName(name);
        const int i = indexOf(config(d).bodies, asked);
        if (i < 0) {
            d.note(unknownName("body", asked, config(d).bodies));
            return -1;
        }
        if (out) *out = robot(d).handles.bodies[static_cast<std::size_t>(i)].index;
        return 0;
    }

    static std::int32_t geom(void* context, const char* path, std::uint32_t* out) {
        Device& d = device(context);
        const std::string asked = moduleName(path);
        const std::string_view whole = asked;
        const std::size_t dot = whole.find('.');
        const std::string_view bodyName = whole.substr(0, dot),
                               geomName = dot == std::string_view::npos ? "" : whole.substr(dot + 1);
        const int b = indexOf(config(d).bodies, bodyName);
        if (b < 0) {
            d.note(unknownName("body", bodyName, config(d).bodies));
            return -1;
        }
        const auto& geoms = config(d).bodies[static_cast<std::size_t>(b)].geoms;
        const int g = indexOf(geoms, geomName);
        if (g < 0) {
            d.note(unknownName("geom in " + std::string(bodyName), geomName, geoms));
            return -1;
        }
        const GeomHandle id = robot(d).handles.geoms[static_cast<std::size_t>(b)][static_cast<std::size_t>(g)];
        if (!id.valid()) {
            d.note("the geom " + asked + " does not collide (Collide=false)");
            return -1;
        }
        if (out) *out = id.index;
        return 0;
    }

    static Device* peer(Device& d, std::string_view name) {
        Device* found = d.world->deviceNamed(robot(d), name);
        if (!found) d.note(unknownName("device", name, config(d).devices));
        return found;
    }

    static double* peerSignal(void* context, const char* kind, const char* name, const char* signalName) {
        Device& d = device(context);
        const std::string peerName = moduleName(name), ofKind = moduleName(kind), asked = moduleName(signalName);
        Device* other = peer(d, peerName);
        if (!other) return nullptr;
        if (!ofKind.empty() && other->spec->kind != ofKind) {
            d.note(peerName + " is a " + other->spec->kind + ", not a " + ofKind);
            return nullptr;
        }
        const int i = signalIndex(*other->kind, asked);
        if (i < 0) {
            d.note(peerName + " has no signal " + asked + " (there are: " + signalNames(*other->kind) + ")");
            return nullptr;
        }
        if (other != &d && std::find(d.peers.begin(), d.peers.end(), other->index) == d.peers.end())
            d.peers.push_back(other->index);
        return d.world->m_block->slots().data() + other->slots[static_cast<std::size_t>(i)];
    }

    static std::int32_t peerNumber(void* context, const char* name, const char* field, double* value) {
        Device& d = device(context);
        const Device* other = peer(d, moduleName(name));
        if (!other) return -1;
        const ResolvedValue* found = other->spec->find(moduleName(field));
        if (!found || found->value.numbers.empty()) return -1;
        if (value) *value = found->value.numbers[0];
        return 0;
    }

    static const char* peerText(void* context, const char* name, const char* field) {
        Device& d = device(context);
        const Device* other = peer(d, moduleName(name));
        if (!other) return nullptr;
        const ResolvedValue* found = other->spec->find(moduleName(field));
        return found && !found->value.texts.empty() ? found->value.texts[0].c_str() : nullptr;
    }

    static std::int32_t addAxialInertia(void* context, std::uint32_t joint, double inertia) {
        BuiltWorld& w = *device(context).world;
        const bool turns = joint < w.m_jointTurns.size() && w.m_jointTurns[joint];
        return turns && w.m_engine->addAxialInertia({joint}, inertia).ok() ? 0 : 1;
    }

    static void print(void* context, std::int32_t severity, const char* words) {
        const Device& d = device(context);
        if (words) d.world->print(d, severity, moduleMessage(words).c_str());
    }

    static void fail(void* context, const char* why) {
        const std::string reason = moduleMessage(why);
        device(context).note(reason.empty() ? "it reported no reason" : reason);
    }
};

void fillMount(Device& device, double tick) {
    device.mount = {sizeof(TrundleMount),
                    0,
                    &device,
                    device.path.c_str(),
                    tick,
                    MountCalls::signal,
                    MountCalls::joint,
                    MountCalls::body,
                    MountCalls::geom,
                    MountCalls::peerSignal,
                    MountCalls::peerNumber,
                    MountCalls::peerText,
                    MountCalls::fail,
                    MountCalls::addAxialInertia,
                    MountCalls::print,
                    mountRadio()};
}

Device::~Device() {
    if (!instance || !kind || !kind->destroy) return;
    const MonitoredCall call(*world->m_calls, target, "destructor");
    kind->destroy(instance);
}

void Device::note(const std::string& why) {
    if (failure.empty()) failure = why;
    world->m_deviceNoted = true;
}

/// Texts printed while the world is being built are kept until a listener is set.
void BuiltWorld::print(const Device& device, int severity, const char* text) {
    if (m_deviceText) m_deviceText(device.path, severity, text);
    else if (m_earlyTexts.size() < kMaxEarlyTexts) m_earlyTexts.push_back({device.path, severity, text});
}

void BuiltWorld::setDeviceText(DeviceText text) {
    m_deviceText = std::move(text);
    if (!m_deviceText) return;
    for (const SetupText& early : std::exchange(m_earlyTexts, {})) m_deviceText(early.path, early.severity, early.text);
}

Device* BuiltWorld::deviceNamed(const BuiltRobot& robot, std::string_view name) {
    for (std::uint32_t i = robot.firstDevice; i < robot.firstDevice + robot.deviceCount; ++i)
        if (m_devices[i]->spec->name == name) return m_devices[i].get();
    return nullptr;
}

void BuiltWorld::createDevices(const DeviceCode& code, Diagnostics& diagnostics) {
    for (std::size_t r = 0; r < m_robots.size(); ++r) {
        BuiltRobot& robot = m_robots[r];
        robot.firstDevice = static_cast<std::uint32_t>(m_devices.size());
        for (const ComponentSpec& spec : robot.spec->config->devices) {
            auto device = std::make_unique<Device>();
            device->world = this;
            device->spec = &spec;
            device->robot = static_cast<std::uint32_t>(r);
            device->index = static_cast<std::uint32_t>(m_devices.size());
            device->path = robot.spec->name + "/" + spec.name;
            device->pathHash = fnv1a64(device->path);
            device->target = m_calls->add({"the device " + spec.kind + " " + device->path, robot.spec->name, spec.kind, {}});
            device->kind = code ? code(spec.kind) : nullptr;
            if (!device->kind || device->kind->role != TRUNDLE_DEVICE || !device->kind->create) {
                diagnostics.error(Code::KindNotLoaded, spec.nameRange,
                                  "no code is loaded for the kind " + spec.kind + " of " + device->path);
                continue;
            }
            const MonitoredCall call(*m_calls, device->target, "constructor");
            device->instance = device->kind->create();
            if (!device->instance) {
                diagnostics.error(Code::DeviceSetup, spec.nameRange, device->path + ": " + errorOf(*device->kind, nullptr));
                continue;
            }
            if (!giveFields(*device, diagnostics)) continue;
            m_devices.push_back(std::move(device));
            ++robot.deviceCount;
        }
    }
}

/// Values whose key is not a field of the kind (the module may be newer or older than its text) are ignored.
bool BuiltWorld::giveFields(Device& device, Diagnostics& diagnostics) {
    const TrundleKind& kind = *device.kind;
    for (std::uint32_t i = 0; i < kind.fieldCount; ++i) {
        const ResolvedValue* given = device.spec->find(kind.fields[i].name);
        if (!given || !kind.set) continue;
        std::vector<const char*> texts;
        for (const std::string& t : given->value.texts) texts.push_back(t.c_str());
        const TrundleField& field = kind.fields[i];
        const bool numeric = field.type == TRUNDLE_NUMBER || field.type == TRUNDLE_INTEGER || field.type == TRUNDLE_BOOLEAN;
        const TrundleValue value{given->value.numbers.data(), texts.data(),
                                 static_cast<std::uint32_t>(numeric ? given->value.numbers.size() : texts.size())};
        // The class reads as many elements as its member has: an outdated description must not make it read out of bounds.
        const bool fits = value.count >= field.minCount && value.count <= field.maxCount;
        if (fits && kind.set(device.instance, i, &value) == 0) continue;
        diagnostics.error(Code::DeviceSetup, given->range.known() ? given->range : device.spec->nameRange,
                          device.path + ": " + field.name +
                              " was refused: " + (fits ? errorOf(kind, device.instance) : "wrong count of elements"));
        return false;
    }
    return true;
}

void BuiltWorld::setupDevices(Diagnostics& diagnostics) {
    for (auto& device : m_devices) {
        fillMount(*device, m_experiment->settings.tick);
        if (!device->kind->setupDevice) continue;
        const MonitoredCall call(*m_calls, device->target, "setup");
        const std::int32_t answer = device->kind->setupDevice(device->instance, &device->mount);
        if (answer != 0 && device->failure.empty()) device->note(errorOf(*device->kind, device->instance));
        if (!device->failure.empty())
            diagnostics.error(Code::DeviceSetup, device->spec->nameRange, device->path + ": " + device->failure);
    }
}

/// Devices act before the peers whose signals they bound, and sense after them.
void BuiltWorld::orderDevices(Diagnostics& diagnostics) {
    std::vector<std::vector<std::uint32_t>> peers, users(m_devices.size());
    for (const auto& device : m_devices) {
        peers.push_back(device->peers);
        for (const std::uint32_t p : device->peers) users[p].push_back(device->index);
    }
    const std::vector<std::uint32_t> acting = actingOrder(peers);
    for (const std::uint32_t i : acting)
        if (Device& d = *m_devices[i]; d.kind->act) m_acting.push_back({d.kind->act, d.instance, &d});
    for (const std::uint32_t i : actingOrder(users))
        if (Device& d = *m_devices[i]; d.kind->sense) m_sensing.push_back({d.kind->sense, d.instance, &d});
    if (acting.size() == m_devices.size()) return;
    std::vector<bool> placed(m_devices.size());
    for (const std::uint32_t i : acting) placed[i] = true;
    std::string names;
    const Device* first = nullptr;
    for (const auto& device : m_devices) {
        if (placed[device->index]) continue;
        if (!first) first = device.get();
        if (names.size() < 200) names += (names.empty() ? "" : ", ") + device->path;
    }
    diagnostics.error(Code::DeviceSetup, first->spec->nameRange, "these devices drive each other in a circle: " + names);
}

} // namespace trundle
