#pragma once
#include <cstddef>
#include <cstdint>

namespace trundle {

/// Of the whole run.
struct EngineSolves {
    /// Solved by the quick solver: all with Solver = quick, those with large clusters with auto, and those that the exact one failed on.
    std::uint64_t quickTicks = 0;
    std::uint64_t rescuedTicks = 0; ///< that the exact solver could not solve at the first attempt, whatever the outcome
    /// Most contacts in a cluster that the exact solver has solved because of Solver = exact; counted only above kExactClusterMax.
    std::size_t largestExactCluster = 0;
};

} // namespace trundle
