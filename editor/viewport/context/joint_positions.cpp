#include "editor/viewport/context/joint_positions.h"

#include "scene/queries/joint_motion.h"

namespace trundle {

double JointPositions::at(const RobotSpec& robot, std::size_t coordinate) const {
    const auto all = jointCoordinates(*robot.config);
    if (coordinate >= all.size()) return 0;
    const auto found = m_positions.find({robot.name, robot.config->joints[all[coordinate].joint].name, all[coordinate].part});
    return found == m_positions.end() ? 0 : found->second;
}

void JointPositions::set(const RobotSpec& robot, std::size_t coordinate, double position) {
    const auto all = jointCoordinates(*robot.config);
    if (coordinate >= all.size()) return;
    std::vector<double> positions;
    for (std::size_t i = 0; i < all.size(); ++i) positions.push_back(at(robot, i));
    setJointPosition(*robot.config, all, coordinate, position, positions);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Key key{robot.name, robot.config->joints[all[i].joint].name, all[i].part};
        if (positions[i] == 0) m_positions.erase(key);
        else m_positions[key] = positions[i];
    }
    Q_EMIT changed();
}

void JointPositions::reset() {
    if (m_positions.empty()) return;
    m_positions.clear();
    Q_EMIT changed();
}

void JointPositions::apply(const ObjectIndex& objects, BodyPoses& poses) const {
    if (m_positions.empty()) return;
    const auto& robots = objects.experiment().robots;
    for (std::size_t r = 0; r < robots.size(); ++r) {
        const auto first = m_positions.lower_bound({robots[r].name, {}, 0});
        if (!robots[r].config || first == m_positions.end() || std::get<0>(first->first) != robots[r].name) continue;
        const RobotConfigSpec& config = *robots[r].config;
        const auto all = jointCoordinates(config);
        std::vector<double> positions;
        for (std::size_t i = 0; i < all.size(); ++i) positions.push_back(at(robots[r], i));
        const std::vector<Pose> motions = bodyMotions(config, all, positions);
        for (std::size_t b = 0; b < config.bodies.size(); ++b)
            poses[objects.firstPose(r) + b] = robots[r].pose * motions[b] * config.bodies[b].pose;
    }
}

} // namespace trundle
