// Checks of what motors can do: climb the ramps of the experiment, and how far a robot gets in one tick and in a second.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/extent.h"
#include "project/edits/value_edits.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kLeastRamp = 2 * kDegree, kSteepestRamp = 40 * kDegree;
constexpr double kUsualSlope = 3 * kDegree;           // without a ramp: a doorstep, a carpet
constexpr double kMostGear = 4;                       // of the factor of a gear ratio that is proposed
constexpr double kReserve = 1.25;                     // of a gear ratio that is proposed
constexpr double kNickel = 1.2, kLithium = 3.7;       // V of a cell
constexpr double kHeldBack = 1.5;                     // of the torque that is left
constexpr double kMostLengths = 80, kMostSpeed = 8;   // of the robot in a second; m/s: faster than a race car of its size

struct Ramp {
    double slope = kUsualSlope;
    std::string name; ///< empty: nothing is that thin
};

/// The steepest plane, or upper face of a box, that a robot could drive on.
Ramp steepestRamp(const ExperimentSpec& experiment, const Vec3& up) {
    Ramp ramp;
    for (const StaticSpec& object : experiment.statics)
        for (const GeomSpec& geom : object.geoms ? *object.geoms : std::vector<GeomSpec>()) {
            const bool isPlane = geom.shape == GeomShape::Plane;
            if (!geom.collide || (geom.shape != GeomShape::Box && !isPlane)) continue;
            const Mat3 axes = (object.pose * geom.pose).rotation.toRotationMatrix();
            for (int k = isPlane ? 2 : 0; k < 3; ++k) {
                const double slope = std::acos(std::min(1.0, std::abs(axes.col(k).dot(up))));
                const bool isBroad = isPlane || geom.size[k] <= 0.5 * std::min(geom.size[(k + 1) % 3], geom.size[(k + 2) % 3]);
                if (isBroad && slope > std::max(kLeastRamp, ramp.slope) && slope < kSteepestRamp)
                    ramp = {slope, object.name + "/" + geom.name};
            }
        }
    return ramp;
}

class SpeedCheck {
public:
    SpeedCheck(const LoadedProject& loaded, const Vec3& up, Diagnostics& diagnostics)
        : m_loaded(loaded), m_experiment(*loaded.experiment), m_diagnostics(diagnostics), m_up(up),
          m_ramp(steepestRamp(m_experiment, m_up)) {}

    void check() {
        std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
        for (const RobotSpec& robot : m_experiment.robots) {
            const RobotConfigSpec& config = *robot.config;
            if (!seen.insert(&config).second) continue;
            const std::vector<DriveWheel> wheels = drivenWheelsOf(config);
            for (const DriveWheel& wheel : wheels) {
                const double speed = speedOf(wheel);
                if (speed > m_fastest) m_fastest = speed, m_fastestName = config.name;
            }
            if (m_up.isZero() || wheels.empty()) continue;
            checkStrength(config, wheels);
            checkFast(config, wheels);
        }
        if (m_fastest > 0) checkThin();
    }

private:
    [[nodiscard]] static double speedOf(const DriveWheel& wheel) { return wheel.topRate() * wheel.geom->radius; } ///< m/s

    /// A missing GearRatio leaves the speed of the motor, and its torque.
    void checkFast(const RobotConfigSpec& config, const std::vector<DriveWheel>& wheels) {
        const Extent x = extentAlong(config, {}, Vec3::UnitX()), y = extentAlong(config, {}, Vec3::UnitY());
        const double length = std::max(x.high - x.low, y.high - y.low);
        const DriveWheel& wheel = *std::ranges::max_element(wheels, {}, speedOf);
        const double speed = speedOf(wheel);
        if (speed < std::max(kMostSpeed, kMostLengths * length)) return;
        m_diagnostics.hint(Code::WeakMotor, wheel.motor->nameRange,
                           wheel.motor->name + " of " + config.name + " turns its wheel at up to " + figureText(wheel.topRate()) +
                               " rad/s: that is " + figureText(speed) + " m/s, " + figureText(speed / length) +
                               " times the length of the robot in a second; a larger GearRatio, now " +
                               figureText(wheel.motor->number("GearRatio")) + ", or a smaller SpeedConstant is more usual");
    }

    /// Of its motors at stall, V: what its battery gives while all draw from it; without one there is no limit but MaxVoltage.
    [[nodiscard]] static double voltsAt(const RobotConfigSpec& config, const std::vector<DriveWheel>& wheels) {
        const auto battery = std::ranges::find(config.devices, "Battery", &ComponentSpec::kind);
        if (battery == config.devices.end()) return HUGE_VAL;
        double volts = battery->number("Voltage");
        if (!(volts > 0)) volts = battery->number("Cells") * (battery->text("Chemistry") == "LiIon" ? kLithium : kNickel);
        double conductance = 0; // 1/ohm
        for (const DriveWheel& wheel : wheels) conductance += 1 / std::max(1e-9, wheel.motor->number("Resistance"));
        return volts > 0 ? volts / (1 + battery->number("InternalResistance") * conductance) : HUGE_VAL;
    }
    /// N m at the wheel, at stall.
    [[nodiscard]] static double torqueOf(const DriveWheel& wheel, double volts) {
        const ComponentSpec& motor = *wheel.motor;
        double share = std::min(1.0, volts / std::max(1e-9, motor.number("MaxVoltage")));
        const double amperes = motor.number("MaxVoltage") / std::max(1e-9, motor.number("Resistance")),
                     limit = motor.number("CurrentLimit");
        if (limit > 0) share = std::min(share, limit / std::max(1e-9, amperes));
        return std::max(0.0, share * wheel.stallTorque() - motor.number("GearRatio") * motor.number("FrictionTorque"));
    }
    /// Whether without limits of current, battery and friction the motors gave half as much again.
    [[nodiscard]] static bool isHeldBack(const std::vector<DriveWheel>& wheels, double volts) {
        const DriveWheel& wheel = wheels.front();
        return wheel.stallTorque() > kHeldBack * torqueOf(wheel, volts);
    }
    [[nodiscard]] static std::string remedyFor(const std::vector<DriveWheel>& wheels, double volts) {
        const ComponentSpec& motor = *wheels.front().motor;
        std::string causes;
        const auto add = [&](const std::string& cause) { causes += (causes.empty() ? "" : ", ") + cause; };
        if (isHeldBack(wheels, volts)) {
            const double resistance = motor.number("Resistance"), limit = motor.number("CurrentLimit"),
                         most = motor.number("MaxVoltage");
            if (limit > 0 && limit * resistance < most) add("their CurrentLimit of " + figureText(limit) + " A");
            if (volts < most) add("the battery, which gives " + figureText(volts) + " V at stall");
            if (motor.number("FrictionTorque") > 0)
                add("their FrictionTorque of " + figureText(motor.number("FrictionTorque")) + " N m");
        }
        return causes.empty() ? "a larger GearRatio, TorqueConstant or MaxVoltage, or less mass, helps"
                              : "what holds them back is " + causes;
    }

