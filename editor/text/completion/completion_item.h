#pragma once
#include <cstddef>
#include <string>

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

} // namespace trundle
