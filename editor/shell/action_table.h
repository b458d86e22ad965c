#pragma once
#include <span>

#include "editor/widgets/actions.h"

namespace trundle {

/// Every action of the window, in the order of the menus.
[[nodiscard]] std::span<const ActionRow> actionTable();

} // namespace trundle
