#pragma once
// Finds the block and property that a `--set PATH=VALUE` refers to.

#include <optional>
#include <vector>

#include "model/outline.h"

namespace trundle {

/// One value set on the command line, on top of the text.
struct SetTarget {
    const Part* part = nullptr; ///< block that it belongs to; nullptr: the top level of the opened file
    std::string key; ///< relative to the block: "Tick", "leftMotor.Resistance"; "Param carrier" declares an implied one
    SourceRange value;          ///< the new value, in its own `--set#N` text
    SourceRange before;         ///< the value that it replaces; unknown: there is none
};

/// A path to a member of a Grid or Scatter, which has no text of its own.
struct MemberPath {
    const Part* layout = nullptr;
    std::string name;
    SourceRange range; ///< of the name
};

struct AppliedSets {
    std::vector<SetTarget> targets;
    std::vector<MemberPath> members;
};

/// Applies the sets of the outline's texts in order. Invalid paths are E314 with the available names; whether the last word is a
/// property and the value is valid is checked when values are read.
[[nodiscard]] AppliedSets applySets(Outline& outline, Diagnostics& diagnostics);
/// The targets of sets that are not part of the outline's texts; the outline is unchanged.
[[nodiscard]] AppliedSets targetsOfSets(const Outline& outline, std::span<const SetText> sets, Diagnostics& diagnostics);

/// The part that a dotted path begins with, and the number of words it takes; nullptr if there is none.
struct PathStart {
    const Part* part = nullptr;
    std::size_t words = 0;
};
[[nodiscard]] PathStart startOfPath(const Outline& outline, std::span<const std::string> path);

} // namespace trundle
