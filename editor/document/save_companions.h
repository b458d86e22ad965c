#pragma once
// What lies beside a project's texts and goes along when they are written elsewhere. Private to editor/document.

#include <string>
#include <vector>

#include "parts/parts.h"

namespace trundle {

/// A file that a text names, as written there.
struct NamedThere {
    FileId text = kNoFile;
    std::string written;
    TextRange range;  ///< of the words; of a mesh one of the places
    std::string path; ///< of the file, absolute
    bool module = false;
};

/// All that the texts of a load name and that was found, but for texts; modules also where their folder is not trusted.
[[nodiscard]] std::vector<NamedThere> namedBy(const Loaded& loaded, const Parts& parts, const OpenOptions& options);
/// The library that a #loadModule of a text in `folder` means; "" where there is none.
[[nodiscard]] std::string libraryOf(const std::string& written, const std::string& folder, const Parts& parts,
                                    const OpenOptions& options);
/// Files that belong to one and are nothing without it: a module's description, the buffers of a glTF file. Relative to its folder.
[[nodiscard]] std::vector<std::string> partsOf(const NamedThere& file);
/// Every place in a tree where a value is these words.
[[nodiscard]] std::vector<TextRange> placesOf(const Tree& tree, const std::string& words);

} // namespace trundle
