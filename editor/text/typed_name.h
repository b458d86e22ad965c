#pragma once
#include <string>
#include <string_view>

#include <QString>

namespace trundle {

/// What the history says of typing: “Type ‘Sped’ at drive.sim:12”. `file` is the file's name without its folder.
[[nodiscard]] QString typedName(std::string_view before, std::string_view after, const std::string& file);

} // namespace trundle
