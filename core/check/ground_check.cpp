// Wheels that stay in the air, or whose axle is across them. Method: rays from each shape down to the ground beneath; when the lowest one
// touches it, the gaps below the others are what is between them.
#include <algorithm>
#include <cmath>
#include <set>

#include "check/checks.h"
#include "check/drive_directions.h"
#include "check/extent.h"

namespace trundle {

namespace {

constexpr double kOffGround = 3e-3, kOffShare = 0.05;    // m, and of the radius: a wheel this far up carries nothing
constexpr double kOffShareOfMany = 0.15;                 // the same where enough others carry: some are meant to be higher
constexpr std::ptrdiff_t kPair = 2, kEnough = 3;         // supports
constexpr double kSamePlane = 0.9999, kSameLevel = 5e-3; // cosine; m
constexpr double kAbreast = 0.05;                        // sine between an axle and the way to the wheel on the other side
constexpr double kInside = 5e-3;                         // m
constexpr double kTurned = 0.7;                          // cosine
constexpr double kFreeShare = 0.5;                       // of the radius
constexpr double kRay = 10;                              // m
constexpr double kAlong = 0.02;                          // sine between axles that are parallel

/// Whether the wheel is one of several about a carrier that turns about a parallel axle, until they touch: a bogie, a star of wheels.
bool isOfStar(const RobotConfigSpec& config, const DriveWheel& wheel, const std::vector<DriveWheel>& wheels) {
    const auto holderOf = [&](std::size_t body) {
        return std::ranges::find(config.joints, static_cast<int>(body), &JointSpec::child);
    };
    const auto axle = holderOf(wheel.body);
    if (axle == config.joints.end() || axle->parent <= 0) return false;
    const auto pivot = holderOf(static_cast<std::size_t>(axle->parent));
    if (pivot == config.joints.end() || pivot->type != JointType::Hinge || pivot->axis.cross(wheel.axis).norm() > kAlong)
        return false;
    return std::ranges::any_of(wheels, [&](const DriveWheel& other) {
        const auto its = holderOf(other.body);
        return other.body != wheel.body && its != config.joints.end() && its->parent == axle->parent;
    });
}

struct Low {
    const GeomSpec* geom;
    const BodySpec* body;
    double height; ///< m, above the ground
};

class GroundCheck {
public:
    GroundCheck(const StartScene& scene, Diagnostics& diagnostics)
        : m_scene(scene), m_experiment(scene.experiment()), m_diagnostics(diagnostics), m_up(scene.up()) {}

    void check() {
        std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
        for (std::uint32_t r = 0; r < m_experiment.robots.size(); ++r) {
            const RobotConfigSpec& config = *m_experiment.robots[r].config;
            if (!seen.insert(&config).second) continue;
            checkGround(r, drivenWheelsOf(config), freeWheelsOf(config));
            checkTracks(r);
        }
    }

private:
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

