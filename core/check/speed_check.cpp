// Checks of what motors can do: climb the ramps of the experiment, and how far a robot gets in one tick. Needs the start scene for
// wheels off the ground.

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
constexpr double kOffGround = 3e-3, kOffShare = 0.05; // m, and of the radius: a wheel this far up carries nothing
constexpr double kOffShareOfMany = 0.15;              // the same where enough others carry: some are meant to be higher
constexpr std::ptrdiff_t kPair = 2, kEnough = 3;      // supports
constexpr double kSamePlane = 0.9999, kSameLevel = 5e-3; // cosine; m
constexpr double kFreeShare = 0.5;                    // of the radius
constexpr double kRay = 10;                           // m

struct Ramp {
    double slope = kUsualSlope;
    std::string name; ///< empty: nothing is that thin
};

/// The steepest upper face of a box that a robot could drive on.
Ramp steepestRamp(const ExperimentSpec& experiment, const Vec3& up) {
    Ramp ramp;
    for (const StaticSpec& object : experiment.statics)
        for (const GeomSpec& geom : object.geoms ? *object.geoms : std::vector<GeomSpec>()) {
            if (!geom.collide || geom.shape != GeomShape::Box) continue;
            const Mat3 axes = (object.pose * geom.pose).rotation.toRotationMatrix();
            for (int k = 0; k < 3; ++k) {
                const double slope = std::acos(std::min(1.0, std::abs(axes.col(k).dot(up))));
                const bool isBroad = geom.size[k] <= 0.5 * std::min(geom.size[(k + 1) % 3], geom.size[(k + 2) % 3]);
                if (isBroad && slope > std::max(kLeastRamp, ramp.slope) && slope < kSteepestRamp)
                    ramp = {slope, object.name + "/" + geom.name};
            }
        }
    return ramp;
}

class SpeedCheck {
public:
    SpeedCheck(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics)
        : m_loaded(loaded), m_scene(scene), m_experiment(scene.experiment()), m_diagnostics(diagnostics), m_up(scene.up()),
          m_ramp(steepestRamp(m_experiment, m_up)) {}

