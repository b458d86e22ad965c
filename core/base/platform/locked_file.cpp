#include "base/platform/locked_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/file_descriptor.h"

namespace trundle {
namespace {

Error cannot(const std::string& path, int why) {
    return Error{Code::FileUnwritable, "cannot write " + path + ": " + std::strerror(why)};
}

/// False if another owner holds the lock. A file system without locks reports another error, which counts as success.
bool lock(int file) {
    int done = 0;
    do done = ::flock(file, LOCK_EX | LOCK_NB);
    while (done != 0 && errno == EINTR);
    return done == 0 || errno != EWOULDBLOCK;
}

/// False if the file was removed or replaced between opening and locking.
bool isAtPath(int file, const std::string& path) {
    struct stat held {
    }, there{};
    return ::fstat(file, &held) == 0 && ::lstat(path.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
           held.st_ino == there.st_ino;
}

} // namespace

Result<std::optional<LockedFile>> LockedFile::take(const std::string& path) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        LockedFile opened(::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK, 0666), path);
        if (opened.m_file < 0) return cannot(path, errno);
        struct stat kind {};
        if (::fstat(opened.m_file, &kind) != 0 || !S_ISREG(kind.st_mode)) return cannot(path, EINVAL);
        if (kind.st_nlink > 1) return cannot(path, EMLINK); // writing would change the content of another name too
        if (!lock(opened.m_file)) return std::optional<LockedFile>();
        if (isAtPath(opened.m_file, path)) return std::optional<LockedFile>(std::move(opened));
    }
    return cannot(path, EBUSY);
}

Result<LockedFile> LockedFile::make(const std::string& path) {
    LockedFile made(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600), path);
    if (made.m_file < 0) return cannot(path, errno);
    (void)lock(made.m_file); // cannot fail: no other process has the name yet
    return made;
}

bool LockedFile::isHeld(const std::string& path) {
    const LockedFile file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK), path);
    return file.m_file >= 0 && !lock(file.m_file);
}

LockedFile::LockedFile(LockedFile&& other) noexcept : m_file(std::exchange(other.m_file, -1)), m_path(std::move(other.m_path)) {}

LockedFile& LockedFile::operator=(LockedFile&& other) noexcept {
    if (this == &other) return *this;
    close();
    m_file = std::exchange(other.m_file, -1);
    m_path = std::move(other.m_path);
    return *this;
}

Error LockedFile::failure(int why) const { return cannot(m_path, why); }

Status LockedFile::append(std::span<const std::string_view> pieces) {
    const off_t end = ::lseek(m_file, 0, SEEK_END);
    if (end < 0) return failure(errno);
    if (std::ranges::all_of(pieces, [this](std::string_view piece) { return writeAll(m_file, piece); })) return {};
    const int why = errno;
    if (::ftruncate(m_file, end) != 0) return failure(errno);
    return failure(why);
}

Status LockedFile::rewrite(std::string_view bytes) {
    if (::ftruncate(m_file, 0) != 0 || ::lseek(m_file, 0, SEEK_SET) < 0 || !writeAll(m_file, bytes)) return failure(errno);
    return {};
}

Status LockedFile::sync() const {
    if (::fdatasync(m_file) != 0) return failure(errno);
    return {};
}

Status LockedFile::renameTo(const std::string& path) {
    if (::rename(m_path.c_str(), path.c_str()) != 0) return failure(errno);
    m_path = path;
    return {};
}

void LockedFile::close() {
    if (m_file >= 0) ::close(std::exchange(m_file, -1));
}

void LockedFile::unlink() {
    if (m_file >= 0 && isAtPath(m_file, m_path)) ::unlink(m_path.c_str());
}

void LockedFile::remove() {
    unlink();
    close();
}

} // namespace trundle
