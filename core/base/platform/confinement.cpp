// Method: a filter of system calls (seccomp). Needs: Linux on x86-64 or AArch64.
#include "base/platform/confinement.h"

#include <cerrno>
#include <cstddef>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace trundle {
namespace {

#if defined(__x86_64__)
constexpr unsigned kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned kMachine = 0;
#endif

using Filter = std::vector<sock_filter>;

void add(Filter& filter, unsigned code, unsigned k, unsigned char ifTrue = 0, unsigned char ifFalse = 0) {
    filter.push_back({static_cast<unsigned short>(code), ifTrue, ifFalse, k});
}
void load(Filter& filter, std::size_t offset) { add(filter, BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset)); }
void loadNumber(Filter& filter) { load(filter, offsetof(seccomp_data, nr)); }
void loadFirstArgument(Filter& filter) { load(filter, offsetof(seccomp_data, args)); } // its low half

constexpr unsigned failing(int error) { return SECCOMP_RET_ERRNO | static_cast<unsigned>(error); }

void refuse(Filter& filter, long call, int error) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1);
    add(filter, BPF_RET | BPF_K, failing(error));
}

/// clone() makes threads only.
void refuseCopies(Filter& filter) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 4);
    loadFirstArgument(filter);
    add(filter, BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0);
    add(filter, BPF_RET | BPF_K, failing(EAGAIN));
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    refuse(filter, SYS_clone3, ENOSYS); // its flags cannot be read here; the C library uses clone() then
#if defined(SYS_fork)
    refuse(filter, SYS_fork, EAGAIN);
    refuse(filter, SYS_vfork, EAGAIN);
#endif
}

/// A signal call whose first argument is a process: its own one only.
void allowForOwn(Filter& filter, long call, unsigned own) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 4);
    loadFirstArgument(filter);
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, own, 1, 0);
    add(filter, BPF_RET | BPF_K, failing(EPERM));
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
}

/// prctl() may not keep the process alive after its parent.
void refuseParentSignal(Filter& filter) {
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, SYS_prctl, 0, 4);
    loadFirstArgument(filter);
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, PR_SET_PDEATHSIG, 0, 1);
    add(filter, BPF_RET | BPF_K, failing(EPERM));
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
}

} // namespace

std::string confinementFilter() {
    if (kMachine == 0) return {};
    const auto own = static_cast<unsigned>(::getpid());
    Filter filter;
    load(filter, offsetof(seccomp_data, arch));
    add(filter, BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0);
    add(filter, BPF_RET | BPF_K, failing(ENOSYS)); // calls of another machine, as of 32-bit code
    loadNumber(filter);
#if defined(__x86_64__)
    add(filter, BPF_JMP | BPF_JGE | BPF_K, 0x40000000u, 0, 1); // the same calls by other numbers (x32)
    add(filter, BPF_RET | BPF_K, failing(ENOSYS));
#endif
    refuseCopies(filter);
    for (const long call : {SYS_execve, SYS_execveat, SYS_ptrace, SYS_process_vm_writev, SYS_tkill, SYS_rt_sigqueueinfo,
                            SYS_rt_tgsigqueueinfo, SYS_pidfd_open, SYS_pidfd_send_signal, SYS_setsid, SYS_setpgid})
        refuse(filter, call, EPERM);
    for (const long call : {SYS_kill, SYS_tgkill}) allowForOwn(filter, call, own);
    refuseParentSignal(filter);
    add(filter, BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    return {reinterpret_cast<const char*>(filter.data()), filter.size() * sizeof(sock_filter)};
}

bool confineProcess() noexcept {
    std::string filter = confinementFilter();
    if (filter.empty()) return false;
    const sock_fprog program{static_cast<unsigned short>(filter.size() / sizeof(sock_filter)),
                             reinterpret_cast<sock_filter*>(filter.data())};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

} // namespace trundle
