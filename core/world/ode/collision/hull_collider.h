#pragma once
// Contacts of flat faces with each other: of convex hulls with hulls, boxes, ends of cylinders, meshes and height maps, and of such ends with planes,
// boxes and each other.

#include <cstdint>
#include <vector>

#include "world/ode/collision/end_contacts.h"
#include "world/ode/collision/near_triangles.h"
#include "world/ode/objects/ode_objects.h"

namespace trundle {

class HullCollider {
public:
    /// Both outlive this; the geoms are where their bodies are.
    HullCollider(const OdeObjects& objects, NearTriangles& near) : m_objects(objects), m_near(near) {}

    /// Adds the contacts of two geoms, at most `most` of one direction, with normals towards the first. False if they are not two such
    /// shapes, if only edges cross, or if a cylinder's lateral surface touches; the single contact of ODE is used then.
    [[nodiscard]] bool meet(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& contacts);
    /// The same of a cylinder that stands on a plane. False if it does not.
    [[nodiscard]] bool standsOnPlane(std::uint32_t geom, const GroundPlane& plane, int most,
                                     std::vector<SurfaceContact>& contacts);

    /// Fills `faces` with those of a geom that has flat ones to which `normal` is across. False if it has none.
    [[nodiscard]] bool setFaces(std::uint32_t geom, const Vec3& normal);
    [[nodiscard]] const FlatBody& faces() const { return m_pair.first; }

private:
    [[nodiscard]] bool endContacts(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out);
    [[nodiscard]] double endOnBox(std::uint32_t cylinder, std::uint32_t box, std::vector<SurfaceContact>& out) const;
    [[nodiscard]] double endOnCylinder(std::uint32_t first, std::uint32_t second, std::vector<SurfaceContact>& out) const;
    [[nodiscard]] RoundEnd endTowards(std::uint32_t cylinder, const Vec3& way) const;
    [[nodiscard]] bool areOnEnds(std::uint32_t cylinder, const std::vector<SurfaceContact>& contacts) const;
    [[nodiscard]] bool isBeside(std::uint32_t cylinder, const std::vector<SurfaceContact>& onEnd) const;
    [[nodiscard]] bool isFlushWith(std::uint32_t cylinder, std::span<const Triangle> triangles) const;
    [[nodiscard]] bool hullContacts(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out);
    [[nodiscard]] bool hullOnMesh(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out);
    void setBody(std::uint32_t geom, FlatBody& body) const;

    const OdeObjects& m_objects;
    NearTriangles& m_near;
    std::vector<SurfaceContact> m_ends;
    FlatPair m_pair;
};

} // namespace trundle
