#include "cli/early_end.h"

#include <csignal>
#include <cstring>
#include <ctime>

#include <sys/resource.h>

#include "base/codes.h"
#include "cli/exit_code.h"
#include "cli/signal_text.h"
#include "cli/standard_streams.h"

namespace trundle {
namespace {

/// The module code being called; nullptr while the solver or nothing of a module runs.
const CallTarget* moduleCall(const EarlyEndFacts& facts) {
    const CallTarget* target = facts.calls ? facts.calls->target() : nullptr;
    return target && (!target->kind.empty() || !target->module.empty()) ? target : nullptr;
}

bool isInSolver(const EarlyEndFacts& facts) {
    const CallTarget* target = facts.calls ? facts.calls->target() : nullptr;
    return target && target->kind.empty() && target->module.empty();
}

/// The module call at fault; a crash in another thread is not caused by the run thread's call.
const CallTarget* crashSite(const EarlyEndFacts& facts, const EarlyEnd& end) {
    return end.onRunsThread ? moduleCall(facts) : nullptr;
}

double secondsSince(double startS) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - startS;
}

/// Writes the message in parts, either to the terminal or into a JSON string.
class MessageBuilder {
public:
    MessageBuilder(SignalText& out, bool json) : m_out(out), m_json(json) {}
    MessageBuilder& operator<<(const char* text) {
        m_out.addClean(text, m_json);
        return *this;
    }
    MessageBuilder& operator<<(double number) {
        m_out.add(number);
        return *this;
    }

private:
    SignalText& m_out;
    bool m_json;
};

void addTarget(MessageBuilder& words, const CallTarget& target) {
    words << target.text.c_str();
    if (!target.module.empty() && !target.kind.empty()) words << " (" << target.module.c_str() << ")";
}

void addTime(MessageBuilder& words, const EarlyEndFacts& facts) {
    if (facts.simulates) words << " at t = " << facts.calls->time() << " s";
}

/// " crashed in update", " crashed while it was loaded and described"
void addPhase(MessageBuilder& words, const EarlyEndFacts& facts) {
    const char* doing = facts.calls->doing();
    if (std::strcmp(doing, "load") == 0) words << " while it was loaded and described";
    else if (std::strcmp(doing, "unload") == 0) words << " while it was unloaded";
    else words << " in " << doing;
}

void addCrash(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    if (const CallTarget* target = crashSite(facts, end)) {
        addTarget(words, *target);
        words << " crashed";
        addPhase(words, facts);
    } else {
        words << "crashed in the middle of the " << facts.activity;
    }
    addTime(words, facts);
    words << ": " << crashName(end.signal);
    if (crashSite(facts, end)) return;
    if (!end.onRunsThread) {
        words << ", in a thread of ";
        if (end.threadOf) addTarget(words, *end.threadOf);
        else words << "no known module";
        return;
    }
    words << (isInSolver(facts) ? ", in the solver; the fault is the program's own, or damage that code of a module did before"
                                 : "; the fault is the program's own, or damage that code of a module did before");
}

void addExit(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    if (const CallTarget* target = crashSite(facts, end)) {
        addTarget(words, *target);
        words << " ended the program";
        addPhase(words, facts);
    } else {
        words << "code of a module ended the program in the middle of the " << facts.activity;
    }
    addTime(words, facts);
    words << ", by exit() or the like";
}

void addNotResponding(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const double waited = end.waitedS;
    if (const CallTarget* target = moduleCall(facts)) {
        addTarget(words, *target);
        words << " is not responding";
        addPhase(words, facts);
        addTime(words, facts);
        words << ": it did not return within " << waited << " s of the request to end";
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
    const CallTarget* target = moduleCall(facts);
    if (!target) return;
    words << ", while waiting for ";
    addTarget(words, *target);
}

void addText(MessageBuilder& words, const EarlyEndFacts& facts, const EarlyEnd& end) {
    switch (end.kind) {
    case EarlyEndKind::Crash: return addCrash(words, facts, end);
    case EarlyEndKind::Exit: return addExit(words, facts, end);
    case EarlyEndKind::NotResponding: return addNotResponding(words, facts, end);
    case EarlyEndKind::Interrupted: return addInterrupted(words, facts);
    }
}

/// {"robot", "kind", "module", "during", "reason"}
void addWhere(SignalText& out, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const CallTarget* target = crashSite(facts, end);
    const char* body = target ? nullptr : facts.calls->clusterBody();
    out.add("{\"robot\": ").addJson(target ? target->robot.c_str() : nullptr);
    out.add(", \"kind\": ").addJson(target ? target->kind.c_str() : nullptr);
    const CallTarget* owner = target ? target : end.threadOf;
    out.add(", \"module\": ").addJson(owner ? owner->module.c_str() : nullptr);
    const char* during = target ? facts.calls->doing() : !end.onRunsThread ? "thread" : isInSolver(facts) ? "solver" : nullptr;
    out.add(", \"during\": ").addJson(during);
    if (end.kind == EarlyEndKind::NotResponding && isInSolver(facts)) {
        out.add(", \"contacts\": ").add(static_cast<std::uint64_t>(facts.calls->clusterContacts()));
        out.add(", \"body\": ").addJson(body);
    }
    out.add(", \"reason\": ")
        .addJson(end.kind == EarlyEndKind::Crash  ? crashName(end.signal)
                 : end.kind == EarlyEndKind::Exit ? "exit"
                                                  : "not responding");
    out.add("}");
}

/// Writes the usual keys with the values available in the middle of a tick.
void addMiddle(SignalText& out, const EarlyEndFacts& facts, const EarlyEnd& end) {
    const double wall = secondsSince(facts.startS), simulated = facts.calls->time();
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    out.add("{\n  \"ticks\": ").add(facts.calls->ticks());
    out.add(",\n  \"simulated_s\": ").add(simulated);
    out.add(",\n  \"wall_s\": ").add(wall);
    out.add(",\n  \"real_time_factor\": ").add(wall > 0 ? simulated / wall : 0);
    out.add(",\n  \"peak_memory_kb\": ").add(static_cast<std::uint64_t>(used.ru_maxrss));
    out.add(",\n  \"state_hash\": null,\n  \"quick_ticks\": null,\n  \"rescued_ticks\": null,\n  \"finished\": null,\n  "
            "\"interrupted\": ");
    out.add(end.kind == EarlyEndKind::NotResponding || end.kind == EarlyEndKind::Interrupted ? "true" : "false");
    out.add(",\n  \"robots\": {");
    const EarlyPoses* poses = facts.poses.load();
    if (poses) out.add(poses->members.data(), poses->members.size());
    out.add("},\n  \"objects\": null,\n  \"robots_time_s\": ");
    if (poses) out.add(poses->timeS);
    else out.add("null");
    out.add(",\n  \"diagnostics\": [");
    if (const std::string* before = facts.diagnostics.load(); before && !before->empty())
        out.add(before->data(), before->size()).add(",");
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

void printJson(const EarlyEndFacts& facts, const EarlyEnd& end) {
    SignalText out(resultsFile());
    const std::string* results = facts.results.load();
    if (results) out.add(results->data(), results->size());
    else addMiddle(out, facts, end);
    if (end.kind != EarlyEndKind::Interrupted) {
        out.add(end.kind == EarlyEndKind::NotResponding ? ",\n  \"not_responding\": " : ",\n  \"crashed\": ");
        addWhere(out, facts, end);
    }
    out.add("\n}\n");
}

} // namespace

const char* crashName(int signal) noexcept {
    switch (signal) {
    case SIGSEGV: return "Segmentation fault";
    case SIGBUS: return "Bus error";
    case SIGFPE: return "Arithmetic exception";
    case SIGILL: return "Illegal instruction";
    case SIGABRT: return "Aborted";
    case SIGTRAP: return "Trap";
    case SIGSYS: return "Bad system call";
    default: return "Killed by a signal";
    }
}

int exitCodeOf(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept {
    if (end.kind == EarlyEndKind::Interrupted) return kExitInterrupted;
    if (end.kind == EarlyEndKind::NotResponding) return moduleCall(facts) ? kExitController : kExitInterrupted;
    const bool own = end.kind == EarlyEndKind::Crash && end.onRunsThread && !moduleCall(facts);
    return own ? 128 + end.signal : kExitController;
}

void reportEarlyEnd(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept {
    {
        SignalText out(messagesFile());
        out.add(facts.terminal ? "\r\033[K" : "").add("trundle-cli: ");
        MessageBuilder words(out, false);
        addText(words, facts, end);
        out.add("\n");
    }
    if (facts.json) printJson(facts, end);
}

} // namespace trundle
