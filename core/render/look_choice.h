#pragma once
#include <cstdint>
#include <string_view>

namespace trundle {

/// Quality of rendered images. Fast is made for software rendering; Rich for graphics cards: sun shadows also on objects, ambient
/// occlusion and smooth edges.
enum class LookChoice : std::uint8_t { Automatic, Fast, Rich };

/// True if a renderer, by its GL_RENDERER string, computes pixels on the CPU. An empty name counts as software.
[[nodiscard]] bool isSoftwareRenderer(std::string_view renderer);

/// Automatic means rich on a graphics card.
[[nodiscard]] bool isRich(LookChoice choice, std::string_view renderer);

} // namespace trundle
