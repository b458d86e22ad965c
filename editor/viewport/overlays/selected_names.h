#pragma once
#include <algorithm>
#include <string_view>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/viewport/context/view_context.h"
#include "model/robot_path.h"

namespace trundle {

/// Whether something is selected by its path, "row_3.goal", or by that of all members of a Repeat, Grid or Scatter, "row.goal".
/// `isOther`: whether something beside it has a name.
template <class IsOther>
[[nodiscard]] bool isSelected(const ViewContext& context, std::string_view name, const IsOther& isOther) {
    const LoadedProject* loaded = context.document.loaded().get();
    const auto isOwn = [&](std::string_view other) { return isOther(other) || (loaded && IsOwnName{*loaded->outline}(other)); };
    return std::ranges::any_of(context.selection.paths(), [&](const std::string& path) { return isNamedBy(name, path, isOwn); });
}
/// For `isOther`: joints, or springs, of a robot.
template <class Specs> [[nodiscard]] auto isNameOfAny(const RobotSpec& robot, const Specs& specs) {
    return [&](std::string_view name) {
        return startsWithPath(name, robot.name) &&
               std::ranges::any_of(specs, [&](const auto& spec) { return name == pathInside(robot.name, spec.name); });
    };
}
/// The same of something at the top level.
[[nodiscard]] inline bool isSelected(const ViewContext& context, std::string_view name) {
    return isSelected(context, name, [](std::string_view) { return false; });
}

} // namespace trundle
