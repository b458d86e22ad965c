// Compiled for AVX2 where the compiler's target has it (CMakeLists.txt), without fused multiply-add.
#include "world/wheeled/vehicle_block.h"

#ifdef __AVX2__
#define TRUNDLE_LANES 4
#include "world/wheeled/vehicle_motion.h"

namespace trundle {

const VehicleKernel* avx2VehicleKernel() {
    static const VehicleKernel kernel{"AVX2", TRUNDLE_LANES, prepareBlock, sweepBlock, keepBlock, settleBlock, finishBlock};
    return __builtin_cpu_supports("avx2") ? &kernel : nullptr;
}

} // namespace trundle
#else
namespace trundle {
const VehicleKernel* avx2VehicleKernel() { return nullptr; }
} // namespace trundle
#endif
