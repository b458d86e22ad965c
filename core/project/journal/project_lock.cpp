#include "project/journal/project_lock.h"

#include <chrono>
#include <ctime>
#include <filesystem>
#include <sstream>

#include "base/clean_text.h"
#include "base/platform/read_file.h"
#include "project/journal/state_folder.h"

namespace trundle {

namespace {

constexpr std::size_t kMaxShown = 64; ///< characters of a host name that are shown; it comes from a file

std::string written(const LockHolder& holder) {
    std::ostringstream out;
    out << holder.process.pid << '\n'
        << holder.process.start << '\n'
        << holder.process.host << '\n'
        << holder.since << '\n'
        << holder.opened << '\n';
    return out.str();
}

LockHolder read(const std::string& path) {
    LockHolder holder;
    const Result<std::string> text = readRegularFile(path, 1u << 16);
    if (!text) return holder;
    std::istringstream in(text.value());
    in >> holder.process.pid >> holder.process.start;
    in.ignore(1);
    std::getline(in, holder.process.host);
    in >> holder.since;
    in.ignore(1);
    std::getline(in, holder.opened);
    return holder;
}

/// Whether the holder's process on this host still runs, as far as the file's content shows; for file systems without locks.
bool isHolderAlive(const LockHolder& holder) {
    const ProcessIdentity self = thisProcess();
    return holder.process.pid > 0 && holder.process.host == self.host && holder.process.pid != self.pid &&
           isPossiblyAlive(holder.process);
}

} // namespace

std::string LockHolder::description() const {
    if (process.pid <= 0) return "another window";
    const std::time_t when = since;
    std::tm local{};
    char clock[32] = "";
    if (since > 0 && ::localtime_r(&when, &local)) std::strftime(clock, sizeof clock, ", since %H:%M", &local);
    return "another window (process " + std::to_string(process.pid) + " on " + cleanLine(process.host).substr(0, kMaxShown) +
           clock + ")";
}

ProjectLock::ProjectLock(const std::string& projectFolder, const std::string& opened) {
    const std::string folder = makeWorkFolder(projectFolder);
    if (folder.empty()) return;
    const std::string path = folder + "/lock";
    const LockHolder before = read(path);
    Result<std::optional<LockedFile>> file = LockedFile::take(path);
    if (!file) return;
    m_taken = file.value().has_value() && !isHolderAlive(before);
    if (!m_taken) {
        m_holder = before;
        return;
    }
    m_file = std::move(file).value();
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    m_holder = {thisProcess(), opened, std::chrono::duration_cast<std::chrono::seconds>(now).count()};
    (void)m_file->rewrite(written(m_holder)); // the content is only informative
}

ProjectLock::~ProjectLock() {
    if (!m_file) return;
    const std::string folder = std::filesystem::path(m_file->path()).parent_path().string();
    m_file->remove();
    tidyWorkFolder(folder);
}

} // namespace trundle
