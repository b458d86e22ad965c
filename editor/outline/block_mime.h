#pragma once
// Objects on the clipboard and in drags: encoded as the text of their blocks, so that any text editor can read and return them.

#include <functional>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "editor/outline/library_item.h"
#include "project/loading/project.h"

class QMimeData;

namespace trundle {

inline constexpr const char* kLibraryMime = "application/x-trundle-library"; ///< JSON {"kind", "text", "imports" ...}

/// A config, material, surface or pattern that blocks refer to. It is inserted with them if the target has none of that name.
struct NeededBlock {
    std::string path, text; ///< "RobotConfig.Rover"
};

/// Blocks to insert.
struct Blocks {
    std::string text;                 ///< as pasted, with its #import and #loadModule lines
    std::vector<std::string> kinds;   ///< of the blocks, in order
    std::vector<std::string> names;   ///< of the blocks as written; "" for a block without a name
    std::vector<std::string> imports; ///< files and modules that they need: "robots/simple_robot.sim", "#loadModule ..."
    std::vector<NeededBlock> needs;   ///< blocks that only the source file contains
    std::vector<std::string> params;  ///< top-level Params, "Param side = 3"; inserted if the target has none of that name
    std::string from;                 ///< opened file of the source window; "" if there is none
};

/// Parses a pasted text: blocks, with the directives that they need. If it is something else, fails with a reason for the user.
[[nodiscard]] Result<Blocks> blocksFrom(const std::string& text);

/// Plain text for other editors; for other Trundle windows also the blocks that it refers to, or the files that contain them.
[[nodiscard]] QMimeData* mimeOf(const LoadedProject& loaded, const std::vector<std::string>& paths);
/// `text`: of the item, made for the selection if it has none of its own. Without plain text.
[[nodiscard]] QMimeData* libraryMime(const LibraryItem& item, const std::string& text);

using MayImport = std::function<bool(const std::string& file)>; ///< absolute
/// Decodes what is dropped or pasted. Blocks of files that cannot be imported here are inserted as text instead. Fails if there
/// is nothing to insert.
[[nodiscard]] Result<Blocks> blocksIn(const QMimeData& mime, const MayImport& mayImport);

} // namespace trundle
