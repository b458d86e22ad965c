#include "base/platform/piped_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace trundle {

bool isInstalled(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
    for (rest += ':'; !rest.empty();) {
        const std::size_t end = rest.find(':');
        const std::string folder = rest.substr(0, end);
        if (!folder.empty() && ::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
        rest.erase(0, end + 1);
    }
    return false;
}

Result<std::unique_ptr<PipedProcess>> PipedProcess::start(const std::string& program, const std::vector<std::string>& arguments,
                                                          int file) {
    std::unique_ptr<PipedProcess> made(new PipedProcess);
    // A socket instead of a pipe: writing after the reader has closed is an error, not SIGPIPE.
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return Error{Code::SystemRefused, std::strerror(errno)};
    made->m_input = ends[0];
    made->m_words = ::memfd_create("words", MFD_CLOEXEC);

    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (made->m_words >= 0) posix_spawn_file_actions_adddup2(&files, made->m_words, STDERR_FILENO);
    if (file >= 0) posix_spawn_file_actions_adddup2(&files, file, 3); // last, because descriptor 3 may be one of the others
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = ::posix_spawnp(&made->m_process, program.c_str(), &files, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    ::close(ends[1]);
    if (!failed) return made;
    made->m_process = 0;
    return Error{Code::SystemRefused, "cannot run " + program + ": " + std::strerror(failed)};
}

PipedProcess::~PipedProcess() {
    if (m_input >= 0) ::close(m_input);
    if (m_words >= 0) ::close(m_words);
    if (m_process <= 0) return;
    ::kill(m_process, SIGTERM);
    while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {}
}

bool PipedProcess::feed(const void* bytes, std::size_t size) {
    const auto* rest = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t taken = m_input >= 0 ? ::send(m_input, rest, size, MSG_NOSIGNAL) : -1;
        if (taken < 0 && m_input >= 0 && errno == EINTR) continue;
        if (taken <= 0) return false;
        rest += taken;
        size -= static_cast<std::size_t>(taken);
    }
    return true;
}

bool PipedProcess::finish() {
    if (m_input >= 0) ::close(m_input);
    m_input = -1;
    int status = -1; // not known
    while (m_process > 0 && ::waitpid(m_process, &status, 0) < 0 && errno == EINTR) {}
    m_process = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string PipedProcess::lastErrorOutput() const {
    char text[2000];
    const ssize_t size = m_words >= 0 ? ::pread(m_words, text, sizeof text, 0) : 0;
    std::string words(text, size > 0 ? static_cast<std::size_t>(size) : 0);
    while (!words.empty() && words.back() == '\n') words.pop_back();
    return words.substr(words.rfind('\n') + 1);
}

} // namespace trundle
