// Springs that swing faster than a tick can follow. Method: the frequency of each spring with the bodies that it joins; a suspension's
// with the body that it carries, whose weight is shared by its wheels; a soft contact's with a robot on three points.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Dense>

#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/linked_bodies.h"
#include "world/spring_row.h"

namespace trundle {

namespace {

constexpr double kLeastDamping = 0.02, kUsualDamping = 0.3; // of the critical one of a suspension
constexpr double kLevelStrut = 0.3;                         // z of its unit axis
constexpr double kPoints = 3; // that carry a robot
// The ground's own spring: at least this stiff, and giving at most this far under a robot.
constexpr double kGroundStiffness = 2e5, kGroundSag = 1e-4, kGravity = 9.81; // N/m, m, m/s^2

std::string in(const RobotConfigSpec& config) { return config.name.empty() ? std::string() : " in " + config.name; }

class SpringCheck {
public:
    SpringCheck(const ExperimentSpec& experiment, Diagnostics& diagnostics)
        : m_tick(experiment.settings.tick), m_experiment(experiment), m_diagnostics(diagnostics) {
        for (const StaticSpec& object : experiment.statics)
            if (object.geoms)
                for (const GeomSpec& geom : *object.geoms)
                    if (geom.collide) m_grounds.insert(geom.surface);
    }

    void check(const RobotConfigSpec& config) {
        for (const JointSpec& joint : config.joints) {
            if (!(joint.stiffness > 0) || reportedLevel(config, joint)) continue;
            const double inertia = inertiaOf(joint, config);
            if (!report(joint.nameRange, "the spring of " + joint.name + in(config), joint.stiffness, joint.damping, inertia) &&
                joint.type == JointType::Suspension)
                checkDamping(config, joint, inertia);
        }
        for (const SpringSpec& spring : config.springs)
            if (spring.stiffness > 0)
                report(spring.nameRange, "the spring " + spring.name + in(config), spring.stiffness, spring.damping,
                       inertiaOf(spring, config));
        double mass = 0;
        std::set<std::uint32_t> surfaces;
        for (const BodySpec& body : config.bodies) {
            mass += body.mass.mass;
            for (const GeomSpec& geom : body.geoms)
                if (geom.collide) surfaces.insert(geom.surface);
        }
        for (const std::uint32_t index : surfaces) {
            checkContact(config, mass, index, index);
            for (const std::uint32_t ground : m_grounds) checkContact(config, mass, index, ground);
        }
    }

private:
    /// A robot's surface on that of a static; each soft surface is reported once.
    void checkContact(const RobotConfigSpec& config, double mass, std::uint32_t own, std::uint32_t ground) {
        const SurfaceSpec &a = m_experiment.surfaces[own], &b = m_experiment.surfaces[ground];
        const double softness = a.softness + (own == ground ? 0 : b.softness);
        const std::uint32_t softer = a.softness >= b.softness ? own : ground;
        if (!(softness > 0) || m_reported.contains(softer)) return;
        const SurfaceSpec& surface = m_experiment.surfaces[softer];
        const double solid = std::max(kGroundStiffness, mass * kGravity / (kPoints * kGroundSag));
        if (report(surface.nameRange, config.name + " on Surface " + surface.name, 1 / (softness + 1 / solid), 0, mass / kPoints))
            m_reported.insert(softer);
    }
    [[nodiscard]] static double about(const JointSpec& joint, const BodySpec& body) {
        const Vec3 axis = body.pose.rotation.conjugate() * joint.axis,
                   arm = body.pose.rotation.conjugate() * (joint.anchor - body.pose * body.mass.centre);
        return axis.dot(body.mass.inertia * axis) + body.mass.mass * arm.cross(axis).squaredNorm();
    }
    /// The reduced inertia of the two bodies along the joint.
    [[nodiscard]] static double inertiaOf(const JointSpec& joint, const RobotConfigSpec& config) {
        const BodySpec& child = config.bodies[static_cast<std::size_t>(joint.child)];
        const bool turns = joint.type == JointType::Hinge;
        const double own = turns ? about(joint, child) : child.mass.mass;
        if (joint.parent == kWorldBody) return own;
        const BodySpec& parent = config.bodies[static_cast<std::size_t>(joint.parent)];
        if (joint.type == JointType::Suspension) {
            double wheels = 0;
            for (const JointSpec& other : config.joints) wheels += other.type == joint.type && other.parent == joint.parent;
            return parent.mass.mass / wheels;
        }
        const double other = turns ? about(joint, parent) : parent.mass.mass;
        return own * other / (own + other);
    }

