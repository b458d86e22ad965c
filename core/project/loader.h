#pragma once
// Opens a file and all it imports, each once, within the limits of the language.

#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.h"
#include "model/text_set.h"
#include "project/search.h"

namespace trundle {

inline constexpr std::size_t kMaxTextBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxFiles = 1000;
inline constexpr int kMaxImportDepth = 32;

/// A #loadModule as met, in the order of the text.
struct ModuleMention {
    std::string written;
    std::string folder; ///< of the file it stands in
    SourceRange range;  ///< of the path
};

class Loader {
public:
    Loader(const FileSearch& search, Diagnostics& diagnostics) : m_search(search), m_diagnostics(diagnostics) {}

    /// Fails only when the file itself cannot be read; what is wrong with its imports is said at their place.
    [[nodiscard]] Status open(const std::string& path);
    /// Reads `--set` texts. To be called after open().
    void addSets(const std::vector<std::string>& sets);

    [[nodiscard]] const TextSet& texts() const { return m_texts; }
    [[nodiscard]] TextSet takeTexts() { return std::move(m_texts); }
    [[nodiscard]] const SourceTable& sources() const { return m_sources; }
    [[nodiscard]] const std::vector<ModuleMention>& modules() const { return m_modules; }
    /// The folder of a file, by FileId.
    [[nodiscard]] std::vector<std::string> takeFolders() { return std::move(m_folders); }

private:
    FileId add(std::string shown, std::string bytes, const std::string& folder, SourceRange importedFrom);
    void visit(const std::vector<Item>& items, FileId file, int depth);
    void import(const ImportItem& item, FileId file, int depth);
    void cycle(FileId target, SourceRange range);

    const FileSearch& m_search;
    Diagnostics& m_diagnostics;
    TextSet m_texts;
    SourceTable m_sources;
    std::vector<std::string> m_folders;
    std::vector<ModuleMention> m_modules;
    std::unordered_map<std::string, FileId> m_byPath; ///< canonical
    std::vector<FileId> m_open;                       ///< the chain of imports being followed
    std::size_t m_bytes = 0;
    bool m_tooMany = false;
};

} // namespace trundle
