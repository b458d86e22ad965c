#pragma once
// Received power of one transmitter on a grid over the floor. A pure function of its request, so it can run on any thread.

#include <functional>
#include <optional>

#include "editor/viewport/radio/radio_links.h"
#include "scene/overlay.h"

namespace trundle {

/// A rectangle of ground, m.
struct Ground {
    double x = 0, y = 0, width = 0, depth = 0; ///< lower left corner and size
    bool operator==(const Ground&) const = default;
    [[nodiscard]] bool empty() const { return !(width > 0 && depth > 0); }
};

/// The ground area of an experiment with a margin, rounded to whole steps, so that it does not change while robots move inside
/// it. The result contains `before`.
[[nodiscard]] Ground groundAround(const Bounds& bounds, const Ground& before = {});

/// The hypothetical receiver at each grid point: isotropic (0 dBi).
struct ImaginedReceiver {
    double height = 0.1;      ///< m above z = 0
    double sensitivity = -94; ///< dBm
    bool operator==(const ImaginedReceiver&) const = default;
};
/// A typical receiver on the transmitter's channel: the medians of the other radios' heights and sensitivities.
[[nodiscard]] ImaginedReceiver typicalReceiver(const RadioPoses& places, std::size_t transmitter);

struct CoverageRequest {
    RadioPoses places;
    std::size_t transmitter = 0; ///< node index; transmits at full power
    ImaginedReceiver receiver;
    Ground ground;
    std::uint32_t cells = 192; ///< along the longer side
};

struct Coverage {
    std::string transmitter; ///< its path
    double sent = 0;         ///< dBm
    Ground ground;
    ImaginedReceiver receiver;
    std::uint32_t columns = 0, rows = 0;
    std::vector<float> power;                          ///< dBm at the centre of each cell; rows along y
    [[nodiscard]] double at(double x, double y) const; ///< value of the cell there; NaN outside
};

/// `resume` is called before each row; nullopt as soon as it returns false.
[[nodiscard]] std::optional<Coverage> coverageOf(const CoverageRequest& request, const std::function<bool()>& resume);

/// Power range of the colours (dBm): multiples of five around the sensitivity.
struct PowerScale {
    double low = -94, high = -40;
};
[[nodiscard]] PowerScale scaleOf(const Coverage& coverage);
/// Colour in steps of half a dB; grey below the sensitivity.
[[nodiscard]] std::array<std::uint8_t, 4> powerColour(double power, const PowerScale& scale, double sensitivity);
[[nodiscard]] std::shared_ptr<const FloorPicture> pictureOf(const Coverage& coverage, const PowerScale& scale);

/// A coverage with its colours, ready to draw.
struct CoverageMap {
    Coverage coverage;
    PowerScale scale;
    std::shared_ptr<const FloorPicture> picture;
};

} // namespace trundle
