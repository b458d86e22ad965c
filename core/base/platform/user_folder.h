#pragma once
#include <string>

namespace trundle {

/// The home folder of this user: $HOME where it is an absolute path, else what the system says. "" where there is none.
[[nodiscard]] std::string homeFolder();

/// A new folder for temporary files that only this user may look into; the same each time within a process. "" where none can be
/// made. Its name cannot be known before, so nobody else can have put something there.
[[nodiscard]] const std::string& privateTemporaryFolder();

} // namespace trundle
