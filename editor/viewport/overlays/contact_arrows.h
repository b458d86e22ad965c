#pragma once
// Selection of the contacts that are drawn, and the lengths of their force arrows.

#include <vector>

#include "model/experiment_spec.h"
#include "run/live/live_run.h"

namespace trundle {

inline constexpr std::size_t kMaxContacts = 600;                  ///< limit over all robots; the strongest are drawn
inline constexpr double kForcePixels = 60, kMaxForcePixels = 150; ///< length of the arrow for forceUnit(), and the maximum

struct ContactArrow {
    const LiveContact* contact = nullptr;
    double pixels = 0;  ///< proportional to the force, at most kMaxForcePixels
    bool isCut = false; ///< the arrow was shortened to the maximum
};

/// The largest of 1, 2 or 5 times a power of ten that is not above `most`.
[[nodiscard]] double roundNumber(double most);
/// The force (N) whose arrow is kForcePixels long: the weight of the heaviest robot, rounded. Constant for an experiment, so that
/// arrows can be compared between times and robots.
[[nodiscard]] double forceUnit(const ExperimentSpec& experiment);
/// The results point into `contacts`.
[[nodiscard]] std::vector<ContactArrow> contactArrows(const std::vector<LiveContact>& contacts, double unit);

} // namespace trundle
