#pragma once
// The description file of a module, `<library>.kinds.json`: its kinds, readable without running its code.

#include <string>
#include <vector>

#include "base/result.h"
#include "project/loading/sources.h"
#include "schema/kind.h"

namespace trundle {

[[nodiscard]] std::string kindsToJson(const std::vector<Kind>& kinds);
/// Fails with E408 and the position if a text is not a valid description.
[[nodiscard]] Result<std::vector<Kind>> kindsFromJson(const std::string& text, const std::string& library);

} // namespace trundle
