#pragma once
// Contacts of a convex polyhedron with the triangles of a mesh. Both sides of a triangle are solid; the side that contains most
// of the body is used.

#include <span>

#include "world/ode/collision/hull_contact.h"

namespace trundle {

struct SurfaceContact {
    Vec3 position, normal; ///< towards the body
    double depth = 0;
};

using Triangle = std::array<Vec3, 3>;

/// All contacts with these triangles, in the order of the triangles.
[[nodiscard]] std::vector<SurfaceContact> contactsOnSurface(const FlatBody& body, std::span<const Triangle> triangles);

} // namespace trundle
