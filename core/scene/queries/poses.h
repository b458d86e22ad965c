#pragma once
// World poses of all robot bodies: from the model before the first tick, from signal blocks afterwards.

#include <cstdint>
#include <vector>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"
#include "scene/queries/led_model.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// World poses of all robot bodies: robots in text order, each with its bodies in the order of its config; and what their Leds show.
struct BodyPoses : std::vector<Pose> {
    using std::vector<Pose>::vector;
    std::vector<LedColour> leds; ///< in the order of ledsOf()
};

[[nodiscard]] BodyPoses startPoses(const ExperimentSpec& experiment);

/// Resolves the offsets of pose signals in a layout once, then reads poses from any block of that layout.
class PoseReader {
public:
    PoseReader(const ExperimentSpec& experiment, const SignalLayout& layout);

    /// A body without a pose signal, or whose signal is not a valid pose (not finite, not a rotation), keeps its entry in
    /// `poses`, as does a Led without signals. If `poses` has the wrong size, it is first filled with the start poses.
    void read(const SignalBlock& block, BodyPoses& poses) const;
    /// Number of bodies whose pose is in the layout.
    [[nodiscard]] std::size_t found() const;

private:
    static constexpr std::uint32_t kAbsent = 0xffffffffu;
    std::vector<std::uint32_t> m_offsets; // slot of each body's pose
    struct LedSlots {
        std::uint32_t lit = kAbsent, colour = kAbsent;
    };
    std::vector<LedSlots> m_leds;
    BodyPoses m_start;
};

} // namespace trundle