    /// At stall, on the steepest ramp.
    void checkStrength(const RobotConfigSpec& config, const std::vector<DriveWheel>& wheels) {
        double push = 0, mass = 0;
        const double volts = voltsAt(config, wheels);
        for (const DriveWheel& wheel : wheels) push += torqueOf(wheel, volts) / wheel.geom->radius;
        for (const BodySpec& body : config.bodies) mass += body.mass.mass;
        const double needed = mass * m_experiment.settings.gravity.norm() * std::sin(m_ramp.slope);
        if (!(wheels.front().stallTorque() > 0) || push >= needed) return;
        const ComponentSpec& motor = *wheels.front().motor;
        const std::string slope = figureText(m_ramp.slope / kDegree) + " degrees" +
                                  (m_ramp.name.empty() ? std::string() : ", that of " + m_ramp.name + ",");
        Diagnostic& d = m_diagnostics.warning(Code::WeakMotor, motor.nameRange,
                                              "the motors of " + config.name + " push with at most " + figureText(push) +
                                                  " N together, and a slope of " + slope + " needs " + figureText(needed) +
                                                  " N: it does not climb that; " + remedyFor(wheels, volts));
        const double ratio = needed / std::max(push, 1e-9) * kReserve;
        if (ratio > kMostGear || isHeldBack(wheels, volts)) return; // another value is odd
        Fix fix{"GearRatio=" + figureText(motor.number("GearRatio") * ratio), {}};
        std::set<std::uint32_t> written;
        for (const DriveWheel& wheel : wheels) {
            const ResolvedValue* gear = wheel.motor->find("GearRatio");
            if (!gear || !gear->range.known() || gear->range.file >= m_loaded.paths.size() ||
                m_loaded.paths[gear->range.file].empty() || gear->range.file != motor.range.file ||
                m_loaded.sources.slice(gear->range).find('$') != std::string_view::npos)
                return;
            if (written.insert(gear->range.range.begin).second) // a Part writes it once for its wheels
                fix.edits.push_back({gear->range, figureText(wheel.motor->number("GearRatio") * ratio)});
        }
        d.fixes.push_back(std::move(fix));
    }

    /// Scenery that the fastest robot could be through in one tick.
    void checkThin() {
        const double way = m_fastest * m_experiment.settings.tick;
        std::size_t others = 0;
        const GeomSpec* thinnest = nullptr;
        std::string name;
        double width = way;
        for (const StaticSpec& object : m_experiment.statics) {
            if (!object.geoms) continue;
            for (const GeomSpec& geom : *object.geoms) {
                if (!geom.collide || !(smallestWidth(geom) < way)) continue;
                ++others;
                if (smallestWidth(geom) >= width) continue;
                thinnest = &geom, name = object.name + "/" + geom.name, width = smallestWidth(geom);
            }
        }
        if (!thinnest) return;
        double tick = std::pow(10, std::floor(std::log10(width / m_fastest))); // 1, 2 or 5 times a power of ten
        for (const double factor : {5., 2.})
            if (factor * tick <= width / m_fastest) {
                tick *= factor;
                break;
            }
        Diagnostic& d = m_diagnostics.hint(
            Code::ThinPart, thinnest->nameRange,
            name + " is " + lengthText(width) + " thick, and " + m_fastestName + " gets " + lengthText(way) +
                " far in a tick at its top speed of " + figureText(m_fastest) +
                " m/s: it may be inside before it touches; make it thicker or the Tick " + figureText(1e3 * tick) + " ms" +
                (others > 1 ? " (and " + std::to_string(others - 1) + " more like it)" : std::string()));
        const auto edits = editsForValues(m_loaded, {{DottedPath("Tick"), ParsedValue(shortNumber(tick))}});
        if (edits.ok() && edits.value().size() == 1)
            d.fixes.push_back({"Tick = " + shortNumber(tick), edits.value().begin()->second});
    }

    const LoadedProject& m_loaded;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    Vec3 m_up;
    Ramp m_ramp;
    double m_fastest = 0; ///< m/s
    std::string m_fastestName;
};

} // namespace

void checkSpeeds(const LoadedProject& loaded, const Vec3& up, Diagnostics& diagnostics) {
    SpeedCheck(loaded, up, diagnostics).check();
}

} // namespace trundle
