#include "world/rays/ray_scene.h"

#include <algorithm>

#include "world/rays/surface_normal.h"

namespace trundle {

namespace {

constexpr double kLarge = 1;      // m: radius from which a geom is in a list instead of the grid
constexpr double kInflate = 1e-9; // of balls, so that rounding loses no hit

} // namespace

RayScene::RayScene(const RayKernel& kernel, double cell) : m_kernel(kernel), m_still(cell), m_moving(cell) {}

void RayScene::add(RayGeom geom) {
    if (geom.tree) {
        geom.shape.nodes = geom.tree->nodes().data();
        geom.shape.triangles = geom.tree->triangles().data();
    }
    if (geom.heights) geom.shape.heights = &geom.heights->cells();
    m_geoms.push_back(std::move(geom));
}

void RayScene::update() {
    if (m_filed != m_geoms.size()) {
        m_filed = m_geoms.size();
        for (auto* list : {&m_planes, &m_meshes, &m_movingSmall}) list->clear();
        m_large.clear();
        std::vector<GeomBall> still;
        for (std::uint32_t i = 0; i < m_geoms.size(); ++i) {
            const RayGeom& g = m_geoms[i];
            if (g.shape.kind == RayShape::Plane) m_planes.push_back(i);
            else if (g.tree || g.heights) m_meshes.push_back(i);
            else if (g.bound >= kLarge) m_large.push_back(ballOf(i));
            else if (g.actor == kNoGeom) still.push_back(ballOf(i));
            else m_movingSmall.push_back(i);
        }
        m_still.build(still);
    }
    for (GeomBall& large : m_large) large = ballOf(large.geom);
    m_balls.clear();
    for (const std::uint32_t i : m_movingSmall) m_balls.push_back(ballOf(i));
    m_moving.build(m_balls);
}

GeomBall RayScene::ballOf(std::uint32_t geom) const {
    const RayGeom& g = m_geoms[geom];
    return {g.centre.x(), g.centre.y(), g.centre.z(), g.bound * (1 + kInflate) + kInflate, geom, g.actor};
}

LocalBeams RayScene::local(const RayGeom& geom, const Vec3& origin, const Vec3& a, const Vec3& b, const Vec3& c) const {
    LocalBeams beams;
    const Vec3 from = origin - geom.centre;
    for (int k = 0; k < 3; ++k) {
        beams.origin[k] = geom.axes.col(k).dot(from);
        beams.a[k] = geom.axes.col(k).dot(a);
        beams.b[k] = geom.axes.col(k).dot(b);
        beams.c[k] = geom.axes.col(k).dot(c);
    }
    return beams;
}

void RayScene::castRay(const SingleRay& ray, std::uint32_t without, const RayHits& hits) const {
    const double one[1 + kBeamPadding] = {1}, none[1 + kBeamPadding] = {};
    double distance[1 + kBeamPadding], nearest[1 + kBeamPadding], part[1 + kBeamPadding] = {};
    std::fill(std::begin(distance), std::end(distance), ray.range);
    std::fill(std::begin(nearest), std::end(nearest), double{kNoGeom});
    const BeamRow row{one, none, distance, nearest, part, 0, 0};
    LocalBeams beams{}; // a beam at bearing 0
    RayRoots roots;
    roots.count = 1;
    const auto test = [&](std::uint32_t geom) {
        const RayGeom& g = m_geoms[geom];
        if (g.actor == without && without != kNoGeom) return;
        if (g.heights) roots.blocks[0] = {g.shape.heights->levels - 1, 0, 0};
        for (int k = 0; k < 3; ++k) {
            beams.origin[k] = g.axes.col(k).dot(ray.origin - g.centre);
            beams.a[k] = g.axes.col(k).dot(ray.direction);
        }
        cast(geom, row, beams, roots);
    };
    const auto visit = [&](const GeomBall& ball) {
        const Vec3 p = Vec3(ball.x, ball.y, ball.z) - ray.origin;
        const double along = std::clamp(p.dot(ray.direction), 0., distance[0]);
        if ((p - along * ray.direction).squaredNorm() <= ball.r * ball.r) test(ball.geom);
    };
    for (const std::uint32_t plane : m_planes) test(plane);
    for (const GeomBall& large : m_large) visit(large);
    const Vec3 way = ray.range * ray.direction;
    m_still.along(ray.origin, way, visit);
    m_moving.along(ray.origin, way, visit);
    for (const std::uint32_t mesh : m_meshes) visit(ballOf(mesh));
    hits.distances[0] = distance[0];
    if (hits.geoms) hits.geoms[0] = static_cast<std::uint32_t>(nearest[0]);
    if (hits.normals) writeNormal(nearest[0], part[0], ray.origin, distance[0] * ray.direction, hits.normals);
}

void RayScene::writeNormal(double geom, double part, const Vec3& origin, const Vec3& way, double* out) const {
    Eigen::Map<Vec3> normal(out);
    const auto index = static_cast<std::uint32_t>(geom);
    if (index == kNoGeom) {
        normal.setZero();
        return;
    }
    const RayGeom& g = m_geoms[index];
    const auto number = static_cast<std::size_t>(part);
    const Vec3 inside = g.tree      ? g.tree->normal(number)
                        : g.heights ? g.heights->normal(number)
                                    : normalOf(g.shape, g.axes.transpose() * (origin - g.centre + way));
    normal = g.axes * inside;
    if (normal.dot(way) > 0) normal = -normal;
}

} // namespace trundle
