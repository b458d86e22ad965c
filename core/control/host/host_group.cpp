// Method: before a request the values of the robots are copied into the host's images; afterwards only the slots that a controller
// may write, what it publishes and the commands that its ports have claimed, are copied back.
#include "control/host/host_group.h"

#include <algorithm>
#include <cmath>

#include "control/host/controller_record.h"
#include "control/host/host_fault.h"
#include "control/host/host_reply.h"
#include "control/kinds_json.h"

namespace trundle {
namespace {

constexpr double kLongestCallS = 10, kLongestEndS = 3, kShortestLimitS = 1, kBudgetFactor = 20, kSayAfterS = 1;

bool isEnd(HostPhase phase) { return phase == HostPhase::Destructor || phase == HostPhase::Unload; }

/// That of a Python file also has the times of its sources, which differ after each change.
bool isSameDescription(const std::string& a, const std::string& b, const std::string& library) {
    const Result<std::vector<Kind>> kinds = kindsFromJson(a, library), others = kindsFromJson(b, library);
    return kinds && others && kindsToJson(kinds.value()) == kindsToJson(others.value());
}

} // namespace

std::size_t HostGroup::add(std::shared_ptr<const RobotSpec> robot, std::size_t controller) {
    Member member;
    member.robot = std::move(robot);
    member.controller = &member.robot->controllers[controller];
    member.index = controller;
    m_members.push_back(std::move(member));
    return m_members.size() - 1;
}

HostGroup::~HostGroup() {
    if (!m_host || !m_host->alive()) return;
    (void)m_host->call(HostRequest::Unload, {}, [this](HostRecord record, std::uint32_t number, WireReader& in) {
        return handle(record, number, in);
    });
    m_waiting.reset();
}

// ---- the host ----

Status HostGroup::connect() {
    if (m_host && m_host->alive()) return {};
    m_host.reset();
    m_mapped = m_updating = false;
    m_kinds.reset();
    for (Member& member : m_members) member.started = false;
    auto host = startHost();
    if (!host) return host.error();
    m_host = std::move(host).value();
    return {};
}

Result<std::unique_ptr<HostConnection>> HostGroup::startHost() {
    m_saidWaiting = false;
    return HostConnection::start(m_context.programs, m_library, m_generation = ++m_context.generations,
                                 {[this](const HostCall& call) { return limitOf(call); },
                                  [this](const HostCall& call, double seconds) { showWaiting(call, seconds); },
                                  [this] { return m_context.calls->endAsked(); }});
}

Result<std::vector<Kind>> HostGroup::load() {
    if (const Status connected = connect(); !connected) return connected.error();
    if (m_kinds) return *m_kinds;
    Result<std::string> json = loadInto(*m_host);
    if (!json) return json.error();
    m_json = std::move(json).value();
    m_kinds = kindsFromJson(m_json, m_library);
    return *m_kinds;
}

/// Returns the kinds of the module, as JSON.
Result<std::string> HostGroup::loadInto(HostConnection& host) {
    m_done.reset();
    const bool alive = host.call(
        HostRequest::Load, WireWriter().bytes(m_library).view(),
        [this](HostRecord record, std::uint32_t number, WireReader& in) { return handle(record, number, in); });
    m_waiting.reset();
    if (!alive) return errorOfLoading(Code::ModuleUnreadable, host.end(), m_library);
    return *m_done ? Result<std::string>(std::exchange(m_more, {})) : m_done->error();
}

Status HostGroup::renew(std::uint64_t request) {
    if (std::exchange(m_renewal, request) != request) m_renewed = replaceHost();
    return m_renewed;
}

/// The old host goes on until the new one has loaded the module.
Status HostGroup::replaceHost() {
    auto host = startHost();
    if (!host) return host.error();
    const Result<std::string> json = loadInto(*host.value());
    if (!json) return json.error();
    if (!isSameDescription(json.value(), m_json, m_library))
        return Error{Code::ControllerFailed, m_library + " has other properties or published values now: reset the run to use it"};
    for (std::size_t i = 0; i < m_members.size(); ++i) stop(i);
    m_host = std::move(host).value();
    m_kinds = kindsFromJson(m_json, m_library);
    m_mapped = m_updating = false;
    return {};
}

/// Runs the destructors of its static objects, and its handlers of exit().
void HostGroup::unload(Member& last) {
    const bool alive = m_host->call(HostRequest::Unload, {}, [this](HostRecord record, std::uint32_t number, WireReader& in) {
        return handle(record, number, in);
    });
    m_waiting.reset();
    if (alive || m_host->end().ofThread) m_host.reset(); // a thread that outlives its controller crashes now that its code is gone
    else last.fault = faultOf(m_host->end(), {}, m_library);
}

Status HostGroup::map(const SignalLayout& layout) {
    if (m_mapped) return {};
    std::size_t slots = 0;
    for (Member& member : m_members) slots = member.slots.place(*member.robot, *member.controller, layout, slots);
    const Status mapped = m_host->map(
        slots, [this](HostRecord record, std::uint32_t number, WireReader& in) { return handle(record, number, in); });
    m_mapped = mapped.ok();
    return mapped;
}

void HostGroup::copyIn(const Member& member) { member.slots.copyIn(m_block->slots(), m_host->sensors(), m_host->commands()); }

void HostGroup::copyOut(const Member& member) { member.slots.copyOut(m_host->commands(), m_block->slots()); }

Status HostGroup::claim(Member& member, const std::string& command) {
    const auto entry = command.starts_with(member.robot->name + "/") ? m_layout->find(command) : std::nullopt;
    if (!entry || entry->direction != SignalDirection::Command) return Error{Code::UnknownPort, "there is no command " + command};
    const Status claimed = member.outputs.claim ? member.outputs.claim(command) : Status();
    if (claimed) member.slots.claim(*entry, m_block->slots(), m_host->commands());
    return claimed;
}

// ---- calls ----

Status HostGroup::call(std::size_t number, HostRequest request, std::string_view bytes) {
    Member& member = m_members[number];
    copyIn(member);
    m_done.reset();
    member.gaveUp.reset();
    const bool alive = m_host->call(request, bytes, [this](HostRecord record, std::uint32_t from, WireReader& in) {
        return handle(record, from, in);
    });
    m_waiting.reset();
    if (alive && m_done) {
        copyOut(member);
        passFinish(member);
        return withPlace(*m_done, member.outputs);
    }
    setFaults();
    if (!member.fault) return Error{Code::ControllerFailed, "its process has ended"};
    return Error{Code::ControllerFailed, member.fault->reason, member.fault->place};
}

/// The status of a request; of an exception in C++ with its place, the calls that led there are printed.
Status HostGroup::withPlace(const Status& status, const ControllerOutputs& outputs) const {
    if (status || m_thrown.empty()) return status;
    const ControllerFault fault = faultOfException(status.error().message, {}, m_thrown, m_library);
    for (const std::string& call : fault.backtrace)
        if (outputs.print) outputs.print(TRUNDLE_ERROR, "  " + call);
    return Error{status.error().code, fault.reason, fault.place};
}

Status HostGroup::start(std::size_t number, const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs) {
    m_layout = &layout;
    m_block = &block;
    m_members[number].fault.reset();
    if (const auto loaded = load(); !loaded) return loaded.error();
    if (const Status mapped = map(layout); !mapped) return mapped;
    Member& member = m_members[number];
    member.outputs = std::move(outputs);
    member.radios.clear();
    member.slots.forgetClaims();
    member.due.reset();
    member.result.reset();
    member.finish.reset();
    if (!member.target) {
        member.target = m_context.calls->add({controllerTitle(*member.robot, *member.controller), member.robot->name,
                                              member.controller->kind, m_library, robotIndex(member)});
    }
    WireWriter message;
    message.number(static_cast<std::uint32_t>(number));
    write(message, *member.robot, member.index, m_context.experiment->settings, layout.entriesOf(member.robot->name),
          member.slots.inImage());
    member.started = true;
    Status started = call(number, HostRequest::Start, message.view());
    member.started = started.ok();
    return started;
}

/// In the experiment.
std::uint32_t HostGroup::robotIndex(const Member& member) const {
    const auto& robots = m_context.experiment->robots;
    return static_cast<std::uint32_t>(std::ranges::find(robots, member.robot->name, &RobotSpec::name) - robots.begin());
}

void HostGroup::prepare(std::size_t number, std::uint64_t tick, double time, double sinceLast) {
    m_members[number].due = sinceLast;
    m_tick = tick;
    m_time = time;
    m_announced = true;
}

void HostGroup::beginUpdates() {
    if (!std::exchange(m_announced, false) || !m_host || !m_host->alive()) return;
    WireWriter message;
    message.number(m_tick).number(m_time);
    const auto due = std::ranges::count_if(m_members, [](const Member& member) { return member.due && member.started && !member.fault; });
    message.number(static_cast<std::uint64_t>(due));
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        Member& member = m_members[i];
        member.result.reset();
        member.gaveUp.reset();
        if (!member.due || !member.started || member.fault) continue;
        copyIn(member);
        message.number(static_cast<std::uint32_t>(i)).number(*member.due);
        std::vector<std::uint64_t> pending;
        for (const std::uint32_t radio : member.radios) pending.push_back(member.outputs.radios->pending(radio));
        message.numbers(member.radios).numbers(pending);
    }
    m_updating = m_host->begin(HostRequest::Update, message.view());
}

