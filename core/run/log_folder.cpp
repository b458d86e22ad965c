#include "run/log_folder.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytes = 32 * 1024;

Error unwritable(const std::string& path, const std::string& why) {
    return Error{Code::LogUnwritable, "cannot write " + path + ": " + why};
}

/// Makes the folders between the log folder and the file, following no link on the way.
Status makeFolders(const fs::path& root, const fs::path& inner) {
    std::error_code failed;
    fs::create_directories(root, failed);
    if (!fs::is_directory(root)) return unwritable(root.string(), failed ? failed.message() : "it is not a folder");
    fs::path at = root;
    for (const fs::path& part : inner) {
        at /= part;
        const fs::file_status status = fs::symlink_status(at, failed);
        if (fs::is_symlink(status)) return unwritable(at.string(), "it is a symbolic link, which could lead out of the log folder");
        if (fs::exists(status) && !fs::is_directory(status)) return unwritable(at.string(), "a file stands where a folder is needed");
        if (!fs::exists(status) && !fs::create_directory(at, failed)) return unwritable(at.string(), failed.message());
    }
    return {};
}

} // namespace

LogFile::LogFile(std::string name, std::string path, std::FILE* file)
    : m_name(std::move(name)), m_path(std::move(path)), m_file(file) {
    m_buffer.reserve(kBufferBytes);
}

LogFile::~LogFile() { (void)close(); }

void LogFile::fail(int errorNumber) {
    if (!m_failure) m_failure = unwritable(m_path, errorNumber ? std::strerror(errorNumber) : "the disk refused");
}

void LogFile::flush() {
    if (!m_failure && !m_buffer.empty()) {
        errno = 0;
        if (std::fwrite(m_buffer.data(), 1, m_buffer.size(), m_file) != m_buffer.size()) fail(errno);
    }
    m_buffer.clear();
}

void LogFile::write(std::string_view bytes) {
    if (m_failure || !m_file) return;
    while (!bytes.empty()) {
        const std::string_view part = bytes.substr(0, kBufferBytes - m_buffer.size());
        m_buffer += part;
        bytes.remove_prefix(part.size());
        if (m_buffer.size() == kBufferBytes) flush();
    }
}

Status LogFile::close() {
    if (m_file) {
        flush();
        errno = 0;
        if (std::fclose(m_file) != 0) fail(errno);
        m_file = nullptr;
    }
    return m_failure ? Status(*m_failure) : Status();
}

Result<std::string> cleanLogName(std::string_view name) {
    const auto refused = [&](const char* why) {
        std::string shown(name);
        for (char& c : shown)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
        return Error{Code::LogUnwritable, "a log file cannot be called '" + shown + "': " + why};
    };
    if (name.size() > 1000) return Error{Code::LogUnwritable, "a log file's name is longer than 1000 bytes"};
    std::string clean;
    std::string part;
    const auto takePart = [&]() -> const char* {
        if (part == "..") return "'..' leaves the log folder";
        if (part.size() > 255) return "a part of it is longer than 255 bytes";
        if (!part.empty() && part != ".") clean += (clean.empty() ? "" : "/") + part;
        part.clear();
        return nullptr;
    };
    if (!name.empty() && (name.front() == '/' || name.front() == '\\')) return refused("it must be inside the log folder");
    if (name.size() > 1 && name[1] == ':') return refused("it must be inside the log folder");
    for (const char c : name) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return refused("it holds a control character");
        if (c != '/' && c != '\\') {
            part += c;
            continue;
        }
        if (const char* why = takePart()) return refused(why);
    }
    const bool namesFile = !part.empty() && part != ".";
    if (const char* why = takePart()) return refused(why);
    if (!namesFile) return refused("it names no file");
    return clean;
}

Result<LogFile*> LogFolder::create(std::string_view name) {
    if (m_path.empty()) return Error{Code::LogUnwritable, "this run keeps no logs"};
    Result<std::string> clean = cleanLogName(name);
    if (!clean) return clean.error();
    for (const auto& file : m_files)
        if (file->name() == clean.value()) return Error{Code::LogUnwritable, clean.value() + " is already written by this run"};

    const fs::path inner = clean.value();
    if (const Status made = makeFolders(m_path, inner.parent_path()); !made) return made.error();
    const fs::path path = fs::path(m_path) / inner;
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(path, failed);
    if (fs::is_symlink(status)) return unwritable(path.string(), "it is a symbolic link, which could lead out of the log folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) return unwritable(path.string(), "something that is no file stands there");
    // A new file, not the old one emptied: a hard link elsewhere keeps its content.
    if (fs::exists(status) && !fs::remove(path, failed)) return unwritable(path.string(), failed.message());
    std::FILE* file = std::fopen(path.c_str(), "wbxe");
    if (!file) return unwritable(path.string(), std::strerror(errno));
    std::setvbuf(file, nullptr, _IONBF, 0); // ours is the buffer
    m_files.push_back(std::make_unique<LogFile>(clean.value(), path.string(), file));
    return m_files.back().get();
}

} // namespace trundle
