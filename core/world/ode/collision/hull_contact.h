#pragma once
// Contacts between convex bodies with flat faces. A general collider finds one deepest point, on which nothing can be; here the
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

    void clear();
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& normal);
    /// The box with these half sides, in place of what was there.
    void setBox(const Vec3& centre, const Mat3& axes, const Vec3& half);
    /// A cylinder about its z with flat sides, which lie outside its round ones by less than a half per cent of the radius: good for what
    /// touches its ends.
    void setCylinder(const Vec3& centre, const Mat3& axes, double radius, double halfLength);
};

/// Keeps what lies below the plane normal . x = offset.
void clipPolygon(std::vector<Vec3>& polygon, const Vec3& normal, double offset, std::vector<Vec3>& scratch);

struct FlatContact {
    Vec3 position;
    double depth = 0;
};

/// All contacts share one normal, towards the first body.
struct FlatTouch {
    bool apart = false; ///< a face's plane lies between them
    Vec3 normal = Vec3::UnitZ();
    std::vector<FlatContact> contacts; ///< empty though not apart: edges cross, no face is inside
};

/// Two bodies and where they touch. Kept from pair to pair, it takes nothing from the heap.
struct FlatPair {
    FlatBody first, second;
    FlatTouch touch;

    /// Fills `touch`.
    const FlatTouch& findContacts();

private:
    void clipFaces(const FlatBody& body, std::size_t reference, const FlatBody& other);
    std::vector<Vec3> m_polygon, m_scratch;
};

} // namespace trundle
