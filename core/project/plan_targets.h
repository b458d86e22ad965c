#pragma once
// The objects that a plan is about. Private to core/project.

#include <string>
#include <vector>

#include "base/result.h"
#include "project/object_place.h"

namespace trundle {

/// The place of a path whose block may be changed. Fails for the experiment itself, for what is not there, and for a member of a
/// Grid or Scatter, which has no text.
[[nodiscard]] Result<ObjectPlace> changeable(const Loaded& loaded, const std::string& path);

/// One of several objects, with the path it was named by.
struct Chosen {
    ObjectPlace place;
    std::string path;
};
/// In the order of the text, each block once, none that stands in another of them.
[[nodiscard]] Result<std::vector<Chosen>> chosen(const Loaded& loaded, const std::vector<std::string>& paths);

/// Whether a block stands in another, or is it.
[[nodiscard]] bool isWithin(const SourceRange& inner, const SourceRange& outer);
/// Whether a kind of block may stand in `parent` (nullptr: at the top level).
[[nodiscard]] bool mayStand(const Kind& kind, const Part* parent);
/// "a Box stands in a Body or a StaticConfig".
[[nodiscard]] std::string standsIn(const Kind& kind);
/// The path without its last name; "" for one of the top level.
[[nodiscard]] std::string parentPath(const ObjectPlace& place, const std::string& path);

} // namespace trundle
