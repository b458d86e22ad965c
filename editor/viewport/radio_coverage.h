#pragma once
// What a receiver on the floor would get of one transmitter, place by place. A value from values: made on any thread.

#include <functional>
#include <optional>

#include "editor/viewport/radio_links.h"
#include "scene/overlay.h"

namespace trundle {

/// A rectangle of ground, m.
struct Ground {
    double x = 0, y = 0, width = 0, depth = 0; ///< its lower left corner and its size
    bool operator==(const Ground&) const = default;
    [[nodiscard]] bool empty() const { return !(width > 0 && depth > 0); }
};

/// The ground of an experiment with room around it, in whole steps: it stays what it is while robots move about in it. `before` is
/// kept in it.
[[nodiscard]] Ground groundAround(const Bounds& bounds, const Ground& before = {});

/// The receiver that is imagined at each place: it hears all directions alike (0 dBi).
struct ImaginedReceiver {
    double height = 0.1;      ///< m, over z = 0
    double sensitivity = -94; ///< dBm
    bool operator==(const ImaginedReceiver&) const = default;
};
/// As the typical other radio on the transmitter's channel: the median of their heights and of their sensitivities.
[[nodiscard]] ImaginedReceiver typicalReceiver(const RadioPlaces& places, std::size_t transmitter);

struct CoverageWish {
    RadioPlaces places;
    std::size_t transmitter = 0; ///< node; it sends with full power
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
    std::vector<float> power;                          ///< dBm in the middle of each cell; rows along y
    [[nodiscard]] double at(double x, double y) const; ///< of the cell there; NaN outside
};

/// Nothing where `goOn`, asked before each row, says no.
[[nodiscard]] std::optional<Coverage> coverageOf(const CoverageWish& wish, const std::function<bool()>& goOn);

/// dBm between which the colours run: whole fives about what is heard.
struct PowerScale {
    double low = -94, high = -40;
};
[[nodiscard]] PowerScale scaleOf(const Coverage& coverage);
/// In steps of half a dB; what is not heard is grey.
[[nodiscard]] std::array<std::uint8_t, 4> powerColour(double power, const PowerScale& scale, double sensitivity);
[[nodiscard]] std::shared_ptr<const FloorPicture> pictureOf(const Coverage& coverage, const PowerScale& scale);

/// Ready to be shown.
struct CoverageMap {
    Coverage coverage;
    PowerScale scale;
    std::shared_ptr<const FloorPicture> picture;
};

} // namespace trundle
