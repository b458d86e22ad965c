#pragma once
#include <string>

namespace trundle {

/// Replaces this program by python3, which runs controllers with the package in `folder`, under the limits of this process. Returns
/// only if that is not possible.
void startPython(const std::string& folder);

} // namespace trundle
