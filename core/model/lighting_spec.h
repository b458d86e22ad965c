#pragma once
// The light of an experiment: the sun, sky and lamps of its text, or defaults. Linear light, red, green and blue: 1 on a white surface shows
// white.

#include <array>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

struct LampSpec {
    Vec3 position = Vec3::Zero();         ///< world frame, m
    std::array<double, 3> light{1, 1, 1}; ///< at 1 m
    bool shadows = true;
};

struct LightingSpec {
    Vec3 toSun = Vec3(-0.52, -0.30, 0.80).normalized();
    std::array<double, 3> sun{0.98, 0.94, 0.86}, sky{0.36, 0.395, 0.45}, ground{0.19, 0.185, 0.18};
    std::array<double, 3> horizon{0.815, 0.865, 0.905}, zenith{0.265, 0.480, 0.765}; ///< display colours
    bool sunShadows = true;
    std::vector<LampSpec> lamps; ///< at most kMaxLamps
};

[[nodiscard]] LightingSpec lightingSpecOf(const ExperimentSpec& experiment);

} // namespace trundle
