#include <csignal>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "base/clean_text.h"
#include "base/spelling.h"
#include "cli/diagnostic_json.h"
#include "cli/manual.h"
#include "cli/messages.h"
#include "cli/run_guard.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"
#include "cli/usage_json.h"
#include "control/kinds_json.h"
#include "control/module_store.h"
#include "crash/exit_hook.h"

namespace trundle {
namespace {

struct DescribeArguments {
    OpenOptions open;
    std::string kind, module, output;
    bool json = false;
};

constexpr unsigned kMaxSeconds = 30; // enough for a build on a busy machine

/// Ends the program if the module's code does not return, so that a build does not wait forever.
void onAlarm(int) {
    static constexpr char kText[] = "trundle-cli: the module did not finish loading and describing its kinds within 30 s: is "
                                    "there an endless loop in a constructor of its globals or in a describe()?\n";
    [[maybe_unused]] const ssize_t written = write(messagesFile(), kText, sizeof kText - 1);
    endProcess(kExitText);
}

/// Called by the build of a module: writes the description file next to the library.
ExitCode describeModule(const DescribeArguments& arguments) {
    const std::string output = arguments.output.empty() ? kindsJsonPath(arguments.module) : arguments.output;
    std::signal(SIGALRM, onAlarm);
    alarm(kMaxSeconds); // until the process ends: destructors of the module may hang too
    const auto calls = std::make_shared<CallMonitor>();
    RunGuard guard({calls, "description", false, false}); // the module's code runs
    guard.endOnRequest();
    const Status written = writeKindsJson(arguments.module, output, calls);
    guard.restoreProcess();
    if (!written) printProblem(written.error().message);
    if (!written && arguments.json) writeOut(usageJson("describe", written.error().message));
    return written ? kExitDone : kExitText;
}

ExitCode describeKinds(Application& application, const DescribeArguments& arguments) {
    const std::shared_ptr<const Registry> builtIn = application.builtIn();
    const std::vector<Kind> fromModules = application.moduleKinds(arguments.open);
    std::vector<const Kind*> kinds = builtIn->all();
    for (const Kind& kind : fromModules) kinds.push_back(&kind);

    if (arguments.kind.empty()) {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        for (const Kind* kind : kinds) all.push_back(manualJson(*kind));
        const bool isReported =
            writeOut(arguments.json ? jsonText(all)
                                    : cleanText(manualList(kinds)) + "\n`trundle-cli describe KIND` shows more of each.\n");
        return isReported ? kExitDone : kExitText;
    }
    std::vector<std::string> names;
    for (const Kind* kind : kinds) {
        if (kind->name == arguments.kind) {
            return writeOut(arguments.json ? jsonText(manualJson(*kind)) : cleanText(manualPage(*kind))) ? kExitDone : kExitText;
        }
        names.push_back(kind->name);
    }
    const std::vector<std::string> near = nearestWords(arguments.kind, names, 1);
    std::string why = "there is no kind " + arguments.kind + (near.empty() ? "" : "; did you mean " + near[0] + "?") +
                      " (`trundle-cli describe` lists all)";
    printProblem(why);
    for (const Error& fault : application.moduleFaults(arguments.open)) { // of a file that may have it
        printProblem(fault.message);
        why += "; " + fault.message;
    }
    if (arguments.json) writeOut(usageJson("describe", why));
    return kExitUsage;
}

constexpr const char* kDescribeExamples = R"(Examples:
  trundle-cli describe
  trundle-cli describe RotaryMotor
  trundle-cli describe LinearMotion --modules build/my_modules
  trundle-cli describe --json > kinds.json)";

} // namespace

void addDescribe(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("describe", "The manual: every kind, its properties and its signals");
    auto arguments = std::make_shared<DescribeArguments>();
    command->add_option("KIND", arguments->kind, "The kind to describe; without it, a list of all")
        ->type_name("")
        ->check(&emptyProblem);
    command->add_flag("--json", arguments->json, "As JSON");
    command->add_option("--modules", arguments->open.modules, "Also the kinds of the modules in DIR (may be repeated)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    command->add_option("--module", arguments->module, "Load a module and write its description file")
        ->type_name("LIB")
        ->group("");
    command->add_option("--output", arguments->output, "Where to; by default LIB.kinds.json")->type_name("FILE")->group("");
    command->footer(kDescribeExamples);
    command->callback([arguments, &application, &chosen] {
        if (!arguments->output.empty() && arguments->module.empty()) throw CLI::ValidationError("--output", "needs --module LIB");
        chosen = [arguments, &application] {
            return arguments->module.empty() ? describeKinds(application(), *arguments) : describeModule(*arguments);
        };
    });
}

} // namespace trundle
