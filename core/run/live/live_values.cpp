#include "run/live/live_values.h"

#include <algorithm>

#include "model/body_geom.h"
#include "model/robot_path.h"
#include "run/logs/signal_columns.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxBound = 256;
constexpr std::uint32_t kMaxNumbers = 6; // of a signal that are all shown: a range scan has hundreds

template <class Range> auto* named(Range& range, std::string_view name) {
    const auto it = std::ranges::find_if(range, [&](const auto& item) { return item.name == name; });
    return it == range.end() ? nullptr : &*it;
}

Pose poseAt(const LiveSnapshot& snapshot, std::uint32_t offset) {
    const double* s = snapshot.block->slots().data() + offset;
    return {Vec3(s[0], s[1], s[2]), Quat(s[3], s[4], s[5], s[6]).normalized()};
}

void append(std::vector<double>& numbers, const Vec3& v) { numbers.insert(numbers.end(), {v.x(), v.y(), v.z()}); }

} // namespace

std::string LiveValue::text() const {
    std::string all;
    for (const std::string& number : numbers) all += (all.empty() ? "" : ", ") + number;
    return all;
}

LiveObject::LiveObject(const ExperimentSpec& experiment, const SignalLayout& layout, const Registry& registry,
                       std::string_view path) {
    if (path.empty()) addRun();
    else bind(experiment, layout, registry, path);
}

void LiveObject::bind(const ExperimentSpec& experiment, const SignalLayout& layout, const Registry& registry,
                      std::string_view path) {
    const std::string first = robotNameIn(experiment, path);
    const RobotSpec* robot = named(experiment.robots, first);
    if (!robot) // a joint, spring or region between robots; in a Repeat of the world "lane_1.goal"
        return addSignals(layout, std::string(path) + "/", named(experiment.regions, path) ? registry.find("Region") : nullptr);
    if (!robot->config) return;
    path = path.size() > first.size() ? path.substr(first.size() + 1) : std::string_view();
    if (path.empty()) return addRobot(*robot, layout, registry);
    const BodySpec* body = named(robot->config->bodies, path);
    const GeomSpec* geom = nullptr;
    if (const BodyGeom at = geomAt(robot->config->bodies, path); !body && at.geom >= 0) {
        body = &robot->config->bodies[static_cast<std::size_t>(at.body)];
        geom = &body->geoms[static_cast<std::size_t>(at.geom)];
    }
    if (body) {
        const std::string prefix = robot->name + "/" + body->name + "/";
        if (geom || body->name == path) addMotion(layout, prefix, geom ? geom->pose : Pose{});
        return;
    }
    const std::string prefix = robot->name + "/" + std::string(path) + "/";
    const ComponentSpec* part = named(robot->config->devices, path);
    if (!part) part = named(robot->controllers, path);
    addSignals(layout, prefix, part ? registry.find(part->kind) : nullptr);
}

void LiveObject::add(LiveValue value, NumberScale scale, std::function<void(const LiveSnapshot&, Numbers&)> read) {
    m_lines.push_back({m_values.size(), std::move(scale), std::move(read)});
    m_values.push_back(std::move(value));
}

void LiveObject::addRun() {
    const auto one = [this](const char* name, const char* help, NumberScale scale, auto get) {
        add({name, "", help, {}, "", false}, std::move(scale),
            [get](const LiveSnapshot& s, Numbers& out) { out.push_back(static_cast<double>(get(s))); });
    };
    constexpr auto whole = NumberScale::Kind::Whole;
    one("time", "Simulated.", NumberScale("s"), [](const LiveSnapshot& s) { return s.time; });
    one("ticks", "Done so far.", NumberScale("", whole), [](const LiveSnapshot& s) { return s.tick; });
    one("contacts", "Points at which things touch.", NumberScale("", whole),
        [](const LiveSnapshot& s) { return s.contactCount; });
    one("real-time factor", "Simulated seconds per second.", NumberScale(""),
        [](const LiveSnapshot& s) { return s.realTimeFactor; });
    one("time per tick", "Of the processor, mean of the last ticks.", NumberScale("ms"),
        [](const LiveSnapshot& s) { return s.stepMs; });
}

void LiveObject::addPose(const SignalEntry& entry, const std::string& prefix, const Pose& inFrame) {
    const std::uint32_t at = entry.offset;
    add({prefix + "position", entry.path, "x, y, z in the world.", {}, "", false}, NumberScale("m"),
        [at, inFrame](const LiveSnapshot& s, Numbers& out) { append(out, (poseAt(s, at) * inFrame).position); });
    add({prefix + "HPR", entry.path, "Heading, pitch and roll in the world.", {}, "", false}, NumberScale("rad"),
        [at, inFrame](const LiveSnapshot& s, Numbers& out) { append(out, hprFromRotation((poseAt(s, at) * inFrame).rotation)); });
}

void LiveObject::addVector(const SignalEntry& entry, LiveValue value, const char* unit, std::uint32_t from, std::uint32_t count) {
    value.signal = entry.path;
    add(std::move(value), NumberScale(unit), [at = entry.offset + from, count](const LiveSnapshot& s, Numbers& out) {
        const double* first = s.block->slots().data() + at;
        out.insert(out.end(), first, first + count);
    });
}

