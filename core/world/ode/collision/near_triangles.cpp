#include "world/ode/collision/near_triangles.h"

#include <algorithm>
#include <cmath>

#include "base/triangle_mesh.h"
#include "world/ode/objects/ode_shapes.h"

namespace trundle {

namespace {

/// The cells of a row of `count` samples over an extent about 0 that a range meets: first and last, empty if first > last.
std::pair<std::size_t, std::size_t> cellsIn(double lo, double hi, double extent, std::uint32_t count) {
    const double step = extent / (count - 1), last = count - 2.0;
    const double from = std::floor((lo + extent / 2) / step), to = std::floor((hi + extent / 2) / step);
    if (to < 0 || from > last) return {1, 0};
    return {static_cast<std::size_t>(std::max(from, 0.0)), static_cast<std::size_t>(std::min(to, last))};
}

} // namespace

NearTriangles::~NearTriangles() {
    if (m_mesh) dGeomDestroy(m_mesh);
    if (m_data) dGeomTriMeshDataDestroy(m_data);
}

dGeomID NearTriangles::findAsMesh(std::uint32_t surface, std::uint32_t geom) {
    if (find(surface, geom).empty()) return nullptr;
    const Vec3& middle = m_objects.centres[geom]; // ODE's trees are of single precision
    m_points.clear();
    m_corners.clear();
    for (const Triangle& t : m_triangles)
        for (const Vec3& corner : t) {
            m_corners.push_back(static_cast<dTriIndex>(m_corners.size()));
            for (int k = 0; k < 3; ++k) m_points.push_back(corner[k] - middle[k]);
        }
    if (!m_data) m_data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(m_data, m_points.data(), 3 * sizeof(double), static_cast<int>(m_corners.size()), m_corners.data(),
                                static_cast<int>(m_corners.size()), 3 * sizeof(dTriIndex));
    if (m_mesh) dGeomTriMeshSetData(m_mesh, m_data);
    else m_mesh = dCreateTriMesh(nullptr, m_data, nullptr, nullptr, nullptr);
    dGeomSetPosition(m_mesh, middle.x(), middle.y(), middle.z());
    return m_mesh;
}

std::span<const Triangle> NearTriangles::find(std::uint32_t surface, std::uint32_t geom) {
    const OdeGeom& s = m_objects.geoms[surface];
    const Mat3 axes = m_objects.axesOf(s), across = axes.transpose() * m_objects.axesOf(m_objects.geoms[geom]);
    const Vec3 centre = axes.transpose() * (m_objects.centres[geom] - m_objects.centres[surface]),
               reach = across.cwiseAbs() * m_objects.geoms[geom].half;
    const Vec3 lo = centre - reach, hi = centre + reach;
    const Box3 box{{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}};
    m_triangles.clear();
    if (s.shape == GeomShape::Mesh) addOfMesh(*s.data, box);
    else if (s.shape == GeomShape::Convex) addOfHull(*s.data);
    else addOfHeights(s, box);
    for (Triangle& t : m_triangles)
        for (Vec3& corner : t) corner = m_objects.centres[surface] + axes * corner;
    return m_triangles;
}

void NearTriangles::addOfMesh(const ShapeData& data, const Box3& box) {
    data.triangleGrid.query(box, m_numbers);
    for (const std::uint32_t t : m_numbers) {
        const auto corner = [&](std::size_t k) { return Vec3(&data.points[3 * data.triangles[3 * t + k]]); };
        m_triangles.push_back({corner(0), corner(1), corner(2)});
    }
}

void NearTriangles::addOfHull(const ShapeData& data) {
    const auto corner = [&](std::size_t i) { return Vec3(&data.points[std::size_t{3} * data.polygons[i]]); };
    for (std::size_t p = 0; p + 3 < data.polygons.size(); p += 4)
        m_triangles.push_back({corner(p + 1), corner(p + 2), corner(p + 3)});
}

/// A height map rises along y; each cell has two triangles, as for rays.
void NearTriangles::addOfHeights(const OdeGeom& geom, const Box3& box) {
    const HeightMap& map = *geom.data->heightMap;
    const double width = 2 * geom.half.x(), depth = 2 * geom.half.z();
    const auto [left, right] = cellsIn(box.lo[0], box.hi[0], width, map.columns);
    const auto [back, front] = cellsIn(box.lo[2], box.hi[2], depth, map.rows);
    const double dx = width / (map.columns - 1), dz = depth / (map.rows - 1);
    const auto sample = [&](std::size_t i, std::size_t k) {
        return Vec3(static_cast<double>(i) * dx - width / 2, geom.radius * static_cast<double>(map.heights[k * map.columns + i]),
                    static_cast<double>(k) * dz - depth / 2);
    };
    for (std::size_t k = back; k <= front; ++k)
        for (std::size_t i = left; i <= right; ++i) {
            const Vec3 a = sample(i, k), b = sample(i + 1, k), c = sample(i, k + 1), d = sample(i + 1, k + 1);
            if (std::max({a.y(), b.y(), c.y(), d.y()}) < box.lo[1]) continue;
            m_triangles.push_back({a, c, b});
            m_triangles.push_back({d, b, c});
        }
}

} // namespace trundle
