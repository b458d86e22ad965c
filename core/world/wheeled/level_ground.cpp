#include "world/wheeled/level_ground.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace trundle {

namespace {

constexpr double kSlope = 2e-3; // sine of the angle by which a side that counts as upright or level may be neither

bool isSloping(double rise) { return std::abs(rise) > kSlope && rise * rise < 1 - kSlope * kSlope; }

/// Whether a side of it that is not above `top` is neither upright nor level. Not for a sphere.
bool hasSlope(const GeomSpec& geom, const Pose& pose, double top) {
    const Mat3 axes = pose.rotation.toRotationMatrix();
    if (geom.shape == GeomShape::Box) return isSloping(axes(2, 0)) || isSloping(axes(2, 1)) || isSloping(axes(2, 2));
    if (!geom.hull) return !isUpright(axes);
    for (const auto& corners : geom.hull->triangles) {
        Vec3 at[3];
        for (std::size_t k = 0; k < 3; ++k) at[k] = pose * Vec3(geom.hull->points[corners[k]].data());
        if (std::min({at[0].z(), at[1].z(), at[2].z()}) >= top) continue;
        const Vec3 a = at[1] - at[0], b = at[2] - at[0], across = a.cross(b);
        const double area = across.norm(), longest = std::max({a.norm(), b.norm(), (b - a).norm()});
        if (area > kTouching * longest && isSloping(across.z() / area)) return true; // what is narrower has no direction
    }
    return false;
}

} // namespace

std::string named(const char* kind, const std::string& name, const char* reason) {
    return std::string(kind) + " " + name + " " + reason;
}

bool isUpright(const Mat3& axes) { return std::abs(axes(2, 2)) > 1 - kLevelAxis; }

bool LevelGround::isEndless() const {
    return std::ranges::any_of(slabs, [](const Slab& slab) { return slab.half.isZero(0); });
}

bool LevelGround::isBelow(const Vec2& point, double inside) const {
    return std::ranges::any_of(slabs, [&](const Slab& slab) {
        const Vec2 at = slab.pose.turnBack(point - slab.pose.at);
        return slab.half.isZero(0) || (std::abs(at.x()) <= slab.half.x() - inside && std::abs(at.y()) <= slab.half.y() - inside);
    });
}

void GroundSearch::add(std::uint32_t geom, const GeomSpec& spec, const Pose& pose) {
    const Mat3 axes = pose.rotation.toRotationMatrix();
    const bool plane = spec.shape == GeomShape::Plane;
    if (!isUpright(axes) || (!plane && spec.shape != GeomShape::Box) || (plane && axes(2, 2) < 0)) return;
    const double height = pose.position.z() + (plane ? 0 : spec.size.z() / 2);
    const PlanarPose at{pose.position.head<2>(), axes(0, 0), axes(1, 0)};
    const LevelGround::Slab slab{geom, spec.surface, at, plane ? Vec2(0, 0) : Vec2(spec.size.head<2>() / 2)};
    for (LevelGround& level : m_levels)
        if (std::abs(level.height - height) < kTouching) return level.slabs.push_back(slab);
    m_levels.push_back({height, {slab}});
    std::ranges::sort(m_levels, std::greater{}, &LevelGround::height);
}

std::optional<LevelGround> GroundSearch::under(double bottom, const Vec2& place) const {
    const auto level =
        std::ranges::find_if(m_levels, [&](const LevelGround& l) { return l.height < bottom + kOnGround && l.isBelow(place); });
    return level == m_levels.end() ? std::nullopt : std::optional(*level);
}

std::optional<LevelGround> GroundSearch::at(double height) const {
    const auto level = std::ranges::min_element(m_levels, {}, [&](const LevelGround& l) { return std::abs(l.height - height); });
    return level == m_levels.end() || std::abs(level->height - height) > kTouching ? std::nullopt : std::optional(*level);
}

std::optional<NotWheeled> whyNotScenery(const GeomSpec& geom, const Pose& pose, const LevelGround& ground, const Movers& movers) {
    const auto no = [&](const char* reason) { return NotWheeled{named("geom", geom.name, reason), geom.nameRange}; };
    switch (geom.shape) {
    case GeomShape::Plane:
        if (!isUpright(pose.rotation.toRotationMatrix())) return no("is a plane that slopes");
        if (pose.rotation.toRotationMatrix()(2, 2) < 0) return no("is a plane that points down");
        return {};
    case GeomShape::Heightfield: return no("is a height map");
    case GeomShape::Mesh:
        if (!geom.collideAsHull) return no("is a mesh that collides as such");
        break;
    case GeomShape::Capsule: return no("is a capsule");
    default: break;
    }
    const auto footprint = planarShapeOf(geom, pose);
    if (!footprint) return no("has no footprint");
    const bool ball = geom.shape == GeomShape::Sphere;
    const double middle = pose.position.z(), high = footprint.value().high;
    if (high <= ground.height + kTouching || footprint.value().low >= movers.top) return {};
    if (ball && middle < ground.height) return no("has its middle below the ground: a robot could drive up on it");
    if (!ball && hasSlope(geom, pose, movers.top)) return no("slopes or overhangs: a robot could drive up on it or under it");
    if ((ball ? middle : high) < ground.height + movers.wheel - kTouching)
        return no("is so low that wheels climb it: its sides end below the axle of the largest one");
    return {};
}

} // namespace trundle
