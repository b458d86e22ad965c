#pragma once

namespace trundle {

/// As ODE hands it over. A row with `normals` >= 0 is friction: its bounds are its `high` times what that row has, in the same solution.
struct IslandRows {
    unsigned rows;
    const double* matrix; ///< lower triangle, row after row
    unsigned stride;
    const double* bounds; ///< pairs of low and high
    const int* normals;   ///< may be null
};

} // namespace trundle
