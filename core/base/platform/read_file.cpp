#include "base/platform/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trundle {
namespace {

Error failure(const std::string& path, const std::string& why) {
    return Error{Code::FileUnreadable, "cannot read " + path + ": " + why};
}

const char* kindRefused(mode_t mode) {
    if (S_ISREG(mode)) return nullptr;
    if (S_ISDIR(mode)) return "it is a folder";
    if (S_ISFIFO(mode)) return "it is a pipe, not a file";
    if (S_ISSOCK(mode)) return "it is a socket, not a file";
    return "it is a device, not a file";
}

struct ReadFrom {
    int file;
    ~ReadFrom() {
        if (file >= 0) ::close(file);
    }
};

FileStamp stampOf(const struct stat& state) {
    return {static_cast<std::uint64_t>(state.st_dev), static_cast<std::uint64_t>(state.st_ino),
            static_cast<std::uint64_t>(state.st_size),
            static_cast<std::int64_t>(state.st_mtim.tv_sec) * 1'000'000'000 + state.st_mtim.tv_nsec};
}

std::string tooLarge(std::uint64_t most) {
    const bool megabytes = most >= (1u << 20);
    return "it is larger than " + std::to_string(megabytes ? most >> 20 : most) + (megabytes ? " MiB" : " bytes");
}

} // namespace

Result<FileStamp> regularFileStamp(const std::string& path) {
    struct stat state {};
    if (::stat(path.c_str(), &state) != 0) return failure(path, std::strerror(errno));
    if (const char* kind = kindRefused(state.st_mode)) return failure(path, kind);
    return stampOf(state);
}

Result<std::string> readRegularFile(const std::string& path, std::uint64_t mostBytes) {
    if (path.find('\0') != std::string::npos) return failure(path, "its name holds a zero byte");
    // Looked at before opening, because opening a device can have effects; and after, because it may have been exchanged.
    if (const Result<FileStamp> before = regularFileStamp(path); !before) return before.error();
    const ReadFrom open{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
    struct stat state {};
    if (open.file < 0 || ::fstat(open.file, &state) != 0) return failure(path, std::strerror(errno));
    if (const char* kind = kindRefused(state.st_mode)) return failure(path, kind);
    if (static_cast<std::uint64_t>(state.st_size) > mostBytes) return failure(path, tooLarge(mostBytes));

    // Files of /proc say size 0, and a file may grow while we read: the end is where read() says so.
    std::string bytes;
    bytes.resize(static_cast<std::size_t>(state.st_size) + 1);
    std::size_t filled = 0;
    for (;;) {
        if (filled == bytes.size()) bytes.resize(std::max<std::size_t>(bytes.size() * 2, 4096));
        const ssize_t got = ::read(open.file, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failure(path, std::strerror(errno));
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > mostBytes) return failure(path, tooLarge(mostBytes));
    }
    bytes.resize(filled);
    return bytes;
}

} // namespace trundle
