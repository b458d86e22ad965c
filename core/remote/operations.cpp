#include "remote/operations.h"

#include <algorithm>

#include "run/logs/log_choice.h"
#include "run/schedule.h"

namespace trundle {

using Json = nlohmann::ordered_json;

namespace {

const char* errorName(Code code) {
    if (code == Code::NoSuchPath) return "no_such_path";
    if (code == Code::Conflict) return "owned";
    return "refused";
}

} // namespace

Reply Reply::failed(std::string error, std::string message) {
    Reply reply;
    reply.error = std::move(error);
    reply.message = std::move(message);
    return reply;
}

Reply Reply::of(const Status& status) { return status ? Reply() : failed(errorName(status.error().code), status.error().message); }

std::optional<Reply> RequestContext::mistake() const {
    std::string problem = arguments.problem();
    if (problem.empty()) return std::nullopt;
    return Reply::failed("bad_request", std::move(problem));
}

double timeOf(ServedRun& run) { return tickTime(run.world().ticks(), run.world().experiment().settings.tick); }

Json stateOf(ServedRun& run) {
    Json state;
    state["tick"] = run.exists() ? run.world().ticks() : 0;
    state["time"] = run.exists() ? timeOf(run) : 0.0;
    state["state"] = run.state() == ServedState::Running ? "running" : run.state() == ServedState::Paused ? "paused" : "ended";
    if (run.state() == ServedState::Ended) state["reason"] = run.endReason();
    else if (run.isAtDuration()) state["reason"] = "the Duration of the text is reached";
    if (const Diagnostic* failure = run.failure()) state["diagnostics"] = problemsJson({*failure}, run.built().sources);
    return state;
}

Json statusOf(ServedRun& run) {
    Json status = stateOf(run);
    if (!run.exists()) return status;
    const SettingsSpec& settings = run.world().experiment().settings;
    status["tick_s"] = settings.tick;
    status["duration_s"] = settings.duration;
    status["seed"] = settings.seed;
    status["speed"] = run.speed();
    status["layout"] = hashDigits(run.world().layout().hash());
    Json stopped = Json::array();
    for (const StoppedController& each : run.runner().stoppedControllers())
        stopped.push_back({{"robot", run.world().experiment().robots[each.robot].name},
                           {"controller", each.controller},
                           {"time", each.time}, {"reason", each.fault.reason}});
    status["stopped"] = std::move(stopped);
    Json ended = Json::array();
    for (const auto& [robot, fault] : run.world().robotFaults().ends)
        ended.push_back({{"robot", run.world().experiment().robots[robot].name},
                         {"body", fault.body},
                         {"reason", fault.reason},
                         {"time", nearestTickTime(fault.time, settings.tick)}});
    status["ended"] = std::move(ended);
    return status;
}

void bindSignals(Subscription& subscription, const SignalLayout& layout) {
    subscription.entries.clear();
    for (const SignalEntry& entry : layout.entries())
        if (std::ranges::any_of(subscription.patterns, [&](const std::string& p) { return matchesWildcard(p, entry.path); }))
            subscription.entries.push_back(entry);
}

} // namespace trundle
