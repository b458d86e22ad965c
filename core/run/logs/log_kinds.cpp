#include "run/logs/log_kinds.h"

#include <map>

#include "run/logs/log_choice.h"
#include "run/logs/log_folder.h"
#include "run/logs/log_settings.h"
#include "world/signal_plan.h"
#include "world/validate.h"

namespace trundle {
namespace {

struct LogKind {
    const char* name;
    Kind (*kind)(std::string name);
    std::unique_ptr<Log> (*make)(const ComponentSpec&, const World&, Diagnostics&);
};

template <class T> Kind logKind(std::string name) { return kindOf<T>(std::move(name), Role::Log, {"", "Repeat", "Ring"}, true); }

constexpr LogKind kLogKinds[] = {
    {"PoseLog", logKind<PoseLogSettings>, makePoseLog},          {"SignalLog", logKind<SignalLogSettings>, makeSignalLog},
    {"ContactLog", logKind<ContactLogSettings>, makeContactLog}, {"EnergyLog", logKind<EnergyLogSettings>, makeEnergyLog},
    {"FrameLog", logKind<FrameLogSettings>, makeFrameLog},       {"RadioLog", logKind<RadioLogSettings>, makeRadioLog},
    {"LinkMatrix", logKind<LinkMatrixSettings>, makeLinkMatrix},
};

} // namespace

Status addLogKinds(Registry& registry) {
    for (const LogKind& log : kLogKinds)
        if (Status added = registry.add(log.kind(log.name)); !added) return added;
    return {};
}

std::unique_ptr<Log> makeLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    for (const LogKind& log : kLogKinds)
        if (spec.kind == log.name) return log.make(spec, world, diagnostics);
    return nullptr; // not reached: the resolver rejects unknown kinds
}

std::string logFileName(const ComponentSpec& spec) {
    return spec.text("File", spec.name + (spec.text("Format") == "pcap" ? ".pcap" : ".csv"));
}

void checkLogs(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::map<std::string, const ComponentSpec*> writers;
    for (const ComponentSpec& spec : experiment.logs) {
        if (spec.find("Robot")) (void)chooseRobots(spec, experiment.robots, diagnostics);
        const ResolvedValue* file = spec.find("File");
        const SourceRange place = file && file->range.known() ? file->range : spec.nameRange;
        const Result<std::string> name = cleanLogName(logFileName(spec));
        if (!name) {
            diagnostics.error(name.error().code, place, name.error().message);
            continue;
        }
        const auto [writer, isNew] = writers.emplace(name.value(), &spec);
        if (isNew) continue;
        diagnostics.error(Code::DuplicateName, place, "two logs write the file " + name.value())
            .notes.emplace_back("the first one", writer->second->nameRange);
    }
}

void checkLogs(const ExperimentSpec& experiment, const Registry& registry, bool allKindsKnown, Diagnostics& diagnostics) {
    checkLogs(experiment, diagnostics);
    Diagnostics silent; // a run reports the reason
    if (allKindsKnown && isBuildable(experiment, silent))
        checkLogSignals(experiment, plannedLayout(experiment, registry), diagnostics);
}

void checkLogSignals(const ExperimentSpec& experiment, const SignalLayout& layout, Diagnostics& diagnostics) {
    for (const ComponentSpec& spec : experiment.logs)
        if (spec.find("Signals")) (void)chooseSignals(spec, layout, diagnostics);
}

} // namespace trundle
