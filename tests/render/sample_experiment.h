#pragma once
// Experiments built in C++ for rendering tests: small robots in a walled arena.

#include <memory>

#include "model/experiment_spec.h"

namespace trundle {

struct SampleOptions {
    int robots = 1;
    double spacing = 0.7; ///< m, cell size of the square grid of robots
    bool arena = true;    ///< floor and walls
    double side = 4;      ///< m, of the arena
};

/// Materials: 0 default, then lightgrey, darkgrey, red, black, wood, concrete, blue, glass, orange, steel.
[[nodiscard]] std::shared_ptr<ExperimentSpec> sampleExperiment(const SampleOptions& options = {});
/// A static "yard" of a floor and one box.
[[nodiscard]] std::shared_ptr<ExperimentSpec> boxOnFloor(const Vec3& size, const Vec3& middle);
/// Small emissive balls of one colour that reflect nothing, for measuring positions in images.
[[nodiscard]] std::shared_ptr<ExperimentSpec> lampExperiment(const std::vector<Vec3>& places, double radius);
/// One geom of every shape, with a hill, a pyramid and a glass box.
[[nodiscard]] std::shared_ptr<ExperimentSpec> shapesExperiment();

} // namespace trundle
