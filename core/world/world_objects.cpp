#include "world/world_objects.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "model/mass_properties.h"
#include "model/object_numbers.h"
#include "model/passive_objects.h"
#include "world/engine_links.h"
#include "world/reflectance.h"
#include "world/signal_plan.h"

namespace trundle {

namespace {

template <class List> std::vector<std::size_t> byName(const List& list) {
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return list[a].name < list[b].name; });
    return order;
}

/// Of a joint between robots, whose anchor and axis are in the world.
JointLocation placeOf(const Link<JointSpec>& link, const std::vector<BuiltRobot>& robots) {
    const JointSpec& joint = link.spec;
    const Vec3& axis = joint.type == JointType::Suspension ? joint.axis2 : joint.axis;
    if (link.parentRobot == kWorldBody) return {0, false, joint.anchor, axis};
    const BuiltRobot& robot = robots[static_cast<std::size_t>(link.parentRobot)];
    const auto body = static_cast<std::size_t>(joint.parent);
    const Pose inParent = (robot.spec->pose * robot.spec->config->bodies[body].pose).inverse();
    return {robot.handles.bodies[body].index, true, inParent * joint.anchor, inParent.rotation * axis};
}

JointLocation placeOf(const JointSpec& joint, const BuiltRobot& robot) {
    const Vec3& axis = joint.type == JointType::Suspension ? joint.axis2 : joint.axis; // the axis of rotation
    if (joint.parent == kWorldBody) return {0, false, robot.spec->pose * joint.anchor, robot.spec->pose.rotation * axis};
    const auto parent = static_cast<std::size_t>(joint.parent);
    const Pose inParent = robot.spec->config->bodies[parent].pose.inverse();
    return {robot.handles.bodies[parent].index, true, inParent * joint.anchor, inParent.rotation * axis};
}

} // namespace

void WorldObjects::build(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.errorCount();
    for (const MaterialSpec& material : experiment.materials) {
        m_reflectances.push_back(reflectanceOf(material));
        m_hasPicture.push_back(material.picture != nullptr);
    }
    m_lights = lightsOf(experiment);
    m_robots.resize(experiment.robots.size());
    buildScenery(experiment, engine, diagnostics);
    buildRobots(experiment, engine, diagnostics);
    if (diagnostics.errorCount() == before) buildLinks(experiment, engine, diagnostics);
    if (diagnostics.errorCount() > before) return;
    const FirstObjects first = firstObjects(experiment);
    for (const BuiltRobot& robot : m_robots) {
        const auto index = static_cast<std::size_t>(&robot - m_robots.data());
        m_robotByName.emplace(robot.spec->name, static_cast<std::uint32_t>(index));
        nameBodies(robot, first.robots[index]);
        locateJoints(robot);
    }
    for (std::size_t i = 0; i < m_joints.size(); ++i)
        locate(m_joints[i], experiment.joints[i].spec.type, placeOf(experiment.joints[i], m_robots));
}

/// Sorted by name, so that the result does not depend on the order of blocks in the text.
void WorldObjects::buildScenery(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics) {
    const FirstObjects first = firstObjects(experiment);
    for (const std::size_t i : byName(experiment.statics)) {
        const StaticSpec& s = experiment.statics[i];
        if (!s.geoms) continue;
        const auto own =
            std::ranges::find_if(experiment.robots, [&](const RobotSpec& r) { return r.scenery && r.name == s.name; });
        BuiltRobot* const moving =
            own == experiment.robots.end() ? nullptr : &m_robots[static_cast<std::size_t>(own - experiment.robots.begin())];
        for (const GeomSpec& g : *s.geoms) {
            if (!g.collide) {
                if (moving) moving->scenery.emplace_back();
                else m_marks.add(g, s.pose * g.pose);
                continue;
            }
            const auto id = engine.addStatic(g, s.pose * Pose{g.pose.position, shapeRotation(g)});
            if (!id) {
                diagnostics.error(id.error().code, g.nameRange, s.name + "/" + id.error().message);
                continue;
            }
            const auto object = first.statics[i] + static_cast<std::uint32_t>(&g - s.geoms->data());
            addGeom(id.value().index, {s.name + "/" + g.name, &g, BuiltGeom::kNoBody, s.pose * g.pose, object});
            if (moving) moving->scenery.push_back(id.value());
        }
    }
}

void WorldObjects::buildRobots(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics) {
    for (const std::size_t i : byName(experiment.robots)) {
        const RobotSpec& spec = experiment.robots[i];
        BuiltRobot& robot = m_robots[i];
        robot.spec = &spec;
        ActorDef def{spec.pose,
                     {},
                     &spec.config->joints,
                     spec.config->selfCollision,
                     &spec.config->springs,
                     &spec.config->gears,
                     &spec.config->noContact};
        for (const BodySpec& body : spec.config->bodies) def.bodies.push_back({spec.pose * body.pose, &body});
        auto made = engine.addActor(def);
        if (!made) {
            diagnostics.error(made.error().code, spec.nameRange, spec.name + "/" + made.error().message);
            continue;
        }
        robot.handles = std::move(made).value();
        const Pose& first = spec.config->bodies[0].pose;
        robot.frameInFirst = first.inverse();
        if (isPassive(spec)) robot.centre = first * spec.config->bodies[0].mass.centre;
        robot.frameIsFirst = first.position.isZero(0) && first.rotation.coeffs() == Quat::Identity().coeffs();
    }
}

