#include "control/host/python_device_host.h"

#include <algorithm>
#include <cmath>

#include "control/host/host_fault.h"
#include "control/kinds_json.h"

namespace trundle {
namespace {

constexpr double kSlack = 1e-6; // ticks, as in SensorClock

/// What the functions of a table do.
struct TableCalls {
    static PythonDevice& device(void* instance) { return *static_cast<PythonDevice*>(instance); }

    static void destroy(void* instance) { device(instance).host->destroy(device(instance)); }
    static std::int32_t set(void* instance, std::uint32_t field, const TrundleValue* value) {
        PythonDevice& d = device(instance);
        return d.host->set(d, d.kind->properties.at(field), *value) ? 0 : 1;
    }
    static const char* lastError(void* instance) { return instance ? device(instance).error.c_str() : ""; }
    static std::int32_t setup(void* instance, const TrundleMount* mount) {
        PythonDevice& d = device(instance);
        return d.host->setup(d, *mount) ? 0 : 1;
    }
    static std::int32_t act(void* instance, const TrundleServices* services) {
        PythonDevice& d = device(instance);
        return !d.acts || d.host->call(d, HostRequest::Act, *services) ? 0 : 1;
    }
    static std::int32_t sense(void* instance, const TrundleServices* services) {
        PythonDevice& d = device(instance);
        const bool idle = services->time + kSlack * services->tick < d.idleUntil;
        return !d.senses || idle || d.host->call(d, HostRequest::Sense, *services) ? 0 : 1;
    }
};

} // namespace

std::vector<double> PythonDevice::numbers() const {
    std::vector<double> all;
    for (const auto& [slots, count] : signals) all.insert(all.end(), slots, slots + count);
    return all;
}

void PythonDevice::setNumbers(const std::vector<double>& values) {
    std::size_t at = 0;
    for (const auto& [slots, count] : signals) {
        if (at + count > values.size()) return;
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(at), count, slots);
        at += count;
    }
}

PythonDeviceHost::PythonDeviceHost(std::unique_ptr<HostConnection> connection, std::string file, std::uint64_t seed)
    : m_file(std::move(file)), m_seed(seed), m_connection(std::move(connection)) {}

PythonDeviceHost::~PythonDeviceHost() {
    if (m_connection->alive())
        (void)m_connection->call(HostRequest::Unload, {}, [](HostRecord, std::uint32_t, WireReader&) { return std::string(); });
}

Result<std::vector<Kind>> PythonDeviceHost::load() {
    Status done;
    std::string json;
    const bool alive = m_connection->call(HostRequest::Load, WireWriter().bytes(m_file).view(),
                                          [&](HostRecord record, std::uint32_t, WireReader& in) {
                                              if (record == HostRecord::Done) {
                                                  done = in.status();
                                                  json = in.text();
                                              }
                                              return std::string();
                                          });
    if (!alive) return errorOfLoading(Code::PythonModule, m_connection->end(), m_file);
    if (!done) return done.error();
    Result<std::vector<Kind>> kinds = kindsFromJson(json, m_file);
    if (!kinds) return kinds;
    m_kinds = kinds.value();
    for (const Kind& kind : m_kinds) addTable(kind);
    return kinds;
}

/// The fields as the world reads them; the text was checked with the kind itself.
void PythonDeviceHost::addTable(const Kind& kind) {
    KindTable& table = m_tables.emplace_back();
    for (const Property& p : kind.properties) {
        TrundleField field{};
        field.name = p.name.c_str();
        field.unit = p.unit.c_str();
        field.help = p.help.c_str();
        field.choices = "";
        field.scale = p.scale;
        field.minimum = p.minimum;
        field.maximum = p.maximum;
        field.type = static_cast<std::uint32_t>(p.type) + TRUNDLE_NUMBER;
        field.minCount = p.minCount;
        field.maxCount = p.maxCount;
        field.flags = p.live ? TRUNDLE_LIVE : 0;
        table.fields.push_back(field);
    }
    for (const SignalDescription& s : kind.signals)
        table.signals.push_back({s.name.c_str(), s.unit.c_str(), s.help.c_str(), s.type, s.count, s.direction, 0});
    TrundleKind& t = table.kind;
    t.size = sizeof t;
    t.role = kind.role == Role::Device ? TRUNDLE_DEVICE : TRUNDLE_CONTROLLER;
    t.name = kind.name.c_str();
    t.help = kind.help.c_str();
    t.fields = table.fields.data();
    t.signals = table.signals.data();
    t.fieldCount = static_cast<std::uint32_t>(table.fields.size());
    t.signalCount = static_cast<std::uint32_t>(table.signals.size());
    t.destroy = TableCalls::destroy;
    t.set = TableCalls::set;
    t.lastError = TableCalls::lastError;
    t.setupDevice = TableCalls::setup;
    t.act = TableCalls::act;
    t.sense = TableCalls::sense;
}

