#pragma once
// Objects outside the program: as the text of their blocks, so that any editor can take them and give them back.

#include <functional>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "project/project.h"

class QMimeData;

namespace trundle {

inline constexpr const char* kLibraryMime = "application/x-trundle-library"; ///< JSON {"kind", "text", "imports" ...}

/// A config, material, surface or pattern that blocks name. It goes in with them where nothing of that name is there.
struct NeededBlock {
    std::string path, text; ///< "RobotConfig.Rover"
};

/// Blocks to be inserted.
struct Blocks {
    std::string text;                 ///< as given, with its #import and #loadModule lines
    std::vector<std::string> kinds;   ///< of the blocks, in order
    std::vector<std::string> names;   ///< as written; "" where a block has none
    std::vector<std::string> imports; ///< further files that they need: "robots/simple_robot.sim", "#loadModule ..."
    std::vector<NeededBlock> needs;   ///< that no file but the one they come from has
    std::vector<std::string> params;  ///< of its top level, "Param side = 3": they go in where there is none of that name
    std::string from;                 ///< opened file of the window they come from; "" where they come from none
};

/// Reads a text that somebody pasted: blocks, with the directives that they need. Fails with the reason, in words for people,
/// where it is something else.
[[nodiscard]] Result<Blocks> blocksFrom(const std::string& text);

/// Text for other editors; for other windows of ours also what it names: the files that hold that, or its blocks.
[[nodiscard]] QMimeData* mimeOf(const Loaded& loaded, const std::vector<std::string>& paths);
[[nodiscard]] QMimeData* libraryMime(const std::string& kind, const std::string& text, const std::vector<std::string>& imports);

using MayImport = std::function<bool(const std::string& file)>; ///< absolute
/// What a drop or a paste brings. Blocks whose files may not be imported here come themselves instead. Fails where it brings
/// nothing of the kind.
[[nodiscard]] Result<Blocks> blocksIn(const QMimeData& mime, const MayImport& mayImport);

} // namespace trundle
