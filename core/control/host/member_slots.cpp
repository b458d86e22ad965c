#include "control/host/member_slots.h"

#include <algorithm>

namespace trundle {

std::size_t MemberSlots::place(const RobotSpec& robot, const ControllerSpec& controller, const SignalLayout& layout,
                               std::size_t first) {
    const ImageSpan* image = layout.imageOf(robot.name);
    m_inBlock = image ? image->offset : 0;
    m_inImage = first;
    m_count = image ? image->count : 0;
    m_written.clear();
    const std::string published = robot.name + "/" + controller.name + "/";
    for (const SignalEntry& entry : layout.entriesOf(robot.name)) {
        if (!entry.path.starts_with(published)) continue;
        if (!m_written.empty() && m_written.back().inBlock + m_written.back().count == entry.offset)
            m_written.back().count += entry.count;
        else m_written.push_back({entry.offset, m_inImage + entry.offset - m_inBlock, entry.count});
    }
    m_published = m_written.size();
    return first + m_count;
}

void MemberSlots::claim(const SignalEntry& command, std::span<const double> block, std::span<double> commands) {
    if (std::ranges::find(m_written, command.offset, &Written::inBlock) != m_written.end()) return;
    m_written.push_back({command.offset, m_inImage + command.offset - m_inBlock, command.count});
    std::copy_n(block.data() + command.offset, command.count, commands.data() + m_written.back().inImage);
}

void MemberSlots::copyIn(std::span<const double> block, std::span<double> sensors, std::span<double> commands) const {
    std::ranges::copy(block.subspan(m_inBlock, m_count), sensors.begin() + static_cast<std::ptrdiff_t>(m_inImage));
    for (const Written& written : m_written)
        std::copy_n(block.data() + written.inBlock, written.count, commands.data() + written.inImage);
}

void MemberSlots::copyOut(std::span<const double> commands, std::span<double> block) const {
    for (const Written& written : m_written)
        std::copy_n(commands.data() + written.inImage, written.count, block.data() + written.inBlock);
}

} // namespace trundle
