#pragma once
// How a picture lies on a geom: the same for drawing and for what sensors see of it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include <Eigen/Core>

#include "model/body_spec.h"

namespace trundle {

enum class PictureMap : std::uint8_t { Planar, Box, Cylinder, Sphere };

/// The mapping for a material's TextureMap value; `auto` depends on the shape.
[[nodiscard]] inline PictureMap pictureMapOf(std::string_view word, GeomShape shape) {
    if (word == "planar") return PictureMap::Planar;
    if (word == "box") return PictureMap::Box;
    if (word == "cylinder") return PictureMap::Cylinder;
    if (word == "sphere") return PictureMap::Sphere;
    switch (shape) {
    case GeomShape::Sphere:
    case GeomShape::Capsule: return PictureMap::Sphere;
    case GeomShape::Cylinder: return PictureMap::Cylinder;
    case GeomShape::Plane:
    case GeomShape::Heightfield: return PictureMap::Planar;
    default: return PictureMap::Box;
    }
}

namespace detail {

template <class Real> using Vector2 = Eigen::Matrix<Real, 2, 1>;
template <class Real> using Vector3 = Eigen::Matrix<Real, 3, 1>;

inline constexpr double kFlatCap = 0.9; // a face whose normal has this |z| or more is a cap

template <class Real> Vector2<Real> pictureOnBox(const Vector3<Real>& share, const Vector3<Real>& normal) {
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const bool front = normal[axis] > 0;
    if (axis == 0) return {front ? share.y() : 1 - share.y(), 1 - share.z()};
    if (axis == 1) return {front ? 1 - share.x() : share.x(), 1 - share.z()};
    return {share.x(), front ? 1 - share.y() : share.y()};
}

template <class Real> Vector2<Real> pictureAround(const Vector3<Real>& share, PictureMap map) {
    const double half = 0.5, height = std::clamp(2.0 * share.z() - 1, -1.0, 1.0);
    const double down = map == PictureMap::Sphere ? half - std::asin(height) / std::numbers::pi : 1.0 - share.z();
    const Real across = share.x() - static_cast<Real>(half), along = share.y() - static_cast<Real>(half);
    const Real turn = static_cast<Real>(std::atan2(along, across) / (2 * std::numbers::pi)) + static_cast<Real>(half);
    return {turn, static_cast<Real>(down)};
}

} // namespace detail

/// Whether a face with this normal is a cap, which has the whole picture as a side of a box has it.
template <class Real> [[nodiscard]] bool isPictureCap(const Eigen::Matrix<Real, 3, 1>& normal, PictureMap map) {
    return map == PictureMap::Cylinder && std::abs(normal.z()) > static_cast<Real>(detail::kFlatCap);
}

/// Where in the picture a point of a geom is: (0, 0) is its top left corner, (1, 1) the lower right one. `share` is the point relative
/// to the geom's bounding box, 0 at its minimum, 1 at its maximum; the normal points outwards.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 2, 1> pictureAt(const Eigen::Matrix<Real, 3, 1>& share, const Eigen::Matrix<Real, 3, 1>& normal,
                                                  PictureMap map) {
    if (map == PictureMap::Planar) return {share.x(), 1 - share.y()};
    if (map == PictureMap::Box || isPictureCap(normal, map)) return detail::pictureOnBox<Real>(share, normal);
    return detail::pictureAround<Real>(share, map);
}

} // namespace trundle
