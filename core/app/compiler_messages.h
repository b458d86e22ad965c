#pragma once
// What a build prints, read for errors and warnings with their places.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"

namespace trundle {

struct LoadedProject;

/// A message of a compiler, a linker or CMake.
struct CompilerMessage {
    enum class Kind { Error, Warning, Note };
    Kind kind = Kind::Error;
    std::string file;           ///< as printed
    std::uint32_t line = 0;     ///< from 1; 0: unknown
    std::uint32_t column = 0;   ///< in bytes, from 1; 0: unknown
    std::string text;           ///< empty: it is in the lines that follow, as with CMake
};

/// The message of a line of output, as GCC, Clang, GNU ld, lld and CMake print it; none if it has no message. Linkers also print the place
/// of a reference without a file that could be opened: those have a message without a place.
[[nodiscard]] std::optional<CompilerMessage> compilerMessage(std::string_view line);

/// The messages of a build as diagnostics. `sources` has the texts and paths of the files that they are about, as they were then.
struct BuildMessages {
    std::vector<Diagnostic> found;
    std::shared_ptr<const LoadedProject> sources;
};

/// Reads the output of a build. A relative path is one in `folder`. Of messages about files that `isShown` does not accept, such as
/// headers of the system, the place is dropped and the message stays. Each message is listed once.
[[nodiscard]] BuildMessages readBuildOutput(std::string_view output, const std::string& folder, const std::string& project,
                                            const std::function<bool(const std::string& file)>& isShown);

} // namespace trundle
