#include "world/world_devices.h"

#include <algorithm>
#include <unordered_map>

#include <trundle/device_signals.h>

#include "base/platform/work_team.h"
#include "base/rng.h"
#include "schema/kind_traits.h"
#include "world/device_mount.h"
#include "world/device_order.h"
#include "world/device_services.h"
#include "world/signal_plan.h"
#include "world/world_objects.h"

namespace trundle {

/// What a text says of a field of a kind.
struct GivenField {
    std::uint32_t index = 0; ///< of the field
    const ResolvedValue* given = nullptr;
    std::vector<const char*> texts;
    std::uint32_t count = 0; ///< of elements
};

namespace {

constexpr std::size_t kMaxNotes = 4;
constexpr std::size_t kMaxNames = 200;            // bytes of the devices that a message names
constexpr std::uint64_t kMaxNumbers = 20'000'000; // in the signals of all devices: 160 MB

/// Values whose key is not a field of the kind (the module may be newer or older than its text) are ignored.
std::vector<GivenField> givenFields(const WorldDevice& device) {
    std::vector<GivenField> fields;
    for (std::uint32_t i = 0; device.kind->set && i < device.kind->fieldCount; ++i) {
        const TrundleField& field = device.kind->fields[i];
        const ResolvedValue* given = device.spec->find(field.name);
        if (!given) continue;
        GivenField& g = fields.emplace_back(GivenField{i, given, {}, 0});
        for (const std::string& t : given->value.texts) g.texts.push_back(t.c_str());
        const bool numeric = field.type == TRUNDLE_NUMBER || field.type == TRUNDLE_INTEGER || field.type == TRUNDLE_BOOLEAN;
        g.count = static_cast<std::uint32_t>(numeric ? given->value.numbers.size() : g.texts.size());
    }
    return fields;
}

/// Where values of the device are given that its block has not: one of them may be the reason.
void noteOverrides(const ComponentSpec& spec, Diagnostic& d) {
    for (const auto& [name, given] : spec.values) {
        const bool isOutside =
            given.origin == Origin::Instance || given.origin == Origin::CommandLine || given.range.file != spec.nameRange.file;
        if (given.range.known() && isOutside && d.notes.size() < kMaxNotes)
            d.notes.emplace_back(name + " is given here", given.range);
    }
}

/// By element: the lists that it is in.
std::vector<std::vector<std::uint32_t>> inverse(const std::vector<std::vector<std::uint32_t>>& lists) {
    std::vector<std::vector<std::uint32_t>> found(lists.size());
    for (std::uint32_t i = 0; i < lists.size(); ++i)
        for (const std::uint32_t each : lists[i]) found[each].push_back(i);
    return found;
}

} // namespace

void WorldDevices::create(std::span<const BuiltRobot> robots, const DeviceCode& code, Diagnostics& diagnostics) {
    for (const BuiltRobot& robot : robots) {
        const auto index = static_cast<std::uint32_t>(m_devices.firstOf.size());
        m_devices.firstOf.push_back(static_cast<std::uint32_t>(m_devices.all.size()));
        for (const ComponentSpec& spec : robot.spec->config->devices)
            if (auto device = made(robot, spec, index, code, diagnostics)) m_devices.all.push_back(std::move(device));
    }
    m_devices.firstOf.push_back(static_cast<std::uint32_t>(m_devices.all.size()));
    for (const auto& device : m_devices.all) instantiate(*device, diagnostics);
    std::unordered_map<const ComponentSpec*, std::vector<GivenField>> given; // robots of one config share their specs
    for (const auto& device : m_devices.all) {
        if (!device->instance) continue;
        const auto [place, isNew] = given.try_emplace(device->spec);
        if (isNew) place->second = givenFields(*device);
        if (giveFields(*device, place->second, diagnostics)) (void)hasRoom(*device, diagnostics);
    }
}

std::unique_ptr<WorldDevice> WorldDevices::made(const BuiltRobot& robot, const ComponentSpec& spec, std::uint32_t robotIndex,
                                                const DeviceCode& code, Diagnostics& diagnostics) {
    auto device = std::make_unique<WorldDevice>();
    device->calls = &m_calls;
    device->spec = &spec;
    device->robot = robotIndex;
    device->index = static_cast<std::uint32_t>(m_devices.all.size());
    device->path = robot.spec->name + "/" + spec.name;
    device->pathHash = fnv1a64(device->path);
    device->target = m_calls.add({"the device " + spec.kind + " " + device->path, robot.spec->name, spec.kind, {}});
    const DeviceKind kind = code ? code(spec.kind) : DeviceKind(nullptr);
    device->kind = kind.table;
    device->create = kind.create;
    if (!device->kind || device->kind->role != TRUNDLE_DEVICE || !(device->kind->create || device->create)) {
        diagnostics.error(Code::KindNotLoaded, spec.nameRange,
                          "no code is loaded for the kind " + spec.kind + " of " + device->path);
        return nullptr;
    }
    return device;
}

/// All one after another, so that their memory is, too: a tick goes through it from front to back.
void WorldDevices::instantiate(WorldDevice& device, Diagnostics& diagnostics) {
    const MonitoredCall call(m_calls, device.target, "constructor");
    device.instance = device.create ? device.create() : device.kind->create();
    if (!device.instance) diagnostics.error(Code::DeviceSetup, device.spec->nameRange, device.path + ": " + device.lastError());
}

/// A signal whose count depends on fields could need any amount of memory.
bool WorldDevices::hasRoom(const WorldDevice& device, Diagnostics& diagnostics) {
    for (std::uint32_t i = 0; i < device.kind->signalCount; ++i) {
        const TrundleSignal& s = device.kind->signals[i];
        const std::uint64_t count = signalCount(*device.kind, s, *device.spec);
        m_numbers += count;
        if (count <= kMaxSignalNumbers && m_numbers <= kMaxNumbers) continue;
        const std::string numbers = std::to_string(count) + " numbers";
        diagnostics.error(Code::DeviceSetup, device.spec->nameRange,
                          device.path + ": its signal " + s.name + " has " + numbers + "; at most " +
                              (count > kMaxSignalNumbers
                                   ? std::to_string(kMaxSignalNumbers) + " are possible"
                                   : std::to_string(kMaxNumbers) + " are possible in all devices of an experiment"));
        return false;
    }
    return true;
}

bool WorldDevices::giveFields(WorldDevice& device, std::span<const GivenField> fields, Diagnostics& diagnostics) {
    for (const GivenField& g : fields) {
        const TrundleField& field = device.kind->fields[g.index];
        const TrundleValue value{g.given->value.numbers.data(), g.texts.data(), g.count};
        // The class reads as many elements as its member has: an outdated description must not make it read out of bounds.
        const bool fits = value.count >= field.minCount && value.count <= field.maxCount;
        if (fits && device.kind->set(device.instance, g.index, &value) == 0) continue;
        diagnostics.error(Code::DeviceSetup, g.given->range.known() ? g.given->range : device.spec->nameRange,
                          device.path + ": " + field.name +
                              " was refused: " + (fits ? device.lastError() : "wrong count of elements"));
        return false;
    }
    return true;
}

void WorldDevices::layOut(std::uint32_t robot, const RobotConfigSpec& config, SignalLayout& layout) {
    for (std::uint32_t d = m_devices.firstOf[robot]; d < m_devices.firstOf[robot + 1]; ++d) {
        WorldDevice& device = *m_devices.all[d];
        for (std::uint32_t i = 0; i < device.kind->signalCount; ++i) {
            const TrundleSignal& s = device.kind->signals[i];
            device.slots.push_back(layout.add(device.spec->name + "/" + s.name,
                                              signalUnit(config, *device.spec, s.name, s.unit ? s.unit : ""),
                                              static_cast<SignalType>(s.type), static_cast<SignalDirection>(s.direction),
                                              static_cast<std::uint32_t>(signalCount(*device.kind, s, *device.spec))));
        }
    }
}

void WorldDevices::layOutLike(std::uint32_t robot, std::uint32_t equal, std::uint32_t shift) {
    const std::uint32_t first = m_devices.firstOf[robot], count = m_devices.firstOf[robot + 1] - first;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<std::uint32_t>& slots = m_devices.all[first + i]->slots;
        slots = m_devices.all[m_devices.firstOf[equal] + i]->slots;
        for (std::uint32_t& slot : slots) slot += shift;
    }
}

