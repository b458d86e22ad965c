#pragma once
// The devices that offer power to what touches their geoms, such as charging stations.

#include <cstdint>
#include <vector>

#include <trundle/abi_supply.h>

namespace trundle {

class WorldChargers {
public:
    /// What touches the geom can take power from the device from now on; with 0 A it cannot. A geom belongs to the last device that offered.
    void offer(std::uint32_t device, std::uint32_t geom, double volts, double amperes);
    /// Shared equally by those that took power in the tick before.
    [[nodiscard]] TrundleOffer offered(std::uint32_t geom) const;
    /// By a robot's battery, in this tick. At most what is offered.
    void take(std::uint32_t geom, double volts, double amperes);
    /// From a device in the tick before.
    [[nodiscard]] TrundleTaken taken(std::uint32_t device) const;
    /// Before the devices of a tick sense.
    void beginTick();

private:
    struct Charger {
        std::uint32_t device = 0;
        std::vector<std::uint32_t> geoms;
        TrundleOffer offer{};
        TrundleTaken before{}, now{};
    };
    [[nodiscard]] const Charger* of(std::uint32_t geom) const;
    std::vector<Charger> m_chargers;
};

} // namespace trundle
