#pragma once
// Which radios of an experiment can reach each other at the current poses, with their link margins. A pure function of the
// displayed poses, so it can run on any thread and does not access the running world.

#include <memory>
#include <vector>

#include "scene/queries/radio_model.h"

namespace trundle {

inline constexpr std::size_t kMaxLinks = 400;        ///< drawn; the strongest are kept
inline constexpr std::size_t kMaxLinkPairs = 20'000; ///< pairs tested; beyond it only each radio's nearest neighbours

struct RadioPoses {
    std::shared_ptr<const ObjectIndex> objects;
    std::shared_ptr<const BodyPoses> poses;
    std::shared_ptr<const std::vector<RadioNode>> nodes;
};
[[nodiscard]] std::vector<Pose> antennasOf(const RadioPoses& places); ///< world poses
/// Radio nodes at these poses, with walls between them. Node indices are those of `places`.
[[nodiscard]] RadioNodes radiosAt(const RadioPoses& places);

struct RadioLink {
    std::size_t from = 0, to = 0; ///< node indices
    double margin = 0;            ///< dB above the sensitivity; the smaller one of both directions
    bool oneWay = false;          ///< only `to` receives `from`; the margin is of that direction
};

struct RadioLinks {
    std::vector<RadioLink> links; ///< strongest first
    std::size_t reaching = 0;     ///< number of tested pairs that reach each other
    std::size_t nearest = 0;      ///< not 0: only that many nearest neighbours of each radio were tested
};

/// Links at full power. `selected` (by node; empty: all) restricts them to those of the selected radios.
[[nodiscard]] RadioLinks linksOf(const RadioPoses& places, const std::vector<bool>& selected);

} // namespace trundle
