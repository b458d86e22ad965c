#pragma once
#include <CLI/App.hpp>

#include "parts/open_options.h"
#include "render/render_entry.h"

namespace trundle {

/// Adds -I, --modules and --trust.
void addOpenOptions(CLI::App& command, OpenOptions& options);
/// Adds --set.
CLI::Option* addSetOption(CLI::App& command, OpenOptions& options);
/// Adds --look.
void addLookOption(CLI::App& command, LookChoice& look);

} // namespace trundle
