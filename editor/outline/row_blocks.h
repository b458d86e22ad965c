#pragma once
#include <utility>
#include <vector>

#include "model/part.h"

namespace trundle {

/// The blocks below the row of a block, and whether they are in the config that it uses, `config`, or is a variant of. Its own are the
/// last ones; `isReached`: they are in a config, too.
[[nodiscard]] std::vector<std::pair<const Part*, bool>> blocksBelow(const Part& block, const Part* config, bool isReached);

} // namespace trundle
