#pragma once
#include <string>
#include <vector>

namespace trundle {

struct LoadedProject;

/// Whether an object moves with one of `others`: it is in that, or it, or what it is in, counts from that by In. Paths as in
/// object_location.h.
[[nodiscard]] bool movesWith(const LoadedProject& loaded, const std::string& path, const std::vector<std::string>& others);

} // namespace trundle
