#include "run/log_folder.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

#include "base/platform/read_file.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListTitle = "logs of the last run, removed by the next";
constexpr std::uint64_t kMostListBytes = 16 << 20;

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
        if (fs::is_symlink(status))
            return unwritable(at.string(), "it is a symbolic link, which could lead out of the log folder");
        if (fs::exists(status) && !fs::is_directory(status))
            return unwritable(at.string(), "a file stands where a folder is needed");
        if (!fs::exists(status) && !fs::create_directory(at, failed)) return unwritable(at.string(), failed.message());
    }
    return {};
}

bool isPlainFile(const fs::path& path) {
    std::error_code failed;
    return fs::is_regular_file(fs::symlink_status(path, failed));
}

/// The names of a list that could be ours; of anything else none.
std::vector<std::string> listedNames(const fs::path& list) {
    std::vector<std::string> names;
    if (!isPlainFile(list)) return names;
    const Result<std::string> bytes = readRegularFile(list.string(), kMostListBytes);
    if (!bytes || !bytes.value().starts_with(std::string(kListTitle) + "\n")) return names;
    std::string_view rest = std::string_view(bytes.value()).substr(kListTitle.size() + 1);
    for (std::size_t end; (end = rest.find('\n')) != std::string_view::npos; rest.remove_prefix(end + 1)) {
        const std::string name(rest.substr(0, end));
        const Result<std::string> clean = cleanLogName(name);
        if (clean && clean.value() == name && name.find('/') == std::string::npos) names.push_back(name);
    }
    return names;
}

} // namespace

LogFile::LogFile(std::string name, std::string path, std::FILE* file)
    : m_name(std::move(name)), m_path(std::move(path)), m_file(file) {}

LogFile::~LogFile() { (void)close(); }

void LogFile::note(int errorNumber) {
    if (errorNumber == 0 || m_failure) return;
    m_failure = unwritable(m_path, errorNumber == EBADF ? "its descriptor was closed or replaced by code of a module"
                                                        : std::strerror(errorNumber));
}

void LogFile::flush() { note(m_file.flush()); }

void LogFile::write(std::string_view bytes) { note(m_file.write(bytes)); }

Status LogFile::close() {
    note(m_file.close());
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
    if (clean == kLogList) return refused("the list of logs has that name");
    return clean;
}

Result<LogFile*> LogFolder::create(std::string_view name) {
    if (m_path.empty()) return Error{Code::LogUnwritable, "this run keeps no logs"};
    Result<std::string> clean = cleanLogName(name);
    if (!clean) return clean.error();
    if (m_names.contains(clean.value())) return Error{Code::LogUnwritable, clean.value() + " is already written by this run"};

    const fs::path inner = clean.value();
    if (const Status made = makeFolders(m_path, inner.parent_path()); !made) return made.error();
    const fs::path path = fs::path(m_path) / inner;
    std::error_code failed;
    const fs::file_status status = fs::symlink_status(path, failed);
    if (fs::is_symlink(status)) return unwritable(path.string(), "it is a symbolic link, which could lead out of the log folder");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return unwritable(path.string(), "something that is no file stands there");
    // A new file, not the old one emptied: a hard link elsewhere keeps its content.
    if (fs::exists(status) && !fs::remove(path, failed)) return unwritable(path.string(), failed.message());
    std::FILE* file = std::fopen(path.c_str(), "wbxe");
    if (!file) return unwritable(path.string(), std::strerror(errno));
    m_names.insert(clean.value());
    m_files.push_back(std::make_unique<LogFile>(clean.value(), path.string(), file));
    return m_files.back().get();
}

void LogFolder::settle() {
    if (m_path.empty()) return;
    const fs::path folder = m_path, list = folder / kLogList;
    std::set<std::string> own;
    for (const auto& file : m_files)
        if (file->name().find('/') == std::string::npos) own.insert(file->name());

    // The list is for tidiness alone: a run is none the worse where it cannot be kept.
    std::error_code ignored;
    for (const std::string& name : listedNames(list))
        if (!own.contains(name) && isPlainFile(folder / name)) fs::remove(folder / name, ignored);
    if (isPlainFile(list)) fs::remove(list, ignored);
    std::FILE* file = own.empty() ? nullptr : std::fopen(list.c_str(), "wbxe"); // a new one: no link is followed
    if (!file) return;
    std::string text = std::string(kListTitle) + "\n";
    for (const std::string& name : own) text += name + "\n";
    (void)std::fwrite(text.data(), 1, text.size(), file);
    std::fclose(file);
}

} // namespace trundle
