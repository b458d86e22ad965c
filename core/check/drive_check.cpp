#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "check/checks.h"
#include "check/drive_directions.h"
#include "check/drive_wheels.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kTolerance = 0.02; // relative, for radius and distances
constexpr double kOdd = 0.05;       // of WheelSeparation
constexpr std::string_view kMotor = "RotaryMotor";

/// Checks all drives of one config.
class DriveCheck {
public:
    DriveCheck(const LoadedProject& loaded, const RobotConfigSpec& config, Diagnostics& diagnostics)
        : m_loaded(loaded), m_config(config), m_diagnostics(diagnostics) {}

    void check(const ComponentSpec& drive) {
        if (drive.kind == "TrackDrive") return checkTracks(drive);
        const std::vector<DriveMotor> motors = motorsOf(drive);
        for (auto motor = motors.begin(); motor != motors.end(); ++motor)
            if (const auto earlier =
                    std::find_if(motors.begin(), motor, [&](const DriveMotor& m) { return m.name == motor->name; });
                earlier != motor)
                return sameMotor(drive, *earlier, *motor);
        DriveReport report(m_loaded, m_config, drive, m_diagnostics);
        std::vector<DriveWheel> wheels;
        for (const DriveMotor& motor : motors) {
            const auto wheel = wheelOf(m_config, motor.name);
            if (!wheel) return checkAxle(report, motor);
            wheels.push_back(*wheel);
        }
        if (wheels.empty() || hasTwins(wheels)) return;
        const auto radius = [](const DriveWheel& w) { return w.geom->radius; };
        if (const auto all = sameOf(wheels, radius))
            compare(drive, "WheelRadius", *all, namesOf(wheels) + " have a radius of ", "distances");
        else reportRadius(report, wheels);
        const std::size_t before = m_diagnostics.all().size();
        checkDirections(report, motors, wheels);
        if (m_diagnostics.all().size() == before) checkDistances(drive, motors, wheels); // which follow from the sides
    }

private:
    /// Of which one has a warning of its own.
    [[nodiscard]] bool hasTwins(const std::vector<DriveWheel>& wheels) const {
        for (auto second = wheels.begin(); second != wheels.end(); ++second)
            for (auto first = wheels.begin(); first != second; ++first)
                if (first->body != second->body && isTwin(m_config.bodies[first->body], m_config.bodies[second->body]))
                    return true;
        return false;
    }

    /// Wheels of a drive that have several radii: the first that has not that of WheelRadius.
    void reportRadius(DriveReport& report, const std::vector<DriveWheel>& wheels) const {
        const double given = report.drive.number("WheelRadius");
        const auto odd = std::ranges::find_if(
            wheels, [&](const DriveWheel& wheel) { return !(std::abs(wheel.geom->radius - given) <= kTolerance * given); });
        if (odd == wheels.end()) return;
        report.warn(m_config.bodies[odd->body].nameRange,
                    report.bodyOf(*odd) + " has a radius of " + lengthText(odd->geom->radius) + ", and the WheelRadius of " +
                        report.drive.name + " is " + lengthText(given) +
                        " for all its wheels: at the same rate they roll at different speeds, so that the robot curves when it "
                        "drives straight ahead");
    }

    /// The middle of a track's geom, in the config's frame; nothing if it has several, as flippers farther out.
    [[nodiscard]] std::optional<Vec3> middleOfTrack(const std::string& name) const {
        const auto track = std::ranges::find(m_config.devices, name, &ComponentSpec::name);
        if (track == m_config.devices.end()) return std::nullopt;
        const std::vector<std::string> geoms = track->texts("Geom");
        if (geoms.size() != 1) return std::nullopt;
        for (const BodySpec& body : m_config.bodies)
            for (const GeomSpec& geom : body.geoms)
                if (body.name + "." + geom.name == geoms[0]) return (body.pose * geom.pose).position;
        return std::nullopt;
    }

    void checkTracks(const ComponentSpec& drive) {
        const auto left = middleOfTrack(drive.text("LeftTrack")), right = middleOfTrack(drive.text("RightTrack"));
        if (!left || !right) return;
        const Vec3 apart = (*left - *right).cwiseAbs();
        compare(drive, "TrackSeparation", std::max(apart.x(), apart.y()), "the middles of its tracks are apart by ", "turns");
    }

