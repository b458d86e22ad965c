#pragma once
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "schema/kind.h"

namespace trundle {

/// All kinds by role, one per line.
[[nodiscard]] std::string manualList(const std::vector<const Kind*>& kinds);
/// The full description of one kind.
[[nodiscard]] std::string manualPage(const Kind& kind);
[[nodiscard]] nlohmann::ordered_json manualJson(const Kind& kind);

} // namespace trundle
