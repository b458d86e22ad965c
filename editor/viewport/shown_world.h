#pragma once
// What all views show: the document's experiment at its start, or the one that runs, where it stands now. Of a text that places
// nothing, what it describes.

#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "render/service.h"
#include "scene/camera_model.h"
#include "scene/object_index.h"
#include "scene/ray_cast.h"

namespace trundle {

class Document;
class RunSession;

class ShownWorld final : public QObject {
    Q_OBJECT
public:
    /// `render` may be null: nothing is drawn then, all else works. All outlive this.
    ShownWorld(Document& document, RunSession& session, RenderService* render, QObject* parent = nullptr);
    ~ShownWorld() override;

    [[nodiscard]] const std::shared_ptr<const ObjectIndex>& objects() const { return m_objects; } ///< never null
    [[nodiscard]] const std::shared_ptr<const BodyPoses>& poses() const { return m_poses; }       ///< never null
    [[nodiscard]] SceneId scene() const { return m_scene; }
    [[nodiscard]] bool isRunning() const { return m_running; } ///< from a run, not from the text

    [[nodiscard]] std::optional<ObjectRef> find(const std::string& path) const { return m_objects->find(path); }
    [[nodiscard]] Pose poseOf(const ObjectRef& object) const { return m_objects->poseOf(object, *m_poses); }
    [[nodiscard]] Bounds boundsOf(const ObjectRef& object) const { return m_objects->boundsOf(object, *m_poses); }
    /// The objects that a path of the selection means: itself, the members of a Grid or Scatter, or one in each instance of a
    /// config.
    [[nodiscard]] std::vector<ObjectRef> objectsOf(const std::string& path) const;
    /// Of its robots, in text order.
    [[nodiscard]] const std::vector<CameraModel>& cameras() const { return m_cameras; }
    [[nodiscard]] const CameraModel* camera(const std::string& path) const; ///< "robot0/eye"; null where there is none
    /// The cameras that a path of the selection means, by themselves or as parts of what it names.
    [[nodiscard]] std::vector<const CameraModel*> camerasOf(const std::string& path) const;
    /// Whether such a path means a component of a robot ("robot0/radio") that sits on a body (as BodyPoses count), or what it is part of.
    [[nodiscard]] bool isPartOf(const std::string& path, const std::string& robot, std::size_t body,
                                const std::string& component) const;
    /// Robots and statics without those hidden, and without endless floors.
    [[nodiscard]] const Bounds& bounds() const;
    /// What is seen along a ray, nearest first; what is locked only where asked for.
    [[nodiscard]] std::vector<RayHit> hitsAlong(const ViewRay& ray, bool alsoLocked = false) const;

    /// Draws what is dragged into the views beside all else: its robots and statics as they stand there, at moveDragged(). Nothing picks
    /// or measures it. Null: no longer.
    void showDragged(std::shared_ptr<const ExperimentSpec> thing);
    /// Where its origin is now; nothing: it is not seen.
    void moveDragged(const std::optional<Pose>& pose);
    [[nodiscard]] const std::optional<Pose>& dragged() const { return m_draggedPose; }
    /// What pictures are drawn of: scene() and poses(), and what is dragged.
    [[nodiscard]] SceneId drawnScene() const { return m_draggedPose && isDragging() ? m_draggedScene : m_scene; }
    [[nodiscard]] std::shared_ptr<const BodyPoses> drawnPoses() const;

    /// Paths of objects; what is in them is meant too.
    void setHidden(std::vector<std::string> paths);
    void setLocked(std::vector<std::string> paths);
    /// As the render service names them.
    [[nodiscard]] const std::vector<std::string>& hiddenInScene() const { return m_hiddenInScene; }
    [[nodiscard]] bool isHidden(const ObjectRef& object) const { return holds(m_hidden, object); }
    [[nodiscard]] bool isLocked(const ObjectRef& object) const;

Q_SIGNALS:
    void replaced(); ///< another experiment: poses too
    void posed();    ///< the same, elsewhere
    void marked();   ///< hidden or locked
    void draggedMoved();

private:
    void look();
    void lookAtPoses();
    void listHidden();
    [[nodiscard]] bool isDragging() const { return m_draggedScene != SceneId::None; }
    void addDraggedScene();
    void removeDraggedScene();
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> ghosts() const;
    [[nodiscard]] bool holds(const std::vector<std::string>& marks, const ObjectRef& object) const;

    Document& m_document;
    RunSession& m_session;
    RenderService* m_render;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<const ObjectIndex> m_objects;
    std::shared_ptr<const BodyPoses> m_poses;
    std::vector<CameraModel> m_cameras;
    SceneId m_scene = SceneId::None, m_draggedScene = SceneId::None;
    std::shared_ptr<const ExperimentSpec> m_dragged;
    std::vector<Pose> m_draggedBodies; // from its origin
    std::optional<Pose> m_draggedPose;
    mutable std::optional<Bounds> m_bounds; // made when somebody asks
    bool m_running = false;
    std::vector<std::string> m_hidden, m_locked, m_hiddenInScene;
};

} // namespace trundle