    void checkDistances(const ComponentSpec& drive, const std::vector<DriveMotor>& motors,
                        const std::vector<DriveWheel>& wheels) {
        const std::string names = namesOf(wheels);
        const Vec3 across = wheels.front().axis, ahead = across.cross(Vec3::UnitZ());
        const auto apart = [&](const Vec3& direction, bool DriveMotor::*side) {
            std::array<double, 2> sums{}, counts{};
            for (std::size_t i = 0; i < wheels.size(); ++i) {
                sums[motors[i].*side] += wheels[i].centre.dot(direction);
                ++counts[motors[i].*side];
            }
            return std::abs(sums[0] / counts[0] - sums[1] / counts[1]); // not a number if all are on one side
        };
        if (drive.kind == "OmniDrive") {
            if (ballUnder(m_config, wheels.front())) return; // its turns depend on the ball
            const auto distance = [](const DriveWheel& w) { return std::abs(w.centre.dot(w.axis)); };
            if (const auto all = sameOf(wheels, distance))
                compare(drive, "WheelDistance", *all, names + " are away from the middle by ", "turns");
            return;
        }
        if (!reportedOdd(drive, motors, wheels) && !reportedLopsided(drive, motors, wheels))
            compare(drive, "WheelSeparation", apart(across, &DriveMotor::isRight), "the middles of " + names + " are apart by ",
                    "turns");
        if (drive.kind == "MecanumDrive")
            compare(drive, "WheelBase", apart(ahead, &DriveMotor::isBack), "the axles of " + names + " are apart by ", "turns");
        if (drive.kind == "AckermannDrive")
            if (const auto steered = steeredAnchor(drive))
                compare(drive, "WheelBase", std::abs((*steered - wheels.front().centre).dot(ahead.normalized())),
                        "the steered wheels are ahead of the driven ones by ", "curves");
    }

