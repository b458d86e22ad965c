#include "editor/viewport/radio/radio_colours.h"

#include <algorithm>
#include <cmath>

namespace trundle {

Rgb heatColour(double share) {
    static constexpr std::array<std::array<double, 3>, 6> kStops{
        {{38, 22, 92}, {44, 78, 158}, {28, 134, 148}, {66, 178, 104}, {176, 208, 62}, {252, 236, 92}}};
    const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
    const auto i = std::min(std::size_t(at), kStops.size() - 2);
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = std::uint8_t(std::lround(kStops[i][c] + (at - double(i)) * (kStops[i + 1][c] - kStops[i][c])));
    return colour;
}

Rgb gainColour(double gain) { return heatColour((gain - kLobeFloor) / (kLobeTop - kLobeFloor)); }

Rgb marginColour(double margin) {
    if (margin < kSlimMargin) return {222, 56, 48};
    return margin < kSafeMargin ? Rgb{240, 164, 20} : Rgb{52, 178, 84};
}

} // namespace trundle