    /// The reduced mass of the two bodies along the spring's line, each free.
    [[nodiscard]] static double inertiaOf(const SpringSpec& spring, const RobotConfigSpec& config) {
        const Vec3 apart = spring.anchor2 - spring.anchor;
        const Vec3 way = apart.norm() > 1e-9 ? Vec3(apart.normalized()) : Vec3(Vec3::UnitZ());
        const auto mobility = [&](int index, const Vec3& point) {
            if (index == kWorldBody) return 0.0;
            const BodySpec& body = config.bodies[static_cast<std::size_t>(index)];
            const Vec3 arm = body.pose.rotation.conjugate() * (point - body.pose * body.mass.centre).cross(way);
            return 1 / body.mass.mass + arm.dot(body.mass.inertia.inverse() * arm);
        };
        return 1 / (mobility(spring.child, spring.anchor2) + mobility(spring.parent, spring.anchor));
    }

    /// A strut that carries a wheel, but gives way along the ground: once for a config.
    bool reportedLevel(const RobotConfigSpec& config, const JointSpec& joint) {
        if (joint.type != JointType::Slider || std::abs(joint.axis.z()) > kLevelStrut) return false;
        const auto isItsWheel = [&](const JointSpec& axle) {
            const auto wheel = axle.parent == joint.child ? wheelOn(config, axle) : std::nullopt;
            return wheel && wheel->geom->shape == GeomShape::Cylinder;
        };
        if (std::ranges::none_of(config.joints, isItsWheel)) return false;
        if (m_level.insert(&config).second)
            m_diagnostics.warning(
                Code::BadJoint, joint.nameRange,
                joint.name + " of " + config.name +
                    " has a spring and carries a wheel, but slides along the ground: it gives way when the robot "
                    "drives, and does not spring; check its Axis, which is upwards if it is not given");
        return true;
    }

    /// Reports the first suspension of a config that keeps swinging.
    void checkDamping(const RobotConfigSpec& config, const JointSpec& joint, double inertia) {
        const double critical = 2 * std::sqrt(joint.stiffness * inertia); // N s/m
        if (joint.damping >= kLeastDamping * critical || !m_undamped.insert(&config).second) return;
        m_diagnostics.hint(Code::SpringTooFast, joint.nameRange,
                           joint.name + (config.name.empty() ? "" : " of " + config.name) +
                               " hardly damps its spring: after a bump the robot keeps swinging at " +
                               figureText(std::sqrt(joint.stiffness / inertia) / (2 * std::numbers::pi)) + " Hz; a Damping of " +
                               figureText(kUsualDamping * critical) + " N s/m, now " + figureText(joint.damping) + ", calms it");
    }

    bool report(const SourceRange& range, const std::string& what, double stiffness, double damping, double inertia) {
        const double turn = springTurn(stiffness, damping, inertia, m_tick);
        if (!(turn > kMaxSpringTurn)) return false;
        constexpr double kTurn = 2 * std::numbers::pi;
        m_diagnostics.warning(Code::SpringTooFast, range,
                              what + " swings at " + figureText(turn / m_tick / kTurn) + " Hz; a tick of " +
                                  figureText(1e3 * m_tick) + " ms follows up to " + figureText(kMaxSpringTurn / m_tick / kTurn) +
                                  " Hz, and damps it strongly; make it softer, or the Tick at most " +
                                  figureText(1e3 * m_tick * kMaxSpringTurn / turn) + " ms");
        return true;
    }

    double m_tick;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    std::set<std::uint32_t> m_grounds, m_reported; ///< surfaces
    std::set<const RobotConfigSpec*> m_undamped, m_level; ///< reported; membership test only
};

} // namespace

void checkSprings(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    SpringCheck check(experiment, diagnostics);
    for (const RobotSpec& robot : experiment.robots)
        if (robot.config && seen.insert(robot.config.get()).second) check.check(*robot.config);
    check.check(linkedBodies(experiment));
}

} // namespace trundle
