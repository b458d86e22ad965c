#include "remote/run_operations.h"

#include "remote/device_views.h"

namespace trundle {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::uint64_t kLargestSeed = 1ull << 53;
constexpr double kFastest = 1000;

} // namespace

/// All or none.
Status RunOperations::setAll(const SignalValues& values) {
    for (const auto& [path, numbers] : values)
        if (Status wrong = m_run.checkSignal(path, numbers.size()); !wrong) return wrong;
    for (const auto& [path, numbers] : values) (void)m_run.setSignal(path, numbers);
    return {};
}

Reply RunOperations::commandDevice(const std::string& path) {
    const ComponentSpec* device = deviceAt(m_run.world().experiment(), path);
    if (!device) return Reply::failed("no_such_path", "there is no device " + shortenedMessage(path));
    const DeviceView* view = viewOf(device->kind);
    SignalValues writes;
    std::string names;
    for (const ViewCommand& each : view ? view->commands : std::span<const ViewCommand>()) {
        const std::string name(each.name);
        names += (names.empty() ? "" : ", ") + name;
        if (!m_arguments.has(name)) continue;
        const std::vector<double> value = each.size == 1 ? std::vector{m_arguments.number(name)} : m_arguments.numbers(name, each.size);
        for (const ViewWrite& write : each.writes)
            writes.emplace_back(path + "/" + std::string(write.signal),
                                std::vector{write.element < 0 ? write.constant : value[static_cast<std::size_t>(write.element)]});
    }
    if (auto wrong = m_request.mistake()) return *wrong;
    if (writes.empty())
        return Reply::failed("bad_request", "a " + interfaceOf(device->kind) + " of kind " + device->kind +
                                                (names.empty() ? " has no commands of its interface; set its signals instead"
                                                               : " needs one of: " + names));
    return Reply::of(setAll(writes));
}

Reply RunOperations::command() {
    if (m_arguments.has("device")) return commandDevice(m_arguments.text("device"));
    const auto values = m_arguments.values("signals");
    if (values.empty()) m_arguments.setProblem("signals, or a device and a command of its interface, are missing");
    if (auto wrong = m_request.mistake()) return *wrong;
    return Reply::of(setAll(values));
}

Reply RunOperations::hold() {
    const std::string robot = m_arguments.text("robot");
    const bool held = m_arguments.flag("held", true);
    if (auto wrong = m_request.mistake()) return *wrong;
    return Reply::of(m_run.hold(robot, held));
}

Reply RunOperations::place() {
    const std::string robot = m_arguments.text("robot");
    const std::vector<double> at = m_arguments.numbers("position", 3);
    const double heading = m_arguments.number("heading", 0);
    if (auto wrong = m_request.mistake()) return *wrong;
    return Reply::of(m_run.place(robot, {Vec3(at[0], at[1], at[2]), rotationFromHpr(Vec3(heading, 0, 0))}));
}

Reply RunOperations::push() {
    const std::string body = m_arguments.text("body");
    const std::vector<double> force = m_arguments.numbers("force", 3), at = m_arguments.numbers("point", 3);
    if (auto wrong = m_request.mistake()) return *wrong;
    return Reply::of(m_run.push(body, Vec3(force[0], force[1], force[2]), Vec3(at[0], at[1], at[2])));
}

Reply RunOperations::restart() {
    const std::string robot = m_arguments.text("robot");
    if (auto wrong = m_request.mistake()) return *wrong;
    return Reply::of(m_run.restart(robot));
}

Reply RunOperations::step() {
    StepJob job{{}, m_arguments.count("ticks", kMostTicks, 1), 0, {}};
    if (m_arguments.has("subscription")) job.subscription = static_cast<std::uint32_t>(m_arguments.count("subscription", UINT32_MAX));
    const auto values = m_arguments.values("signals");
    if (auto wrong = m_request.mistake()) return *wrong;
    if (job.subscription && !m_client.subscriptions.contains(*job.subscription))
        return Reply::failed("no_such_path", "there is no such subscription");
    if (m_run.state() == ServedState::Running) return Reply::failed("busy", "the run is running; pause it first");
    if (const Status set = setAll(values); !set) return Reply::of(set);
    m_client.step = std::move(job);
    Reply reply;
    reply.later = true;
    return reply;
}

Reply RunOperations::run() {
    const double speed = m_arguments.number("speed", 1);
    if (speed < 0 || speed > kFastest) m_arguments.setProblem("speed must be from 0, which is as fast as possible, to 1000");
    if (auto wrong = m_request.mistake()) return *wrong;
    m_run.run(speed);
    return {stateOf(m_run), {}, {}, {}, false};
}

Reply RunOperations::pause() {
    if (auto wrong = m_request.mistake()) return *wrong;
    m_run.pause();
    return {stateOf(m_run), {}, {}, {}, false};
}

Reply RunOperations::reset() {
    std::optional<std::uint64_t> seed;
    if (m_arguments.has("seed")) seed = m_arguments.count("seed", kLargestSeed);
    if (auto wrong = m_request.mistake()) return *wrong;
    if (m_run.isPacedElsewhere()) return Reply::failed("refused", "the run is one of a window, which resets it");
    const bool built = m_run.reset(seed);
    Reply reply =
        built ? Reply{statusOf(m_run), {}, {}, {}, false} : Reply::failed(kResetFailed, "the experiment could not be built");
    reply.members["diagnostics"] = problemsJson(m_run.built().problems, m_run.built().sources);
    return reply;
}

} // namespace trundle
