#pragma once
#include <memory>

#include "base/raster.h"

namespace trundle {

/// The fallback for a missing or broken picture: a conspicuous magenta and black pattern.
[[nodiscard]] std::shared_ptr<const Raster> missingAssetPicture();

} // namespace trundle
