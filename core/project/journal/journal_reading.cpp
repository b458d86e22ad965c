#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>

#include "base/platform/folder_handle.h"
#include "base/platform/process_identity.h"
#include "lang/text_splice.h"
#include "project/journal/journal.h"
#include "project/journal/journal_record.h"
#include "project/journal/state_folder.h"
#include "project/loading/search.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMaxJournalBytes = 1u << 30;
constexpr std::size_t kMaxListed = 100;            ///< journals inside a project
constexpr std::chrono::hours kEmptyJournalAge{24}; ///< after this time an empty journal is removed

template <class Number> std::optional<Number> numberIn(const std::string& text) {
    Number number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Replays the records. Stops at the first invalid or truncated record.
class JournalReplay {
public:
    bool readField(const JournalRecord& record) {
        switch (record.kind) {
        case JournalRecord::Head: return readHead(record.fields);
        case JournalRecord::Begin: return readBegin(record.fields);
        case JournalRecord::Change: return readChange(record.fields);
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
    bool readHead(const std::vector<std::string>& fields) {
        if (fields.size() != 5) return false;
        recovery.head = {fields[0], fields[1]};
        writer = {numberIn<std::int64_t>(fields[2]).value_or(0), numberIn<std::uint64_t>(fields[3]).value_or(0), fields[4]};
        return true;
    }
    bool readBegin(const std::vector<std::string>& fields) {
        const bool isCreated = fields.size() == 4 && fields[3] == kCreatedMark;
        if (fields.size() != 3 && !isCreated) return false;
        recovery.files[fields[0]] = {fields[1], fields[1], isCreated && fields[0] != recovery.head.opened};
        return readTime(fields[2]);
    }
    bool readChange(const std::vector<std::string>& fields) {
        if (fields.size() != 5) return false;
        const auto file = recovery.files.find(fields[0]);
        const auto at = numberIn<std::uint64_t>(fields[1]), length = numberIn<std::uint64_t>(fields[2]);
        if (file == recovery.files.end() || !at || !length) return false;
        std::string& text = file->second.text;
        if (*at > text.size() || *length > text.size() - *at) return false;
        text.replace(*at, *length, fields[3]);
        return readTime(fields[4]);
    }
    bool readTime(const std::string& text) {
        const auto time = numberIn<std::int64_t>(text);
        if (time) recovery.time = std::max(recovery.time, *time);
        return time.has_value();
    }
};

std::optional<JournalReplay> play(std::string_view bytes) {
    if (!bytes.starts_with(kJournalMark)) return std::nullopt;
    bytes.remove_prefix(kJournalMark.size());
    JournalReplay playback;
    while (const std::optional<JournalRecord> record = nextRecord(bytes))
        if (!playback.readField(*record)) break;
    std::erase_if(playback.recovery.files, [](const auto& entry) { return entry.second.base == entry.second.text; });
    if (playback.recovery.head.opened.empty() || playback.recovery.files.empty()) return std::nullopt;
    return playback;
}

/// A window on another host may still write: locks of other hosts are not always visible here.
bool writerIsGone(const std::string& path, const ProcessIdentity& writer) {
    return !LockedFile::isHeld(path) && !(writer.host != thisProcess().host && isPossiblyAlive(writer));
}

/// Removes a journal without notes, left by a crash. A recent one is kept: it may be about to be written.
void removeEmptyJournal(const fs::path& path) {
    std::error_code failed;
    const fs::file_time_type changed = fs::last_write_time(path, failed);
    if (failed || fs::file_time_type::clock::now() - changed < kEmptyJournalAge || LockedFile::isHeld(path.string())) return;
    fs::remove(path, failed);
}

} // namespace

std::optional<Recovery> readJournal(std::string_view bytes) {
    std::optional<JournalReplay> playback = play(bytes);
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
        if (name.ends_with(".journal.new")) removeEmptyJournal(file);
        if (!name.ends_with(".journal")) continue;
        const Result<std::string> bytes = folder.value().readFile(name, kMaxJournalBytes);
        if (!bytes) continue;
        std::optional<JournalReplay> playback = play(bytes.value());
        if (!playback) removeEmptyJournal(file);
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
    for (fs::directory_iterator at(folder, none), end; !none && at != end && found.size() < kMaxListed; at.increment(none))
        if (at->path().extension() == ".journal") found.push_back(at->path().string());
    std::ranges::sort(found);
    return found;
}

std::vector<std::string> filesOutside(const Recovery& recovery, const std::vector<std::string>& folders) {
    std::vector<std::string> outside;
    for (const auto& [path, text] : recovery.files)
        if (!isInside(path, folders)) outside.push_back(path);
    return outside;
}

void discardRecovery(const Recovery& recovery) {
    std::error_code none;
    fs::remove(recovery.journal, none);
    const fs::path folder = fs::path(recovery.journal).parent_path();
    if (fs::remove(folder, none)) tidyWorkFolder(folder.parent_path().string()); // only if it is empty
}

} // namespace trundle
