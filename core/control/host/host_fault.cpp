#include "control/host/host_fault.h"

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/platform/crash_name.h"
#include "control/host/python_report.h"
#include "control/host/symbolizer.h"

namespace trundle {
namespace {

std::string signalText(int signal) {
    if (const char* crash = crashName(signal)) return crash;
    if (signal == SIGXFSZ) return "a file grew too large";
    const char* name = ::sigabbrev_np(signal);
    return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

std::string fileName(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string seconds(double value) {
    const auto tenths = std::to_string(std::lround(value * 10));
    return tenths.size() < 2 ? "0." + tenths : tenths.substr(0, tenths.size() - 1) + "." + tenths.back();
}

std::string ending(const HostEnd& end) {
    const std::string in = std::string(" in ") + phaseName(end.during.phase);
    switch (end.cause) {
    case HostEnd::Cause::Crash:
        if (end.ofSensorImage) return " wrote to a sensor value" + in + ", which only the simulation may set";
        return " crashed" + in + ": " + signalText(end.code);
    case HostEnd::Cause::Exit:
        return " ended its process" + in + (end.code < 0 ? ", by exit() or the like" : " with exit code " + std::to_string(end.code));
    case HostEnd::Cause::Killed: return " ended its process" + in + ": " + signalText(end.code);
    case HostEnd::Cause::NotResponding: return " did not return from " + std::string(phaseName(end.during.phase)) + " within " +
                                               seconds(end.limitS) + " s" + (end.afterRequest ? " of the request to end" : "") +
                                               " and was stopped";
    case HostEnd::Cause::Damaged: return " damaged the messages of its process" + in + " and was stopped";
    }
    return {};
}

} // namespace

const char* phaseName(HostPhase phase) {
    switch (phase) {
    case HostPhase::Load: return "load";
    case HostPhase::Setup: return "setup";
    case HostPhase::Update: return "update";
    case HostPhase::Set: return "set";
    case HostPhase::Destructor: return "destructor";
    case HostPhase::Unload: return "unload";
    case HostPhase::SaveState: return "saveState";
    case HostPhase::LoadState: return "loadState";
    case HostPhase::Act: return "act";
    case HostPhase::Sense: return "sense";
    case HostPhase::None: break;
    }
    return "the middle of the run";
}

namespace {

void setPlace(ControllerFault& fault, const std::vector<SourceFrame>& frames) {
    fault.backtrace = backtraceOf(frames);
    if (const SourceFrame* own = ownFrame(frames)) fault.place = {own->file, own->line};
}

/// Also adds ", in act() at zoo.cpp:316" to the reason.
void addPlace(ControllerFault& fault, const std::vector<SourceFrame>& frames) {
    setPlace(fault, frames);
    if (const SourceFrame* own = ownFrame(frames))
        fault.reason += ", in " + own->function + " at " + fileName(own->file) + ":" + std::to_string(own->line);
}

} // namespace

ControllerFault faultOf(const HostEnd& end, const std::string& controller, const std::string& library) {
    ControllerFault fault;
    const std::string module = "the module " + library;
    if (!controller.empty()) fault.reason = controller + " (" + library + ")";
    else fault.reason = end.ofThread ? "a thread of " + module : module;
    fault.reason += ending(end);
    if (!end.exception.empty()) fault.reason += ", uncaught exception: " + end.exception;
    addPlace(fault, end.report.empty() ? symbolize(library, end.frames) : framesOfPython(end.report));
    return fault;
}

ControllerFault faultOfException(std::string reason, const std::string& report, const std::vector<std::uint64_t>& thrown,
                                 const std::string& library) {
    ControllerFault fault;
    fault.reason = std::move(reason);
    if (thrown.empty()) {
        setPlace(fault, framesOfPython(report));
        return fault;
    }
    std::vector<std::pair<std::uint32_t, std::uint64_t>> addresses;
    for (const std::uint64_t offset : thrown) addresses.emplace_back(0, offset);
    addPlace(fault, symbolize(library, addresses));
    return fault;
}

ControllerFault sharedFault(const ControllerFault& own, const std::string& controller, const std::string& faultyRobot) {
    return {controller + " shares its process with that of " + faultyRobot +
                ": " + own.reason + ". Isolation = robot gives each a process",
            {},
            own.process,
            false};
}

Error errorOfLoading(Code code, const HostEnd& end, const std::string& library) {
    ControllerFault fault = faultOf(end, {}, library);
    return {code, fault.reason.substr(std::string_view("the module ").size()), std::move(fault.place)};
}

} // namespace trundle
