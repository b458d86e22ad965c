#pragma once
// Undo for the whole program: what the files held before and after each edit.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "project/text_overlay.h"
#include "project/text_splice.h"

namespace trundle {

/// The bytes of files by absolute path. Copying copies pointers.
using FileTexts = TextOverlay;

/// One named edit, as it is made: the files it changed, before and after.
struct HistoryEntry {
    QString name;
    FileTexts before, after;
    std::string mergeKey; ///< edits of one drag or of one word typed share a key and become one entry
};

/// A list of entries and a place in it. Holds no document: who undoes puts the texts back. Every change of a text must pass through
/// here, since an entry keeps only what differs.
class History {
public:
    /// One entry as kept.
    struct Step {
        QString name;
        std::map<std::string, TextSplice> splices; ///< by file
        std::string mergeKey;
    };

    void push(HistoryEntry entry); ///< forgets what was undone; joins the last entry where the merge keys are equal and not empty
    /// Whether the last entry has this key and may still be joined.
    [[nodiscard]] bool canWithdraw(const std::string& mergeKey) const;
    /// The entry after the position, one that could be withdrawn before moveTo() went back over it, goes without a trace: what it
    /// made forgotten can be redone again.
    void dropWithdrawn();
    void endMerge(); ///< the next push starts an entry of its own
    void clear();
    void renameFile(const std::string& from, const std::string& to); ///< a file goes on under another path

    [[nodiscard]] const std::vector<Step>& entries() const { return m_entries; }
    [[nodiscard]] std::size_t position() const { return m_position; } ///< entries before it are done
    [[nodiscard]] bool canUndo() const { return m_position > 0; }
    [[nodiscard]] bool canRedo() const { return m_position < m_entries.size(); }
    /// Texts to put in place to be at `position`, moving there. Undo is moveTo(position() - 1).
    [[nodiscard]] FileTexts moveTo(std::size_t position);

private:
    void join(const HistoryEntry& entry);

    std::vector<Step> m_entries;
    std::vector<Step> m_forgotten; // by the last push, while it may be withdrawn
    FileTexts m_now;               // of each file that an entry changes
    std::size_t m_position = 0;
    bool m_mayMerge = false;
};

} // namespace trundle
