#include "remote/remote_world.h"

#include <algorithm>

namespace trundle {

RemoteWorld::RemoteWorld(std::unique_ptr<World> described, std::unique_ptr<RobotLink> link)
    : m_described(std::move(described)), m_link(std::move(link)) {
    join();
    takeValues();
}

void RemoteWorld::join() {
    const std::string robot = experiment().robots[0].name;
    for (const SignalEntry& entry : layout().entries()) {
        if (isPublished(entry.path)) continue; // the controller here writes it, that at the other end rests
        const auto found = std::ranges::find(m_link->signals(), entry.path, &RobotLink::Signal::path);
        const bool isCommand = entry.direction == SignalDirection::Command;
        const bool isThere = found != m_link->signals().end() && found->count == entry.count;
        if (!isThere || (found->direction == "command") != isCommand) {
            if (entry.direction != SignalDirection::Truth) m_missing.push_back(entry.path);
            continue;
        }
        if (isCommand) m_commands.push_back({entry.offset, found->offset, entry.path, std::vector<double>(entry.count)});
        if (isCommand) continue;
        m_read.push_back({entry.offset, found->offset, entry.count});
        if (entry.path == robot + "/pose") m_pose = entry.offset;
        if (!m_odometry && entry.path.ends_with("/odometry") && entry.count == 3) m_odometry = entry.offset;
    }
}

bool RemoteWorld::isPublished(const std::string& path) const {
    const RobotSpec& robot = experiment().robots[0];
    return std::ranges::any_of(robot.controllers, [&](const ControllerSpec& controller) {
        return path.starts_with(robot.name + "/" + controller.name + "/");
    });
}

void RemoteWorld::takeValues() {
    const std::span<double> slots = block().slots();
    for (const Span& span : m_read)
        std::ranges::copy(m_link->values().subspan(span.there, span.count),
                          slots.begin() + static_cast<std::ptrdiff_t>(span.here));
    for (CommandOf& command : m_commands) { // a drive commands its motors
        std::ranges::copy(m_link->values().subspan(command.there, command.known.size()), command.known.begin());
        std::ranges::copy(command.known, slots.begin() + static_cast<std::ptrdiff_t>(command.here));
    }
}

Status RemoteWorld::tick() {
    std::vector<std::pair<std::string, std::vector<double>>> changes;
    for (const CommandOf& command : m_commands) {
        const auto now = block().slots().subspan(command.here, command.known.size());
        if (!std::ranges::equal(now, command.known)) changes.emplace_back(command.path, std::vector(now.begin(), now.end()));
    }
    if (const Status stepped = m_link->step(changes); !stepped) return stepped;
    BlockHeader& header = block().header();
    ++header.sequence; // odd: write in progress
    takeValues();
    header.tick = ++m_ticks;
    header.time = time();
    ++header.sequence;
    return {};
}

Pose RemoteWorld::robotPose(std::size_t robot) const {
    const std::span<const double> slots = block().slots();
    if (m_pose) {
        const auto at = slots.subspan(*m_pose, 7);
        return {Vec3(at[0], at[1], at[2]), Quat(at[3], at[4], at[5], at[6])};
    }
    const Pose& start = experiment().robots[robot].pose;
    if (!m_odometry) return start;
    const auto at = slots.subspan(*m_odometry, 3);
    return start * Pose{Vec3(at[0], at[1], 0), rotationFromHpr(Vec3(at[2], 0, 0))};
}

Error RemoteWorld::refused() { return {Code::SystemRefused, "this robot is not simulated here"}; }

} // namespace trundle
