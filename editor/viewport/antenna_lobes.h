#pragma once
// How an antenna sends and hears in each direction, as a surface around it.

#include <memory>

#include "radio/antenna_pattern.h"
#include "scene/overlay.h"

namespace trundle {

/// Distance of the surface from the antenna in a direction of this gain (dBi), where 0 dBi is `unit` metres: linear in dB.
[[nodiscard]] double lobeRadius(double gain, double unit);

/// In the frame of the antenna; `spokes` around, a multiple of four, so that all six axes have a corner.
[[nodiscard]] std::shared_ptr<const TintedMesh> lobeMesh(const AntennaPattern& pattern, double unit, int spokes);

/// The round length (1, 2 or 5 times a power of ten) that is nearest to the size of a robot: what 0 dBi is beside it.
[[nodiscard]] double lobeUnitBeside(double robotRadius);

} // namespace trundle
