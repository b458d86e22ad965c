#include "scene/scene.h"

#include <map>

#include "scene/geom_nodes.h"
#include "scene/osg_types.h"
#include "scene/surroundings.h"

namespace trundle {
namespace {

constexpr double kFloorReach = 400, kFloorReachInRadii = 60; // m: half the side of a floor that has no end

Bounds boundsOf(const osg::Node& node) {
    Bounds bounds;
    const osg::BoundingSphere& sphere = node.getBound();
    if (sphere.valid()) {
        const Vec3 centre(sphere.center().x(), sphere.center().y(), sphere.center().z());
        bounds.add(centre);
        bounds.grow(sphere.radius());
    }
    return bounds;
}

bool isSane(const Pose& pose) { return pose.position.allFinite() && pose.rotation.coeffs().allFinite() && pose.position.norm() < 1e6; }

} // namespace

Scene::Scene(const ExperimentSpec& experiment) {
    m_look.applyTo(*m_root->getOrCreateStateSet());
    m_robots->setNodeMask(kMaskRobots);
    m_statics->setNodeMask(kMaskStatics);
    m_root->addChild(m_robots);
    m_root->addChild(m_statics);
    addRobots(experiment);
    addStatics(experiment);
    addSurroundings(experiment);
}

void Scene::addRobots(const ExperimentSpec& experiment) {
    // Robots of one config share all geometry: only where they stand is their own.
    std::map<const RobotConfigSpec*, std::vector<osg::ref_ptr<osg::Group>>> known;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        auto [entry, isNew] = known.try_emplace(robot.config.get());
        if (isNew) {
            for (const BodySpec& body : robot.config->bodies) {
                entry->second.push_back(makeGeomNode(body.geoms, experiment.materials, m_look));
                ++m_sharedNodes;
            }
        }
        osg::ref_ptr<osg::Group> node = new osg::Group;
        node->setName(robot.name);
        for (std::size_t i = 0; i < robot.config->bodies.size(); ++i) {
            osg::ref_ptr<osg::MatrixTransform> body = new osg::MatrixTransform;
            body->setName(robot.config->bodies[i].name);
            body->setDataVariance(osg::Object::DYNAMIC);
            if (entry->second[i]->getNumChildren() > 0) body->addChild(entry->second[i]);
            node->addChild(body);
            m_bodies.push_back(body);
        }
        m_robots->addChild(node);
    }
    setPoses(startPoses(experiment));
}

void Scene::addStatics(const ExperimentSpec& experiment) {
    std::map<const std::vector<GeomSpec>*, osg::ref_ptr<osg::Group>> known;
    for (const StaticSpec& fixed : experiment.statics) {
        if (!fixed.geoms || !isSane(fixed.pose)) continue;
        auto [entry, isNew] = known.try_emplace(fixed.geoms.get());
        if (isNew) {
            entry->second = makeGeomNode(*fixed.geoms, experiment.materials, m_look);
            ++m_sharedNodes;
        }
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(fixed.pose));
        node->setName(fixed.name);
        node->addChild(entry->second);
        m_statics->addChild(node);
    }
}

void Scene::addSurroundings(const ExperimentSpec& experiment) {
    const std::vector<FloorPlane> floors = floorPlanes(experiment);
    const Bounds about = bounds();
    const double reach = std::max(kFloorReach, kFloorReachInRadii * about.radius());
    m_look.haze->set(static_cast<float>(reach / 5));
    if (const auto level = levelFloor(floors)) {
        m_floorHeight = floors[*level].pose.position.z();
        m_look.ground->set(static_cast<float>(*m_floorHeight));
    }

    osg::ref_ptr<osg::Group> floorGroup = new osg::Group, sharp = new osg::Group, soft = new osg::Group;
    osg::ref_ptr<osg::Group> casters = new osg::Group;
    casters->addChild(m_robots);
    casters->addChild(m_statics);
    const osg::Vec3 sun = sunDirection();
    for (unsigned i = 0; i < floors.size(); ++i) {
        floorGroup->addChild(makeFloorNode(floors[i], i, about, reach, m_look));
        if (i >= kShadowedFloors || floors[i].normal().dot(Vec3(sun.x(), sun.y(), sun.z())) < 0.2) continue;
        sharp->addChild(makeSharpShadow(floors[i], i, *casters, m_look));
        soft->addChild(makeSoftShadow(floors[i], i, *casters, m_look));
    }
    osg::ref_ptr<osg::Node> sky = makeSkyNode(m_look);
    floorGroup->setNodeMask(kMaskFloor);
    sharp->setNodeMask(kMaskShadows);
    soft->setNodeMask(kMaskSoftShadows);
    sky->setNodeMask(kMaskSky);
    for (osg::Node* node :
         {static_cast<osg::Node*>(floorGroup), static_cast<osg::Node*>(sharp), static_cast<osg::Node*>(soft), sky.get()})
        m_root->addChild(node);
}

void Scene::setPoses(const BodyPoses& poses) {
    if (poses.size() != m_bodies.size()) return;
    for (std::size_t i = 0; i < poses.size(); ++i) if (isSane(poses[i])) m_bodies[i]->setMatrix(toOsg(poses[i]));
}

Bounds Scene::bounds() const {
    Bounds all;
    for (const osg::Group* group : {m_robots.get(), m_statics.get()}) {
        for (unsigned i = 0; i < group->getNumChildren(); ++i) all.add(boundsOf(*group->getChild(i)));
    }
    return all;
}

} // namespace trundle
