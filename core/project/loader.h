#pragma once
// Opens a file and all it imports, each once, within the limits of the language.

#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.h"
#include "model/text_set.h"
#include "project/project.h"
#include "project/search.h"

namespace trundle {

/// Imports, and modules, that are not found: enough to give up on the rest, as a search for each would take minutes.
inline constexpr std::size_t kMostNotFound = 500;


inline constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxFiles = 1000;
inline constexpr int kMaxImportDepth = 32;

/// A #loadModule as met, in the order of the text.
struct ModuleMention {
    std::string written;
    std::string folder; ///< of the file it stands in
    SourceRange range;  ///< of the path
};

/// Where a load takes its bytes from, beside the disk, and how it names them.
struct LoadOptions {
    const TextOverlay* texts = nullptr; ///< instead of the files
    const Loaded* previous = nullptr;   ///< trees of it that are still right are taken over
    std::string shownFrom;              ///< folder that shown paths start from; empty: the opened file as given, others from here
    std::size_t mostTokens = static_cast<std::size_t>(-1); ///< of all files together; what is behind them is not read
};

/// The one assignment that a `--set` text is; nullptr where it is something else, which is said.
[[nodiscard]] const AssignmentItem* assignmentOf(const Tree& tree, Diagnostics& diagnostics);

class Loader {
public:
    Loader(const FileSearch& search, Diagnostics& diagnostics, LoadOptions options = {})
        : m_search(search), m_diagnostics(diagnostics), m_options(std::move(options)) {}

    /// Fails only when the file itself cannot be read; what is wrong with its imports is said at their place.
    [[nodiscard]] Status open(const std::string& path);
    /// Reads `--set` texts. To be called after open().
    void addSets(const std::vector<std::string>& sets);

    [[nodiscard]] const TextSet& texts() const { return m_texts; }
    [[nodiscard]] TextSet takeTexts() { return std::move(m_texts); }
    [[nodiscard]] const SourceTable& sources() const { return m_sources; }
    [[nodiscard]] const std::vector<ModuleMention>& modules() const { return m_modules; }
    /// Absolute, by FileId; "" for a `--set` text.
    [[nodiscard]] std::vector<std::string> takePaths() { return std::move(m_paths); }
    [[nodiscard]] std::size_t parses() const { return m_parses; }
    /// The first file that mostTokens cut short; kNoFile where all were read.
    [[nodiscard]] FileId limitedFile() const { return m_limited; }
    /// The folder of a file, by FileId.
    [[nodiscard]] std::vector<std::string> takeFolders() { return std::move(m_folders); }

private:
    /// Bytes of the overlay, or of the disk.
    struct Bytes {
        std::string own;
        std::shared_ptr<const std::string> shared;
        [[nodiscard]] std::string_view view() const { return shared ? std::string_view(*shared) : std::string_view(own); }
        [[nodiscard]] std::shared_ptr<const std::string> take() {
            return shared ? shared : std::make_shared<const std::string>(std::move(own));
        }
    };
    /// `path` is what to read, `absolute` what it is called in the overlay.
    [[nodiscard]] Result<Bytes> read(const std::string& path, const std::string& absolute, std::size_t most) const;
    [[nodiscard]] std::shared_ptr<const Tree> sameAsBefore(FileId file, const std::string& shown, const std::string& absolute,
                                                           std::string_view bytes) const;
    FileId add(std::string shown, std::string absolute, Bytes bytes, const std::string& folder, SourceRange importedFrom);
    void visit(const std::vector<Item>& items, FileId file, int depth);
    void import(const ImportItem& item, FileId file, int depth);
    void cycle(FileId target, SourceRange range);

    const FileSearch& m_search;
    Diagnostics& m_diagnostics;
    LoadOptions m_options;
    TextSet m_texts;
    SourceTable m_sources;
    std::vector<std::string> m_folders, m_paths;
    std::size_t m_parses = 0;
    std::vector<ModuleMention> m_modules;
    std::unordered_map<std::string, FileId> m_byPath; ///< canonical
    std::vector<FileId> m_open;                       ///< the chain of imports being followed
    std::size_t m_bytes = 0, m_tokens = 0;
    FileId m_limited = kNoFile;
    std::size_t m_notFound = 0; ///< imports
    bool m_tooMany = false;
};

} // namespace trundle
