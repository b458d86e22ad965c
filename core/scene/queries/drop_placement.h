#pragma once
// Where an object dropped into the world is placed: on the floor, on another object or beside a wall, never inside anything.

#include <functional>
#include <optional>
#include <vector>

#include "scene/queries/clearance.h"
#include "scene/queries/ray_cast.h"

namespace trundle {

/// A geom of the dropped object, and its body's pose with the object's Pos at the origin and its final rotation.
struct PlacementGeom {
    GeomSpec geom;
    Pose body;
};

class DropPlacement {
public:
    /// `counts` selects the geoms of the world that may obstruct; of those only colliding ones do. The arguments must outlive
    /// this object.
    DropPlacement(const ObjectIndex& objects, const BodyPoses& poses, std::function<bool(const ObjectRef& geom)> counts);

    /// The Pos of an object dropped along a ray. On a face that points upwards it is at the hit point; at a steeper face it
    /// stands on the ground and touches the face. If nothing below the centre of its base would support it, it is placed on the
    /// ground beside. `hits`: along the ray, nearest first; `otherwise`: the position if there are none. x and y are multiples of
    /// `step` (m); beside an obstacle, which prevents that, they are whole millimetres.
    [[nodiscard]] Vec3 placeFor(const std::vector<PlacementGeom>& thing, const std::vector<RayHit>& hits, const Vec3& otherwise,
                                double step) const;
    /// The Pos of an object placed against the face that the ray hit, in whatever direction that faces, touching the geom of that
    /// face.
    [[nodiscard]] Vec3 placeAgainst(const std::vector<PlacementGeom>& thing, const RayHit& hit, double step) const;
    /// True if the object with its Pos at `at` penetrates nothing.
    [[nodiscard]] bool isFree(const std::vector<PlacementGeom>& thing, const Vec3& at) const;
    /// The free Pos nearest to `from` where the object stands on a static or, without one, on z = 0. x and y differ from those of
    /// `from` by multiples of `step` (m). Nothing if the object has no usable shape or nothing is free within 100 m.
    [[nodiscard]] std::optional<Vec3> placeOnFloor(const std::vector<PlacementGeom>& thing, const Vec3& from, double step) const;

private:
    struct Solid {
        ObjectRef object;
        const GeomSpec* geom = nullptr;
        Pose owner;
        Bounds bounds; // empty: a plane
    };
    struct MovedPieces;
    [[nodiscard]] static MovedPieces movedOf(const std::vector<PlacementGeom>& thing);
    [[nodiscard]] std::vector<ConvexPiece> obstaclesOf(const MovedPieces& thing, const ObjectRef* only) const;
    [[nodiscard]] double groundBelow(const Vec3& point) const;
    [[nodiscard]] std::vector<RayHit> floorsAt(const Vec3& point) const;
    [[nodiscard]] std::optional<Vec3> standingAt(const MovedPieces& thing, const Vec3& at) const;
    void pushOut(MovedPieces& thing, const ObjectRef& from, const Vec3& direction) const;
    void roundOff(MovedPieces& thing, double step) const;
    void settle(MovedPieces& thing, const ObjectRef* ground, bool staysLevel = false) const;
    [[nodiscard]] std::optional<RayHit> solidBelow(const Vec3& point) const;
    [[nodiscard]] bool isSupported(const MovedPieces& thing) const;
    [[nodiscard]] bool isWideEnough(const MovedPieces& thing, const RayHit& floor) const;

    const ObjectIndex& m_objects;
    const BodyPoses& m_poses;
    std::function<bool(const ObjectRef&)> m_counts;
    std::vector<Solid> m_solids;
};

} // namespace trundle
