#pragma once
// The scene shown in all views: the document's experiment at its start, or the current run. An edited model is shown alone, and a
// text without placed objects as a preview of what it defines.

#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "editor/viewport/context/dragged_object.h"
#include "editor/viewport/context/joint_positions.h"
#include "render/service.h"
#include "scene/queries/camera_model.h"
#include "scene/queries/object_index.h"
#include "scene/queries/range_model.h"
#include "scene/queries/ray_cast.h"

namespace trundle {

class Document;
class RunSession;

class ViewportScene final : public QObject {
    Q_OBJECT
public:
    /// `render` may be null: then nothing is drawn, everything else works. All arguments must outlive this object.
    ViewportScene(Document& document, RunSession& session, RenderService* render, QObject* parent = nullptr);
    ~ViewportScene() override;

    [[nodiscard]] const std::shared_ptr<const ObjectIndex>& objects() const { return m_objects; } ///< never null
    [[nodiscard]] const std::shared_ptr<const BodyPoses>& poses() const { return m_poses; }       ///< never null
    [[nodiscard]] SceneId scene() const { return m_scene; }
    [[nodiscard]] bool isRunning() const { return m_running; } ///< shows a run instead of the text

    [[nodiscard]] std::optional<ObjectRef> find(const std::string& path) const { return m_objects->find(path); }
    [[nodiscard]] Pose poseOf(const ObjectRef& object) const { return m_objects->poseOf(object, *m_poses); }
    [[nodiscard]] Bounds boundsOf(const ObjectRef& object) const { return m_objects->boundsOf(object, *m_poses); }
    /// The objects that a path of the selection refers to: the object itself, the members of a Grid or Scatter, or the matching
    /// object in each instance of a config.
    [[nodiscard]] std::vector<ObjectRef> objectsOf(const std::string& path) const;
    /// Cameras of its robots, in text order.
    [[nodiscard]] const std::vector<CameraModel>& cameras() const { return m_cameras; }
    [[nodiscard]] const CameraModel* camera(const std::string& path) const; ///< "robot0/eye"; null if there is none
    /// The cameras that a path of the selection refers to, directly or as parts of the named object.
    [[nodiscard]] std::vector<const CameraModel*> camerasOf(const std::string& path) const;
    /// Distance sensors of its robots, in text order.
    [[nodiscard]] const std::vector<RangeModel>& rangeSensors() const { return m_rangeSensors; }
    /// True if `path` refers to the component "robot0/radio" of that robot and body (index in BodyPoses), or to an object that
    /// contains it.
    [[nodiscard]] bool isPartOf(const std::string& path, const std::string& robot, std::size_t body,
                                const std::string& component) const;
    /// Bounds of the visible robots and statics, without infinite floors.
    [[nodiscard]] const Bounds& bounds() const;
    /// Visible objects along a ray, nearest first; locked ones only if `alsoLocked`.
    [[nodiscard]] std::vector<RayHit> hitsAlong(const ViewRay& ray, bool alsoLocked = false) const;

    [[nodiscard]] DraggedObject& dragged() { return m_dragged; }
    [[nodiscard]] const DraggedObject& dragged() const { return m_dragged; }

    /// Paths of hidden objects; their parts are hidden too.
    void setHidden(std::vector<std::string> paths);
    void setLocked(std::vector<std::string> paths);
    /// The same as paths of the render service.
    [[nodiscard]] const std::vector<std::string>& hiddenInScene() const { return m_hiddenInScene; }
    [[nodiscard]] bool isHidden(const ObjectRef& object) const { return holds(m_hidden, object); }
    [[nodiscard]] bool isLocked(const ObjectRef& object) const;

Q_SIGNALS:
    void replaced(); ///< another experiment, with new poses
    void posed();    ///< same experiment, new poses
    void marked();   ///< hidden or locked objects changed

private:
    friend bool showsModel(const ViewportScene& scene);
    friend JointPositions& jointPositions(ViewportScene& scene);
    friend bool isLocked(const ViewportScene& scene, const std::string& path);
    void updateScene();
    void updatePoses();
    [[nodiscard]] std::shared_ptr<const BodyPoses> posesOfText() const;
    void listHidden();
    void addInside(const std::string& instance, std::string_view part, std::vector<ObjectRef>& objects) const;
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> ghosts() const;
    [[nodiscard]] bool holds(const std::vector<std::string>& marks, const ObjectRef& object) const;

    Document& m_document;
    RunSession& m_session;
    RenderService* m_render;
    DraggedObject m_dragged;
    JointPositions m_joints;
    std::shared_ptr<const ExperimentSpec> m_experiment, m_ghosts; // shown
    std::shared_ptr<const ObjectIndex> m_objects;
    std::shared_ptr<const BodyPoses> m_poses;
    std::vector<CameraModel> m_cameras;
    std::vector<RangeModel> m_rangeSensors;
    SceneId m_scene = SceneId::None;
    mutable std::optional<Bounds> m_bounds; // computed on demand
    bool m_drawnAlike = false;              // during an edit: the images do not change
    bool m_running = false;
    std::vector<std::string> m_hidden, m_locked, m_hiddenInScene;
};

/// Those of the text's robots; a run begins without them.
[[nodiscard]] JointPositions& jointPositions(ViewportScene& scene);

/// Whether `path` is that name in a config or robot, or that of all the members it is one of: "row.eye" for "row_3.eye".
[[nodiscard]] bool isNameOf(std::string_view name, std::string_view path);

/// Whether what a path names is locked, also a Part, Repeat or Region, which is no object of the scene.
[[nodiscard]] bool isLocked(const ViewportScene& scene, const std::string& path);

/// Whether it shows the edited model alone.
[[nodiscard]] bool showsModel(const ViewportScene& scene);

} // namespace trundle
