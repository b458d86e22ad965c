#include <algorithm>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "base/clean_text.h"
#include "check/model_check.h"
#include "cli/diagnostic_json.h"
#include "cli/messages.h"
#include "cli/models_of_file.h"
#include "cli/open_arguments.h"
#include "cli/run_guard.h"
#include "cli/subcommands.h"
#include "project/edits/plan_targets.h"
#include "project/loading/modules.h"
#include "run/logs/log_kinds.h"
#include "world/validate.h"

namespace trundle {
namespace {

struct CheckArguments {
    OpenOptions open;
    std::vector<std::string> files;
    bool json = false;
    bool ofEditor = false; ///< see checkRobots()
    bool isModel = false;  ///< see openModels()
};

/// The JSON entry of a file that cannot be read.
nlohmann::ordered_json unreadableJson(const std::string& file, const Error& error) {
    nlohmann::ordered_json entries = diagnosticsJson({{Severity::Error, error.code, error.message, {}, {}, {}, {}}}, {});
    entries[0]["file"] = file;
    return entries;
}

/// Builds everything a run would build, without running a tick; reports devices that cannot be set up and unknown ports.
void buildOnce(Application& application, const LoadedProject& loaded, Diagnostics& diagnostics, bool json = false) {
    RunOptions options;
    options.calls = std::make_shared<CallMonitor>();
    const RunGuard guard({options.calls, "check", false, json}); // runs code of trusted modules
    options.pictures = [](const ExperimentSpec&, const SignalLayout&) -> Result<std::unique_ptr<ImageSource>> {
        return Error{Code::NoGraphics, "a check takes no pictures"};
    };
    Diagnostics problems;
    (void)application.makeRunner(loaded, std::move(options), problems);
    for (const Diagnostic& problem : problems.all())
        if (problem.severity == Severity::Error) diagnostics.append({problem});
}

/// Reports what would make `run` fail or give wrong results although the text itself is valid.
void checkForRun(Application& application, const LoadedProject& loaded, FileId definitions, Diagnostics& diagnostics) {
    const bool hasErrors = diagnostics.hasErrors(), allKindsKnown = hasAllModules(diagnostics);
    if (!hasErrors && !isBuildable(*loaded.experiment, diagnostics)) return;
    checkLogs(*loaded.experiment, *loaded.registry, allKindsKnown && !hasErrors, diagnostics);
    checkModel(loaded, diagnostics, {}, definitions);
    tryRobots(loaded, diagnostics);
    if (allKindsKnown && !diagnostics.hasErrors() && !loaded.experiment->robots.empty())
        buildOnce(application, loaded, diagnostics);
}

/// For an editor, which does the other checks itself: standard input has its texts, a JSON object by path. Prints an array of what
/// setting up the robots finds, or the object of a run that a module ended. Places are absolute paths and byte offsets.
ExitCode checkRobots(Application& application, CheckArguments arguments) {
    const auto texts = nlohmann::json::parse(std::cin, nullptr, false);
    for (const auto& [path, text] : texts.items())
        if (text.is_string()) arguments.open.texts.emplace(path, std::make_shared<const std::string>(text.get<std::string>()));
    const auto opened = application.open(arguments.files[0], arguments.open);
    Diagnostics found, unused;
    if (!opened) return kExitUsage;
    const LoadedProject& loaded = *opened.value();
    const Diagnostics& problems = loaded.diagnostics;
    if (!problems.hasErrors() && hasAllModules(problems) && isBuildable(*loaded.experiment, unused))
        buildOnce(application, loaded, found, true);
    nlohmann::ordered_json entries = diagnosticsJson(found.all(), loaded.sources);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const SourceRange& place = found.all()[i].range;
        if (place.known()) entries[i]["file"] = loaded.paths[place.file];
        entries[i]["begin"] = place.range.begin;
        entries[i]["end"] = place.range.end;
    }
    return writeOut(jsonText(entries)) ? kExitDone : kExitText;
}

Result<OpenedModels> openFor(Application& application, const std::string& file, const CheckArguments& arguments) {
    if (arguments.isModel) return openModels(application, file, arguments.open);
    const auto opened = application.open(file, arguments.open);
    if (!opened) return opened.error();
    return OpenedModels{opened.value()};
}

ExitCode check(Application& application, const CheckArguments& arguments) {
    ExitCode code = kExitDone;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& file : arguments.files) {
        const Result<OpenedModels> opened = openFor(application, file, arguments);
        if (!opened) {
            code = kExitUsage;
            if (!arguments.json) printProblem(opened.error().message);
            for (auto& entry : unreadableJson(file, opened.error())) all.push_back(std::move(entry));
            continue;
        }
        const LoadedProject& loaded = *opened.value().loaded;
        Diagnostics diagnostics = loaded.diagnostics;
        checkForRun(application, loaded, opened.value().definitions, diagnostics);
        const bool ofModels = isOfModels(loaded);
        const SourceTable sources = ofModels ? withoutModels(loaded.sources) : loaded.sources;
        if (ofModels) diagnostics = atTheirModels(loaded, diagnostics);
        const bool lacksModules =
            !hasAllModules(diagnostics); // warnings only: the user may trust them, or describe them, before a run
        if ((diagnostics.hasErrors() || lacksModules) && code == kExitDone) code = kExitText;
        if (arguments.json) {
            for (auto& entry : diagnosticsJson(diagnostics.all(), sources)) all.push_back(std::move(entry));
            continue;
        }
        printDiagnostics(diagnostics.all(), sources);
        const std::string counts = countText(diagnostics.all());
        const char* const refused = lacksModules && !diagnostics.hasErrors() ? "; a run is refused without the module" : "";
        if (!writeOut(cleanLine(file) + ": " + (counts.empty() ? "ok" : counts) + refused + "\n") && code == kExitDone)
            code = kExitText;
    }
    if (arguments.json && !writeOut(jsonText(all)) && code == kExitDone) code = kExitText;
    return code;
}

constexpr const char* kCheckExamples = R"(Examples:
  trundle-cli check configs/experiments/*.sim
  trundle-cli check my.sim --json
  trundle-cli check --model my_robot.sim

Beside mistakes in the text it says what starts inside something else, below the floor or in the air, which bodies no joint holds or
differ too much in mass, which drives disagree with their wheels or are too weak, and what a run would refuse. For that it sets up
robots with the controllers of trusted modules, as a run does, but takes no step.

Exit codes: 0 no errors (there may be warnings), 1 errors, or a module that a run with the same options does not load, 2 a FILE that
cannot be read.)";

} // namespace

void addCheck(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand(
        "check", "Look for mistakes in experiments, robots and arenas, and for what starts badly, without running them");
    auto arguments = std::make_shared<CheckArguments>();
    command->add_option("FILE", arguments->files, "Files to check, each by itself")->required()->type_name("");
    command->add_flag("--json", arguments->json, "A JSON array of all messages instead of text");
    command->add_flag("--model", arguments->isModel, "Check each robot model of a FILE on a plain floor, without its experiment");
    addSetOption(*command, arguments->open);
    addOpenOptions(*command, arguments->open);
    command->add_flag("--robots-of-texts", arguments->ofEditor, "For an editor: see checkRobots()")->group("");
    command->footer(kCheckExamples);
    command->callback([arguments, &application, &chosen] {
        chosen = [arguments, &application] {
            return arguments->ofEditor ? checkRobots(application(), *arguments) : check(application(), *arguments);
        };
    });
}

} // namespace trundle
