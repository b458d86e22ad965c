#pragma once

#include <vector>

namespace trundle {

/// Solves `count` equations, each followed by its right side, which becomes its solution. False where they are nearly singular.
[[nodiscard]] bool solveDense(std::vector<double>& rows, unsigned count);

} // namespace trundle
