// What a person does to a running world: it all enters as commands that the runner stamps.
#include <cmath>
#include <numbers>

#include "editor/running/kept_poses.h"
#include "editor/running/pose_overlay.h"
#include "editor/running/session.h"
#include "project/described.h"

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
        return refuse(tr("A body can be pushed while the experiment runs."));
    if (!force.allFinite() || !point.allFinite()) return false;
    m_run->keepPushing(PushCommand{body, force, point});
    return true;
}

void RunSession::endPush() {
    if (m_run) m_run->keepPushing(std::nullopt);
}

bool RunSession::place(const std::string& robot, const Pose& pose) {
    if (m_state != RunState::Running && m_state != RunState::Paused)
        return refuse(tr("A robot can be put elsewhere in a run while it is running or paused."));
    if (!robotNamed(robot) || !isOfRun(robot))
        return refuse(tr("%1 is no robot of this run.").arg(QString::fromStdString(robot)));
    if (!pose.position.allFinite() || !pose.rotation.coeffs().allFinite()) return false;
    m_run->command(PlaceCommand{robot, pose});
    if (m_state != RunState::Paused || !m_snapshot) return true;
    std::erase_if(m_placed, [&](const PlaceCommand& place) { return place.robot == robot; });
    m_placed.push_back({robot, pose});
    m_placedTick = m_snapshot->tick;
    showSnapshot(std::make_shared<LiveSnapshot>(*m_snapshot)); // the same tick, seen with it
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
    if (const QString why = driveRefusal(name); !why.isEmpty()) return refuse(why);
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
    if (!describedAlone(*m_document.loaded()).empty())
        return tr("This file places no robot: the one that runs is there to be looked at, and has no pose in the text.");
    if (m_state == RunState::Running) return tr("Pause the run first.");
    return posesNow().refusal;
}

KeptPoses RunSession::posesNow() const {
    return keptPoses(*m_document.loaded(),
                     [this](const std::string& robot) { return isOfRun(robot) ? robotPose(robot) : std::nullopt; });
}

void RunSession::keepPoses() {
    if (const QString why = keepRefusal(); !why.isEmpty()) {
        refuse(why);
        return;
    }
    const KeptPoses kept = posesNow();
    if (const Status done = m_document.setValues(tr("Keep Poses as Start"), kept.values); !done)
        refuse(QString::fromStdString(done.error().message));
    else if (!kept.leftOut.isEmpty())
        Q_EMIT m_document.notice(tr("Poses kept, but not of %1: new or renamed since the run began.").arg(kept.leftOut));
}

} // namespace trundle
