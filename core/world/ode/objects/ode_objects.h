#pragma once
// What is in the engine, in flat arrays: the one thing that its parts share. Builders fill it, the search places the geoms, ODE moves the
// bodies, `publish` copies their states out.

#include <span>
#include <vector>

#include "world/ode/objects/ode_math.h"
#include "world/ode/objects/ode_records.h"

namespace trundle {

/// Actors own runs of bodies, bodies own runs of geoms; all indices ascend with creation.
struct OdeObjects {
    OdeObjects() = default;
    OdeObjects(const OdeObjects&) = delete;
    OdeObjects& operator=(const OdeObjects&) = delete;
    ~OdeObjects();

    std::vector<OdeActor> actors;
    std::vector<OdeBody> bodies;
    std::vector<BodyState> states; ///< of bodies, as published last
    std::vector<Mat3> inertias;    ///< of bodies about their centres of mass, without the rotors of motors
    std::vector<OdeJoint> joints;
    std::vector<OdeCoupling> couplings;
    std::vector<OdeLatch> latches;
    std::vector<std::uint32_t> links; ///< joints between actors, or of an actor and the world, that came after the actors
    std::vector<IndexPair> apartActors, apartBodies; ///< that do not touch each other, each as (lower, higher), ascending
    std::vector<OdeGeom> geoms;
    std::vector<Vec3> centres;           ///< of geoms, world
    std::vector<Box3> boxes, actorBoxes; ///< of geoms, of actors
    std::vector<GroundPlane> planes;
    std::vector<std::uint32_t> statics; ///< static geoms other than planes

    /// Pairs of actors that a joint, spring or latch joins.
    [[nodiscard]] std::vector<IndexPair> joinedActors() const;
    /// Has two actors, or two bodies, not touch each other.
    void separateActors(std::uint32_t first, std::uint32_t second);
    /// False if they did not before.
    bool separateBodies(std::uint32_t first, std::uint32_t second);
    void reuniteBodies(std::uint32_t first, std::uint32_t second);
    [[nodiscard]] static bool areApart(const std::vector<IndexPair>& pairs, std::uint32_t first, std::uint32_t second);

    /// In the world.
    [[nodiscard]] Mat3 axesOf(const OdeGeom& geom) const {
        if (geom.body == kNone) return geom.axes;
        const Mat3 body = matrix(bodies[geom.body].r);
        return geom.turned ? Mat3(body * geom.axes) : body;
    }
    [[nodiscard]] Vec3 pointVelocity(const OdeGeom& geom, const Vec3& point) const {
        if (geom.body == kNone) return Vec3::Zero();
        const OdeBody& b = bodies[geom.body];
        return vec(b.v) + vec(b.w).cross(point - vec(b.p));
    }
    /// Of the first body on the second, where they touch: m/s. After a step with the states before it, since bodies have moved on from
    /// where they touched.
    [[nodiscard]] Vec3 contactSpeed(const OdeContact& contact) const;
    [[nodiscard]] Vec3 contactSpeed(const OdeContact& contact, std::span<const RawState> before) const;
    /// Whether a geom is round about the axis that it would roll about on a floor of this normal.
    [[nodiscard]] bool rolls(const OdeGeom& geom, const Vec3& normal) const;
    /// How the place of a contact moves: with the first body, or with its centre if it rolls there. m/s.
    [[nodiscard]] Vec3 carriedBy(const OdeContact& contact) const;
    /// The state of a body's frame from that of its centre of mass.
    void publish(std::uint32_t body);
};

[[nodiscard]] RawState rawState(const OdeBody& body);
/// Writes through ODE's const pointers, because its setters change the last bits.
void setRawState(const OdeBody& body, const RawState& state);

} // namespace trundle
