#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// Names of all geoms, by the numbers that they have in segmentation pictures and in ground truth of sensors: "robot0/chassis/hull",
/// "arena/north". The first entry means "no object" and is empty.
[[nodiscard]] std::vector<std::string> objectNames(const ExperimentSpec& experiment);

/// The number of the first geom of each robot and of each static; theirs follow each other, body by body.
struct FirstObjects {
    std::vector<std::uint32_t> robots, statics;
};
[[nodiscard]] FirstObjects firstObjects(const ExperimentSpec& experiment);

} // namespace trundle
