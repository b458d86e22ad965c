#include "editor/viewport/context/dragged_object.h"

#include "model/experiment_spec.h"

namespace trundle {

DraggedObject::~DraggedObject() { removeScene(); }

void DraggedObject::setWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts) {
    m_world = std::move(experiment);
    m_ghosts = std::move(ghosts);
    if (m_object) addScene();
}

void DraggedObject::show(std::shared_ptr<const ExperimentSpec> object) {
    m_object = std::move(object);
    m_pose.reset();
    if (m_object) addScene();
    else removeScene();
    Q_EMIT moved();
}

void DraggedObject::moveTo(const std::optional<Pose>& pose) {
    m_pose = pose;
    Q_EMIT moved();
}

std::shared_ptr<const BodyPoses> DraggedObject::posesWith(const BodyPoses& world) const {
    auto all = std::make_shared<BodyPoses>(world);
    for (const Pose& body : m_bodies) all->push_back(*m_pose * body);
    return all;
}

/// Builds a scene with the dragged objects as an additional last robot, so that moving them only changes poses.
void DraggedObject::addScene() {
    removeScene();
    if (!m_render || !m_world) return;
    auto drawn = std::make_shared<ExperimentSpec>(*m_world);
    const auto materials = static_cast<std::uint32_t>(drawn->materials.size());
    drawn->materials.insert(drawn->materials.end(), m_object->materials.begin(), m_object->materials.end());
    m_bodies.clear();
    const auto body = [&](const std::vector<GeomSpec>& geoms, const Pose& pose) {
        BodySpec one;
        one.name = "body" + std::to_string(m_bodies.size());
        one.pose = pose;
        for (GeomSpec geom : geoms) {
            if (geom.shape == GeomShape::Plane) continue; // it would hide the scene
            geom.material += materials;
            one.geoms.push_back(std::move(geom));
        }
        m_bodies.push_back(pose);
        return one;
    };
    auto config = std::make_shared<RobotConfigSpec>();
    for (const RobotSpec& robot : m_object->robots)
        for (const BodySpec& each : robot.config->bodies) config->bodies.push_back(body(each.geoms, robot.pose * each.pose));
    for (const StaticSpec& fixed : m_object->statics) config->bodies.push_back(body(*fixed.geoms, fixed.pose));
    RobotSpec dragged;
    dragged.name = ".dragged"; // cannot occur in a text
    dragged.config = std::move(config);
    drawn->robots.push_back(std::move(dragged));
    m_scene = m_render->addScene(std::move(drawn), m_ghosts);
}

void DraggedObject::removeScene() {
    if (m_render && m_scene != SceneId::None) m_render->removeScene(m_scene);
    m_scene = SceneId::None;
}

} // namespace trundle
