#include "cli/early_end.h"

#include <ctime>

#include <sys/resource.h>

#include "base/codes.h"
#include "cli/exit_code.h"
#include "cli/standard_streams.h"
#include "crash/last_steps.h"
#include "crash/signal_text.h"

namespace trundle {
namespace {

double secondsSince(double startS) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - startS;
}

void addNotResponding(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const double waited = end.waitedS;
    if (const CallTarget* target = moduleCall(facts.calls)) {
        addTarget(words, *target);
        words << " is not responding";
        addPhase(words, *facts.calls);
        addTime(words, facts);
        words << ": it did not return within " << waited << " s of the request to end";
        return;
    }
    if (!facts.calls) {
        words << "code of a module is not responding";
        return;
    }
    words << "one step of the solver";
    addTime(words, facts);
    words << " did not end within " << waited << " s of the request to end: ";
    words << static_cast<double>(facts.calls->clusterContacts()) << " contacts";
    if (const char* body = facts.calls->clusterBody()) words << " hang together, among them those of " << body;
}

void addInterrupted(MessageBuilder& words, const EarlyEndFacts& facts) {
    words << "interrupted: ended at once";
    const CallTarget* target = moduleCall(facts.calls);
    if (!target) return;
    words << ", while waiting for ";
    addTarget(words, *target);
}

void addText(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    switch (end.kind) {
    case EarlyEndKind::Crash: return addCrash(words, facts, end.cause);
    case EarlyEndKind::Exit: return addExit(words, facts, end.cause);
    case EarlyEndKind::NotResponding: return addNotResponding(words, facts, end);
    case EarlyEndKind::Interrupted: return addInterrupted(words, facts);
    }
}

/// {"robot", "kind", "module", "during", "reason"}
void addWhere(SignalText& out, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const CallTarget* target = crashSite(facts, end.cause);
    const char* body = target || !facts.calls ? nullptr : facts.calls->clusterBody();
    out.add("{\"robot\": ").addJson(target ? target->robot.c_str() : nullptr);
    out.add(", \"kind\": ").addJson(target ? target->kind.c_str() : nullptr);
    const CallTarget* owner = target ? target : end.cause.threadOf;
    out.add(", \"module\": ").addJson(owner ? owner->module.c_str() : nullptr);
    const char* during = target                    ? facts.calls->doing()
                         : !end.cause.onRunsThread ? "thread"
                         : isInSolver(facts.calls) ? "solver"
                                                   : nullptr;
    out.add(", \"during\": ").addJson(during);
    if (end.kind == EarlyEndKind::NotResponding && isInSolver(facts.calls)) {
        out.add(", \"contacts\": ").add(static_cast<std::uint64_t>(facts.calls->clusterContacts()));
        out.add(", \"body\": ").addJson(body);
    }
    out.add(", \"reason\": ")
        .addJson(end.kind == EarlyEndKind::Crash  ? crashName(end.cause.signal)
                 : end.kind == EarlyEndKind::Exit ? "exit"
                                                  : "not responding");
    out.add("}");
}

void addText(SignalText& out, const KeptText& kept) { out.add(kept.text().data(), kept.text().size()); }

/// Writes the usual keys with the values available in the middle of a tick.
void addMiddle(SignalText& out, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const double wall = secondsSince(facts.startS), simulated = facts.calls ? facts.calls->time() : 0;
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    out.add("{\n  \"ticks\": ");
    if (facts.calls) out.add(facts.calls->ticks()).add(",\n  \"simulated_s\": ").add(simulated);
    else out.add("null,\n  \"simulated_s\": null");
    out.add(",\n  \"wall_s\": ").add(wall);
    out.add(",\n  \"real_time_factor\": ").add(wall > 0 ? simulated / wall : 0);
    out.add(",\n  \"peak_memory_kb\": ").add(static_cast<std::uint64_t>(used.ru_maxrss));
    out.add(",\n  \"engine\": null,\n  \"threads\": null,\n  \"state_hash\": null,\n  \"quick_ticks\": null,\n  "
            "\"rescued_ticks\": null,\n  \"finished\": null,\n  "
            "\"interrupted\": ");
    out.add(end.kind == EarlyEndKind::NotResponding || end.kind == EarlyEndKind::Interrupted ? "true" : "false");
    out.add(",\n  \"robots\": {");
    const EarlyPoses* poses = facts.poses.load();
    if (poses) addText(out, poses->members);
    out.add("},\n  \"objects\": null,\n  \"ended\": null,\n  \"stopped\": null,\n  \"robots_time_s\": ");
    if (poses) out.add(poses->timeS);
    else out.add("null");
    out.add(",\n  \"diagnostics\": [");
    if (const KeptText* before = facts.diagnostics.load(); before && !before->text().empty()) {
        addText(out, *before);
        out.add(",");
    }
    out.add("{\"file\": \"\", \"line\": 0, \"column\": 0, \"end_line\": 0, \"end_column\": 0, \"severity\": \"error\", \"code\": "
            "\"E");
    const int exit = exitCodeOf(facts, end);
    out.add(static_cast<std::uint64_t>(exit == kExitController    ? Code::ControllerFailed
                                       : exit == kExitInterrupted ? Code::Interrupted
                                                                  : Code::Internal));
    out.add("\", \"message\": \"");
    MessageBuilder words(out, true);
    addText(words, facts, end);
    out.add("\", \"suggestions\": [], \"fixes\": []}]");
}

void addObject(SignalText& out, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const KeptText* results = facts.results.load();
    if (results) addText(out, *results);
    else addMiddle(out, facts, end);
    if (end.kind != EarlyEndKind::Interrupted) {
        out.add(end.kind == EarlyEndKind::NotResponding ? ",\n  \"not_responding\": " : ",\n  \"crashed\": ");
        addWhere(out, facts, end);
    }
    out.add("\n}\n");
}

void printJson(const EarlyEndFacts& facts, const EarlyEnd& end) {
    Draft draft(resultsFile());
    {
        SignalText out(draft.file());
        addObject(out, facts, end);
    }
    draft.publish();
}

void printMessage(const EarlyEndFacts& facts, const EarlyEnd& end) {
    Draft draft(messagesFile());
    {
        SignalText out(draft.file());
        out.add(facts.terminal ? "\r\033[K" : "").add("trundle-cli: ");
        MessageBuilder words(out, false);
        addText(words, facts, end);
        out.add("\n");
    }
    draft.publish();
}

} // namespace

int exitCodeOf(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept {
    if (end.kind == EarlyEndKind::Interrupted) return kExitInterrupted;
    if (end.kind == EarlyEndKind::NotResponding) return moduleCall(facts.calls) ? kExitController : kExitInterrupted;
    const bool own = end.kind == EarlyEndKind::Crash && end.cause.onRunsThread && !facts.hasModules && !moduleCall(facts.calls);
    return own ? 128 + end.cause.signal : kExitController;
}

void reportEarlyEnd(EarlyEndFacts& facts, const EarlyEnd& end) noexcept {
    if (!facts.reported) printMessage(facts, end);
    facts.reported = true;
    if (facts.json) printJson(facts, end);
    facts.json = false;
}

} // namespace trundle
