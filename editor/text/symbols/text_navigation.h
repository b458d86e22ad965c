#pragma once
// Go to definition, find references, and the symbol to rename.

#include <optional>
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

struct Definition {
    SourceRange place; ///< the name in the definition; the beginning of an imported file
    SourceRange word;  ///< range of the word at the offset
    std::string name;
};

/// The definition of the name at an offset: a block, a Param or a file. On a definition's own name, that definition.
[[nodiscard]] std::optional<Definition> definitionAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);
/// The object that a rename at an offset applies to.
struct Symbol {
    std::string path; ///< of the block or Param, as for planRename()
    std::string name;
    SourceRange word; ///< range of its name at the offset
};
/// The block or Param defined or referenced at an offset; nothing for other words.
[[nodiscard]] std::optional<Symbol> symbolAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);
/// Ranges of all references to the same object, in order of files; its definition comes first.
[[nodiscard]] std::vector<SourceRange> usesAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);

} // namespace trundle
