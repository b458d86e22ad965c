#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace trundle {

/// The length of a C string from a module; empty if there is no terminating zero within `longest` bytes or within readable
/// memory. A module may pass a full array without a terminator, or an invalid pointer; only mapped bytes are read.
[[nodiscard]] std::optional<std::size_t> moduleTextLength(const char* text, std::size_t longest);

/// The name of a port, joint or file. Empty for nullptr. An unterminated name is cut and reported, so that it matches nothing.
[[nodiscard]] std::string moduleName(const char* name);

/// A message text, as much of it as is readable, up to 8 MiB. Empty for nullptr.
[[nodiscard]] std::string moduleMessage(const char* text);

} // namespace trundle
