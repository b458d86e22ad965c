#pragma once
#include <map>
#include <memory>
#include <string>

#include "project/project.h"

namespace trundle {

/// Which robots of a run the document still has. A name alone does not tell: a robot may go and another take its name.
class SameRobots {
public:
    void begin(std::shared_ptr<const Loaded> built);
    /// Called with every change of the document.
    void follow(std::shared_ptr<const Loaded> now);
    /// False for one that went and did not come back as it was, by Undo for one.
    [[nodiscard]] bool has(const std::string& robot) const { return !m_gone.contains(robot); }

private:
    std::shared_ptr<const Loaded> m_built, m_seen;
    std::map<std::string, std::string> m_gone; ///< their texts when they went, by name
};

} // namespace trundle
