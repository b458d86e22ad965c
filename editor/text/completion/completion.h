#pragma once
// Computes completions at an offset of a text, without widgets. Uses the parser's error recovery and the tokens, so it also
// works on texts with errors.

#include <string>
#include <string_view>
#include <vector>

#include "editor/text/completion/completion_item.h"
#include "editor/text/symbols/project_files.h"
#include "project/loading/project.h"

namespace trundle {

struct Completions {
    TextRange word; ///< the part typed so far, which is replaced
    std::vector<Completion> items;
};

/// `folders`: search folders for texts and modules in addition to the text's own folder and the project's.
[[nodiscard]] Completions completionsAt(const LoadedProject& loaded, FileId file, std::uint32_t offset,
                                        const FileFolders& folders);

/// The items that match the typed letters, best first: prefixes, then substrings, then subsequences.
[[nodiscard]] std::vector<const Completion*> fitting(const std::vector<Completion>& items, std::string_view typed);

} // namespace trundle
