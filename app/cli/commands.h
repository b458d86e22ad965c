#pragma once
// The subcommands. Each adds itself to the command line and, when it is the one that was asked for, leaves its work in `chosen`.

#include <functional>

#include <CLI/App.hpp>

#include "cli/exit_code.h"
#include "cli/open_options.h"
#include "parts/parts.h"

namespace trundle {

using PartsMaker = std::function<Parts&()>; ///< parts are built when a command first asks
using Chosen = std::function<ExitCode()>;

void addRun(CLI::App& app, const PartsMaker& parts, Chosen& chosen);
void addCheck(CLI::App& app, const PartsMaker& parts, Chosen& chosen);
void addPrint(CLI::App& app, Chosen& chosen);
void addFormat(CLI::App& app, Chosen& chosen);
void addEdit(CLI::App& app, const PartsMaker& parts, Chosen& chosen);
void addRender(CLI::App& app, const PartsMaker& parts, Chosen& chosen);
void addDescribe(CLI::App& app, const PartsMaker& parts, Chosen& chosen);

} // namespace trundle
