#pragma once
// Which radios of an experiment reach each other as everything stands now, and with how much to spare. A value from values: made on any
// thread, of what a run shows, not of its world.

#include <memory>
#include <vector>

#include "scene/radio_model.h"

namespace trundle {

inline constexpr std::size_t kMostLinks = 400;        ///< drawn: the strongest
inline constexpr std::size_t kMostLinkPairs = 20'000; ///< looked at: beyond it those to the nearest radios

struct RadioPlaces {
    std::shared_ptr<const ObjectIndex> objects;
    std::shared_ptr<const BodyPoses> poses;
    std::shared_ptr<const std::vector<RadioNode>> nodes;
};
[[nodiscard]] std::vector<Pose> antennasOf(const RadioPlaces& places); ///< in the world
/// With walls between them. Number i is node i.
[[nodiscard]] RadioNodes radiosAt(const RadioPlaces& places);

struct RadioLink {
    std::size_t from = 0, to = 0; ///< nodes
    double margin = 0;            ///< dB over the sensitivity; of both directions the smaller one
    bool oneWay = false;          ///< only `to` hears `from`, and the margin is its
};

struct RadioLinks {
    std::vector<RadioLink> links; ///< strongest first
    std::size_t reaching = 0;     ///< pairs in reach of those looked at
    std::size_t nearest = 0;      ///< not 0: of each radio only so many nearest were looked at
};

/// At full power. `selected` (by node; empty: all) says whose links are meant.
[[nodiscard]] RadioLinks linksOf(const RadioPlaces& places, const std::vector<bool>& selected);

} // namespace trundle
