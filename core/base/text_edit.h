#pragma once
#include <string>

#include "base/source_range.h"

namespace trundle {

/// Replaces the bytes of `range` by `text`. An empty range inserts, an empty text removes.
struct TextEdit {
    SourceRange range;
    std::string text;
};

} // namespace trundle
