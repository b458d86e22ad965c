// needs: the shapes of the dropped object and of everything that collides.
// assumes: the space below a plane is solid; a triangle mesh is solid only at its faces.
// method: the object is placed with its lowest point at the height of the ray hit, or of the ground at the foot of a steep face,
//   and pushed horizontally out of that face. While it penetrates something it moves the shortest way out, upwards or
//   horizontally; out of the ground it was placed on, upwards first. If that does not converge, it is raised until nothing is in
//   its way. If nothing then supports the centre of its base, it is placed on the ground below instead and moves out of obstacles
//   horizontally only.
// data: convex pieces of the object, which move with it; bounds of everything that collides.
#include "scene/queries/drop_placement.h"

#include <algorithm>
#include <cmath>

#include "model/convex_hull.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr double kTipMargin = 0.01; // m; the centre of a supported object is at least this far inside the edge
constexpr double kSteep = 0.5;      // z of a unit normal; objects do not rest on steeper faces
constexpr double kDepth = 2e-6;     // m; smaller penetration is ignored
constexpr double kBase = 0.4;       // of the size of what stands on something: as far from its middle it has support
constexpr double kGap = 2e-6;       // m, between touching objects; above the rounding of numbers in the text
constexpr double kRound = 1e-3;     // m; Pos is a multiple of it where that is possible
constexpr int kSteps = 40, kWays = 16;
constexpr double kFarthest = 100;          // m, of the search for a free place
constexpr double kDigit = 1e-6;            // m, resolution of Pos
constexpr double kSupportTolerance = 5e-3; // m; an object at most this far above a surface rests on it

/// Convex shape used for placement; a mesh is represented by its hull.
std::optional<ConvexPiece> pieceOf(const PlacementGeom& part) {
    GeomSpec geom = part.geom;
    if (geom.shape == GeomShape::Mesh && geom.mesh && !geom.collideAsHull) {
        auto hull = convexHull(geom.mesh->points);
        geom.hull = hull ? std::make_shared<const TriangleMesh>(std::move(*hull)) : geom.mesh;
        geom.collideAsHull = true;
    }
    std::vector<ConvexPiece> pieces = ConvexPiece::of(geom, part.body, Bounds{});
    return pieces.size() == 1 ? std::optional(pieces.front()) : std::nullopt;
}

double roundedUp(double z) { return kDigit * std::ceil(z / kDigit - 1e-3); }

double rounded(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }

} // namespace

struct DropPlacement::MovedPieces {
    std::vector<ConvexPiece> pieces;
    Vec3 pos = Vec3::Zero();
    Bounds bounds;

    void move(const Vec3& by) {
        for (ConvexPiece& piece : pieces) piece.move(by);
        pos += by;
        bounds.low += by;
        bounds.high += by;
    }
    [[nodiscard]] bool isInside(const ConvexPiece& fixed) const {
        return std::any_of(pieces.begin(), pieces.end(), [&](const ConvexPiece& piece) { return piece.isInside(fixed, kDepth); });
    }
    /// The longest exit distance of the pieces that are inside `fixed`.
    [[nodiscard]] double exitDistance(const ConvexPiece& fixed, const Vec3& direction) const {
        double way = 0;
        for (const ConvexPiece& piece : pieces)
            if (piece.isInside(fixed, kDepth)) way = std::max(way, piece.exitDistance(fixed, direction));
        return way;
    }
};

DropPlacement::DropPlacement(const ObjectIndex& objects, const BodyPoses& poses,
                             std::function<bool(const ObjectRef& geom)> counts)
    : m_objects(objects), m_poses(poses), m_counts(std::move(counts)) {
    const auto add = [&](ObjectRef ref, const std::vector<GeomSpec>& geoms, const Pose& owner) {
        for (std::uint32_t i = 0; i < geoms.size(); ++i) {
            ref.geom = i;
            const bool solid = geoms[i].collide && !isPlaceholder(geoms[i]) && m_counts(ref);
            const Bounds bounds = solid ? boundsOf(geoms[i], owner) : Bounds{};
            if (solid && (geoms[i].shape == GeomShape::Plane || !bounds.empty()))
                m_solids.push_back({ref, &geoms[i], owner, bounds});
        }
    };
    const ExperimentSpec& e = objects.experiment();
    for (std::uint32_t r = 0; r < e.robots.size(); ++r)
        for (std::uint32_t b = 0; e.robots[r].config && b < e.robots[r].config->bodies.size(); ++b)
            add({ObjectKind::Geom, r, b}, e.robots[r].config->bodies[b].geoms, objects.poseOf({ObjectKind::Body, r, b}, poses));
    for (std::uint32_t s = 0; s < e.statics.size(); ++s)
        if (e.statics[s].geoms) add({ObjectKind::StaticGeom, s}, *e.statics[s].geoms, e.statics[s].pose);
}

