#pragma once
// Finds imported files in the search folders and checks that they may be opened.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/loading/folder_names.h"
#include "project/loading/text_overlay.h"

namespace trundle {

/// The nearest folder above the file that contains `.trundle/` or is named `configs`, else the file's own folder.
[[nodiscard]] std::string projectFolderOf(const std::string& file);
/// Absolute path, links resolved as far as it exists.
[[nodiscard]] std::string canonicalPath(const std::string& path);
/// The path for display: relative to `from`, or to the current folder if that is empty, if the file is below it; else absolute.
[[nodiscard]] std::string shownPath(const std::string& absolute, const std::string& from = {});
/// The same for a file used by an experiment of the project `folder`: a file of another project, such as a shipped one, is shown
/// relative to that project, "robots/amr.sim".
[[nodiscard]] std::string shownInProject(const std::string& absolute, const std::string& folder);

/// Whether a file is below one of the folders after links are resolved; a dangling link counts as outside. `file` and the folders
/// are absolute.
[[nodiscard]] bool isInside(const std::string& file, const std::vector<std::string>& folders);

/// Whether there can be a file of that name: no part of a path is longer than any file system allows.
[[nodiscard]] bool canBeFile(std::string_view path);

/// Used by one thread, for one load: what links lead to is looked up once for each folder.
class FileSearch {
public:
    /// `folders` are searched in order after the importing file's own. Paths in `texts` count as files; `texts` must outlive this
    /// object.
    explicit FileSearch(std::vector<std::string> folders, const TextOverlay* texts = nullptr)
        : m_folders(std::move(folders)), m_texts(texts) {}

    /// The file (links resolved) that `written` refers to in a file in `folder`. Tries `endings` if there is no file without
    /// them. Fails with E308 (searched folders, or a folder of that name), E311 (outside the folders) or E322 (a pipe, a device).
    [[nodiscard]] Result<std::string> find(std::string written, const std::string& folder,
                                           std::span<const std::string> endings = {}) const;
    /// Similar file names for a missing file, best first, as they would be written: first of all its name with `ending`.
    [[nodiscard]] std::vector<std::string> nearest(std::string written, const std::string& folder,
                                                   const std::string& ending = {}) const;

private:
    struct Roots {
        std::vector<std::string> folders; ///< canonical
        std::string shown;                ///< "a, b", for messages
    };
    [[nodiscard]] const Roots& roots(const std::string& folder) const;
    [[nodiscard]] bool onlyAsText(const std::string& path, std::string& canonical) const;
    std::vector<std::string> m_folders;
    const TextOverlay* m_texts;
    mutable std::map<std::string, Roots> m_roots; ///< by the importing file's folder
    mutable FolderNames m_names;
};

/// The bytes of a regular file. Never blocks: pipes, devices and folders are refused. Messages name the file `shown`, or by its path.
[[nodiscard]] Result<std::string> readFile(const std::string& path, std::size_t most, const std::string& shown = {});

} // namespace trundle
