#pragma once
// Where two geoms touch. Balls, boxes, wheels and standing cylinders on planes, and wheels on boxes, are computed in closed form; all other pairs use
// dCollide, always as (lower, higher), reduced to a few well-spread points.

#include <vector>

#include "world/ode/collision/hull_collider.h"
#include "world/ode/objects/ode_objects.h"
#include "world/wheel_contact.h"

namespace trundle {

class GeomCollider {
public:
    /// The objects outlive this; their geoms are where their bodies are.
    explicit GeomCollider(const OdeObjects& objects) : m_objects(objects), m_hulls(objects) {}

    using Contacts = std::vector<OdeContact>;
    /// Adds the contacts of two geoms, of which the second may be static.
    void meet(std::uint32_t first, std::uint32_t second, Contacts& contacts);
    /// The same with a plane, at most `bound` away from it.
    void meetPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts);

private:
    [[nodiscard]] bool isRolling(std::uint32_t geom) const;
    void wheelAgainst(std::uint32_t wheel, std::uint32_t other, bool wheelFirst, Contacts& contacts) const;
    void sphereOnPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts) const;
    void boxOnPlane(std::uint32_t geom, const GroundPlane& plane, Contacts& contacts) const;
    void genericContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts);
    void addHullContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts) const;
    void atRadius(std::uint32_t geom, double side, dContactGeom* found, int count) const;
    [[nodiscard]] bool lineContacts(std::uint32_t first, std::uint32_t second, const Vec3& normal);
    [[nodiscard]] int collide(std::uint32_t first, std::uint32_t second, dContactGeom* found) const;
    [[nodiscard]] int mostContacts(std::uint32_t first, std::uint32_t second) const;
    OdeContact& addContact(std::uint32_t first, std::uint32_t second, const double* position, const double* normal, double depth,
                           Contacts& contacts) const;
    [[nodiscard]] WheelPose wheelPose(const OdeGeom& geom, std::uint32_t index) const;

    const OdeObjects& m_objects;
    HullCollider m_hulls;
    std::vector<SurfaceContact> m_onHulls;
    mutable FlatPair m_flat;
};

} // namespace trundle
