#include "scene/shaders/shader_source.h"

#include <algorithm>

#include "scene/shaders/shader_files.h"

namespace trundle {
namespace {

std::string included(std::string_view file) {
    const auto found = std::ranges::find(kShaderFiles, file, &ShaderFile::name);
    if (found == std::end(kShaderFiles)) return "#error no such file: " + std::string(file) + "\n";
    constexpr std::string_view include = "#include \"";
    std::string text(found->text);
    for (std::size_t at = text.find(include); at != std::string::npos; at = text.find(include, at)) {
        const std::size_t name = at + include.size(), quote = text.find('"', name);
        text.replace(at, quote + 1 - at, included(text.substr(name, quote - name)));
    }
    return text;
}

} // namespace

std::string shaderSource(std::string_view file) { return "#version 130\n" + included(file); }

} // namespace trundle
