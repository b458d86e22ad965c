#pragma once
#include <optional>
#include <span>
#include <string>

namespace trundle {

/// The path of a file from the first of these folders that it lies below, links resolved, with `/`: as a text names it that is meant to
/// work on another machine too. Nothing where it lies below none; empty folders hold nothing.
[[nodiscard]] std::optional<std::string> pathBelow(const std::string& absolute, std::span<const std::string> folders);

} // namespace trundle
