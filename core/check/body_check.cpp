// Checks of how the bodies of a config hang together, and of their mass properties. Method: joints and springs connect bodies, the
// world is one more of them; a joint between two that are connected already closes a loop.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "check/body_groups.h"
#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/extent.h"
#include "project/edits/plans.h"

namespace trundle {

namespace {

constexpr double kOutside = 0.1;      // of the extent: the centre of mass may be that far outside of the shapes
constexpr double kFarAnchor = 2;      // of the size of both bodies
constexpr double kLevelWheel = 0.1;   // z of the unit axis of a cylinder
constexpr double kSamePlace = 1e-6, kSameAngle = 1e-6; // m, rad
constexpr double kLeastSpread = 1e-3; // of the moment of inertia of a solid box around the shapes

bool isSamePose(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() < kSamePlace && a.rotation.angularDistance(b.rotation) < kSameAngle;
}

using FixPlaces = std::set<std::pair<Code, SourceRange>>;

class BodyCheck {
public:
    /// `planned`: the places that have a fix by the check of another config, which is shown there alone.
    BodyCheck(const LoadedProject& loaded, const RobotSpec& robot, FixPlaces& planned, Diagnostics& diagnostics)
        : m_loaded(loaded), m_robot(robot), m_config(*robot.config), m_planned(planned), m_diagnostics(diagnostics) {}

    void check() {
        BodyGroups groups(m_config.bodies.size());
        std::set<std::pair<int, int>> joined; // a second joint between two bodies has a warning of its own
        for (const JointSpec& joint : m_config.joints)
            if (joined.insert(std::minmax(joint.parent, joint.child)).second && !groups.join(joint.parent, joint.child))
                reportLoop(joint);
        for (const JointSpec& joint : m_config.joints) checkAnchor(joint);
        for (const SpringSpec& spring : m_config.springs) groups.join(spring.parent, spring.child);
        if (!m_config.joints.empty() || isMeantAsOne()) reportLoose(groups);
        for (const BodySpec& body : m_config.bodies) checkMass(body);
        checkPlaces();
    }

private:
    [[nodiscard]] std::string nameOf(int body) const {
        return body == kWorldBody ? "the world" : m_config.bodies[static_cast<std::size_t>(body)].name;
    }
    [[nodiscard]] std::string pathOf(const std::string& name) const { return "RobotConfig." + m_config.name + "." + name; }

    template <class MakePlan> void addFix(Diagnostic& d, const std::string& title, const MakePlan& makePlan) {
        if (!m_planned.emplace(d.code, d.range).second) return;
        const Result<EditPlan> plan = makePlan();
        if (plan.ok() && plan.value().edits.size() == 1) d.fixes.push_back({title, plan.value().edits.begin()->second});
    }

    void reportLoop(const JointSpec& joint) {
        m_diagnostics.hint(Code::ClosedLoop, joint.nameRange,
                           joint.name + " of " + m_config.name + " closes a loop of joints, from " + nameOf(joint.parent) +
                               " to " + nameOf(joint.child) +
                               ", which other joints connect already: the loop is held by forces alone and drifts a little; a "
                               "Spring or a Gear needs no loop");
    }

    /// Bodies without any joint are one robot, and no heap of things, if it has devices, or something with wheels beside it.
    [[nodiscard]] bool isMeantAsOne() const {
        const auto isWheel = [](const BodySpec& body) {
            return std::ranges::any_of(body.geoms, [&](const GeomSpec& geom) {
                const Vec3 axis = body.pose.rotation * (geom.pose.rotation * Vec3::UnitZ());
                return geom.shape == GeomShape::Cylinder && geom.length < 2 * geom.radius && std::abs(axis.z()) < kLevelWheel;
            });
        };
        const auto wheels = static_cast<std::size_t>(std::ranges::count_if(m_config.bodies, isWheel));
        return !m_config.devices.empty() || (wheels > 0 && wheels < m_config.bodies.size());
    }

    /// Of the bodies that are connected to one, the first that is no joint's child: it has to be held.
    [[nodiscard]] std::size_t heldBy(BodyGroups& groups, std::size_t body) const {
        for (std::size_t b = 0; b < m_config.bodies.size(); ++b) {
            const auto isChild = [&](const JointSpec& joint) { return joint.child == static_cast<int>(b); };
            const bool isWithIt = groups.of(static_cast<int>(b)) == groups.of(static_cast<int>(body));
            if (isWithIt && std::ranges::none_of(m_config.joints, isChild)) return b;
        }
        return body;
    }

    void reportLoose(BodyGroups& groups) {
        std::set<std::size_t> reported{groups.of(0), groups.of(kWorldBody)};
        for (const DriveWheel& wheel : drivenWheelsOf(m_config))
            if (const auto ball = ballUnder(m_config, wheel)) reported.insert(groups.of(static_cast<int>(*ball)));
        for (std::size_t b = 0; b < m_config.bodies.size(); ++b) {
            if (!reported.insert(groups.of(static_cast<int>(b))).second) continue;
            const BodySpec& body = m_config.bodies[heldBy(groups, b)];
            Diagnostic& d = m_diagnostics.warning(Code::LooseBody, body.nameRange,
                                                  body.name + " of " + m_config.name +
                                                      " is held by no joint, and stays behind when the robot moves; " +
                                                      "a joint with Child=" + body.name + " holds it");
            if (body.name.find('.') != std::string::npos) continue; // of a Part: the joint belongs into its config
            const auto isRound = [](const GeomSpec& g) { return g.shape == GeomShape::Cylinder || g.shape == GeomShape::Sphere; };
            if (std::ranges::any_of(body.geoms, isRound)) continue; // a wheel or a ball is to turn
            addFix(d, "fix it to " + m_config.bodies[0].name, [&] {
                return planInsert(m_loaded, "RobotConfig." + m_config.name,
                                  "Fixed " + body.name + "Hold { Parent=" + m_config.bodies[0].name + " Child=" + body.name +
                                      " }");
            });
        }
    }