/// Adds pose and velocity of a robot, a body, or a geom that is fixed to a body.
void LiveObject::addMotion(const SignalLayout& layout, const std::string& prefix, const Pose& inFrame) {
    const auto pose = layout.find(prefix + "pose"), velocity = layout.find(prefix + "velocity");
    if (!pose || shapeOf(*pose) != SignalShape::Pose) return;
    addPose(*pose, "", inFrame);
    if (!velocity || shapeOf(*velocity) != SignalShape::Velocity) return;
    const auto linear = [at = velocity->offset, frame = pose->offset, inFrame](const LiveSnapshot& s) -> Vec3 {
        const double* v = s.block->slots().data() + at;
        return Vec3(v[0], v[1], v[2]) + Vec3(v[3], v[4], v[5]).cross(poseAt(s, frame).rotation * inFrame.position);
    };
    add({"speed", velocity->path, "How fast its origin moves.", {}, "", false}, NumberScale("m/s"),
        [linear](const LiveSnapshot& s, Numbers& out) { out.push_back(linear(s).norm()); });
    add({"velocity", velocity->path, "Of its origin along x, y, z of the world.", {}, "", false}, NumberScale("m/s"),
        [linear](const LiveSnapshot& s, Numbers& out) { append(out, linear(s)); });
    addVector(*velocity, {"angular rate", "", "About x, y, z of the world.", {}, "", false}, "rad/s", 3, 3);
}

void LiveObject::addRobot(const RobotSpec& robot, const SignalLayout& layout, const Registry& registry) {
    addMotion(layout, robot.name + "/", {});
    // Signals published by controllers are shown with the robot, like the controllers' properties.
    const bool isAlone = robot.controllers.size() == 1;
    for (const ControllerSpec& controller : robot.controllers)
        addSignals(layout, robot.name + "/" + controller.name + "/", registry.find(controller.kind), isAlone ? "" : controller.name + " ");
}

void LiveObject::addSignals(const SignalLayout& layout, const std::string& prefix, const Kind* kind, const std::string& owner) {
    for (const SignalEntry& entry : layout.entriesOf(std::string_view(prefix).substr(0, prefix.find('/')))) {
        if (!entry.path.starts_with(prefix)) continue;
        const std::string name = entry.path.substr(prefix.size());
        const SignalDescription* described = kind ? named(kind->signals, name) : nullptr;
        addSignal(entry,
                  {owner + name, entry.path, described ? described->help : "", {}, "", entry.direction == SignalDirection::Command});
    }
}

void LiveObject::addSignal(const SignalEntry& entry, LiveValue value) {
    switch (shapeOf(entry)) {
    case SignalShape::Pose: return addPose(entry, value.name + " ", {});
    case SignalShape::Velocity: {
        LiveValue angular = value;
        angular.name += ", angular";
        addVector(entry, std::move(value), "m/s", 0, 3);
        return addVector(entry, std::move(angular), "rad/s", 3, 3);
    }
    case SignalShape::PlanePose: {
        LiveValue heading = value;
        value.name += " x, y";
        heading.name += " heading";
        addVector(entry, std::move(value), "m", 0, 2);
        return addVector(entry, std::move(heading), "rad", 2, 1);
    }
    case SignalShape::Plain: break;
    }
    if (entry.count > kMaxNumbers) addExtremes(entry, std::move(value));
    else addVector(entry, std::move(value), entry.unit.c_str(), 0, entry.count);
    m_lines.back().type = entry.type;
    if (entry.type != SignalType::Real) m_lines.back().scale = NumberScale(entry.unit, NumberScale::Kind::Whole);
}

/// Of a signal with many numbers the least and the greatest.
void LiveObject::addExtremes(const SignalEntry& entry, LiveValue value) {
    value.name += " least, greatest";
    value.help += (value.help.empty() ? "Of " : " Of ") + std::to_string(entry.count) + " numbers.";
    value.signal = entry.path;
    add(std::move(value), NumberScale(entry.unit), [at = entry.offset, count = entry.count](const LiveSnapshot& s, Numbers& out) {
        const double* first = s.block->slots().data() + at;
        const auto [least, greatest] = std::minmax_element(first, first + count);
        out.insert(out.end(), {*least, *greatest});
    });
}

const std::vector<LiveValue>& LiveObject::read(const LiveSnapshot& snapshot) {
    if (snapshot.block == m_read) return m_values;
    m_read = snapshot.block;
    for (Line& line : m_lines) {
        m_numbers.clear();
        line.read(snapshot, m_numbers);
        for (const double number : m_numbers) line.scale.note(number);
        LiveValue& value = m_values[line.value];
        value.unit = line.scale.unit();
        value.numbers.clear();
        for (const double number : m_numbers)
            value.numbers.push_back(line.type == SignalType::Boolean ? (number != 0 ? "true" : "false")
                                                                     : line.scale.text(number));
    }
    return m_values;
}

LiveObjects::LiveObjects(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const SignalLayout> layout,
                         std::shared_ptr<const Registry> registry)
    : m_experiment(std::move(experiment)), m_layout(std::move(layout)), m_registry(std::move(registry)) {}

const std::vector<LiveValue>& LiveObjects::read(const std::string& path, const LiveSnapshot& snapshot) {
    auto it = m_objects.find(path);
    if (it == m_objects.end()) {
        if (m_objects.size() >= kMaxBound) m_objects.clear();
        it = m_objects.emplace(path, LiveObject(*m_experiment, *m_layout, *m_registry, path)).first;
    }
    return it->second.read(snapshot);
}

} // namespace trundle
