#pragma once
#include <cstdint>
#include <string_view>

namespace trundle {

/// How pictures look. Fast is made for a processor that computes every pixel itself; rich for a graphics card: what the sun does not
/// reach lies in shadow, on things too, corners are darker, and edges are smooth.
enum class LookChoice : std::uint8_t { Automatic, Fast, Rich };

/// Whether a renderer, as GL_RENDERER names it, computes pixels on the processor. So does one that names itself not at all.
[[nodiscard]] bool isSoftwareRenderer(std::string_view renderer);

/// Automatic is rich on a graphics card.
[[nodiscard]] bool isRich(LookChoice choice, std::string_view renderer);

} // namespace trundle
