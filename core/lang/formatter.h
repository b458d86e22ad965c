#pragma once
#include <string>

#include "lang/tree.h"

namespace trundle {

/// The tree's text in the standard style: two spaces of indent per block, no trailing spaces, one final newline. Comments,
/// one-line blocks and values are kept as written. format(parse(format(t))) == format(t). A text with syntax errors is returned
/// unchanged.
[[nodiscard]] std::string format(const Tree& tree);

} // namespace trundle
