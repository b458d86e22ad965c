#include "base/platform/process_identity.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>

#include <signal.h>
#include <unistd.h>

namespace trundle {
namespace {

// Fields 3 and 22 of /proc/PID/stat. Field 2, the program name, is in parentheses and may contain spaces and parentheses.
struct Stat {
    char state = 0;
    std::uint64_t start = 0;
};

Stat statOf(std::int64_t pid) {
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string line;
    if (!std::getline(file, line)) return {};
    const std::size_t bracket = line.rfind(')');
    if (bracket == std::string::npos) return {};
    std::istringstream rest(line.substr(bracket + 1));
    Stat stat;
    if (!(rest >> stat.state)) return {};
    std::string field;
    for (int number = 4; number <= 22; ++number)
        if (!(rest >> field)) return stat;
    stat.start = std::strtoull(field.c_str(), nullptr, 10);
    return stat;
}

std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

} // namespace

ProcessIdentity thisProcess() { return {::getpid(), statOf(::getpid()).start, hostName()}; }

bool isPossiblyAlive(const ProcessIdentity& process) {
    if (process.host != hostName()) return true;
    if (process.pid <= 0) return false;
    if (::kill(static_cast<pid_t>(process.pid), 0) != 0 && errno == ESRCH) return false;
    const Stat now = statOf(process.pid);
    if (now.state == 'Z' || now.state == 'X') return false; // it has ended, but its parent has not waited for it
    return now.start == 0 || process.start == 0 || now.start == process.start;
}

} // namespace trundle
