// For every processor that the program runs on.
#define TRUNDLE_LANES 2
#include "world/wheeled/vehicle_motion.h"

namespace trundle {

const VehicleKernel& baselineVehicleKernel() {
    static const VehicleKernel kernel{"baseline", TRUNDLE_LANES, prepareBlock, sweepBlock, keepBlock, settleBlock, finishBlock};
    return kernel;
}

const VehicleKernel& vehicleKernel() {
    const VehicleKernel* fast = avx2VehicleKernel();
    return fast ? *fast : baselineVehicleKernel();
}

} // namespace trundle
