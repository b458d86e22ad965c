#pragma once
#include <optional>
#include <span>
#include <string>

namespace trundle {

/// The path of a file relative to the first of these folders that contains it, links resolved, with `/`: the portable form for a
/// source file. Nothing if no folder contains it; empty folders are skipped.
[[nodiscard]] std::optional<std::string> pathBelow(const std::string& absolute, std::span<const std::string> folders);

} // namespace trundle
