#include "editor/running/robot_commands.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/running/ended_robots.h"
#include "editor/running/pose_overlay.h"
#include "editor/running/run_edits.h"
#include "editor/running/run_messages.h"
#include "editor/running/start_poses.h"
#include "editor/widgets/strings.h"
#include "model/joined_robots.h"
#include "project/objects/unplaced_configs.h"

namespace trundle {
namespace {

constexpr std::string_view kDrives[] = {"DifferentialDrive", "SkidDrive", "OmniDrive", "MecanumDrive", "AckermannDrive"};

const ComponentSpec* driveOf(const RobotSpec& robot) {
    if (!robot.config) return nullptr;
    for (const ComponentSpec& device : robot.config->devices)
        if (std::ranges::find(kDrives, device.kind) != std::end(kDrives)) return &device;
    return nullptr;
}

/// The angle at which a base with steered wheels turns as fast as asked; at rest, and in turns that are too narrow for it, its largest.
double steeringFor(const ComponentSpec& drive, double linear, double angular) {
    const double most = drive.number("MaxSteeringAngle");
    return std::clamp(std::atan2(drive.number("WheelBase") * angular, std::abs(linear)), -most, most);
}

/// The signals that make a base move so; without the speeds they stop it.
std::vector<SignalCommand> driveCommands(const std::string& robot, const ComponentSpec& drive, double linear, double angular) {
    const std::string base = robot + "/" + drive.name + "/";
    if (drive.kind == "AckermannDrive")
        return {{base + "linearAmount", 0},
                {base + "linearVelocity", linear},
                {base + "steeringAngle", steeringFor(drive, linear, angular)}};
    std::vector<SignalCommand> commands = {
        {base + "linearAmount", 0}, {base + "angularAmount", 0}, {base + "linearVelocity", linear}};
    if (drive.kind == "OmniDrive" || drive.kind == "MecanumDrive") commands.push_back({base + "lateralVelocity", 0});
    commands.push_back({base + "angularVelocity", angular});
    return commands;
}

} // namespace

RobotCommands::RobotCommands(const ActiveRun& run, const RunEdits& edits, const EndedRobots& ended, RunMessages& messages,
                             Document& document, QObject* parent)
    : QObject(parent), m_run(run), m_edits(edits), m_ended(ended), m_messages(messages), m_document(document) {}

std::optional<Pose> RobotCommands::pose(const std::string& robot) const {
    for (const PlaceCommand& place : m_placed)
        if (place.robot == robot) return place.pose;
    if (!m_run.snapshot || !m_run.layout) return std::nullopt;
    const RobotSpec* spec = m_run.robot(robot);
    return spec ? shownPose(*m_run.layout, *m_run.snapshot->block, *spec) : std::nullopt;
}

bool RobotCommands::push(const std::string& body, const Vec3& force, const Vec3& point) {
    if (!m_run.acceptsCommands()) return m_messages.refuse(tr("A body can be pushed while the experiment runs."));
    if (const QString why = endedRefusal(std::string_view(body).substr(0, body.find('/'))); !why.isEmpty())
        return m_messages.refuse(why);
    if (!force.allFinite() || !point.allFinite()) return false;
    m_run.live->keepPushing(PushCommand{body, force, point});
    return true;
}

void RobotCommands::endPush() {
    if (m_run.live) m_run.live->keepPushing(std::nullopt);
}

bool RobotCommands::place(const std::string& robot, const Pose& to) {
    if (!m_run.acceptsCommands()) return m_messages.refuse(tr("A robot can be moved while the experiment is running or paused."));
    if (!m_run.robot(robot) || !m_edits.isOfRun(robot))
        return m_messages.refuse(tr("%1 is no robot of this run.").arg(QString::fromStdString(robot)));
    if (const QString why = endedRefusal(robot); !why.isEmpty()) return m_messages.refuse(why);
    if (!to.position.allFinite() || !to.rotation.coeffs().allFinite()) return false;
    const std::vector<RobotSpec>& robots = m_run.experiment->robots;
    const JoinedRobots joined(*m_run.experiment);
    const auto index = static_cast<std::size_t>(m_run.robot(robot) - robots.data());
    if (const std::string& hold = joined.hold(index); !hold.empty())
        return m_messages.refuse(tr("%1 cannot be placed: %2.").arg(toQString(robot), toQString(hold)));
    m_run.live->command(PlaceCommand{robot, to});
    if (m_run.state != RunState::Paused || !m_run.snapshot) return true;
    for (const std::size_t i : joined.with(index)) // the last placement of what is joined counts
        std::erase_if(m_placed, [&](const PlaceCommand& place) { return place.robot == robots[i].name; });
    m_placed.push_back({robot, to});
    m_placedTick = m_run.snapshot->tick;
    Q_EMIT placed();
    return true;
}

/// Empty unless it has ended by a fault: then nothing moves it any more.
QString RobotCommands::endedRefusal(std::string_view robot) const {
    return m_ended.hasEnded(robot) ? tr("%1 has ended by a fault, see Problems.").arg(toQString(std::string(robot))) : QString();
}

QString RobotCommands::driveRefusal(const std::string& name) const {
    if (!m_run.acceptsCommands()) return tr("A robot can be driven while the experiment runs.");
    const RobotSpec* robot = m_run.robot(name);
    if (!robot) return tr("Select a robot to drive.");
    if (const QString why = endedRefusal(name); !why.isEmpty()) return why;
    if (!driveOf(*robot))
        return tr("%1 has no drive to steer it by, such as a DifferentialDrive.").arg(QString::fromStdString(name));
    return {};
}

bool RobotCommands::drive(const std::string& name, double linear, double angular) {
    if (const QString why = driveRefusal(name); !why.isEmpty()) return m_messages.refuse(why);
    if (!std::isfinite(linear) || !std::isfinite(angular)) return false;
    if (m_driven != name) {
        stopDriving();
        m_run.live->command(HoldCommand{name, true});
        m_driven = name;
    }
    for (const SignalCommand& command : driveCommands(name, *driveOf(*m_run.robot(name)), linear, angular))
        m_run.live->command(command);
    return true;
}

void RobotCommands::stopDriving() {
    const RobotSpec* robot = m_driven.empty() ? nullptr : m_run.robot(m_driven);
    const ComponentSpec* drive = robot ? driveOf(*robot) : nullptr;
    if (m_run.live && drive) {
        for (const SignalCommand& command : driveCommands(m_driven, *drive, 0, 0)) m_run.live->command(command);
        m_run.live->command(HoldCommand{m_driven, false});
    }
    m_driven.clear();
}

/// Gives one command for each of the controllers. Returns how many.
template <class Order> std::size_t RobotCommands::order(const std::vector<std::string>& controllers) {
    std::size_t ordered = 0;
    for (const std::string& path : controllers) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        const RobotSpec* robot = m_run.robot(path.substr(0, slash));
        if (!robot || robot->controllers.empty()) continue;
        m_run.live->command(Order{robot->name, slash < path.size() ? path.substr(slash + 1) : std::string()});
        ++ordered;
    }
    return ordered;
}

