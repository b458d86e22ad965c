#pragma once
// `--set PATH=VALUE`: where in the text the path leads.

#include <optional>
#include <vector>

#include "model/outline.h"

namespace trundle {

/// One setting from the command line, laid over the outline.
struct SetTarget {
    const Part* part = nullptr; ///< the block it belongs into; nullptr: the top level of the opened file
    std::string key;            ///< relative to the block: "Tick", "leftMotor.Resistance"
    SourceRange value;          ///< the new value, in its own `--set#N` text
    SourceRange before;         ///< the value it takes the place of; unknown: there is none, it is added
};

/// A path to one member of a Grid or Scatter, which has no text of its own.
struct MemberPath {
    const Part* layout = nullptr;
    std::string name;
    SourceRange range; ///< of the name
};

struct AppliedSets {
    std::vector<SetTarget> targets;
    std::vector<MemberPath> members;
};

/// Lays the sets of the outline's texts over it, in order. Wrong paths are E314 with the names that are there; whether the last
/// word is a property and the value fits is said when values are read.
[[nodiscard]] AppliedSets applySets(Outline& outline, Diagnostics& diagnostics);
/// Where sets that are none of the outline's texts would lead; the outline stays as it is.
[[nodiscard]] AppliedSets targetsOfSets(const Outline& outline, std::span<const SetText> sets, Diagnostics& diagnostics);

/// The part that a dotted path begins with, and how many of its words that took; nullptr where it names nothing.
struct PathStart {
    const Part* part = nullptr;
    std::size_t words = 0;
};
[[nodiscard]] PathStart startOfPath(const Outline& outline, std::span<const std::string> path);

} // namespace trundle
