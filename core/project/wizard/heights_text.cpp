#include "project/wizard/heights_text.h"

#include <algorithm>
#include <cmath>

#include "project/wizard/floor_path.h"

namespace trundle {

Result<std::string> heightsText(const std::string& file, const std::array<double, 3>& size) {
    for (const double length : size)
        if (!(length >= 0.001 && length <= 1e4))
            return Error{Code::OutOfRange, "The ground must be from 0.001 to 10000 m long, wide and high."};
    const bool isPlain = std::ranges::all_of(file, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '/' ||
               c == '-';
    });
    if (file.find_first_of("\"\\\n") != std::string::npos)
        return Error{Code::OutOfRange, "The name of the picture must be without quotes and backslashes."};
    return "Heightfield ground { File=" + (isPlain ? file : '"' + file + '"') + " Size=" + tidyNumber(size[0]) + "," +
           tidyNumber(size[1]) + "," + tidyNumber(size[2]) + " Material=concrete Surface=ground }\n";
}

std::string heightsArenaText(const std::string& name, const std::string& ground) {
    return "// " + name + ": ground from a grey picture, black at z = 0. Size is its length, its width and the height of white." +
           "\n#import common/materials.sim\n#import common/surfaces.sim\n\nStaticConfig " + name + " {\n  " + ground + "}\n";
}

double heightAt(const HeightMap& map, const std::array<double, 3>& size, const std::array<double, 2>& place, double radius) {
    double highest = 0;
    for (std::uint32_t row = 0; row < map.rows; ++row)
        for (std::uint32_t column = 0; column < map.columns; ++column) {
            const double x = (double(column) / std::max(1u, map.columns - 1) - 0.5) * size[0];
            const double y = (0.5 - double(row) / std::max(1u, map.rows - 1)) * size[1];
            if (std::hypot(x - place[0], y - place[1]) <= radius + std::max(size[0] / map.columns, size[1] / map.rows))
                highest = std::max(highest, double(map.heights[std::size_t(row) * map.columns + column]) * size[2]);
        }
    return highest;
}

} // namespace trundle