void HostGroup::completeUpdates() {
    m_updating = false;
    const bool alive = m_host->complete(
        [this](HostRecord record, std::uint32_t number, WireReader& in) { return handle(record, number, in); });
    m_waiting.reset();
    for (Member& member : m_members)
        if (std::exchange(member.due, {}) && member.result && alive) copyOut(member);
    if (!alive) setFaults();
}

void HostGroup::passFinish(Member& member) {
    if (const auto reason = std::exchange(member.finish, {}); reason && member.outputs.finish) member.outputs.finish(*reason);
}

Status HostGroup::update(std::size_t number, std::uint64_t tick, double time, double sinceLast) {
    Member& member = m_members[number];
    if (!member.started) return Error{Code::ControllerFailed, "the controller of " + member.robot->name + " was not started"};
    if (!m_updating && !member.result) {
        if (!member.due) prepare(number, tick, time, sinceLast);
        m_context.beginUpdates();
    }
    if (m_updating) completeUpdates();
    const std::optional<UpdateResult> result = std::exchange(member.result, {});
    if (member.fault) return Error{Code::ControllerFailed, member.fault->reason};
    if (!result) return Error{Code::ControllerFailed, "the process of " + member.robot->name + " gave no result"};
    member.seconds = result->seconds;
    passFinish(member);
    if (result->status || result->gaveUp) return result->status;
    // An exception: the host and its other controllers are sound.
    member.fault = faultOfException(result->status.error().message, result->report, result->thrown, m_library);
    return Error{result->status.error().code, member.fault->reason};
}

