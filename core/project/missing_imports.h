#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "project/search.h"

namespace trundle {

struct Loaded;

/// Unknown references to what a file that could be imported defines (a config, material, surface or antenna pattern) get that
/// file's name and the line that imports it. `folders` are looked through in their order. Reads files only where such a reference is.
void offerImports(const Loaded& loaded, const FileSearch& search, const std::vector<std::string>& folders,
                  std::vector<Diagnostic>& diagnostics);

} // namespace trundle