/// In text order, after all actors.
void WorldObjects::buildLinks(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics) {
    if (!engine.links) return; // what it cannot join was refused with the experiment
    const auto bodyOf = [&](int robot, int body) {
        return robot == kWorldBody ? BodyHandle{}
                                   : m_robots[static_cast<std::size_t>(robot)].handles.bodies[static_cast<std::size_t>(body)];
    };
    const auto add = [&](const auto& link, auto& handles, auto made) {
        if (made) handles.push_back(made.value());
        else diagnostics.error(made.error().code, link.spec.nameRange, made.error().message);
    };
    for (const auto& link : experiment.joints)
        add(link, m_joints,
            engine.links->addJoint(link.spec, bodyOf(link.childRobot, link.spec.child),
                                   bodyOf(link.parentRobot, link.spec.parent)));
    for (const auto& link : experiment.springs)
        add(link, m_springs,
            engine.links->addSpring(link.spec, bodyOf(link.childRobot, link.spec.child),
                                    bodyOf(link.parentRobot, link.spec.parent)));
    for (const auto& [first, second] : experiment.noContact)
        engine.links->separate(m_robots[first].handles.actor, m_robots[second].handles.actor);
}

void WorldObjects::moveWorldJoints(const BuiltRobot& robot, const Pose& motion) {
    for (const JointHandle joint : robot.handles.joints) {
        JointLocation& location = m_jointLocations[joint.index];
        if (!location.carried) location = {0, false, motion * location.anchor, motion.rotation * location.axis};
    }
}

void WorldObjects::addGeom(std::uint32_t index, BuiltGeom geom) {
    m_geoms.resize(std::max<std::size_t>(m_geoms.size(), index + 1));
    const std::uint32_t material = geom.spec->material;
    if (material < m_hasPicture.size() && m_hasPicture[material]) std::tie(geom.low, geom.size) = pictureBox(*geom.spec);
    m_geoms[index] = std::move(geom);
}

void WorldObjects::nameBodies(const BuiltRobot& robot, std::uint32_t firstObject) {
    const auto& bodies = robot.spec->config->bodies;
    std::uint32_t object = firstObject;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const std::uint32_t id = robot.handles.bodies[b].index;
        m_bodyPaths.resize(std::max<std::size_t>(m_bodyPaths.size(), id + 1));
        m_bodyRanges.resize(m_bodyPaths.size());
        m_bodyPaths[id] = robot.spec->name + "/" + bodies[b].name;
        m_bodyRanges[id] = bodies[b].nameRange;
        m_isFixed.resize(m_bodyPaths.size());
        m_isFixed[id] = robot.isFixed(b);
        m_bodyByPath.emplace(m_bodyPaths[id], id);
        for (std::size_t g = 0; g < bodies[b].geoms.size(); ++g, ++object) {
            const GeomHandle geom = robot.handles.geoms[b][g];
            const GeomSpec& spec = bodies[b].geoms[g];
            if (geom.valid()) addGeom(geom.index, {m_bodyPaths[id] + "/" + spec.name, &spec, id, spec.pose, object});
        }
    }
}

void WorldObjects::locateJoints(const BuiltRobot& robot) {
    const auto& joints = robot.spec->config->joints;
    for (std::size_t j = 0; j < joints.size(); ++j) locate(robot.handles.joints[j], joints[j].type, placeOf(joints[j], robot));
}

void WorldObjects::locate(JointHandle joint, JointType type, const JointLocation& location) {
    const std::uint32_t id = joint.index;
    m_jointTypes.resize(std::max<std::size_t>(m_jointTypes.size(), id + 1), JointType::Fixed);
    m_jointTypes[id] = type;
    m_jointLocations.resize(m_jointTypes.size());
    m_jointLocations[id] = location;
}

Pose WorldObjects::framePose(const BuiltRobot& robot, const Engine& engine, std::uint64_t ticks) {
    if (ticks == 0) return robot.spec->pose;
    const BodyState& first = engine.state(robot.handles.bodies[0]);
    const Pose body{first.position, first.rotation};
    return robot.frameIsFirst ? body : body * robot.frameInFirst;
}

Pose WorldObjects::reportedPose(const BuiltRobot& robot, const Engine& engine, std::uint64_t ticks) {
    Pose pose = framePose(robot, engine, ticks);
    if (robot.centre) pose.position = pose * *robot.centre;
    return pose;
}

std::pair<const BuiltRobot*, std::size_t> WorldObjects::ownerOf(BodyHandle body) const {
    for (const BuiltRobot& robot : m_robots) {
        const auto& bodies = robot.handles.bodies;
        const auto found = std::find(bodies.begin(), bodies.end(), body);
        if (found != bodies.end()) return {&robot, static_cast<std::size_t>(found - bodies.begin())};
    }
    return {nullptr, 0};
}

const std::uint32_t* WorldObjects::findBody(const std::string& path) const {
    const auto found = m_bodyByPath.find(path);
    return found == m_bodyByPath.end() ? nullptr : &found->second;
}

const BuiltRobot* WorldObjects::findRobot(const std::string& name) const {
    const auto found = m_robotByName.find(name);
    return found == m_robotByName.end() ? nullptr : &m_robots[found->second];
}

} // namespace trundle