const TrundleKind* PythonDeviceHost::find(const std::string& kind) const {
    const auto found =
        std::ranges::find_if(m_tables, [&](const KindTable& t) { return t.kind.name == kind && t.kind.role == TRUNDLE_DEVICE; });
    return found == m_tables.end() ? nullptr : &found->kind;
}

void* PythonDeviceHost::create(const std::string& kind) {
    auto made = std::make_unique<PythonDevice>();
    made->host = this;
    made->kind = &*std::ranges::find(m_kinds, kind, &Kind::name);
    made->number = static_cast<std::uint32_t>(m_devices.size());
    m_devices.push_back(std::move(made));
    return m_devices.back().get();
}

bool PythonDeviceHost::set(PythonDevice& device, const Property& property, const TrundleValue& value) {
    PropertyValue given{property.type, {}, {}};
    const bool numeric = property.type <= PropertyType::Boolean;
    for (std::uint32_t i = 0; i < value.count; ++i)
        if (numeric) given.numbers.push_back(value.numbers[i]);
        else given.texts.emplace_back(value.texts[i]);
    if (!device.started) {
        device.values.emplace_back(property.name, std::move(given));
        return true;
    }
    std::string more;
    return request(device, HostRequest::Set, WireWriter().number(device.number).bytes(property.name).value(given).view(), more);
}

bool PythonDeviceHost::setup(PythonDevice& device, const TrundleMount& mount) {
    device.path = mount.path;
    for (const SignalDescription& s : device.kind->signals) {
        double* slots = mount.signal(mount.context, s.name.c_str());
        if (!slots) return false; // reported
        device.signals.emplace_back(slots, s.count);
    }
    WireWriter out;
    out.number(device.number).bytes(device.kind->name).bytes(device.path).number(mount.tick).number(m_seed);
    out.number<std::uint64_t>(device.values.size());
    for (const auto& [name, value] : device.values) out.bytes(name).value(value);
    device.calls.begin(&mount, nullptr);
    std::string more;
    device.started = request(device, HostRequest::StartDevice, out.view(), more);
    device.calls.begin(nullptr, nullptr);
    if (!device.started) return false;
    WireReader in(more);
    take(device, in);
    const std::string_view phases = in.bytes();
    device.acts = phases.size() > 0 && phases[0] != 0;
    device.senses = phases.size() > 1 && phases[1] != 0;
    device.values.clear();
    return true;
}

bool PythonDeviceHost::call(PythonDevice& device, HostRequest request, const TrundleServices& services) {
    const Supply supply = Services(services).supply();
    const auto tick = static_cast<std::uint64_t>(std::llround(services.time / services.tick));
    WireWriter out;
    out.number(device.number).number(tick).number(services.time);
    out.number<std::uint8_t>(supply.present).number(supply.voltage).number(supply.nominal);
    out.numbers(device.numbers()).numbers(device.calls.peers());
    device.calls.begin(nullptr, &services);
    std::string more;
    const bool done = this->request(device, request, out.view(), more);
    if (!done && !m_connection->alive() && services.print)
        for (const std::string& line : std::exchange(m_backtrace, {}))
            services.print(services.context, TRUNDLE_ERROR, line.c_str());
    device.calls.begin(nullptr, nullptr);
    if (!done) return false;
    WireReader in(more);
    take(device, in);
    return true;
}

/// What a call has changed.
void PythonDeviceHost::take(PythonDevice& device, WireReader& in) {
    device.setNumbers(in.numbers<double>());
    device.calls.setPeers(in.numbers<double>());
    device.idleUntil = in.number<double>();
}

void PythonDeviceHost::destroy(PythonDevice& device) {
    std::string more;
    if (device.started && m_connection->alive())
        (void)request(device, HostRequest::Stop, WireWriter().number(device.number).view(), more);
    m_devices[device.number].reset();
}

bool PythonDeviceHost::request(PythonDevice& device, HostRequest request, std::string_view bytes, std::string& more) {
    Status done = Error{Code::ControllerFailed, "the process of " + m_file + " has ended"};
    const bool wasAlive = m_connection->alive();
    const bool alive = wasAlive && m_connection->call(request, bytes, [&](HostRecord record, std::uint32_t, WireReader& in) {
        if (record == HostRecord::DeviceQuery || record == HostRecord::DeviceCommand) return device.calls.answer(in);
        if (record == HostRecord::Done) {
            done = in.status();
            more = in.text();
        }
        return std::string();
    });
    if (alive && done) return true;
    device.error = alive || !wasAlive ? done.error().message : faultOfEnd(device);
    return false;
}

/// Of the process, in a call of the device.
std::string PythonDeviceHost::faultOfEnd(const PythonDevice& device) {
    ControllerFault fault = faultOf(m_connection->end(), "the device " + device.kind->name, m_file);
    m_backtrace = std::move(fault.backtrace);
    return fault.reason;
}

} // namespace trundle
