#include "render/look_choice.h"

#include <algorithm>
#include <array>
#include <string>

namespace trundle {

bool isSoftwareRenderer(std::string_view renderer) {
    constexpr std::array<std::string_view, 7> known{"llvmpipe",    "softpipe",    "swrast", "swr (", "software rasterizer",
                                                    "swiftshader", "basic render"};
    std::string name(renderer);
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return name.empty() ||
           std::ranges::any_of(known, [&](std::string_view each) { return name.find(each) != std::string::npos; });
}

bool isRich(LookChoice choice, std::string_view renderer) {
    return choice == LookChoice::Rich || (choice == LookChoice::Automatic && !isSoftwareRenderer(renderer));
}

} // namespace trundle
