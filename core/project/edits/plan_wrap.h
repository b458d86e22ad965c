#pragma once
// Puts blocks of a config into a part or a Repeat, and writes mirror images of parts.

#include <string>
#include <vector>

#include "project/edits/plans.h"

namespace trundle {

/// Makes a PartConfig of blocks of one config, written before that config, and a Part that uses it in their place. Poses are kept.
/// What the blocks use outside of them becomes Params of the PartConfig, given by the Part; names that lead into the blocks lead
/// through the Part. Blocks that all have one body outside of them as their In give it to the Part. Fails for blocks of several
/// configs or files, for blocks that count from different bodies and for blocks that a PartConfig cannot have.
[[nodiscard]] Result<EditPlan> planMakePart(const LoadedProject& loaded, const std::vector<std::string>& paths);
/// Writes the mirror image of each Part along `axis` ('x', 'y' or 'z') of the config behind it: "Part right { Config=... Mirror=y }".
/// Other blocks become a part first, see planMakePart(). Fails for a Part whose pose or Mirror cannot be mirrored in the text, for
/// devices alone that have no pose, and where the mirror image is there already, see checkMirrorImage().
[[nodiscard]] Result<EditPlan> planMirror(const LoadedProject& loaded, const std::vector<std::string>& paths, char axis);
/// Puts blocks of one config into a Repeat with `count` members, each `step` (m) from the one before. Names that lead into the blocks
/// lead to the first member, overrides to all. Fails as planMakePart(), and for a count that is not from 1 to kMaxObjects.
[[nodiscard]] Result<EditPlan> planRepeat(const LoadedProject& loaded, const std::vector<std::string>& paths, int count,
                                          const Vec3& step);

} // namespace trundle
