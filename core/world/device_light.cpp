#include "world/device_light.h"

#include <algorithm>
#include <cmath>

#include "world/engine.h"
#include "world/reflectance.h"
#include "world/world_device.h"
#include "world/world_lamps.h"
#include "world/world_objects.h"

namespace trundle {

namespace {

constexpr double kMaxExponent = 1e6; // of a beam

/// Of the top of a mark.
std::int32_t reflectanceOfMark(const DeviceHost& host, const FloorMarks::Mark& mark, const Vec3& point, double* share) {
    if (mark.geom->material >= host.experiment.materials.size()) return -1;
    const auto [low, size] = pictureBox(*mark.geom);
    *share = reflectanceAt(host.experiment.materials[mark.geom->material], mark.geom->shape, mark.X_WG.inverse() * point,
                           Vec3::UnitZ(), low, size);
    return 0;
}

struct LightCalls {
    static std::int32_t reflectance(void* context, std::uint32_t index, const double point[3], const double normal[3],
                                    double* share) {
        const DeviceHost& host = *static_cast<const ServiceContext*>(context)->host;
        if (!point || !normal || !share || !host.objects.isGeom(index) || !host.objects.geom(index).spec) return -1;
        const BuiltGeom& geom = host.objects.geom(index);
        if (geom.body == BuiltGeom::kNoBody)
            if (const FloorMarks::Mark* mark = host.objects.marks().at(Vec3(point)))
                return reflectanceOfMark(host, *mark, Vec3(point), share);
        if (geom.spec->material >= host.experiment.materials.size()) return -1;
        const MaterialSpec& material = host.experiment.materials[geom.spec->material];
        if (!material.picture) {
            *share = host.objects.reflectance(geom.spec->material);
            return 0;
        }
        Pose pose = geom.pose;
        if (geom.body != BuiltGeom::kNoBody) {
            const BodyState& body = host.engine.state({geom.body});
            pose = Pose{body.position, body.rotation} * geom.pose;
        }
        const Vec3 at = pose.inverse() * Vec3(point), outwards = pose.rotation.conjugate() * Vec3(normal);
        *share = reflectanceAt(material, geom.spec->shape, at, outwards, geom.low, geom.size);
        return 0;
    }

    static std::uint32_t lights(void* context, TrundleLight* out, std::uint32_t capacity) {
        const DeviceHost& host = *static_cast<const ServiceContext*>(context)->host;
        const std::vector<TrundleLight>& fixed = host.objects.lights();
        const std::size_t room = out ? capacity : 0, first = std::min(fixed.size(), room);
        std::copy_n(fixed.begin(), first, out);
        return static_cast<std::uint32_t>(fixed.size() + host.lamps.write({out + first, room - first}, host.engine));
    }

    static void emit(void* context, std::uint32_t body, const double point[3], double light) {
        emitBeam(context, body, point, light, nullptr);
    }

    static void emitBeam(void* context, std::uint32_t body, const double point[3], double light, const TrundleBeam* beam) {
        const ServiceContext& call = *static_cast<const ServiceContext*>(context);
        if (!call.acts() || !call.mayShare("a lamp") || !point || !call.host->objects.isBody(body)) return;
        LampMount mount{body, Vec3(point)};
        if (beam) mount.beam = *beam;
        if (mount.point.allFinite() && std::isfinite(light) && isBeam(mount.beam))
            call.host->lamps.set(*call.device, mount, light);
    }

    static bool isBeam(const TrundleBeam& beam) {
        return std::abs(Vec3(beam.axis).norm() - 1) < 1e-6 && beam.exponent >= 0 && beam.exponent <= kMaxExponent &&
               beam.radius >= 0 && std::isfinite(beam.radius);
    }

    static std::uint32_t beams(void* context, TrundleBeam* out, std::uint32_t capacity) {
        const DeviceHost& host = *static_cast<const ServiceContext*>(context)->host;
        const std::size_t fixed = host.objects.lights().size(), room = out ? capacity : 0, first = std::min(fixed, room);
        std::fill_n(out, first, TrundleBeam{{1, 0, 0}, 0, 0});
        return static_cast<std::uint32_t>(fixed + host.lamps.writeBeams({out + first, room - first}, host.engine));
    }
};

} // namespace

const TrundleServicesLight* servicesLight() {
    static const TrundleServicesLight table{sizeof(TrundleServicesLight),
                                            0,
                                            LightCalls::reflectance,
                                            LightCalls::lights,
                                            LightCalls::emit,
                                            LightCalls::emitBeam,
                                            LightCalls::beams};
    return &table;
}

} // namespace trundle