    /// Of several wheels on a side, one that is farther out than the others, from which WheelSeparation is.
    bool reportedOdd(const ComponentSpec& drive, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
        const Vec3 left = wheels.front().axis;
        const auto usual = [&](bool isRight) { // m, the median of a side, towards the left
            std::vector<double> places;
            for (std::size_t i = 0; i < wheels.size(); ++i)
                if (motors[i].isRight == isRight) places.push_back(wheels[i].centre.dot(left));
            std::ranges::sort(places);
            return places.empty() ? 0 : places[places.size() / 2];
        };
        const double onLeft = usual(false), onRight = usual(true), given = drive.number("WheelSeparation");
        if (std::abs(given - (onLeft - onRight)) > kTolerance * given) return false;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            const double out =
                (wheels[i].centre.dot(left) - (motors[i].isRight ? onRight : onLeft)) * (motors[i].isRight ? -1 : 1);
            if (std::abs(out) <= kOdd * given) continue;
            const BodySpec& body = m_config.bodies[wheels[i].body];
            m_diagnostics.hint(Code::WheelGeometry, body.nameRange,
                               body.name + " is " + lengthText(std::abs(out)) + (out > 0 ? " farther out" : " farther in") +
                                   " than the other wheels of its side, from which the WheelSeparation of " + drive.name + " is");
            break;
        }
        return true;
    }

    /// WheelSeparation is right for one side and its mirror image, but the other side is elsewhere.
    bool reportedLopsided(const ComponentSpec& drive, const std::vector<DriveMotor>& motors,
                          const std::vector<DriveWheel>& wheels) {
        const Vec3 left = wheels.front().axis;
        const double given = drive.number("WheelSeparation");
        const auto outOf = [&](std::size_t i) { return wheels[i].centre.dot(left) * (motors[i].isRight ? -1 : 1); };
        const auto isMeant = [&](std::size_t i) { return std::abs(outOf(i) - given / 2) <= kTolerance * given; };
        std::optional<std::size_t> meant, other;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            std::optional<std::size_t>& side = isMeant(i) ? meant : other;
            if (side && motors[*side].isRight != motors[i].isRight) return false;
            if (!side) side = i;
        }
        if (!meant || !other || outOf(*other) <= 0) return false;
        const BodySpec &body = m_config.bodies[wheels[*other].body], &image = m_config.bodies[wheels[*meant].body];
        m_diagnostics.warning(Code::WheelGeometry, body.nameRange,
                              body.name + " is " + lengthText(std::abs(outOf(*other))) + " from the middle of " + m_config.name +
                                  ", " + image.name + " " + lengthText(outOf(*meant)) + ", as the WheelSeparation of " +
                                  drive.name + " has both: check the Pos of " + body.name + ", or the Mirror of its Part");
        return true;
    }

    [[nodiscard]] std::string namesOf(const std::vector<DriveWheel>& wheels) const {
        return "the wheels " + nameOf(wheels.front()) + " and " + nameOf(wheels.back());
    }

    /// Names the geom, and its body where another wheel has a geom of that name.
    [[nodiscard]] std::string nameOf(const DriveWheel& wheel) const {
        const std::string& name = wheel.geom->name;
        int same = 0;
        for (const BodySpec& body : m_config.bodies)
            same += static_cast<int>(std::ranges::count(body.geoms, name, &GeomSpec::name));
        return same > 1 ? m_config.bodies[wheel.body].name : name;
    }

    /// The value of all wheels; nothing if they differ.
    template <class Of> [[nodiscard]] static std::optional<double> sameOf(const std::vector<DriveWheel>& wheels, Of of) {
        const double first = of(wheels.front());
        for (const DriveWheel& wheel : wheels)
            if (!(std::abs(of(wheel) - first) <= kTolerance * first)) return std::nullopt;
        return first;
    }

    /// Of the axis about which the left front wheel is steered.
    [[nodiscard]] std::optional<Vec3> steeredAnchor(const ComponentSpec& drive) const {
        const auto servo = std::ranges::find(m_config.devices, drive.text("LeftSteering"), &ComponentSpec::name);
        if (servo == m_config.devices.end()) return std::nullopt;
        const auto joint = std::ranges::find(m_config.joints, servo->text("Joint"), &JointSpec::name);
        return joint == m_config.joints.end() ? std::nullopt : std::optional(joint->anchor);
    }

    /// Reports a drive that uses one motor twice; a run would refuse it.
    void sameMotor(const ComponentSpec& drive, const DriveMotor& first, const DriveMotor& second) {
        const SourceRange& range = second.value->range;
        const bool isOneKey = first.value == second.value;
        Diagnostic& d =
            m_diagnostics.error(Code::DeviceSetup, range.known() ? range : drive.nameRange,
                                isOneKey ? std::string(second.key) + " of " + drive.name + " names the motor " + second.name +
                                               " twice; each wheel needs one of its own"
                                         : std::string(first.key) + " and " + second.key + " of " + drive.name +
                                               " are the same motor, " + second.name + "; each wheel needs one of its own");
        std::vector<std::string> others;
        const std::vector<DriveMotor> used = motorsOf(drive);
        for (const ComponentSpec& device : m_config.devices)
            if (device.kind == kMotor && std::ranges::find(used, device.name, &DriveMotor::name) == used.end())
                others.push_back(device.name);
        if (others.size() == 1 && second.value->value.texts.size() == 1 && isWritten(m_loaded, *second.value))
            d.fixes.push_back({others[0], {{range, others[0]}}});
        d.suggestions = std::move(others);
    }

    void compare(const ComponentSpec& drive, const char* key, double real, const std::string& where, const char* effect) {
        const ResolvedValue* value = drive.find(key);
        const double given = drive.number(key);
        if (!value || !(real > 0) || std::abs(given - real) <= kTolerance * real) return;
        Diagnostic& d = m_diagnostics.warning(Code::WheelGeometry, value->range.known() ? value->range : drive.nameRange,
                                              std::string(key) + " of " + drive.name + " is " + lengthText(given) + ", but " +
                                                  where + lengthText(real) + ": " + effect + " will be " +
                                                  figureText(100 * std::abs(given / real - 1)) + " % off");
        const std::string text = shortNumber(std::round(real * 1e6) / 1e6);
        if (isWritten(m_loaded, *value) && isOneForAll(*value))
            d.fixes.push_back({std::string(key) + "=" + text, {{value->range, text}}});
    }

    /// Whether no other robot has it with other values, to which a change of the config would be wrong.
    [[nodiscard]] bool isOneForAll(const ResolvedValue& value) const {
        const auto isOther = [&](const RobotSpec& robot) {
            return robot.config.get() != &m_config && robot.config->name == m_config.name;
        };
        return value.origin != Origin::Config || std::ranges::none_of(m_loaded.experiment->robots, isOther);
    }

    const LoadedProject& m_loaded;
    const RobotConfigSpec& m_config;
    Diagnostics& m_diagnostics;
};

} // namespace

void checkDrives(const LoadedProject& loaded, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!robot.config || !seen.insert(robot.config.get()).second) continue;
        checkMotors(*robot.config, diagnostics);
        DriveCheck check(loaded, *robot.config, diagnostics);
        for (const ComponentSpec& device : robot.config->devices) check.check(device);
    }
}

} // namespace trundle
