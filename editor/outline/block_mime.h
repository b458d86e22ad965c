#pragma once
// Objects outside the program: as the text of their blocks, so that any editor can take them and give them back.

#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "project/project.h"

class QMimeData;

namespace trundle {

inline constexpr const char* kLibraryMime = "application/x-trundle-library"; ///< JSON {"kind", "text", "imports"}
inline constexpr const char* kObjectsMime = "application/x-trundle-objects"; ///< dotted paths, a line each: of this window

/// Blocks to be inserted.
struct Blocks {
    std::string text;                 ///< as given, with its #import and #loadModule lines
    std::vector<std::string> kinds;   ///< of the blocks, in order
    std::vector<std::string> names;   ///< as written; "" where a block has none
    std::vector<std::string> imports; ///< further files that they need: "robots/simple_robot.sim"
};

/// Reads a text that somebody pasted: blocks, with the directives that they need. Fails with the reason, in words for people,
/// where it is something else.
[[nodiscard]] Result<Blocks> blocksFrom(const std::string& text);

/// Text for other editors, and the files that hold the configs, materials and surfaces that it uses for other windows of ours.
[[nodiscard]] QMimeData* mimeOf(const Loaded& loaded, const std::vector<std::string>& paths);
[[nodiscard]] QMimeData* libraryMime(const std::string& kind, const std::string& text, const std::vector<std::string>& imports);

/// What a drop or a paste brings. Fails where it brings nothing of the kind.
[[nodiscard]] Result<Blocks> blocksIn(const QMimeData& mime);
/// Dotted paths of a drag that began in a tree; empty where it did not.
[[nodiscard]] std::vector<std::string> pathsIn(const QMimeData& mime);

} // namespace trundle
