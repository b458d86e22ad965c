#include "base/platform/process_identity.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>

#include <signal.h>
#include <unistd.h>

namespace trundle {
namespace {

// Field 22 of /proc/PID/stat. The name of the program, field 2, stands in brackets and may hold blanks and brackets.
std::uint64_t startOf(std::int64_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string line;
    if (!std::getline(file, line)) return 0;
    const std::size_t bracket = line.rfind(')');
    if (bracket == std::string::npos) return 0;
    std::istringstream rest(line.substr(bracket + 1));
    std::string field;
    for (int number = 3; number <= 22; ++number)
        if (!(rest >> field)) return 0;
    return std::strtoull(field.c_str(), nullptr, 10);
}

std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

} // namespace

ProcessIdentity thisProcess() { return {::getpid(), startOf(::getpid()), hostName()}; }

bool mayBeAlive(const ProcessIdentity& process) {
    if (process.host != hostName()) return true;
    if (process.pid <= 0) return false;
    if (::kill(static_cast<pid_t>(process.pid), 0) != 0 && errno == ESRCH) return false;
    const std::uint64_t start = startOf(process.pid);
    return start == 0 || process.start == 0 || start == process.start;
}

} // namespace trundle
