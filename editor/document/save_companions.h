#pragma once
// Finds the files (meshes, images, modules) that must be copied when a project is saved elsewhere. Private to
// editor/document.

#include <string>
#include <vector>

#include "app/application.h"

namespace trundle {

/// A file that a text refers to, as written there.
struct NamedThere {
    FileId text = kNoFile;
    std::string written;
    TextRange range;  ///< range of the reference in the text; for a mesh one of several
    std::string path; ///< absolute path of the file
    bool module = false;
};

/// All files other than texts that the loaded texts refer to and that were found; also modules in folders that are not
/// trusted.
[[nodiscard]] std::vector<NamedThere> namedBy(const LoadedProject& loaded, const Application& parts, const OpenOptions& options);
/// Path of the library that a #loadModule in a text of `folder` resolves to; "" if it is not found.
[[nodiscard]] std::string libraryOf(const std::string& written, const std::string& folder, const Application& parts,
                                    const OpenOptions& options);
/// Files that a file needs: a module's description, the buffers of a glTF file. Relative to its folder.
[[nodiscard]] std::vector<std::string> partsOf(const NamedThere& file);
/// Every range in a syntax tree where a value has exactly this text.
[[nodiscard]] std::vector<TextRange> placesOf(const Tree& tree, const std::string& words);

} // namespace trundle
