#pragma once
// Unsaved texts on disk: one append-only file per window, so that a crash loses nothing that was written to it.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/platform/locked_file.h"
#include "base/result.h"
#include "lang/text_splice.h"
#include "project/loading/text_overlay.h"

namespace trundle {

/// The edited file: its path and, until it is saved for the first time, its display name.
struct JournalHead {
    std::string opened; ///< absolute path
    std::string name;   ///< "" if the text has a file
};

/// Writes a journal. The file is created at the first note() in `journal/` of projectStateFolder() and is locked while it is
/// open. Records have checksums; a record truncated by a crash is ignored when the journal is read.
class Journal {
public:
    Journal(std::string projectFolder, JournalHead head);
    ~Journal(); ///< keeps the file
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// Records that a file with the bytes `base` on disk now has the text `text`; writes only the difference to the last note.
    /// `isCreated`: see RecoveredText.
    [[nodiscard]] Status note(const std::string& file, SharedText base, SharedText text, bool isCreated = false);
    /// Records that a file was saved. Removes the journal when no unsaved text is left.
    [[nodiscard]] Status forget(const std::string& file);
    [[nodiscard]] bool holds(const std::string& file) const { return m_journaled.contains(file); }
    [[nodiscard]] bool empty() const { return m_journaled.empty(); }
    /// The file, for a thread that syncs it to disk; null if there is none. May be kept and synced concurrently with all other
    /// calls.
    [[nodiscard]] std::shared_ptr<const LockedFile> file() const { return m_file; }
    /// Removes the file: nothing is left to restore.
    void discard();

private:
    struct JournaledText {
        SharedText base, text;
        bool isCreated = false;
    };
    /// Returns the number of bytes written.
    [[nodiscard]] static Result<std::uint64_t> begin(LockedFile& journal, const std::string& file,
                                                     const JournaledText& journaled);
    [[nodiscard]] static std::string changeBytes(const std::string& file, const TextSplice& splice);
    [[nodiscard]] Status makeFile();
    [[nodiscard]] Status append(const std::string& record);
    [[nodiscard]] Status compact();

    std::string m_projectFolder;
    JournalHead m_head;
    std::shared_ptr<LockedFile> m_file;
    std::map<std::string, JournaledText> m_journaled;
    std::uint64_t m_bytes = 0; // size of the file
};

struct RecoveredText {
    std::string base; ///< bytes on disk when editing began
    std::string text;
    bool isCreated = false; ///< created by an undoable edit: the file is removed if its text is empty
};

/// Contents of a journal left by a window that closed unexpectedly.
struct Recovery {
    std::string journal; ///< path of the journal
    std::string project; ///< folder of the project that was searched
    JournalHead head;
    std::int64_t time = 0; ///< of the last note, s since 1970
    std::map<std::string, RecoveredText> files;
};

/// Journals of a project whose windows are gone, newest first. Only reads journals in the user's own state folder that belong to
/// this user and that no one else can write: a journal shipped with a project could otherwise overwrite any file when it is
/// restored and saved.
[[nodiscard]] std::vector<Recovery> findRecoveries(const std::string& projectFolder);
/// Journals inside the project's folder, from an earlier version or another source. They are never read.
[[nodiscard]] std::vector<std::string> journalsInProject(const std::string& projectFolder);
/// Files of a journal that are not below any of the folders, links resolved.
[[nodiscard]] std::vector<std::string> filesOutside(const Recovery& recovery, const std::vector<std::string>& folders);
/// Removes a journal after it was restored or discarded.
void discardRecovery(const Recovery& recovery);
/// Parses a journal's bytes up to the first damaged record. Nothing if there is no usable record.
[[nodiscard]] std::optional<Recovery> readJournal(std::string_view bytes);

} // namespace trundle
