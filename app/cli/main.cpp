// trundle-cli: experiments from the command line. Works with no display.

#include <algorithm>
#include <csignal>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <trundle/abi.h>

#include "base/spelling.h"
#include "cli/commands.h"
#include "cli/messages.h"

namespace {

constexpr const char* kFooter = R"(Examples:
  trundle-cli run configs/experiments/linear_motion.sim
  trundle-cli check my_robot.sim
  trundle-cli describe RotaryMotor

`trundle-cli COMMAND --help` tells more of each.)";

/// CLI11 would only say that a subcommand is missing.
std::optional<std::string> unknownCommand(const CLI::App& app, int argc, char** argv) {
    if (argc < 2 || argv[1][0] == '-') return std::nullopt;
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::string word = argv[1];
    if (std::ranges::find(names, word) != names.end()) return std::nullopt;
    const std::vector<std::string> near = trundle::nearestWords(word, names, 1);
    return "there is no command " + word + (near.empty() ? "" : "; did you mean " + near[0] + "?") +
           " (`trundle-cli --help` lists all)";
}

int run(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files fails the write, not the program
    CLI::App app("Trundle: describe mobile robots in text, run them in 3D dynamics, measure.", "trundle-cli");
    app.set_version_flag("--version", "trundle-cli " TRUNDLE_VERSION " (SDK " TRUNDLE_SDK_VERSION ")");
    app.require_subcommand(1);
    app.footer(kFooter);

    std::unique_ptr<trundle::Parts> parts;
    const trundle::PartsMaker partsOf = [&parts]() -> trundle::Parts& {
        if (!parts) parts = trundle::makeParts();
        return *parts;
    };
    trundle::Chosen chosen;
    trundle::addRun(app, partsOf, chosen);
    trundle::addCheck(app, partsOf, chosen);
    trundle::addPrint(app, chosen);
    trundle::addFormat(app, chosen);
    trundle::addEdit(app, partsOf, chosen);
    trundle::addRender(app, partsOf, chosen);
    trundle::addDescribe(app, partsOf, chosen);
    if (const auto problem = unknownCommand(app, argc, argv)) {
        trundle::printProblem(*problem);
        return trundle::kExitUsage;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) { return app.exit(problem) == 0 ? trundle::kExitDone : trundle::kExitUsage; }
    return chosen ? chosen() : trundle::kExitUsage;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& problem) { // out of memory, say: no library lets anything else through
        trundle::printProblem(problem.what());
        return trundle::kExitText;
    }
}
