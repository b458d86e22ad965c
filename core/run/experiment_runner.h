#pragma once
// The Runner implementation; see runner.h for the contract.

#include <optional>
#include <string>

#include "base/clean_text.h"
#include "run/console_limit.h"
#include "run/controller_set.h"
#include "run/logs/log.h"
#include "run/logs/log_folder.h"
#include "run/run_pictures.h"
#include "run/runner.h"
#include "run/schedule.h"
#include "run/world_warnings.h"

namespace trundle {

class ExperimentRunner final : public Runner {
public:
    ExperimentRunner(std::unique_ptr<World> world, RunOptions options);
    ~ExperimentRunner() override { (void)finish(); }

    // Steps of create(), in this order. Errors go to `diagnostics`.
    void startControllers(const BackendFactory& backends, Diagnostics& diagnostics) {
        m_controllers.start(backends, diagnostics);
    }
    void openLogs(Diagnostics& diagnostics);

    Status tick() override;
    void command(decltype(Command::what) what) override;
    const std::vector<Command>& commands() const override { return m_commands; }
    const std::vector<Diagnostic>& warnings() const override { return m_warnings; }
    const Diagnostic* failure() const override { return m_failure ? &*m_failure : nullptr; }
    const std::vector<StoppedController>& stoppedControllers() const override { return m_controllers.stopped(); }
    std::vector<const ControllerSpec*> controllersOf(const std::string& robot) const override {
        return m_controllers.specsOf(robot);
    }
    std::vector<ControllerCost> controllerCosts() const override { return m_controllers.costs(); }
    const RunFinish* finished() const override { return m_finish ? &*m_finish : nullptr; }
    void flushLogs() override;
    Status finish() override;
    World& world() override { return *m_world; }
    CameraCapture& cameras() override { return m_cameras; }
    std::vector<std::string> logFiles() const override;

private:
    struct OpenLog {
        std::unique_ptr<RunLog> log;
        LogFile* file;
        Schedule schedule;
        SourceRange range;
    };

    /// A file of a controller.
    struct ControllerLog {
        LogFile* file;
        std::string robot, controller;
        std::uint64_t start; ///< of the controller, the latest that opened it
    };

    const ExperimentSpec& experiment() const { return m_world->experiment(); }
    ControllerOutputs outputsFor(const RobotSpec& robot, const ControllerSpec& controller);
    [[nodiscard]] ControllerLog* controllerLog(const std::string& fileName);
    Result<LogFile*> createLog(const std::string& fileName);
    int openControllerLog(ControllerLog asked, const std::string& fileName);
    void addMessage(const std::string& who, int severity, const std::string& text);
    /// A message of the run itself, which does not count as a line of the robot.
    void say(const std::string& who, int severity, const std::string& text) {
        if (m_options.console)
            m_options.console(tickTime(m_world->ticks(), experiment().settings.tick), who, severity, cleanText(text));
    }
    void reportDropped();
    Status fail(const Error& error, SourceRange range);

    void applyCommands();
    Status apply(const Command& command);
    Status writeLogs();
    void writeCollected();
    void closeFinish();

    RunOptions m_options;
    ConsoleLimit m_console;
    std::unique_ptr<World> m_world; // before the controllers, which refer to its signal block
    CameraCapture m_cameras;
    LogFolder m_folder; // before the controllers, which write into it
    std::vector<Diagnostic> m_warnings;
    RunPictures m_pictures{*m_world, m_cameras, m_folder, m_warnings};
    ControllerSet m_controllers;
    std::vector<OpenLog> m_logs;
    std::vector<ControllerLog> m_controllerLogs; // index: the number returned to the controller
    std::uint64_t m_starts = 0;                  // of all controllers
    std::vector<Command> m_commands;
    std::size_t m_applied = 0; // number of commands already applied
    std::optional<Diagnostic> m_failure;
    std::optional<RunFinish> m_finishAsked, m_finish; // requested in the current tick; set after that tick
    Schedule m_reportsDropped;                        // once per second
    std::string m_rows;
    WorldWarnings m_worldWarnings;
    bool m_finished = false;
    bool m_hasLogs = false; ///< its logs are open: those of the last run can go
};

} // namespace trundle
