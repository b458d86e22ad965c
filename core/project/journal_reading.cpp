#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>

#include "base/platform/folder_handle.h"
#include "base/platform/process_identity.h"
#include "project/journal.h"
#include "project/journal_record.h"
#include "project/search.h"
#include "project/state_folder.h"
#include "project/text_splice.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostJournalBytes = 1u << 30;
constexpr std::size_t kMostListed = 100;     ///< journals inside a project
constexpr std::chrono::hours kWorthless{24}; ///< after which a journal that says nothing is taken away

template <class Number> std::optional<Number> numberIn(const std::string& text) {
    Number number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Plays the records back. A record that makes no sense ends it, like one that is cut off.
class Playback {
public:
    bool take(const JournalRecord& record) {
        switch (record.kind) {
        case JournalRecord::Head: return takeHead(record.fields);
        case JournalRecord::Begin: return takeBegin(record.fields);
        case JournalRecord::Change: return takeChange(record.fields);
        case JournalRecord::Forget:
            if (record.fields.size() != 1) return false;
            recovery.files.erase(record.fields[0]);
            return true;
        }
        return false;
    }

    Recovery recovery;
    ProcessIdentity writer;

private:
    bool takeHead(const std::vector<std::string>& fields) {
        if (fields.size() != 5) return false;
        recovery.head = {fields[0], fields[1]};
        writer = {numberIn<std::int64_t>(fields[2]).value_or(0), numberIn<std::uint64_t>(fields[3]).value_or(0), fields[4]};
        return true;
    }
    bool takeBegin(const std::vector<std::string>& fields) {
        const bool isCreated = fields.size() == 4 && fields[3] == kCreatedMark;
        if (fields.size() != 3 && !isCreated) return false;
        recovery.files[fields[0]] = {fields[1], fields[1], isCreated && fields[0] != recovery.head.opened};
        return takeTime(fields[2]);
    }
    bool takeChange(const std::vector<std::string>& fields) {
        if (fields.size() != 5) return false;
        const auto file = recovery.files.find(fields[0]);
        const auto at = numberIn<std::uint64_t>(fields[1]), length = numberIn<std::uint64_t>(fields[2]);
        if (file == recovery.files.end() || !at || !length) return false;
        std::string& text = file->second.text;
        if (*at > text.size() || *length > text.size() - *at) return false;
        text.replace(*at, *length, fields[3]);
        return takeTime(fields[4]);
    }
    bool takeTime(const std::string& text) {
        const auto time = numberIn<std::int64_t>(text);
        if (time) recovery.time = std::max(recovery.time, *time);
        return time.has_value();
    }
};

std::optional<Playback> play(std::string_view bytes) {
    if (!bytes.starts_with(kJournalMark)) return std::nullopt;
    bytes.remove_prefix(kJournalMark.size());
    Playback playback;
    while (const std::optional<JournalRecord> record = nextRecord(bytes))
        if (!playback.take(*record)) break;
    std::erase_if(playback.recovery.files, [](const auto& entry) { return entry.second.base == entry.second.text; });
    if (playback.recovery.head.opened.empty() || playback.recovery.files.empty()) return std::nullopt;
    return playback;
}

/// Another host's window may still write: its locks are not always seen from here.
bool writerIsGone(const std::string& path, const ProcessIdentity& writer) {
    return !LockedFile::isHeld(path) && !(writer.host != thisProcess().host && mayBeAlive(writer));
}

/// What a crash left before anything was noted. A young one may be about to be written.
void removeWorthless(const fs::path& path) {
    std::error_code failed;
    const fs::file_time_type changed = fs::last_write_time(path, failed);
    if (failed || fs::file_time_type::clock::now() - changed < kWorthless || LockedFile::isHeld(path.string())) return;
    fs::remove(path, failed);
}

} // namespace

std::optional<Recovery> readJournal(std::string_view bytes) {
    std::optional<Playback> playback = play(bytes);
    if (!playback) return std::nullopt;
    return std::move(playback->recovery);
}

std::vector<Recovery> findRecoveries(const std::string& projectFolder) {
    std::vector<Recovery> found;
    const std::string path = projectStateFolder(projectFolder) + "/journal";
    const Result<FolderHandle> folder = FolderHandle::open(path);
    std::error_code none;
    for (fs::directory_iterator at(path, none), end; folder && !none && at != end; at.increment(none)) {
        const std::string name = at->path().filename().string(), file = at->path().string();
        if (!folder.value().hasOwnFile(name)) continue;
        if (name.ends_with(".journal.new")) removeWorthless(file);
        if (!name.ends_with(".journal")) continue;
        const Result<std::string> bytes = folder.value().readFile(name, kMostJournalBytes);
        if (!bytes) continue;
        std::optional<Playback> playback = play(bytes.value());
        if (!playback) removeWorthless(file);
        if (!playback || !writerIsGone(file, playback->writer)) continue;
        playback->recovery.journal = file;
        playback->recovery.project = projectFolder;
        found.push_back(std::move(playback->recovery));
    }
    std::ranges::stable_sort(found, [](const Recovery& a, const Recovery& b) { return a.time > b.time; });
    return found;
}

std::vector<std::string> journalsInProject(const std::string& projectFolder) {
    std::vector<std::string> found;
    const fs::path own = fs::path(projectFolder) / ".trundle", folder = own / "journal";
    std::error_code none;
    for (const fs::path& each : {own, folder})
        if (!fs::is_directory(fs::symlink_status(each, none))) return found;
    for (fs::directory_iterator at(folder, none), end; !none && at != end && found.size() < kMostListed; at.increment(none))
        if (at->path().extension() == ".journal") found.push_back(at->path().string());
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> filesOutside(const Recovery& recovery, const std::vector<std::string>& folders) {
    std::vector<std::string> outside;
    for (const auto& [path, text] : recovery.files)
        if (!liesInside(path, folders)) outside.push_back(path);
    return outside;
}

void discardRecovery(const Recovery& recovery) {
    std::error_code none;
    fs::remove(recovery.journal, none);
    const fs::path folder = fs::path(recovery.journal).parent_path();
    if (fs::remove(folder, none)) tidyWorkFolder(folder.parent_path().string()); // where nothing else is in it
}

} // namespace trundle
