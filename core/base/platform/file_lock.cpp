#include "base/platform/file_lock.h"

#include <cerrno>
#include <filesystem>
#include <set>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trundle {
namespace {

constexpr int kNothingThere = -1, kBusy = -2;
constexpr std::chrono::milliseconds kPause(2);

int openForLock(const std::string& path) {
    const int flags = O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
    const int file = ::open(path.c_str(), O_RDWR | flags); // read-write, as locks on network file systems require
    return file >= 0 ? file : ::open(path.c_str(), O_RDONLY | flags);
}

/// False if the file was replaced between opening and locking.
bool isAt(int file, const std::string& path) {
    struct stat held {
    }, there{};
    return ::fstat(file, &held) == 0 && ::stat(path.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
           held.st_ino == there.st_ino;
}

} // namespace

/// Returns a descriptor, kNothingThere or kBusy.
int FileLock::openLocked(const std::string& path, std::chrono::steady_clock::time_point until) {
    for (;;) {
        const int file = openForLock(path);
        if (file < 0) return kNothingThere;
        const int done = ::flock(file, LOCK_EX | LOCK_NB);
        const bool taken = done == 0 || (errno != EWOULDBLOCK && errno != EINTR);
        if (taken && isAt(file, path)) return file;
        ::close(file);
        if (std::chrono::steady_clock::now() >= until) return kBusy;
        if (!taken) std::this_thread::sleep_for(kPause);
    }
}

Result<std::vector<FileLock>> FileLock::takeAll(const std::vector<std::string>& paths, std::chrono::milliseconds atMost) {
    const auto until = std::chrono::steady_clock::now() + atMost;
    std::set<std::string> ordered;
    std::error_code none;
    for (const std::string& path : paths) ordered.insert(std::filesystem::weakly_canonical(path, none).string());
    std::vector<FileLock> locks;
    for (const std::string& path : ordered) {
        const int file = openLocked(path, until);
        if (file == kBusy) return Error{Code::FileUnwritable, path + " is being changed by another program; try again"};
        if (file >= 0) locks.push_back(FileLock(file));
    }
    return locks;
}

FileLock::FileLock(FileLock&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(m_file, other.m_file);
    return *this;
}

FileLock::~FileLock() {
    if (m_file >= 0) ::close(m_file);
}

} // namespace trundle
