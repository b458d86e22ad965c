#include "run/logs/log_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

#include "base/clean_text.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kListTitle = "logs of the last run, removed by the next", kOwnerTitle = "of the experiment ";
constexpr std::uint64_t kMaxListBytes = 16 << 20;

Error unwritable(const std::string& path, const std::string& why) {
    return Error{Code::LogUnwritable, "cannot write " + path + ": " + why};
}

/// The valid file names of the list in a folder; empty if the list has another format. None if it is that of another experiment.
std::optional<std::vector<std::string>> listedNames(const FolderHandle& folder, const std::string& experiment) {
    std::vector<std::string> names;
    const Result<std::string> bytes = folder.readFile(std::string(kLogList), kMaxListBytes);
    if (!bytes || !bytes.value().starts_with(std::string(kListTitle) + "\n")) return names;
    std::string_view rest = std::string_view(bytes.value()).substr(kListTitle.size() + 1);
    if (rest.starts_with(kOwnerTitle)) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        if (!experiment.empty() && rest.substr(kOwnerTitle.size(), end - kOwnerTitle.size()) != experiment) return std::nullopt;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
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
        return Error{Code::LogUnwritable, "a log file cannot be called '" + cleanLine(name) + "': " + why};
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

std::string experimentName(const std::string& experimentFile) {
    const std::string stem = fs::path(experimentFile).stem().string();
    return stem.empty() || stem == "." || stem == ".." ? "experiment" : stem; // `..` is the stem of a file called "..."
}

LogLocation logsOf(const std::string& projectFolder, const std::string& experimentFile, const std::string& chosen) {
    std::error_code failed;
    LogLocation logs = chosen.empty() ? LogLocation(projectFolder, "logs/" + experimentName(experimentFile))
                                      : LogLocation(fs::absolute(chosen, failed).string());
    logs.experiment = fs::weakly_canonical(experimentFile, failed).string();
    std::ranges::replace(logs.experiment, '\n', ' '); // it is a line of the list
    return logs;
}

Result<FolderHandle> LogFolder::folderOf(const std::string& name, bool make) const {
    fs::path shown = m_location.folder;
    Result<FolderHandle> folder = make ? FolderHandle::make(shown.string()) : FolderHandle::open(shown.string());
    const auto enter = [&](const fs::path& way) {
        for (const fs::path& part : way) {
            if (!folder) return;
            shown /= part;
            folder = make ? folder.value().makeFolder(part.string()) : folder.value().openFolder(part.string());
        }
    };
    enter(m_location.below);
    if (!folder && !m_location.below.empty())
        return unwritable(shown.string(), folder.error().message + "; trundle-cli run --log-dir DIR writes logs elsewhere");
    enter(fs::path(name).parent_path());
    if (!folder) return unwritable(shown.string(), folder.error().message);
    return folder;
}

Status LogFolder::lock() {
    if (m_locked) return {};
    Result<FolderHandle> folder = folderOf(std::string(kLogList), true);
    if (!folder) return folder.error();
    const fs::path inside = m_location.below, shown = inside.empty() ? fs::path(m_location.folder) : m_location.folder / inside;
    if (!folder.value().lock())
        return unwritable(
            shown.string(),
            "another run writes its logs there; end it, or give this one a folder of its own: trundle-cli run --log-dir DIR");
    m_locked = std::move(folder).value();
    return {};
}

Result<LogFile*> LogFolder::create(std::string_view name) {
    if (m_location.empty()) return Error{Code::LogUnwritable, "this run keeps no logs"};
    Result<std::string> clean = cleanLogName(name);
    if (!clean) return clean.error();
    if (m_names.contains(clean.value())) return Error{Code::LogUnwritable, clean.value() + " is already written by this run"};
    if (const Status locked = lock(); !locked) return locked.error();
    const Result<FolderHandle> folder = folderOf(clean.value(), true);
    if (!folder) return folder.error();
    const std::string path = (fs::path(m_location.path()) / clean.value()).string();
    const Result<std::FILE*> file = folder.value().makeFile(fs::path(clean.value()).filename().string());
    if (!file) return unwritable(path, file.error().message);
    m_names.insert(clean.value());
    m_files.push_back(std::make_unique<LogFile>(clean.value(), path, file.value()));
    return m_files.back().get();
}

void LogFolder::remove(const LogFile& file) {
    if (const Result<FolderHandle> folder = folderOf(file.name(), false))
        folder.value().removeFile(fs::path(file.name()).filename().string());
}

void LogFolder::settle() {
    if (m_location.empty()) return;
    std::set<std::string> own;
    for (const auto& file : m_files)
        if (file->name().find('/') == std::string::npos) own.insert(file->name());

    // The list is only used to remove old logs: a failure to write it is ignored.
    const std::string list(kLogList);
    const Result<FolderHandle> folder = folderOf(list, false);
    if (!folder) return;
    const auto listed = listedNames(folder.value(), m_location.experiment);
    if (!listed && own.empty()) return;
    for (const std::string& name : listed.value_or(std::vector<std::string>()))
        if (!own.contains(name)) folder.value().removeFile(name);
    if (own.empty()) {
        folder.value().removeFile(list);
        return;
    }
    const Result<std::FILE*> file = folder.value().makeFile(list);
    if (!file) return;
    std::string text = std::string(kListTitle) + "\n";
    if (!m_location.experiment.empty()) text += std::string(kOwnerTitle) + m_location.experiment + "\n";
    for (const std::string& name : own) text += name + "\n";
    (void)std::fwrite(text.data(), 1, text.size(), file.value());
    std::fclose(file.value());
}

} // namespace trundle
