#pragma once
// All places in a project where one block or Param is referenced by name.

#include <string>
#include <string_view>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

struct NameReference {
    const BlockItem* target = nullptr; ///< the referenced block; nullptr: it is a Param
    const ParamItem* param = nullptr;
    SourceRange name;           ///< source range of the name; unknown: a default value of `user`, not written in the text
    SourceRange before;         ///< in `chassis.hull` the range of `chassis`; unknown: the name has no prefix
    const Part* user = nullptr; ///< the block that contains it; nullptr: the top level
    std::string property;       ///< key of the value that contains it; for an override its whole path
    bool pattern = false;       ///< part of a pattern that may match other names too
    /// For a name in an override of something in a Part that is not found where it is written, but in the Part: where it is looked up first.
    const Part* lookedUpFirst = nullptr;
    const Name* implied = nullptr; ///< the Param if no text declares it, see ImpliedParam: its name where it is used first
};

/// References in `--set` texts are excluded. For a file imported by several blocks, its references are listed once per block.
[[nodiscard]] std::vector<NameReference> referencesIn(const LoadedProject& loaded);

/// Matches `*` and `?` as in the patterns of logs.
[[nodiscard]] bool fitsPattern(std::string_view pattern, std::string_view name);
/// Whether a property is a text of a log that names robots or signals.
[[nodiscard]] bool namesWorld(const Kind& kind, const Property& property);

} // namespace trundle
