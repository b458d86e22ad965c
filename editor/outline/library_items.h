#pragma once
// Sources of library items. The functions read files, so callers run them on a worker thread.

#include "editor/outline/library_item.h"
#include "schema/kind.h"

namespace trundle {

class Tree;
struct BlockItem;

/// A folder of .sim files, and the prefix of the paths under which an #import finds them: "robots/" for configs/robots.
struct LibraryFolder {
    std::string path, imports;
};

/// An item for each RobotConfig and StaticConfig at the top level of the .sim files below a folder. Files that cannot be read,
/// files beyond the limits on number and size, and the file `except` are skipped.
[[nodiscard]] std::vector<LibraryItem> configItems(const LibraryFolder& folder, const std::string& except = {});
/// An item for each .sim file in a folder, with its blocks unchanged. The first comment has the form "Title: description."
[[nodiscard]] std::vector<LibraryItem> snippetItems(const std::string& folder);
/// Kinds that can be inserted on their own.
[[nodiscard]] std::vector<LibraryItem> kindItems(const std::vector<const Kind*>& kinds);
/// Controllers and devices of modules in the program's folder, with the #loadModule that they need.
[[nodiscard]] std::vector<LibraryItem> moduleItems(const std::vector<Kind>& kinds, const std::string& moduleFolder);

/// An experiment that shows one config of an open text, with only the parts of the text that it needs.
[[nodiscard]] std::string pictureOfConfig(const Tree& tree, const BlockItem& config);

/// Default instance name of a config: "simpleRobot" for "SimpleRobot".
[[nodiscard]] std::string nameFor(const std::string& config);

} // namespace trundle
