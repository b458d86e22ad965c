#include "world/device_mount.h"

#include <algorithm>
#include <cmath>

#include "base/platform/module_text.h"
#include "base/spelling.h"
#include "model/body_geom.h"
#include "model/dotted_path.h"
#include "world/device_radio.h"
#include "world/device_texts.h"
#include "world/signal_plan.h"
#include "world/world_objects.h"
#include "world/world_supply.h"

namespace trundle {

namespace {

constexpr std::string_view kDirection = "/direction";

/// "leftAxle, rightAxle": joins the names of a list.
template <class List> std::string namesOf(const List& list) {
    std::string out;
    for (const auto& item : list) out += (out.empty() ? "" : ", ") + item.name;
    return out.empty() ? "none" : out;
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

struct MountCalls {
    static WorldDevice& device(void* context) { return *static_cast<WorldDevice*>(context); }
    static const BuiltRobot& robot(const WorldDevice& d) { return d.host->objects.robots()[d.robot]; }
    static const RobotConfigSpec& config(const WorldDevice& d) { return *robot(d).spec->config; }

    static double* signal(void* context, const char* name) {
        WorldDevice& d = device(context);
        const std::string asked = moduleName(name);
        const int i = signalIndex(*d.kind, asked);
        if (i < 0) {
            d.note("it has no signal " + asked + " (there are: " + signalNames(*d.kind) + ")");
            return nullptr;
        }
        return d.host->block.slots().data() + d.slots[static_cast<std::size_t>(i)];
    }

    static std::int32_t joint(void* context, const char* name, std::uint32_t* out) {
        WorldDevice& d = device(context);
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
        WorldDevice& d = device(context);
        const std::string asked = moduleName(name);
        int i = indexOf(config(d).bodies, asked);
        if (const BodyGeom at = geomAt(config(d).bodies, asked); i < 0 && at.geom >= 0) i = at.body;
        if (i < 0) {
            d.note(unknownName("body", asked, config(d).bodies));
            return -1;
        }
        if (out) *out = robot(d).handles.bodies[static_cast<std::size_t>(i)].index;
        return 0;
    }

    static std::int32_t geom(void* context, const char* path, std::uint32_t* out) {
        WorldDevice& d = device(context);
        const std::string asked = moduleName(path);
        if (const auto* fixed = robot(d).spec->scenery.get())
            if (const int g = indexOf(*fixed, asked); g >= 0)
                return found(d, asked, robot(d).scenery[static_cast<std::size_t>(g)], out);
        const auto [b, g] = geomAt(config(d).bodies, asked);
        if (b < 0) {
            const std::string_view body = withoutLastWord(asked);
            d.note(body.empty() ? "there is no geom " + asked + ", it is named with its body: body.geom"
                                : unknownName("body", body, config(d).bodies));
            return -1;
        }
        if (g < 0) {
            const BodySpec& body = config(d).bodies[static_cast<std::size_t>(b)];
            d.note(unknownName("geom in " + body.name, asked.substr(body.name.size() + 1), body.geoms));
            return -1;
        }
        return found(d, asked, robot(d).handles.geoms[static_cast<std::size_t>(b)][static_cast<std::size_t>(g)], out);
    }

    static std::int32_t found(WorldDevice& d, const std::string& name, GeomHandle geom, std::uint32_t* out) {
        if (!geom.valid()) {
            d.note("the geom " + name + " does not collide (Collide=false)");
            return -1;
        }
        if (out) *out = geom.index;
        return 0;
    }

    static const WorldDevice* peer(WorldDevice& d, std::string_view name) {
        const WorldDevice* found = d.host->devices.find(d.robot, name);
        if (!found) d.note(unknownName("device", name, config(d).devices));
        return found;
    }

    static double* peerSignal(void* context, const char* kind, const char* name, const char* signalName) {
        WorldDevice& d = device(context);
        const std::string peerName = moduleName(name), ofKind = moduleName(kind), asked = moduleName(signalName);
        const WorldDevice* other = peer(d, peerName);
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
        return d.host->block.slots().data() + other->slots[static_cast<std::size_t>(i)];
    }

    /// What the device without a name, the experiment, has for Mount::gravity().
    static std::int32_t settingNumber(const SettingsSpec& settings, const std::string& name, double* value) {
        const std::string axes[] = {"Gravity.x", "Gravity.y", "Gravity.z"};
        const auto axis = std::find(std::begin(axes), std::end(axes), name) - std::begin(axes);
        if (axis == std::size(axes) || !value) return -1;
        *value = settings.gravity[axis];
        return 0;
    }

    /// For the name "count/direction", which no field has.
    static std::int32_t directionOf(const WorldDevice& other, std::string_view signal, double* value) {
        const int i = signalIndex(*other.kind, signal);
        if (i < 0 || !value) return -1;
        *value = other.kind->signals[i].direction;
        return 0;
    }

    static std::int32_t peerNumber(void* context, const char* name, const char* field, double* value) {
        WorldDevice& d = device(context);
        const std::string peerName = moduleName(name), asked = moduleName(field);
        if (peerName.empty()) return settingNumber(d.host->experiment.settings, asked, value);
        const WorldDevice* other = peer(d, peerName);
        if (!other) return -1;
        if (asked.ends_with(kDirection)) return directionOf(*other, asked.substr(0, asked.size() - kDirection.size()), value);
        const ResolvedValue* found = other->spec->find(asked);
        if (!found || found->value.numbers.empty()) return -1;
        if (value) *value = found->value.numbers[0];
        return 0;
    }

    static const char* peerText(void* context, const char* name, const char* field) {
        WorldDevice& d = device(context);
        const WorldDevice* other = peer(d, moduleName(name));
        if (!other) return nullptr;
        const ResolvedValue* found = other->spec->find(moduleName(field));
        return found && !found->value.texts.empty() ? found->value.texts[0].c_str() : nullptr;
    }

    static std::int32_t addAxialInertia(void* context, std::uint32_t joint, double inertia) {
        const DeviceHost& host = *device(context).host;
        return host.objects.jointHasPosition(joint) && host.engine.addAxialInertia({joint}, inertia).ok() ? 0 : 1;
    }

    static std::int32_t addRotor(void* context, std::uint32_t joint, double inertia, double ratio) {
        const DeviceHost& host = *device(context).host;
        return host.objects.jointHasPosition(joint) && host.engine.addRotor({joint}, inertia, ratio).ok() ? 0 : 1;
    }

    static std::int32_t measureJoint(void* context, const char* name, std::uint32_t* out) {
        WorldDevice& d = device(context);
        const auto& joints = config(d).joints;
        const std::string asked = moduleName(name);
        const int i = indexOf(joints, asked);
        if (i < 0) {
            d.note(unknownName("joint", asked, joints));
            return -1;
        }
        const JointHandle joint = robot(d).handles.joints[static_cast<std::size_t>(i)];
        if (const Status measured = d.host->engine.measureWrench(joint); !measured.ok()) {
            d.note("the joint " + asked + " cannot be measured: " + measured.error().message);
            return -1;
        }
        if (out) *out = joint.index;
        return 0;
    }

    static std::int32_t provideSupply(void* context, double nominal, double voltage) {
        WorldDevice& d = device(context);
        if (!(nominal > 0) || !std::isfinite(nominal) || !std::isfinite(voltage) ||
            !d.host->supply.provide(d.robot, nominal, voltage))
            return -1;
        d.isSupply = true;
        return 0;
    }

    static void print(void* context, std::int32_t severity, const char* words) {
        const WorldDevice& d = device(context);
        if (words) d.host->texts.print(d.path, severity, moduleMessage(words).c_str());
    }

    static void fail(void* context, const char* why) {
        const std::string reason = moduleMessage(why);
        device(context).note(reason.empty() ? "it reported no reason" : reason);
    }
};

} // namespace

void fillMount(WorldDevice& device, double tick) {
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
                    mountRadio(),
                    MountCalls::provideSupply,
                    MountCalls::measureJoint,
                    MountCalls::addRotor};
}

} // namespace trundle
