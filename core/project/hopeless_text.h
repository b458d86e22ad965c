#pragma once
// Whether a large text of which only the beginning was read is so wrong that the rest need not be read.

#include "base/diagnostic.h"
#include "lang/tree.h"

namespace trundle {

/// True where at least 500 of the errors would stay whatever the unread rest of `tree` brings: names that it does not define, values that
/// it does not override, kinds that no module of it brings. The rest is scanned once, and only if there are so many errors.
[[nodiscard]] bool isHopeless(const Tree& tree, const Diagnostics& diagnostics);

/// Says how much of it is not read.
[[nodiscard]] Diagnostic restUnread(const Tree& tree);

} // namespace trundle
