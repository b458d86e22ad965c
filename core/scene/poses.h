#pragma once
// Where every robot body stands: from the model until the first tick, from a block of signals afterwards.

#include <cstdint>
#include <vector>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// World poses of all robot bodies: robots in text order, each with its bodies in the order of its config.
using BodyPoses = std::vector<Pose>;

[[nodiscard]] BodyPoses startPoses(const ExperimentSpec& experiment);

/// Finds once where the poses stand in blocks of a layout, then reads them from any block of it.
class PoseReader {
public:
    PoseReader(const ExperimentSpec& experiment, const SignalLayout& layout);

    /// A body without a signal, or whose signal is not a pose (not finite, no rotation), keeps what `poses` holds for it;
    /// `poses` is filled with start poses first where its size is not right.
    void read(const SignalBlock& block, BodyPoses& poses) const;
    /// Bodies whose pose is in the layout.
    [[nodiscard]] std::size_t found() const;

private:
    static constexpr std::uint32_t kAbsent = 0xffffffffu;
    std::vector<std::uint32_t> m_offsets; // slot of each body's pose
    BodyPoses m_start;
};

} // namespace trundle
