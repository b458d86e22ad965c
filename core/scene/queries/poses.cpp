#include "scene/queries/poses.h"

#include <algorithm>
#include <cmath>

#include <trundle/equipment_signals.h>

namespace trundle {
namespace {

constexpr std::uint32_t kPoseSlots = 7;  // x y z qw qx qy qz
constexpr std::uint32_t kPointSlots = 4; // x y z begins

} // namespace

BodyPoses startPoses(const ExperimentSpec& experiment) {
    BodyPoses poses;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) poses.push_back(robot.pose * body.pose);
    }
    for (const LedModel& led : ledsOf(experiment)) poses.leds.push_back(led.atStart);
    return poses;
}

PoseReader::PoseReader(const ExperimentSpec& experiment, const SignalLayout& layout) : m_start(startPoses(experiment)) {
    m_offsets.reserve(m_start.size());
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) {
            const auto entry = layout.find(robot.name + "/" + body.name + "/pose");
            const bool usable = entry && entry->count == kPoseSlots && entry->offset + kPoseSlots <= layout.slotCount();
            m_offsets.push_back(usable ? entry->offset : kAbsent);
        }
    }
    findPens(experiment, layout);
    for (const LedModel& led : ledsOf(experiment)) {
        const auto lit = layout.find(led.path + "/lit"), colour = layout.find(led.path + "/color");
        const bool usable = lit && colour && colour->count == 3;
        m_leds.push_back(usable ? LedSlots{lit->offset, colour->offset} : LedSlots{});
    }
}

void PoseReader::findPens(const ExperimentSpec& experiment, const SignalLayout& layout) {
    for (const RobotSpec& robot : experiment.robots)
        for (const ComponentSpec& device : robot.config ? robot.config->devices : std::vector<ComponentSpec>()) {
            if (device.kind != PenSignals::kKind) continue;
            const std::string path = robot.name + "/" + device.name;
            const auto line = layout.find(path + "/line"), count = layout.find(path + "/points");
            if (!line || !count) continue;
            PenSlots pen{{}, line->offset, count->offset, line->count / kPointSlots};
            pen.empty.width = device.number("Width", 0.01);
            const ResolvedValue* colour = device.find("ColorRGB");
            for (std::size_t k = 0; k < 3 && colour && colour->value.numbers.size() == 3; ++k)
                pen.empty.colour[k] = colour->value.numbers[k];
            m_pens.push_back(std::move(pen));
        }
}

void PoseReader::readLines(std::span<const double> slots, BodyPoses& poses) const {
    poses.lines = nullptr;
    if (m_pens.empty()) return;
    auto lines = std::make_shared<std::vector<PenLine>>();
    for (const PenSlots& pen : m_pens) {
        if (pen.count >= slots.size() || std::size_t{pen.line} + pen.capacity * kPointSlots > slots.size()) continue;
        const double written = slots[pen.count];
        const auto count = written > 0 ? std::min(pen.capacity, static_cast<std::uint32_t>(written)) : 0;
        PenLine& line = lines->emplace_back(pen.empty);
        for (std::uint32_t i = 0; i < count; ++i) {
            const double* s = slots.data() + pen.line + std::size_t{i} * kPointSlots;
            const Vec3 at(s[0], s[1], s[2]);
            if (at.allFinite()) line.points.push_back({at, s[3] != 0});
        }
    }
    poses.lines = std::move(lines);
}

void PoseReader::read(const SignalBlock& block, BodyPoses& poses) const {
    if (poses.size() != m_start.size() || poses.leds.size() != m_start.leds.size()) poses = m_start;
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
    readLines(slots, poses);
    for (std::size_t i = 0; i < m_leds.size(); ++i) {
        const auto [lit, colour] = m_leds[i];
        if (lit == kAbsent || std::max(lit + 1, colour + 3) > slots.size()) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double share = slots[colour + k];
            poses.leds[i][k] = slots[lit] != 0 && std::isfinite(share) ? static_cast<float>(std::clamp(share, 0.0, 1.0)) : 0;
        }
    }
}

std::size_t PoseReader::found() const {
    return static_cast<std::size_t>(
        std::count_if(m_offsets.begin(), m_offsets.end(), [](std::uint32_t o) { return o != kAbsent; }));
}

} // namespace trundle
