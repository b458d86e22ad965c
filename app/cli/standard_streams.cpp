#include "cli/standard_streams.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/output_cleaner.h"
#include "base/platform/standard_descriptors.h"

namespace trundle {
namespace {

constexpr int kHigh = 100; // high enough to survive loops that close the first few descriptors

/// A saved descriptor and the file it referred to, to detect that module code has closed or replaced it.
struct SavedDescriptor {
    int file = -1;
    dev_t device = 0;
    ino_t inode = 0;

    bool leadsTo(int other) const {
        struct stat there {};
        return ::fstat(other, &there) == 0 && there.st_dev == device && there.st_ino == inode;
    }
    bool isWhole() const { return file >= 0 && leadsTo(file); }
    void keep(int standard) {
        const int high = ::fcntl(standard, F_DUPFD_CLOEXEC, kHigh);
        file = high >= 0 ? high : ::fcntl(standard, F_DUPFD_CLOEXEC, 3);
        struct stat there {};
        if (::fstat(file, &there) != 0) return;
        device = there.st_dev;
        inode = there.st_ino;
    }
};

// global, because signal handlers use them
SavedDescriptor s_savedResults, s_messages, s_modules; // s_modules: where the output of modules goes

} // namespace

void keepStandardStreams() {
    if (openStandardDescriptors()) s_savedResults.keep(STDOUT_FILENO);
    s_messages.keep(STDERR_FILENO);
    startOutputCleaner();
}

void redirectStandardOutput() {
    cleanStandardOutput();
    s_modules.keep(STDERR_FILENO);
}

void restoreStandardStreams() {
    std::fflush(stdout);
    (void)openIfClosed(STDIN_FILENO);
    if (!s_modules.isWhole() && s_modules.leadsTo(STDERR_FILENO)) s_modules.keep(STDERR_FILENO);
    const int target = s_modules.isWhole() ? s_modules.file : s_messages.isWhole() ? s_messages.file : -1;
    if (target < 0) return;
    if (!s_modules.leadsTo(STDERR_FILENO)) ::dup2(target, STDERR_FILENO);
    if (::fcntl(STDOUT_FILENO, F_GETFD) < 0) ::dup2(target, STDOUT_FILENO);
    std::clearerr(stdout);
    std::clearerr(stderr);
}

void writeMessage(std::string_view text) {
    waitForOutputCleaner();
    while (!text.empty()) {
        const ssize_t done = ::write(messagesFile(), text.data(), text.size());
        if (done < 0 && errno != EINTR) return;
        if (done > 0) text.remove_prefix(static_cast<std::size_t>(done));
    }
}

int resultsFile() { return s_savedResults.isWhole() ? s_savedResults.file : -1; }

int messagesFile() { return s_messages.isWhole() ? s_messages.file : STDERR_FILENO; }

} // namespace trundle
