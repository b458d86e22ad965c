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
    /// To one more battery, in this tick. Shared equally by all that asked in the tick before, but for what some of them did not want; never
    /// more than others have left in this tick. One that is offered nothing has its share from the next tick on.
    [[nodiscard]] TrundleOffer offered(std::uint32_t geom);
    /// By that battery. At most what is offered.
    void take(std::uint32_t geom, double volts, double amperes);
    /// From a device in the tick before.
    [[nodiscard]] TrundleTaken taken(std::uint32_t device) const;
    /// After all offers of a tick, before the batteries take.
    void beginTick();

private:
    struct Charger {
        std::uint32_t device = 0;
        std::vector<std::uint32_t> geoms;
        TrundleOffer offer{};
        TrundleTaken before{}, now{};
        double share = 0;              ///< A, that each can take in this tick
        std::vector<double> satisfied; ///< A, taken in this tick by those that could have had more
        std::uint32_t limited = 0;     ///< in this tick, that could not

        [[nodiscard]] double left() const;
        [[nodiscard]] double nextShare();
    };
    [[nodiscard]] Charger* of(std::uint32_t geom);
    std::vector<Charger> m_chargers;
};

} // namespace trundle
