#include "model/mass_properties.h"

#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

#include <Eigen/Eigenvalues>

#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSmallestMoment = 1e-18; ///< kg m^2; smaller moments are lost in rounding errors
constexpr double kRounding = 1e-15;

MassProperties centred(double volume, double xx, double yy, double zz) {
    return {volume, Vec3::Zero(), volume * Vec3(xx, yy, zz).asDiagonal().toDenseMatrix()};
}

MassProperties box(const Vec3& s) {
    const Vec3 q = s.cwiseProduct(s) / 12;
    return centred(s.prod(), q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
}

MassProperties sphere(double r) { return centred(4.0 / 3 * kPi * r * r * r, 0.4 * r * r, 0.4 * r * r, 0.4 * r * r); }

MassProperties cylinder(double r, double length) {
    const double across = r * r / 4 + length * length / 12;
    return centred(kPi * r * r * length, across, across, r * r / 2);
}

MassProperties capsule(double r, double length) {
    const double tube = kPi * r * r * length, caps = 4.0 / 3 * kPi * r * r * r, h = length / 2;
    const double across = tube * (r * r / 4 + length * length / 12) + caps * (0.4 * r * r + h * h + 0.75 * h * r);
    const double along = tube * r * r / 2 + caps * 0.4 * r * r;
    return {tube + caps, Vec3::Zero(), Vec3(across, across, along).asDiagonal().toDenseMatrix()};
}

/// Merges equal points and removes the triangles that become degenerate.
std::vector<std::array<std::uint32_t, 3>> welded(const TriangleMesh& mesh) {
    std::map<std::array<double, 3>, std::uint32_t> first;
    std::vector<std::uint32_t> place(mesh.points.size());
    for (std::uint32_t i = 0; i < mesh.points.size(); ++i) place[i] = first.try_emplace(mesh.points[i], i).first->second;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> w{place[t[0]], place[t[1]], place[t[2]]};
        if (w[0] != w[1] && w[1] != w[2] && w[0] != w[2]) triangles.push_back(w);
    }
    return triangles;
}

/// Whether every edge occurs once in each direction.
bool closed(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::unordered_map<std::uint64_t, int> edges;
    for (const auto& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = t[i], b = t[(i + 1) % 3];
            if (++edges[a << 32 | b] > 1) return false;
        }
    }
    for (const auto& [edge, count] : edges) {
        if (!edges.count(edge << 32 | edge >> 32)) return false;
    }
    return !triangles.empty();
}

} // namespace

Result<MassProperties> solidOf(const TriangleMesh& mesh) {
    const std::vector<std::array<std::uint32_t, 3>> triangles = welded(mesh);
    if (!closed(triangles)) return Error{Code::BadMass, "the mesh is not closed, so that it has no volume"};
    Vec3 origin = Vec3::Zero(); // near the points, to keep precision for meshes far from their origin
    for (const auto& p : mesh.points) origin += Vec3(p[0], p[1], p[2]) / static_cast<double>(mesh.points.size());
    const auto point = [&](std::uint32_t i) {
        return Vec3(Vec3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]) - origin);
    };
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    Mat3 second = Mat3::Zero(); // integral of x x^T, a sum over tetrahedra with one corner at the origin
    for (const auto& t : triangles) {
        const Vec3 a = point(t[0]), b = point(t[1]), c = point(t[2]), s = a + b + c;
        const double six = a.dot(b.cross(c));
        volume += six / 6;
        moment += six / 24 * s;
        second += six / 120 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    if (volume < 0) { // triangles are clockwise seen from outside
        volume = -volume;
        moment = -moment;
        second = -second;
    }
    if (!(volume > 0)) return Error{Code::BadMass, "the mesh has no volume"};
    const Vec3 centre = moment / volume;
    second -= volume * centre * centre.transpose();
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    return MassProperties{volume, centre + origin, inertia};
}

Result<MassProperties> solidOf(const GeomSpec& geom) {
    switch (geom.shape) {
    case GeomShape::Box: return box(geom.size);
    case GeomShape::Sphere: return sphere(geom.radius);
    case GeomShape::Cylinder: return cylinder(geom.radius, geom.length);
    case GeomShape::Capsule: return capsule(geom.radius, geom.length);
    case GeomShape::Convex:
    case GeomShape::Mesh:
        if (geom.mesh) return solidOf(*geom.mesh);
        break;
    default: break;
    }
    return Error{Code::BadMass, "it has no volume"};
}

MassProperties withMass(const MassProperties& solid, double mass) {
    return {mass, solid.centre, solid.inertia * (mass / solid.mass)};
}

Quat shapeRotation(const GeomSpec& geom) {
    Quat q = geom.pose.rotation;
    if (geom.shape != GeomShape::Cylinder && geom.shape != GeomShape::Capsule) return q;
    const auto areOpposite = [](double a, double b) { return std::abs(a + b) < kRounding; };
    const bool isRolled = areOpposite(q.x(), q.w()) && areOpposite(q.y(), q.z()); // by -90 degrees, after any heading
    const bool isPitched = areOpposite(q.y(), q.w()) && areOpposite(q.x(), -q.z());
    if (isRolled || isPitched) return {q.w(), 0.0 - q.x(), 0.0 - q.y(), q.z()};
    return q;
}

MassProperties placed(const MassProperties& solid, const Pose& pose) {
    const Mat3 r = pose.rotation.toRotationMatrix();
    return {solid.mass, pose * solid.centre, r * solid.inertia * r.transpose()};
}

MassProperties sum(const std::vector<MassProperties>& parts) {
    MassProperties total{0, Vec3::Zero(), Mat3::Zero()};
    for (const MassProperties& p : parts) {
        total.mass += p.mass;
        total.centre += p.mass * p.centre;
    }
    if (total.mass > 0) total.centre /= total.mass;
    for (const MassProperties& p : parts) {
        const Vec3 d = p.centre - total.centre;
        total.inertia += p.inertia + p.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
    }
    total.inertia = (total.inertia + total.inertia.transpose().eval()) / 2;
    return total;
}

Status checkMass(const MassProperties& m) {
    if (!(m.mass > 0) || !std::isfinite(m.mass) || !m.centre.allFinite() || !m.inertia.allFinite()) {
        return Error{Code::BadMass, "its mass is not a usable number"};
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(m.inertia, Eigen::EigenvaluesOnly);
    const Vec3 moments = solver.eigenvalues(); // in increasing order
    if (!moments.allFinite() || moments.x() <= 0) return Error{Code::BadMass, "its inertia is not positive definite"};
    if (moments.x() < kSmallestMoment)
        return Error{Code::BadMass, "its inertia is too small to be simulated (" + numberText(moments.x()) + " kg m^2)"};
    if (moments.x() + moments.y() < moments.z() * (1 - 1e-6)) {
        return Error{Code::BadMass, "no body has this inertia: of the principal moments " + numberText(moments.x()) + ", " +
                                        numberText(moments.y()) + " and " + numberText(moments.z()) +
                                        " the largest is above the sum of the others"};
    }
    return {};
}

} // namespace trundle
