#include "remote/served_run.h"

#include <algorithm>
#include <cstdio>

#include "base/spelling.h"
#include "model/joined_robots.h"
#include "run/schedule.h"

namespace trundle {
namespace {

constexpr std::size_t kMostProblems = 100;

std::string robotOf(const std::string& path) { return path.substr(0, path.find('/')); }

/// "; did you mean X?", or nothing.
std::string meant(const std::string& word, const std::vector<std::string>& names) {
    const std::vector<std::string> near = nearestWords(word, names, 1);
    return near.empty() ? std::string() : "; did you mean " + near[0] + "?";
}

Error noRun() { return {Code::SystemRefused, "there is no run; reset it"}; }

} // namespace

ServedRun::ServedRun(Runner& runner) : m_state(ServedState::Paused) {
    m_built.runner = {std::shared_ptr<void>(), &runner}; // owned elsewhere
    if (runner.finished()) m_state = ServedState::Ended;
}

void ServedRun::follow(bool running, double speed) {
    if (m_state == ServedState::Ended) return;
    m_state = running ? ServedState::Running : ServedState::Paused;
    m_speed = speed;
}

bool ServedRun::reset(std::optional<std::uint64_t> seed) {
    m_built.runner.reset(); // its logs are closed before the next one opens them
    m_commands.clear();
    m_held.clear();
    m_atDuration = false;
    m_built = m_maker(seed);
    m_state = exists() ? ServedState::Paused : ServedState::Ended;
    if (!exists()) return false;
    const SettingsSpec& settings = world().experiment().settings;
    m_durationTicks = settings.duration > 0 ? ticksFor(settings.duration, settings.tick) : 0;
    if (runner().finished()) m_state = ServedState::Ended;
    return true;
}

void ServedRun::run(double speed) {
    if (m_state == ServedState::Ended) return;
    m_speed = speed;
    m_state = ServedState::Running;
    m_atDuration = false;
}

void ServedRun::pause() {
    if (m_state == ServedState::Running) m_state = ServedState::Paused;
}

std::string ServedRun::endReason() const {
    if (!exists()) return "there is no run";
    if (const Diagnostic* failed = failure()) return failed->message;
    if (const RunFinish* finish = m_built.runner->finished())
        return "the controller " + finish->controller + " of " + finish->robot + " finished it: " + finish->reason;
    return {};
}

void ServedRun::beginTick() {
    for (auto& [key, command] : m_commands) runner().command(std::move(command));
    m_commands.clear();
}

void ServedRun::endTick(bool good) {
    m_atDuration = false;
    if (!good || runner().finished()) m_state = ServedState::Ended;
    if (m_state != ServedState::Running || m_durationTicks == 0 || world().ticks() != m_durationTicks) return;
    m_state = ServedState::Paused;
    m_atDuration = true;
}

const RobotSpec* ServedRun::robot(const std::string& name) const {
    const std::vector<RobotSpec>& robots = m_built.runner->world().experiment().robots;
    const auto found = std::ranges::find(robots, name, &RobotSpec::name);
    return found == robots.end() ? nullptr : &*found;
}

Status ServedRun::checkSignal(const std::string& path, std::size_t count) const {
    if (!exists()) return noRun();
    const SignalLayout& layout = m_built.runner->world().layout();
    const auto entry = layout.find(path);
    if (!entry) {
        std::vector<std::string> names;
        for (const SignalEntry& each : layout.entriesOf(robotOf(path)))
            if (each.direction == SignalDirection::Command) names.push_back(each.path);
        return Error{Code::NoSuchPath, "there is no signal " + shortenedMessage(path) + meant(path, names)};
    }
    if (entry->direction != SignalDirection::Command) return Error{Code::WrongPlace, path + " is measured, not commanded"};
    if (entry->count != count)
        return Error{Code::WrongPlace, path + " has " + std::to_string(entry->count) +
                                           (entry->count == 1 ? " number, not " : " numbers, not ") + std::to_string(count)};
    return checkOwner(path);
}

Status ServedRun::checkOwner(const std::string& path) const {
    const RobotSpec* owner = robot(robotOf(path));
    if (!owner || isHeld(owner->name)) return {};
    const std::vector<const ControllerSpec*> controllers = m_built.runner->controllersOf(owner->name);
    if (controllers.empty()) return {};
    return Error{Code::Conflict, "the controller " + controllers.front()->name + " of " + owner->name + " owns " + path +
                                     "; hold " + owner->name + " first"};
}

Status ServedRun::setSignal(const std::string& path, const std::vector<double>& values) {
    if (Status wrong = checkSignal(path, values.size()); !wrong) return wrong;
    for (std::uint32_t i = 0; i < values.size(); ++i)
        m_commands["signal " + path + " " + std::to_string(i)] = SignalCommand{path, values[i], i};
    return {};
}

Status ServedRun::hold(const std::string& name, bool held) {
    if (!exists()) return noRun();
    if (!robot(name)) return Error{Code::NoSuchPath, "there is no robot " + shortenedMessage(name)};
    m_commands["hold " + name] = HoldCommand{name, held, Holder::Guest};
    if (held) {
        m_held.insert(name);
        return {};
    }
    m_held.erase(name);
    if (!runner().controllersOf(name).empty()) // its signals that wait for the coming tick are its controller's again
        std::erase_if(m_commands, [&](const auto& command) { return command.first.starts_with("signal " + name + "/"); });
    return {};
}

Status ServedRun::place(const std::string& name, const Pose& pose) {
    if (!exists()) return noRun();
    const RobotSpec* placed = robot(name);
    if (!placed) return Error{Code::NoSuchPath, "there is no robot " + shortenedMessage(name)};
    const ExperimentSpec& experiment = world().experiment();
    const JoinedRobots joined(experiment);
    const auto index = static_cast<std::size_t>(placed - experiment.robots.data());
    if (const Status possible = checkPlace(world(), joined, index, pose); !possible) return possible;
    for (const std::size_t i : joined.with(index)) m_commands.erase("place " + experiment.robots[i].name); // the last one counts
    m_commands["place " + name] = PlaceCommand{name, pose};
    return {};
}

Status ServedRun::push(const std::string& body, const Vec3& force, const Vec3& point) {
    if (!exists()) return noRun();
    const RobotSpec* owner = robot(robotOf(body));
    const bool known = owner && std::ranges::any_of(owner->config->bodies, [&](const BodySpec& each) {
                           return body == owner->name + "/" + each.name;
                       });
    if (!known) return Error{Code::NoSuchPath, "there is no body " + shortenedMessage(body)};
    const auto index = static_cast<std::size_t>(owner - world().experiment().robots.data());
    if (const Status possible = checkPush(world(), index, force, point); !possible) return possible;
    char key[32]; // of its own: all pushes act, in the order in which they came
    std::snprintf(key, sizeof key, "push %020llu", static_cast<unsigned long long>(m_pushes++));
    m_commands[key] = PushCommand{body, force, point};
    return {};
}

Status ServedRun::restart(const std::string& name) {
    if (!exists()) return noRun();
    if (runner().controllersOf(name).empty())
        return Error{Code::NoSuchPath, "there is no robot " + shortenedMessage(name) + " with a controller"};
    m_commands["restart " + name] = RestartCommand{name};
    return {};
}

nlohmann::ordered_json problemsJson(const std::vector<Diagnostic>& problems, const SourceTable& sources) {
    std::vector<const Diagnostic*> sorted;
    for (const Diagnostic& each : problems) sorted.push_back(&each);
    std::ranges::stable_sort(sorted, {}, [](const Diagnostic* each) { return each->severity; });
    sorted.resize(std::min(sorted.size(), kMostProblems));
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Diagnostic* each : sorted) {
        LineColumn at{0, 0};
        std::string file;
        if (each->range.known() && each->range.file < sources.size()) {
            const SourceText& text = *sources[each->range.file].text;
            file = text.path();
            at = text.position(each->range.range.begin);
        }
        constexpr const char* kSeverities[] = {"error", "warning", "hint"};
        all.push_back({{"severity", kSeverities[static_cast<std::size_t>(each->severity)]},
                       {"code", codeName(each->code)},
                       {"message", each->message},
                       {"file", file},
                       {"line", at.line},
                       {"column", at.column}});
    }
    return all;
}

} // namespace trundle
