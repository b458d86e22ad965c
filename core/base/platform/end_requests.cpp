#include "base/platform/end_requests.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <thread>

#include <semaphore.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/platform/buffered_file.h"

namespace trundle {
namespace {

// Global, because signal handlers receive no arguments of ours.
std::atomic<int> s_request{0};
sem_t s_asked;

/// Not _exit(), which the programs define to report it.
void end(int code) { syscall(SYS_exit_group, code); }

void onSignal(int signal) {
    const int before = errno;
    if (s_request.exchange(signal) != 0) {
        BufferedFile::writeOutAll();
        end(128 + signal);
    }
    sem_post(&s_asked);
    errno = before;
}

void watchEnd(const std::function<void(int)>& onRequest, std::chrono::seconds timeout) {
    while (sem_wait(&s_asked) != 0 && errno == EINTR) {}
    const int exitCode = 128 + s_request;
    onRequest(exitCode);
    std::this_thread::sleep_for(timeout);
    BufferedFile::writeOutAll();
    end(exitCode);
}

void handle(int signal) {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

/// Replaces no handler of a library, such as that of its own timer.
void handleOther(int signal) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) handle(signal);
}

} // namespace

void forOtherEndSignals(void (*change)(int signal)) {
    for (const int signal : {SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGXCPU, SIGIO, SIGPWR, SIGSTKFLT}) change(signal);
    for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) change(signal);
}

void watchEndRequests(std::function<void(int exitCode)> onRequest, std::chrono::seconds timeout) {
    sem_init(&s_asked, 0, 0);
    std::thread([onRequest = std::move(onRequest), timeout] { watchEnd(onRequest, timeout); }).detach();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_IGN) handle(signal);
    }
    forOtherEndSignals(handleOther);
}

} // namespace trundle
