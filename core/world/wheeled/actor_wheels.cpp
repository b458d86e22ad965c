// Which bodies are wheels and casters, and why one that looks like a wheel does not count as one.

#include <cmath>
#include <cstdio>

#include "world/wheeled/actor_shape.h"

namespace trundle {

namespace {

bool isRound(GeomShape shape) {
    return shape == GeomShape::Sphere || shape == GeomShape::Cylinder || shape == GeomShape::Capsule;
}

/// Distance of a point in the actor's frame from the axle, m.
double besideAxle(const JointSpec& joint, const Vec3& point) {
    const Vec3 off = point - joint.anchor;
    return (off - off.dot(joint.axis) * joint.axis).norm();
}

/// The round geom of a body at a pose in the actor's frame through which the axle goes; of several the largest.
const GeomSpec* treadOn(const JointSpec& joint, const BodySpec& body, const Pose& at) {
    const GeomSpec* found = nullptr;
    for (const GeomSpec& geom : body.geoms) {
        if (!geom.collide || !isRound(geom.shape) || (found && found->radius >= geom.radius)) continue;
        const Pose pose = at * geom.pose;
        const bool along = std::abs((pose.rotation * Vec3::UnitZ()).dot(joint.axis)) > 1 - kLevelAxis;
        if ((geom.shape == GeomShape::Sphere || along) && besideAxle(joint, pose.position) < geom.radius) found = &geom;
    }
    return found;
}

/// What keeps a body that is on the ground from being a wheel on its axle; empty: nothing. `off`: of its tread from the axle, m.
std::string whyNoWheel(const JointSpec& joint, const std::string& body, const GeomSpec& tread, bool isOnly, double off) {
    const auto wheel = [&](const char* reason) { return named("wheel", body, reason); };
    const auto axle = [&](const char* reason) { return named("the Hinge", joint.name, reason); };
    if (!isOnly) return wheel("has more than one geom that collides");
    if (tread.shape == GeomShape::Capsule) return wheel("is a Capsule; only a Cylinder or a Sphere can be one");
    if (off > kTouching) {
        char text[64];
        std::snprintf(text, sizeof text, "has its middle %.1f mm beside its axle", 1e3 * off);
        return wheel(text);
    }
    if (joint.lowStop || joint.highStop) return axle("has stops; a wheel turns without end");
    if (joint.friction > 0) return axle("has Friction; a wheel turns freely on its axle");
    if (joint.stiffness > 0) return axle("has a spring; a wheel turns freely on its axle");
    return {};
}

} // namespace

const GeomSpec* onlyGeom(const BodySpec& body) {
    const GeomSpec* found = nullptr;
    for (const GeomSpec& geom : body.geoms)
        if (geom.collide) {
            if (found) return nullptr;
            found = &geom;
        }
    return found;
}

bool ActorReader::hasRollingFriction(const GeomSpec& geom) const {
    return m_surfaces[geom.surface].rollingFriction > 0 || m_surfaces[m_ground.surface()].rollingFriction > 0;
}

/// A level axle through the middle of one cylinder or ball.
bool ActorReader::isWheel(const JointSpec& joint) {
    const auto index = static_cast<std::uint32_t>(joint.child);
    if (std::abs(joint.axis.z()) > kLevelAxis) return false;
    const GeomSpec* tread = treadOn(joint, body(index), inActor(index));
    if (!tread) {
        const auto parent = static_cast<std::uint32_t>(joint.parent);
        const GeomSpec* other = treadOn(joint, body(parent), inActor(parent));
        if (!other || std::abs(gapBelow(parent, *other)) > kOnGround) return false;
        return refuse(named("the Hinge", joint.name, "has its wheel as its Parent; it has to be the Child"), joint.nameRange);
    }
    const double off = besideAxle(joint, inActor(index) * tread->pose.position), gap = gapBelow(index, *tread);
    if (std::string reason = whyNoWheel(joint, body(index).name, *tread, onlyGeom(body(index)) != nullptr, off); !reason.empty())
        return std::abs(gap) < kOnGround + off && refuse(std::move(reason), joint.nameRange);
    if (besideAxle(joint, inActor(index) * body(index).mass.centre) > kTouching)
        return refuse(named("wheel", body(index).name, "has its centre of mass beside its axle"), joint.nameRange);
    return isOnGround("wheel", joint, gap);
}

/// Height of its lowest point above the ground.
double ActorReader::gapBelow(std::uint32_t index, const GeomSpec& round) const {
    return m_actor->frame.position.z() + (inActor(index) * round.pose.position).z() - round.radius - m_ground.height;
}

/// A ball in a socket on the ground, in which it turns freely.
bool ActorReader::isCaster(const JointSpec& joint) {
    const auto index = static_cast<std::uint32_t>(joint.child);
    const GeomSpec* geom = onlyGeom(body(index));
    if (!geom || geom->shape != GeomShape::Sphere || joint.swingStop || joint.stiffness > 0) return false;
    const std::string& name = body(index).name;
    if (joint.damping > 0)
        return refuse(named("the Ball", joint.name, "has a Damping; a caster turns freely in its joint"), joint.nameRange);
    if (hasRollingFriction(*geom)) return refuse(named("caster", name, "has rolling friction"), joint.nameRange);
    if ((body(index).mass.centre - geom->pose.position).norm() > kTouching)
        return refuse(named("caster", name, "has a centre of mass that is not its middle"), joint.nameRange);
    const Vec3 centre = inActor(index) * geom->pose.position;
    return (centre - joint.anchor).norm() < kTouching && isOnGround("caster", joint, gapBelow(index, *geom));
}

bool ActorReader::isOnGround(const char* kind, const JointSpec& joint, double gap) {
    if (std::abs(gap) < kOnGround) return true;
    char text[64];
    std::snprintf(text, sizeof text, "is %.1f mm %s the ground at the start", 1e3 * std::abs(gap), gap > 0 ? "above" : "in");
    return refuse(named(kind, body(static_cast<std::uint32_t>(joint.child)).name, text), joint.nameRange);
}

} // namespace trundle
