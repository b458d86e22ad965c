// Needs: shapes and poses. Assumption: the ground is flat and rigid, and so is the robot. Method: points of its shapes within a
// tolerance of the lowest one support it; their convex hull by Andrew's monotone chain. On a slope of the angle a the centre of mass, h above
// the ground, is above the point that is h tan(a) further down: the robot tips where that leaves the hull.
#include "scene/queries/balance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "model/mass_properties.h"

namespace trundle {
namespace {

constexpr double kTouch = 2e-3; // m; what is this little above the ground settles onto it

using Points = std::vector<Vec3>;

void addBox(const GeomSpec& g, const Pose& X_WG, Points& points) {
    for (int i = 0; i < 8; ++i)
        points.push_back(X_WG * Vec3(0.5 * g.size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1))));
}

/// The lowest points of both rims; all around where the cylinder is upright.
void addCylinder(const GeomSpec& g, const Pose& X_WG, Points& points) {
    const Vec3 along = X_WG.rotation * Vec3::UnitZ();
    const Vec3 down = -Vec3::UnitZ() + along.z() * along;
    for (const double end : {-0.5, 0.5}) {
        const Vec3 middle = X_WG.position + end * g.length * along;
        if (down.norm() > 1e-6) points.push_back(middle + g.radius * down.normalized());
        if (std::abs(along.z()) < 0.5) continue;
        constexpr int kSpokes = 24;
        for (int i = 0; i < kSpokes; ++i) {
            const double a = 2 * std::numbers::pi * i / kSpokes;
            points.push_back(middle + X_WG.rotation * Vec3(g.radius * std::cos(a), g.radius * std::sin(a), 0));
        }
    }
}

void addLowest(const GeomSpec& g, const Pose& X_WG, Points& points) {
    switch (g.shape) {
    case GeomShape::Box: return addBox(g, X_WG, points);
    case GeomShape::Sphere: return points.push_back(X_WG.position - g.radius * Vec3::UnitZ());
    case GeomShape::Cylinder: return addCylinder(g, X_WG, points);
    case GeomShape::Capsule:
        for (const double end : {-0.5, 0.5}) points.push_back(X_WG * Vec3(0, 0, end * g.length) - g.radius * Vec3::UnitZ());
        return;
    case GeomShape::Convex:
    case GeomShape::Mesh:
        if (g.mesh)
            for (const auto& p : g.mesh->points) points.push_back(X_WG * Vec3(p[0], p[1], p[2]));
        return;
    default: return;
    }
}

double cross(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

Points hullOf(Points points) {
    std::ranges::sort(points, [](const Vec3& a, const Vec3& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    const auto same = [](const Vec3& a, const Vec3& b) { return (a - b).head<2>().norm() < 1e-6; };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3) return points;
    Points hull;
    const auto add = [&](const Vec3& p, std::size_t least) {
        while (hull.size() >= least && cross(hull[hull.size() - 2], hull.back(), p) <= 1e-12) hull.pop_back();
        hull.push_back(p);
    };
    for (const Vec3& p : points) add(p, 2);
    const std::size_t lower = hull.size() + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.pop_back();
    return hull;
}

double distanceToEdge(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Eigen::Vector2d along = (b - a).head<2>(), from = (p - a).head<2>();
    const double length = along.squaredNorm(), t = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
    return (from - t * along).norm();
}

double marginOf(const Points& polygon, const Vec3& p) {
    double nearest = HUGE_VAL;
    bool isInside = polygon.size() > 2;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        nearest = std::min(nearest, distanceToEdge(p, a, b));
        isInside = isInside && cross(a, b, p) > 0;
    }
    return isInside ? nearest : -nearest;
}

} // namespace

MassProperties massOf(const ObjectIndex& objects, std::uint32_t robot, const BodyPoses& poses) {
    std::vector<MassProperties> parts;
    const RobotConfigSpec& config = *objects.experiment().robots[robot].config;
    for (std::uint32_t b = 0; b < config.bodies.size(); ++b)
        if (config.bodies[b].mass.mass > 0 && !config.bodies[b].isFixed)
            parts.push_back(placed(config.bodies[b].mass, objects.poseOf({ObjectKind::Body, robot, b}, poses)));
    return sum(parts);
}

InertiaEllipsoid ellipsoidOf(const MassProperties& mass) {
    InertiaEllipsoid made;
    if (!(mass.mass > 0)) return made;
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(mass.inertia);
    made.moments = solver.eigenvalues();
    made.axes = solver.eigenvectors();
    if (made.axes.determinant() < 0) made.axes.col(0) *= -1;
    for (int i = 0; i < 3; ++i)
        made.semiAxes[i] = std::sqrt(std::max(0.0, 2.5 / mass.mass * (made.moments.sum() - 2 * made.moments[i])));
    return made;
}

