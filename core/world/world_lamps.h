#pragma once
// The lamps that devices are, such as LEDs.

#include <cstdint>
#include <span>
#include <vector>

#include <trundle/abi_light.h>
#include <trundle/geometry.h>

namespace trundle {

class Engine;

class WorldLamps {
public:
    /// The device is a lamp from now on, at a point of a body (m, in its frame); with a light of 0 it is dark.
    void set(std::uint32_t device, std::uint32_t body, const Vec3& point, double light);
    /// How many are not dark. Writes as many of them as there is room for, where their bodies are, in the order of the devices.
    std::size_t write(std::span<TrundleLight> out, const Engine& engine) const;

private:
    struct Lamp {
        std::uint32_t device = 0, body = 0;
        Vec3 point = Vec3::Zero();
        double light = 0;
    };
    std::vector<Lamp> m_lamps; ///< by device
};

} // namespace trundle
