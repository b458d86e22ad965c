#include "run/logs/log_kinds.h"

#include <algorithm>
#include <map>
#include <set>

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
    std::unique_ptr<RunLog> (*make)(const ComponentSpec&, const World&, Diagnostics&);
    bool needsSimulation;
};

template <class T> Kind logKind(std::string name) { return kindOf<T>(std::move(name), Role::Log, {"", "Repeat", "Ring"}, true); }

constexpr LogKind kLogKinds[] = {
    {"PoseLog", logKind<PoseLogSettings>, makePoseLog, false},
    {"SignalLog", logKind<SignalLogSettings>, makeSignalLog, false},
    {"ContactLog", logKind<ContactLogSettings>, makeContactLog, true},
    {"EnergyLog", logKind<EnergyLogSettings>, makeEnergyLog, true},
    {"FrameLog", logKind<FrameLogSettings>, makeFrameLog, false},
    {"RadioLog", logKind<RadioLogSettings>, makeRadioLog, true},
    {"LinkMatrix", logKind<LinkMatrixSettings>, makeLinkMatrix, true},
};

} // namespace

Status addLogKinds(Registry& registry) {
    for (const LogKind& log : kLogKinds)
        if (Status added = registry.add(log.kind(log.name)); !added) return added;
    return {};
}

std::unique_ptr<RunLog> makeLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    for (const LogKind& log : kLogKinds)
        if (spec.kind == log.name) return log.make(spec, world, diagnostics);
    return nullptr; // not reached: the resolver rejects unknown kinds
}

bool needsSimulation(const ComponentSpec& spec) {
    return std::ranges::any_of(kLogKinds, [&](const LogKind& log) { return spec.kind == log.name && log.needsSimulation; });
}

std::string logFileName(const ComponentSpec& spec) {
    return spec.text("File", spec.name + (spec.text("Format") == "pcap" ? ".pcap" : ".csv"));
}

namespace {

/// Calls `check` for each log; of the members of a Repeat, which have one block, none after the first that has an error.
template <class Check> void eachLog(const ExperimentSpec& experiment, const Diagnostics& diagnostics, const Check& check) {
    std::set<std::pair<FileId, std::uint32_t>> faulty;
    for (const ComponentSpec& spec : experiment.logs) {
        const std::pair block{spec.nameRange.file, spec.nameRange.range.begin};
        if (faulty.contains(block)) continue;
        const std::size_t errors = diagnostics.errorCount();
        check(spec);
        if (diagnostics.errorCount() > errors && spec.nameRange.known()) faulty.insert(block);
    }
}

using Writers = std::map<std::string, const ComponentSpec*>; // by the names of their files

/// The log whose file has the name of a folder of the file `name`, or the other way round; end(): no such log.
Writers::const_iterator nestedWriter(const Writers& writers, const std::string& name) {
    for (std::size_t end = name.find('/'); end != std::string::npos; end = name.find('/', end + 1))
        if (const auto outer = writers.find(name.substr(0, end)); outer != writers.end()) return outer;
    const std::string inFolder = name + "/";
    const auto inner = writers.lower_bound(inFolder);
    return inner != writers.end() && inner->first.starts_with(inFolder) ? inner : writers.end();
}

} // namespace

void checkLogs(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    Writers writers;
    eachLog(experiment, diagnostics, [&](const ComponentSpec& spec) {
        if (spec.find("Robot")) (void)chooseRobots(spec, experiment.robots, diagnostics);
        const ResolvedValue* file = spec.find("File");
        const SourceRange place = file && file->range.known() ? file->range : spec.nameRange;
        const Result<std::string> name = cleanLogName(logFileName(spec));
        if (!name) return (void)diagnostics.error(name.error().code, place, name.error().message);
        const auto nested = nestedWriter(writers, name.value());
        if (nested != writers.end()) {
            const auto& [outer, inner] = std::minmax(nested->first, name.value());
            diagnostics.error(Code::DuplicateName, place, outer + " cannot be both a log file and the folder of " + inner)
                .notes.emplace_back("the first one", nested->second->nameRange);
        }
        const auto [writer, isNew] = writers.emplace(name.value(), &spec);
        if (isNew) return;
        diagnostics.error(Code::DuplicateName, place, "two logs write the file " + name.value())
            .notes.emplace_back("the first one", writer->second->nameRange);
    });
}

void checkLogs(const ExperimentSpec& experiment, const Registry& registry, bool allKindsKnown, Diagnostics& diagnostics) {
    checkLogs(experiment, diagnostics);
    Diagnostics silent; // a run reports the reason
    if (allKindsKnown && isBuildable(experiment, silent))
        checkLogSignals(experiment, plannedLayout(experiment, registry), diagnostics);
}

void checkLogSignals(const ExperimentSpec& experiment, const SignalLayout& layout, Diagnostics& diagnostics) {
    eachLog(experiment, diagnostics, [&](const ComponentSpec& spec) {
        if (spec.find("Signals")) (void)chooseSignals(spec, layout, diagnostics);
    });
}

} // namespace trundle
