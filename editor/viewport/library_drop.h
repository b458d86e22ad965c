#pragma once
// A drag from the Library over a view: the thing itself goes under the cursor, and the drop puts it where it was shown.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QPointF>

#include "scene/standing.h"

class QMimeData;

namespace trundle {

struct Kind;
struct StaticSpec;
class View;

/// Whether a drag brings blocks from the Library (JSON {"kind", "text", "imports"}).
[[nodiscard]] bool canDrop(const QMimeData& data);

/// Robots and arenas are placed in the world, bodies and shapes in the config of what they fall on, a material onto the shape. What
/// stands in the world stands on the floor or on top of what is there, never inside. What cannot be is said through Document::refused.
class LibraryDrop {
public:
    /// `shown`: what is dragged is drawn at its place, in all views, as long as this lives.
    LibraryDrop(View& view, const QMimeData& data, bool shown);
    ~LibraryDrop();

    void hover(const QPointF& at);
    void drop(const QPointF& at);

private:
    struct Cargo {
        std::string kind, text;
        std::vector<std::string> imports;
    };
    /// What a drop falls on, and what it goes into.
    struct Ground {
        std::vector<RayHit> hits;
        Vec3 point = Vec3::Zero();
        std::string owner;    ///< of a shape or body: the robot, body or static that it becomes part of
        Pose frame;           ///< that a Pos there is written in
        bool isRobot = false; ///< the owner is part of one
        [[nodiscard]] const RayHit* hit() const { return hits.empty() ? nullptr : &hits.front(); }
    };
    [[nodiscard]] static std::optional<Cargo> cargoOf(const QMimeData& data);
    [[nodiscard]] Ground groundAt(const QPointF& at) const;
    /// Into which body or config a shape or body would go; false: into none.
    [[nodiscard]] bool findOwner(Ground& ground) const;
    [[nodiscard]] Vec3 placeOn(const Ground& ground) const; ///< in the world
    [[nodiscard]] const Kind* kind() const;
    [[nodiscard]] bool standsInWorld() const; ///< a Robot, Static, Grid or Scatter
    void load();
    void dropController(const Ground& ground);
    bool dropMaterial(const Ground& ground);
    void refuse(const QString& why);

    View& m_view;
    std::optional<Cargo> m_cargo;
    bool m_shown = false;
    std::shared_ptr<const ExperimentSpec> m_thing; ///< alone, at the origin; null where it has no shapes
    std::vector<StandingGeom> m_geoms;             ///< of m_thing
};

} // namespace trundle
