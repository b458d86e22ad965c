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

} // namespace trundle
