#include "editor/running/robot_match.h"

#include "model/experiment_spec.h"
#include "model/outline.h"

namespace trundle {
namespace {

const Part* partOf(const LoadedProject& loaded, const std::string& robot) {
    const Part* part = loaded.outline->world.find(robot);
    return part ? part : layoutOfMember(*loaded.outline, robot);
}

std::string textOf(const LoadedProject& loaded, const Part& part) {
    return std::string(loaded.outline->texts().slice(part.range));
}

} // namespace

void RobotMatch::begin(std::shared_ptr<const LoadedProject> built) {
    m_gone.clear();
    m_built = m_seen = std::move(built);
}

void RobotMatch::follow(const ChangeSet& changes) {
    const std::shared_ptr<const LoadedProject>& now = changes.after();
    if (!m_built || now == m_seen) return;
    const auto before = std::exchange(m_seen, now);
    if (before == changes.before() && !changes.changesStructure() && m_gone.empty()) return;
    for (const RobotSpec& robot : m_built->experiment->robots) {
        const Part* is = partOf(*now, robot.name);
        const auto gone = m_gone.find(robot.name);
        if (gone != m_gone.end()) {
            if (is && textOf(*now, *is) == gone->second) m_gone.erase(gone);
        } else if (const Part* was = is ? nullptr : partOf(*before, robot.name)) {
            m_gone.emplace(robot.name, textOf(*before, *was));
        }
    }
}

} // namespace trundle
