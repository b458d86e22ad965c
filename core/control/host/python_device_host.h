#pragma once
// Method: each act and sense is one message to the host and back, with the numbers of the device's signals; what the device asks meanwhile
// are messages in between.

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <trundle/kind_table.h>

#include "control/host/device_calls.h"
#include "control/host/host_connection.h"
#include "schema/kind.h"

namespace trundle {

class PythonDeviceHost;

/// A device of one robot, behind the handle of its function table.
struct PythonDevice {
    PythonDeviceHost* host = nullptr;
    const Kind* kind = nullptr;
    std::uint32_t number = 0;
    std::string path, error;
    std::vector<std::pair<std::string, PropertyValue>> values; ///< of its fields, until it is started
    std::vector<std::pair<double*, std::uint32_t>> signals;    ///< slots and counts, in the order of the kind
    DeviceCalls calls;
    bool started = false, acts = false, senses = false;
    double idleUntil = 0; ///< s: no sense is needed before

    /// All numbers of its signals.
    [[nodiscard]] std::vector<double> numbers() const;
    void setNumbers(const std::vector<double>& values);
};

/// The host process of a Python file and its devices.
class PythonDeviceHost {
public:
    PythonDeviceHost(std::unique_ptr<HostConnection> connection, std::string file, std::uint64_t seed);
    ~PythonDeviceHost();
    PythonDeviceHost(const PythonDeviceHost&) = delete;
    PythonDeviceHost& operator=(const PythonDeviceHost&) = delete;

    [[nodiscard]] Result<std::vector<Kind>> load();
    [[nodiscard]] const TrundleKind* find(const std::string& kind) const;
    [[nodiscard]] void* create(const std::string& kind);

    // The functions of the tables: true on success, otherwise the device has an error.
    [[nodiscard]] bool set(PythonDevice& device, const Property& property, const TrundleValue& value);
    [[nodiscard]] bool setup(PythonDevice& device, const TrundleMount& mount);
    [[nodiscard]] bool call(PythonDevice& device, HostRequest request, const TrundleServices& services);
    void destroy(PythonDevice& device);

private:
    void addTable(const Kind& kind);
    [[nodiscard]] bool request(PythonDevice& device, HostRequest request, std::string_view bytes, std::string& more);
    static void take(PythonDevice& device, WireReader& in);
    [[nodiscard]] std::string faultOfEnd(const PythonDevice& device);

    std::string m_file;
    std::uint64_t m_seed;
    std::unique_ptr<HostConnection> m_connection;
    std::vector<Kind> m_kinds;
    std::deque<KindTable> m_tables;                       ///< in their order; a table must not move
    std::vector<std::unique_ptr<PythonDevice>> m_devices; ///< by number
    std::vector<std::string> m_backtrace;                 ///< of the end of the process, until it is printed
};

} // namespace trundle
