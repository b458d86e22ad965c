#pragma once
#include <string>

#include "lang/tree.h"

namespace trundle {

/// The tree's text in the house style: indent by two blanks per block, no trailing blanks, one final newline, comments and the author's
/// choice of one-line or many-line blocks kept, values untouched. format(parse(format(t))) == format(t). A text with syntax errors
/// comes back as it is.
[[nodiscard]] std::string format(const Tree& tree);

} // namespace trundle
