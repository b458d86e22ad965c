#include "world/device_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "world/engine.h"
#include "world/rays/ray_targets.h"
#include "world/world_device.h"
#include "world/world_objects.h"

namespace trundle {

namespace {

constexpr std::uint64_t kMaxRays = 10'000'000; // of one call
constexpr double kMaxBearing = 1e4;            // rad: about 1600 turns

struct RayCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }

    static std::uint32_t without(const ServiceContext& call, std::int32_t own) {
        return own ? kNoActor : call.host->objects.robots()[call.device->robot].handles.actor.index;
    }

    static std::int32_t refuse(const ServiceContext& call, const char* what) {
        call.device->note(std::string(what) + " was asked for a value that is not valid");
        return -1;
    }

    static bool isRange(double range) { return range > 0 && std::isfinite(range); }

    static bool isValid(const TrundleFan& f) {
        if (f.count == 0 || f.layers == 0 || !f.elevations || std::uint64_t{f.count} * f.layers > kMaxRays) return false;
        const double last = f.firstBearing + f.bearingStep * f.count;
        const bool turns = std::abs(f.firstBearing) <= kMaxBearing && std::abs(last) <= kMaxBearing;
        const bool rises = std::all_of(f.elevations, f.elevations + f.layers,
                                       [](double e) { return std::abs(e) <= std::numbers::pi / 2 + 1e-12; });
        const double square = Eigen::Map<const Eigen::Vector4d>(f.quaternion).squaredNorm();
        return Vec3(f.position).allFinite() && isRange(square) && square > 1e-12 && isRange(f.range) && turns && rises;
    }

    static bool isValid(const TrundleRay& r) {
        const double square = Vec3(r.direction).squaredNorm();
        return Vec3(r.origin).allFinite() && isRange(square) && square > 1e-12 && isRange(r.range);
    }

    static std::int32_t castFan(void* context, const TrundleFan* fan, double* distances, std::uint32_t* geoms, double* normals) {
        const ServiceContext& call = caller(context);
        if (!fan || !distances || !isValid(*fan)) return refuse(call, "castFan");
        const double* q = fan->quaternion;
        const RayFan cast{Vec3(fan->position),
                          Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(),
                          fan->range,
                          fan->firstBearing,
                          fan->bearingStep,
                          fan->count,
                          {fan->elevations, fan->layers}};
        call.host->engine.rays().castFan(cast, without(call, fan->own), {distances, geoms, normals});
        return 0;
    }

    static std::int32_t castRays(void* context, const TrundleRay* rays, std::uint32_t count, std::int32_t own, double* distances,
                                 std::uint32_t* geoms, double* normals) {
        const ServiceContext& call = caller(context);
        if (count == 0) return 0;
        const bool valid = rays && distances && count <= kMaxRays &&
                           std::all_of(rays, rays + count, [](const TrundleRay& r) { return isValid(r); });
        if (!valid) return refuse(call, "castRays");
        std::array<SingleRay, 32> part; // on the stack: a tick takes nothing from the heap
        for (std::uint32_t begin = 0; begin < count; begin += part.size()) {
            const std::size_t size = std::min<std::size_t>(part.size(), count - begin);
            for (std::size_t i = 0; i < size; ++i) {
                const TrundleRay& r = rays[begin + i];
                part[i] = {Vec3(r.origin), Vec3(r.direction).normalized(), r.range};
            }
            call.host->engine.rays().castRays(
                std::span(part).first(size), without(call, own),
                {distances + begin, geoms ? geoms + begin : nullptr, normals ? normals + 3 * std::size_t{begin} : nullptr});
        }
        return 0;
    }

    static std::int32_t geomInfo(void* context, std::uint32_t geom, TrundleGeomInfo* info) {
        const DeviceHost& host = *caller(context).host;
        if (!info || info->size < offsetof(TrundleGeomInfo, object) || !host.objects.isGeom(geom)) return -1;
        const std::uint32_t index = host.objects.geomMaterial(geom);
        const MaterialSpec fallback,
            &material = index < host.experiment.materials.size() ? host.experiment.materials[index] : fallback;
        info->path = host.objects.geomPath(geom).c_str();
        info->material = index < host.experiment.materials.size() ? material.name.c_str() : "";
        std::copy(material.colour.begin(), material.colour.end(), info->colour);
        info->reflectance = host.objects.reflectance(index);
        info->opacity = material.opacity;
        info->shininess = material.shininess;
        if (info->size >= sizeof(TrundleGeomInfo)) info->object = host.objects.objectNumber(geom);
        return 0;
    }
};

} // namespace

const TrundleServicesRays* servicesRays() {
    static const TrundleServicesRays table{sizeof(TrundleServicesRays), 0, RayCalls::castFan, RayCalls::castRays,
                                           RayCalls::geomInfo};
    return &table;
}

} // namespace trundle
