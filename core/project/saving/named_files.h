#pragma once
// The files (meshes, images, modules) that texts refer to, which must be copied when a project is saved elsewhere.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "project/loading/loaded_project.h"
#include "project/loading/sources.h"

namespace trundle {

/// A reference to a file other than a text.
struct NamedFileUse {
    FileId text = kNoFile;
    std::string written;
    TextRange range;  ///< range of the reference in the text; for a mesh one of several
    std::string path; ///< absolute path of the file
    bool module = false;
};

/// All files other than texts that the loaded texts refer to and that were found; `modules` decides which libraries are found.
[[nodiscard]] std::vector<NamedFileUse> namedFiles(const LoadedProject& loaded, ModuleCatalog& modules);
/// Path of the library that a #loadModule in a text of `folder` resolves to; "" if it is not found.
[[nodiscard]] std::string libraryOf(const std::string& written, const std::string& folder, ModuleCatalog& modules);
/// Files that a file needs: a module's description, the buffers of a glTF file. Relative to its folder.
[[nodiscard]] std::vector<std::string> neededBy(const NamedFileUse& file);
/// Where values of the texts name files: in properties that are files, and in Params that such a property has. By text and words.
using FileWords = std::map<std::pair<FileId, std::string>, std::vector<TextRange>>;
[[nodiscard]] FileWords fileWordsIn(const LoadedProject& loaded);

} // namespace trundle
