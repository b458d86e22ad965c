#pragma once
// The lamps that devices are, such as LEDs.

#include <cstdint>
#include <span>
#include <vector>

#include <trundle/abi_light.h>
#include <trundle/geometry.h>

namespace trundle {

class Engine;
struct WorldDevice;

/// Where a lamp is on a body, and how it shines; axis and point are in the frame of the body, m.
struct LampMount {
    std::uint32_t body = 0;
    Vec3 point = Vec3::Zero();
    TrundleBeam beam{{1, 0, 0}, 0, 0};
};

class WorldLamps {
public:
    /// The device is a lamp from now on; with a light of 0 it is dark.
    void set(const WorldDevice& device, const LampMount& mount, double light);
    // Both return how many are not dark, and write as many of them as there is room for, where their bodies are. Their order depends on
    // the paths of the devices alone, so that sums over them have the same bits for any order of blocks in the text.
    std::size_t write(std::span<TrundleLight> out, const Engine& engine) const;
    std::size_t writeBeams(std::span<TrundleBeam> out, const Engine& engine) const;

private:
    struct Lamp {
        std::uint64_t pathHash = 0;
        std::uint32_t device = 0;
        LampMount mount;
        double light = 0;
    };
    std::vector<Lamp> m_lamps; ///< by pathHash, device
};

} // namespace trundle
