// Bodies, geoms and statics of the ODE engine. ODE places a body's origin at its centre of mass, the specs at their own frame.
#include "world/ode/ode_engine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trundle {

namespace {

constexpr const char* kRefused = "its shape cannot be simulated; check its sizes, or build it from boxes, spheres and cylinders";
constexpr double kFewestSupports = 3; // minimum number of contacts that share an actor's weight, unless it is a single ball

/// Half the extent of a rotated box along each axis of the outer frame.
Vec3 reach(const Mat3& axes, const Vec3& half) { return axes.cwiseAbs() * half; }

} // namespace

Result<ActorHandles> OdeEngine::addActor(const ActorDef& def) {
    ActorHandles handles;
    std::string failure;
    try {
        prepareThread();
        buildActor(def, handles, failure);
    } catch (const OdeFault&) { failure = kRefused; }
    if (!failure.empty()) return Error{Code::BadGeometry, failure};
    return handles;
}

void OdeEngine::buildActor(const ActorDef& def, ActorHandles& handles, std::string& failure) {
    const auto index = static_cast<std::uint32_t>(m_actors.size());
    handles.actor = {index};
    m_actors.emplace_back();
    m_placed.push_back(index);
    Actor& actor = m_actors.back();
    actor.bodies.begin = static_cast<std::uint32_t>(m_bodies.size());
    actor.geoms.begin = static_cast<std::uint32_t>(m_geoms.size());
    actor.joints.begin = static_cast<std::uint32_t>(m_joints.size());
    for (const BodyDef& body : def.bodies) addBody(body, index, handles, failure);
    actor.bodies.end = static_cast<std::uint32_t>(m_bodies.size());
    actor.geoms.end = static_cast<std::uint32_t>(m_geoms.size());
    if (def.joints)
        for (const JointSpec& joint : *def.joints) {
            handles.joints.push_back({static_cast<std::uint32_t>(m_joints.size())});
            addJoint(joint, def, index);
        }
    actor.joints.end = static_cast<std::uint32_t>(m_joints.size());
    actor.jointed = actor.joints.end > actor.joints.begin;
    if (def.selfCollision) findSelfPairs(actor);

    const bool ball = actor.geoms.end - actor.geoms.begin == 1 && m_geoms[actor.geoms.begin].shape == GeomShape::Sphere;
    const double gravity = std::max(9.81, m_settings.gravity.norm());
    actor.stiffness = std::max(kContactStiffness, actor.mass * gravity / ((ball ? 1 : kFewestSupports) * kMaxSag));
    for (std::uint32_t i = actor.joints.begin; i < actor.joints.end; ++i)
        if (m_joints[i].type == JointType::Suspension) {
            actor.stiffness *= kSuspendedStiffness;
            break;
        }
    actor.damping = kContactDamping * actor.stiffness / kContactStiffness;
    m_actorBoxes.emplace_back();
    m_bodiesDone = false;
    for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) publishBody(i);
}

