// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Many rays in one call, for range sensors. Since 1.6. All casts use the poses after the last step.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <trundle/abi.h>
#include <trundle/geometry.h>
#include <trundle/mount.h>

namespace trundle {
inline namespace sdk1 {

/// Beams from one point: for each elevation a ring of `count` beams, at the bearings firstBearing + k * bearingStep. Bearings are about
/// z, counter-clockwise from x, and elevations above the x-y plane of the pose from which it is cast. Any beam costs much less than a
/// ray of its own.
struct Fan {
    double range = 1;                         ///< m
    double firstBearing = 0, bearingStep = 0; ///< rad
    std::uint32_t count = 1;
    std::vector<double> elevations{0}; ///< rad, from -pi/2 to pi/2
    bool own = false;                  ///< true: geoms of the own robot are hit too

    [[nodiscard]] std::size_t size() const { return count * elevations.size(); }
    /// In the frame of the pose; beams are counted layer by layer.
    [[nodiscard]] Vec3 direction(std::size_t beam) const {
        const double bearing = firstBearing + static_cast<double>(beam % count) * bearingStep, up = elevations[beam / count];
        return {std::cos(up) * std::cos(bearing), std::cos(up) * std::sin(bearing), std::sin(up)};
    }
};

struct Ray {
    Vec3 origin = Vec3::Zero();     ///< world frame, m
    Vec3 direction = Vec3::UnitX(); ///< world frame, a unit vector
    double range = 1;               ///< m
};

/// Where the results of a cast go: one element per beam or ray. Spans that are empty are not filled.
struct RayResults {
    std::span<double> distances;  ///< m; the range where nothing is hit
    std::span<GeomId> geoms = {}; ///< an empty id where nothing is hit
    std::span<Vec3> normals = {}; ///< of the surface, world frame, against the beam; zero where nothing is hit

    [[nodiscard]] bool fits(std::size_t count) const {
        return distances.size() >= count && (geoms.empty() || geoms.size() >= count) &&
               (normals.empty() || normals.size() >= count);
    }
};

namespace detail {
static_assert(sizeof(GeomId) == sizeof(std::uint32_t) && sizeof(Vec3) == 3 * sizeof(double) && sizeof(Ray) == sizeof(TrundleRay));

/// nullptr: the program is older.
inline const TrundleServicesRays* raysOf(const TrundleServices& services) {
    return services.size >= offsetof(TrundleServices, rays) + sizeof services.rays ? services.rays : nullptr;
}

/// One ray by the service that all programs have.
inline void castRay(const TrundleServices& services, const Ray& ray, bool own, const RayResults& results, std::size_t at) {
    TrundleHit hit{};
    const bool found = services.ray(services.context, ray.origin.data(), ray.direction.data(), ray.range, own ? 1 : 0, &hit) != 0;
    results.distances[at] = found ? hit.distance : ray.range;
    if (!results.geoms.empty()) results.geoms[at] = found ? GeomId{hit.geom} : GeomId{};
    if (!results.normals.empty()) results.normals[at] = found ? Vec3(hit.normal) : Vec3(Vec3::Zero());
}

inline std::uint32_t* indices(const RayResults& results) {
    return results.geoms.empty() ? nullptr : &results.geoms.front().index;
}
inline double* numbers(const RayResults& results) { return results.normals.empty() ? nullptr : results.normals.front().data(); }

inline bool castFan(const TrundleServices& services, const Fan& fan, const Pose& pose, const RayResults& results) {
    if (fan.size() == 0 || !results.fits(fan.size())) return false;
    if (const TrundleServicesRays* rays = raysOf(services)) {
        const Vec3& p = pose.position;
        const Quat& q = pose.rotation;
        const TrundleFan f{{p.x(), p.y(), p.z()},
                           {q.w(), q.x(), q.y(), q.z()},
                           fan.range,
                           fan.firstBearing,
                           fan.bearingStep,
                           fan.elevations.data(),
                           fan.count,
                           static_cast<std::uint32_t>(fan.elevations.size()),
                           fan.own ? 1 : 0,
                           0};
        return rays->castFan(services.context, &f, results.distances.data(), indices(results), numbers(results)) == 0;
    }
    for (std::size_t i = 0; i < fan.size(); ++i)
        castRay(services, {pose.position, pose.rotation * fan.direction(i), fan.range}, fan.own, results, i);
    return true;
}

inline bool castRays(const TrundleServices& services, std::span<const Ray> list, bool own, const RayResults& results) {
    if (!results.fits(list.size())) return false;
    if (list.empty()) return true;
    if (const TrundleServicesRays* rays = raysOf(services))
        return rays->castRays(services.context, reinterpret_cast<const TrundleRay*>(list.data()),
                              static_cast<std::uint32_t>(list.size()), own ? 1 : 0, results.distances.data(), indices(results),
                              numbers(results)) == 0;
    for (std::size_t i = 0; i < list.size(); ++i) castRay(services, list[i], own, results, i);
    return true;
}

/// Contacts of a geom in the last step; `out` is overwritten.
inline void contacts(const TrundleServices& services, std::uint32_t geom, std::vector<TrundleContact>& out) {
    constexpr std::uint32_t kUsual = 8;
    TrundleContact usual[kUsual]; // not initialised: nearly always there are few or none
    std::uint32_t there = services.contacts(services.context, geom, usual, kUsual);
    if (there == 0) return out.clear();
    if (there <= kUsual) return out.assign(usual, usual + there);
    out.resize(there);
    const std::uint32_t now = services.contacts(services.context, geom, out.data(), there);
    if (now < there) out.resize(now);
}

inline bool geomInfo(const TrundleServices& services, GeomId geom, TrundleGeomInfo& info) {
    info = {};
    info.size = sizeof info;
    info.path = info.material = "";
    const TrundleServicesRays* rays = raysOf(services);
    return rays && rays->geomInfo(services.context, geom.index, &info) == 0;
}
} // namespace detail

} // namespace sdk1
} // namespace trundle
