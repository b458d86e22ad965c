#include "host/host_worker.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include <sys/syscall.h>
#include <unistd.h>

#include "control/kinds_json.h"
#include "control/python_kinds.h"
#include "crash/exit_hook.h"
#include "host/crash_recorder.h"
#include "host/throw_recorder.h"

namespace trundle {
namespace {

long thisThread() { return ::syscall(SYS_gettid); }

} // namespace

HostWorker::HostWorker(ControlPage& page, int sensors, int commands)
    : MessageLink(page, Turn::Host), m_sensorFile(sensors), m_commandFile(commands), m_thread(thisThread()) {}

// ---- messages ----

bool HostWorker::awaitTurn() {
    if (pollTurn()) return true;
    while (!hasTurn()) sleepForTurn(-1);
    return true;
}

std::string HostWorker::receive() {
    std::string message;
    for (bool more = true; more;) {
        (void)receivePart(message, more);
        if (more) askForMore();
    }
    return message;
}

void HostWorker::record(HostRecord kind, std::uint32_t controller, std::string_view bytes) {
    if (thisThread() != m_thread) {
        m_ignoredOf = controller;
        return;
    }
    const RecordHeader header{static_cast<std::uint32_t>(kind), controller, bytes.size()};
    (void)append({reinterpret_cast<const char*>(&header), sizeof header});
    (void)append(bytes);
}

std::string HostWorker::ask(HostRecord kind, std::uint32_t controller, std::string_view bytes) {
    if (thisThread() != m_thread) {
        m_ignoredOf = controller;
        return {};
    }
    record(kind, controller, bytes);
    finishMessage();
    return receive();
}

void HostWorker::done(const Status& status, std::string_view more) {
    std::fflush(nullptr); // what a module has printed
    reportIgnored();
    WireWriter out;
    out.status(status);
    if (status) out.bytes(more);
    else out.numbers(lastThrow());
    m_page.phase = static_cast<std::uint32_t>(HostPhase::None);
    record(HostRecord::Done, 0, out.view());
    finishMessage();
}

void HostWorker::reportIgnored() {
    const std::int64_t controller = m_ignoredOf.exchange(kNone);
    if (controller == kNone || std::exchange(m_saidIgnored, true)) return;
    constexpr const char* kText = "print(), logs, cameras and radios work in setup() and update() alone: what other threads of the "
                                  "module ask for is ignored";
    record(HostRecord::Print, static_cast<std::uint32_t>(controller),
           WireWriter().number<std::int32_t>(TRUNDLE_WARNING).bytes(kText).view());
}

void HostWorker::run() {
    for (;;) {
        const std::string message = receive();
        WireReader in(message);
        handle(static_cast<HostRequest>(in.number<std::uint32_t>()), in);
    }
}

void HostWorker::handle(HostRequest request, WireReader& in) {
    switch (request) {
    case HostRequest::Load: return load(in.text());
    case HostRequest::Map: return map();
    case HostRequest::Start: return start(in);
    case HostRequest::Update: return update(in);
    case HostRequest::Set: return set(in);
    case HostRequest::Stop: return stop(in.number<std::uint32_t>());
    case HostRequest::Unload: return unload();
    case HostRequest::SaveState: return saveState(in.number<std::uint32_t>());
    case HostRequest::LoadState: return loadState(in);
    case HostRequest::StartDevice:
    case HostRequest::Act:
    case HostRequest::Sense: return done(Error{Code::Internal, "devices of a library run in the program itself"});
    }
}

// ---- requests ----

void HostWorker::enter(HostPhase phase, std::uint32_t controller) {
    forgetThrow();
    m_page.controller = controller;
    m_page.phase = static_cast<std::uint32_t>(phase);
}

void HostWorker::load(const std::string& library) {
    enter(HostPhase::Load, ~0u);
    if (isPythonModule(library)) // startPython() has failed
        return done(Error{Code::PythonModule, library + " needs the program python3, which cannot be run; install Python 3"});
    m_store = std::make_unique<ModuleStore>(m_calls);
    const auto module = m_store->load(library);
    if (!module) return done(module.error());
    setModuleCode(module.value()->code);
    done({}, kindsToJson(module.value()->kinds));
}

void HostWorker::map() {
    auto sensors = SharedSegment::map(m_sensorFile, false), commands = SharedSegment::map(m_commandFile, true);
    if (!sensors) return done(sensors.error());
    if (!commands) return done(commands.error());
    m_sensors = std::move(sensors).value();
    m_commands = std::move(commands).value();
    setSensorImage(m_sensors.data(), m_sensors.bytes());
    done({});
}

void HostWorker::start(WireReader& in) {
    const auto number = in.number<std::uint32_t>();
    enter(HostPhase::Setup, number);
    Controller& controller = m_controllers[number];
    controller.instance.reset();
    controller.record = readControllerRecord(in);
    const std::string& kind = controller.record.robot.controllers[controller.record.controller].kind;
    const TrundleKind* code = m_store->find(kind, TRUNDLE_CONTROLLER);
    if (!code) return done(Error{Code::KindNotLoaded, "the controller " + kind + " is not in the module"});
    controller.target = m_calls->add({"the controller " + kind, controller.record.robot.name, kind, {}, 0});
    controller.radios = std::make_shared<HostRadios>(*this, number);
    controller.instance = std::make_unique<ControllerInstance>(controller.record.robot, controller.record.controller,
                                                               controller.record.settings, *code);
    const MonitoredCall call(*m_calls, controller.target, "setup");
    const SlotImages images{static_cast<double*>(m_sensors.data()) + controller.record.offset,
                            static_cast<double*>(m_commands.data()) + controller.record.offset};
    const Status started =
        controller.instance->start(controller.record.layout, images, makeHostOutputs(*this, number, controller.radios));
    if (controller.instance->gaveUp()) forgetThrow();
    done(started);
}

void HostWorker::update(WireReader& in) {
    using Clock = std::chrono::steady_clock;
    const auto tick = in.number<std::uint64_t>();
    const auto time = in.number<double>();
    for (std::uint64_t left = in.count(); left > 0; --left) {
        const auto number = in.number<std::uint32_t>();
        const auto sinceLast = in.number<double>();
        const auto radios = in.numbers<std::uint32_t>();
        const auto pending = in.numbers<std::uint64_t>();
        const auto found = m_controllers.find(number);
        if (found == m_controllers.end() || !found->second.instance) continue;
        Controller& controller = found->second;
        for (std::size_t i = 0; i < radios.size() && i < pending.size(); ++i) controller.radios->setPending(radios[i], pending[i]);
        enter(HostPhase::Update, number);
        const Clock::time_point begin = Clock::now();
        Status updated;
        {
            const MonitoredCall call(*m_calls, controller.target, "update");
            updated = controller.instance->tick(tick, time, sinceLast);
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        const bool threw = !updated && !controller.instance->gaveUp();
        WireWriter out;
        out.status(updated).number<std::uint8_t>(controller.instance->gaveUp()).number(seconds).bytes({}); // of Python: the calls
        out.numbers(threw ? lastThrow() : std::vector<std::uint64_t>());
        record(HostRecord::Updated, number, out.view());
    }
    done({});
}

void HostWorker::set(WireReader& in) {
    const auto number = in.number<std::uint32_t>();
    const std::string property = in.text();
    const auto found = m_controllers.find(number);
    if (found == m_controllers.end() || !found->second.instance) return done(Error{Code::Internal, "no such controller"});
    enter(HostPhase::Set, number);
    const MonitoredCall call(*m_calls, found->second.target, "set");
    done(found->second.instance->set(property, in.value()));
}

void HostWorker::saveState(std::uint32_t number) {
    const auto found = m_controllers.find(number);
    if (found == m_controllers.end() || !found->second.instance) return done({});
    enter(HostPhase::SaveState, number);
    const MonitoredCall call(*m_calls, found->second.target, "saveState");
    const Result<std::string> state = found->second.instance->saveState();
    if (!state) return done(state.error());
    done({}, state.value());
}

void HostWorker::loadState(WireReader& in) {
    const auto number = in.number<std::uint32_t>();
    const auto found = m_controllers.find(number);
    if (found == m_controllers.end() || !found->second.instance) return done(Error{Code::Internal, "no such controller"});
    enter(HostPhase::LoadState, number);
    const MonitoredCall call(*m_calls, found->second.target, "loadState");
    done(found->second.instance->loadState(in.bytes()));
}

void HostWorker::stop(std::uint32_t number) {
    enter(HostPhase::Destructor, number);
    if (const auto found = m_controllers.find(number); found != m_controllers.end()) {
        const MonitoredCall call(*m_calls, found->second.target, "destructor");
        found->second.instance.reset();
    }
    done({});
}

void HostWorker::unload() {
    enter(HostPhase::Unload, ~0u);
    m_controllers.clear();
    m_store.reset();
    done({});
}

} // namespace trundle
