// Which way the wheels of drives turn that move in any direction.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "check/checks.h"
#include "check/drive_directions.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOff = 2 * kDegree; // between WheelAngles and the wheels

/// Of the wheel's place around the middle, rad, from 0 to 2 pi.
double angleOf(const DriveWheel& wheel) {
    const double angle = std::atan2(-wheel.axis.y(), -wheel.axis.x());
    return angle < -1e-9 ? angle + 2 * kPi : angle;
}
std::string degreesText(double radians) { return shortNumber(std::round(radians / kDegree * 100) / 100 + 0.); }

/// Those at the front left and the back right lie one way, the others the other way.
void checkRollers(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const double heading = report.loaded.experiment->surfaces[wheels[i].geom->surface].frictionHeading;
        const double right = motors[i].isRight == motors[i].isBack ? -45 : 45;
        if (std::sin(2 * heading) * right >= 0) continue;
        report.warn(wheels[i].geom->nameRange, "the rollers of " + report.bodyOf(wheels[i]) + " lie across those that " +
                                                   report.drive.name + " needs there: the FrictionHeading of its Surface is " +
                                                   degreesText(heading) + " degrees, not " + shortNumber(right) +
                                                   "; -45 is for front left and back right, 45 for the others");
        return;
    }
}

} // namespace

void checkOmni(DriveReport& report, const std::vector<DriveWheel>& wheels) {
    const ComponentSpec& drive = report.drive;
    Vec3 middle = Vec3::Zero();
    for (const DriveWheel& wheel : wheels) middle += wheel.centre / static_cast<double>(wheels.size());
    std::vector<DriveWheel> outward;
    for (const DriveWheel& wheel : wheels)
        if (wheel.axis.dot(wheel.centre - middle) > 0) outward.push_back(wheel);
    if (!outward.empty()) {
        const JointSpec* joint = report.jointOf(outward.front());
        if (!joint) return;
        Diagnostic& d = report.warn(
            joint->nameRange,
            joint->name + ", the axle of " + report.bodyOf(outward.front()) + ", points away from the middle: " + drive.name +
                " turns its wheel the wrong way" +
                (outward.size() > 1 ? " (and " + std::to_string(outward.size() - 1) + " more like it)" : std::string()) +
                "; reverse its axis");
        return report.addReversal(d, outward);
    }
    const ResolvedValue* given = drive.find("WheelAngles");
    const std::vector<double> angles = given ? given->value.numbers : std::vector<double>();
    if (!angles.empty() && angles.size() != wheels.size()) return; // a run refuses it
    std::string right;
    const DriveWheel* wrong = nullptr;
    double said = 0;
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const double even = kPi * static_cast<double>(2 * i + 1) / static_cast<double>(wheels.size());
        const double is = angleOf(wheels[i]), has = angles.empty() ? even : angles[i];
        if (!wrong && std::abs(std::remainder(is - has, 2 * kPi)) > kOff) wrong = &wheels[i], said = has;
        right += (i ? "," : "") + degreesText(is);
    }
    if (!wrong) return;
    Diagnostic& d = report.warn(
        given ? given->range : drive.nameRange,
        (angles.empty() ? drive.name + ", which has no WheelAngles, takes " : "WheelAngles of " + drive.name + " takes ") +
            report.bodyOf(*wrong) + " for a wheel at " + degreesText(said) + " degrees, but it is at " +
            degreesText(angleOf(*wrong)) + ": " + drive.name + " will move askew; WheelAngles=" + right + " are its angles");
    if (given && isWritten(report.loaded, *given)) d.fixes.push_back({"WheelAngles=" + right, {{given->range, right}}});
}

void checkMecanum(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels,
                  const Vec3& ahead) {
    double middle = 0; // m, along the way ahead
    for (const DriveWheel& wheel : wheels) middle += wheel.centre.dot(ahead) / static_cast<double>(wheels.size());
    std::vector<std::size_t> wrong; // at the other end
    for (std::size_t i = 0; i < wheels.size(); ++i)
        if ((wheels[i].centre.dot(ahead) - middle) * (motors[i].isBack ? -1 : 1) < 0) wrong.push_back(i);
    if (wrong.empty()) return checkRollers(report, motors, wheels);
    const std::size_t first = wrong.front(), last = wrong.back();
    const std::string where = motors[first].isBack ? "at the front" : "at the back";
    if (wrong.size() == wheels.size())
        report.warn(motors[first].value->range,
                    "the wheels that the front motors of " + report.drive.name +
                        " turn are at the back: its motion will be wrong; swap the front and the back motors");
    else if (wrong.size() == 2 && motors[first].isRight == motors[last].isRight)
        report.reportExchanged(motors[first], wheels[first], motors[last], where);
    else report.reportPlace(motors[first], wheels[first], where);
}

} // namespace trundle
