#include "world/device_joints.h"

#include <cmath>

#include "world/engine.h"
#include "world/world_device.h"
#include "world/world_objects.h"

namespace trundle {

namespace {

/// A friction that a drive may have, however large.
bool isFriction(double value) { return value >= 0 && std::isfinite(value); }

struct JointCalls {
    static const ServiceContext& caller(void* context) { return *static_cast<const ServiceContext*>(context); }

    static void drive(void* context, std::uint32_t joint, const TrundleJointDrive* d) {
        const ServiceContext& call = caller(context);
        if (!call.acts() || !d || d->size < sizeof(TrundleJointDrive)) return;
        if (!call.host->objects.jointHasPosition(joint))
            return call.device->note("driveJoint was asked for something that is not there");
        const bool finite = std::isfinite(d->rate) && isFriction(d->softness) && d->limit >= 0 && isFriction(d->damping) &&
                            isFriction(d->dryFriction) && isFriction(d->viscousFriction);
        if (!finite)
            return call.device->note(
                "driveJoint was asked for a value that is not finite, or for a softness, limit, damping or friction below 0");
        call.host->engine.setMotor({joint}, {d->rate, d->softness, d->limit, d->damping, d->dryFriction, d->viscousFriction});
    }
    static double frictionEffort(void* context, std::uint32_t joint) {
        return caller(context).host->engine.jointReading({joint}).friction;
    }
    static std::int32_t wrench(void* context, std::uint32_t joint, double force[3], double torque[3]) {
        const DeviceHost& w = *caller(context).host;
        if (!w.objects.jointLocation(joint) || !force || !torque) return -1;
        const JointWrench found = w.engine.jointWrench({joint});
        for (int k = 0; k < 3; ++k) {
            force[k] = found.force[k];
            torque[k] = found.torque[k];
        }
        return 0;
    }
};

} // namespace

const TrundleServicesJoints* servicesJoints() {
    static const TrundleServicesJoints table{sizeof(TrundleServicesJoints), 0, JointCalls::drive, JointCalls::frictionEffort,
                                             JointCalls::wrench};
    return &table;
}

} // namespace trundle
