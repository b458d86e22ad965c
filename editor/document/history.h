#pragma once
// Undo history of the whole program: what each edit changed in the files.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "lang/text_splice.h"
#include "project/loading/text_overlay.h"

namespace trundle {

/// Texts of files by absolute path. Copying copies pointers.
using FileTexts = TextOverlay;

/// One named edit: the texts of the changed files before and after.
struct HistoryEntry {
    QString name;
    FileTexts before, after;
    std::string mergeKey; ///< edits of one drag or of one typed word have the same key and become one entry
};

/// A list of entries and a position in it. It does not change the document: the caller of moveTo() applies the texts. Every
/// change of a text must be pushed, since an entry stores only the difference.
class History {
public:
    /// One stored entry.
    struct Step {
        QString name;
        std::map<std::string, TextSplice> splices; ///< by file
        std::string mergeKey;
    };

    void push(HistoryEntry entry); ///< drops redoable entries; joins the last entry if the merge keys are equal and not empty
    /// Whether the last entry has this key and can still be extended or discarded.
    [[nodiscard]] bool canDiscardMerge(const std::string& mergeKey) const;
    /// Removes the entry after the position, which moveTo() has just undone and which canDiscardMerge() was true for. The
    /// entries that it had made unreachable can be redone again.
    void dropDiscarded();
    void endMerge(); ///< the next push creates its own entry
    void clear();
    void renameFile(const std::string& from, const std::string& to); ///< the file now has another path

    [[nodiscard]] const std::vector<Step>& entries() const { return m_entries; }
    [[nodiscard]] std::size_t position() const { return m_position; } ///< number of entries that are applied
    [[nodiscard]] bool canUndo() const { return m_position > 0; }
    [[nodiscard]] bool canRedo() const { return m_position < m_entries.size(); }
    /// Moves to `position` and returns the texts to apply. Undo is moveTo(position() - 1).
    [[nodiscard]] FileTexts moveTo(std::size_t position);

private:
    void join(const HistoryEntry& entry);

    std::vector<Step> m_entries;
    std::vector<Step> m_forgotten; // redoable entries dropped by the last push, kept while it can be discarded
    FileTexts m_now;               // current text of each file that an entry changes
    std::size_t m_position = 0;
    bool m_mayMerge = false;
};

} // namespace trundle
