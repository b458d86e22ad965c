// Implementation of the functions that devices call during a tick. The context is the world, which stores the device being
// called.
#include <cmath>

#include "base/platform/module_text.h"
#include "base/rng.h"
#include "world/built_world.h"

namespace trundle {

/// Handles passed by devices are engine indices; invalid ones are rejected before they reach the engine.
struct ServiceCalls {
    static BuiltWorld& world(void* context) { return *static_cast<BuiltWorld*>(context); }

    static bool mayActOn(BuiltWorld& w, bool known, bool finite, const char* what) {
        if (!w.m_inAct || !w.m_current) return false;
        if (!known) w.m_current->note(std::string(what) + " was asked for something that is not there");
        else if (!finite) w.m_current->note(std::string(what) + " was asked for a value that is not finite");
        return known && finite;
    }
    static bool isJoint(const BuiltWorld& w, std::uint32_t joint) {
        return joint < w.m_jointTurns.size() && w.m_jointTurns[joint];
    }
    static bool isBody(const BuiltWorld& w, std::uint32_t body) { return body < w.m_bodyPaths.size(); }
    static bool isGeom(const BuiltWorld& w, std::uint32_t geom) { return geom < w.m_geomPaths.size(); }

    static void motorRow(void* context, std::uint32_t joint, double rate, double softness, double limit) {
        BuiltWorld& w = world(context);
        const bool finite =
            std::isfinite(rate) && softness >= 0 && std::isfinite(softness) && limit >= 0; // an infinite limit is allowed
        if (mayActOn(w, isJoint(w, joint), finite, "motorRow")) w.m_engine->setMotor({joint}, {rate, softness, limit});
    }
    static void servoRow(void* context, std::uint32_t joint, double rate, double limit, double damping) {
        BuiltWorld& w = world(context);
        const bool finite = std::isfinite(rate) && limit >= 0 && damping >= 0 && std::isfinite(damping);
        if (mayActOn(w, isJoint(w, joint), finite, "servoRow")) w.m_engine->setMotor({joint}, {rate, 0, limit, damping});
    }
    static void jointTorque(void* context, std::uint32_t joint, double torque) {
        BuiltWorld& w = world(context);
        if (mayActOn(w, isJoint(w, joint), std::isfinite(torque), "jointTorque")) w.m_engine->addJointTorque({joint}, torque);
    }
    static void bodyForce(void* context, std::uint32_t body, const double force[3], const double point[3]) {
        BuiltWorld& w = world(context);
        const Vec3 f(force), p(point);
        if (mayActOn(w, isBody(w, body), f.allFinite() && p.allFinite(), "bodyForce")) w.m_engine->addForce({body}, f, p);
    }
    static void surfaceVelocity(void* context, std::uint32_t geom, const double velocity[3]) {
        BuiltWorld& w = world(context);
        const Vec3 v(velocity);
        if (mayActOn(w, isGeom(w, geom), v.allFinite(), "surfaceVelocity")) w.m_engine->setSurfaceVelocity({geom}, v);
    }

    static double jointPosition(void* context, std::uint32_t joint) {
        const BuiltWorld& w = world(context);
        return isJoint(w, joint) ? w.m_engine->jointPosition({joint}) : 0;
    }
    static double jointRate(void* context, std::uint32_t joint) {
        const BuiltWorld& w = world(context);
        return isJoint(w, joint) ? w.m_engine->jointRate({joint}) : 0;
    }
    static double jointMotorEffort(void* context, std::uint32_t joint) {
        const BuiltWorld& w = world(context);
        return isJoint(w, joint) ? w.m_engine->jointMotorEffort({joint}) : 0;
    }
    static void jointAnchor(void* context, std::uint32_t joint, double anchor[3], double axis[3]) {
        const BuiltWorld& w = world(context);
        if (joint >= w.m_jointLocations.size() || !anchor || !axis) return;
        const JointLocation& place = w.m_jointLocations[joint];
        Pose parent;
        if (place.carried) {
            const BodyState& s = w.m_engine->state({place.parent});
            parent = {s.position, s.rotation};
        }
        const Vec3 at = parent * place.anchor, along = parent.rotation * place.axis;
        for (int k = 0; k < 3; ++k) {
            anchor[k] = at[k];
            axis[k] = along[k];
        }
    }
    static void bodyState(void* context, std::uint32_t body, TrundleBodyState* out) {
        const BuiltWorld& w = world(context);
        if (!out) return;
        *out = {{0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        if (!isBody(w, body)) return;
        const BodyState& s = w.m_engine->state({body});
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
        const BuiltWorld& w = world(context);
        if (!isGeom(w, geom) || w.m_ticks == 0) return 0;
        const auto list = w.m_engine->contactsOf({geom});
        for (std::uint32_t i = 0; i < list.size() && i < capacity && out; ++i) {
            const EngineContact c = w.m_engine->contact(list[i]);
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
        const BuiltWorld& w = world(context);
        ActorHandle without;
        if (!own && w.m_current) without = w.m_robots[w.m_current->robot].handles.actor;
        const auto found = w.m_engine->ray(Vec3(origin), Vec3(direction), range, without);
        if (!found) return 0;
        if (hit) *hit = {found->distance, {found->normal.x(), found->normal.y(), found->normal.z()}, found->geom.index, 0};
        return 1;
    }

    static std::uint64_t random(void* context, std::uint64_t index) {
        const BuiltWorld& w = world(context);
        return randomBits(w.m_experiment->settings.seed, w.m_current ? w.m_current->pathHash : 0, w.m_ticks, index);
    }

    static void print(void* context, std::int32_t severity, const char* text) {
        BuiltWorld& w = world(context);
        if (w.m_current && text) w.print(*w.m_current, severity, moduleMessage(text).c_str());
    }
};

void fillServices(TrundleServices& services, BuiltWorld& world, double tick) {
    services = {sizeof(TrundleServices),
                0,
                &world,
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
                ServiceCalls::servoRow};
}

} // namespace trundle
