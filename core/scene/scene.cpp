#include "scene/scene.h"

#include <osg/PolygonMode>

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/osg_types.h"
#include "scene/nodes/point_impostor.h"
#include "scene/nodes/surroundings.h"

namespace trundle {
namespace {

constexpr double kFloorReach = 400, kFloorReachInRadii = 60; // m: half the side of an infinite floor's quad

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

/// Index of the largest body shape, whose impostor represents the whole robot; past the end if nothing is visible.
std::size_t largestOf(const std::vector<osg::ref_ptr<osg::Group>>& shapes) {
    const auto radius = [](const osg::ref_ptr<osg::Group>& each) { return each->getBound().radius(); };
    const auto largest =
        std::max_element(shapes.begin(), shapes.end(), [&](const auto& a, const auto& b) { return radius(a) < radius(b); });
    return std::size_t(largest - shapes.begin());
}

bool isSane(const Pose& pose) {
    return pose.position.allFinite() && pose.rotation.coeffs().allFinite() && pose.position.norm() < 1e6;
}

} // namespace

Scene::Scene(const ExperimentSpec& experiment, std::shared_ptr<ShapeStore> store, const ExperimentSpec* ghosts)
    : m_store(store ? std::move(store) : std::make_shared<ShapeStore>()), m_collision(*m_root, m_store->look), m_data(*m_root),
      m_overlay(*m_root, m_store->look) {
    SceneShading::applyTo(*m_root->getOrCreateStateSet(), m_uniforms);
    m_robots->setNodeMask(kMaskRobots | kMaskSolid);
    m_statics->setNodeMask(kMaskStatics | kMaskSolid);
    addRobots(experiment);
    addStatics(experiment);
    if (ghosts) addGhosts(*ghosts);
    addSurroundings(experiment);
}

osg::ref_ptr<osg::Group> Scene::addedGroup(osg::Group& root) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    root.addChild(group);
    return group;
}

void Scene::addRobots(const ExperimentSpec& experiment) {
    // Robots of one config share all geometry and differ only in their poses.
    struct ConfigShapes {
        std::vector<osg::ref_ptr<osg::Group>> shapes;
        std::size_t largest = 0;
        osg::ref_ptr<osg::Node> impostor;
    };
    std::unordered_map<const RobotConfigSpec*, ConfigShapes> known;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        auto [entry, isNew] = known.try_emplace(robot.config.get());
        auto& [shapes, largest, impostor] = entry->second;
        if (isNew) {
            const auto spokes = spokePatternsOf(*robot.config, experiment.materials);
            for (std::size_t i = 0; i < robot.config->bodies.size(); ++i)
                shapes.push_back(m_store->nodeOf(robot.config->bodies[i].geoms, experiment.materials, spokes[i]));
            largest = largestOf(shapes);
            if (largest < shapes.size()) impostor = makePointImpostor(*shapes[largest], m_store->look);
        }
        osg::ref_ptr<osg::Group> node = new osg::Group;
        node->setName(robot.name);
        for (std::size_t i = 0; i < robot.config->bodies.size(); ++i) {
            osg::ref_ptr<osg::MatrixTransform> body = new osg::MatrixTransform;
            body->setName(robot.config->bodies[i].name);
            body->setDataVariance(osg::Object::DYNAMIC);
            if (shapes[i]->getNumChildren() > 0) body->addChild(shapes[i]);
            if (i == largest && impostor) body->addChild(impostor);
            node->addChild(body);
            m_bodies.push_back(body);
            m_objects.add(robot.name + "/" + body->getName(), SceneObject{body, shapes[i]});
        }
        m_robots->addChild(node);
        if (!robot.scenery) m_objects.add(robot.name, SceneObject{node, nullptr});
    }
    const std::vector<LedModel> leds = ledsOf(experiment);
    m_leds.make(leds, m_bodies, m_store->look);
    m_ledLights.make(experiment, leds, m_bodies);
    setPoses(startPoses(experiment));
}

void Scene::addStatics(const ExperimentSpec& experiment) {
    std::unordered_map<const std::vector<GeomSpec>*, std::pair<osg::ref_ptr<osg::Group>, osg::ref_ptr<osg::Node>>> known;
    for (const StaticSpec& fixed : experiment.statics) {
        if (!fixed.geoms || !isSane(fixed.pose)) continue;
        auto [entry, isNew] = known.try_emplace(fixed.geoms.get());
        auto& [shapes, impostor] = entry->second;
        if (isNew) {
            shapes = m_store->nodeOf(*fixed.geoms, experiment.materials);
            impostor = makePointImpostor(*shapes, m_store->look);
            m_hasClearStatics = m_hasClearStatics || hasClearParts(*shapes);
        }
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(fixed.pose));
        node->setName(fixed.name);
        node->addChild(shapes);
        if (impostor) node->addChild(impostor);
        m_statics->addChild(node);
        m_objects.add(fixed.name, SceneObject{node, shapes});
    }
}

