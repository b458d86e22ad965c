#include "base/platform/folder_handle.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/file_descriptor.h"

namespace trundle {
namespace {

// O_PATH: write permission is enough, read permission is not needed.
constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;

Error refused(const std::string& why) { return Error{Code::FileUnwritable, why}; }
Error refused(int why) { return refused(std::strerror(why)); }

/// Why a name is refused: it exists with another file type than `wanted` (S_IFREG, S_IFDIR).
Error occupied(mode_t mode, mode_t wanted) {
    if (S_ISLNK(mode)) return refused("it is a symbolic link, which could lead to another place");
    if (wanted == S_IFDIR) return refused("it is not a folder");
    const char* const kind = kindRefused(mode);
    return refused(kind ? kind : "it is taken");
}

bool isOnePart(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos &&
           name.find('\0') == std::string::npos;
}

} // namespace

FolderHandle::FolderHandle(FolderHandle&& other) noexcept
    : m_folder(std::exchange(other.m_folder, -1)), m_lock(std::exchange(other.m_lock, -1)) {}

FolderHandle& FolderHandle::operator=(FolderHandle&& other) noexcept {
    std::swap(m_folder, other.m_folder);
    std::swap(m_lock, other.m_lock);
    return *this;
}

FolderHandle::~FolderHandle() {
    if (m_folder >= 0) ::close(m_folder);
    if (m_lock >= 0) ::close(m_lock);
}

bool FolderHandle::lock() {
    const int file = ::openat(m_folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return true; // a folder that may not be read
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(file);
        return false;
    }
    m_lock = file;
    return true;
}

Result<FolderHandle> FolderHandle::open(const std::string& path) {
    const int folder = ::open(path.c_str(), kFolder);
    if (folder < 0) return errno == ENOTDIR ? refused("it is not a folder") : refused(errno);
    return FolderHandle(folder);
}

Result<FolderHandle> FolderHandle::make(const std::string& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    Result<FolderHandle> opened = open(path);
    if (!opened && failed) return refused(failed.message());
    return opened;
}

Result<FolderHandle> FolderHandle::openFolder(const std::string& name) const {
    if (!isOnePart(name)) return refused(EINVAL);
    const int folder = ::openat(m_folder, name.c_str(), kFolder | O_NOFOLLOW);
    if (folder >= 0) return FolderHandle(folder);
    const int why = errno;
    struct stat there {};
    if (::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISDIR(there.st_mode))
        return occupied(there.st_mode, S_IFDIR);
    return refused(why);
}

Result<FolderHandle> FolderHandle::makeFolder(const std::string& name) const {
    if (!isOnePart(name)) return refused(EINVAL);
    if (::mkdirat(m_folder, name.c_str(), 0777) != 0 && errno != EEXIST) {
        const int why = errno;
        Result<FolderHandle> opened = openFolder(name);
        if (!opened && why != ENOENT) return refused(why);
        return opened;
    }
    return openFolder(name);
}

Result<std::FILE*> FolderHandle::makeFile(const std::string& name) const {
    if (!isOnePart(name)) return refused(EINVAL);
    struct stat there {};
    if (::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0) {
        if (!S_ISREG(there.st_mode)) return occupied(there.st_mode, S_IFREG);
        if (::unlinkat(m_folder, name.c_str(), 0) != 0) return refused(errno);
    }
    // If the name exists again by now, it is neither opened nor followed.
    const int file = ::openat(m_folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0) return refused(errno);
    if (std::FILE* stream = ::fdopen(file, "wb")) return stream;
    const int why = errno;
    ::close(file);
    return refused(why);
}

Result<std::string> FolderHandle::readFile(const std::string& name, std::uint64_t mostBytes) const {
    if (!isOnePart(name)) return refused(EINVAL);
    // Checked before opening, because opening a device can have side effects, and after, because the file may have been replaced.
    struct stat there {};
    if (::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) != 0) return refused(errno);
    if (!S_ISREG(there.st_mode)) return occupied(there.st_mode, S_IFREG);
    const FileDescriptor open(::openat(m_folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (open.file < 0 || ::fstat(open.file, &there) != 0) return refused(errno);
    if (!S_ISREG(there.st_mode)) return occupied(there.st_mode, S_IFREG);
    return readAll(open, mostBytes);
}

bool FolderHandle::hasFile(const std::string& name) const {
    struct stat there {};
    return isOnePart(name) && ::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(there.st_mode);
}

bool FolderHandle::hasOwnFile(const std::string& name) const {
    struct stat there {};
    return isOnePart(name) && ::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(there.st_mode) &&
           there.st_uid == ::geteuid() && (there.st_mode & (S_IWGRP | S_IWOTH)) == 0;
}

bool FolderHandle::removeFile(const std::string& name) const {
    return hasFile(name) && ::unlinkat(m_folder, name.c_str(), 0) == 0;
}

Status FolderHandle::rename(const std::string& from, const std::string& to) const {
    if (!isOnePart(from) || !isOnePart(to)) return refused(EINVAL);
    if (::renameat(m_folder, from.c_str(), m_folder, to.c_str()) != 0) return refused(errno);
    return {};
}

} // namespace trundle
