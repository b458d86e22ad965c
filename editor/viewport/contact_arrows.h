#pragma once
// Which contacts of a run are drawn, and how long the arrows of their forces are.

#include <vector>

#include "model/experiment_spec.h"
#include "run/live_run.h"

namespace trundle {

inline constexpr std::size_t kMostContacts = 600;                     ///< drawn, of all robots: the strongest
inline constexpr double kForcePixels = 60, kMostForcePixels = 150;    ///< of an arrow of forceUnit(), and of the longest

struct ContactArrow {
    const LiveContact* contact = nullptr;
    double pixels = 0;  ///< in proportion to the force, kMostForcePixels at most
    bool isCut = false; ///< the force is more than its length says
};

/// 1, 2 or 5 times a power of ten, at most so much.
[[nodiscard]] double roundNumber(double most);
/// The force (N) whose arrow is kForcePixels long: what the heaviest robot weighs, in round numbers. It is the experiment's own, so
/// the arrows of two moments and of two robots compare.
[[nodiscard]] double forceUnit(const ExperimentSpec& experiment);
/// They point into `contacts`.
[[nodiscard]] std::vector<ContactArrow> contactArrows(const std::vector<LiveContact>& contacts, double unit);

} // namespace trundle
