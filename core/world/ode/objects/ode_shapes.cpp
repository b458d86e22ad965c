#include "world/ode/objects/ode_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/convex_hull.h"

namespace trundle {

namespace {

struct Bounds {
    Vec3 lo, hi;
    [[nodiscard]] Vec3 centre() const { return (lo + hi) / 2; }
    [[nodiscard]] Vec3 half() const { return (hi - lo) / 2; }
};

template <class Points> Bounds boundsOf(const Points& points) {
    Bounds b{Vec3(points[0][0], points[0][1], points[0][2]), Vec3(points[0][0], points[0][1], points[0][2])};
    for (const auto& p : points)
        for (int k = 0; k < 3; ++k) {
            b.lo[k] = std::min(b.lo[k], p[static_cast<std::size_t>(k)]);
            b.hi[k] = std::max(b.hi[k], p[static_cast<std::size_t>(k)]);
        }
    return b;
}

constexpr double kNeedle = 1e-6;           // minimum height of a triangle, relative to the size of its hull
constexpr std::size_t kMaxHullPoints = 96; // ODE visits all of them for every pair

OdeShape simple(dGeomID id, const Vec3& half, double bound) { return {id, {}, half, bound, nullptr}; }

Error bad(const GeomSpec& spec, const std::string& why) { return {Code::BadGeometry, spec.name + " " + why}; }

/// ODE requires every polygon to be counter-clockwise around an origin inside the hull.
Result<OdeShape> hullShape(const GeomSpec& spec) {
    const TriangleMesh* given = spec.hull ? spec.hull.get() : spec.mesh.get();
    const auto hull = given ? convexHull(farthestPoints(given->points, kMaxHullPoints)) : std::nullopt;
    if (!hull) return bad(spec, "has no volume: a convex hull needs at least four points that are not in one plane");
    Vec3 centre = Vec3::Zero();
    for (const auto& p : hull->points) centre += Vec3(p[0], p[1], p[2]);
    centre /= static_cast<double>(hull->points.size());

    OdeShape shape;
    shape.data = std::make_shared<ShapeData>();
    shape.centre.position = centre;
    for (const auto& p : hull->points) {
        const Vec3 q = Vec3(p[0], p[1], p[2]) - centre;
        shape.data->points.insert(shape.data->points.end(), {q.x(), q.y(), q.z()});
        shape.half = shape.half.cwiseMax(q.cwiseAbs());
        shape.bound = std::max(shape.bound, q.norm());
    }
    const auto at = [&](std::uint32_t i) { return Vec3(&shape.data->points[3 * i]); };
    for (const auto& f : hull->triangles) {
        const Vec3 ab = at(f[1]) - at(f[0]), ac = at(f[2]) - at(f[0]), bc = at(f[2]) - at(f[1]), across = ab.cross(ac);
        const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()}));
        if (across.norm() <= kNeedle * shape.bound * longest) continue; // no stable normal; its neighbours cover it
        const Vec3 normal = across.normalized();
        shape.data->planes.insert(shape.data->planes.end(), {normal.x(), normal.y(), normal.z(), normal.dot(at(f[0]))});
        shape.data->polygons.insert(shape.data->polygons.end(), {3u, f[0], f[1], f[2]});
    }
    const auto faces = static_cast<unsigned>(shape.data->planes.size() / 4);
    if (faces < 4) return bad(spec, "has no volume: its convex hull is too thin");
    shape.id = dCreateConvex(nullptr, shape.data->planes.data(), faces, shape.data->points.data(),
                             static_cast<unsigned>(hull->points.size()), shape.data->polygons.data());
    return shape;
}