Status HostGroup::set(std::size_t number, const std::string& property, const PropertyValue& value) {
    if (!m_members[number].started) return Error{Code::ControllerFailed, "it has stopped"};
    return call(number, HostRequest::Set,
                WireWriter().number(static_cast<std::uint32_t>(number)).bytes(property).value(value).view());
}

Result<std::string> HostGroup::saveState(std::size_t number) {
    if (!m_members[number].started) return std::string();
    const Status saved = call(number, HostRequest::SaveState, WireWriter().number(static_cast<std::uint32_t>(number)).view());
    return saved ? Result<std::string>(std::exchange(m_more, {})) : saved.error();
}

Status HostGroup::loadState(std::size_t number, std::string_view state) {
    if (!m_members[number].started) return Error{Code::ControllerFailed, "it has stopped"};
    return call(number, HostRequest::LoadState, WireWriter().number(static_cast<std::uint32_t>(number)).bytes(state).view());
}

void HostGroup::stop(std::size_t number) {
    Member& member = m_members[number];
    if (std::exchange(member.started, false) && m_host && m_host->alive()) {
        (void)call(number, HostRequest::Stop, WireWriter().number(static_cast<std::uint32_t>(number)).view());
        if (m_host->alive() && std::ranges::none_of(m_members, &Member::started)) unload(member);
    }
    member.outputs = {}; // what they refer to may be destroyed now
}

