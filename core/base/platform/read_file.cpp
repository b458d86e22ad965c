#include "base/platform/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/platform/file_descriptor.h"

namespace trundle {
namespace {

Error failure(const std::string& path, const std::string& why) {
    return Error{Code::FileUnreadable, "cannot read " + path + ": " + why};
}

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

FileDescriptor::~FileDescriptor() {
    if (file >= 0) ::close(file);
}

const char* kindRefused(mode_t mode) {
    if (S_ISREG(mode)) return nullptr;
    if (S_ISDIR(mode)) return "it is a folder";
    if (S_ISFIFO(mode)) return "it is a pipe, not a file";
    if (S_ISSOCK(mode)) return "it is a socket, not a file";
    return "it is a device, not a file";
}

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::write(file, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
}

Result<std::string> readAll(const FileDescriptor& open, std::uint64_t mostBytes) {
    const auto failed = [](const std::string& why) { return Error{Code::FileUnreadable, why}; };
    struct stat state {};
    if (::fstat(open.file, &state) != 0) return failed(std::strerror(errno));
    if (static_cast<std::uint64_t>(state.st_size) > mostBytes) return failed(tooLarge(mostBytes));

    // Files in /proc report size 0, and a file may grow while it is read: the end is where read() returns 0.
    std::string bytes;
    bytes.resize(static_cast<std::size_t>(state.st_size) + 1);
    std::size_t filled = 0;
    for (;;) {
        if (filled == bytes.size()) bytes.resize(std::max<std::size_t>(bytes.size() * 2, 4096));
        const ssize_t got = ::read(open.file, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failed(std::strerror(errno));
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (filled > mostBytes) return failed(tooLarge(mostBytes));
    }
    bytes.resize(filled);
    return bytes;
}

Result<FileStamp> regularFileStamp(const std::string& path) {
    struct stat state {};
    if (::stat(path.c_str(), &state) != 0) return failure(path, std::strerror(errno));
    if (const char* kind = kindRefused(state.st_mode)) return failure(path, kind);
    return stampOf(state);
}

Result<std::string> readRegularFile(const std::string& path, std::uint64_t mostBytes) {
    if (path.find('\0') != std::string::npos) return failure(path, "its name holds a zero byte");
    // Checked before opening, because opening a device can have side effects, and after, because the file may have been replaced.
    if (const Result<FileStamp> before = regularFileStamp(path); !before) return before.error();
    const FileDescriptor open(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat state {};
    if (open.file < 0 || ::fstat(open.file, &state) != 0) return failure(path, std::strerror(errno));
    if (const char* kind = kindRefused(state.st_mode)) return failure(path, kind);
    Result<std::string> bytes = readAll(open, mostBytes);
    if (!bytes) return failure(path, bytes.error().message);
    return bytes;
}

} // namespace trundle
