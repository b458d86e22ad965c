#pragma once
#include <map>
#include <memory>
#include <string>

namespace trundle {

/// Bytes that stand in for the content of files, by absolute canonical path: what an editor holds and has not saved. A path that
/// no file holds yet is as good as one that does.
using TextOverlay = std::map<std::string, std::shared_ptr<const std::string>>;

} // namespace trundle