bool RobotCommands::restartControllers(const std::vector<std::string>& controllers) {
    if (!m_run.acceptsCommands()) return m_messages.refuse(tr("A controller can be restarted while the experiment runs."));
    return order<RestartCommand>(controllers) > 0 || m_messages.refuse(tr("Select a robot with a controller."));
}

bool RobotCommands::stopControllers(const std::vector<std::string>& controllers) {
    if (!m_run.acceptsCommands()) return m_messages.refuse(tr("A controller can be stopped while the experiment runs."));
    return order<StopCommand>(controllers) > 0 || m_messages.refuse(tr("Select a robot with a controller."));
}

bool RobotCommands::reloadModules(const std::string& library) {
    if (!m_run.acceptsCommands()) return m_messages.refuse(tr("A module can be reloaded while the experiment runs."));
    m_run.live->command(ReloadCommand{library});
    return true;
}

std::vector<Command> RobotCommands::all() const { return m_run.live ? m_run.live->commands() : std::vector<Command>(); }

std::shared_ptr<const LiveSnapshot> RobotCommands::withPlacedRobots(std::shared_ptr<const LiveSnapshot> snapshot) {
    if (snapshot->tick > m_placedTick) m_placed.clear();
    if (m_placed.empty()) return snapshot;
    auto moved = std::make_shared<LiveSnapshot>(*snapshot);
    moved->contacts = nullptr; // they belong to the previous poses
    moved->images.clear();
    moved->block = withPlaced(*m_run.layout, *snapshot->block, *m_run.experiment, m_placed);
    return moved;
}

void RobotCommands::clear() {
    m_placed.clear();
    m_driven.clear();
}

QString RobotCommands::keepRefusal() const {
    if (!m_run.snapshot || !m_document.loaded()) return tr("Nothing has moved yet: run the experiment first.");
    if (m_document.editedModel().isOpen() || !configsWithoutInstances(*m_document.loaded()).empty())
        return tr("The robot shown is a preview: it has no pose in the text.");
    if (m_run.state == RunState::Running) return tr("Pause the run first.");
    return posesNow().refusal;
}

StartPoses RobotCommands::posesNow() const {
    return startPoses(*m_document.loaded(),
                      [this](const std::string& robot) { return m_edits.isOfRun(robot) ? pose(robot) : std::nullopt; });
}

void RobotCommands::keepPoses() {
    if (const QString why = keepRefusal(); !why.isEmpty()) {
        m_messages.refuse(why);
        return;
    }
    const StartPoses kept = posesNow();
    if (const Status done = m_document.structure().setValues(tr("Keep Poses as Start"), kept.values); !done)
        m_messages.refuse(QString::fromStdString(done.error().message));
    else if (!kept.leftOut.isEmpty())
        Q_EMIT m_document.notice(tr("Poses saved, except of %1: new or renamed since the run started.").arg(kept.leftOut));
}

} // namespace trundle
