#include "model/config_blocks.h"

#include <algorithm>

#include "base/spelling.h"

namespace trundle {

bool hasMisspeltConfig(const Part& config) {
    const std::vector<std::string> meant{"Config"};
    return std::ranges::any_of(config.assignments.all(), [&](const SourceAssignment& a) {
        return a.path.size() == 1 && !config.kind->find(a.key) && !nearestWords(a.key, meant).empty();
    });
}

bool isConfigComputed(const Part& part) {
    const SourceAssignment* a = part.isPartUse() ? part.assignments.find("Config") : nullptr;
    if (!a || a->value->elements.size() != 1) return false;
    const Element::Kind kind = a->value->elements[0].kind;
    return kind == Element::Kind::ParamRef || kind == Element::Kind::Expression;
}

} // namespace trundle
