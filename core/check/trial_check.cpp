// Tries robots on a plain floor. Method: each config with motors stands for a second, then its drives are commanded. What is found in the
// text is the better message: a config that has a warning already is not tried.
#include <algorithm>
#include <cmath>
#include <set>

#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/model_check.h"
#include "check/trial_drive.h"
#include "project/edits/plan_targets.h"
#include "world/validate.h"

namespace trundle {

namespace {

constexpr double kStand = 1; // s
constexpr std::size_t kMostTrials = 30;
constexpr std::chrono::seconds kMostSeconds(2); // of all; what is large is not tried to the end
constexpr double kFallen = 30 * kDegree, kLeans = 3 * kDegree, kLeansLater = 6 * kDegree;
constexpr double kGivesWay = 5 * kDegree, kSinks = 0.01; // of a servo, of a linear motor in m
constexpr double kBalances = 0.2;                        // of its height: a centre of mass beside the axle
constexpr double kStop = 0.97, kLeastTravel = 1e-3;      // of the way to a stop; m

class Trial {
public:
    Trial(const ExperimentSpec& experiment, const RobotSpec& robot, Diagnostics& diagnostics, const std::stop_token& stop)
        : m_experiment(experiment), m_robot(robot), m_config(*robot.config), m_diagnostics(diagnostics), m_stop(stop) {}

    void run(TrialTime end) {
        m_world = TrialWorld::build(m_experiment, m_robot, end);
        if (!m_world) return;
        for (const BodySpec& body : m_config.bodies) m_start.push_back(m_world->bodyPose(body));
        m_wasUp = m_world->pose().rotation.conjugate() * Vec3::UnitZ();
        if (!m_world->run(kStand, m_stop)) return reportFault();
        if (!stands()) return;
        if (std::ranges::count_if(m_config.devices, isDrive) > 1) return; // while one drives, the others would brake
        if (isGuided() || isOffFloor()) return;
        for (const ComponentSpec& device : m_config.devices)
            if (isDrive(device)) tryOut(device);
    }

private:
    [[nodiscard]] const BodySpec& base() const { return m_world->base(); }

    /// By a rail of the world.
    [[nodiscard]] bool isGuided() const {
        const auto isRail = [](const JointSpec& joint) { return joint.parent == kWorldBody && joint.type == JointType::Slider; };
        return std::ranges::any_of(m_config.joints, isRail);
    }
    /// Its wheels are for another floor, as rails that it hangs from.
    [[nodiscard]] bool isOffFloor() const {
        const auto wheels = drivenWheelsOf(m_config);
        const auto isLoaded = [&](const DriveWheel& wheel) { return m_world->loadOf(m_config.bodies[wheel.body]) > 0; };
        const auto isHeld = [](const JointSpec& joint) { return joint.parent == kWorldBody; };
        return !wheels.empty() && std::ranges::none_of(wheels, isLoaded) && std::ranges::none_of(m_config.joints, isHeld);
    }

    void tryOut(const ComponentSpec& drive) {
        Diagnostics found;
        const bool isWhole = tryDrive(*m_world, m_config, drive, found, m_stop);
        const bool mayTip = mayBalance() && tilt() > kLeans; // without its controller
        if (!isWhole) reportFault();
        else if (tilt() > kFallen && !mayTip) reportFallen(", when " + drive.name + " moves it");
        else if (!mayTip) {
            if (found.all().empty() && tilt() > kLeansLater && !m_leans) reportLeaning(", after " + drive.name + " has moved it");
            m_diagnostics.append(found.all());
        }
    }

    /// rad, from the start.
    [[nodiscard]] double tilt() const { return std::acos(std::clamp((m_world->pose().rotation * m_wasUp).z(), -1.0, 1.0)); }

    void reportFault() {
        if (const Fault* fault = m_world->fault())
            m_diagnostics.warning(Code::FailsToStand, base().nameRange,
                                  "tried on a plain floor, " + m_config.name + " does not hold together: " + fault->reason);
    }

