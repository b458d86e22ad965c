#pragma once
// The members of a Repeat or Ring, and their numbers in `$( )`.

#include <vector>

#include <trundle/geometry.h>

#include "model/kinds/world_fields.h"
#include "model/params.h"
#include "model/part.h"
#include "schema/value_reader.h"

namespace trundle {

/// How many members: of one or two numbers the product. 0 without numbers.
[[nodiscard]] std::size_t memberCount(const std::vector<double>& counts);
/// The Count of a Repeat, Ring, Grid or Scatter, evaluated in a scope in which its members have no numbers yet; empty, with a
/// diagnostic, if it has no valid one. `set`: the value that overrides its own; nullptr: none does.
[[nodiscard]] std::vector<double> countsOf(const Part& part, Evaluator& evaluator, ParamScope& scope, const GivenValue* set,
                                           Diagnostics& diagnostics);
/// Adds `index`, the number of a member, to the Params of a scope; with two counts, `index` counts to the first one and `index2` is
/// the other.
void setIndex(ParamScope& scope, std::size_t member, const std::vector<double>& counts);
[[nodiscard]] bool isIndexUsed(const ParamScope& scope);
/// Where the frame of a member is in the config that the Ring is in.
[[nodiscard]] Pose memberPose(const RingFields& ring, std::size_t member);

} // namespace trundle
