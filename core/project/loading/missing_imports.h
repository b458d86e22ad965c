#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "project/loading/search.h"

namespace trundle {

struct LoadedProject;

/// Adds fixes to unknown references to configs, materials, surfaces and antenna patterns: the import line of a file that defines
/// the name. Searches `folders` in order. Reads files only if there is such a reference.
void offerImports(const LoadedProject& loaded, const FileSearch& search, const std::vector<std::string>& folders,
                  std::vector<Diagnostic>& diagnostics);

} // namespace trundle
