#pragma once
// What is asked of the rays of an engine, and where the results go. World frame, m, rad.

#include <cstdint>
#include <span>

#include <trundle/geometry.h>

namespace trundle {

/// Rings of `count` beams from one point, one ring for each elevation. Axes: forwards, left, up; bearings are about up, from forwards to
/// left, elevations towards up. The beam k of a ring has the bearing firstBearing + k * bearingStep.
struct RayFan {
    Vec3 origin = Vec3::Zero();
    Mat3 axes = Mat3::Identity(); ///< columns
    double range = 1, firstBearing = 0, bearingStep = 0;
    std::uint32_t count = 1;
    std::span<const double> elevations; ///< from -pi/2 to pi/2

    [[nodiscard]] std::size_t size() const { return count * elevations.size(); }
};

struct SingleRay {
    Vec3 origin = Vec3::Zero(), direction = Vec3::UnitX(); ///< a unit vector
    double range = 1;
};

inline constexpr std::uint32_t kNoGeom = 0xffffffffu;

struct SingleHit {
    double distance = 0;
    Vec3 normal = Vec3::UnitZ(); ///< against the ray
    std::uint32_t geom = kNoGeom;
};

/// One element for each ray, of a fan layer by layer. Arrays that are null are not filled.
struct RayHits {
    double* distances = nullptr; ///< the range where nothing is hit
    std::uint32_t* geoms = nullptr;
    double* normals = nullptr; ///< three numbers each, against the ray; zeros where nothing is hit
};

} // namespace trundle
