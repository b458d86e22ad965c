#pragma once
// Experiments made by hand for tests of pictures: small robots in a walled arena.

#include <memory>

#include "model/experiment_spec.h"

namespace trundle {

struct SampleOptions {
    int robots = 1;
    double spacing = 0.7; ///< m, of the square grid they are in
    bool arena = true;    ///< floor and walls
    double side = 4;      ///< m, of the arena
};

/// Materials: 0 default, then lightgrey, darkgrey, red, black, wood, concrete, blue, glass, orange, steel.
[[nodiscard]] std::shared_ptr<ExperimentSpec> sampleExperiment(const SampleOptions& options = {});
/// Lamps without lit surface: small balls that shine in one colour and reflect nothing, for measuring where things appear.
[[nodiscard]] std::shared_ptr<ExperimentSpec> lampExperiment(const std::vector<Vec3>& places, double radius);
/// One of every shape, with a hill, a pyramid and a glass box.
[[nodiscard]] std::shared_ptr<ExperimentSpec> shapesExperiment();

} // namespace trundle
