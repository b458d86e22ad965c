#include "world/device_services.h"

#include <cmath>

#include "base/platform/module_text.h"
#include "base/rng.h"
#include "world/device_joints.h"
#include "world/device_latch.h"
#include "world/device_light.h"
#include "world/device_radio.h"
#include "world/device_rays.h"
#include "world/device_supply.h"
#include "world/device_texts.h"
#include "world/rays/ray_targets.h"
#include "world/world_objects.h"

namespace trundle {

namespace {

/// Handles passed by devices are engine indices; invalid ones are rejected before they reach the engine.
struct ServiceCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }
    static const DeviceHost& world(void* context) { return *caller(context).host; }

    static bool mayActOn(void* context, bool known, bool finite, const char* what) {
        const ServiceContext& call = caller(context);
        if (!call.acts()) return false;
        if (!known) call.device->note(std::string(what) + " was asked for something that is not there");
        else if (!finite) call.device->note(std::string(what) + " was asked for a value that is not finite");
        return known && finite;
    }

    static void motorRow(void* context, std::uint32_t joint, double rate, double softness, double limit) {
        const DeviceHost& w = world(context);
        const bool finite =
            std::isfinite(rate) && softness >= 0 && std::isfinite(softness) && limit >= 0; // an infinite limit is allowed
        if (mayActOn(context, w.objects.jointHasPosition(joint), finite, "motorRow"))
            w.engine.setMotor({joint}, {rate, softness, limit});
    }
    static void servoRow(void* context, std::uint32_t joint, double rate, double limit, double damping) {
        const DeviceHost& w = world(context);
        const bool finite = std::isfinite(rate) && limit >= 0 && damping >= 0 && std::isfinite(damping);
        if (mayActOn(context, w.objects.jointHasPosition(joint), finite, "servoRow"))
            w.engine.setMotor({joint}, {rate, 0, limit, damping});
    }
    static void jointTorque(void* context, std::uint32_t joint, double torque) {
        const DeviceHost& w = world(context);
        if (mayActOn(context, w.objects.jointHasPosition(joint), std::isfinite(torque), "jointTorque"))
            w.engine.addJointTorque({joint}, torque);
    }
    static void bodyForce(void* context, std::uint32_t body, const double force[3], const double point[3]) {
        const DeviceHost& w = world(context);
        const Vec3 f(force), p(point);
        if (mayActOn(context, w.objects.isBody(body), f.allFinite() && p.allFinite(), "bodyForce") && !w.objects.isFixed(body))
            w.engine.addForce({body}, f, p);
    }
    static void surfaceVelocity(void* context, std::uint32_t geom, const double velocity[3]) {
        const DeviceHost& w = world(context);
        const Vec3 v(velocity);
        if (mayActOn(context, w.objects.isGeom(geom), v.allFinite(), "surfaceVelocity") &&
            caller(context).mayShare("a moving surface"))
            w.engine.setSurfaceVelocity({geom}, v);
    }

    static double jointPosition(void* context, std::uint32_t joint) {
        return world(context).engine.jointReading({joint}).position;
    }
    static double jointRate(void* context, std::uint32_t joint) { return world(context).engine.jointReading({joint}).rate; }
    static double jointMotorEffort(void* context, std::uint32_t joint) {
        return world(context).engine.jointReading({joint}).motor;
    }
    static void jointAnchor(void* context, std::uint32_t joint, double anchor[3], double axis[3]) {
        const DeviceHost& w = world(context);
        const JointLocation* place = w.objects.jointLocation(joint);
        if (!place || !anchor || !axis) return;
        static const BodyState kWorld;
        const BodyState& parent = place->carried ? w.engine.state({place->parent}) : kWorld;
        Eigen::Map<Vec3>{anchor} = parent.position + parent.rotation * place->anchor;
        Eigen::Map<Vec3>{axis} = parent.rotation * place->axis;
    }
    static void bodyState(void* context, std::uint32_t body, TrundleBodyState* out) {
        const DeviceHost& w = world(context);
        if (!out) return;
        *out = {{0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        if (!w.objects.isBody(body)) return;
        const BodyState& s = w.engine.state({body});
        for (int k = 0; k < 3; ++k) {
            out->position[k] = s.position[k];
            out->linear[k] = s.linear[k];
            out->angular[k] = s.angular[k];
        }
        out->quaternion[0] = s.rotation.w();
        out->quaternion[1] = s.rotation.x();
        out->quaternion[2] = s.rotation.y();
        out->quaternion[3] = s.rotation.z();
    }

    static std::uint32_t contacts(void* context, std::uint32_t geom, TrundleContact* out, std::uint32_t capacity) {
        const DeviceHost& w = world(context);
        if (!w.objects.isGeom(geom) || caller(context).phase->ticks == 0) return 0;
        const auto list = w.engine.contactsOf({geom});
        for (std::uint32_t i = 0; i < list.size() && i < capacity && out; ++i) {
            const EngineContact c = w.engine.contact(list[i]);
            const double side = c.first == geom ? 1 : -1;
            for (int k = 0; k < 3; ++k) {
                out[i].position[k] = c.position[k];
                out[i].normal[k] = side * c.normal[k];
            }
            out[i].depth = c.depth;
            out[i].force = c.force;
            out[i].other = c.first == geom ? c.second : c.first;
            out[i].reserved = 0;
        }
        return static_cast<std::uint32_t>(list.size());
    }

    static std::int32_t ray(void* context, const double origin[3], const double direction[3], double range, std::int32_t own,
                            TrundleHit* hit) {
        const DeviceHost& w = world(context);
        const std::uint32_t without = own ? kNoActor : w.objects.robots()[caller(context).robot].handles.actor.index;
        const auto found = w.engine.rays().ray({Vec3(origin), Vec3(direction), range}, without);
        if (!found) return 0;
        if (hit) *hit = {found->distance, {found->normal.x(), found->normal.y(), found->normal.z()}, found->geom, 0};
        return 1;
    }

    static std::uint64_t random(void* context, std::uint64_t index) {
        const ServiceContext& call = caller(context);
        return randomBits(call.host->experiment.settings.seed, call.device->pathHash, call.phase->ticks, index);
    }

    static void print(void* context, std::int32_t severity, const char* text) {
        const ServiceContext& call = caller(context);
        if (!call.isCalled() || !text) return;
        if (!call.phase->keepsTexts) return call.host->texts.print(call.device->path, severity, moduleMessage(text).c_str());
        call.device->texts.emplace_back(severity, moduleMessage(text));
        call.phase->printed.store(true, std::memory_order_relaxed);
    }
};

} // namespace

void fillServices(TrundleServices& services, double tick) {
    services = {sizeof(TrundleServices),
                0,
                nullptr,
                tick,
                0,
                ServiceCalls::motorRow,
                ServiceCalls::jointTorque,
                ServiceCalls::bodyForce,
                ServiceCalls::surfaceVelocity,
                ServiceCalls::jointPosition,
                ServiceCalls::jointRate,
                ServiceCalls::jointMotorEffort,
                ServiceCalls::bodyState,
                ServiceCalls::contacts,
                ServiceCalls::ray,
                ServiceCalls::random,
                ServiceCalls::jointAnchor,
                ServiceCalls::print,
                servicesRadio(),
                ServiceCalls::servoRow,
                servicesRays(),
                servicesLight(),
                servicesSupply(),
                servicesJoints(),
                servicesLatch()};
}

} // namespace trundle
