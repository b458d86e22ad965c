#pragma once
// Every place in the texts of a load where one thing names another.

#include <string>
#include <string_view>
#include <vector>

#include "project/project.h"

namespace trundle {

struct Mention {
    const BlockItem* target = nullptr; ///< block of the thing that is named; nullptr: it is a Param
    const ParamItem* param = nullptr;
    SourceRange name;           ///< the characters of the name; unknown: a default of `user` names it, nothing is written
    SourceRange before;         ///< in `chassis.hull` the characters of `chassis`; unknown: the name stands alone
    const Part* user = nullptr; ///< block it stands in; nullptr: the top level
    std::string property;       ///< key of the value it stands in; of an override, its whole path
    bool pattern = false;       ///< in a pattern that may mean others as well
};

/// Those in `--set` texts are left out. What stands in a file that several blocks import comes once for each of them.
[[nodiscard]] std::vector<Mention> mentionsIn(const Loaded& loaded);

/// `*` and `?` as logs understand them.
[[nodiscard]] bool fitsPattern(std::string_view pattern, std::string_view name);
/// A text property of a log that names robots or signals.
[[nodiscard]] bool namesWorld(const Kind& kind, const Property& property);

} // namespace trundle