    /// Reports the first body that is in the place of another one with the same shapes.
    void checkPlaces() {
        std::map<std::array<long, 3>, std::vector<const BodySpec*>> near; // by place of the origin
        for (const BodySpec& body : m_config.bodies) {
            std::array<long, 3> cell{};
            for (int k = 0; k < 3; ++k) cell[static_cast<std::size_t>(k)] = std::lround(body.pose.position[k] / kSamePlace);
            std::vector<const BodySpec*>& others = near[cell];
            for (const BodySpec* other : others) {
                if (!isTwin(body, *other)) continue;
                m_diagnostics.warning(Code::StartOverlap, body.nameRange,
                                      body.name + " of " + m_config.name + " is in the place of " + other->name +
                                          ", which has the same shapes; check its Pos and HPR, or those of its Part");
                return;
            }
            others.push_back(&body);
        }
    }

    /// Reports a joint that is far from both its bodies, as with millimetres for metres.
    void checkAnchor(const JointSpec& joint) {
        if (joint.parent == kWorldBody || joint.type == JointType::Fixed || joint.type == JointType::Slider) return;
        double size = 0, distance = 0; // m, of both bodies together; from the farther one
        for (const int index : {joint.parent, joint.child}) {
            const BodySpec& body = m_config.bodies[static_cast<std::size_t>(index)];
            if (body.geoms.empty()) return;
            const auto [low, high] = boxAround(body);
            const Vec3 at = body.pose.inverse() * joint.anchor;
            size += (high - low).norm();
            distance = std::max(distance, (low - at).cwiseMax(at - high).cwiseMax(0.0).norm());
        }
        if (!(distance > kFarAnchor * size)) return;
        m_diagnostics.warning(Code::BadJoint, joint.nameRange,
                              joint.name + " of " + m_config.name + " is " + lengthText(distance) + " away from " +
                                  nameOf(joint.parent) + " or " + nameOf(joint.child) +
                                  "; check its Anchor, or the Pos of what it joins");
    }

    /// Compares the mass properties with those that shapes of this extent can have.
    void checkMass(const BodySpec& body) {
        const auto [low, high] = boxAround(body);
        const Vec3 size = high - low;
        if (body.geoms.empty() || !(size.minCoeff() > 0)) return;
        const Vec3& centre = body.mass.centre;
        const Vec3 reach = (centre - low).cwiseMax(high - centre); // the farthest that mass can be from the centre
        for (int k = 0; k < 3; ++k) {
            const double outside = std::max(low[k] - centre[k], centre[k] - high[k]);
            if (outside > kOutside * size[k]) return reportCentre(body, outside);
        }
        for (int k = 0; k < 3; ++k) {
            const int u = (k + 1) % 3, v = (k + 2) % 3;
            const double most = body.mass.mass * (reach[u] * reach[u] + reach[v] * reach[v]);
            const double solid = body.mass.mass * (size[u] * size[u] + size[v] * size[v]) / 12, given = body.mass.inertia(k, k);
            if (given > most || given < kLeastSpread * solid) return reportInertia(body, "XYZ"[k], given, solid, given > most);
        }
    }

    void reportCentre(const BodySpec& body, double outside) {
        m_diagnostics.warning(Code::OddInertia, body.nameRange,
                              "the centre of mass of " + body.name + " in " + m_config.name + " is " + lengthText(outside) +
                                  " outside of its shapes; check its place, or the masses of its shapes");
    }

    void reportInertia(const BodySpec& body, char axis, double given, double solid, bool isLarge) {
        Diagnostic& d = m_diagnostics.warning(
            Code::OddInertia, body.nameRange,
            "the inertia of " + body.name + " in " + m_config.name + " about " + axis + " is " + figureText(given) + " kg m^2, " +
                (isLarge ? "more than its mass can have inside its shapes" : "far less than its mass has inside its shapes") +
                "; a solid of this size has about " + figureText(solid) + " kg m^2");
        addFix(d, "take it from the shapes", [&] {
            const Result<EditPlan> ofRobot = planReset(m_loaded, {m_robot.name + "." + body.name + ".Inertia"});
            return ofRobot.ok() ? ofRobot : planReset(m_loaded, {pathOf(body.name) + ".Inertia"});
        });
    }

    const LoadedProject& m_loaded;
    const RobotSpec& m_robot; ///< the first with this config
    const RobotConfigSpec& m_config;
    FixPlaces& m_planned;
    Diagnostics& m_diagnostics;
};

} // namespace

bool isTwin(const BodySpec& a, const BodySpec& b) {
    const auto isAlike = [&](const GeomSpec& x, const GeomSpec& y) {
        return x.collide && y.collide && x.shape == y.shape && x.size.isApprox(y.size) && x.radius == y.radius &&
               x.length == y.length && x.mesh == y.mesh && isSamePose(a.pose * x.pose, b.pose * y.pose);
    };
    return !a.geoms.empty() && std::ranges::equal(a.geoms, b.geoms, isAlike);
}

void checkBodies(const LoadedProject& loaded, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    FixPlaces planned;
    for (const RobotSpec& robot : loaded.experiment->robots)
        if (robot.config && !robot.config->bodies.empty() && seen.insert(robot.config.get()).second)
            BodyCheck(loaded, robot, planned, diagnostics).check();
}

} // namespace trundle
