#include "scene/queries/poses.h"

namespace trundle {
namespace {

constexpr std::uint32_t kPoseSlots = 7; // x y z qw qx qy qz

} // namespace

BodyPoses startPoses(const ExperimentSpec& experiment) {
    BodyPoses poses;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) poses.push_back(robot.pose * body.pose);
    }
    return poses;
}

PoseReader::PoseReader(const ExperimentSpec& experiment, const SignalLayout& layout) : m_start(startPoses(experiment)) {
    m_offsets.reserve(m_start.size());
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) {
            const SignalEntry* entry = layout.find(robot.name + "/" + body.name + "/pose");
            const bool usable = entry && entry->count == kPoseSlots && entry->offset + kPoseSlots <= layout.slotCount();
            m_offsets.push_back(usable ? entry->offset : kAbsent);
        }
    }
}

void PoseReader::read(const SignalBlock& block, BodyPoses& poses) const {
    if (poses.size() != m_start.size()) poses = m_start;
    const std::span<const double> slots = block.slots();
    for (std::size_t i = 0; i < m_offsets.size(); ++i) {
        if (m_offsets[i] == kAbsent || m_offsets[i] + kPoseSlots > slots.size()) continue;
        const double* s = slots.data() + m_offsets[i];
        const Vec3 position{s[0], s[1], s[2]};
        const Quat rotation{s[3], s[4], s[5], s[6]};
        const double norm = rotation.norm();
        if (!position.allFinite() || !(norm > 1e-6 && norm < 1e6)) continue;
        poses[i] = {position, rotation.normalized()};
    }
}

std::size_t PoseReader::found() const {
    return static_cast<std::size_t>(
        std::count_if(m_offsets.begin(), m_offsets.end(), [](std::uint32_t o) { return o != kAbsent; }));
}

} // namespace trundle
