#pragma once
// Wheels whose rotation nobody could see, since they are round and in one colour: they are drawn with spokes. Colours alone change:
// outline, depth, shadow and collision shape stay those of the geom.

#include <array>
#include <cstdint>
#include <vector>

#include "model/experiment_spec.h"
#include "scene/shape_mesh.h"

namespace trundle {

/// One geom of a body that is drawn with spokes.
struct SpokePattern {
    std::uint32_t geom = 0;    ///< index in its body
    Vec3 axis = Vec3::UnitZ(); ///< of the rotation, unit, in the geom's frame
    bool top = true,
         bottom = true; ///< whether the faces of a cylinder towards +z and -z have spokes; else another geom covers them
};

/// For each body of a config its patterns. A geom has one where it and all that is seen of what moves with it are round about the
/// axis of a Hinge or of a Suspension's wheel, and its material has no picture; thin parts such as nuts have none.
[[nodiscard]] std::vector<std::vector<SpokePattern>> spokePatternsOf(const RobotConfigSpec& config,
                                                                     const std::vector<MaterialSpec>& materials);

/// What each triangle of a wheel is painted with.
enum class WheelPaint : std::uint8_t { Tyre, Metal, Gap, Mean };
inline constexpr std::size_t kWheelPaints = 4;

/// The shape of a geom, apart by paint. Of few segments it has no spokes, but the mean of their colours.
[[nodiscard]] std::array<ShapeMesh, kWheelPaints> spokedShapeOf(const GeomSpec& geom, const SpokePattern& pattern,
                                                                Fineness fineness);
/// The geom's own material on its tyre; spokes are light on a dark tyre and dark on a light one.
[[nodiscard]] MaterialSpec paintedMaterial(const MaterialSpec& tyre, WheelPaint paint);

} // namespace trundle
