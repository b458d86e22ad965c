// RunSession: user commands to a running world. All are sent to the runner, which stamps them with their tick.
#include <cmath>
#include <numbers>

#include "editor/running/pose_overlay.h"
#include "editor/running/session.h"
#include "editor/running/start_poses.h"
#include "project/objects/unplaced_configs.h"

namespace trundle {
namespace {

const ComponentSpec* driveOf(const RobotSpec& robot) {
    if (!robot.config) return nullptr;
    for (const ComponentSpec& device : robot.config->devices)
        if (device.kind == "DifferentialDrive") return &device;
    return nullptr;
}

} // namespace

const RobotSpec* RunSession::robotNamed(const std::string& name) const {
    if (!m_experiment) return nullptr;
    for (const RobotSpec& robot : m_experiment->robots)
        if (robot.name == name) return &robot;
    return nullptr;
}

std::optional<Pose> RunSession::robotPose(const std::string& robot) const {
    for (const PlaceCommand& place : m_placed)
        if (place.robot == robot) return place.pose;
    if (!m_snapshot || !m_layout) return std::nullopt;
    return shownPose(*m_layout, *m_snapshot->block, robot);
}

bool RunSession::push(const std::string& body, const Vec3& force, const Vec3& point) {
    if (m_state != RunState::Running && m_state != RunState::Paused)
        return reject(tr("A body can be pushed while the experiment runs."));
    if (!force.allFinite() || !point.allFinite()) return false;
    m_run->keepPushing(PushCommand{body, force, point});
    return true;
}

void RunSession::endPush() {
    if (m_run) m_run->keepPushing(std::nullopt);
}

bool RunSession::place(const std::string& robot, const Pose& pose) {
    if (m_state != RunState::Running && m_state != RunState::Paused)
        return reject(tr("A robot can be moved while the experiment is running or paused."));
    if (!robotNamed(robot) || !isOfRun(robot))
        return reject(tr("%1 is no robot of this run.").arg(QString::fromStdString(robot)));
    if (!pose.position.allFinite() || !pose.rotation.coeffs().allFinite()) return false;
    m_run->command(PlaceCommand{robot, pose});
    if (m_state != RunState::Paused || !m_snapshot) return true;
    std::erase_if(m_placed, [&](const PlaceCommand& place) { return place.robot == robot; });
    m_placed.push_back({robot, pose});
    m_placedTick = m_snapshot->tick;
    showSnapshot(std::make_shared<LiveSnapshot>(*m_snapshot)); // the same tick with the new pose
    return true;
}

QString RunSession::driveRefusal(const std::string& name) const {
    if (m_state != RunState::Running && m_state != RunState::Paused)
        return tr("A robot can be driven while the experiment runs.");
    const RobotSpec* robot = robotNamed(name);
    if (!robot) return tr("Select a robot to drive.");
    if (!driveOf(*robot)) return tr("%1 has no DifferentialDrive to steer it by.").arg(QString::fromStdString(name));
    return {};
}

bool RunSession::drive(const std::string& name, double linear, double angular) {
    if (const QString why = driveRefusal(name); !why.isEmpty()) return reject(why);
    if (!std::isfinite(linear) || !std::isfinite(angular)) return false;
    if (m_driven != name) {
        stopDriving();
        m_run->command(HoldCommand{name, true});
        m_driven = name;
    }
    const std::string base = name + "/" + driveOf(*robotNamed(name))->name + "/";
    m_run->command(SignalCommand{base + "linearAmount", 0});
    m_run->command(SignalCommand{base + "angularAmount", 0});
    m_run->command(SignalCommand{base + "linearVelocity", linear});
    m_run->command(SignalCommand{base + "angularVelocity", angular});
    return true;
}

void RunSession::stopDriving() {
    const RobotSpec* robot = m_driven.empty() ? nullptr : robotNamed(m_driven);
    const ComponentSpec* drive = robot ? driveOf(*robot) : nullptr;
    if (m_run && drive) {
        for (const char* signal : {"/linearVelocity", "/angularVelocity"})
            m_run->command(SignalCommand{m_driven + "/" + drive->name + signal, 0});
        m_run->command(HoldCommand{m_driven, false});
    }
    m_driven.clear();
}

QString RunSession::keepRefusal() const {
    if (!m_snapshot || !m_document.loaded()) return tr("Nothing has moved yet: run the experiment first.");
    if (!configsWithoutInstances(*m_document.loaded()).empty())
        return tr("This file places no robot: the one shown is a preview and has no pose in the text.");
    if (m_state == RunState::Running) return tr("Pause the run first.");
    return posesNow().refusal;
}

StartPoses RunSession::posesNow() const {
    return startPoses(*m_document.loaded(),
                      [this](const std::string& robot) { return isOfRun(robot) ? robotPose(robot) : std::nullopt; });
}

void RunSession::keepPoses() {
    if (const QString why = keepRefusal(); !why.isEmpty()) {
        reject(why);
        return;
    }
    const StartPoses kept = posesNow();
    if (const Status done = m_document.setValues(tr("Keep Poses as Start"), kept.values); !done)
        reject(QString::fromStdString(done.error().message));
    else if (!kept.leftOut.isEmpty())
        Q_EMIT m_document.notice(tr("Poses saved, except of %1: new or renamed since the run started.").arg(kept.leftOut));
}

} // namespace trundle
