// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Electric power of a robot, for devices. Since 1.8.

#include <algorithm>
#include <cstddef>

#include <trundle/abi.h>

namespace trundle {
inline namespace sdk1 {

/// The battery of the robot as its devices see it in this tick.
struct Supply {
    bool present = false; ///< false: the robot has none, and its devices have all the power that they need
    double voltage = 0;   ///< V; 0: it is empty
    double nominal = 0;   ///< V, for which drivers are set up

    /// Whether devices can work.
    [[nodiscard]] bool powered() const { return !present || voltage > 0; }
    /// The voltage (V) of a driver that is to give `wanted` and at most `most`: it switches the battery on for the share wanted / nominal of
    /// the time, so its voltage sags with that of the battery.
    [[nodiscard]] double driven(double wanted, double most) const {
        if (!present) return wanted;
        const double share = std::clamp(nominal > 0 ? wanted / nominal : 0, -1.0, 1.0);
        return std::clamp(share * voltage, -most, most);
    }
    /// The highest voltage (V) of such a driver.
    [[nodiscard]] double highest(double most) const { return present ? std::min(most, voltage) : most; }
};

namespace detail {

/// nullptr: the program is older.
inline const TrundleServicesSupply* supplyOf(const TrundleServices& services) {
    return services.size >= offsetof(TrundleServices, supply) + sizeof services.supply ? services.supply : nullptr;
}

/// nullptr: the program is older and has no chargers.
inline const TrundleServicesSupply* chargingOf(const TrundleServices& services) {
    const TrundleServicesSupply* table = supplyOf(services);
    return table && table->size >= offsetof(TrundleServicesSupply, taken) + sizeof table->taken ? table : nullptr;
}

inline Supply supply(const TrundleServices& services) {
    Supply now;
    const TrundleServicesSupply* table = supplyOf(services);
    now.present = table && table->voltage(services.context, &now.voltage, &now.nominal) == 0;
    return now;
}

} // namespace detail
} // namespace sdk1
} // namespace trundle
