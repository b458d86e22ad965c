#pragma once
#include <map>
#include <memory>
#include <string>

namespace trundle {

using SharedText = std::shared_ptr<const std::string>;

/// Unsaved file contents of an editor, by absolute canonical path, used instead of the files on disk. A path without a file on
/// disk is valid too.
using TextOverlay = std::map<std::string, SharedText>;

} // namespace trundle