std::vector<Box3> boxesOf(const ShapeData& mesh) {
    std::vector<Box3> boxes;
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
        const auto corner = [&](std::size_t i) {
            const double* p = &mesh.points[3 * mesh.triangles[t + i]];
            return Box3{{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
        };
        boxes.push_back(corner(0));
        boxes.back().cover(corner(1));
        boxes.back().cover(corner(2));
    }
    return boxes;
}

Result<OdeShape> meshShape(const GeomSpec& spec) {
    if (!spec.mesh || spec.mesh->points.empty()) return bad(spec, "has no triangles");
    const TriangleMesh& mesh = *spec.mesh;
    const Bounds bounds = boundsOf(mesh.points);
    OdeShape shape;
    shape.data = std::make_shared<ShapeData>();
    shape.centre.position = bounds.centre();
    shape.half = bounds.half();
    shape.bound = shape.half.norm();
    for (const auto& p : mesh.points)
        for (std::size_t k = 0; k < 3; ++k) shape.data->points.push_back(p[k] - shape.centre.position[static_cast<int>(k)]);
    const auto at = [&](std::uint32_t i) { return Vec3(&shape.data->points[3 * i]); };
    const double smallest = 1e-14 * std::max(1e-12, shape.half.squaredNorm());
    for (const auto& t : mesh.triangles) {
        if (t[0] >= mesh.points.size() || t[1] >= mesh.points.size() || t[2] >= mesh.points.size()) continue;
        if ((at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm() <= smallest) continue; // degenerate: no normal
        shape.data->triangles.insert(shape.data->triangles.end(), t.begin(), t.end());
    }
    if (shape.data->triangles.empty()) return bad(spec, "has no triangle with an area");
    shape.data->triangleGrid.build(boxesOf(*shape.data));
    shape.data->mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(shape.data->mesh, shape.data->points.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.points.size()), shape.data->triangles.data(),
                                static_cast<int>(shape.data->triangles.size()), 3 * sizeof(dTriIndex));
    dGeomTriMeshDataPreprocess2(shape.data->mesh, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
    shape.id = dCreateTriMesh(nullptr, shape.data->mesh, nullptr, nullptr, nullptr);
    return shape;
}

/// ODE's height fields rise along y with the first row at -z; a quarter turn about x moves that row to +y.
Result<OdeShape> heightShape(const GeomSpec& spec) {
    if (!spec.heightMap || spec.heightMap->columns < 2 || spec.heightMap->rows < 2 ||
        spec.heightMap->heights.size() < static_cast<std::size_t>(spec.heightMap->columns) * spec.heightMap->rows)
        return bad(spec, "needs a picture of at least 2 x 2 pixels");
    const HeightMap& map = *spec.heightMap;
    OdeShape shape;
    shape.data = std::make_shared<ShapeData>();
    shape.data->heightMap = spec.heightMap;
    shape.data->heights = dGeomHeightfieldDataCreate();
    const double skirt = std::max(spec.size.z(), 1.0); // solid ground below black
    dGeomHeightfieldDataBuildSingle(shape.data->heights, map.heights.data(), 0, spec.size.x(), spec.size.y(),
                                    static_cast<int>(map.columns), static_cast<int>(map.rows), spec.size.z(), 0, skirt, 0);
    dGeomHeightfieldDataSetBounds(shape.data->heights, 0, spec.size.z());
    shape.id = dCreateHeightfield(nullptr, shape.data->heights, 1);
    shape.centre.rotation = rotationFromHpr({0, 0, std::numbers::pi / 2});
    shape.half = {spec.size.x() / 2, spec.size.z() + skirt, spec.size.y() / 2};
    shape.bound = shape.half.norm();
    return shape;
}

} // namespace

ShapeData::~ShapeData() {
    if (mesh) dGeomTriMeshDataDestroy(mesh);
    if (heights) dGeomHeightfieldDataDestroy(heights);
}

Result<OdeShape> makeShape(const GeomSpec& spec) {
    const double r = spec.radius, half = spec.length / 2;
    switch (spec.shape) {
    case GeomShape::Box:
        return simple(dCreateBox(nullptr, spec.size.x(), spec.size.y(), spec.size.z()), spec.size / 2, spec.size.norm() / 2);
    case GeomShape::Sphere: return simple(dCreateSphere(nullptr, r), {r, r, r}, r);
    case GeomShape::Cylinder: return simple(dCreateCylinder(nullptr, r, spec.length), {r, r, half}, std::hypot(r, half));
    case GeomShape::Capsule: return simple(dCreateCapsule(nullptr, r, spec.length), {r, r, half + r}, half + r);
    case GeomShape::Convex: return hullShape(spec);
    case GeomShape::Mesh: return spec.collideAsHull ? hullShape(spec) : meshShape(spec);
    case GeomShape::Heightfield: return heightShape(spec);
    case GeomShape::Plane: break;
    }
    return bad(spec, "cannot be made here");
}

} // namespace trundle
