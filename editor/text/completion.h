#pragma once
// Computes completions at an offset of a text, without widgets. Uses the parser's error recovery and the tokens, so it also
// works on texts with errors.

#include <string>
#include <string_view>
#include <vector>

#include "editor/text/project_files.h"
#include "project/project.h"

namespace trundle {

enum class CompletionSort { Key, Kind, Word, Value, Reference, Param, Unit, File };

struct Completion {
    CompletionSort sort = CompletionSort::Word;
    std::string label;                 ///< as listed, and as matched against the typed letters
    std::string insert;                ///< replaces Completions::word
    std::size_t select = 0, caret = 0; ///< selection in `insert` after insertion: from `select` to `caret`
    std::string detail;                ///< short: "m", "Material"
    std::string help;                  ///< one or two lines
    bool hasMore = false;              ///< more can be completed after it
};

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
