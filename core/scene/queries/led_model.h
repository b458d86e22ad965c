#pragma once
// The Leds of an experiment, as pictures show them.

#include <array>
#include <string>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// A display colour; black: it is dark.
using LedColour = std::array<float, 3>;

struct LedModel {
    std::string path;                            ///< "robot0/beacon"
    std::size_t body = 0;                        ///< index into BodyPoses of the body it is fixed to
    Pose mounting;                               ///< in its body
    double diameter = 0.005;                     ///< m; 0: it is not seen
    LedColour colour{1, 1, 1}, atStart{0, 0, 0}; ///< colour: of the text, also when it is dark at the start
};

/// Robots in text order, and for each robot its Leds in text order.
[[nodiscard]] std::vector<LedModel> ledsOf(const ExperimentSpec& experiment);

} // namespace trundle
