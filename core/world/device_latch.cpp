#include "world/device_latch.h"

#include "world/engine_links.h"
#include "world/world_device.h"
#include "world/world_objects.h"

namespace trundle {

namespace {

/// The engine knows the latch of a device by its index.
struct LatchCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }

    static std::int32_t hold(void* context, std::uint32_t body, std::uint32_t geom) {
        const ServiceContext& call = caller(context);
        const WorldObjects& objects = call.host->objects;
        if (!call.acts() || !call.mayShare("a latch") || !call.host->engine.links) return -1;
        if (!objects.isBody(body) || !objects.isGeom(geom) || objects.geom(geom).body == body) {
            call.device->note("hold was asked for something that is not there");
            return -1;
        }
        const std::uint32_t held = objects.geom(geom).body;
        call.host->engine.links->setLatch(call.device->index, {body},
                                          held == BuiltGeom::kNoBody ? BodyHandle{} : BodyHandle{held});
        return 0;
    }
    static void release(void* context) {
        const ServiceContext& call = caller(context);
        if (call.acts() && call.mayShare("a latch") && call.host->engine.links)
            call.host->engine.links->setLatch(call.device->index, {}, std::nullopt);
    }
    static std::int32_t held(void* context, double force[3], double torque[3]) {
        const ServiceContext& call = caller(context);
        const EngineLinks* links = call.host->engine.links;
        if (!force || !torque || !links || !links->latchHolds(call.device->index)) return -1;
        const JointWrench found = links->latchWrench(call.device->index);
        for (int k = 0; k < 3; ++k) {
            force[k] = found.force[k];
            torque[k] = found.torque[k];
        }
        return 0;
    }
};

} // namespace

const TrundleServicesLatch* servicesLatch() {
    static const TrundleServicesLatch table{sizeof(TrundleServicesLatch), 0, LatchCalls::hold, LatchCalls::release,
                                            LatchCalls::held};
    return &table;
}

} // namespace trundle
