#pragma once
#include <map>
#include <memory>
#include <string>

#include "project/edits/change_set.h"

namespace trundle {

/// Tracks which robots of a run still exist in the document. A name is not enough: a robot may be removed and another one get
/// its name.
class RobotMatch {
public:
    void begin(std::shared_ptr<const LoadedProject> built);
    /// Call it with every change of the document.
    void follow(const ChangeSet& changes);
    /// False for a robot that was removed and has not been restored unchanged, for example by undo.
    [[nodiscard]] bool has(const std::string& robot) const { return !m_gone.contains(robot); }

private:
    std::shared_ptr<const LoadedProject> m_built, m_seen;
    std::map<std::string, std::string> m_gone; ///< removed robots: text at removal, by name
};

} // namespace trundle
