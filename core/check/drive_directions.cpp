// Which way a drive's wheels turn. Method: a positive rate about an axle moves the base along axle x up, so with all axles to its left it
// drives ahead; those of an OmniDrive point to the middle, so that it turns left.
#include "check/drive_directions.h"

#include <algorithm>
#include <cmath>

#include "check/checks.h"
#include "check/drive_report.h"

namespace trundle {

namespace {

constexpr double kBeside = 1e-3, kBesideShare = 0.02; // m, and of the radius: of an axle from the middle of its wheel
constexpr double kTogether = 0.2;                     // of the radius
constexpr double kApart = 1e-6;                       // m, from the middle between the sides
constexpr double kInLine = 2e-3, kInLineShare = 0.1;  // m, and of the radius: between the axles of both sides

/// Of a drive whose wheels are on two sides.
class SideDirections {
public:
    SideDirections(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels)
        : m_report(report), m_motors(motors), m_wheels(wheels), m_left(wheels.front().axis),
          m_ahead(m_left.cross(Vec3::UnitZ())) {}

    void check() {
        if (std::abs(m_left.z()) > 0.5) return;
        if (reportedAgainst() || reportedNoSides() || reportedSides()) return;
        if (m_report.drive.kind == "MecanumDrive") return checkMecanum(m_report, m_motors, m_wheels, m_ahead);
        if (m_report.drive.kind == "AckermannDrive" && reportedSteering()) return;
        if (m_wheels.size() == 2) checkInLine();
    }

private:
    /// Some axles point the other way: those that point right are meant, or the fewer ones.
    bool reportedAgainst() {
        std::vector<DriveWheel> against, others;
        for (const DriveWheel& wheel : m_wheels) (wheel.axis.dot(m_left) < 0 ? against : others).push_back(wheel);
        if (against.empty()) return false;
        if (std::abs(m_left.y()) > 0.5 ? m_left.y() < 0 : others.size() < against.size()) std::swap(against, others);
        const JointSpec* joint = m_report.jointOf(against.front());
        if (!joint) return true;
        Diagnostic& d =
            m_report.warn(joint->nameRange, joint->name + ", the axle of " + m_report.bodyOf(against.front()) +
                                                ", points the other way than that of " + m_report.bodyOf(others.front()) +
                                                ": at one speed of both, " + m_report.drive.name +
                                                " turns the robot instead of driving it; reverse the axis of " + joint->name);
        m_report.addReversal(d, against);
        return true;
    }

    bool reportedNoSides() {
        const auto right = static_cast<std::size_t>(std::ranges::find(m_motors, true, &DriveMotor::isRight) - m_motors.begin());
        const auto isBeside = [&](const DriveWheel& w) {
            return std::abs((w.centre - m_wheels.front().centre).dot(m_left)) > kApart;
        };
        if (right == m_motors.size() || std::ranges::any_of(m_wheels, isBeside)) return false;
        m_report.warn(m_report.config.bodies[m_wheels[right].body].nameRange,
                      m_report.bodyOf(m_wheels[right]) + " is as far to the side as " + m_report.bodyOf(m_wheels.front()) + ": " +
                          m_report.drive.name + " cannot turn the robot; check the sign of its Pos");
        return true;
    }

    bool reportedSides() {
        double middle = 0; // m, towards the left
        for (const DriveWheel& wheel : m_wheels) middle += wheel.centre.dot(m_left) / static_cast<double>(m_wheels.size());
        std::vector<std::size_t> wrong; // on the other side
        for (std::size_t i = 0; i < m_wheels.size(); ++i)
            if ((m_wheels[i].centre.dot(m_left) - middle) * (m_motors[i].isRight ? -1 : 1) < -kApart) wrong.push_back(i);
        if (wrong.empty()) return false;
        const auto sideOf = [&](std::size_t i) { return m_motors[i].isRight ? "on the left" : "on the right"; };
        const std::size_t first = wrong.front(), last = wrong.back();
        if (wrong.size() == m_wheels.size()) {
            if (m_left.y() < -0.5) reportBackwards();
            else {
                const auto right = std::ranges::find(m_motors, true, &DriveMotor::isRight);
                m_report.reportSwapped({m_motors.front().key, right->key}, m_report.bodyOf(m_wheels.front()) + ", which " +
                                                                               m_motors.front().name + " turns, is on the right");
            }
        } else if (wrong.size() == 2 && m_motors[first].isRight != m_motors[last].isRight)
            m_report.reportExchanged(m_motors[first], m_wheels[first], m_motors[last], sideOf(first));
        else m_report.reportPlace(m_motors[first], m_wheels[first], sideOf(first));
        return true;
    }

    void reportBackwards() {
        const JointSpec* joint = m_report.jointOf(m_wheels.front());
        if (!joint) return;
        Diagnostic& d = m_report.warn(joint->nameRange,
                                      "the axles of " + m_report.bodyOf(m_wheels.front()) + " and " +
                                          m_report.bodyOf(m_wheels.back()) + " point to the right: " + m_report.drive.name +
                                          " drives backwards at a positive speed, and turns the other way; reverse their axes");
        m_report.addReversal(d, m_wheels);
    }

