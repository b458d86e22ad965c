#pragma once
// What is asked of the rays of an engine, and where the results go. World frame, m, rad.

#include <cstdint>
#include <optional>
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

/// What rays can hit, with the poses after the last step; for one thread at a time. Geoms of the actor `without` (an index, kNoGeom for none) are ignored.
class RayTargets {
public:
    virtual ~RayTargets() = default;
    /// Nothing for what is no ray.
    [[nodiscard]] virtual std::optional<SingleHit> ray(const SingleRay& ray, std::uint32_t without) const = 0;
    virtual void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const = 0;
    virtual void castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const = 0;
    /// How often poses were taken over for casts: once in a tick with casts.
    [[nodiscard]] virtual std::uint64_t updates() const = 0;
};

} // namespace trundle
