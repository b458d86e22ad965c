// trundle-cli: experiments from the command line. Needs no display.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <trundle/abi.h>

#include "base/platform/memory.h"
#include "base/spelling.h"
#include "cli/messages.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"
#include "cli/usage_json.h"

namespace {

constexpr const char* kFooter = R"(Examples:
  trundle-cli run configs/experiments/linear_motion.sim
  trundle-cli check my_robot.sim
  trundle-cli describe RotaryMotor

`trundle-cli COMMAND --help` shows more of each.)";

/// The error message for an unknown subcommand or option; CLI11 would only report that a subcommand is missing.
std::optional<std::string> unknownCommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2) return std::nullopt;
    if (argv[1][0] == '-')
        return app.get_option_no_throw(argv[1])
                   ? std::nullopt
                   : std::optional("there is no option " + std::string(argv[1]) + " before a command");
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::string word = argv[1];
    if (std::ranges::find(names, word) != names.end()) return std::nullopt;
    const std::vector<std::string> near = trundle::nearestWords(word, names, 1);
    return "there is no command " + word + (near.empty() ? "" : "; did you mean " + near[0] + "?") +
           " (`trundle-cli --help` lists all)";
}

/// `known`: the command exists.
int refuse(int argc, char** argv, const std::string& why, bool known) {
    const std::string command = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
    trundle::printProblem(why);
    trundle::writeMessage("`trundle-cli " + (known && !command.empty() ? command + " " : std::string()) +
                          "--help` says how it is used.\n");
    if (trundle::asksForJson(argc, argv)) trundle::writeOut(trundle::usageJson(command, why));
    return trundle::kExitUsage;
}

int run(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // exceeding the file size limit fails the write instead of ending the program
    CLI::App app("Trundle: describe mobile robots in text, run them in 3D dynamics, measure.", "trundle-cli");
    app.set_version_flag("--version", "trundle-cli " TRUNDLE_VERSION " (SDK " TRUNDLE_SDK_VERSION ")");
    app.require_subcommand(1);
    app.footer(kFooter);

    std::unique_ptr<trundle::Application> application;
    const trundle::ApplicationFactory applicationOf = [&application]() -> trundle::Application& {
        if (!application) application = trundle::makeApplication();
        return *application;
    };
    trundle::ChosenCommand chosen;
    trundle::addRun(app, applicationOf, chosen);
    trundle::addServe(app, chosen);
    trundle::addDrive(app, chosen);
    trundle::addCheck(app, applicationOf, chosen);
    trundle::addPrint(app, chosen);
    trundle::addFormat(app, chosen);
    trundle::addEdit(app, applicationOf, chosen);
    trundle::addRender(app, applicationOf, chosen);
    trundle::addNew(app, applicationOf, chosen);
    trundle::addDescribe(app, applicationOf, chosen);
    if (const auto problem = unknownCommand(app, argc, argv)) return refuse(argc, argv, *problem, false);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        (void)app.exit(help, text, text);
        return trundle::writeOut(text.str()) ? trundle::kExitDone : trundle::kExitText;
    } catch (const CLI::ParseError& problem) { return refuse(argc, argv, problem.what(), true); }
    return chosen ? chosen() : trundle::kExitUsage;
}

} // namespace

int main(int argc, char** argv) {
    trundle::keepStandardStreams();
    try {
        return run(argc, argv);
    } catch (const std::exception& problem) { // for example out of memory: other exceptions do not leave the libraries
        const std::string reason = trundle::reasonOf(problem);
        trundle::printProblem(reason);
        if (trundle::asksForJson(argc, argv)) trundle::writeOut(trundle::usageJson(argc > 1 ? argv[1] : "", reason));
        return trundle::kExitText;
    }
}
