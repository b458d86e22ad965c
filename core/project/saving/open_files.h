#pragma once
// The files of a document: their current text and their last known content on disk.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/loading/text_overlay.h"

namespace trundle {

struct OpenFile {
    SharedText text;   ///< current text
    SharedText disk;   ///< last known content on disk; for a new text, its initial content
    bool gone = false; ///< deleted on disk
    bool made = false; ///< created by an edit; an empty text means that the file does not exist
    SharedText theirs; ///< content on disk that conflicts with edits made here, until it is resolved; else null

    [[nodiscard]] bool edited() const { return text != disk && *text != *disk; }
    [[nodiscard]] bool modified() const { return gone || edited(); }
    [[nodiscard]] bool isRemoved() const { return made && text->empty(); } ///< the next save removes it
};

class OpenFiles {
public:
    void clear() { m_files.clear(); }
    /// Adds a file with its content on disk. A known file does not change.
    void take(const std::string& path, SharedText bytes);
    void make(const std::string& path); ///< adds a file that is not on disk, with an empty text
    void remove(const std::string& path) { m_files.erase(path); }
    /// A file was saved at another path: its text is on disk there. A file known at that path is kept.
    void rename(const std::string& from, const std::string& to);

    [[nodiscard]] OpenFile* find(const std::string& path);
    [[nodiscard]] const OpenFile* find(const std::string& path) const;
    [[nodiscard]] SharedText text(const std::string& path) const; ///< null if the file is unknown
    void setTexts(const TextOverlay& texts);                      ///< of known files
    [[nodiscard]] TextOverlay texts() const;
    [[nodiscard]] std::vector<std::string> modified() const;
    /// All files in an order in which writing can be interrupted safely: files that edits created before the files that
    /// import them, files that a save removes after the files that imported them.
    [[nodiscard]] std::vector<std::string> inWritingOrder() const;
    [[nodiscard]] const std::map<std::string, OpenFile>& all() const { return m_files; }

private:
    std::map<std::string, OpenFile> m_files; // by absolute path
};

} // namespace trundle
