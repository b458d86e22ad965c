// Ray casts against shapes. Each shape is tested in its own frame; the ray direction is a unit vector, so distances are
// preserved.

#include "scene/queries/ray_cast.h"

#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

struct LocalRay {
    Vec3 from, along;
    [[nodiscard]] Vec3 at(double t) const { return from + t * along; }
};

struct LocalHit {
    double distance = -1; ///< negative: missed
    Vec3 normal = Vec3::UnitZ();
};

constexpr double kPlaceholderHalf = 0.05; // m
constexpr int kFieldSteps = 4000;         // maximum steps along a height map

LocalHit hitBox(const LocalRay& ray, const Vec3& low, const Vec3& high) {
    double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
    int side = 0;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(ray.along[k]) < 1e-15) {
            if (ray.from[k] < low[k] || ray.from[k] > high[k]) return {};
            continue;
        }
        double a = (low[k] - ray.from[k]) / ray.along[k], b = (high[k] - ray.from[k]) / ray.along[k];
        if (a > b) std::swap(a, b);
        if (a > enter) enter = a, side = k;
        leave = std::min(leave, b);
    }
    if (enter > leave || enter < 0) return {};
    Vec3 normal = Vec3::Zero();
    normal[side] = ray.along[side] > 0 ? -1 : 1;
    return {enter, normal};
}

LocalHit hitBall(const LocalRay& ray, const Vec3& centre, double radius) {
    const Vec3 to = ray.from - centre;
    const double b = to.dot(ray.along), d = b * b - to.squaredNorm() + radius * radius;
    if (!(d >= 0)) return {};
    const double t = -b - std::sqrt(d);
    if (t < 0) return {};
    return {t, (ray.at(t) - centre) / radius};
}

/// Lateral surface of a cylinder about z, from -half to half.
LocalHit hitSide(const LocalRay& ray, double radius, double half) {
    const double a = ray.along.head<2>().squaredNorm(), b = ray.from.head<2>().dot(ray.along.head<2>());
    const double d = b * b - a * (ray.from.head<2>().squaredNorm() - radius * radius);
    if (a < 1e-15 || !(d >= 0)) return {};
    const double t = (-b - std::sqrt(d)) / a;
    const Vec3 p = ray.at(t);
    if (t < 0 || std::abs(p.z()) > half) return {};
    return {t, Vec3(p.x(), p.y(), 0) / radius};
}

LocalHit nearer(const LocalHit& a, const LocalHit& b) {
    if (a.distance < 0) return b;
    return b.distance < 0 || a.distance <= b.distance ? a : b;
}

/// The half ball at `end` of a capsule: the other half is inside the capsule.
LocalHit hitCap(const LocalRay& ray, double radius, double end) {
    const LocalHit hit = hitBall(ray, {0, 0, end}, radius);
    return hit.distance >= 0 && std::copysign(1.0, end) * (ray.at(hit.distance).z() - end) >= 0 ? hit : LocalHit{};
}

LocalHit hitCylinder(const LocalRay& ray, double radius, double length) {
    LocalHit best = hitSide(ray, radius, 0.5 * length);
    if (std::abs(ray.along.z()) < 1e-15) return best;
    const double up = ray.along.z() > 0 ? -1 : 1;
    const double t = (up * 0.5 * length - ray.from.z()) / ray.along.z();
    if (t >= 0 && ray.at(t).head<2>().norm() <= radius) best = nearer(best, {t, Vec3(0, 0, up)});
    return best;
}

LocalHit hitTriangles(const LocalRay& ray, const TriangleMesh& mesh) {
    LocalHit best;
    const auto point = [&](std::uint32_t i) { return Vec3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]); };
    for (const auto& triangle : mesh.triangles) {
        if (std::max({triangle[0], triangle[1], triangle[2]}) >= mesh.points.size()) continue;
        const Vec3 a = point(triangle[0]), u = point(triangle[1]) - a, v = point(triangle[2]) - a;
        const Vec3 cross = ray.along.cross(v);
        const double determinant = u.dot(cross);
        if (std::abs(determinant) < 1e-18) continue;
        const Vec3 to = ray.from - a;
        const double s = to.dot(cross) / determinant;
        if (s < 0 || s > 1) continue;
        const Vec3 turned = to.cross(u);
        const double r = ray.along.dot(turned) / determinant, t = v.dot(turned) / determinant;
        if (r < 0 || s + r > 1 || t < 0) continue;
        Vec3 normal = u.cross(v).normalized();
        if (normal.dot(ray.along) > 0) normal = -normal;
        best = nearer(best, {t, normal});
    }
    return best;
}