    /// Whether a drive can be tried.
    bool stands() {
        if (tilt() > kFallen) {
            if (!mayBalance()) reportFallen(" at rest");
            return false;
        }
        if (reportedSpring() || reportedServo()) return false;
        if (tilt() > kLeans && !mayBalance()) reportLeaning(" at rest");
        return true;
    }

    void reportLeaning(const std::string& when) {
        m_leans = true;
        m_diagnostics.hint(Code::FailsToStand, base().nameRange,
                           "tried on a plain floor, " + m_config.name + " leans by " + figureText(tilt() / kDegree) + " degrees" +
                               when + ": not all that is to support it reaches as low; check the heights of wheels and casters");
    }

    /// One that measures its tilt may keep upright by its controller, if its centre of mass is above its two wheels.
    [[nodiscard]] bool mayBalance() const {
        const auto isImu = [](const ComponentSpec& device) { return device.kind == "Imu"; };
        if (std::ranges::none_of(m_config.devices, isImu)) return false;
        const auto drive = std::ranges::find_if(m_config.devices, isDrive);
        if (drive == m_config.devices.end()) return true; // on legs
        const auto wheels = drivenWheelsOf(m_config);
        if (motorsOf(*drive).size() != 2 || drive->kind == "AckermannDrive" || wheels.size() != 2) return false;
        Vec3 centre = Vec3::Zero();
        double mass = 0;
        for (const BodySpec& body : m_config.bodies)
            centre += body.mass.mass * (body.pose * body.mass.centre), mass += body.mass.mass;
        const Vec3 up = m_wasUp, ahead = wheels[0].axis.cross(up).normalized(),
                   above = centre / mass - (wheels[0].centre + wheels[1].centre) / 2;
        return above.dot(up) > 0 && std::abs(above.dot(ahead)) < kBalances * above.dot(up);
    }

    void reportFallen(const std::string& when) {
        const bool isHeld =
            std::ranges::any_of(m_config.joints, [](const JointSpec& joint) { return joint.parent == kWorldBody; });
        m_diagnostics.warning(
            Code::FailsToStand, base().nameRange,
            "tried on a plain floor, " + m_config.name + (isHeld ? " gives way" : " falls over") + when + ": it is tilted by " +
                figureText(tilt() / kDegree) + " degrees; check " +
                (isHeld
                     ? "the servos and joints between it and the world, and the masses that they carry"
                     : "what supports it, as a caster, its centre of mass and the masses of its bodies, and the joints that let "
                       "it tip"));
    }

    /// Of a Suspension, or of a Slider with a spring, that was not at its stop at the start.
    bool reportedSpring() {
        for (const JointSpec& joint : m_config.joints) {
            double stop = joint.travel;
            if (joint.type == JointType::Slider && joint.stiffness > 0) {
                const double at = m_world->value(joint.name + "/position");
                if ((joint.rest - at) * at > 0) continue; // its spring holds it there
                stop = std::abs((at < 0 ? joint.lowStop : joint.highStop).value_or(0));
            } else if (joint.type != JointType::Suspension) continue;
            if (stop < kLeastTravel || movedAlong(joint) < kStop * stop) continue;
            m_diagnostics.warning(Code::FailsToStand, joint.nameRange,
                                  "tried on a plain floor, " + joint.name + " of " + m_config.name + " rests at its stop, " +
                                      lengthText(stop) + " from where it starts: its Stiffness, " + figureText(joint.stiffness) +
                                      " N/m, is too low for what it carries");
            return true;
        }
        return false;
    }

    /// m, by which child and parent of a joint have moved along its axis.
    [[nodiscard]] double movedAlong(const JointSpec& joint) const {
        if (joint.parent == kWorldBody) return 0;
        const auto inParent = [](const Pose& parent, const Pose& child) -> Vec3 {
            return parent.rotation.conjugate() * (child.position - parent.position);
        };
        const auto parent = static_cast<std::size_t>(joint.parent), child = static_cast<std::size_t>(joint.child);
        const Vec3 moved = inParent(m_world->bodyPose(m_config.bodies[parent]), m_world->bodyPose(m_config.bodies[child])) -
                           inParent(m_start[parent], m_start[child]);
        return std::abs((m_config.bodies[parent].pose.rotation * moved).dot(joint.axis));
    }

