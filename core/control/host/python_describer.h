#pragma once
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "control/host/host_connection.h"
#include "schema/kind.h"

namespace trundle {

/// Describes Python files: loads them in a process with the limits of a host, and remembers what was found until they change.
class PythonDescriber {
public:
    explicit PythonDescriber(HostPrograms programs) : m_programs(std::move(programs)) {}

    /// The kinds of a file. Its code runs, in another process, unless the cache has its description. Thread-safe. Fails with E414.
    [[nodiscard]] Result<std::vector<Kind>> kinds(const std::string& file);

private:
    [[nodiscard]] Result<std::vector<Kind>> describe(const std::string& file);

    const HostPrograms m_programs;
    std::mutex m_mutex;
    /// Files whose loading did not end, with their times: they are not loaded again before they change.
    std::map<std::string, std::pair<std::int64_t, Error>> m_endless;
};

} // namespace trundle
