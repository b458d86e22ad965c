#include "cli/interrupt.h"

#include <csignal>

#include <unistd.h>

#include "cli/exit_code.h"

namespace trundle {

namespace {

// A signal handler reaches nothing but a variable of its own.
volatile std::sig_atomic_t s_interrupts = 0;

void noteInterrupt(int) {
    if (s_interrupts) _exit(kExitInterrupted);
    s_interrupts = 1;
}

} // namespace

void watchInterrupts() {
    struct sigaction action = {};
    action.sa_handler = noteInterrupt;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr); // without SA_RESTART: a sleep of --realtime ends too
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return s_interrupts != 0; }

} // namespace trundle
