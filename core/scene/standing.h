#pragma once
// Where a thing comes to stand that somebody puts down in the world: on the floor or on top of something, beside a wall and never in it.

#include <functional>

#include "scene/clearance.h"
#include "scene/ray_cast.h"

namespace trundle {

/// A geom of the thing, and its body's pose with the thing's own Pos at the origin and turned as it will stand.
struct StandingGeom {
    GeomSpec geom;
    Pose body;
};

class Standing {
public:
    /// `counts`: which geoms of the world are in the way; of those only what collides is. The arguments outlive this.
    Standing(const ObjectIndex& objects, const BodyPoses& poses, std::function<bool(const ObjectRef& geom)> counts);

    /// The Pos of a thing that is put where a ray falls. On a face that points up it stands there; at the foot of another face it
    /// touches it. What would hang in the air there, since nothing is below the middle of its base, goes to the ground beside. `hits` along
    /// the ray, nearest first; `otherwise`: where it falls if there are none. Its x and y are multiples of `step` unless something is in the way.
    [[nodiscard]] Vec3 placeFor(const std::vector<StandingGeom>& thing, const std::vector<RayHit>& hits, const Vec3& otherwise,
                                double step) const;
    /// The Pos of a thing that is put against the face that a ray met, whatever way that faces, and touches what has it.
    [[nodiscard]] Vec3 placeAgainst(const std::vector<StandingGeom>& thing, const RayHit& hit, double step) const;

private:
    struct Solid {
        ObjectRef object;
        const GeomSpec* geom = nullptr;
        Pose owner;
        Bounds bounds; // empty: a plane
    };
    struct Moved;
    [[nodiscard]] static Moved movedOf(const std::vector<StandingGeom>& thing);
    [[nodiscard]] std::vector<ConvexPiece> inTheWay(const Moved& thing, const ObjectRef* only) const;
    [[nodiscard]] double groundBelow(const Vec3& point) const;
    void pushOut(Moved& thing, const ObjectRef& from, const Vec3& direction) const;
    void settle(Moved& thing, const ObjectRef* ground, bool staysLevel = false) const;
    [[nodiscard]] std::optional<RayHit> solidBelow(const Vec3& point) const;
    [[nodiscard]] bool isCarried(const Moved& thing) const;

    const ObjectIndex& m_objects;
    const BodyPoses& m_poses;
    std::function<bool(const ObjectRef&)> m_counts;
    std::vector<Solid> m_solids;
};

} // namespace trundle
