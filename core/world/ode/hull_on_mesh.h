#pragma once
// A convex body with flat faces on the triangles of a surface. Both sides of a triangle are ground; which one is told by where most
// of the body is.

#include "world/ode/hull_contact.h"

namespace trundle {

struct SurfaceContact {
    Vec3 position, normal; ///< towards the body
    double depth = 0;
};

using Triangle = std::array<Vec3, 3>;

/// All contacts with these triangles, in their order.
[[nodiscard]] std::vector<SurfaceContact> contactsOnSurface(const FlatBody& body, const std::vector<Triangle>& triangles);

} // namespace trundle
