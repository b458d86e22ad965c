#pragma once
// The distance and ground sensors of an experiment for overlays: where they are and in which directions they measure.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// A sensor of any kind that has a Body and a MaxRange: a fan if it has Beams, otherwise a cone. With a MaxHeight it is a ground sensor.
struct RangeModel {
    std::string path, robot;             ///< "robot0/scan", "robot0"
    std::size_t body = 0;                ///< index into BodyPoses of the body it is fixed to
    Pose mounting;                       ///< in its body
    double maxRange = 1;                 ///< m
    double coneAngle = 0;                ///< rad; of a cone
    std::uint32_t beams = 0, layers = 1; ///< of a fan; no beams: a cone
    bool ground = false;                 ///< looks along its -z and measures a reflectance
    bool closed = false;                 ///< the beams of a layer go all around
    std::vector<Vec3> directions;        ///< unit vectors of the beams in its own frame, layer by layer; of a cone, its axis

    /// The signal with its readings, one for each direction: "robot0/scan/ranges", "robot0/front/range", "robot0/eye/reflectance".
    [[nodiscard]] std::string signal() const { return path + (ground ? "/reflectance" : beams > 0 ? "/ranges" : "/range"); }
};

/// The model of one sensor, without its path, robot and body. None if the component measures no distances and no reflectance.
[[nodiscard]] std::optional<RangeModel> rangeModelOf(const ComponentSpec& device);

/// Robots in text order, and for each robot its sensors in text order.
[[nodiscard]] std::vector<RangeModel> rangeModelsOf(const ExperimentSpec& experiment);

} // namespace trundle
