#pragma once
// The trees of one load and how they hang together: what resolving starts from.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "lang/tree.h"

namespace trundle {

/// One `--set PATH=VALUE`, read as a text of its own named `--set#N`, so that errors point into what was typed.
struct SetText {
    FileId file = kNoFile;
    const AssignmentItem* item = nullptr; ///< nullptr: it is not one assignment (already said)
};

/// Immutable once loaded; items are pointed to, so the trees are kept alive here.
struct TextSet {
    std::vector<std::shared_ptr<const Tree>> trees;        ///< by FileId; [0] is the opened file
    std::unordered_map<const ImportItem*, FileId> imports; ///< those that were found
    std::vector<SetText> sets;
    FileId firstSet = kNoFile; ///< files from here on are --set texts
    bool openModules = false;  ///< a module's kinds are not known: unknown blocks in robots stay raw text

    [[nodiscard]] bool commandLine(FileId file) const { return file != kNoFile && file >= firstSet; }
    [[nodiscard]] std::string_view slice(FileId file, TextRange range) const { return trees[file]->source().slice(range); }
    [[nodiscard]] std::string_view slice(const SourceRange& r) const {
        return r.known() ? slice(r.file, r.range) : std::string_view();
    }
};

inline constexpr std::size_t kMaxObjects = 200000;

} // namespace trundle
