#include "editor/running/pose_overlay.h"

namespace trundle {

std::optional<Pose> shownPose(const SignalLayout& layout, const SignalBlock& block, const std::string& robot) {
    const SignalEntry* entry = layout.find(robot + "/pose");
    if (!entry || entry->count != 7 || entry->offset + 7 > block.slots().size()) return std::nullopt;
    const double* s = block.slots().data() + entry->offset;
    const Quat rotation(s[3], s[4], s[5], s[6]);
    const Vec3 position(s[0], s[1], s[2]);
    if (!position.allFinite() || !(rotation.norm() > 1e-6)) return std::nullopt;
    return Pose{position, rotation.normalized()};
}

void moveRobot(BodyPoses& poses, const ExperimentSpec& experiment, const std::string& robot, const Pose& motion) {
    std::size_t at = 0;
    for (const RobotSpec& spec : experiment.robots) {
        if (!spec.config) continue;
        for (std::size_t b = 0; b < spec.config->bodies.size(); ++b, ++at)
            if (spec.name == robot && at < poses.size()) poses[at] = motion * poses[at];
    }
}

} // namespace trundle
