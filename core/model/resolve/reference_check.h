#pragma once
// The names in the properties of a config's blocks. Private to core/model.

#include "model/resolve/part_frame.h"

namespace trundle {

/// Checks all references of a block, with a diagnostic for each that names nothing or the wrong kind, and writes the names as they are
/// in the config, with those of the Parts in front. `self`: the name of the block where it cannot mean itself; empty: it can.
[[nodiscard]] bool checkReferences(ResolveContext& context, Record& record, const PartFrame& frame, const std::string& self = {});
/// The same for a block of a config without Parts around it.
[[nodiscard]] bool checkReferences(ResolveContext& context, Record& record, const Part& config);

} // namespace trundle
