#pragma once
// What is said about the Parts and Repeats of a config. Private to core/model/resolve.

#include "model/resolve/part_frame.h"

namespace trundle {

/// Notes in which member of a Repeat, Grid or Scatter something is wrong; not for the first one, unless it is its number.
void nameMember(const ResolveContext& context, Diagnostic& d, const Part& of, std::size_t member);
/// What a part is joined to is not given.
void reportMissing(ResolveContext& context, const PartFrame& frame, const OverrideNode* outside, const SourceParam& param);
/// Whether a Part, or a variant that it uses, has an unknown key that is near to the name of a Param: it is reported there.
[[nodiscard]] bool isMisspelt(const Part& use, const Part& config, const std::string& param);
/// A Part gives a Param that its PartConfig uses and has not declared.
void adviseToDeclare(const ResolveContext& context, Diagnostic& d, const PartFrame& frame);
/// An empty chain: no circle, but too deep. `use`: the Part or variant that closes it.
void reportCircle(ResolveContext& context, const Part& use, SourceRange place, const std::string& chain);
/// The Repeat around all others that a frame is in; nullptr: it is in none.
[[nodiscard]] const Part* outermostRepeat(const PartFrame& frame);

/// Reports PartConfigs that contain each other (E302).
void reportPartCircles(ResolveContext& context);

} // namespace trundle
