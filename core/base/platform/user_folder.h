#pragma once
#include <string>

namespace trundle {

/// The home folder of this user: $HOME if it is an absolute path, otherwise from the system's user database. "" if there is none.
[[nodiscard]] std::string homeFolder();

/// A new folder for temporary files, accessible only to this user; the same for the whole process. "" if it cannot be created.
/// Its name is unpredictable, so no other user can have created it before.
[[nodiscard]] const std::string& privateTemporaryFolder();

} // namespace trundle
