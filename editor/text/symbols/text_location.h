#pragma once
// The context of an offset in a text: enclosing blocks, their kinds, and the config in which references are resolved.

#include <span>
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

struct TextLocation {
    FileId file = kNoFile;
    std::uint32_t offset = 0;
    std::vector<const BlockItem*> blocks; ///< outermost first; empty: the top level
    std::vector<const Part*>
        parts;                  ///< parts of `blocks`, and of the blocks that import the file; may be fewer in a text with errors
    const Item* item = nullptr; ///< innermost one that contains or touches the offset
    const Kind* kind = nullptr; ///< of the innermost block, or the settings; nullptr: unknown kind
    const Part* config = nullptr;   ///< the config in which references are resolved here
    const Part* instance = nullptr; ///< the innermost block if it is a Robot, Static, Grid or Scatter

    [[nodiscard]] const BlockItem* block() const { return blocks.empty() ? nullptr : blocks.back(); }
    /// The Param between whose braces the offset is; nullptr: none.
    [[nodiscard]] const ParamItem* described() const;
    [[nodiscard]] const std::vector<Item>& items(const LoadedProject& loaded) const {
        return block() ? block()->items : loaded.trees[file]->items();
    }
};

/// Also at its end: where the caret is after a word.
[[nodiscard]] inline bool touches(TextRange range, std::uint32_t offset) { return range.begin <= offset && offset <= range.end; }
[[nodiscard]] TextLocation placeAt(const LoadedProject& loaded, FileId file, std::uint32_t offset);
/// The property that a key sets there; in an instance the key may be a path into its config. nullptr if there is none.
[[nodiscard]] const Property* propertyOf(const TextLocation& place, std::span<const std::string> path);
/// The components of an assignment's key.
[[nodiscard]] std::vector<std::string> keyOf(const AssignmentItem& assignment);
/// All Params in scope, the innermost of a name first.
[[nodiscard]] std::vector<const SourceParam*> paramsAt(const LoadedProject& loaded, const TextLocation& place);

} // namespace trundle
