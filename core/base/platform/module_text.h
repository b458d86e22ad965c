#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace trundle {

/// How long a C string of a module is; nothing where it has no terminating zero within `longest` bytes or within the memory that is
/// there. Code of a module may hand over a fixed array that it filled to the end, or a pointer to nothing: no byte is read that the
/// process does not have.
[[nodiscard]] std::optional<std::size_t> moduleTextLength(const char* text, std::size_t longest);

/// A name of a port, a joint, a file. Empty for nullptr. One without an end is cut and says so, and is then the name of nothing.
[[nodiscard]] std::string moduleName(const char* name);

/// Words for people: as much of them as there is, up to 8 MiB. Empty for nullptr.
[[nodiscard]] std::string moduleWords(const char* text);

} // namespace trundle
