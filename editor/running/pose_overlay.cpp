#include "editor/running/pose_overlay.h"

#include <algorithm>
#include <initializer_list>

#include "model/joined_robots.h"
#include "model/passive_objects.h"

namespace trundle {

namespace {

std::optional<Pose> poseIn(const SignalLayout& layout, const SignalBlock& block, const std::string& owner) {
    const auto entry = layout.find(owner + "/pose");
    if (!entry || entry->count != 7 || entry->offset + 7 > block.slots().size()) return std::nullopt;
    const double* s = block.slots().data() + entry->offset;
    const Quat rotation(s[3], s[4], s[5], s[6]);
    const Vec3 position(s[0], s[1], s[2]);
    if (!position.allFinite() || !(rotation.norm() > 1e-6)) return std::nullopt;
    return Pose{position, rotation.normalized()};
}

void put(const SignalLayout& layout, SignalBlock& block, const std::string& owner, const Pose& pose) {
    const auto write = [&](const char* signal, std::initializer_list<double> values) {
        const auto entry = layout.find(owner + signal);
        if (!entry || entry->count != values.size()) return;
        std::ranges::copy(values, block.slots().begin() + entry->offset);
    };
    const Vec3& p = pose.position;
    const Quat& q = pose.rotation;
    write("/pose", {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
    write("/velocity", {0, 0, 0, 0, 0, 0});
}

void move(const SignalLayout& layout, SignalBlock& block, const RobotSpec& robot, const Pose& motion) {
    const auto moveOwner = [&](const std::string& owner) {
        if (const auto pose = poseIn(layout, block, owner)) put(layout, block, owner, motion * *pose);
    };
    moveOwner(robot.name);
    if (!robot.config) return;
    for (const BodySpec& body : robot.config->bodies) moveOwner(robot.name + "/" + body.name);
}

} // namespace

std::optional<Pose> shownPose(const SignalLayout& layout, const SignalBlock& block, const RobotSpec& robot) {
    if (!isPassive(robot)) return poseIn(layout, block, robot.name);
    const BodySpec& first = robot.config->bodies[0];
    const auto body = poseIn(layout, block, robot.name + "/" + first.name);
    return body ? std::optional(*body * first.pose.inverse()) : std::nullopt;
}

std::shared_ptr<const SignalBlock> withPlaced(const SignalLayout& layout, const SignalBlock& block,
                                              const ExperimentSpec& experiment, const std::vector<PlaceCommand>& placed) {
    auto moved = std::make_shared<SignalBlock>(layout);
    moved->copyFrom(block);
    const JoinedRobots joined(experiment);
    for (const PlaceCommand& place : placed) {
        const auto robot = std::ranges::find_if(experiment.robots, [&](const RobotSpec& r) { return r.name == place.robot; });
        if (robot == experiment.robots.end() || !robot->config) continue;
        const auto now = shownPose(layout, block, *robot);
        if (!now) continue;
        const Pose motion = place.pose * now->inverse();
        for (const std::size_t i : joined.with(static_cast<std::size_t>(robot - experiment.robots.begin())))
            move(layout, *moved, experiment.robots[i], motion);
        if (!isPassive(*robot)) put(layout, *moved, place.robot, place.pose); // to the bit
    }
    return moved;
}

} // namespace trundle
