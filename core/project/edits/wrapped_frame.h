#pragma once
// Selected blocks that count from a body outside of the selection. Private to core/project.

#include <string>

#include "project/edits/wrapped_blocks.h"

namespace trundle {

/// The `In` of the Part or Repeat around the blocks, "chassis", in place of those of the blocks, which are removed; empty if they have
/// none that leads out of the selection. Their poses keep their numbers; joints and springs, which are described in the frame of the
/// config, get those of the body's frame. Fails if the blocks count from different frames, and where numbers cannot be written anew.
[[nodiscard]] Result<std::string> takeIn(const LoadedProject& loaded, WrappedBlocks& blocks,
                                         const std::vector<NameReference>& references);

} // namespace trundle
