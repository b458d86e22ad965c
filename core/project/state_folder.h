#pragma once
#include <string>
#include <vector>

namespace trundle {

/// The folder of this user in which the program keeps what belongs to no project: $XDG_STATE_HOME/trundle, else
/// ~/.local/state/trundle, else a new one below the folder for temporary files. It need not exist yet.
[[nodiscard]] std::string userStateFolder();

/// The folder of this user for what belongs to one project and must not come with it: its journals. It need not exist yet.
[[nodiscard]] std::string projectStateFolder(const std::string& projectFolder);

/// Where the lock of a project may be, best first: `.trundle` in the project's folder, where all its users see it, unless that is a
/// symbolic link; then projectStateFolder(). A folder that is no marked project gets no `.trundle`, since that would make a project of
/// everything below it.
[[nodiscard]] std::vector<std::string> workFolders(const std::string& projectFolder);
/// The first of them that can be written, made where it is missing; "" where none can.
[[nodiscard]] std::string makeWorkFolder(const std::string& projectFolder);
/// Removes one that is empty, unless it is what marks the project.
void tidyWorkFolder(const std::string& folder);

} // namespace trundle
