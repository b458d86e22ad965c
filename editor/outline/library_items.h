#pragma once
// Where the things in the Library come from. Files are read here, so callers do it beside the GUI.

#include "editor/outline/library_item.h"
#include "schema/kind.h"

namespace trundle {

class Tree;
struct BlockItem;

/// A folder of texts, and the start of the paths under which an #import finds them: "robots/" for configs/robots.
struct LibraryFolder {
    std::string path, imports;
};

/// An item for each RobotConfig and StaticConfig that stands at the top level of the .sim files below a folder. Files that
/// cannot be read, or are too many or too large for a library, give none, nor does the file `except`.
[[nodiscard]] std::vector<LibraryItem> configItems(const LibraryFolder& folder, const std::string& except = {});
/// An item for each .sim file in a folder: its blocks as they are. The first comment says "Title: what it is."
[[nodiscard]] std::vector<LibraryItem> snippetItems(const std::string& folder);
/// Kinds that can be put in by themselves.
[[nodiscard]] std::vector<LibraryItem> kindItems(const std::vector<const Kind*>& kinds);
/// Controllers and devices of modules that lie in the program's folder, with the #loadModule that they need.
[[nodiscard]] std::vector<LibraryItem> moduleItems(const std::vector<Kind>& kinds, const std::string& moduleFolder);

/// An experiment that shows a config of a text that is open, with what of the text it may need and nothing else.
[[nodiscard]] std::string pictureOfConfig(const Tree& tree, const BlockItem& config);

/// "SimpleRobot" as a name for one of it: "simpleRobot".
[[nodiscard]] std::string nameFor(const std::string& config);

} // namespace trundle
