// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Devices that hold other bodies. Since 1.11.

#include <cstddef>

#include <trundle/abi.h>
#include <trundle/abi_latch.h>
#include <trundle/geometry.h>
#include <trundle/joints.h>

namespace trundle {
inline namespace sdk1 {

namespace detail {

/// nullptr: the program is older.
inline const TrundleServicesLatch* latchOf(const TrundleServices& services) {
    return services.size >= offsetof(TrundleServices, latch) + sizeof services.latch ? services.latch : nullptr;
}

inline bool latchHold(const TrundleServices& services, std::uint32_t body, std::uint32_t geom) {
    const TrundleServicesLatch* table = latchOf(services);
    return table && table->hold(services.context, body, geom) == 0;
}

inline void latchRelease(const TrundleServices& services) {
    if (const TrundleServicesLatch* table = latchOf(services)) table->release(services.context);
}

inline bool latchHeld(const TrundleServices& services, Wrench& out) {
    const TrundleServicesLatch* table = latchOf(services);
    return table && table->held(services.context, out.force.data(), out.torque.data()) == 0;
}

} // namespace detail
} // namespace sdk1
} // namespace trundle
