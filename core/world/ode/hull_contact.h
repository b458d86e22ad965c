#pragma once
// Contacts between convex bodies with flat faces. A general collider finds one deepest point, on which nothing can stand; here the
// touching faces are clipped against the other body, so that a body rests on the whole of what it covers.

#include <array>
#include <cstdint>
#include <vector>

#include <trundle/geometry.h>

namespace trundle {

/// Convex and closed, in the world; triangles counter-clockwise seen from outside, each with its plane normal . x = offset.
struct FlatBody {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Vec3> normals;
    std::vector<double> offsets;

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& normal);
};

/// The box with these half sides.
[[nodiscard]] FlatBody flatBox(const Vec3& centre, const Mat3& axes, const Vec3& half);

struct FlatContact {
    Vec3 position;
    double depth = 0;
};

/// What `flatContacts` found: all contacts share one normal, towards the first body.
struct FlatTouch {
    bool apart = false; ///< a face's plane lies between them
    Vec3 normal = Vec3::UnitZ();
    std::vector<FlatContact> contacts; ///< empty though not apart: edges cross, no face is inside
};

[[nodiscard]] FlatTouch flatContacts(const FlatBody& first, const FlatBody& second);

} // namespace trundle