    void check() {
        std::set<std::string> seen;
        for (std::uint32_t r = 0; r < m_experiment.robots.size(); ++r) {
            const RobotConfigSpec& config = *m_experiment.robots[r].config;
            if (!seen.insert(config.name).second) continue;
            const std::vector<DriveWheel> wheels = drivenWheelsOf(config), free = freeWheelsOf(config);
            for (const DriveWheel& wheel : wheels) {
                const double speed = wheel.topRate() * wheel.geom->radius;
                if (speed > m_fastest) m_fastest = speed, m_fastestName = config.name;
            }
            if (m_up.isZero()) continue;
            if (!wheels.empty()) checkStrength(config, wheels);
            checkGround(r, wheels, free);
        }
        if (m_fastest > 0) checkThin();
    }

private:
    /// At stall, on the steepest ramp.
    void checkStrength(const RobotConfigSpec& config, const std::vector<DriveWheel>& wheels) {
        double push = 0, mass = 0;
        for (const DriveWheel& wheel : wheels) push += wheel.stallTorque() / wheel.geom->radius;
        for (const BodySpec& body : config.bodies) mass += body.mass.mass;
        const double needed = mass * m_experiment.settings.gravity.norm() * std::sin(m_ramp.slope);
        if (!(push > 0) || push >= needed) return;
        const ComponentSpec& motor = *wheels.front().motor;
        const std::string slope = figureText(m_ramp.slope / kDegree) + " degrees" +
                                  (m_ramp.name.empty() ? std::string() : ", that of " + m_ramp.name + ",");
        Diagnostic& d = m_diagnostics.warning(
            Code::WeakMotor, motor.nameRange,
            "the motors of " + config.name + " push with at most " + figureText(push) + " N together, and a slope of " + slope +
                " needs " + figureText(needed) +
                " N: it does not climb that; a larger GearRatio, TorqueConstant or MaxVoltage, or less mass, helps");
        const double ratio = needed / push * kReserve;
        if (ratio > kMostGear) return; // another value is odd
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

    /// From the lowest point of a geom to the ground, along its normal; nothing if no scenery is beneath.
    [[nodiscard]] std::optional<double> heightOf(std::uint32_t r, const GeomSpec& geom, const Pose& X_WG,
                                                 const Vec3& normal) const {
        const double low = extentAlong(geom, X_WG, normal).low, middle = X_WG.position.dot(normal);
        const double above = std::max(0.02, middle - low); // m: it may start inside the ground
        const auto hit = m_scene.ray(X_WG.position + (low - middle + above) * normal, -normal, kRay, r);
        return hit && m_scene.owner(hit->geom).isStatic ? std::optional(hit->distance - above)
                                                        : std::nullopt; // no other robot is ground
    }

    /// The normal of the ground beneath all wheels; nothing where it is not one plane, as between rails.
    [[nodiscard]] std::optional<Vec3> groundNormal(std::uint32_t r, const std::vector<DriveWheel>& wheels) const {
        const RobotSpec& robot = m_experiment.robots[r];
        std::optional<Vec3> normal;
        double level = 0;
        for (const DriveWheel& wheel : wheels) {
            const Vec3 from =
                (robot.pose * robot.config->bodies[wheel.body].pose * wheel.geom->pose).position + wheel.geom->radius * m_up;
            const auto hit = m_scene.ray(from, -m_up, kRay, r);
            if (!hit) return std::nullopt;
            const Vec3 at = from - hit->distance * m_up;
            if (!normal) normal = hit->normal, level = at.dot(*normal);
            if (hit->normal.dot(*normal) < kSamePlane || std::abs(at.dot(*normal) - level) > kSameLevel) return std::nullopt;
        }
        return normal;
    }

    /// Wheels that stay in the air when the lowest shape of their robot touches the ground. A free one that is higher than half of its
    /// radius is for something else, and one of a robot with three other supports too.
    void checkGround(std::uint32_t r, std::vector<DriveWheel> wheels, const std::vector<DriveWheel>& free) {
        if (wheels.empty() && free.empty()) return;
        wheels.insert(wheels.end(), free.begin(), free.end());
        const RobotSpec& robot = m_experiment.robots[r];
        const std::optional<Vec3> normal = groundNormal(r, wheels);
        if (!normal) return;
        struct Low {
            const GeomSpec* geom;
            const BodySpec* body;
            double height;
        };
        std::vector<Low> lows;
        for (const BodySpec& body : robot.config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (const auto height =
                        geom.collide ? heightOf(r, geom, robot.pose * body.pose * geom.pose, *normal) : std::nullopt)
                    lows.push_back({&geom, &body, *height});
        if (lows.empty()) return;
        const Low lowest = *std::ranges::min_element(lows, {}, &Low::height);
        const auto supports = std::ranges::count_if(lows, [&](const Low& l) { return l.height - lowest.height <= kOffGround; });
        for (const DriveWheel& wheel : wheels) {
            const auto own = std::ranges::find(lows, wheel.geom, &Low::geom);
            if (own == lows.end()) continue;
            const double gap = own->height - lowest.height;
            const double share = wheel.motor && supports >= kPair ? kOffShareOfMany : kOffShare;
            if (gap <= std::max(kOffGround, share * wheel.geom->radius)) continue;
            if (!wheel.motor && (supports >= kEnough || gap > kFreeShare * wheel.geom->radius)) continue;
            reportOffGround(*robot.config, wheel, *lowest.geom, *lowest.body, gap);
            return; // the others are the same fault
        }
    }

    void reportOffGround(const RobotConfigSpec& config, const DriveWheel& wheel, const GeomSpec& lowest, const BodySpec& holder,
                         double gap) {
        const BodySpec& body = config.bodies[wheel.body];
        const bool isShared = lowest.nameRange == wheel.geom->nameRange; // the tyre of another wheel, made by the same text
        const std::string touching = isShared || holder.name.find('.') != std::string::npos ? holder.name : lowest.name;
        Diagnostic& d = m_diagnostics.warning(
            Code::WheelOffGround, body.nameRange,
            body.name + " of " + config.name + " is " + lengthText(gap) + " above the ground when " + touching +
                " touches it: " + (wheel.motor ? "its motor turns it in the air" : "it carries nothing") +
                "; lower the wheel, or raise " + touching);
        d.notes.push_back({"this touches the ground first", lowest.nameRange});
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
    const StartScene& m_scene;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    Vec3 m_up;
    Ramp m_ramp;
    double m_fastest = 0; ///< m/s
    std::string m_fastestName;
};

} // namespace

void checkSpeeds(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics) {
    SpeedCheck(loaded, scene, diagnostics).check();
}

} // namespace trundle
