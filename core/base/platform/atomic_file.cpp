#include "base/platform/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/file_descriptor.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".trundle-", kSuffix = ".tmp";
constexpr time_t kOldS = 60;

Error failure(const std::string& path, const std::string& why) {
    return Error{Code::FileUnwritable, "cannot write " + path + ": " + why};
}

// A rename would replace the link itself, so the link is resolved first.
std::optional<fs::path> targetOf(const std::string& path) {
    fs::path target = path;
    for (int hops = 0; hops < 40; ++hops) {
        std::error_code none;
        if (!fs::is_symlink(fs::symlink_status(target, none))) return target;
        const fs::path next = fs::read_symlink(target, none);
        if (none) return std::nullopt;
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return std::nullopt;
}

/// A temporary file, removed on destruction unless it was renamed.
struct Temporary {
    std::string path;
    int file = -1;

    explicit Temporary(const fs::path& folder) {
        for (int attempt = 0; attempt < 100 && file < 0; ++attempt) {
            path = (folder / temporaryName()).string();
            file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (file >= 0) lockTemporaryFile(file);
            if (file < 0 && errno != EEXIST) return;
        }
    }
    ~Temporary() {
        const int before = errno;
        closeFile();
        if (!path.empty()) ::unlink(path.c_str());
        errno = before;
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    bool closeFile() {
        const int old = std::exchange(file, -1);
        return old < 0 || ::close(old) == 0;
    }
};

/// As temporaryName() makes them.
bool isTemporaryName(std::string_view name) {
    if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix) || name.size() <= kPrefix.size() + kSuffix.size()) return false;
    name = name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
    return name.find('-') != std::string_view::npos && name.find_first_not_of("0123456789-") == std::string_view::npos;
}

// Some file systems cannot fsync a folder. The rename has already happened, so this is not a failure.
void syncFolder(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0) return;
    (void)::fsync(file);
    ::close(file);
}

} // namespace

std::string temporaryName() {
    static std::atomic<unsigned> counter{0};
    return std::string(kPrefix) + std::to_string(::getpid()) + "-" + std::to_string(counter++) + std::string(kSuffix);
}

void lockTemporaryFile(int file) { (void)::flock(file, LOCK_EX | LOCK_NB); }

// A live writer holds a lock, except just after creating its file; hence the age limit.
void removeAbandonedFiles(const std::string& folder) {
    std::error_code none;
    for (fs::directory_iterator at(folder, none), end; !none && at != end; at.increment(none)) {
        const std::string path = at->path().string();
        if (!isTemporaryName(at->path().filename().string())) continue;
        const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (file < 0) continue;
        struct stat state {};
        const bool old = ::fstat(file, &state) == 0 && S_ISREG(state.st_mode) && ::time(nullptr) - state.st_mtime > kOldS;
        if (old && ::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
        ::close(file);
    }
}

Status writeFileAtomically(const std::string& path, std::string_view bytes) {
    const std::optional<fs::path> target = targetOf(path);
    if (!target) return failure(path, "its chain of links has no end");
    struct stat old {};
    const bool exists = ::stat(target->c_str(), &old) == 0;
    if (!exists && *target != path)
        return failure(path, "it is a symbolic link to " + target->string() + ", which does not exist");
    if (exists && S_ISDIR(old.st_mode)) return failure(path, "it is a folder");
    if (exists && !S_ISREG(old.st_mode)) return failure(path, "it is not a regular file");
    // A rename checks only the permissions of the folder; a file that its owner made read-only must stay unchanged.
    if (exists && ::access(target->c_str(), W_OK) != 0) return failure(path, std::strerror(errno));

    const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
    Temporary temporary(folder);
    if (temporary.file < 0) {
        const int why = errno;
        temporary.path.clear();
        return failure(path, std::strerror(why));
    }
    if (exists) {
        // Only root can keep the owner; otherwise the file is written with a new owner.
        if (::fchown(temporary.file, old.st_uid, old.st_gid) != 0) errno = 0;
        if (::fchmod(temporary.file, old.st_mode & 07777) != 0) return failure(path, std::strerror(errno));
    }
    if (!writeAll(temporary.file, bytes) || ::fsync(temporary.file) != 0 || !temporary.closeFile())
        return failure(path, std::strerror(errno));
    if (::rename(temporary.path.c_str(), target->c_str()) != 0) return failure(path, std::strerror(errno));
    temporary.path.clear();
    removeAbandonedFiles(folder.string());
    syncFolder(folder);
    return {};
}

bool isWritable(const std::string& path) { return ::access(path.c_str(), W_OK) == 0; }

} // namespace trundle
