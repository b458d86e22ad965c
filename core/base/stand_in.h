#pragma once
#include <memory>

#include "base/raster.h"

namespace trundle {

/// In place of a picture that is missing or broken: what nobody takes for meant, magenta and black.
[[nodiscard]] std::shared_ptr<const Raster> standInPicture();

} // namespace trundle
