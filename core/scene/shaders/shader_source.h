#pragma once
// The GLSL files of this folder, compiled into the program. GLSL 1.30 for a compatibility context. Input and output colours are
// display colours; light is summed linearly, with a gamma of 2. The number of lamps is compiled in, and no branch depends on a
// uniform: software renderers pay for every loop and branch.

#include <string>
#include <string_view>

namespace trundle {

/// The text of a shader file ("body.frag.glsl") with its `#include "other.glsl"` lines replaced by the files that they name, and a
/// `#version` line in front. A file that does not exist becomes an `#error` line, which CheckedProgram reports.
[[nodiscard]] std::string shaderSource(std::string_view file);

} // namespace trundle
