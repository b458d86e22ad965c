#include "base/platform/crash_name.h"

#include <csignal>

namespace trundle {

const char* crashName(int signal) noexcept {
    switch (signal) {
    case SIGSEGV: return "Segmentation fault";
    case SIGBUS: return "Bus error";
    case SIGFPE: return "Arithmetic exception";
    case SIGILL: return "Illegal instruction";
    case SIGABRT: return "Aborted";
    case SIGTRAP: return "Trap";
    case SIGSYS: return "Bad system call";
    default: return nullptr;
    }
}

} // namespace trundle
