#pragma once
// An object that is dragged over the views, drawn in addition to their scene. It cannot be picked or measured.

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "render/service.h"
#include "scene/queries/poses.h"

namespace trundle {

struct ExperimentSpec;

class DraggedObject final : public QObject {
    Q_OBJECT
public:
    explicit DraggedObject(RenderService* render) : m_render(render) {} ///< `render` may be null: then nothing is drawn
    ~DraggedObject() override;

    /// The world that it is drawn in; `ghosts` as for RenderService::addScene(). Null: nothing is shown.
    void setWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts);
    /// Draws `object` at the pose of moveTo(). Null: removes it.
    void show(std::shared_ptr<const ExperimentSpec> object);
    /// World pose of its origin; nullopt: hidden.
    void moveTo(const std::optional<Pose>& pose);
    [[nodiscard]] const std::optional<Pose>& pose() const { return m_pose; }

    [[nodiscard]] bool isDrawn() const { return m_pose && m_scene != SceneId::None; }
    /// While it is drawn: the scene with the world and the object, and its poses where the world has these.
    [[nodiscard]] SceneId scene() const { return m_scene; }
    [[nodiscard]] std::shared_ptr<const BodyPoses> posesWith(const BodyPoses& world) const;

Q_SIGNALS:
    void moved();

private:
    void addScene();
    void removeScene();

    RenderService* m_render;
    std::shared_ptr<const ExperimentSpec> m_world, m_ghosts, m_object;
    std::vector<Pose> m_bodies; // relative to its origin
    std::optional<Pose> m_pose;
    SceneId m_scene = SceneId::None;
};

} // namespace trundle
