#pragma once
// The syntax trees of one load and their import relations: the input of the resolver.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "lang/tree.h"

namespace trundle {

/// One `--set PATH=VALUE`, parsed as a source text named `--set#N`, so that diagnostics refer to the argument.
struct SetText {
    FileId file = kNoFile;
    const AssignmentItem* item = nullptr; ///< nullptr: not a single assignment (already reported)
};

/// Immutable once loaded. Keeps the trees alive, since others point to their items.
struct TextSet {
    std::vector<std::shared_ptr<const Tree>> trees;        ///< by FileId; [0] is the opened file
    std::unordered_map<const ImportItem*, FileId> imports; ///< successful imports
    std::vector<SetText> sets;
    FileId firstSet = kNoFile; ///< this file and all later ones are --set texts
    bool openImports = false; ///< some imported file is not there, which is reported: names that are unknown may be defined in it
    bool openModules = false;  ///< some module's kinds are unknown: unknown blocks in robots are kept as raw text

    [[nodiscard]] bool commandLine(FileId file) const { return file != kNoFile && file >= firstSet; }
    [[nodiscard]] std::string_view slice(FileId file, TextRange range) const { return trees[file]->source().slice(range); }
    [[nodiscard]] std::string_view slice(const SourceRange& r) const {
        return r.known() ? slice(r.file, r.range) : std::string_view();
    }
};

inline constexpr std::size_t kMaxObjects = 200000;

} // namespace trundle