/// Height of the map at (x, y), in metres above its lowest point.
double heightAt(const HeightMap& map, const Vec3& size, double x, double y) {
    const double u = std::clamp(x / size.x() + 0.5, 0.0, 1.0) * (map.columns - 1);
    const double v = std::clamp(0.5 - y / size.y(), 0.0, 1.0) * (map.rows - 1);
    const auto i = std::min(static_cast<std::uint32_t>(u), map.columns - 2),
               j = std::min(static_cast<std::uint32_t>(v), map.rows - 2);
    const double a = u - i, b = v - j;
    const auto sample = [&](std::uint32_t column, std::uint32_t row) {
        return static_cast<double>(map.heights[std::size_t(row) * map.columns + column]);
    };
    const double top = (1 - a) * sample(i, j) + a * sample(i + 1, j), low = (1 - a) * sample(i, j + 1) + a * sample(i + 1, j + 1);
    return size.z() * ((1 - b) * top + b * low);
}

LocalHit hitField(const LocalRay& ray, const HeightMap& map, const Vec3& size) {
    if (map.heights.size() < std::size_t(map.columns) * map.rows) return {};
    const Vec3 half(0.5 * size.x(), 0.5 * size.y(), 0);
    Bounds box;
    box.add(-half);
    box.add(half + Vec3(0, 0, size.z()));
    box.grow(1e-9);
    const bool inside = box.distanceTo(ray.from) == 0;
    const LocalHit door = hitBox(ray, box.low, box.high);
    if (!inside && door.distance < 0) return {};
    const double begin = inside ? 0 : door.distance, length = 2 * box.radius();
    const double cell = std::min(size.x() / map.columns, size.y() / map.rows);
    const int steps = std::clamp(static_cast<int>(2 * length / std::max(cell, 1e-9)), 16, kFieldSteps);
    const auto above = [&](double t) {
        const Vec3 p = ray.at(t);
        return p.z() - heightAt(map, size, p.x(), p.y());
    };
    double before = begin;
    for (int i = 1; i <= steps; ++i) {
        const double t = begin + length * i / steps;
        const Vec3 p = ray.at(t);
        if (std::abs(p.x()) > half.x() || std::abs(p.y()) > half.y()) return {};
        if (above(t) <= 0 && above(before) >= 0) {
            double low = before, high = t;
            for (int k = 0; k < 30; ++k) (above(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
            const Vec3 at = ray.at(high);
            const double e = 0.5 * cell;
            const Vec3 slope(heightAt(map, size, at.x() - e, at.y()) - heightAt(map, size, at.x() + e, at.y()),
                             heightAt(map, size, at.x(), at.y() - e) - heightAt(map, size, at.x(), at.y() + e), 2 * e);
            return {high, slope.normalized()};
        }
        before = t;
    }
    return {};
}

LocalHit hitShape(const LocalRay& ray, const GeomSpec& g) {
    if (isPlaceholder(g)) return hitBox(ray, Vec3::Constant(-kPlaceholderHalf), Vec3::Constant(kPlaceholderHalf));
    switch (g.shape) {
    case GeomShape::Box: return hitBox(ray, -0.5 * g.size, 0.5 * g.size);
    case GeomShape::Sphere: return hitBall(ray, Vec3::Zero(), g.radius);
    case GeomShape::Cylinder: return hitCylinder(ray, g.radius, g.length);
    case GeomShape::Capsule:
        return nearer(hitSide(ray, g.radius, 0.5 * g.length),
                      nearer(hitCap(ray, g.radius, 0.5 * g.length), hitCap(ray, g.radius, -0.5 * g.length)));
    case GeomShape::Plane: {
        if (std::abs(ray.along.z()) < 1e-12) return {};
        const double t = -ray.from.z() / ray.along.z();
        return {t, Vec3(0, 0, ray.along.z() > 0 ? -1 : 1)};
    }
    case GeomShape::Heightfield: return hitField(ray, *g.heightMap, g.size);
    case GeomShape::Mesh:
    case GeomShape::Convex: return hitTriangles(ray, *g.mesh);
    }
    return {};
}

/// Calls `take` for each accepted geom that the ray enters, in the order of the experiment.
template <class Wanted, class Take>
void meetAll(const ObjectIndex& objects, const BodyPoses& poses, const ViewRay& ray, const Wanted& wanted, const Take& take) {
    const auto meet = [&](ObjectRef ref, const std::vector<GeomSpec>& geoms, const Pose& owner) {
        const Pose inverse = owner.inverse();
        const Vec3 from = inverse * ray.origin, along = inverse.rotation * ray.direction;
        const std::vector<Ball>& balls = objects.ballsOf(geoms);
        for (std::uint32_t i = 0; i < geoms.size() && i < balls.size(); ++i) {
            if (!wanted(geoms[i]) || !(balls[i].radius >= 0)) continue;
            const Vec3 to = balls[i].centre - from;
            const double reach = balls[i].radius * (1 + 1e-9) + 1e-9, ahead = to.dot(along);
            if (to.squaredNorm() - ahead * ahead > reach * reach || ahead < -reach) continue;
            const Pose local = geoms[i].pose.inverse();
            const LocalHit hit = hitShape({local * from, local.rotation * along}, geoms[i]);
            if (!(hit.distance >= 0) || !std::isfinite(hit.distance)) continue;
            ref.geom = i;
            take(ref, hit.distance, owner.rotation * (geoms[i].pose.rotation * hit.normal));
        }
    };
    const ExperimentSpec& e = objects.experiment();
    for (std::uint32_t r = 0; r < e.robots.size(); ++r) {
        if (!e.robots[r].config || !wanted(r)) continue;
        for (std::uint32_t b = 0; b < e.robots[r].config->bodies.size(); ++b)
            meet({ObjectKind::Geom, r, b}, e.robots[r].config->bodies[b].geoms, objects.poseOf({ObjectKind::Body, r, b}, poses));
    }
    for (std::uint32_t s = 0; s < e.statics.size(); ++s)
        if (e.statics[s].geoms) meet({ObjectKind::StaticGeom, s}, *e.statics[s].geoms, e.statics[s].pose);
}

/// Accepts visible geoms.
struct Visible {
    bool operator()(const GeomSpec& geom) const { return geom.visible; }
    bool operator()(std::uint32_t) const { return true; }
};

/// Accepts colliding geoms, except those of two robots.
struct Solid {
    std::size_t robot, otherRobot;
    bool operator()(const GeomSpec& geom) const { return geom.collide; }
    bool operator()(std::uint32_t which) const { return which != robot && which != otherRobot; }
};

} // namespace

std::vector<RayHit> castRay(const ObjectIndex& objects, const BodyPoses& poses, const ViewRay& ray) {
    std::vector<RayHit> hits;
    meetAll(objects, poses, ray, Visible{}, [&](const ObjectRef& geom, double distance, const Vec3& normal) {
        hits.push_back({geom, ray.origin + distance * ray.direction, normal, distance});
    });
    std::stable_sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
    return hits;
}

int solidsBetween(const ObjectIndex& objects, const BodyPoses& poses, const Vec3& from, const Vec3& to, std::size_t robot,
                  std::size_t otherRobot) {
    const double length = (to - from).norm();
    if (!(length > 0)) return 0;
    int solids = 0;
    meetAll(objects, poses, {from, (to - from) / length}, Solid{robot, otherRobot},
            [&](const ObjectRef&, double distance, const Vec3&) { solids += distance < length ? 1 : 0; });
    return solids;
}

} // namespace trundle
