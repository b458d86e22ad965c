#include "scene/queries/face_snap.h"

#include <algorithm>
#include <cmath>

#include "scene/shapes/extents.h"

namespace trundle {
namespace {

constexpr double kAligned = 1 - 1e-9; // cosine

/// A place along one direction of the face, from its middle, and the line of the face that it belongs to.
struct Place {
    double at = 0;
    std::optional<double> line; ///< nothing: a multiple of the step
};

Mat3 axesAlong(const Vec3& x, const Vec3& z) {
    Mat3 axes;
    axes << x, z.cross(x), z;
    return axes;
}

std::vector<Place> featuresOf(double half, double low, double high, double axis) {
    std::vector<Place> places{{-(low + high) / 2, 0.}};
    if (std::abs(axis) < half) places.push_back({axis, axis});
    if (high - low < 2 * half) places.push_back({-half - low, -half}), places.push_back({half - high, half});
    return places;
}

} // namespace

std::optional<FlatFace> FlatFace::of(const GeomSpec& geom, const Pose& owner, const RayHit& hit) {
    const Pose X_WG = owner * geom.pose;
    const Mat3 axes = X_WG.rotation.toRotationMatrix();
    const Vec3 n = axes.transpose() * hit.normal, p = X_WG.inverse() * hit.point;
    FlatFace face;
    const auto frame = [&](const Vec3& middle, int x, const Vec3& normal) {
        face.middle = X_WG * middle;
        face.rotation = Quat(axesAlong(axes.col(x), normal));
    };
    const bool isMesh = geom.shape == GeomShape::Mesh || geom.shape == GeomShape::Convex;
    if (geom.shape == GeomShape::Box || isMesh) {
        int k = 0;
        n.cwiseAbs().maxCoeff(&k);
        const Bounds bounds = boundsOf(geom, geom.pose.inverse());
        if (std::abs(n[k]) < kAligned || bounds.empty()) return std::nullopt;
        Vec3 middle = bounds.centre();
        middle[k] = isMesh ? p[k] : std::copysign(geom.size[k] / 2, n[k]);
        frame(middle, (k + 1) % 3, std::copysign(1, n[k]) * axes.col(k));
        const Vec3 half = bounds.size() / 2;
        face.half = {half[(k + 1) % 3], half[(k + 2) % 3]};
        return face;
    }
    if (geom.shape != GeomShape::Cylinder) return std::nullopt;
    if (std::abs(n.z()) > kAligned) {
        frame({0, 0, std::copysign(geom.length / 2, n.z())}, 0, hit.normal);
        face.half = {geom.radius, geom.radius};
    } else { // along its side
        frame({p.x(), p.y(), 0}, 2, hit.normal);
        face.half = {geom.length / 2, 0};
    }
    return face;
}

FaceSnap snapOnFace(const FlatFace& face, const Vec3& point, const FaceSnapOptions& options) {
    const Mat3 axes = face.rotation.toRotationMatrix();
    const Vec3 p = axes.transpose() * (point - face.middle), origin = axes.transpose() * (options.origin - face.middle);
    const Bounds thing = options.thing.empty() ? Bounds{Vec3::Zero(), Vec3::Zero()} : options.thing;
    FaceSnap snap{point, {}};
    for (int k = 0; k < 2; ++k) {
        const double half = face.half[std::size_t(k)];
        const Vec3 along = axes.col(k);
        std::vector<Place> places;
        if (half > 0)
            for (const Place& place : featuresOf(half, thing.low[k], thing.high[k], origin[k]))
                if (std::abs(place.at - p[k]) < options.near[std::size_t(k)]) places.push_back(place);
        int world = 0;
        along.cwiseAbs().maxCoeff(&world);
        if (options.step > 0 && std::abs(along[world]) > kAligned)
            places.push_back({p[k] + (options.step * std::round(point[world] / options.step) - point[world]) / along[world], {}});
        const auto nearest = std::ranges::min_element(places, {}, [&](const Place& place) { return std::abs(place.at - p[k]); });
        if (nearest == places.end()) continue;
        snap.point += (nearest->at - p[k]) * along;
        if (!nearest->line) continue;
        const double across = face.half[std::size_t(1 - k)];
        const Vec3 middle = face.middle + *nearest->line * along, reach = across * axes.col(1 - k);
        if (across > 0) snap.guides.push_back({middle - reach, middle + reach});
    }
    return snap;
}

} // namespace trundle
