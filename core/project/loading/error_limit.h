#pragma once
// Decides whether a large file, of which only the beginning was read, has so many errors that the rest need not be read.

#include "base/diagnostic.h"
#include "lang/tree.h"

namespace trundle {

/// True if at least 500 errors, or 1,000 messages, would remain whatever the unread rest of `tree` contains: names that it does not
/// define, values that it does not override, kinds that none of its modules provides. The rest is scanned once, and only if there are
/// that many.
[[nodiscard]] bool hasTooManyErrors(const Tree& tree, const Diagnostics& diagnostics);

/// True if there are at least 500 errors or 1,000 messages, whatever could still resolve them: of a text beyond a few MiB so many
/// are enough.
[[nodiscard]] bool hasManyMistakes(const Diagnostics& diagnostics);

/// True if there are at least 1,000 warnings and hints, and few errors.
[[nodiscard]] bool hasManyWarnings(const Diagnostics& diagnostics);

/// A diagnostic that states how much of the file was not read.
[[nodiscard]] Diagnostic restUnread(const Tree& tree);

/// The one error of an experiment with more than `most` tokens, at the place in `tree` from where on nothing was read.
[[nodiscard]] Diagnostics tooManyTokens(const Tree& tree, std::size_t most);

} // namespace trundle
