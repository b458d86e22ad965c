#pragma once
#include <map>
#include <memory>
#include <string>

namespace trundle {

/// Unsaved file contents of an editor, by absolute canonical path, used instead of the files on disk. A path without a file on
/// disk is valid too.
using TextOverlay = std::map<std::string, std::shared_ptr<const std::string>>;

} // namespace trundle
