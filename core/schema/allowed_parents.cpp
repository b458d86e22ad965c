#include "schema/allowed_parents.h"

#include <algorithm>

namespace trundle {

std::vector<std::string> allowedParents(const Kind& kind) {
    switch (kind.role) {
    case Role::Device: return {"RobotConfig", "StaticConfig", "PartConfig", "Repeat", "Ring"};
    case Role::Controller: return {"Robot", "Static", "Grid", "Scatter"};
    case Role::Log: return {"", "Repeat", "Ring"};
    default: return kind.parents;
    }
}

bool isAllowedInside(const Kind& kind, std::string_view parent) {
    const std::vector<std::string> all = allowedParents(kind);
    return std::find(all.begin(), all.end(), parent) != all.end();
}

} // namespace trundle
