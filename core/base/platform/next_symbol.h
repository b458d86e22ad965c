#pragma once

namespace trundle {

/// The definition of a symbol in the shared libraries of this program, where the program has one of its own; nullptr: none of them does.
[[nodiscard]] void* nextSymbol(const char* name);

} // namespace trundle
