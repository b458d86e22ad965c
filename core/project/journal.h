#pragma once
// Texts that are not saved, kept on the disk: an append-only file for each window, from which a crash loses nothing that was noted.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/platform/locked_file.h"
#include "base/result.h"

namespace trundle {

/// What is being edited: an opened file and, while no file holds it, the name it is shown under.
struct JournalHead {
    std::string opened; ///< absolute path
    std::string name;   ///< "" for a text that has a file
};

/// The writing side. The file is made at the first note, in `journal/` of projectStateFolder(), and is locked as long as it is open.
/// Records carry checksums; one that was cut off by a crash is left out when the journal is read.
class Journal {
public:
    Journal(std::string projectFolder, JournalHead head);
    ~Journal(); ///< leaves the file where it is
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// A text is now `text`, having begun as `base` on the disk. Writes what differs from the last note. `isCreated`: see RecoveredText.
    [[nodiscard]] Status note(const std::string& file, const std::string& base, const std::string& text, bool isCreated = false);
    /// A text is saved. When none is left the journal goes.
    [[nodiscard]] Status forget(const std::string& file);
    [[nodiscard]] bool holds(const std::string& file) const { return m_noted.contains(file); }
    [[nodiscard]] bool empty() const { return m_noted.empty(); }
    /// The file, for a thread that waits until the disk has it; null where there is none. May be kept and synced while this goes on.
    [[nodiscard]] std::shared_ptr<const LockedFile> file() const { return m_file; }
    /// Removes the file: there is nothing to bring back.
    void discard();

private:
    struct Noted {
        std::string base, text;
        bool isCreated = false;
    };
    [[nodiscard]] static std::string beginBytes(const std::string& file, const Noted& noted);
    [[nodiscard]] Status makeFile();
    [[nodiscard]] Status append(const std::string& record);
    [[nodiscard]] Status compact();

    std::string m_projectFolder;
    JournalHead m_head;
    std::shared_ptr<LockedFile> m_file;
    std::map<std::string, Noted> m_noted;
    std::uint64_t m_bytes = 0; // in the file
};

struct RecoveredText {
    std::string base; ///< the disk's bytes that the edits began with
    std::string text;
    bool isCreated = false; ///< by an edit that can be undone: the file goes when its text is empty
};

/// What a window that did not end well has left.
struct Recovery {
    std::string journal; ///< the file
    std::string project; ///< the folder that it was looked for with
    JournalHead head;
    std::int64_t time = 0; ///< of the last note, s since 1970
    std::map<std::string, RecoveredText> files;
};

/// Journals of a project whose windows are gone, newest first. Only those in the user's own state folder, which this user wrote and
/// nobody else may: what comes with a project could say anything, and who restores and saves it would write that to any file.
[[nodiscard]] std::vector<Recovery> findRecoveries(const std::string& projectFolder);
/// Journals inside the project's folder, where an earlier version kept them, or somebody put them. They are not read.
[[nodiscard]] std::vector<std::string> journalsInProject(const std::string& projectFolder);
/// Files of a journal that are really below none of the folders.
[[nodiscard]] std::vector<std::string> filesOutside(const Recovery& recovery, const std::vector<std::string>& folders);
/// Removes the journal: it was brought back, or is not wanted.
void discardRecovery(const Recovery& recovery);
/// What a journal's bytes say, as far as they are whole. Nothing where they say nothing.
[[nodiscard]] std::optional<Recovery> readJournal(std::string_view bytes);

} // namespace trundle
