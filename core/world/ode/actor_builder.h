#pragma once
// Makes bodies, geoms and statics of their specs. ODE places a body's origin at its centre of mass, the specs at their own frame.

#include <string>

#include "world/ode/joints/coupling_rows.h"
#include "world/ode/joints/joint_builder.h"

namespace trundle {

class ActorBuilder {
public:
    /// All of these outlive this.
    ActorBuilder(const EngineSettings& settings, const OdeWorld& world, OdeObjects& objects, JointRows& rows,
                 CouplingRows& couplings)
        : m_settings(settings), m_world(world.id()), m_objects(objects), m_rows(rows), m_couplings(couplings),
          m_joints(world, objects, rows) {}

    [[nodiscard]] Result<ActorHandles> addActor(const ActorDef& actor);
    /// Between actors; kNone: the world.
    [[nodiscard]] Result<JointHandle> addJoint(const JointSpec& spec, std::uint32_t child, std::uint32_t parent);
    [[nodiscard]] Result<CouplingHandle> addSpring(const SpringSpec& spec, std::uint32_t child, std::uint32_t parent);
    [[nodiscard]] Result<GeomHandle> addStatic(const GeomSpec& geom, const Pose& pose);

private:
    void buildActor(const ActorDef& def, ActorHandles& handles, std::string& failure);
    void removeLast();
    void markLinked(std::uint32_t child, std::uint32_t parent);
    void addBody(const BodyDef& def, std::uint32_t actor, ActorHandles& handles, std::string& failure);
    [[nodiscard]] bool addGeom(const GeomSpec& spec, std::uint32_t body, std::string& failure);
    void setStiffness(OdeActor& actor) const;
    void findSelfPairs(OdeActor& actor, const ActorDef& def) const;

    const EngineSettings& m_settings;
    dWorldID m_world;
    OdeObjects& m_objects;
    JointRows& m_rows;
    CouplingRows& m_couplings;
    JointBuilder m_joints;
};

} // namespace trundle
