#pragma once
#include <string>
#include <vector>

namespace trundle {

/// This user's folder for program state that belongs to no project: $XDG_STATE_HOME/trundle, else ~/.local/state/trundle, else a
/// new folder inside the one for temporary files. It may not exist yet.
[[nodiscard]] std::string userStateFolder();

/// This user's folder for state of one project that must not be distributed with it: its journals. It may not exist yet.
[[nodiscard]] std::string projectStateFolder(const std::string& projectFolder);

/// Candidate folders for the lock of a project, best first: `.trundle` in the project's folder, where all users see it, unless
/// that is a symbolic link; then projectStateFolder(). A folder without a project marker gets no `.trundle`, since that would
/// turn everything below it into a project.
[[nodiscard]] std::vector<std::string> workFolders(const std::string& projectFolder);
/// The first of them that is writable, created if missing; "" if there is none.
[[nodiscard]] std::string makeWorkFolder(const std::string& projectFolder);
/// Removes an empty work folder, unless it is the project's marker.
void tidyWorkFolder(const std::string& folder);

} // namespace trundle
