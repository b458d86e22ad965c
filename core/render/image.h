#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// RGB, 8 bits per channel as displayed; rows from the top, no padding.
struct Image {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels; ///< width * height * 3

    [[nodiscard]] const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const {
        return pixels.data() + (std::size_t(y) * width + x) * 3;
    }
    bool operator==(const Image&) const = default;
};

/// Deterministic: equal images give equal bytes.
[[nodiscard]] Result<std::string> pngBytes(const Image& image);
[[nodiscard]] Result<std::string> jpegBytes(const Image& image, int quality = 92);
/// PNG or JPEG, depending on the extension (.png, .jpg, .jpeg); other extensions are an error.
[[nodiscard]] Result<std::string> imageBytes(const Image& image, const std::string& name);
/// Writes the same bytes to a file, atomically.
[[nodiscard]] Status saveImage(const Image& image, const std::string& path);

} // namespace trundle