void WorldDevices::setup(const DeviceHost& host, Diagnostics& diagnostics) {
    m_tick = host.experiment.settings.tick;
    const WorkTeam* threads = host.engine.threads(false);
    m_services.resize(threads ? threads->size() : 1);
    for (ThreadServices& services : m_services) fillServices(services.table, m_tick);
    m_contexts.reserve(m_devices.all.size());
    for (auto& device : m_devices.all) {
        device->host = &host;
        device->phase = &m_phase;
        m_contexts.push_back({&host, device.get(), &m_phase, device->robot});
        fillMount(*device, m_tick);
        if (!device->kind->setupDevice) continue;
        const MonitoredCall call(m_calls, device->target, "setup");
        const std::int32_t answer = device->kind->setupDevice(device->instance, &device->mount);
        if (answer != 0 && device->failure.empty()) device->note(device->lastError());
        if (device->failure.empty()) continue;
        Diagnostic& d = diagnostics.error(Code::DeviceSetup, device->spec->nameRange, device->path + ": " + device->failure);
        noteOverrides(*device->spec, d);
    }
}

void WorldDevices::order(Diagnostics& diagnostics) {
    std::vector<std::vector<std::uint32_t>> peers;
    for (const auto& device : m_devices.all) peers.push_back(device->peers);
    std::vector<std::vector<std::uint32_t>> users = inverse(peers);
    const std::vector<std::uint32_t> acting = actingOrder(peers);
    const std::vector<bool> actsApart = independent(acting, users);
    addSupplies(users);
    const std::vector<std::uint32_t> sensing = actingOrder(users);
    const std::vector<bool> sensesApart = independent(sensing, inverse(users));
    for (const std::uint32_t i : acting)
        if (const WorldDevice& d = *m_devices.all[i]; d.kind->act) {
            const DeviceCall call{d.kind->act, d.instance, &m_contexts[i], d.target};
            m_acting.add(call, actsApart[i]);
            if (d.spec->kind == LedSignals::kKind) m_leds.add(call, false);
        }
    for (const std::uint32_t i : sensing)
        if (const WorldDevice& d = *m_devices.all[i]; d.kind->sense)
            m_sensing.add({d.kind->sense, d.instance, &m_contexts[i], d.target}, sensesApart[i]);
    for (PhaseCalls* calls : {&m_acting, &m_sensing, &m_leds}) calls->arrange();
    if (acting.size() != m_devices.all.size()) reportCircle(acting, diagnostics);
    else if (sensing.size() != m_devices.all.size()) reportCircle(sensing, diagnostics);
}

