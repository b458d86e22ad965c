#pragma once
#include <string>
#include <vector>

#include "control/host/symbolizer.h"

namespace trundle {

/// The calls in a report of Python's fault handler, innermost first, without those of the package that calls the controllers. The
/// report may be damaged.
[[nodiscard]] std::vector<SourceFrame> framesOfPython(const std::string& report);

} // namespace trundle
