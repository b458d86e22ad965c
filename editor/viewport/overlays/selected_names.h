#pragma once
#include <algorithm>
#include <string_view>

#include "editor/document/selection.h"
#include "model/robot_path.h"

namespace trundle {

/// Whether something is selected by its path, "row_3.goal", or by that of all members of a Repeat, Grid or Scatter, "row.goal".
[[nodiscard]] inline bool isSelected(const Selection& selection, std::string_view name) {
    return std::ranges::any_of(selection.paths(), [&](const std::string& path) { return isNamedBy(name, path); });
}

} // namespace trundle
