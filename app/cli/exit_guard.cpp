#include "cli/exit_guard.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "cli/exit_code.h"
#include "cli/messages.h"

namespace trundle {

namespace {

constexpr int kCrashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Handlers of the system take no arguments of ours.
bool s_guarded = false;
alignas(16) char s_stack[64 * 1024]; // a crash may be an endless recursion

void atExit() {
    if (!s_guarded) return;
    printProblem("code of a module ended the program in the middle of the run; its logs are not complete");
    std::fflush(nullptr);
    _exit(kExitController);
}

/// Only says what happened; returning meets the default action, as if nobody had watched.
void onCrash(int signal) {
    static constexpr char kText[] = "\ntrundle-cli: crashed in the middle of the run, in the code of a module or in the program "
                                    "itself; its logs are not complete\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kText, sizeof kText - 1);
    raise(signal);
}

/// Where nobody else does, a debugger's or sanitizer's runtime say.
void watchCrashes() {
    const stack_t stack{s_stack, 0, sizeof s_stack};
    sigaltstack(&stack, nullptr);
    for (const int signal : kCrashes) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
        struct sigaction ours = {};
        ours.sa_handler = onCrash;
        ours.sa_flags = SA_RESETHAND | SA_ONSTACK;
        sigemptyset(&ours.sa_mask);
        sigaction(signal, &ours, nullptr);
    }
}

void unwatchCrashes() {
    for (const int signal : kCrashes) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == onCrash) std::signal(signal, SIG_DFL);
    }
}

} // namespace

ExitGuard::ExitGuard() {
    static const bool s_registered = std::atexit(&atExit) == 0;
    s_guarded = s_registered;
    watchCrashes();
}

ExitGuard::~ExitGuard() {
    s_guarded = false;
    unwatchCrashes();
}

} // namespace trundle
