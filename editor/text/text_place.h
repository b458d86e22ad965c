#pragma once
// What stands round an offset of a text: its blocks, what they are, whose parts their references mean.

#include <span>
#include <string>
#include <vector>

#include "project/project.h"

namespace trundle {

struct TextPlace {
    FileId file = kNoFile;
    std::uint32_t offset = 0;
    std::vector<const BlockItem*> blocks; ///< outermost first; empty: the top level
    std::vector<const Part*>
        parts; ///< those of `blocks`, and of the blocks the file is imported into; may be fewer where a text is broken
    const Item* item = nullptr;     ///< innermost one that holds or touches the offset
    const Kind* kind = nullptr;     ///< of the innermost block, or the settings; nullptr: there is no such kind
    const Part* config = nullptr;   ///< whose parts are meant by references here
    const Part* instance = nullptr; ///< the innermost block is this Robot, Static, Grid or Scatter

    [[nodiscard]] const BlockItem* block() const { return blocks.empty() ? nullptr : blocks.back(); }
    [[nodiscard]] const std::vector<Item>& items(const Loaded& loaded) const {
        return block() ? block()->items : loaded.trees[file]->items();
    }
};

[[nodiscard]] TextPlace placeAt(const Loaded& loaded, FileId file, std::uint32_t offset);
/// What a key as written at a place sets; in an instance also a path into its config. nullptr where it is none.
[[nodiscard]] const Property* propertyOf(const TextPlace& place, std::span<const std::string> path);
/// The words of an assignment's key.
[[nodiscard]] std::vector<std::string> keyOf(const AssignmentItem& assignment);
/// Every Param that can be seen there, the innermost of a name first.
[[nodiscard]] std::vector<const PlacedParam*> paramsAt(const Loaded& loaded, const TextPlace& place);

} // namespace trundle
