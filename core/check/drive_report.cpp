#include "check/drive_report.h"

#include <algorithm>
#include <cmath>

#include "project/edits/value_edits.h"
#include "project/objects/part_values.h"

namespace trundle {

const JointSpec* DriveReport::jointOf(const DriveWheel& wheel) const {
    const auto joint = std::ranges::find(config.joints, wheel.motor->text("Joint"), &JointSpec::name);
    return joint == config.joints.end() ? nullptr : &*joint;
}

void DriveReport::addAxisFix(Diagnostic& d, const std::string& title, const std::vector<const JointSpec*>& joints,
                             const std::vector<Vec3>& axes) const {
    std::vector<ValueEdit> values;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i] || joints[i]->name.find('.') != std::string::npos) return;
        const char* key = joints[i]->type == JointType::Suspension ? ".Axis2" : ".Axis";
        values.push_back(
            {DottedPath("RobotConfig." + config.name + "." + joints[i]->name + key), ParsedValue(axisText(axes[i]))});
    }
    const auto edits = editsForValues(loaded, values);
    if (edits.ok() && edits.value().size() == 1) d.fixes.push_back({title, edits.value().begin()->second});
}

void DriveReport::addReversal(Diagnostic& d, const std::vector<DriveWheel>& wheels) const {
    std::vector<const JointSpec*> joints;
    std::vector<Vec3> axes;
    for (const DriveWheel& wheel : wheels) {
        const JointSpec* joint = jointOf(wheel);
        if (!joint) return;
        joints.push_back(joint), axes.push_back(joint->type == JointType::Suspension ? -joint->axis2 : -joint->axis);
    }
    addAxisFix(d, wheels.size() == 1 ? "reverse the axis" : "reverse their axes", joints, axes);
}

void DriveReport::reportSwapped(const SwappedKeys& keys, const std::string& what) {
    const ResolvedValue *left = drive.find(keys.left), *right = drive.find(keys.right);
    if (!left || !right) return;
    const std::string both = std::string(keys.left) + " and " + keys.right;
    Diagnostic& d = warn(left->range,
                         what + ", but " + keys.left + " of " + drive.name + " names it: its motion will be wrong; swap " + both);
    if (!isWritten(loaded, *left) || !isWritten(loaded, *right) || left->range.file != right->range.file) return;
    d.fixes.push_back({"swap " + both,
                       {{left->range, std::string(loaded.sources.slice(right->range))},
                        {right->range, std::string(loaded.sources.slice(left->range))}}});
}

void DriveReport::reportExchanged(const DriveMotor& motor, const DriveWheel& wheel, const DriveMotor& other,
                                  const std::string& where) {
    const SourceRange &one = motor.place(), &two = other.place();
    Diagnostic& d = warn(one, bodyOf(wheel) + ", which " + motor.name + " turns, is " + where + ", but " + motor.key + " of " +
                                  drive.name + " names it: its motion will be wrong; swap " + motor.name + " and " + other.name);
    if (one.known() && one.file == two.file && loaded.sources.slice(one) == motor.name && loaded.sources.slice(two) == other.name)
        d.fixes.push_back({"swap " + motor.name + " and " + other.name, {{one, other.name}, {two, motor.name}}});
}

void DriveReport::reportPlace(const DriveMotor& motor, const DriveWheel& wheel, const std::string& where) {
    warn(motor.place(), bodyOf(wheel) + ", which " + motor.name + " turns, is " + where + ", but " + motor.key + " of " +
                            drive.name + " names it: its motion will be wrong");
}

bool isWritten(const LoadedProject& loaded, const ResolvedValue& value) {
    const FileId file = value.range.file;
    if (!value.range.known() || file >= loaded.paths.size() || loaded.paths[file].empty()) return false;
    return loaded.sources.slice(value.range).find('$') == std::string_view::npos;
}

std::string axisText(const Vec3& axis) {
    return positionText(axis.unaryExpr([](double v) { return std::round(v * 1e6) / 1e6 + 0.; }));
}

} // namespace trundle
