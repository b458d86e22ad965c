#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/clean_text.h"
#include "cli/commands.h"
#include "cli/diagnostic_json.h"
#include "cli/messages.h"
#include "cli/open_options.h"
#include "run/log_kinds.h"
#include "world/signal_plan.h"
#include "world/validate.h"

namespace trundle {
namespace {

struct CheckArguments {
    OpenOptions open;
    std::vector<std::string> files;
    bool json = false;
};

/// A file that cannot be read still has its entry in the JSON.
nlohmann::ordered_json unreadableJson(const std::string& file, const Error& error) {
    nlohmann::ordered_json entries = diagnosticsJson({{Severity::Error, error.code, error.message, {}, {}, {}, {}}}, {});
    entries[0]["file"] = file;
    return entries;
}

/// What `run` would refuse although the text makes sense.
void checkForRun(const Loaded& loaded, Diagnostics& diagnostics) {
    checkLogs(*loaded.experiment, diagnostics);
    if (diagnostics.hasErrors() || !isBuildable(*loaded.experiment, diagnostics)) return;
    const bool allKindsKnown = std::ranges::none_of(diagnostics.all(), [](const Diagnostic& d) {
        return d.code == Code::ModuleNotTrusted || d.code == Code::ModuleUndescribed;
    });
    if (allKindsKnown) // a device that is not known may have any signal
        checkLogSignals(*loaded.experiment, plannedLayout(*loaded.experiment, *loaded.registry), diagnostics);
}

ExitCode check(Parts& parts, const CheckArguments& arguments) {
    ExitCode code = kExitDone;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& file : arguments.files) {
        const Result<std::shared_ptr<const Loaded>> opened = parts.open(file, arguments.open);
        if (!opened) {
            code = kExitUsage;
            if (!arguments.json) printProblem(opened.error().message);
            for (auto& entry : unreadableJson(file, opened.error())) all.push_back(std::move(entry));
            continue;
        }
        const Loaded& loaded = *opened.value();
        Diagnostics diagnostics = loaded.diagnostics;
        checkForRun(loaded, diagnostics);
        if (diagnostics.hasErrors() && code == kExitDone) code = kExitText;
        if (arguments.json) {
            for (auto& entry : diagnosticsJson(diagnostics.all(), loaded.sources)) all.push_back(std::move(entry));
            continue;
        }
        printDiagnostics(diagnostics.all(), loaded.sources);
        const std::string counts = countText(diagnostics.all());
        writeOut(cleanLine(file) + ": " + (counts.empty() ? "ok" : counts) + "\n");
    }
    if (arguments.json && !writeOut(jsonText(all)) && code == kExitDone) code = kExitText;
    return code;
}

constexpr const char* kCheckExamples = R"(Examples:
  trundle-cli check configs/experiments/*.sim
  trundle-cli check my.sim --json

Exit codes: 0 no errors (there may be warnings), 1 errors, 2 a FILE that cannot be read.)";

} // namespace

void addCheck(CLI::App& app, const PartsMaker& parts, Chosen& chosen) {
    CLI::App* command = app.add_subcommand("check", "Look for mistakes in experiments, robots and arenas without running them");
    auto arguments = std::make_shared<CheckArguments>();
    command->add_option("FILE", arguments->files, "Files to check, each by itself")->required()->type_name("");
    command->add_flag("--json", arguments->json, "A JSON array of all messages instead of text");
    addSetOption(*command, arguments->open);
    addOpenOptions(*command, arguments->open);
    command->footer(kCheckExamples);
    command->callback([arguments, &parts, &chosen] { chosen = [arguments, &parts] { return check(parts(), *arguments); }; });
}

} // namespace trundle
