#include "control/host/python_devices.h"

#include <algorithm>

#include "control/host/python_device_host.h"

namespace trundle {
namespace {

constexpr double kLongestCallS = 10, kLongestEndS = 3;

} // namespace

PythonDevices::PythonDevices(HostPrograms programs, std::uint64_t seed, std::shared_ptr<CallMonitor> calls)
    : m_programs(std::move(programs)), m_seed(seed), m_calls(std::move(calls)) {}
PythonDevices::~PythonDevices() = default;

Result<std::vector<Kind>> PythonDevices::load(const std::string& file) {
    HostConnection::Watch watch;
    watch.limits = [](const HostCall& call) {
        return call.phase == HostPhase::Destructor || call.phase == HostPhase::Unload ? kLongestEndS : kLongestCallS;
    };
    watch.waiting = [](const HostCall&, double) {}; // the world names the device
    watch.endAsked = [calls = m_calls] { return calls->endAsked(); };
    auto connection = HostConnection::start(m_programs, file, 0, std::move(watch));
    if (!connection) return connection.error();
    auto host = std::make_unique<PythonDeviceHost>(std::move(connection).value(), file, m_seed);
    Result<std::vector<Kind>> kinds = host->load();
    if (kinds) m_hosts.insert_or_assign(file, std::move(host));
    return kinds;
}

const TrundleKind* PythonDevices::find(const std::string& kind) const {
    for (const auto& [file, host] : m_hosts)
        if (const TrundleKind* found = host->find(kind)) return found;
    return nullptr;
}

void* PythonDevices::create(const std::string& kind) {
    for (const auto& [file, host] : m_hosts)
        if (host->find(kind)) return host->create(kind);
    return nullptr;
}

} // namespace trundle
