#pragma once
// World poses of all robot bodies: from the model before the first tick, from signal blocks afterwards.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"
#include "scene/queries/led_model.h"
#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

/// What a Pen has drawn.
struct PenLine {
    std::array<double, 3> colour{0, 0, 0};
    double width = 0; ///< m
    struct Point {
        Vec3 at = Vec3::Zero(); ///< in the world, m
        bool begins = false;    ///< of a stroke
    };
    std::vector<Point> points;
};

/// What differs between pictures of one experiment. World poses of all robot bodies: robots in text order, each with its bodies in the
/// order of its config; what their Leds show and their Pens have drawn.
struct BodyPoses : std::vector<Pose> {
    using std::vector<Pose>::vector;
    std::vector<LedColour> leds;                       ///< in the order of ledsOf()
    std::shared_ptr<const std::vector<PenLine>> lines; ///< null: there are none
};

[[nodiscard]] BodyPoses startPoses(const ExperimentSpec& experiment);

/// Resolves the offsets of pose signals in a layout once, then reads poses from any block of that layout.
class PoseReader {
public:
    PoseReader(const ExperimentSpec& experiment, const SignalLayout& layout);

    /// A body without a pose signal, or whose signal is not a valid pose (not finite, not a rotation), keeps its entry in
    /// `poses`, as does a Led without signals. If `poses` has the wrong size, it is first filled with the start poses. The lines of
    /// pens are replaced.
    void read(const SignalBlock& block, BodyPoses& poses) const;
    /// Number of bodies whose pose is in the layout.
    [[nodiscard]] std::size_t found() const;

private:
    static constexpr std::uint32_t kAbsent = 0xffffffffu;
    struct PenSlots {
        PenLine empty; ///< its colour and width
        std::uint32_t line = 0, count = 0, capacity = 0;
    };
    void findPens(const ExperimentSpec& experiment, const SignalLayout& layout);
    void readLines(std::span<const double> slots, BodyPoses& poses) const;

    std::vector<std::uint32_t> m_offsets; // slot of each body's pose
    std::vector<PenSlots> m_pens;
    struct LedSlots {
        std::uint32_t lit = kAbsent, colour = kAbsent;
    };
    std::vector<LedSlots> m_leds;
    BodyPoses m_start;
};

} // namespace trundle