    /// Of a joint whose servo is to hold it where it is.
    bool reportedServo() {
        for (const ComponentSpec& servo : m_config.devices) {
            const bool isLinear = servo.kind == "LinearMotor";
            if ((servo.kind != "Servo" && !isLinear) || servo.text("Mode") == "speed") continue;
            const double moved = std::abs(m_world->value(servo.name + "/position"));
            if (moved < (isLinear ? kSinks : kGivesWay) || m_world->value(servo.name + "/saturated") == 0) continue;
            m_diagnostics.warning(Code::WeakMotor, servo.nameRange,
                                  "tried on a plain floor, " + servo.name + " of " + m_config.name + " cannot hold " +
                                      servo.text("Joint") + " where it starts: it gives way by " +
                                      (isLinear ? lengthText(moved) : figureText(moved / kDegree) + " degrees") +
                                      " in a second; its " +
                                      (isLinear ? "MaxForce is " + figureText(servo.number("MaxForce")) + " N"
                                                : "MaxTorque is " + figureText(servo.number("MaxTorque")) + " N m"));
            return true;
        }
        return false;
    }

    const ExperimentSpec& m_experiment;
    const RobotSpec& m_robot;
    const RobotConfigSpec& m_config;
    Diagnostics& m_diagnostics;
    const std::stop_token& m_stop;
    std::unique_ptr<TrialWorld> m_world;
    std::vector<Pose> m_start; ///< of the bodies
    Vec3 m_wasUp = Vec3::UnitZ();
    bool m_leans = false; ///< and this is reported
};

/// Whether a warning has its place in the config's text or in that of its parts.
bool hasWarning(const RobotConfigSpec& config, const Diagnostics& found) {
    return std::ranges::any_of(found.all(), [&](const Diagnostic& d) {
        const auto isAt = [&](const auto& part) { return part.nameRange == d.range; };
        return d.severity <= Severity::Warning && d.code != Code::UnusedDefinition &&
               (isWithin(d.range, config.range) || std::ranges::any_of(config.bodies, isAt) ||
                std::ranges::any_of(config.joints, isAt) || std::ranges::any_of(config.devices, isAt));
    });
}

} // namespace

void tryRobots(const LoadedProject& loaded, Diagnostics& diagnostics, const std::stop_token& stop) {
    if (loaded.diagnostics.hasErrors() || loaded.pending) return;
    const ExperimentSpec& experiment = *loaded.experiment;
    const TrialTime end = std::chrono::steady_clock::now() + kMostSeconds;
    Diagnostics found;
    if (!isBuildable(experiment, found) || experiment.settings.gravity.norm() < 1e-6) return;

    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    std::set<SourceRange> reported;        // configs of one name differ in values alone
    for (std::size_t i = 0; i < experiment.robots.size() && !stop.stop_requested(); ++i) {
        const RobotSpec& robot = experiment.robots[i];
        const auto isHeld = [&](const Link<JointSpec>& link) {
            return link.childRobot == static_cast<int>(i) || link.parentRobot == static_cast<int>(i);
        };
        const auto moves = [](const ComponentSpec& d) {
            return isDrive(d) || d.kind == "Servo" || d.kind == "LinearMotor" || d.kind == "RotaryMotor";
        };
        if (robot.scenery || std::ranges::any_of(experiment.joints, isHeld)) continue;
        if (std::ranges::none_of(robot.config->devices, moves) || !seen.insert(robot.config.get()).second) continue;
        if (hasWarning(*robot.config, diagnostics)) continue;
        Diagnostics ofRobot;
        Trial(experiment, robot, ofRobot, stop).run(end);
        for (const Diagnostic& d : ofRobot.all())
            if (reported.insert(d.range).second) found.append({d});
        if (seen.size() >= kMostTrials) break;
    }
    diagnostics.append(found.all());
}

} // namespace trundle
