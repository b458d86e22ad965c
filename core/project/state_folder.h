#pragma once
#include <string>
#include <vector>

namespace trundle {

/// The folder of this user in which the program keeps what belongs to no project: $XDG_STATE_HOME/trundle, else
/// ~/.local/state/trundle, else one below the folder for temporary files. It need not exist yet.
[[nodiscard]] std::string userStateFolder();

/// Where the program may keep what it needs to remember of a project (journals, the lock), best first: `.trundle` in the project's
/// folder, then a folder of the user's own for this project. A folder that is no marked project gets no `.trundle`, since
/// that would make a project of everything below it.
[[nodiscard]] std::vector<std::string> workFolders(const std::string& projectFolder);
/// The first of them that can be written, made where it is missing; "" where none can.
[[nodiscard]] std::string makeWorkFolder(const std::string& projectFolder);
/// Removes one that is empty, unless it is what marks the project.
void tidyWorkFolder(const std::string& folder);

} // namespace trundle
