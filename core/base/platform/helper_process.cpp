#include "base/platform/helper_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace trundle {
namespace {

constexpr int kFirstDescriptor = 3, kAboveAll = 64;

} // namespace

Result<HelperProcess> HelperProcess::start(const std::string& program, const std::vector<int>& descriptors,
                                           const std::vector<std::string>& more) {
    std::string own = std::to_string(::getpid());
    std::vector<char*> words{const_cast<char*>(program.c_str()), own.data()};
    for (const std::string& word : more) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0); // it reads none of the user's input
    std::vector<int> lifted; // out of the way of the numbers that the child uses
    for (const int file : descriptors) lifted.push_back(::fcntl(file, F_DUPFD_CLOEXEC, kAboveAll));
    for (std::size_t i = 0; i < lifted.size(); ++i)
        posix_spawn_file_actions_adddup2(&files, lifted[i], kFirstDescriptor + static_cast<int>(i));
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    HelperProcess made;
    const int failed = ::posix_spawn(&made.m_process, program.c_str(), &files, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    for (const int file : lifted)
        if (file >= 0) ::close(file);
    if (!failed) return made;
    made.m_process = 0;
    return Error{Code::SystemRefused, "cannot run " + program + ": " + std::strerror(failed)};
}

HelperProcess& HelperProcess::operator=(HelperProcess&& other) noexcept {
    std::swap(m_process, other.m_process);
    std::swap(m_exit, other.m_exit);
    return *this;
}

void HelperProcess::record(int status) {
    m_exit = {WIFSIGNALED(status), WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status)};
    m_process = 0;
}

bool HelperProcess::hasEnded() {
    if (m_process <= 0) return true;
    int status = 0;
    const pid_t got = ::waitpid(m_process, &status, WNOHANG);
    if (got == m_process && (WIFEXITED(status) || WIFSIGNALED(status))) record(status); // a traced child reports its stops too
    else if (got < 0 && errno == ECHILD) record(0); // another part of the program has waited for it
    return m_process <= 0;
}

void HelperProcess::signalMainThread(int signal) {
    if (!hasEnded()) ::syscall(SYS_tgkill, m_process, m_process, signal);
}

void HelperProcess::kill() {
    if (hasEnded()) return;
    ::kill(-m_process, SIGKILL);
    ::kill(m_process, SIGKILL);
    int status = 0;
    for (;;) {
        const pid_t got = ::waitpid(m_process, &status, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return record(SIGKILL);
        if (WIFEXITED(status) || WIFSIGNALED(status)) return record(status);
    }
}

void HelperProcess::send(int signal) const {
    if (m_process > 0) ::kill(m_process, signal);
}

bool HelperProcess::isTraced() const {
    std::ifstream status("/proc/" + std::to_string(m_process) + "/status");
    std::string word;
    while (status >> word) {
        long tracer = 0;
        if (word == "TracerPid:" && status >> tracer) return tracer != 0 && tracer != ::getpid();
    }
    return false;
}

bool HelperProcess::receives(int signal) const {
    std::ifstream status("/proc/" + std::to_string(m_process) + "/status");
    std::string word, digits;
    while (status >> word)
        if ((word == "SigBlk:" || word == "SigIgn:") && status >> digits)
            if ((std::strtoull(digits.c_str(), nullptr, 16) >> (signal - 1) & 1) != 0) return false;
    return true;
}

bool endWithParent(int parent) { return ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && ::getppid() == parent; }

} // namespace trundle
