#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <trundle/abi.h>

#include "base/call_monitor.h"
#include "control/host/host_connection.h"
#include "schema/kind.h"

namespace trundle {

class PythonDeviceHost;

/// The devices of a run whose code is in Python: one host process for each file. Must outlive the devices.
class PythonDevices {
public:
    PythonDevices(HostPrograms programs, std::uint64_t seed, std::shared_ptr<CallMonitor> calls);
    ~PythonDevices();

    /// Starts a process for a file and loads it. Returns its kinds.
    [[nodiscard]] Result<std::vector<Kind>> load(const std::string& file);
    /// The function table of a kind of a loaded file; nullptr: none has it. Its `create` is null: use create().
    [[nodiscard]] const TrundleKind* find(const std::string& kind) const;
    /// A new instance of that kind, for its table.
    [[nodiscard]] void* create(const std::string& kind);

private:
    HostPrograms m_programs;
    std::uint64_t m_seed;
    std::shared_ptr<CallMonitor> m_calls;
    std::map<std::string, std::unique_ptr<PythonDeviceHost>> m_hosts; ///< by file
};

} // namespace trundle