void OdeEngine::addBody(const BodyDef& def, std::uint32_t actor, ActorHandles& handles, std::string& failure) {
    const BodySpec& spec = *def.spec;
    const auto index = static_cast<std::uint32_t>(m_bodies.size());
    handles.bodies.push_back({index});
    Body body;
    body.id = dBodyCreate(m_world);
    body.actor = actor;
    body.centre = spec.mass.centre;
    body.range = spec.range;
    const Mat3& i = spec.mass.inertia;
    dMass mass;
    dMassSetZero(&mass);
    dMassSetParameters(&mass, spec.mass.mass, 0, 0, 0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    dBodySetMass(body.id, &mass);
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
    body.geoms.begin = static_cast<std::uint32_t>(m_geoms.size());
    m_bodies.push_back(body);
    m_rotation.add(spec.mass.inertia);
    m_states.emplace_back();
    m_actors[actor].mass += spec.mass.mass;
    auto& geoms = handles.geoms.emplace_back();
    for (const GeomSpec& geom : spec.geoms) {
        const bool made = geom.collide && addGeom(geom, index, failure);
        geoms.push_back(made ? GeomHandle{static_cast<std::uint32_t>(m_geoms.size() - 1)} : GeomHandle{});
    }
    m_bodies[index].geoms.end = static_cast<std::uint32_t>(m_geoms.size());
}

bool OdeEngine::addGeom(const GeomSpec& spec, std::uint32_t body, std::string& failure) {
    Result<OdeShape> made = makeShape(spec);
    if (!made) {
        failure = made.error().message;
        return false;
    }
    const OdeShape& shape = made.value();
    const Pose pose = spec.pose * shape.centre;
    Geom geom;
    geom.shape = spec.shape == GeomShape::Mesh && spec.collideAsHull ? GeomShape::Convex : spec.shape;
    geom.actor = m_bodies[body].actor;
    geom.body = body;
    geom.surface = spec.surface;
    geom.id = shape.id;
    geom.data = shape.data;
    geom.offset = pose.position - m_bodies[body].centre;
    geom.axes = pose.rotation.toRotationMatrix();
    geom.turned = !pose.rotation.isApprox(Quat::Identity(), 0);
    geom.half = shape.half;
    geom.radius = spec.radius;
    geom.bound = shape.bound;
    m_bodies[body].thin = std::min(m_bodies[body].thin, geom.half.minCoeff());
    m_bodies[body].reach = std::max(m_bodies[body].reach, geom.offset.norm() + geom.bound);
    dGeomSetBody(geom.id, m_bodies[body].id);
    dReal q[4];
    toOde(pose.rotation, q);
    dGeomSetOffsetPosition(geom.id, geom.offset.x(), geom.offset.y(), geom.offset.z());
    dGeomSetOffsetQuaternion(geom.id, q);
    m_geoms.push_back(std::move(geom));
    m_centres.emplace_back();
    m_boxes.emplace_back();
    return true;
}

Result<GeomHandle> OdeEngine::addStatic(const GeomSpec& spec, const Pose& at) {
    try {
        prepareThread();
        Geom geom;
        geom.shape = spec.shape == GeomShape::Mesh && spec.collideAsHull ? GeomShape::Convex : spec.shape;
        geom.surface = spec.surface;
        geom.radius = spec.shape == GeomShape::Heightfield ? spec.size.z() : spec.radius;
        const auto index = static_cast<std::uint32_t>(m_geoms.size());
        Pose pose = at;
        if (spec.shape == GeomShape::Plane) {
            const Vec3 normal = (at.rotation * Vec3::UnitZ()).normalized();
            const double distance = normal.dot(at.position);
            geom.id = dCreatePlane(nullptr, normal.x(), normal.y(), normal.z(), distance);
            m_planes.push_back({index, normal, distance});
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
            m_statics.push_back(index);
        }
        geom.axes = pose.rotation.toRotationMatrix();
        m_sweep.addScenery(geom);
        const Vec3 half = reach(geom.axes, geom.half), lo = pose.position - half, hi = pose.position + half;
        m_geoms.push_back(std::move(geom));
        m_centres.push_back(pose.position);
        m_boxes.push_back({{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}});
        m_staticsDone = false;
        return GeomHandle{index};
    } catch (const OdeFault&) { return Error{Code::BadGeometry, spec.name + ": " + kRefused}; }
}

void OdeEngine::finishStatics() {
    std::vector<Box3> boxes;
    for (const std::uint32_t geom : m_statics) boxes.push_back(m_boxes[geom]);
    m_grid.build(std::move(boxes));
    m_staticsDone = true;
}

void OdeEngine::finishBodies() {
    m_pinned.start(m_bodies, m_joints, m_settings.gravity);
    m_rotation.start(m_bodies, m_joints, m_pinned);
    m_drift.setUp(m_bodies, m_joints);
    m_plan.setUp(m_bodies, m_joints);
    m_bodiesDone = true;
}

/// Finds all pairs of geoms whose bodies differ and are not directly joined.
void OdeEngine::findSelfPairs(Actor& actor) {
    for (std::uint32_t a = actor.geoms.begin; a < actor.geoms.end; ++a)
        for (std::uint32_t b = a + 1; b < actor.geoms.end; ++b) {
            const std::uint32_t x = m_geoms[a].body, y = m_geoms[b].body;
            bool joined = x == y;
            for (std::uint32_t j = actor.joints.begin; j < actor.joints.end && !joined; ++j)
                joined =
                    (m_joints[j].child == x && m_joints[j].parent == y) || (m_joints[j].child == y && m_joints[j].parent == x);
            if (!joined) actor.selfPairs.emplace_back(a, b);
        }
}

} // namespace trundle
