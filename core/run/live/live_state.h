#pragma once
// What a LiveRun shows of its run.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "run/runner.h"
#include "signals/block.h"
#include "signals/camera_image.h"
#include "signals/layout.h"
#include "world/world.h"

namespace trundle {

/// Running: also while single ticks are executed. Paused: the snapshot shows the current tick. Ended: by Duration (see
/// Options::canContinue), a controller's finish(), a fault, a failed controller, or a failed build; the logs are closed by then.
enum class LivePhase { Building, Paused, Running, Ended };

/// A copy of a contact, valid without the world.
struct LiveContact {
    std::string first, second; ///< geoms "robot0/chassis/bumper", "arena/north"
    Vec3 position = Vec3::Zero(), normal = Vec3::UnitZ();
    double depth = 0, force = 0; ///< m, N
};

/// The state after one tick. Immutable; may be kept as long as needed.
struct LiveSnapshot {
    std::shared_ptr<const SignalBlock> block;
    std::shared_ptr<const std::vector<LiveContact>> contacts; ///< null unless enabled
    std::uint64_t tick = 0, quickTicks = 0;
    EngineChoice engine = EngineChoice::General;
    unsigned threads = 1; ///< of the engine
    double time = 0;           ///< s, simulated
    double realTimeFactor = 0; ///< over about the last second; 0 while paused
    double stepMs = 0;         ///< mean wall time per tick since the previous snapshot
    std::size_t contactCount = 0;
    std::vector<RobotEnd> ended;       ///< robots that ended by a fault of their own while the run continues; only grows
    std::vector<StoppedController> stopped; ///< controllers that a fault of their own or a command stopped
    std::vector<ControllerCost> costs;      ///< of all controllers
    std::optional<std::uint64_t> hash; ///< World::stateHash(); set only while paused or ended
    RunImages images;                  ///< the newest image of each camera that a controller or a log has used so far
};

struct LiveLine {
    double time = 0;
    std::string who; ///< "robot0", "robot0/leftMotor"; "" for the run itself
    int severity = 0;
    std::string text;
};

/// Console lines since the last call. If too many are waiting, the oldest are dropped and counted.
struct LiveLines {
    std::vector<LiveLine> lines;
    std::uint64_t dropped = 0;
};

/// A consistent view of the run at one moment.
struct LiveView {
    LivePhase phase = LivePhase::Building;
    std::shared_ptr<const SignalLayout> layout;   ///< null until built
    std::shared_ptr<const LiveSnapshot> snapshot; ///< null until built
};

struct LiveEnd {
    std::optional<Diagnostic> failure; ///< none: ended by Duration or by a controller
    std::optional<RunFinish> finish;   ///< set if a controller ended the run
    std::string body;                  ///< the body with the fault: "robot0/chassis"; empty: none
    double time = 0;                   ///< s, simulated
    std::vector<Diagnostic> problems;  ///< diagnostics of the build
    std::vector<std::string> logFiles;
    bool canContinue = false; ///< ended by Duration with logs flushed but open: run() and step() continue without limit
};

/// Creates the runner; called once, on the run's thread. Everything that it references must outlive the run.
using RunnerMaker = std::function<std::unique_ptr<Runner>(RunOptions, Diagnostics&)>;

} // namespace trundle
