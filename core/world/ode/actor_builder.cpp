#include "world/ode/actor_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/mass_properties.h"

namespace trundle {

namespace {

constexpr const char* kRefused = "its shape cannot be simulated; check its sizes, or build it from boxes, spheres and cylinders";

/// Half the extent of a rotated box along each axis of the outer frame.
Vec3 reach(const Mat3& axes, const Vec3& half) { return axes.cwiseAbs() * half; }

/// The signs, along the axes that the shape has here, of those that the text gives it.
Vec3 writtenAxes(const GeomSpec& geom) {
    return (shapeRotation(geom).conjugate() * geom.pose.rotation).toRotationMatrix().diagonal().array().round();
}

} // namespace

Result<ActorHandles> ActorBuilder::addActor(const ActorDef& def) {
    ActorHandles handles;
    std::string failure;
    try {
        prepareThread();
        buildActor(def, handles, failure);
    } catch (const OdeFault&) { failure = kRefused; }
    if (failure.empty()) return handles;
    removeLast();
    return Error{Code::BadGeometry, failure};
}

/// What there is of an actor that could not be built. A part that ODE itself could not make stays in its world, joined to nothing.
void ActorBuilder::removeLast() {
    const OdeActor actor = m_objects.actors.back();
    try {
        for (std::size_t i = actor.geoms.begin; i < m_objects.geoms.size(); ++i)
            if (const dGeomID id = m_objects.geoms[i].id) dGeomDestroy(id);
        for (std::size_t i = actor.bodies.begin; i < m_objects.bodies.size(); ++i) {
            const dBodyID body = m_objects.bodies[i].id;
            while (dBodyGetNumJoints(body) > 0) dJointDestroy(dBodyGetJoint(body, 0));
            dBodyDestroy(body);
        }
    } catch (const OdeFault&) { // better lost than dead
    }
    m_objects.actors.pop_back();
    m_objects.actorBoxes.resize(m_objects.actors.size());
    m_objects.bodies.resize(actor.bodies.begin);
    m_objects.inertias.resize(actor.bodies.begin);
    m_objects.states.resize(actor.bodies.begin);
    m_objects.geoms.resize(actor.geoms.begin);
    m_objects.centres.resize(actor.geoms.begin);
    m_objects.boxes.resize(actor.geoms.begin);
    m_objects.joints.resize(actor.joints.begin);
    m_objects.couplings.resize(actor.couplings.begin);
    m_rows.forget(actor.joints.begin);
}

void ActorBuilder::buildActor(const ActorDef& def, ActorHandles& handles, std::string& failure) {
    const auto index = static_cast<std::uint32_t>(m_objects.actors.size());
    handles.actor = {index};
    m_objects.actors.emplace_back();
    OdeActor& actor = m_objects.actors.back();
    actor.bodies.begin = static_cast<std::uint32_t>(m_objects.bodies.size());
    actor.geoms.begin = static_cast<std::uint32_t>(m_objects.geoms.size());
    actor.joints.begin = static_cast<std::uint32_t>(m_objects.joints.size());
    actor.couplings.begin = static_cast<std::uint32_t>(m_objects.couplings.size());
    for (const BodyDef& body : def.bodies) addBody(body, index, handles, failure);
    actor.bodies.end = static_cast<std::uint32_t>(m_objects.bodies.size());
    actor.geoms.end = static_cast<std::uint32_t>(m_objects.geoms.size());
    if (!failure.empty()) return;
    if (def.joints)
        for (const JointSpec& joint : *def.joints) {
            handles.joints.push_back({static_cast<std::uint32_t>(m_objects.joints.size())});
            m_joints.addJoint(joint, def, index);
        }
    actor.joints.end = static_cast<std::uint32_t>(m_objects.joints.size());
    handles.couplings = m_couplings.add(def, index);
    actor.couplings.end = static_cast<std::uint32_t>(m_objects.couplings.size());
    actor.jointed = actor.joints.end > actor.joints.begin || actor.couplings.end > actor.couplings.begin;
    if (def.selfCollision) findSelfPairs(actor, def);

    setStiffness(actor);
    m_objects.actorBoxes.emplace_back();
    for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) m_objects.publish(i);
}

