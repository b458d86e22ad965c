#pragma once
// Where files are looked for, and which may be opened.

#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/text_overlay.h"

namespace trundle {

/// The nearest folder above the file that holds `.trundle/` or is named `configs`, else the file's own.
[[nodiscard]] std::string projectFolderOf(const std::string& file);
/// Absolute, links resolved as far as the path exists.
[[nodiscard]] std::string canonicalPath(const std::string& path);
/// As people know the file: relative to `from`, or to where they stand where that is empty, when it lies below; else absolute.
[[nodiscard]] std::string shownPath(const std::string& absolute, const std::string& from = {});
/// The same for a file that an experiment of the project `folder` uses: one of another project, as those that come with the
/// program are, is named as its own project names it, "robots/amr.sim".
[[nodiscard]] std::string shownInProject(const std::string& absolute, const std::string& folder);

/// Whether a file is really below one of the folders: links on the way are followed, and one that leads to nothing yet is none of
/// theirs. `file` and the folders are absolute.
[[nodiscard]] bool liesInside(const std::string& file, const std::vector<std::string>& folders);

class FileSearch {
public:
    /// Folders after the importing file's own, in order. A path of `texts`, which outlives this, is found like a file.
    explicit FileSearch(std::vector<std::string> folders, const TextOverlay* texts = nullptr)
        : m_folders(std::move(folders)), m_texts(texts) {}

    /// The file (symlinks resolved) that `written` means in a text that lies in `folder`. `endings` are tried where none fits
    /// as written. Fails with E308 (places looked at, nearest names), E311 (outside the folders) or E322 (no plain file).
    [[nodiscard]] Result<std::string> find(std::string written, const std::string& folder,
                                           std::span<const std::string> endings = {}) const;
    /// Names of files near the one that is missing, best first, as they would be written.
    [[nodiscard]] std::vector<std::string> nearest(std::string written, const std::string& folder) const;

private:
    [[nodiscard]] std::vector<std::string> roots(const std::string& folder) const;
    [[nodiscard]] bool onlyAsText(const std::string& path, std::string& canonical) const;
    std::vector<std::string> m_folders;
    const TextOverlay* m_texts;
};

/// The bytes of a plain file. Never blocks: pipes, devices and folders are refused.
[[nodiscard]] Result<std::string> readFile(const std::string& path, std::size_t most);

} // namespace trundle
