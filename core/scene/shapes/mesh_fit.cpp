// Method: the smallest circle and ball around points by steps towards the farthest one (Badoiu and Clarkson, Smaller Core-Sets for Balls,
// SODA 2003); distances to shapes in closed form, to the hull by its faces: the mesh is inside.

#include "scene/shapes/mesh_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/convex_hull.h"
#include "scene/shapes/bounds.h"

namespace trundle {
namespace {

constexpr int kBallSteps = 2000;
constexpr std::size_t kMostSamples = 20000, kMostWork = 50000000, kOuterPoints = 400, kHullPoints = 4000;
constexpr double kThinnest = 1e-4; // m, of a shape

/// Centre of the smallest ball around points, in as many dimensions as are not masked out.
Vec3 ballCentre(const std::vector<Vec3>& points, const Vec3& mask) {
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : points) centre += p / double(points.size());
    for (int step = 1; step <= kBallSteps; ++step) {
        const auto distance = [&](const Vec3& p) { return (p - centre).cwiseProduct(mask).squaredNorm(); };
        const Vec3& far = *std::ranges::max_element(points, {}, distance);
        centre += (far - centre) / (step + 1.0);
    }
    return centre;
}

/// From the surface of the shape, in its own frame.
double distanceTo(const GeomSpec& geom, const Vec3& p) {
    switch (geom.shape) {
    case GeomShape::Box: {
        const Vec3 q = p.cwiseAbs() - geom.size / 2;
        return std::abs(q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0));
    }
    case GeomShape::Sphere: return std::abs(p.norm() - geom.radius);
    case GeomShape::Cylinder: {
        const double out = std::hypot(p.x(), p.y()) - geom.radius, along = std::abs(p.z()) - geom.length / 2;
        return std::abs(std::hypot(std::max(out, 0.0), std::max(along, 0.0)) + std::min(std::max(out, along), 0.0));
    }
    case GeomShape::Capsule: {
        const double past = std::max(std::abs(p.z()) - geom.length / 2, 0.0);
        return std::abs(std::hypot(p.x(), p.y(), past) - geom.radius);
    }
    default: break;
    }
    double inside = INFINITY; // from the nearest face
    for (const auto& [i, j, k] : geom.mesh->triangles) {
        const Vec3 a(geom.mesh->points[i].data()), b(geom.mesh->points[j].data()), c(geom.mesh->points[k].data());
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.norm() > 0) inside = std::min(inside, std::abs(normal.normalized().dot(p - a)));
    }
    return inside;
}

Quat alongAxis(int axis) {
    if (axis == 0) return Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()));
    if (axis == 1) return Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
    return Quat::Identity();
}

class ShapeFitter {
public:
    explicit ShapeFitter(const TriangleMesh& mesh) {
        for (const auto& point : mesh.points) m_samples.emplace_back(point.data());
        for (const Vec3& p : m_samples) m_bounds.add(p);
        for (const auto& [i, j, k] : mesh.triangles) m_samples.push_back((m_samples[i] + m_samples[j] + m_samples[k]) / 3);
        const std::size_t step = m_samples.size() / kMostSamples + 1;
        for (std::size_t i = 0; i < m_samples.size(); i += step) m_samples[i / step] = m_samples[i];
        m_samples.resize((m_samples.size() + step - 1) / step);
        m_outer = farthestPoints(mesh.points, kOuterPoints);
        for (const auto& point : mesh.points) m_points.emplace_back(point.data());
    }

    [[nodiscard]] MeshFit box() const {
        GeomSpec geom = at(GeomShape::Box, m_bounds.centre());
        geom.size = m_bounds.size().cwiseMax(kThinnest);
        return measured(geom);
    }
    [[nodiscard]] MeshFit sphere() const {
        GeomSpec geom = at(GeomShape::Sphere, ballCentre(outer(), Vec3::Ones()));
        geom.radius = reach(geom.pose.position, Vec3::Ones());
        return measured(geom);
    }
    /// A cylinder or a capsule, along the axis that is nearest.
    [[nodiscard]] MeshFit round(GeomShape shape) const {
        MeshFit best;
        best.mean = INFINITY;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 mask = Vec3::Ones();
            mask[axis] = 0;
            Vec3 centre = ballCentre(outer(), mask);
            centre[axis] = m_bounds.centre()[axis];
            GeomSpec geom = at(shape, centre);
            geom.pose.rotation = alongAxis(axis);
            geom.radius = std::max(reach(centre, mask), kThinnest);
            geom.length = m_bounds.size()[axis];
            if (shape == GeomShape::Capsule) { // as short as its ends allow
                geom.length = 0;
                for (const Vec3& p : m_points) {
                    const double out = (p - centre).cwiseProduct(mask).norm(), along = std::abs(p[axis] - centre[axis]);
                    const double cap = std::sqrt(std::max(0.0, geom.radius * geom.radius - out * out));
                    geom.length = std::max(geom.length, 2 * (along - cap));
                }
            }
            geom.length = std::max(geom.length, kThinnest);
            if (MeshFit fit = measured(geom); fit.mean < best.mean) best = std::move(fit);
        }
        return best;
    }
    [[nodiscard]] std::optional<MeshFit> hull() const {
        std::vector<std::array<double, 3>> points;
        for (const Vec3& p : m_points) points.push_back({p.x(), p.y(), p.z()});
        auto hull = convexHull(farthestPoints(points, kHullPoints));
        if (!hull) return std::nullopt;
        GeomSpec geom = at(GeomShape::Convex, Vec3::Zero());
        geom.mesh = std::make_shared<const TriangleMesh>(std::move(*hull));
        return measured(geom);
    }

private:
    static GeomSpec at(GeomShape shape, const Vec3& centre) {
        GeomSpec geom;
        geom.shape = shape;
        geom.pose.position = centre;
        return geom;
    }
    [[nodiscard]] std::vector<Vec3> outer() const {
        std::vector<Vec3> points;
        for (const auto& point : m_outer) points.emplace_back(point.data());
        return points;
    }
    [[nodiscard]] double reach(const Vec3& centre, const Vec3& mask) const {
        double radius = 0;
        for (const Vec3& p : m_points) radius = std::max(radius, (p - centre).cwiseProduct(mask).norm());
        return radius;
    }
    [[nodiscard]] MeshFit measured(const GeomSpec& geom) const {
        MeshFit fit{geom, 0, 0};
        const Pose inverse = geom.pose.inverse();
        const std::size_t work = geom.mesh ? m_samples.size() * geom.mesh->triangles.size() : 0, step = work / kMostWork + 1;
        const double count = double((m_samples.size() + step - 1) / step);
        for (std::size_t i = 0; i < m_samples.size(); i += step) {
            const double distance = distanceTo(geom, inverse * m_samples[i]);
            fit.largest = std::max(fit.largest, distance);
            fit.mean += distance / count;
        }
        return fit;
    }

    std::vector<Vec3> m_samples, m_points;
    std::vector<std::array<double, 3>> m_outer;
    Bounds m_bounds;
};

} // namespace

std::vector<MeshFit> fitsAround(const TriangleMesh& mesh) {
    if (mesh.triangles.empty() || mesh.points.empty()) return {};
    const ShapeFitter fitter(mesh);
    std::vector<MeshFit> fits{fitter.box(), fitter.round(GeomShape::Cylinder), fitter.sphere(), fitter.round(GeomShape::Capsule)};
    if (auto hull = fitter.hull()) fits.push_back(std::move(*hull));
    return fits;
}

} // namespace trundle
