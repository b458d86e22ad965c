#include "world/ode/solver/random_order.h"

#include <ode/ode.h>

#include "base/rng.h"

namespace {

constexpr int kFirst = 2; // a shuffle asks for a number below 2, below 3 and so on

struct Stream {
    std::uint64_t seed = 0, index = 0;
};
thread_local Stream t_stream;

} // namespace

/// Takes the place of the function of ODE: at least 0, less than `n`.
extern "C" __attribute__((visibility("default"))) int dRandInt(int n) {
    if (n == kFirst) t_stream.index = 0;
    return static_cast<int>(trundle::toUnit(trundle::randomBits(t_stream.seed, 0, 0, t_stream.index++)) * n);
}

namespace trundle {

void seedOrders(std::uint64_t seed) { t_stream = {seed, 0}; }

} // namespace trundle
