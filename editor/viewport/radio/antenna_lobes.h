#pragma once
// Gain of an antenna by direction, as a surface around it.

#include <memory>

#include "radio/antenna_pattern.h"
#include "scene/overlay.h"

namespace trundle {

/// Distance (m) of the surface from the antenna in a direction of this gain (dBi): linear in dB, with `unit` metres at 0 dBi.
[[nodiscard]] double lobeRadius(double gain, double unit);

/// In the antenna's frame. `spokes`: vertices around the axis, a multiple of four, so that all six axes pass through a vertex.
[[nodiscard]] std::shared_ptr<const TintedMesh> lobeMesh(const AntennaPattern& pattern, double unit, int spokes);

/// The round length (1, 2 or 5 times a power of ten, m) nearest to the size of a robot; used as the radius of 0 dBi.
[[nodiscard]] double lobeUnitBeside(double robotRadius);

} // namespace trundle
