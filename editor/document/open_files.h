#pragma once
// The files of a document: what they hold here and what the disk is known to hold.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/text_overlay.h"

namespace trundle {

using SharedText = std::shared_ptr<const std::string>;

struct OpenFile {
    SharedText text;   ///< here
    SharedText disk;   ///< the last bytes of the disk that were seen; what a new text began with
    bool gone = false; ///< no longer on the disk
    bool made = false; ///< by an edit: no text is no file
    SharedText theirs; ///< what another program wrote over edits made here, until someone decides; else null

    [[nodiscard]] bool edited() const { return text != disk && *text != *disk; }
    [[nodiscard]] bool modified() const { return gone || edited(); }
    [[nodiscard]] bool isRemoved() const { return made && text->empty(); } ///< by a save
};

class OpenFiles {
public:
    void clear() { m_files.clear(); }
    /// Takes a file in as the disk holds it. One that is known stays as it is.
    void take(const std::string& path, std::string_view bytes);
    void make(const std::string& path); ///< one that is on no disk, without a text
    void remove(const std::string& path) { m_files.erase(path); }

    [[nodiscard]] OpenFile* find(const std::string& path);
    [[nodiscard]] const OpenFile* find(const std::string& path) const;
    [[nodiscard]] SharedText text(const std::string& path) const; ///< null where the file is not known
    void setTexts(const TextOverlay& texts);                      ///< of files that are known
    [[nodiscard]] TextOverlay texts() const;
    [[nodiscard]] std::vector<std::string> modified() const;
    /// All files in an order of writing that is safe to be cut off anywhere: what edits created before what imports it, what a save
    /// removes after what imported it.
    [[nodiscard]] std::vector<std::string> inWritingOrder() const;
    [[nodiscard]] const std::map<std::string, OpenFile>& all() const { return m_files; }

private:
    std::map<std::string, OpenFile> m_files; // by absolute path
};

} // namespace trundle
