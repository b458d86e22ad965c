#pragma once
// Where two geoms touch. Balls, boxes, wheels and standing cylinders on planes, wheels on boxes, and balls, wheels and cylinders on triangles are computed in
// closed form; all other pairs use dCollide, always as (lower, higher), reduced to a few well-spread points.

#include <vector>

#include "world/ode/collision/hull_collider.h"
#include "world/ode/collision/round_on_triangles.h"
#include "world/ode/objects/ode_objects.h"

namespace trundle {

class GeomCollider {
public:
    /// The objects outlive this; their geoms are where their bodies are.
    explicit GeomCollider(const OdeObjects& objects) : m_objects(objects), m_near(objects), m_hulls(objects, m_near) {}

    using Contacts = std::vector<OdeContact>;
    /// Adds the contacts of two geoms, of which the second may be static.
    void meet(std::uint32_t first, std::uint32_t second, Contacts& contacts);
    /// The same with a plane, at most `bound` away from it.
    void meetPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts);

private:
    [[nodiscard]] bool isRolling(std::uint32_t geom) const;
    void wheelAgainst(std::uint32_t wheel, std::uint32_t other, bool wheelFirst, Contacts& contacts);
    void wheelOnSurface(std::uint32_t wheel, std::uint32_t surface, bool wheelFirst, Contacts& contacts);
    [[nodiscard]] int roundOnSurface(std::uint32_t first, std::uint32_t second, dContactGeom* found);
    void sphereOnPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts) const;
    void boxOnPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts) const;
    void genericContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts);
    void addHullContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts) const;
    void atRadius(std::uint32_t geom, double side, dContactGeom* found, int count) const;
    [[nodiscard]] bool lineContacts(std::uint32_t first, std::uint32_t second, const Vec3& normal);
    [[nodiscard]] int collide(std::uint32_t first, std::uint32_t second, dContactGeom* found);
    [[nodiscard]] int collideAsMesh(std::uint32_t first, std::uint32_t second, dContactGeom* found);
    [[nodiscard]] int mostContacts(std::uint32_t first, std::uint32_t second) const;
    OdeContact& addContact(std::uint32_t first, std::uint32_t second, const double* position, const double* normal, double depth,
                           Contacts& contacts) const;
    [[nodiscard]] WheelPose wheelPose(const OdeGeom& geom, std::uint32_t index) const;

    const OdeObjects& m_objects;
    NearTriangles m_near;
    HullCollider m_hulls;
    std::vector<TreadContact> m_onTread;
    std::vector<SurfaceContact> m_onHulls;
    mutable FlatPair m_flat;
};

} // namespace trundle