std::vector<ConvexPiece> DropPlacement::obstaclesOf(const MovedPieces& thing, const ObjectRef* only) const {
    std::vector<ConvexPiece> all;
    for (const Solid& solid : m_solids) {
        if (only && solid.object != *only) continue;
        const Bounds& b = solid.bounds;
        if (!b.empty() &&
            ((b.low.array() > thing.bounds.high.array()).any() || (b.high.array() < thing.bounds.low.array()).any()))
            continue;
        for (const ConvexPiece& piece : ConvexPiece::of(*solid.geom, solid.owner, thing.bounds))
            if (thing.isInside(piece)) all.push_back(piece);
    }
    return all;
}

std::optional<RayHit> DropPlacement::solidBelow(const Vec3& point) const {
    for (const RayHit& hit : castRay(m_objects, m_poses, {point, -Vec3::UnitZ()})) {
        const GeomSpec* geom = m_objects.geomOf(hit.geom);
        if (geom && geom->collide && m_counts(hit.geom)) return hit;
    }
    return std::nullopt;
}

double DropPlacement::groundBelow(const Vec3& point) const {
    const auto solid = solidBelow(point);
    return solid ? solid->point.z() : std::min(0.0, point.z());
}

/// True if there is a surface directly below the centre of the base and around it (above an edge it would tip), with a tolerance that
/// grows with the surface's slope.
bool DropPlacement::isSupported(const MovedPieces& thing) const {
    const Bounds& b = thing.bounds;
    const double reach = 0.5 * std::hypot(b.size().x(), b.size().y()), margin = std::min(kTipMargin, 0.1 * reach);
    const auto supportedAt = [&](double x, double y) {
        const auto solid = solidBelow({b.centre().x() + x, b.centre().y() + y, b.high.z()});
        if (!solid) return std::abs(b.low.z()) < kSupportTolerance; // without a floor, z = 0 is the ground
        const double up = std::max(solid->normal.z(), kSteep), slope = std::sqrt(1 - std::min(1.0, up * up)) / up;
        return b.low.z() - solid->point.z() < kSupportTolerance + slope * reach;
    };
    return supportedAt(margin, 0) && supportedAt(-margin, 0) && supportedAt(0, margin) && supportedAt(0, -margin);
}

/// False on the edge of a wall and on a small thing: most of the base would be in the air.
bool DropPlacement::isWideEnough(const MovedPieces& thing, const RayHit& floor) const {
    const GeomShape shape = m_objects.geomOf(floor.geom)->shape;
    if (shape == GeomShape::Plane || shape == GeomShape::Heightfield || shape == GeomShape::Mesh) return true; // may be uneven
    const Vec3 half = kBase * thing.bounds.size(), middle = thing.bounds.centre();
    for (const double x : {-half.x(), half.x()})
        for (const double y : {-half.y(), half.y()}) {
            const auto solid = solidBelow({middle.x() + x, middle.y() + y, thing.bounds.high.z()});
            if (!solid || thing.bounds.low.z() - solid->point.z() > kSupportTolerance) return false;
        }
    return true;
}

void DropPlacement::pushOut(MovedPieces& thing, const ObjectRef& from, const Vec3& direction) const {
    for (int i = 0; i < kSteps; ++i) {
        double way = 0;
        for (const ConvexPiece& piece : obstaclesOf(thing, &from)) way = std::max(way, thing.exitDistance(piece, direction));
        if (!(way > 0) || !std::isfinite(way)) return;
        thing.move((way + kGap) * direction);
    }
}