    /// Of all shapes that may touch the ground.
    [[nodiscard]] std::vector<Low> lowsOf(std::uint32_t r, const Vec3& normal) const {
        const RobotSpec& robot = m_experiment.robots[r];
        std::vector<Low> lows;
        for (const BodySpec& body : robot.config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (const auto height =
                        geom.collide ? heightOf(r, geom, robot.pose * body.pose * geom.pose, normal) : std::nullopt)
                    lows.push_back({&geom, &body, *height});
        return lows;
    }

    /// Whether the wheel on the other side, abreast of it, touches the ground.
    [[nodiscard]] static bool hasLowerTwin(const DriveWheel& wheel, const std::vector<Low>& lows, double lowest,
                                           const std::vector<DriveWheel>& wheels) {
        return std::ranges::any_of(wheels, [&](const DriveWheel& other) {
            const Vec3 way = other.centre - wheel.centre;
            const double aside = std::abs(way.dot(wheel.axis));
            const auto its = std::ranges::find(lows, other.geom, &Low::geom);
            return aside > wheel.geom->radius && way.cross(wheel.axis).norm() < kAbreast * aside && its != lows.end() &&
                   its->height - lowest <= kOffGround;
        });
    }

    /// A robot on its side, or upside down: the axles of its wheels are upright, or turned over its wheels would be lowest.
    [[nodiscard]] bool reportedTurned(std::uint32_t r, const std::vector<DriveWheel>& wheels) {
        const RobotSpec& robot = m_experiment.robots[r];
        double lowestOfWheels = HUGE_VAL, highestOfWheels = -HUGE_VAL; // m, along the ground's normal
        const auto isUpright = [&](const DriveWheel& wheel) {
            if (ballUnder(*robot.config, wheel)) return false;
            return std::abs((robot.pose.rotation * wheel.axis).dot(m_up)) > kTurned;
        };
        for (const DriveWheel& wheel : wheels) {
            const Extent e =
                extentAlong(*wheel.geom, robot.pose * robot.config->bodies[wheel.body].pose * wheel.geom->pose, m_up);
            lowestOfWheels = std::min(lowestOfWheels, e.low), highestOfWheels = std::max(highestOfWheels, e.high);
        }
        const Extent all = extentAlong(*robot.config, robot.pose, m_up);
        const bool isOver = highestOfWheels >= all.high - kOffGround && lowestOfWheels > all.low + kOffGround &&
                            (robot.pose.rotation * Vec3::UnitZ()).dot(m_up) < -kTurned;
        if (!isOver && !std::ranges::all_of(wheels, isUpright)) return false;
        m_diagnostics.warning(
            Code::WheelOffGround, robot.nameRange,
            robot.name +
                (isOver ? " is upside down: its wheels are above" : " lies on its side: the axles of its wheels are upright") +
                "; check its HPR");
        return true;
    }

    /// Whether it starts inside something that is not the ground beneath its wheels: that says nothing of their heights.
    [[nodiscard]] bool startsInside(std::uint32_t r, const std::vector<DriveWheel>& wheels) const {
        const RobotSpec& robot = m_experiment.robots[r];
        const auto isGround = [&](std::uint32_t other) {
            return std::ranges::any_of(wheels, [&](const DriveWheel& wheel) {
                const Pose pose = robot.pose * robot.config->bodies[wheel.body].pose * wheel.geom->pose;
                const auto hit = m_scene.ray(pose.position + wheel.geom->radius * m_up, -m_up, kRay, r);
                return hit && hit->geom == other;
            });
        };
        for (std::size_t i = 0; i < m_scene.contactCount(); ++i) {
            const EngineContact c = m_scene.contact(i);
            for (const auto& [own, other] : {std::pair(c.first, c.second), {c.second, c.first}})
                if (c.depth > kInside && !m_scene.owner(own).isStatic && m_scene.owner(own).object == r &&
                    m_scene.owner(other).isStatic && !isGround(other))
                    return true;
        }
        return false;
    }

    /// Whether the wheel would touch a ground that is as high everywhere.
    [[nodiscard]] static bool isOverEdge(const RobotSpec& robot, const DriveWheel& wheel, const Low& lowest, const Vec3& normal,
                                         double share) {
        const auto lowOf = [&](const GeomSpec& geom, const BodySpec& body) {
            return extentAlong(geom, robot.pose * body.pose * geom.pose, normal).low;
        };
        const double gap = lowOf(*wheel.geom, robot.config->bodies[wheel.body]) - lowOf(*lowest.geom, *lowest.body);
        return gap <= std::max(kOffGround, share * wheel.geom->radius);
    }

    void reportEdge(const RobotSpec& robot, const DriveWheel& wheel, double gap) {
        m_diagnostics.warning(Code::WheelOffGround, robot.nameRange,
                              robot.name + " is placed over an edge: the ground below " + robot.config->bodies[wheel.body].name +
                                  " is " + lengthText(gap) + " lower than elsewhere below it; check its Pos");
    }

    /// Wheels that stay in the air when the lowest shape of their robot touches the ground. A free one that is higher than half of its
    /// radius is for something else, and one of a robot with three other supports too.
    void checkGround(std::uint32_t r, std::vector<DriveWheel> wheels, const std::vector<DriveWheel>& free) {
        if (wheels.empty() && free.empty()) return;
        wheels.insert(wheels.end(), free.begin(), free.end());
        const RobotSpec& robot = m_experiment.robots[r];
        if (reportedTurned(r, wheels) || startsInside(r, wheels)) return;
        const std::optional<Vec3> normal = groundNormal(r, wheels);
        if (!normal) return;
        const std::vector<Low> lows = lowsOf(r, *normal);
        if (lows.empty()) return;
        const Low lowest = *std::ranges::min_element(lows, {}, &Low::height);
        const auto supports = std::ranges::count_if(lows, [&](const Low& l) { return l.height - lowest.height <= kOffGround; });
        for (const DriveWheel& wheel : wheels) {
            const auto own = std::ranges::find(lows, wheel.geom, &Low::geom);
            if (own == lows.end()) continue;
            const double gap = own->height - lowest.height;
            const bool isOneOfMany = wheel.motor && supports >= kPair && !hasLowerTwin(wheel, lows, lowest.height, wheels);
            const double share = isOneOfMany ? kOffShareOfMany : kOffShare;
            if (gap <= std::max(kOffGround, share * wheel.geom->radius)) continue;
            if (ballUnder(*robot.config, wheel) || isOfStar(*robot.config, wheel, wheels)) continue;
            if (!wheel.motor && (supports >= kEnough || gap > kFreeShare * wheel.geom->radius)) continue;
            if (isOverEdge(robot, wheel, lowest, *normal, share)) reportEdge(robot, wheel, gap);
            else reportOffGround(*robot.config, wheel, *lowest.geom, *lowest.body, gap);
            return; // the others are the same fault
        }
        for (const DriveWheel& wheel : wheelsAcross(*robot.config)) {
            const auto own = std::ranges::find(lows, wheel.geom, &Low::geom);
            if (own != lows.end() && own->height - lowest.height <= std::max(kOffGround, kOffShare * wheel.geom->radius))
                return reportAcross(*robot.config, wheel);
        }
    }

    /// Tracks of which no geom touches the ground.
    void checkTracks(std::uint32_t r) {
        const RobotConfigSpec& config = *m_experiment.robots[r].config;
        std::vector<Low> lows;
        for (const ComponentSpec& track : config.devices) {
            if (track.kind != "Track") continue;
            if (lows.empty()) lows = lowsOf(r, m_up);
            if (lows.empty()) return;
            const Low lowest = *std::ranges::min_element(lows, {}, &Low::height);
            const std::vector<std::string> names = track.texts("Geom");
            double gap = HUGE_VAL; // m
            for (const Low& low : lows)
                if (std::ranges::find(names, low.body->name + "." + low.geom->name) != names.end())
                    gap = std::min(gap, low.height - lowest.height);
            if (gap <= kOffGround || !std::isfinite(gap)) continue;
            Diagnostic& d = m_diagnostics.warning(
                Code::WheelOffGround, track.nameRange,
                track.name + " of " + config.name + " is " + lengthText(gap) + " above the ground when " + lowest.geom->name +
                    " touches it: it moves in the air; lower its geoms, or raise " + lowest.geom->name);
            d.notes.push_back({"this touches the ground first", lowest.geom->nameRange});
            return;
        }
    }

    void reportAcross(const RobotConfigSpec& config, const DriveWheel& wheel) {
        const auto joint = std::ranges::find(config.joints, static_cast<int>(wheel.body), &JointSpec::child);
        m_diagnostics.warning(Code::WheelGeometry, joint->nameRange,
                              joint->name + " of " + config.name + " is not along the axis of " + config.bodies[wheel.body].name +
                                  "'s " + wheel.geom->name + ": the wheel does not roll; check its Axis, or the HPR of " +
                                  wheel.geom->name);
    }

    void reportOffGround(const RobotConfigSpec& config, const DriveWheel& wheel, const GeomSpec& lowest, const BodySpec& holder,
                         double gap) {
        const BodySpec& body = config.bodies[wheel.body];
        int same = 0; // geoms of that name, as the tyre of another wheel
        for (const BodySpec& each : config.bodies)
            same += static_cast<int>(std::ranges::count(each.geoms, lowest.name, &GeomSpec::name));
        const std::string touching = same > 1 || holder.name.find('.') != std::string::npos ? holder.name : lowest.name;
        Diagnostic& d = m_diagnostics.warning(
            Code::WheelOffGround, body.nameRange,
            body.name + " of " + config.name + " is " + lengthText(gap) + " above the ground when " + touching +
                " touches it: " + (wheel.motor ? "its motor turns it in the air" : "it carries nothing") +
                "; lower the wheel, or raise " + touching);
        d.notes.push_back({"this touches the ground first", lowest.nameRange});
    }

    const StartScene& m_scene;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    Vec3 m_up;
};

} // namespace

void checkGround(const StartScene& scene, Diagnostics& diagnostics) {
    if (!scene.up().isZero()) GroundCheck(scene, diagnostics).check();
}

} // namespace trundle
