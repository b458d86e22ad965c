#pragma once
#include <cstdint>

namespace trundle {

class ToolView;
struct PictureRequest;

/// The request for the image of a view. `fine`: refined, while nothing changes. `software`: no graphics card draws it.
[[nodiscard]] PictureRequest pictureRequest(const ToolView& view, bool fine, bool software);

/// The request for another image size, without marks; the image contains everything that the view shows.
[[nodiscard]] PictureRequest stillRequest(const ToolView& view, std::uint32_t width, std::uint32_t height);

} // namespace trundle
