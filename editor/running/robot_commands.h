#pragma once
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include <trundle/geometry.h>

#include "editor/running/active_run.h"

namespace trundle {

class Document;
class EndedRobots;
class RunEdits;
class RunMessages;
struct StartPoses;

/// The user's commands to the robots of a running world; the runner stamps them with their tick. On failure RunMessages::refused()
/// gives the reason.
class RobotCommands final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    RobotCommands(const ActiveRun& run, const RunEdits& edits, const EndedRobots& ended, RunMessages& messages,
                  Document& document, QObject* parent = nullptr);

    /// Applies a force (N, world frame) at a point (m, world frame) of "robot0/chassis" in every tick until endPush(). While
    /// paused it starts with the next tick.
    bool push(const std::string& body, const Vec3& force, const Vec3& point);
    void endPush();
    /// Moves a robot to a pose (world frame), at rest, and what is joined to it along. While paused it is shown there at once.
    bool place(const std::string& robot, const Pose& pose);
    /// Drives a robot by its drive, m/s and rad/s. Its controller is not called until stopDriving(); after that the
    /// robot stops until the controller sends a new command.
    bool drive(const std::string& robot, double linear, double angular);
    void stopDriving();
    /// Loads a module again, by the path of its library, and starts its controllers from their setup; empty: all modules.
    bool reloadModules(const std::string& library);
    /// Starts the controllers of these robots again, from their setup, where they are. A controller that was stopped with others
    /// of its process is started with them.
    bool restartControllers(const std::vector<std::string>& controllers);
    /// The controllers of these robots are not called any more until they are restarted; the robots' commands become 0.
    bool stopControllers(const std::vector<std::string>& controllers);
    [[nodiscard]] std::string driven() const { return m_driven; } ///< robot, or empty
    /// Why a robot cannot be driven; empty if it can.
    [[nodiscard]] QString driveRefusal(const std::string& robot) const;
    [[nodiscard]] const EndedRobots& ended() const { return m_ended; } ///< those that take no commands any more
    /// Current pose of a robot's config frame in the world, including a place() that waits for the next tick.
    [[nodiscard]] std::optional<Pose> pose(const std::string& robot) const;
    /// All commands of the run so far, with their ticks; none at Start.
    [[nodiscard]] std::vector<Command> all() const;

    /// Why the poses cannot be kept; empty if they can.
    [[nodiscard]] QString keepRefusal() const;
    void keepPoses(); ///< sets Pos and HPR of the robots that moved, as one edit of the document

    /// The snapshot with the robots that were placed since its tick.
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> withPlacedRobots(std::shared_ptr<const LiveSnapshot> snapshot);
    void endDriving() { m_driven.clear(); } ///< the run has ended
    void clear();

Q_SIGNALS:
    void placed(); ///< while paused: the snapshot has to be shown again

private:
    [[nodiscard]] StartPoses posesNow() const;
    template <class Order> [[nodiscard]] std::size_t order(const std::vector<std::string>& robots);
    [[nodiscard]] QString endedRefusal(std::string_view robot) const;

    const ActiveRun& m_run;
    const RunEdits& m_edits;
    const EndedRobots& m_ended;
    RunMessages& m_messages;
    Document& m_document;
    std::vector<PlaceCommand> m_placed; // placed at m_placedTick while paused, not in a snapshot yet
    std::uint64_t m_placedTick = 0;
    std::string m_driven;
};

} // namespace trundle
