#pragma once
// Edits of the document since the run was built: which the run took over, and which wait for a reset.

#include <string>
#include <vector>

#include <QObject>

#include "editor/running/live_edits.h"
#include "editor/running/robot_match.h"

namespace trundle {

class RunEdits final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// A run of this project begins; null: none.
    void begin(std::shared_ptr<const LoadedProject> built);
    /// The document was edited. `source`: what a run would be built from now. `running`: the experiment of the run.
    [[nodiscard]] LiveEdits follow(const ChangeSet& changes, const std::shared_ptr<const LoadedProject>& source,
                                   const ExperimentSpec& running);
    void setWaiting(std::vector<std::string> paths);
    /// No edit waits any more. True if some did; changed() is left to the caller.
    [[nodiscard]] bool clear();

    /// Sorted dotted paths of properties and objects whose change in the document waits for a reset.
    [[nodiscard]] const std::vector<std::string>& waiting() const { return m_waiting; }
    [[nodiscard]] bool needsReset() const { return !m_waiting.empty(); }
    [[nodiscard]] QString waitingText() const; ///< "robot0.Pos, Tick and 3 more"
    /// Whether a property, or an object that contains it, is among them.
    [[nodiscard]] bool waitsForReset(const std::string& propertyPath) const;
    /// Whether the document's robot of that name is the one in the run, not a newer one with the same name.
    [[nodiscard]] bool isOfRun(const std::string& robot) const { return m_sameRobots.has(robot); }

Q_SIGNALS:
    void changed(); ///< needsReset() or the waiting edits changed

private:
    std::vector<std::string> m_waiting;
    std::shared_ptr<const LoadedProject> m_built;
    RobotMatch m_sameRobots;
    RunComparison m_comparison;
};

} // namespace trundle
