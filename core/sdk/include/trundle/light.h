// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Light and what returns it, for devices. Since 1.7.

#include <cmath>
#include <cstddef>
#include <vector>

#include <trundle/abi.h>
#include <trundle/abi_light.h>
#include <trundle/geometry.h>
#include <trundle/mount.h>

namespace trundle {
inline namespace sdk1 {
namespace detail {

/// nullptr: the program is older.
inline const TrundleServicesLight* lightOf(const TrundleServices& services) {
    return services.size >= offsetof(TrundleServices, light) + sizeof services.light ? services.light : nullptr;
}

inline double reflectance(const TrundleServices& services, GeomId geom, const Vec3& point, const Vec3& normal) {
    const TrundleServicesLight* light = lightOf(services);
    double share = 0;
    return light && light->reflectance(services.context, geom.index, point.data(), normal.data(), &share) == 0 ? share : 0;
}

inline void lights(const TrundleServices& services, std::vector<TrundleLight>& out) {
    const TrundleServicesLight* light = lightOf(services);
    out.resize(light ? light->lights(services.context, nullptr, 0) : 0);
    if (!out.empty()) light->lights(services.context, out.data(), static_cast<std::uint32_t>(out.size()));
}

inline void beams(const TrundleServices& services, std::vector<TrundleBeam>& out) {
    const TrundleServicesLight* light = lightOf(services);
    const bool known = light && light->size >= offsetof(TrundleServicesLight, beams) + sizeof light->beams;
    out.resize(known ? light->beams(services.context, nullptr, 0) : 0);
    if (!out.empty()) light->beams(services.context, out.data(), static_cast<std::uint32_t>(out.size()));
}

inline void emitLight(const TrundleServices& services, BodyId body, const Vec3& point, double light) {
    const TrundleServicesLight* table = lightOf(services);
    if (table && table->size >= offsetof(TrundleServicesLight, emit) + sizeof table->emit)
        table->emit(services.context, body.index, point.data(), light);
}

inline void emitBeam(const TrundleServices& services, BodyId body, const Vec3& point, double light, const TrundleBeam& beam) {
    const TrundleServicesLight* table = lightOf(services);
    if (table && table->size >= offsetof(TrundleServicesLight, emitBeam) + sizeof table->emitBeam)
        table->emitBeam(services.context, body.index, point.data(), light, &beam);
    else emitLight(services, body, point, light);
}

} // namespace detail

/// The share of its light that a lamp sends along a unit direction away from it. Since 1.10.
[[nodiscard]] inline double shareAlong(const TrundleBeam& beam, const Vec3& direction) {
    if (!(beam.exponent > 0)) return 1;
    const double cosine = Vec3(beam.axis).dot(direction);
    return cosine > 0 ? std::pow(cosine, beam.exponent) : 0;
}

} // namespace sdk1
} // namespace trundle