/// By device: it is independent, and so are all that it waits for in this order. `before`: by device, whom it follows directly.
std::vector<bool> WorldDevices::independent(const std::vector<std::uint32_t>& order,
                                            const std::vector<std::vector<std::uint32_t>>& before) const {
    std::vector<bool> apart(m_devices.all.size());
    for (const std::uint32_t i : order)
        apart[i] =
            isIndependent(*m_devices.all[i]->kind) && std::ranges::all_of(before[i], [&](std::uint32_t k) { return apart[k]; });
    return apart;
}

/// The supply of a robot senses after all devices of it that do not sense after it anyway.
void WorldDevices::addSupplies(std::vector<std::vector<std::uint32_t>>& next) const {
    for (const auto& supply : m_devices.all) {
        if (!supply->isSupply) continue;
        for (std::uint32_t i = m_devices.firstOf[supply->robot]; i < m_devices.firstOf[supply->robot + 1]; ++i) {
            const std::vector<std::uint32_t>& peers = m_devices.all[i]->peers;
            const bool bound = std::find(peers.begin(), peers.end(), supply->index) != peers.end();
            if (i != supply->index && !bound) next[i].push_back(supply->index);
        }
    }
}

/// Of those that have no place in the order.
void WorldDevices::reportCircle(const std::vector<std::uint32_t>& acting, Diagnostics& diagnostics) const {
    std::vector<bool> placed(m_devices.all.size());
    for (const std::uint32_t i : acting) placed[i] = true;
    std::string names;
    const WorldDevice* first = nullptr;
    for (const auto& device : m_devices.all) {
        if (placed[device->index]) continue;
        if (!first) first = device.get();
        if (names.size() < kMaxNames) names += (names.empty() ? "" : ", ") + device->path;
    }
    diagnostics.error(Code::DeviceSetup, first->spec->nameRange, "these devices drive each other in a circle: " + names);
}

const WorldDevice* WorldDevices::callAll(std::uint64_t ticks, DevicePhase::Calls phase, const PhaseCalls& calls) {
    if (m_devices.all.empty()) return nullptr;
    m_phase.ticks = ticks;
    m_phase.calls = phase;
    for (ThreadServices& services : m_services) services.table.time = static_cast<double>(ticks) * m_tick;
    Engine& engine = m_devices.all.front()->host->engine;
    WorkTeam* team = engine.threads(phase == DevicePhase::Calls::Act);
    const WorldDevice* failed = calls.run({m_calls, m_phase, m_services, team});
    m_phase.calls = DevicePhase::Calls::None;
    return failed;
}

} // namespace trundle
