#include "editor/outline/row_blocks.h"

#include "model/config_blocks.h"

namespace trundle {

std::vector<std::pair<const Part*, bool>> blocksBelow(const Part& block, const Part* config, bool isReached) {
    std::vector<std::pair<const Part*, bool>> blocks;
    if (!config && isVariant(block)) config = block.config;
    if (config) eachBlock(*config, [&](const Part& part) { blocks.emplace_back(&part, true); });
    for (const Part& part : block.parts) blocks.emplace_back(&part, isReached);
    return blocks;
}

} // namespace trundle
