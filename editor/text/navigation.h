#pragma once
// Where the things that a text names are given, and who names them.

#include <optional>
#include <string>
#include <vector>

#include "project/project.h"

namespace trundle {

struct Definition {
    SourceRange place; ///< the name where it is given; the beginning of an imported file
    SourceRange word;  ///< the characters asked about
    std::string name;
};

/// What the word at an offset names: a block, a Param, a file. On the name of a block or Param itself it is that.
[[nodiscard]] std::optional<Definition> definitionAt(const Loaded& loaded, FileId file, std::uint32_t offset);
/// What a rename at an offset means.
struct Symbol {
    std::string path; ///< of the block or Param, as planRename() takes it
    std::string name;
    SourceRange word; ///< the name's characters there
};
/// The block or Param that is given or named at an offset; nothing on other words.
[[nodiscard]] std::optional<Symbol> symbolAt(const Loaded& loaded, FileId file, std::uint32_t offset);
/// Every place that names the same, in order of files; the place where it is given comes first.
[[nodiscard]] std::vector<SourceRange> usesAt(const Loaded& loaded, FileId file, std::uint32_t offset);

} // namespace trundle
