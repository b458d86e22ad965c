#pragma once
// What may stand at a place of a text: pure, no widgets. Works on what the parser recovered of a broken text and on its tokens.

#include <string>
#include <string_view>
#include <vector>

#include "editor/text/project_files.h"
#include "project/project.h"

namespace trundle {

enum class CompletionSort { Key, Kind, Word, Value, Reference, Param, Unit, File };

struct Completion {
    CompletionSort sort = CompletionSort::Word;
    std::string label;                 ///< as listed, and what typed letters are compared with
    std::string insert;                ///< takes the place of Completions::word
    std::size_t select = 0, caret = 0; ///< of `insert`, selected afterwards up to the caret
    std::string detail;                ///< short: "m", "Material"
    std::string help;                  ///< one line or two
    bool goesOn = false;               ///< there is more to complete behind it
};

struct Completions {
    TextRange word; ///< what is typed of it already, or would be replaced
    std::vector<Completion> items;
};

/// `folders` are those of Loaded's texts and modules beside the text's own and the project's.
[[nodiscard]] Completions completionsAt(const Loaded& loaded, FileId file, std::uint32_t offset, const FileFolders& folders);

/// Those that fit the letters typed, best first: as begun, then with its capitals or inner letters.
[[nodiscard]] std::vector<const Completion*> fitting(const std::vector<Completion>& items, std::string_view typed);

} // namespace trundle
