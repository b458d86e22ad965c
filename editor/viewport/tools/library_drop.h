#pragma once
// Drag and drop from the Library into a view: a preview follows the cursor, and the drop inserts the block at the preview's pose.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QPointF>

#include "editor/viewport/tools/robot_part.h"
#include "scene/queries/drop_placement.h"
#include "scene/queries/face_snap.h"

class QMimeData;
class QPainter;

namespace trundle {

struct Kind;
struct StaticSpec;
class ToolView;

/// True if the drag contains blocks from the Library (JSON {"kind", "text", "imports"}; {"title", "isTemplate"} of the Library itself).
[[nodiscard]] bool canDrop(const QMimeData& data);

/// Robots and arenas are inserted into the world, bodies and shapes into the config of the object under the cursor; a material is
/// assigned to the shape. A robot part and a sensor are put on the face under the cursor, turned to it and joined to its body; parts
/// that reach the floor keep their height above it, and near the mirror image of another part they are put exactly opposite. On a flat
/// face of a robot all of these snap, see snapOnFace(). Objects in the world rest on the floor or on other objects, never inside them.
/// Failures are reported through Document::refused.
class LibraryDrop {
public:
    /// `shown`: the dragged object is drawn at its target pose, in all views, during the lifetime of this object.
    LibraryDrop(ToolView& view, const QMimeData& data, bool shown);
    ~LibraryDrop();

    void hover(const QPointF& at);
    void drop(const QPointF& at);
    /// Where a drop would put a sensor, in world coordinates; nothing for what is shown itself.
    [[nodiscard]] const std::optional<Vec3>& spot() const { return m_spot; }
    /// The lines of the face under the cursor that it snaps to.
    void paintGuides(QPainter& painter) const;

private:
    struct DraggedContent {
        std::string kind, text;
        std::vector<std::string> imports;
        QString title;           ///< what the history names
        bool isTemplate = false; ///< the text is one for the selection, not for what it is dropped on
    };
    /// What is under the cursor, and the object that a drop inserts into.
    struct Ground {
        std::vector<RayHit> hits;
        Vec3 point = Vec3::Zero();
        std::string owner;            ///< for a shape or body: the robot, body or static that it is inserted into
        Pose frame;                   ///< the frame of a Pos there, in world coordinates
        bool isRobot = false;         ///< the owner belongs to a robot
        Quat turn = Quat::Identity(); ///< of a robot part, from the frame
        std::optional<FaceSnap> snap; ///< of the first hit, whose point is that of the snap
        [[nodiscard]] const RayHit* hit() const { return hits.empty() ? nullptr : &hits.front(); }
    };
    [[nodiscard]] static std::optional<DraggedContent> draggedContentOf(const QMimeData& data);
    [[nodiscard]] Ground groundAt(const QPointF& at) const;
    /// Sets the owner and frame for a dragged shape or body; false if there is none.
    [[nodiscard]] bool findOwner(Ground& ground) const;
    void snap(Ground& ground) const; ///< to what the face of a robot has to snap to
    [[nodiscard]] std::vector<PlacementGeom> turnedGeoms(const Ground& ground) const;
    [[nodiscard]] bool isDevice() const;                    ///< with a place on a body
    [[nodiscard]] Vec3 placeOn(const Ground& ground) const; ///< in world coordinates
    [[nodiscard]] Vec3 placePart(const Ground& ground, const std::vector<PlacementGeom>& turned, double step) const;
    [[nodiscard]] std::optional<Vec3> oppositeOf(const Ground& ground, const Vec3& p_R) const;
    [[nodiscard]] bool isUpright() const;
    [[nodiscard]] std::string partText(const Ground& ground) const;
    [[nodiscard]] std::string deviceText(const Ground& ground) const;
    [[nodiscard]] const Kind* kind() const;
    [[nodiscard]] bool isWorldObject() const; ///< a Robot, Static, Grid or Scatter
    void load();
    void dropController(const Ground& ground);
    bool dropMaterial(const Ground& ground);
    void refuse(const QString& why);

    ToolView& m_view;
    std::optional<DraggedContent> m_content;
    bool m_shown = false;
    std::optional<RobotPart> m_part;               ///< for a body that comes with a joint
    std::shared_ptr<const ExperimentSpec> m_thing; ///< the dragged object alone, at the origin; null if it has no shapes
    std::vector<PlacementGeom> m_geoms;            ///< of m_thing
    std::optional<Vec3> m_spot;
    std::vector<std::array<Vec3, 2>> m_guides;
};

} // namespace trundle
