#pragma once
// Wheels whose rotation would be invisible, since they are round and of one colour, are drawn with spokes. Only colours change:
// outline, depth, shadow and collision shape remain those of the geom.

#include <array>
#include <cstdint>
#include <vector>

#include "model/experiment_spec.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {

/// A geom of a body that is drawn with spokes.
struct SpokePattern {
    std::uint32_t geom = 0;    ///< index in its body
    Vec3 axis = Vec3::UnitZ(); ///< rotation axis, unit vector in the geom's frame
    bool top = true,
         bottom = true; ///< whether the +z and -z faces of a cylinder have spokes; false where another geom covers the face
};

/// The patterns of each body of a config. A geom has one if it and everything visible that moves with it is rotationally
/// symmetric about the axis of a Hinge or of a Suspension's wheel, and its material has no texture. Thin parts such as nuts have
/// none.
[[nodiscard]] std::vector<std::vector<SpokePattern>> spokePatternsOf(const RobotConfigSpec& config,
                                                                     const std::vector<MaterialSpec>& materials);

/// Colour class of the triangles of a wheel.
enum class WheelPaint : std::uint8_t { Tyre, Metal, Gap, Mean };
inline constexpr std::size_t kWheelPaints = 4;

/// The shape of a geom, split by paint. With few segments there are no spokes but their mean colour.
[[nodiscard]] std::array<ShapeMesh, kWheelPaints> spokedShapeOf(const GeomSpec& geom, const SpokePattern& pattern,
                                                                Fineness fineness);
/// The tyre keeps the geom's own material; spokes are light on a dark tyre and dark on a light one.
[[nodiscard]] MaterialSpec paintedMaterial(const MaterialSpec& tyre, WheelPaint paint);

} // namespace trundle
