#include "model/body_geom.h"

#include <algorithm>

#include "model/dotted_path.h"

namespace trundle {

BodyGeom geomAt(const std::vector<BodySpec>& bodies, std::string_view path) {
    for (std::string_view name = withoutLastWord(path); !name.empty(); name = withoutLastWord(name)) {
        const auto body = std::ranges::find(bodies, name, &BodySpec::name);
        if (body == bodies.end()) continue;
        const auto geom = std::ranges::find(body->geoms, path.substr(name.size() + 1), &GeomSpec::name);
        return {static_cast<int>(body - bodies.begin()),
                geom == body->geoms.end() ? -1 : static_cast<int>(geom - body->geoms.begin())};
    }
    return {};
}

} // namespace trundle
