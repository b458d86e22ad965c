#pragma once
// The run that a server gives to its clients: its state, its commands, and how it starts again. Used by one thread.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/diagnostic.h"
#include "lang/source_text.h"
#include "run/runner.h"

namespace trundle {

/// What was built from a text, or why it was not.
struct ServedExperiment {
    std::shared_ptr<Runner> runner; ///< null: see the problems
    SourceTable sources;            ///< of the problems, and of the run's diagnostics
    std::vector<Diagnostic> problems;
};
/// Builds the experiment at tick 0; with a seed, in place of the one that it had. What it references must outlive the run.
using ExperimentMaker = std::function<ServedExperiment(std::optional<std::uint64_t> seed)>;

/// Paused: also while single ticks are executed. Ended: only a reset helps.
enum class ServedState { Paused, Running, Ended };

class ServedRun {
public:
    explicit ServedRun(ExperimentMaker maker) : m_maker(std::move(maker)) {}
    /// A run that is paced elsewhere, and outlives this object: it is not reset, and ticks come from beginTick() and endTick().
    explicit ServedRun(Runner& runner);
    [[nodiscard]] bool isPacedElsewhere() const { return !m_maker; }
    /// Of such a run: what it does now.
    void follow(bool running, double speed);

    /// Builds the experiment again. False, with problems in built(), if that fails; there is no run then.
    bool reset(std::optional<std::uint64_t> seed = {});
    [[nodiscard]] const ServedExperiment& built() const { return m_built; }

    [[nodiscard]] bool exists() const { return m_built.runner != nullptr; }
    [[nodiscard]] Runner& runner() { return *m_built.runner; } ///< only if it exists
    [[nodiscard]] World& world() { return m_built.runner->world(); }

    [[nodiscard]] ServedState state() const { return m_state; }
    [[nodiscard]] double speed() const { return m_speed; } ///< simulated s per s; 0: as fast as possible
    void run(double speed);
    void pause();
    /// Why it is over: a controller's finish(), or a failure. Empty otherwise.
    [[nodiscard]] std::string endReason() const;
    [[nodiscard]] const Diagnostic* failure() const { return exists() ? m_built.runner->failure() : nullptr; }

    /// Before a tick: passes on the commands for it.
    void beginTick();
    /// At the text's Duration a running one pauses, once.
    void endTick(bool good);
    /// It has just paused at the text's Duration.
    [[nodiscard]] bool isAtDuration() const { return m_atDuration; }

    // Commands for the coming tick: of several that set the same, the last counts; all pushes act. They fail without effect.
    /// Fails for the robot of a controller that is not held: that writes the commands of its robot.
    [[nodiscard]] Status setSignal(const std::string& path, const std::vector<double>& values);
    /// Fails if the robot of a path "other/radio" has a controller that is not held.
    [[nodiscard]] Status checkOwner(const std::string& path) const;
    [[nodiscard]] Status checkSignal(const std::string& path, std::size_t count) const;
    [[nodiscard]] Status hold(const std::string& robot, bool held);
    [[nodiscard]] Status place(const std::string& robot, const Pose& pose);
    [[nodiscard]] Status push(const std::string& body, const Vec3& force, const Vec3& point);
    [[nodiscard]] Status restart(const std::string& robot);
    [[nodiscard]] bool isHeld(const std::string& robot) const { return m_held.contains(robot); }
    [[nodiscard]] const RobotSpec* robot(const std::string& name) const;

private:
    ExperimentMaker m_maker;
    ServedExperiment m_built;
    ServedState m_state = ServedState::Ended;
    double m_speed = 1;
    std::uint64_t m_durationTicks = 0;
    bool m_atDuration = false;
    std::map<std::string, decltype(Command::what)> m_commands; ///< for the coming tick, by what they set; pushes by their number
    std::uint64_t m_pushes = 0;                                ///< so far
    std::set<std::string> m_held;
};

/// [{severity, code, message, file, line, column}], errors first, the first hundred; line and column count from 1, 0 without a place.
[[nodiscard]] nlohmann::ordered_json problemsJson(const std::vector<Diagnostic>& problems, const SourceTable& sources);

} // namespace trundle
