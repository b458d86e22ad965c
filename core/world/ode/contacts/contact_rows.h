#pragma once
// From contacts to rows of the solver: a joint of ODE for each, with a spring whose behaviour does not depend on the tick, bounce,
// friction and rolling friction as both surfaces have them.

#include <span>
#include <vector>

#include "world/ode/contacts/friction_rows.h"
#include "world/ode/objects/ode_objects.h"
#include "world/ode/objects/ode_world.h"

namespace trundle {

class ContactRows {
public:
    /// All of these outlive this.
    ContactRows(const EngineSettings& settings, const OdeWorld& world, const OdeObjects& objects);

    /// Rows of all contacts that are neither outside nor iterated, for a step of `h` seconds; their forces go to the feedbacks.
    void make(TickContacts& contacts, double h);
    /// Makes the rows of these contacts anew.
    void remake(TickContacts& contacts, std::span<const std::uint32_t> which, double h);
    /// Removes all.
    void clear();
    /// The rows of one contact.
    dJointID add(const OdeContact& contact, double h, dJointGroupID group, dJointFeedback* feedback) const;

    /// N/m: of the ground alone, without what surfaces give. Stiffer where it has borne more than the actor's weight.
    [[nodiscard]] double stiffness(const OdeContact& contact) const { return stiffening(contact) * stiffer(contact).stiffness; }
    /// m that it gives under its load, once that lasts.
    [[nodiscard]] double sag(const OdeContact& contact) const;
    /// `h`: s, of a tick that begins.
    [[nodiscard]] FrictionLaw frictionLaw(const OdeContact& contact, double h = 0) const;
    /// A new contact of what has springs. Its depth, which came about in the rest of the tick in which the two met, is taken back
    /// at once: pushed out slowly it would load the springs meanwhile.
    [[nodiscard]] bool landsOnSprings(const OdeContact& contact) const;

    /// J that the spring of a soft surface holds as a contact begins: nothing where its depth is that of one tick of its way here.
    void startSprings(std::span<OdeContact> contacts, double h) const;
    /// Work (J) along the normal of a contact with a soft surface, as it was solved; 0 of others.
    [[nodiscard]] double work(const OdeContact& contact, const dJointFeedback& force, std::span<const RawState> before,
                              double h) const;
    /// After the solver: contacts with soft surfaces that part with more than they took, because a spring begins and ends within a
    /// tick. They get less; returns them.
    [[nodiscard]] std::span<const std::uint32_t> findThrown(TickContacts& contacts, std::span<const RawState> before, double h);

private:
    [[nodiscard]] double softness(const OdeContact& contact) const;
    [[nodiscard]] double mass(const OdeContact& contact) const;
    [[nodiscard]] double springStiffness(const OdeContact& contact) const;
    [[nodiscard]] double stiffening(const OdeContact& contact) const;
    [[nodiscard]] double blowDamping(const OdeContact& contact, double h) const;
    [[nodiscard]] const OdeActor& stiffer(const OdeContact& contact) const;
    void fillSurface(const OdeContact& contact, double h, dContact& out) const;
    void fillSpring(const OdeContact& contact, double h, dContact& out) const; // contact_spring.cpp
    [[nodiscard]] double mobility(std::uint32_t geom, const Vec3& point, const Vec3& way) const;
    [[nodiscard]] FrictionLaw ownFriction(std::uint32_t geom, const Vec3& outward, double h) const;
    [[nodiscard]] Vec3 rollingAxis(const OdeContact& contact, const Vec3& normal) const;
    [[nodiscard]] Vec3 restAxis(const OdeContact& contact, const Vec3& normal, const Vec3& slip, double h) const;
    [[nodiscard]] bool restsQuietly(const OdeContact& contact, const FrictionLaw& law) const;
    [[nodiscard]] Vec3 carriedAlong(const OdeContact& contact, const Vec3& normal, double h) const;
    void fillFriction(const OdeContact& contact, FrictionLaw law, const Vec3& speed, double h, dContact& out) const;

    const EngineSettings& m_settings;
    const OdeObjects& m_objects;
    const std::vector<OdeGeom>& m_geoms;
    const std::vector<OdeBody>& m_bodies;
    dWorldID m_world;
    OwnedJointGroup m_group;
    std::vector<std::uint32_t> m_thrown;
};

} // namespace trundle
