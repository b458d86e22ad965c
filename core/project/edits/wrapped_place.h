#pragma once
// The place of selected blocks, which the Part around them gets. Private to core/project.

#include <string>

#include "project/edits/wrapped_blocks.h"

namespace trundle {

/// The Pos of the first body as written, "0,$half,$r", which is removed: the other bodies and the joints count from it now. Empty, with
/// nothing changed, where the text does not show the places: a Repeat, a Pos that an override sets, a device with a pose on a body outside,
/// several bodies by formulas. The pose of the first body is the same to the last bit, those of others but for the rounding of a sum.
[[nodiscard]] std::string takePlace(const LoadedProject& loaded, WrappedBlocks& blocks,
                                    const std::vector<NameReference>& references);

} // namespace trundle
