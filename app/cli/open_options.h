#pragma once
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace trundle {

/// What every command that loads an experiment takes.
struct OpenOptions {
    std::vector<std::string> includes; ///< -I
    std::vector<std::string> modules;  ///< --modules
    std::vector<std::string> sets;     ///< --set
    bool trust = false;
};

/// Adds -I, --modules and --trust.
void addOpenOptions(CLI::App& command, OpenOptions& options);
/// Adds --set.
CLI::Option* addSetOption(CLI::App& command, OpenOptions& options);

} // namespace trundle
