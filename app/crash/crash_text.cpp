#include "crash/crash_text.h"

#include <cstring>

namespace trundle {

const CallTarget* moduleCall(const CallMonitor* calls) {
    const CallTarget* target = calls ? calls->target() : nullptr;
    return target && (!target->kind.empty() || !target->module.empty()) ? target : nullptr;
}

bool isInSolver(const CallMonitor* calls) {
    const CallTarget* target = calls ? calls->target() : nullptr;
    return target && target->kind.empty() && target->module.empty();
}

const CallTarget* crashSite(const CrashedRun& run, const CrashCause& cause) {
    return cause.onRunsThread ? moduleCall(run.calls) : nullptr;
}

void addTarget(MessageBuilder& words, const CallTarget& target) {
    words << target.text.c_str();
    if (!target.module.empty() && !target.kind.empty()) words << " (" << target.module.c_str() << ")";
}

void addPhase(MessageBuilder& words, const CallMonitor& calls) {
    const char* doing = calls.doing();
    if (std::strcmp(doing, "load") == 0) words << " while it was loaded and described";
    else if (std::strcmp(doing, "unload") == 0) words << " while it was unloaded";
    else words << " in " << doing;
}

void addTime(MessageBuilder& words, const CrashedRun& run) {
    if (run.simulates) words << " at t = " << run.calls->time() << " s";
}

namespace {

void addThread(MessageBuilder& words, const CrashCause& cause) {
    words << "a thread of ";
    if (cause.threadOf) addTarget(words, *cause.threadOf);
    else words << "no known module";
}

} // namespace

void addCrash(MessageBuilder& words, const CrashedRun& run, const CrashCause& cause) {
    const CallTarget* target = crashSite(run, cause);
    if (target) {
        addTarget(words, *target);
        words << " crashed";
        addPhase(words, *run.calls);
    } else {
        words << "crashed in the middle of the " << run.activity;
    }
    addTime(words, run);
    words << ": " << crashName(cause.signal);
    if (target) return;
    if (!cause.onRunsThread) {
        words << ", in ";
        return addThread(words, cause);
    }
    words << (isInSolver(run.calls)
                  ? ", in the solver; the fault is the program's own, or damage that code of a module did before"
                  : "; the fault is the program's own, or damage that code of a module did before");
}

void addExit(MessageBuilder& words, const CrashedRun& run, const CrashCause& cause) {
    if (const CallTarget* target = crashSite(run, cause)) {
        addTarget(words, *target);
        words << " ended the program";
        addPhase(words, *run.calls);
    } else {
        if (!cause.onRunsThread && cause.threadOf) addThread(words, cause);
        else words << "code of a module";
        words << " ended the program in the middle of the " << run.activity;
    }
    addTime(words, run);
    words << ", by exit() or the like";
}

} // namespace trundle
