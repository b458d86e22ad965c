#pragma once
#include <CLI/App.hpp>

#include "parts/open_options.h"

namespace trundle {

/// Adds -I, --modules and --trust.
void addOpenOptions(CLI::App& command, OpenOptions& options);
/// Adds --set.
CLI::Option* addSetOption(CLI::App& command, OpenOptions& options);

} // namespace trundle
