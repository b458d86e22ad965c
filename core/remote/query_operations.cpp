#include "remote/query_operations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/spelling.h"
#include "model/object_numbers.h"
#include "remote/device_views.h"

namespace trundle {

using Json = nlohmann::ordered_json;

namespace {

constexpr double kWholeNumbers = 0x1p63; // the integers of JSON end below

template <class T> std::string_view bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// [[number, name]] of the objects in an image.
Json namesOf(const CameraImage& image, const ExperimentSpec& experiment) {
    const std::vector<std::string> names = objectNames(experiment);
    const std::set<std::uint32_t> numbers(image.objects.begin(), image.objects.end());
    Json all = Json::array();
    for (const std::uint32_t number : numbers)
        if (number > 0 && number < names.size()) all.push_back({number, names[number]});
    return all;
}

/// Names the first pattern, and the signal that may be meant by it.
Reply noneMatches(const std::vector<std::string>& patterns, const SignalLayout& layout) {
    std::string text = patterns.empty() ? "no signal is named" : "no signal matches " + patterns.front();
    std::vector<std::string> paths;
    for (const SignalEntry& entry : layout.entries()) paths.push_back(entry.path);
    if (!patterns.empty())
        if (const std::vector<std::string> near = nearestWords(patterns.front(), paths); !near.empty()) text += "; did you mean " + near.front() + "?";
    return Reply::failed("no_such_path", text + "; `describe` lists those of a robot");
}

} // namespace

Reply QueryOperations::status() {
    if (auto wrong = m_request.mistake()) return *wrong;
    return {statusOf(m_run), {}, {}, {}, false};
}

namespace {

Json controllersOf(ServedRun& run, const RobotSpec& robot) {
    Json all = Json::array();
    for (const ControllerSpec* each : run.runner().controllersOf(robot.name))
        all.push_back({{"kind", each->kind}, {"name", each->name}});
    return all;
}

} // namespace

Reply QueryOperations::list() {
    if (auto wrong = m_request.mistake()) return *wrong;
    Reply reply;
    Json robots = Json::array();
    for (const RobotSpec& robot : m_run.world().experiment().robots) {
        Json devices = Json::array(), controllers = controllersOf(m_run, robot);
        for (const ComponentSpec& device : robot.config->devices)
            devices.push_back({{"device", robot.name + "/" + device.name}, {"kind", device.kind}, {"interface", interfaceOf(device.kind)}});
        robots.push_back({{"robot", robot.name},
                          {"controller", controllers.empty() ? Json() : controllers.front()["kind"]},
                          {"controllers", std::move(controllers)},
                          {"held", m_run.isHeld(robot.name)},
                          {"devices", std::move(devices)}});
    }
    reply.members["interface"] = "simulation";
    reply.members["robots"] = std::move(robots);
    return reply;
}

namespace {

Json describedDevice(const RobotSpec& robot, const ComponentSpec& device) {
    Json data = Json::array(), commands = Json::object();
    if (const DeviceView* view = viewOf(device.kind)) {
        for (const ViewData& each : view->data) data.push_back(each.name);
        for (const ViewCommand& each : view->commands) commands[std::string(each.name)] = each.size;
    }
    return {{"device", robot.name + "/" + device.name},
            {"name", device.name},
            {"kind", device.kind},
            {"interface", interfaceOf(device.kind)},
            {"update_period", device.number("UpdatePeriod")},
            {"data", std::move(data)},
            {"commands", std::move(commands)}};
}

Json describedSignal(const SignalEntry& entry) {
    constexpr const char* kTypes[] = {"real", "integer", "boolean"};
    constexpr const char* kDirections[] = {"output", "command", "truth"};
    return {{"path", entry.path},
            {"unit", entry.unit},
            {"type", kTypes[static_cast<std::size_t>(entry.type) - 1]},
            {"direction", kDirections[static_cast<std::size_t>(entry.direction) - 1]},
            {"count", entry.count},
            {"offset", entry.offset}};
}

} // namespace

Reply QueryOperations::describe() {
    const std::string name = m_arguments.text("robot");
    if (auto wrong = m_request.mistake()) return *wrong;
    const RobotSpec* robot = m_run.robot(name);
    if (!robot) return Reply::failed("no_such_path", "there is no robot " + shortenedMessage(name));
    Reply reply;
    Json devices = Json::array(), signals = Json::array(), controllers = controllersOf(m_run, *robot);
    for (const ComponentSpec& device : robot->config->devices) devices.push_back(describedDevice(*robot, device));
    for (const SignalEntry& entry : m_run.world().layout().entriesOf(robot->name)) signals.push_back(describedSignal(entry));
    reply.members["robot"] = robot->name;
    reply.members["controller"] = controllers.empty() ? Json() : controllers.front();
    reply.members["controllers"] = std::move(controllers);
    reply.members["held"] = m_run.isHeld(robot->name);
    reply.members["slots"] = m_run.world().layout().slotCount();
    reply.members["devices"] = std::move(devices);
    reply.members["signals"] = std::move(signals);
    return reply;
}

Reply QueryOperations::subscribe() {
    Subscription subscription{m_arguments.texts("signals"), {}, m_arguments.count("every", kMostTicks, 1), 0};
    if (auto wrong = m_request.mistake()) return *wrong;
    if (subscription.patterns.size() > RemoteClient::kMostPatterns || m_client.subscriptions.size() >= RemoteClient::kMostSubscriptions)
        return Reply::failed("refused", "at most " + std::to_string(RemoteClient::kMostSubscriptions) + " subscriptions of at most " +
                                            std::to_string(RemoteClient::kMostPatterns) + " patterns are possible");
    bindSignals(subscription, m_run.world().layout());
    if (subscription.entries.empty()) return noneMatches(subscription.patterns, m_run.world().layout());
    Reply reply;
    Json signals = Json::array();
    for (const SignalEntry& entry : subscription.entries) signals.push_back({entry.path, entry.count});
    reply.members["subscription"] = ++m_client.lastSubscription;
    reply.members["signals"] = std::move(signals);
    m_client.subscriptions[m_client.lastSubscription] = std::move(subscription);
    return reply;
}

Reply QueryOperations::unsubscribe() {
    const auto number = static_cast<std::uint32_t>(m_arguments.count("subscription", UINT32_MAX));
    if (auto wrong = m_request.mistake()) return *wrong;
    if (m_client.subscriptions.erase(number) == 0) return Reply::failed("no_such_path", "there is no such subscription");
    return {};
}

Json QueryOperations::numbersOf(const SignalEntry& entry) {
    const std::span<const double> slots = std::as_const(m_run.world()).block().slots().subspan(entry.offset, entry.count);
    const auto valueOf = [&](double value) {
        if (entry.type == SignalType::Boolean) return Json(value != 0);
        const bool isWhole = entry.type == SignalType::Integer && std::abs(value) < kWholeNumbers;
        return isWhole ? Json(static_cast<std::int64_t>(value)) : Json(value);
    };
    if (entry.count == 1) return valueOf(slots[0]);
    Json all = Json::array();
    for (const double value : slots) all.push_back(valueOf(value));
    return all;
}

Reply QueryOperations::readDevice(const std::string& path) {
    const ComponentSpec* device = deviceAt(m_run.world().experiment(), path);
    if (!device) return Reply::failed("no_such_path", "there is no device " + shortenedMessage(path));
    Reply reply{stateOf(m_run), {}, {}, {}, false};
    Json data = Json::object();
    const SignalLayout& layout = m_run.world().layout();
    if (const DeviceView* view = viewOf(device->kind)) {
        for (const ViewData& each : view->data)
            if (const auto entry = layout.find(path + "/" + std::string(each.signal)))
                data[std::string(each.name)] = numbersOf(*entry);
    } else {
        for (const SignalEntry& entry : layout.entriesOf(path.substr(0, path.find('/'))))
            if (entry.path.starts_with(path + "/") && entry.direction == SignalDirection::Output)
                data[entry.path.substr(path.size() + 1)] = numbersOf(entry);
    }
    reply.members["device"] = path;
    reply.members["interface"] = interfaceOf(device->kind);
    reply.members["data"] = std::move(data);
    return reply;
}

Reply QueryOperations::readSubscription() {
    const auto number = static_cast<std::uint32_t>(m_arguments.count("subscription", UINT32_MAX));
    if (auto wrong = m_request.mistake()) return *wrong;
    const auto found = m_client.subscriptions.find(number);
    if (found == m_client.subscriptions.end()) return Reply::failed("no_such_path", "there is no such subscription");
    return {stateOf(m_run), valuesOf(found->second, m_run.world().block()), {}, {}, false};
}

Reply QueryOperations::read() {
    if (m_arguments.has("device")) {
        const std::string device = m_arguments.text("device");
        if (auto wrong = m_request.mistake()) return *wrong;
        return readDevice(device);
    }
    if (m_arguments.has("subscription")) return readSubscription();
    Subscription once{m_arguments.texts("signals"), {}, 0, 0};
    if (auto wrong = m_request.mistake()) return *wrong;
    if (once.patterns.size() > RemoteClient::kMostPatterns) return Reply::failed("refused", "too many patterns at once");
    bindSignals(once, m_run.world().layout());
    if (once.entries.empty()) return noneMatches(once.patterns, m_run.world().layout());
    Reply reply{stateOf(m_run), {}, {}, {}, false};
    Json values = Json::object();
    for (const SignalEntry& entry : once.entries) values[entry.path] = numbersOf(entry);
    reply.members["values"] = std::move(values);
    return reply;
}

Reply QueryOperations::hash() {
    if (auto wrong = m_request.mistake()) return *wrong;
    Reply reply{stateOf(m_run), {}, {}, {}, false};
    reply.members["hash"] = hashDigits(m_run.world().stateHash());
    return reply;
}

Reply QueryOperations::image() {
    const std::string camera = m_arguments.text("camera");
    if (auto wrong = m_request.mistake()) return *wrong;
    const ComponentSpec* device = deviceAt(m_run.world().experiment(), camera);
    if (!device || device->kind != "Camera") return Reply::failed("no_such_path", "there is no camera " + shortenedMessage(camera));
    const Result<const CameraImage*> drawn = m_run.runner().cameras().capture(camera);
    if (!drawn) return Reply::failed("failed", drawn.error().message);
    const CameraImage& image = *drawn.value();
    Reply reply;
    reply.members = {{"width", image.width},
                     {"height", image.height},
                     {"tick", image.tick},
                     {"time", image.time},
                     {"pixels", image.pixels.size()},
                     {"depth", image.depth.size() * sizeof(float)},
                     {"objects", image.objects.size() * sizeof(std::uint32_t)}};
    if (!image.objects.empty()) reply.members["names"] = namesOf(image, m_run.world().experiment());
    reply.bytes = bytesOf(image.pixels);
    reply.bytes += bytesOf(image.depth);
    reply.bytes += bytesOf(image.objects);
    return reply;
}

Reply QueryOperations::objects() {
    if (auto wrong = m_request.mistake()) return *wrong;
    return {{{"objects", objectNames(m_run.world().experiment())}}, {}, {}, {}, false};
}

Reply QueryOperations::console() {
    const bool on = m_arguments.flag("on", true);
    if (auto wrong = m_request.mistake()) return *wrong;
    m_client.console = on;
    return {};
}

} // namespace trundle
