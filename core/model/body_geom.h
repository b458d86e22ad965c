#pragma once
// Where a path leads among bodies: "left.wheel" is a body of a Part, "left.wheel.tyre" a geom of that, "hull.disc_3.plate" one of a
// Repeat in a body.

#include <string_view>
#include <vector>

#include "model/body_spec.h"

namespace trundle {

/// The numbers of a body and of a geom in it; -1 where the path leads to none.
struct BodyGeom {
    int body = -1, geom = -1;
};
/// The body is the one with the longest name that the path begins with.
[[nodiscard]] BodyGeom geomAt(const std::vector<BodySpec>& bodies, std::string_view path);

} // namespace trundle