std::string balanceText(const Balance& balance) {
    if (balance.polygon.size() == 1) return "Rests on a point: it may roll or tip";
    if (balance.polygon.size() < 3) return "Falls over: it rests on a line";
    const double mm = std::abs(balance.margin) * 1000;
    char text[80];
    std::snprintf(text, sizeof text, balance.isStable() ? "Stable: %.*f mm to the edge" : "Falls over: %.*f mm beyond the edge",
                  mm < 10 ? 1 : 0, mm);
    return text;
}

Vec3 edgeTowards(const Balance& balance, const Vec3& direction) {
    const Vec3 along = Vec3(direction.x(), direction.y(), 0).normalized();
    double reach = HUGE_VAL;
    for (std::size_t i = 0; i < balance.polygon.size(); ++i) {
        const Vec3 &a = balance.polygon[i], edge = balance.polygon[(i + 1) % balance.polygon.size()] - a;
        const double towards = along.dot(Vec3(edge.y(), -edge.x(), 0)); // the edge's outward normal
        if (towards > 1e-12) reach = std::min(reach, (a - balance.centre).dot(Vec3(edge.y(), -edge.x(), 0)) / towards);
    }
    return std::isfinite(reach) ? Vec3(balance.centre + reach * along) : balance.centre;
}

Vec3 nearestEdge(const Balance& balance) {
    Vec3 nearest = balance.centre;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < balance.polygon.size(); ++i) {
        const Vec3 &a = balance.polygon[i], along = balance.polygon[(i + 1) % balance.polygon.size()] - a;
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp((balance.centre - a).dot(along) / length, 0.0, 1.0) : 0;
        const Vec3 point = a + t * along;
        if (const double distance = (point - balance.centre).norm(); distance < least) nearest = point, least = distance;
    }
    return nearest;
}

double tipAngle(const Balance& balance, const Vec3& direction) {
    if (!balance.isStable()) return 0;
    return std::atan2((edgeTowards(balance, direction) - balance.centre).norm(), balance.height);
}

double leastTipAngle(const Balance& balance) { return balance.isStable() ? std::atan2(balance.margin, balance.height) : 0; }

std::string tippingText(const Balance& balance, double heading) {
    std::string text;
    const char* const names[] = {"forward", "left", "backward", "right"};
    const auto degrees = [](double angle) { return std::to_string(std::lround(angle * 180 / std::numbers::pi)) + "°"; };
    for (const int quarter : {0, 2, 1, 3}) {
        const double angle = heading + quarter * std::numbers::pi / 2;
        text += (text.empty() ? "" : ", ") + std::string(names[quarter]) + " " +
                degrees(tipAngle(balance, {std::cos(angle), std::sin(angle), 0}));
    }
    return text + "; least " + degrees(leastTipAngle(balance));
}

std::optional<Balance> balanceOf(const ObjectIndex& objects, std::uint32_t robot, const BodyPoses& poses) {
    const RobotConfigSpec& config = *objects.experiment().robots[robot].config;
    const auto isHeld = [&](const auto& link) { return link.parentRobot == int(robot) || link.childRobot == int(robot); };
    if (std::ranges::any_of(config.joints, [](const JointSpec& joint) { return joint.parent == kWorldBody; }) ||
        std::ranges::any_of(objects.experiment().joints, isHeld))
        return std::nullopt;
    const MassProperties mass = massOf(objects, robot, poses);
    Points points;
    for (std::uint32_t b = 0; b < config.bodies.size(); ++b)
        for (const GeomSpec& geom : config.bodies[b].geoms)
            if (geom.collide) addLowest(geom, objects.poseOf({ObjectKind::Body, robot, b}, poses) * geom.pose, points);
    if (!(mass.mass > 0) || points.empty()) return std::nullopt;
    Balance balance;
    balance.level = std::ranges::min(points, {}, [](const Vec3& p) { return p.z(); }).z();
    std::erase_if(points, [&](const Vec3& p) { return p.z() > balance.level + kTouch; });
    for (Vec3& p : points) p.z() = balance.level;
    balance.polygon = hullOf(std::move(points));
    balance.centre = {mass.centre.x(), mass.centre.y(), balance.level};
    balance.height = mass.centre.z() - balance.level;
    balance.margin = marginOf(balance.polygon, balance.centre);
    return balance;
}

} // namespace trundle
