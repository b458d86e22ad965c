// Needs: fork without SIGCHLD, so that a module that waits for all of its own child processes does not wait for this one.
// Method: a pipe to the other process; a page of memory shared with it counts the bytes it has taken and passed on.
#include "base/platform/output_cleaner.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clean_text.h"
#include "base/utf8.h"

namespace trundle {
namespace {

constexpr int kHigh = 100;          // as in standard_streams.cpp: survives loops that close the first few descriptors
constexpr int kHoldMs = 20;         // how long the beginning of a character waits for its rest
constexpr int kLongestWaitMs = 500; // without progress
constexpr int kLongestEndMs = 50;   // a process that a module has left behind may keep the pipe open

struct Progress {
    std::atomic<std::uint64_t> taken{0}, passed{0}; ///< bytes
    enum Step { Idle, Reading, Writing }; ///< Reading: what it has read is not counted yet
    std::atomic<int> step{Idle};
};

Progress* s_progress = nullptr;
int s_pipe = -1;   ///< our end
int s_errors = -1; ///< the original standard error
ino_t s_inode = 0;
pid_t s_owner = 0, s_cleaner = 0;

void writeAll(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::write(STDERR_FILENO, bytes.data(), bytes.size());
        if (done > 0) bytes.remove_prefix(static_cast<std::size_t>(done));
        else if (errno == EAGAIN) {
            pollfd wait{STDERR_FILENO, POLLOUT, 0};
            ::poll(&wait, 1, -1);
        } else if (errno != EINTR) return; // closed: drop the text, so that modules are not blocked
    }
}

/// Bytes at the end that may belong together with what follows: the beginning of a UTF-8 sequence, or a CR.
std::size_t unfinished(std::string_view text) {
    if (text.ends_with('\r')) return 1;
    for (std::size_t tail = 1; tail <= 3 && tail <= text.size(); ++tail) {
        const auto first = static_cast<unsigned char>(text[text.size() - tail]);
        if (first < 0x80) return 0;
        if (first >= 0xC0) return codePointAt(text, text.size() - tail).valid ? 0 : tail;
    }
    return 0;
}

/// Passes on what it reads until the last writer has closed.
void passOn(int from) {
    char bytes[16384];
    std::string text;
    for (;;) {
        pollfd wait{from, POLLIN, 0};
        if (::poll(&wait, 1, text.empty() ? -1 : kHoldMs) < 0) continue;
        const bool isComplete = wait.revents == 0;
        s_progress->step = Progress::Reading; // before the read, since waitForOutputCleaner() looks at the pipe first
        const ssize_t got = isComplete ? 0 : ::read(from, bytes, sizeof bytes);
        if (got < 0 && errno == EINTR) continue;
        if (got > 0) text.append(bytes, static_cast<std::size_t>(got));
        s_progress->taken += got > 0 ? static_cast<std::uint64_t>(got) : 0;
        s_progress->step = Progress::Writing;
        const std::size_t held = got > 0 ? unfinished(text) : 0;
        const std::size_t ready = text.size() - held;
        writeAll(cleanText(std::string_view(text).substr(0, ready)));
        text.erase(0, ready);
        s_progress->passed += ready;
        s_progress->step = held > 0 ? Progress::Writing : Progress::Idle;
        if (got <= 0 && !isComplete) return;
    }
}

/// In the child: standard error stays, the pipe becomes standard input, everything else is closed.
[[noreturn]] void becomeCleaner(int from) {
    for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGPIPE, SIGTTOU})
        std::signal(signal, SIG_IGN); // ends with its writers
    ::prctl(PR_SET_NAME, "trundle-output");
    const bool ready = ::dup2(from, STDIN_FILENO) == STDIN_FILENO && ::close(STDOUT_FILENO) == 0 && ::chdir("/") == 0;
    ::syscall(SYS_close_range, 3u, ~0u, 0u);
    if (ready) passOn(STDIN_FILENO);
    for (;;) ::syscall(SYS_exit_group, 0);
}

bool leadsToPipe(int file) {
    struct stat there {};
    return ::fstat(file, &there) == 0 && S_ISFIFO(there.st_mode) && there.st_ino == s_inode;
}

/// A descriptor of the pipe; -1: modules have closed them all.
int openEnd() {
    for (const int file : {s_pipe, STDERR_FILENO, STDOUT_FILENO})
        if (leadsToPipe(file)) return file;
    return -1;
}

int lifted(int file) {
    const int high = ::fcntl(file, F_DUPFD_CLOEXEC, kHigh);
    if (high < 0) return file;
    ::close(file);
    return high;
}

void flushAtExit() {
    std::fflush(stdout);
    finishOutputCleaner();
}

void pauseMs() {
    const timespec pause{0, 1'000'000};
    ::nanosleep(&pause, nullptr);
}

} // namespace

void startOutputCleaner() {
    int ends[2];
    void* const page = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED || ::pipe2(ends, O_CLOEXEC) != 0) return;
    s_progress = new (page) Progress;
    const long child = ::syscall(SYS_clone, 0, nullptr, nullptr, nullptr, nullptr);
    if (child == 0) becomeCleaner(ends[0]);
    ::close(ends[0]);
    struct stat there {};
    if (child < 0 || ::fstat(ends[1], &there) != 0) {
        ::close(ends[1]);
        return;
    }
    s_inode = there.st_ino;
    s_pipe = lifted(ends[1]);
    s_errors = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, kHigh);
    s_owner = ::getpid();
    s_cleaner = static_cast<pid_t>(child);
}

void cleanStandardOutput() {
    std::fflush(stdout);
    if (s_pipe < 0 || ::dup2(s_pipe, STDERR_FILENO) < 0) {
        ::dup2(STDERR_FILENO, STDOUT_FILENO);
        return;
    }
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // in order with standard error, and complete before a crash
    static const int s_atExit = std::atexit(&flushAtExit);
    (void)s_atExit;
}

void waitForOutputCleaner() noexcept {
    const int before = errno;
    const int file = s_pipe < 0 ? -1 : openEnd();
    std::uint64_t target = 0, passed = 0;
    for (int quietMs = 0, first = 1; file >= 0 && quietMs < kLongestWaitMs;) {
        int waiting = 0;
        pollfd end{file, POLLOUT, 0};
        if (::ioctl(file, FIONREAD, &waiting) != 0 || (::poll(&end, 1, 0) > 0 && end.revents & (POLLERR | POLLNVAL))) break;
        const int step = s_progress->step;
        if (waiting == 0 && step == Progress::Idle) break;
        if (first && step != Progress::Reading) {
            target = s_progress->taken + static_cast<std::uint64_t>(waiting); // later text is not waited for
            first = 0;
        }
        const std::uint64_t now = s_progress->passed;
        if (!first && now >= target) break;
        quietMs = now == passed ? quietMs + 1 : 0;
        passed = now;
        pauseMs();
    }
    errno = before;
}

void finishOutputCleaner() noexcept {
    if (s_cleaner == 0 || ::getpid() != s_owner) return; // a copy made by fork()
    waitForOutputCleaner();
    for (const int file : {STDERR_FILENO, STDOUT_FILENO})
        if (leadsToPipe(file) && ::dup2(s_errors, file) < 0) ::close(file);
    for (int file = 0; file < 2 * kHigh; ++file) // ours and copies: while any is open, the other process waits for text
        if (leadsToPipe(file)) ::close(file);
    for (int ms = 0; ms < kLongestEndMs && ::waitpid(s_cleaner, nullptr, WNOHANG | __WCLONE) == 0; ++ms) pauseMs();
    s_cleaner = 0;
}

} // namespace trundle
