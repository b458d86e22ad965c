#pragma once
// Springs between points of two bodies, and gears between two joints. Method: a row along a line between two bodies, for which ODE has a
// joint that keeps two points at a distance; with a very small gain its distance sets the rate that the row is to have, whatever the
// points themselves do.

#include <span>
#include <vector>

#include "world/ode/joints/joint_inertia.h"
#include "world/ode/objects/ode_objects.h"

namespace trundle {

class CouplingRows {
public:
    /// Both outlive this.
    CouplingRows(OdeObjects& objects, JointInertias& inertias) : m_objects(objects), m_inertias(inertias) {}

    /// Those of an actor whose bodies and joints are there. Returns the handles in the order of the specs, springs first.
    [[nodiscard]] std::vector<CouplingHandle> add(const ActorDef& def, std::uint32_t actor);
    /// A spring between actors, or of one and the world (kNone); its points are in the world.
    [[nodiscard]] CouplingHandle addLink(const SpringSpec& spec, std::uint32_t child, std::uint32_t parent);
    /// Prepares all rows for a step with these contacts. `errorReduction`: of gears.
    void update(double h, std::span<const OdeContact> contacts, double errorReduction);
    /// What they did, after a step.
    void measure();

private:
    [[nodiscard]] OdeCoupling springOf(const SpringSpec& spec, const Pose& frame, std::uint32_t child,
                                       std::uint32_t parent) const;
    [[nodiscard]] OdeCoupling gearOf(const GearSpec& spec, const ActorDef& def, std::uint32_t firstJoint) const;
    CouplingHandle keep(OdeCoupling coupling);
    void updateInertia(OdeCoupling& spring, std::uint32_t index, std::span<const OdeContact> contacts);
    void updateSpring(OdeCoupling& spring, double h) const;
    void updateGear(OdeCoupling& gear, double h, double errorReduction) const;
    [[nodiscard]] Vec3 pointOf(std::uint32_t body, const Vec3& place) const;
    [[nodiscard]] Vec3 speedOf(std::uint32_t body, const Vec3& point) const;

    OdeObjects& m_objects;
    JointInertias& m_inertias;
    std::vector<bool> m_touched; ///< by body around the spring that is being updated
    std::vector<JointInertias::Push> m_pushes;
    std::uint32_t m_ticks = 0;
};

} // namespace trundle