void DropPlacement::settle(MovedPieces& thing, const ObjectRef* ground, bool staysLevel) const {
    std::vector<Vec3> ways;
    if (!staysLevel) ways.push_back(Vec3::UnitZ());
    for (int i = 0; i < kWays; ++i) {
        const double angle = 2 * M_PI * i / kWays;
        ways.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    if (ground) // resting on the ground has priority
        pushOut(thing, *ground, Vec3::UnitZ());
    for (int i = 0; i < kSteps; ++i) {
        const std::vector<ConvexPiece> obstacles = obstaclesOf(thing, nullptr);
        if (obstacles.empty()) return;
        double best = std::numeric_limits<double>::infinity();
        Vec3 out = Vec3::Zero();
        for (const Vec3& way : ways) {
            double far = 0;
            for (const ConvexPiece& piece : obstacles) far = std::max(far, thing.exitDistance(piece, way));
            if (far < best) best = far, out = way;
        }
        if (!std::isfinite(best) || i > kSteps / 2) out = Vec3::UnitZ(), best = 0;
        if (best == 0)
            for (const ConvexPiece& piece : obstacles)
                if (const double up = thing.exitDistance(piece, Vec3::UnitZ()); std::isfinite(up)) best = std::max(best, up);
        thing.move((best + kGap) * out);
    }
}

/// Rounds x and y of Pos, to the nearest values at which the object is neither inside something nor loses its support.
void DropPlacement::roundOff(MovedPieces& thing, double step) const {
    const double grid = std::min(step, kRound);
    if (!(grid > 0)) return;
    std::vector<Vec3> ways;
    for (const bool upX : {false, true})
        for (const bool upY : {false, true}) {
            const auto neighbour = [&](double value, bool up) {
                const double near = rounded(value, grid);
                const double other = near + (near > value ? -grid : grid);
                return (near > value) == up ? near : other;
            };
            ways.emplace_back(neighbour(thing.pos.x(), upX) - thing.pos.x(), neighbour(thing.pos.y(), upY) - thing.pos.y(), 0);
        }
    std::ranges::sort(ways, {}, [](const Vec3& way) { return way.norm(); });
    const bool supported = isSupported(thing);
    for (const Vec3& way : ways) {
        MovedPieces moved = thing;
        moved.move(way);
        if (!obstaclesOf(moved, nullptr).empty() || (supported && !isSupported(moved))) continue;
        thing = std::move(moved);
        return;
    }
}

/// No pieces if the object is itself ground or has no usable shape. If none of its geoms collides, the visible ones are used.
DropPlacement::MovedPieces DropPlacement::movedOf(const std::vector<PlacementGeom>& thing) {
    const auto isGround = [](const PlacementGeom& part) {
        return part.geom.shape == GeomShape::Plane || part.geom.shape == GeomShape::Heightfield;
    };
    const bool collides = std::any_of(thing.begin(), thing.end(), [](const PlacementGeom& part) { return part.geom.collide; });
    MovedPieces moved;
    if (std::any_of(thing.begin(), thing.end(), isGround)) return moved;
    for (const PlacementGeom& part : thing) {
        if (collides ? !part.geom.collide : !part.geom.visible) continue;
        if (auto piece = pieceOf(part)) {
            moved.bounds.add(piece->bounds());
            moved.pieces.push_back(std::move(*piece));
        }
    }
    return moved;
}

Vec3 DropPlacement::placeAgainst(const std::vector<PlacementGeom>& thing, const RayHit& hit, double step) const {
    Vec3 at = hit.point;
    for (int k = 0; k < 3; ++k) // along the face, not away from it
        if (std::abs(hit.normal[k]) < 1e-6) at[k] = rounded(at[k], step);
    MovedPieces moved = movedOf(thing);
    if (moved.pieces.empty()) return at;
    moved.move(at);
    pushOut(moved, hit.geom, hit.normal);
    return moved.pos;
}

Vec3 DropPlacement::placeFor(const std::vector<PlacementGeom>& thing, const std::vector<RayHit>& hits, const Vec3& otherwise,
                             double step) const {
    const auto solid = std::find_if(hits.begin(), hits.end(), [&](const RayHit& hit) {
        const GeomSpec* geom = m_objects.geomOf(hit.geom);
        return m_counts(hit.geom) && geom && geom->collide;
    });
    const Vec3 point = solid != hits.end() ? solid->point : otherwise;
    const Vec3 onGrid(rounded(point.x(), step), rounded(point.y(), step), point.z());
    MovedPieces moved = movedOf(thing);
    if (moved.pieces.empty()) return onGrid;
    const double low = moved.bounds.low.z();
    const Vec3 normal = solid != hits.end() ? solid->normal : Vec3(Vec3::UnitZ());
    const Vec3 level(normal.x(), normal.y(), 0);
    if (normal.z() >= kSteep || level.norm() < 1e-6) {
        moved.move(onGrid - Vec3(0, 0, low));
        settle(moved, solid != hits.end() ? &solid->geom : nullptr);
    } else {
        const Vec3 out = level.normalized();
        moved.move({onGrid.x(), onGrid.y(), groundBelow(point + 1e-3 * out) - low});
        pushOut(moved, solid->geom, out);
        settle(moved, nullptr);
    }
    if (!isSupported(moved)) {
        MovedPieces beside = movedOf(thing);
        beside.move(onGrid - Vec3(0, 0, low));
        const Vec3 middle = beside.bounds.centre();
        beside.move(
            {0, 0, groundBelow({middle.x(), middle.y(), beside.bounds.low.z() + kSupportTolerance}) - beside.bounds.low.z()});
        settle(beside, nullptr, true);
        if (isSupported(beside)) moved = std::move(beside);
    }
    roundOff(moved, step);
    moved.pos.z() = roundedUp(moved.pos.z());
    return moved.pos;
}

bool DropPlacement::isFree(const std::vector<PlacementGeom>& thing, const Vec3& at) const {
    MovedPieces moved = movedOf(thing);
    if (moved.pieces.empty()) return true;
    moved.move(at);
    return obstaclesOf(moved, nullptr).empty();
}

/// The statics' faces that point upwards above and below a point, lowest first.
std::vector<RayHit> DropPlacement::floorsAt(const Vec3& point) const {
    std::vector<RayHit> floors;
    for (const RayHit& hit : castRay(m_objects, m_poses, {{point.x(), point.y(), kFarthest}, -Vec3::UnitZ()})) {
        const GeomSpec* geom = m_objects.geomOf(hit.geom);
        if (hit.geom.kind == ObjectKind::StaticGeom && geom && geom->collide && hit.normal.z() >= kSteep && m_counts(hit.geom))
            floors.insert(floors.begin(), hit);
    }
    return floors;
}

/// The lowest free Pos at the x and y of `at`.
std::optional<Vec3> DropPlacement::standingAt(const MovedPieces& thing, const Vec3& at) const {
    MovedPieces moved = thing;
    moved.move({at.x(), at.y(), -moved.bounds.low.z()});
    const std::vector<RayHit> floors = floorsAt(moved.bounds.centre());
    if (floors.empty()) return obstaclesOf(moved, nullptr).empty() ? std::optional(moved.pos) : std::nullopt;
    for (const RayHit& floor : floors) {
        MovedPieces raised = moved;
        raised.move({0, 0, floor.point.z()});
        pushOut(raised, floor.geom, Vec3::UnitZ());
        if (obstaclesOf(raised, nullptr).empty() && isSupported(raised) && isWideEnough(raised, floor)) return raised.pos;
    }
    return std::nullopt;
}

std::optional<Vec3> DropPlacement::placeOnFloor(const std::vector<PlacementGeom>& thing, const Vec3& from, double step) const {
    const MovedPieces moved = movedOf(thing);
    if (moved.pieces.empty()) return std::nullopt;
    for (double radius = 0; radius < kFarthest; radius += std::max(step, radius / kWays)) {
        std::optional<Vec3> lowest; // at this distance: the floor rather than the top of a wall
        for (int i = 0; i < (radius > 0 ? kWays : 1); ++i) {
            const double angle = 2 * M_PI * i / kWays;
            const Vec3 aside(rounded(radius * std::cos(angle), step), rounded(radius * std::sin(angle), step), 0);
            const auto at = standingAt(moved, from + aside);
            if (at && (!lowest || at->z() < lowest->z() - kSupportTolerance)) lowest = at;
        }
        if (!lowest) continue;
        lowest->z() = roundedUp(lowest->z());
        return lowest;
    }
    return std::nullopt;
}

} // namespace trundle
