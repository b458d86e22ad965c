#include "base/missing_asset.h"

namespace trundle {

std::shared_ptr<const Raster> missingAssetPicture() {
    static const auto picture = [] {
        constexpr std::uint32_t side = 16;
        auto raster = std::make_shared<Raster>(Raster{side, side, {}});
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const bool light = ((i / 4) % 2 == 0) != ((i / (4 * side)) % 2 == 0);
            raster->pixels.insert(raster->pixels.end(), {std::uint8_t(light ? 255 : 30), 0, std::uint8_t(light ? 255 : 30)});
        }
        return std::shared_ptr<const Raster>(raster);
    }();
    return picture;
}

} // namespace trundle
