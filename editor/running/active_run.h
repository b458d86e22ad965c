#pragma once
// The run of the window as its parts share it, and what it has built and done so far.

#include <memory>
#include <optional>

#include <QString>

#include "model/experiment_spec.h"
#include "project/loading/project.h"
#include "run/live/live_run.h"
#include "scene/queries/poses.h"

namespace trundle {

/// Start: no world is built, the document's start poses are shown. Ended: by Duration, by a fault or a failed controller.
enum class RunState { Start, Building, Running, Paused, Ended };

/// Everything is null at Start.
struct RunResults {
    /// The project that was built, whose texts the run's diagnostics refer to.
    std::shared_ptr<const LoadedProject> built;
    /// The running experiment as built, with live changes applied. Other edits made since are only in the document.
    std::shared_ptr<const ExperimentSpec> experiment;
    std::shared_ptr<const SignalLayout> layout;   ///< null while it is built
    std::shared_ptr<const LiveSnapshot> snapshot; ///< newest tick and statistics; null while it is built
    std::shared_ptr<const BodyPoses> poses;       ///< current poses of the bodies of `experiment`; null while it is built
    std::optional<LiveEnd> end;                   ///< how and why it ended; nothing before

    [[nodiscard]] double time() const { return snapshot ? snapshot->time : 0; } ///< s, simulated
    /// Over the last second; 0 while it does not run.
    [[nodiscard]] double realTimeFactor() const { return snapshot ? snapshot->realTimeFactor : 0; }
    [[nodiscard]] EngineChoice engine() const { return snapshot ? snapshot->engine : EngineChoice::General; }
    /// The run has reached its Duration: run(), step() and runFor() continue it and its logs.
    [[nodiscard]] bool canResume() const { return end && end->canContinue; }
    /// "finished by robot_0/brain at t = 83.5 s: reached"; empty if no controller ended the run.
    [[nodiscard]] QString finishText() const;
    /// The robot of the running experiment; null if no robot has that name.
    [[nodiscard]] const RobotSpec* robot(const std::string& name) const;
};

struct ActiveRun : RunResults {
    RunState state = RunState::Start;
    std::unique_ptr<LiveRun> live; ///< null at Start

    /// There is a world that executes commands in its next tick.
    [[nodiscard]] bool acceptsCommands() const { return state == RunState::Running || state == RunState::Paused; }
};

} // namespace trundle
