#pragma once
// The subcommands. Each registers itself with the command line and, if selected, stores its action in `chosen`.

#include <functional>

#include <CLI/App.hpp>

#include "app/application.h"
#include "cli/exit_code.h"
#include "cli/open_arguments.h"

namespace trundle {

using ApplicationFactory = std::function<Application&()>; ///< creates the application when a command first needs it
using ChosenCommand = std::function<ExitCode()>;

void addRun(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);
void addCheck(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);
void addPrint(CLI::App& app, ChosenCommand& chosen);
void addFormat(CLI::App& app, ChosenCommand& chosen);
void addEdit(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);
void addRender(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);
void addServe(CLI::App& app, ChosenCommand& chosen);
void addDrive(CLI::App& app, ChosenCommand& chosen);
void addNew(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);
void addDescribe(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen);

} // namespace trundle