/// Of its contacts: so that it sags by no more than kMaxSag under its weight.
void ActorBuilder::setStiffness(OdeActor& actor) const {
    const bool ball = actor.geoms.end - actor.geoms.begin == 1 && m_objects.geoms[actor.geoms.begin].shape == GeomShape::Sphere;
    const double gravity = std::max(9.81, m_settings.gravity.norm());
    actor.stiffness = std::max(kContactStiffness, actor.mass * gravity / ((ball ? 1 : kFewestSupports) * kMaxSag));
    bool isSprung = false;
    for (std::uint32_t i = actor.joints.begin; i < actor.joints.end; ++i)
        isSprung = isSprung || m_objects.joints[i].type == JointType::Suspension;
    for (std::uint32_t i = actor.couplings.begin; i < actor.couplings.end; ++i)
        isSprung = isSprung || !m_objects.couplings[i].isGear;
    if (isSprung) actor.stiffness *= kSuspendedStiffness;
    actor.damping = kContactDamping * actor.stiffness / kContactStiffness;
}

void ActorBuilder::addBody(const BodyDef& def, std::uint32_t actor, ActorHandles& handles, std::string& failure) {
    const BodySpec& spec = *def.spec;
    const auto index = static_cast<std::uint32_t>(m_objects.bodies.size());
    handles.bodies.push_back({index});
    OdeBody body;
    body.id = dBodyCreate(m_world);
    body.actor = actor;
    body.centre = spec.mass.centre;
    body.range = spec.range;
    const Mat3& i = spec.mass.inertia;
    dMass mass;
    dMassSetZero(&mass);
    if (spec.isFixed) dMassSetParameters(&mass, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0);
    else dMassSetParameters(&mass, spec.mass.mass, 0, 0, 0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    dBodySetMass(body.id, &mass);
    if (spec.isFixed) dBodySetKinematic(body.id);
    dBodySetGyroscopicMode(body.id, 0);
    const Vec3 at = def.pose * body.centre;
    dReal q[4];
    toOde(def.pose.rotation, q);
    dBodySetPosition(body.id, at.x(), at.y(), at.z());
    dBodySetQuaternion(body.id, q);
    body.p = dBodyGetPosition(body.id);
    body.r = dBodyGetRotation(body.id);
    body.q = dBodyGetQuaternion(body.id);
    body.v = dBodyGetLinearVel(body.id);
    body.w = dBodyGetAngularVel(body.id);
    body.geoms.begin = static_cast<std::uint32_t>(m_objects.geoms.size());
    m_objects.bodies.push_back(body);
    m_objects.inertias.push_back(spec.isFixed ? Mat3::Identity() : spec.mass.inertia);
    m_objects.states.emplace_back();
    m_objects.actors[actor].mass += spec.mass.mass;
    auto& geoms = handles.geoms.emplace_back();
    for (const GeomSpec& geom : spec.geoms) {
        const bool made = geom.collide && addGeom(geom, index, failure);
        geoms.push_back(made ? GeomHandle{static_cast<std::uint32_t>(m_objects.geoms.size() - 1)} : GeomHandle{});
    }
    m_objects.bodies[index].geoms.end = static_cast<std::uint32_t>(m_objects.geoms.size());
}

bool ActorBuilder::addGeom(const GeomSpec& spec, std::uint32_t body, std::string& failure) {
    Result<OdeShape> made = makeShape(spec);
    if (!made) {
        failure = made.error().message;
        return false;
    }
    const OdeShape& shape = made.value();
    const Pose pose = Pose{spec.pose.position, shapeRotation(spec)} * shape.centre;
    OdeGeom geom;
    geom.shape = spec.shape == GeomShape::Mesh && spec.collideAsHull ? GeomShape::Convex : spec.shape;
    geom.actor = m_objects.bodies[body].actor;
    geom.body = body;
    geom.surface = spec.surface;
    geom.id = shape.id;
    geom.data = shape.data;
    geom.offset = pose.position - m_objects.bodies[body].centre;
    geom.axes = pose.rotation.toRotationMatrix();
    geom.written = writtenAxes(spec);
    geom.turned = !pose.rotation.isApprox(Quat::Identity(), 0);
    geom.half = shape.half;
    geom.radius = spec.radius;
    geom.bound = shape.bound;
    m_objects.bodies[body].thin = std::min(m_objects.bodies[body].thin, geom.half.minCoeff());
    m_objects.bodies[body].reach = std::max(m_objects.bodies[body].reach, geom.offset.norm() + geom.bound);
    dGeomSetBody(geom.id, m_objects.bodies[body].id);
    dReal q[4];
    toOde(pose.rotation, q);
    dGeomSetOffsetPosition(geom.id, geom.offset.x(), geom.offset.y(), geom.offset.z());
    dGeomSetOffsetQuaternion(geom.id, q);
    m_objects.geoms.push_back(std::move(geom));
    m_objects.centres.emplace_back();
    m_objects.boxes.emplace_back();
    return true;
}

Result<GeomHandle> ActorBuilder::addStatic(const GeomSpec& spec, const Pose& at) {
    try {
        prepareThread();
        OdeGeom geom;
        geom.shape = spec.shape == GeomShape::Mesh && spec.collideAsHull ? GeomShape::Convex : spec.shape;
        geom.surface = spec.surface;
        geom.radius = spec.shape == GeomShape::Heightfield ? spec.size.z() : spec.radius;
        const auto index = static_cast<std::uint32_t>(m_objects.geoms.size());
        Pose pose = at;
        if (spec.shape == GeomShape::Plane) {
            const Vec3 normal = (at.rotation * Vec3::UnitZ()).normalized();
            const double distance = normal.dot(at.position);
            geom.id = dCreatePlane(nullptr, normal.x(), normal.y(), normal.z(), distance);
            m_objects.planes.push_back({index, normal, distance});
        } else {
            Result<OdeShape> made = makeShape(spec);
            if (!made) return made.error();
            pose = at * made.value().centre;
            geom.id = made.value().id;
            geom.data = made.value().data;
            geom.half = made.value().half;
            geom.bound = made.value().bound;
            dReal q[4];
            toOde(pose.rotation, q);
            dGeomSetPosition(geom.id, pose.position.x(), pose.position.y(), pose.position.z());
            dGeomSetQuaternion(geom.id, q);
        }
        geom.axes = pose.rotation.toRotationMatrix();
        geom.written = writtenAxes(spec);
        const Vec3 half = reach(geom.axes, geom.half), lo = pose.position - half, hi = pose.position + half;
        if (spec.shape != GeomShape::Plane) m_objects.statics.push_back(index);
        m_objects.geoms.push_back(std::move(geom));
        m_objects.centres.push_back(pose.position);
        m_objects.boxes.push_back({{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}});
        return GeomHandle{index};
    } catch (const OdeFault&) { return Error{Code::BadGeometry, spec.name + ": " + kRefused}; }
}

/// The two bodies do not touch each other, as those that a joint of one actor joins.
Result<JointHandle> ActorBuilder::addJoint(const JointSpec& spec, std::uint32_t child, std::uint32_t parent) {
    try {
        prepareThread();
        m_joints.addLink(spec, child, parent);
    } catch (const OdeFault&) { return Error{Code::BadJoint, spec.name + ": it cannot be simulated"}; }
    markLinked(child, parent);
    if (parent != kNone) (void)m_objects.separateBodies(child, parent);
    return JointHandle{static_cast<std::uint32_t>(m_objects.joints.size() - 1)};
}

Result<CouplingHandle> ActorBuilder::addSpring(const SpringSpec& spec, std::uint32_t child, std::uint32_t parent) {
    try {
        prepareThread();
        const CouplingHandle added = m_couplings.addLink(spec, child, parent);
        markLinked(child, parent);
        return added;
    } catch (const OdeFault&) { return Error{Code::BadJoint, spec.name + ": it cannot be simulated"}; }
}

void ActorBuilder::markLinked(std::uint32_t child, std::uint32_t parent) {
    for (const std::uint32_t body : {child, parent})
        if (body != kNone) m_objects.actors[m_objects.bodies[body].actor].jointed = true;
}

/// Finds all pairs of geoms whose bodies differ, are not directly joined, and are to touch each other.
void ActorBuilder::findSelfPairs(OdeActor& actor, const ActorDef& def) const {
    const auto isApart = [&](std::uint32_t x, std::uint32_t y) {
        const auto first = static_cast<int>(x - actor.bodies.begin), second = static_cast<int>(y - actor.bodies.begin);
        return def.noContact && std::ranges::binary_search(*def.noContact, std::pair(std::min(first, second), std::max(first, second)));
    };
    for (std::uint32_t a = actor.geoms.begin; a < actor.geoms.end; ++a)
        for (std::uint32_t b = a + 1; b < actor.geoms.end; ++b) {
            const std::uint32_t x = m_objects.geoms[a].body, y = m_objects.geoms[b].body;
            bool joined = x == y;
            for (std::uint32_t j = actor.joints.begin; j < actor.joints.end && !joined; ++j)
                joined = (m_objects.joints[j].child == x && m_objects.joints[j].parent == y) ||
                         (m_objects.joints[j].child == y && m_objects.joints[j].parent == x);
            if (!joined && !isApart(x, y)) actor.selfPairs.emplace_back(a, b);
        }
}

} // namespace trundle
