#pragma once
#include <string>
#include <string_view>

#include <QString>

namespace trundle {

/// The name of a typing entry in the history: “Type ‘Sped’ at drive.sim:12”. `file` is a file name without folder.
[[nodiscard]] QString typedName(std::string_view before, std::string_view after, const std::string& file);

} // namespace trundle
