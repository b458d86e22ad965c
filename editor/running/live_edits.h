#pragma once
// The effect of document edits on a running world: live properties are sent as commands, other changes wait for a reset.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "project/edits/change_set.h"
#include "run/command.h"

namespace trundle {

struct LiveEdits {
    std::vector<decltype(Command::what)> commands;
    std::shared_ptr<const ExperimentSpec> experiment; ///< the running one with the live changes; null: none
    std::vector<std::string> waiting;                 ///< dotted paths of all other differences from `built`
    std::set<std::string> swapped;                    ///< paths of controllers that came, went or were replaced
};

/// Follows the edits made during a run. Looks only at what an edit changed, and at everything where that is not known.
class RunComparison {
public:
    void begin(std::shared_ptr<const LoadedProject> built); ///< the text that the run is built from
    /// The next edit. `running`: the experiment as built, with the live edits made since. A text with errors changes nothing in the
    /// run; what it changed is sent after the errors are gone.
    [[nodiscard]] LiveEdits follow(const ChangeSet& changes, const ExperimentSpec& running);
    /// Number of values and of parts of the experiment looked at so far.
    [[nodiscard]] std::size_t compared() const { return m_compared; }

private:
    void findDifferences(const ChangeSet& changes);
    [[nodiscard]] std::vector<std::string> waiting() const;

    std::shared_ptr<const LoadedProject> m_built, m_now;
    std::set<std::string> m_swapped;               ///< paths of controllers that came, went or were replaced during the run
    std::set<std::string> m_differing;             ///< paths of values and blocks whose text differs from m_built
    std::optional<std::set<std::string>> m_unsent; ///< paths of changed blocks that no command was sent for; none: any block
    std::size_t m_compared = 0;
};

} // namespace trundle
