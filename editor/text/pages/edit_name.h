#pragma once
#include <string>
#include <string_view>

#include <QString>

#include "lang/text_splice.h"

namespace trundle {

/// The name of a typing entry in the history: “Type ‘Sped’ at drive.sim:12”. `after` is the text after the change, `file` a file name
/// without folder.
[[nodiscard]] QString typedName(const TextSplice& change, std::string_view after, const std::string& file);

} // namespace trundle
