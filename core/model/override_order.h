#pragma once
// Which of the values that blocks around an object set for it holds. One rule, the same as where the resolver lays overrides over
// each other (resolve/part_expansion.cpp): that of one member of a Repeat before that of all, of the innermost Repeat first; else
// that of the outermost block.

#include <span>
#include <string>
#include <vector>

#include "model/part.h"

namespace trundle {

/// One word of a path to a value.
struct OverrideWord {
    std::string name;
    std::string all; ///< of a member of a Repeat, `roller_3`, the name of that, `roller`; else empty
};

/// A block that sets values of what is inside it: a Robot, Static, Grid, Scatter, Part or variant.
struct OverrideLayer {
    const Part* instance = nullptr;
    std::size_t first = 0; ///< the word of the path that its keys begin with
};

struct FoundOverride {
    const SourceAssignment* assignment = nullptr;
    std::size_t layer = 0;
};

/// The overrides for a path; the first one holds. `layers`: outermost first, a variant before what it is a variant of.
[[nodiscard]] std::vector<FoundOverride> overridesFor(std::span<const OverrideWord> path, std::span<const OverrideLayer> layers);

} // namespace trundle
