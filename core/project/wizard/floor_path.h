#pragma once
// Walls and lines along the corners of a path on the floor, as text.

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

using FloorPoint = std::array<double, 2>; ///< x, y in m

/// One straight piece of a path.
struct FloorPiece {
    FloorPoint middle{};
    double heading = 0; ///< degrees, above -90 and up to 90
    double length = 0;  ///< m; past a corner by half a thickness or less, so that the corner is closed
};
/// The pieces between the corners, `thickness` m wide. If the last corner is the first one, that is a corner too. Corners at the same place
/// are one.
[[nodiscard]] std::vector<FloorPiece> piecesAlong(const std::vector<FloorPoint>& corners, double thickness);

/// A number of metres or degrees as a person would write it, to the tenth of a millimetre and never "-0".
[[nodiscard]] std::string tidyNumber(double value);

/// What a path becomes.
struct FloorPathStyle {
    std::string_view config;      ///< of an experiment: Wall, FloorLine
    std::string_view name;        ///< of its objects, with a number: wall1
    double length = 2;            ///< m; of the config where none is given
    double thickness = 0.1;       ///< m; across it on the floor
    double bottom = 0, top = 0.5; ///< m, z of the shape in a StaticConfig
    std::string_view material = "white", surface = "wall";
    bool collides = true;
};
[[nodiscard]] FloorPathStyle wallPath();
/// A line that a ground sensor sees and wheels do not feel.
[[nodiscard]] FloorPathStyle linePath();

/// A Static for each piece, for an experiment that imports the config.
[[nodiscard]] std::string staticsText(const std::vector<FloorPiece>& pieces, const FloorPathStyle& style);
/// A Box for each piece, for a StaticConfig.
[[nodiscard]] std::string boxesText(const std::vector<FloorPiece>& pieces, const FloorPathStyle& style);

} // namespace trundle