const ControllerFault* HostGroup::fault(std::size_t number) const {
    const auto& fault = m_members[number].fault;
    return fault ? &*fault : nullptr;
}

void HostGroup::setFaults() {
    m_updating = false;
    const HostEnd& end = m_host->end();
    const std::size_t faulty = end.during.controller;
    const bool known = faulty < m_members.size() && !end.ofThread && end.during.phase != HostPhase::None;
    const auto titleOf = [](const Member& member) { return controllerTitle(*member.robot, *member.controller); };
    ControllerFault own = faultOf(end, known ? titleOf(m_members[faulty]) : std::string(), m_library);
    own.process = m_library + " " + std::to_string(m_generation);
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        Member& member = m_members[i];
        const bool isFaulty = known && i == faulty;
        if (!std::exchange(member.started, false) && !isFaulty) continue;
        member.fault = known && !isFaulty ? sharedFault(own, titleOf(member), m_members[faulty].robot->name) : own;
        if (isFaulty && member.gaveUp) member.fault->reason += "; it had called fail(): " + *member.gaveUp;
        if (!known) own.backtrace.clear(); // once, with the first robot
        passFinish(member);
    }
}

// ---- records of the host ----

HostGroup::Member* HostGroup::memberAt(std::uint32_t number) {
    return number < m_members.size() ? &m_members[number] : nullptr;
}

std::string HostGroup::handle(HostRecord record, std::uint32_t number, WireReader& in) {
    if (record == HostRecord::Done) {
        m_done = in.status();
        m_more = m_done->ok() ? in.text() : std::string();
        m_thrown = m_done->ok() ? std::vector<std::uint64_t>() : in.numbers<std::uint64_t>();
        return {};
    }
    Member* member = memberAt(number);
    if (!member) return {};
    switch (record) {
    case HostRecord::Updated: {
        UpdateResult result;
        result.status = in.status();
        result.gaveUp = in.number<std::uint8_t>() != 0;
        result.seconds = in.number<double>();
        result.report = in.text();
        result.thrown = in.numbers<std::uint64_t>();
        member->result = std::move(result);
        return {};
    }
    case HostRecord::Finish: {
        std::string reason = in.text();
        if (!member->finish) member->finish = std::move(reason);
        return {};
    }
    case HostRecord::GaveUp: member->gaveUp = in.text(); return {};
    case HostRecord::Claim: return WireWriter().status(claim(*member, in.text())).take();
    default: return answerHost(record, member->robot->name, member->outputs, member->radios, in);
    }
}

double HostGroup::limitOf(const HostCall& call) const {
    const bool updates = call.phase == HostPhase::Update || call.phase == HostPhase::Set;
    if (!updates || call.controller >= m_members.size()) return isEnd(call.phase) ? kLongestEndS : kLongestCallS;
    const double budget = m_members[call.controller].controller->number("Budget");
    return budget > 0 ? std::max(kBudgetFactor * budget, kShortestLimitS) : kLongestCallS;
}

void HostGroup::showWaiting(const HostCall& call, double seconds) {
    if (call.phase == HostPhase::None) return;
    if (!m_moduleTarget) m_moduleTarget = m_context.calls->add({"the module " + m_library, {}, {}, m_library});
    const CallTarget* target = call.controller < m_members.size() ? m_members[call.controller].target : m_moduleTarget;
    if (!target) return;
    const double limit = limitOf(call);
    if (seconds >= kSayAfterS && limit > 2 * kSayAfterS && m_context.say && !std::exchange(m_saidWaiting, true))
        m_context.say("waiting for " + target->text + " in " + phaseName(call.phase) + ", which is stopped after " +
                      std::to_string(std::lround(limit)) + " s");
    if (m_context.calls->target() == target) return;
    m_waiting.reset();
    m_waiting.emplace(*m_context.calls, target, phaseName(call.phase));
}

} // namespace trundle
