// Method: Python gets the places of the parts of the control page and the filter of system calls as arguments: they are in C++ alone.
#include "host/python_start.h"

#include <cstddef>
#include <cstdlib>
#include <utility>

#include <unistd.h>

#include "base/platform/confinement.h"
#include "control/host/control_page.h"

namespace trundle {
namespace {

std::string layout() {
    const std::pair<const char*, std::size_t> offsets[] = {
        {"turn", offsetof(ControlPage, turn)},     {"hostSleeps", offsetof(ControlPage, hostSleeps)},
        {"phase", offsetof(ControlPage, phase)},   {"controller", offsetof(ControlPage, controller)},
        {"toHost", offsetof(ControlPage, toHost)}, {"toRun", offsetof(ControlPage, toRun)},
        {"report", offsetof(ControlPage, report)}, {"exception", offsetof(ControlPage, crash) + offsetof(CrashRecord, exception)},
        {"mailSize", offsetof(Mailbox, size)},     {"mailMore", offsetof(Mailbox, more)},
        {"mailBytes", offsetof(Mailbox, bytes)}};
    std::string text;
    for (const auto& [name, offset] : offsets) text += (text.empty() ? "" : ",") + std::string(name) + "=" + std::to_string(offset);
    return text;
}

std::string hex(const std::string& bytes) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) {
        text += kDigits[static_cast<unsigned char>(c) >> 4];
        text += kDigits[static_cast<unsigned char>(c) & 15];
    }
    return text;
}

} // namespace

void startPython(const std::string& folder) {
    const std::string script = folder + "/run_controllers.py", offsets = layout(), filter = hex(confinementFilter());
    ::setenv("PYTHONHASHSEED", "0", 1); // the order of sets must not differ between runs
    ::execlp("python3", "python3", "-B", "-X", "utf8", script.c_str(), offsets.c_str(), filter.c_str(), nullptr);
}

} // namespace trundle