void Scene::addGhosts(const ExperimentSpec& ghosts) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setNodeMask(kMaskGhosts);
    group->setStateSet(m_store->look.ghosts);
    const auto add = [&](const Pose& pose, std::span<const GeomSpec> geoms) {
        if (!isSane(pose)) return;
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(pose));
        node->addChild(m_store->nodeOf(geoms, ghosts.materials));
        group->addChild(node);
    };
    for (const RobotSpec& robot : ghosts.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) add(robot.pose * body.pose, body.geoms);
    }
    for (const StaticSpec& fixed : ghosts.statics)
        if (fixed.geoms) add(fixed.pose, *fixed.geoms);
    m_root->addChild(group);
}

void Scene::addSurroundings(const ExperimentSpec& experiment) {
    const std::vector<FloorPlane> floors = floorPlanes(experiment);
    const Bounds about = bounds();
    const double reach = std::max(kFloorReach, kFloorReachInRadii * about.radius());
    m_uniforms.haze->set(static_cast<float>(reach / 5));
    if (const auto level = levelFloor(floors)) {
        m_floorHeight = floors[*level].pose.position.z();
        m_uniforms.ground->set(static_cast<float>(*m_floorHeight));
    }

    const SceneShading& look = m_store->look;
    osg::ref_ptr<osg::Group> floorGroup = new osg::Group, sharp = new osg::Group, soft = new osg::Group, lamps = new osg::Group;
    osg::ref_ptr<osg::Group> casters = new osg::Group;
    casters->addChild(m_robots);
    casters->addChild(m_statics);
    const Lighting lighting = lightingOf(experiment);
    lighting.applyTo(*m_root->getOrCreateStateSet());
    m_sun = Vec3(lighting.sun.x(), lighting.sun.y(), lighting.sun.z()).normalized();
    m_sunCasts = lighting.shadows && lighting.sunLight.length2() > 0;
    for (unsigned i = 0; i < floors.size(); ++i) {
        const osg::ref_ptr<osg::Node> floor = makeFloorNode(floors[i], i, about, reach, look, m_store->pictures, lighting);
        floorGroup->addChild(floor);
        m_objects.add(floors[i].path, SceneObject{floor->asGroup(), nullptr});
        if (i >= kShadowedFloors) continue;
        sharp->addChild(makeSharpShadow(floors[i], i, *casters, look, lighting));
        soft->addChild(makeSoftShadow(floors[i], i, *casters, look, lighting));
        lamps->addChild(makeLampShadows(floors[i], i, *casters, look, lighting));
    }
    if (floors.empty()) {
        const osg::ref_ptr<osg::Node> guide = makeGuideNode(about, reach, look);
        guide->setNodeMask(kMaskGuide);
        m_root->addChild(guide);
    }
    osg::ref_ptr<osg::Node> sky = makeSkyNode(look);
    floorGroup->setNodeMask(kMaskFloor);
    sharp->setNodeMask(kMaskShadows);
    soft->setNodeMask(kMaskSoftShadows);
    lamps->setNodeMask(kMaskShadows | kMaskSoftShadows | kMaskLampShadows);
    sky->setNodeMask(kMaskSky);
    for (const osg::ref_ptr<osg::Group>& group : {floorGroup, sharp, soft, lamps}) m_root->addChild(group);
    m_root->addChild(sky);
}

void Scene::setPoses(const BodyPoses& poses) {
    if (poses.size() != m_bodies.size()) return;
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (isSane(poses[i])) m_bodies[i]->setMatrix(toOsg(poses[i]));
    m_leds.set(poses.leds);
    m_ledLights.set(poses.leds);
    m_marks.followPoses();
    m_collision.followPoses();
    m_overlay.followPoses();
    if (poses.lines != m_lines) m_pens.set(poses.lines ? *poses.lines : std::vector<PenLine>(), m_store->look, m_store->pictures);
    m_lines = poses.lines;
}

void Scene::setWireframe(bool on) {
    if (on == m_wireframe) return;
    m_wireframe = on;
    for (osg::Group* group : {m_robots.get(), m_statics.get()}) {
        osg::StateSet* state = group->getOrCreateStateSet();
        if (!on) {
            state->removeAttribute(osg::StateAttribute::POLYGONMODE);
            continue;
        }
        state->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE),
                                    osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON);
    }
}

std::optional<SceneHit> Scene::pick(const ViewRay& ray, std::uint32_t mask) const {
    std::vector<SceneHit> hits = pickAll(ray, mask);
    return hits.empty() ? std::nullopt : std::optional(std::move(hits.front()));
}

Bounds Scene::bounds() const {
    Bounds all;
    for (const osg::Group* group : {m_robots.get(), m_statics.get()}) {
        for (unsigned i = 0; i < group->getNumChildren(); ++i) all.add(boundsOf(*group->getChild(i)));
    }
    return all;
}

} // namespace trundle
