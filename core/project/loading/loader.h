#pragma once
// Opens a file and everything it imports, each file once, within the limits of the language.

#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.h"
#include "model/text_set.h"
#include "project/loading/loaded_project.h"
#include "project/loading/search.h"
#include "project/loading/text_overlay.h"

namespace trundle {

/// After this many missing imports or modules the others are not searched for, since that would take minutes.
inline constexpr std::size_t kMaxNotFound = 500;

inline constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxFiles = 1000;
inline constexpr int kMaxImportDepth = 32;

/// A #loadModule directive, in text order.
struct ModuleReference {
    std::string written;
    std::string folder; ///< of the file that contains it
    SourceRange range;  ///< of the path
};

/// Sources of text besides the disk, and settings of a load.
struct LoadOptions {
    const TextOverlay* texts = nullptr;      ///< used instead of the files on disk
    const LoadedProject* previous = nullptr; ///< its trees are reused if still valid
    /// Displayed paths are relative to this folder. Empty: the opened file as given, others relative to the current folder.
    std::string shownFrom;
    std::size_t mostTokens = static_cast<std::size_t>(-1); ///< limit for all files together; the rest is not read
};

/// The single assignment of a `--set` text; nullptr, with a diagnostic, if it is anything else.
[[nodiscard]] const AssignmentItem* assignmentOf(const Tree& tree, Diagnostics& diagnostics);

class Loader {
public:
    Loader(const FileSearch& search, Diagnostics& diagnostics, LoadOptions options = {})
        : m_search(search), m_diagnostics(diagnostics), m_options(std::move(options)) {}

    /// Fails only if the file itself cannot be read; faults of its imports are reported as diagnostics.
    [[nodiscard]] Status open(const std::string& path);
    /// Reads `--set` texts. Must be called after open().
    void addSets(const std::vector<std::string>& sets);

    [[nodiscard]] const TextSet& texts() const { return m_texts; }
    [[nodiscard]] TextSet takeTexts() { return std::move(m_texts); }
    [[nodiscard]] const SourceTable& sources() const { return m_sources; }
    [[nodiscard]] const std::vector<ModuleReference>& modules() const { return m_modules; }
    /// Absolute paths by FileId; "" for a `--set` text.
    [[nodiscard]] std::vector<std::string> takePaths() { return std::move(m_paths); }
    [[nodiscard]] std::size_t parses() const { return m_parses; }
    /// The first file that mostTokens truncated; kNoFile if all files were read completely.
    [[nodiscard]] FileId limitedFile() const { return m_limited; }
    /// Folders of the files by FileId.
    [[nodiscard]] std::vector<std::string> takeFolders() { return std::move(m_folders); }

private:
    /// Bytes from the overlay or the disk.
    struct Bytes {
        std::string own;
        std::shared_ptr<const std::string> shared;
        [[nodiscard]] std::string_view view() const { return shared ? std::string_view(*shared) : std::string_view(own); }
        [[nodiscard]] std::shared_ptr<const std::string> take() {
            return shared ? shared : std::make_shared<const std::string>(std::move(own));
        }
    };
    /// `path` is the path to read, `absolute` its key in the overlay.
    [[nodiscard]] Result<Bytes> read(const std::string& path, const std::string& absolute, const std::string& shown,
                                     std::size_t most) const;
    [[nodiscard]] std::shared_ptr<const Tree> sameAsBefore(FileId file, const std::string& shown, const std::string& absolute,
                                                           std::string_view bytes) const;
    FileId add(std::string shown, std::string absolute, Bytes bytes, const std::string& folder, SourceRange importedFrom);
    void visit(const std::vector<Item>& items, FileId file, int depth);
    void import(const ImportItem& item, FileId file, int depth);
    [[nodiscard]] std::vector<std::string> importsLike(const std::string& written, FileId file) const;
    void cycle(FileId target, SourceRange range);

    const FileSearch& m_search;
    Diagnostics& m_diagnostics;
    LoadOptions m_options;
    TextSet m_texts;
    SourceTable m_sources;
    std::vector<std::string> m_folders, m_paths;
    std::size_t m_parses = 0;
    std::vector<ModuleReference> m_modules;
    std::unordered_map<std::string, FileId> m_byPath; ///< canonical
    std::vector<FileId> m_open;                       ///< the current chain of imports
    std::size_t m_bytes = 0, m_tokens = 0;
    FileId m_limited = kNoFile;
    std::size_t m_notFound = 0; ///< number of missing imports
    bool m_tooMany = false;
};

} // namespace trundle