    void checkInLine() {
        const double apart = (m_wheels[0].centre - m_wheels[1].centre).dot(m_ahead.normalized());
        if (std::abs(apart) <= std::max(kInLine, kInLineShare * m_wheels[0].geom->radius)) return;
        m_report.warn(m_report.config.bodies[m_wheels[1].body].nameRange,
                      m_report.bodyOf(m_wheels[1]) + " is " + lengthText(std::abs(apart)) +
                          (apart > 0 ? " behind " : " ahead of ") + m_report.bodyOf(m_wheels[0]) +
                          ": their axles are not in line, and " + m_report.drive.name +
                          " drags them through its turns; check their Pos");
    }

    [[nodiscard]] const JointSpec* pivotOf(const char* key) const {
        const auto& devices = m_report.config.devices;
        const auto servo = std::ranges::find(devices, m_report.drive.text(key), &ComponentSpec::name);
        if (servo == devices.end()) return nullptr;
        const auto joint = std::ranges::find(m_report.config.joints, servo->text("Joint"), &JointSpec::name);
        return joint == m_report.config.joints.end() ? nullptr : &*joint;
    }

    bool reportedSteering() {
        const JointSpec *onLeft = pivotOf("LeftSteering"), *onRight = pivotOf("RightSteering");
        if (!onLeft || !onRight) return false;
        const std::string& drive = m_report.drive.name;
        if ((onLeft->anchor - onRight->anchor).dot(m_left) < 0) {
            m_report.reportSwapped({"LeftSteering", "RightSteering"},
                                   "the wheel that " + m_report.drive.text("LeftSteering") + " steers is on the right");
            return true;
        }
        for (const JointSpec* pivot : {onLeft, onRight})
            if (pivot->axis.z() < -0.5) {
                Diagnostic& d = m_report.warn(pivot->nameRange, pivot->name + " points down: " + drive +
                                                                    " steers its wheel to the other side; reverse its axis");
                std::vector<const JointSpec*> reversed;
                std::vector<Vec3> axes;
                for (const JointSpec* joint : {onLeft, onRight})
                    if (joint->axis.z() < -0.5) reversed.push_back(joint), axes.push_back(-joint->axis);
                m_report.addAxisFix(d, reversed.size() == 1 ? "reverse the axis" : "reverse their axes", reversed, axes);
                return true;
            }
        if ((onLeft->anchor - m_wheels.front().centre).dot(m_ahead) >= 0) return false;
        m_report.warn(onLeft->nameRange, onLeft->name + ", which steers, is behind the wheels that " + drive +
                                             " drives: it steers to the other side; the driven wheels belong at the back");
        return true;
    }

    DriveReport& m_report;
    const std::vector<DriveMotor>& m_motors;
    const std::vector<DriveWheel>& m_wheels;
    Vec3 m_left, m_ahead; ///< the drive ahead is along left x up
};

/// A wheel whose axle does not go through its middle.
bool reportedBeside(DriveReport& report, const DriveWheel& wheel) {
    const JointSpec* joint = report.jointOf(wheel);
    if (!joint) return false;
    const double beside = (wheel.centre - joint->anchor).cross(wheel.axis).norm();
    if (beside <= std::max(kBeside, kBesideShare * wheel.geom->radius)) return false;
    const bool isTurnedAround = static_cast<std::size_t>(joint->child) != wheel.body;
    const std::string& child = report.config.bodies[static_cast<std::size_t>(joint->child)].name;
    report.warn(joint->nameRange, joint->name + ", the axle of " + report.bodyOf(wheel) + ", is " + lengthText(beside) +
                                      " beside the middle of its " + wheel.geom->name +
                                      ": it turns out of round; without an Anchor it is at the origin of its Child, " + child +
                                      (isTurnedAround ? ": swap its Parent and Child" : ""));
    return true;
}

/// Two wheels in one place; a body that two motors turn has a warning of its own.
bool reportedTogether(DriveReport& report, const DriveWheel& one, const DriveWheel& two) {
    if (one.body == two.body) return true;
    if ((one.centre - two.centre).norm() > kTogether * one.geom->radius) return false;
    report.warn(report.config.bodies[two.body].nameRange, report.bodyOf(two) + " is in the place of " + report.bodyOf(one) +
                                                              "; check its Pos and HPR, or those of its Part");
    return true;
}

} // namespace

void checkDirections(DriveReport& report, const std::vector<DriveMotor>& motors, const std::vector<DriveWheel>& wheels) {
    for (const DriveWheel& wheel : wheels)
        if (reportedBeside(report, wheel)) return;
    for (auto second = wheels.begin(); second != wheels.end(); ++second)
        for (auto first = wheels.begin(); first != second; ++first)
            if (reportedTogether(report, *first, *second)) return;
    if (report.drive.kind == "OmniDrive") checkOmni(report, wheels);
    else SideDirections(report, motors, wheels).check();
}

} // namespace trundle
