#include "world/validate.h"
#include "world/wheeled/wheeled.h"

#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>

#include "model/gear_line.h"

namespace trundle {

namespace {

constexpr double kFarthest = 1e5;                   // m
constexpr double kSmallest = 1e-6;                  // m
constexpr double kLightest = 1e-9, kHeaviest = 1e9; // kg

bool isIn(double value, double low, double high) { return value >= low && value <= high; } // false for NaN

bool isUnit(const Vec3& v) { return v.allFinite() && std::abs(v.norm() - 1) < 1e-6; }

/// Checks one experiment and reports every problem found; `where` is the path that precedes the message.
class Check {
public:
    explicit Check(const ExperimentSpec& experiment, Diagnostics& diagnostics)
        : m_experiment(experiment), m_diagnostics(diagnostics) {}

    bool all() {
        settings();
        surfaces();
        for (const StaticSpec& s : m_experiment.statics) scenery(s);
        for (const RobotSpec& r : m_experiment.robots) robot(r);
        for (const auto& link : m_experiment.joints)
            if (ends(link)) jointValues(link.spec, link.parentRobot == kWorldBody);
        for (const auto& link : m_experiment.springs)
            if (ends(link)) springValues(link.spec);
        for (const RegionSpec& r : m_experiment.regions)
            need(isPosition(r.pose) && r.size.allFinite() && r.size.minCoeff() > 0, Code::OutOfRange, r.nameRange,
                 r.name + " has no valid position or size");
        return m_good;
    }

private:
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    std::set<const RobotConfigSpec*> m_seen; // for lookup only, never iterated
    bool m_good = true;

    void bad(Code code, const SourceRange& range, std::string message) {
        m_diagnostics.error(code, range, std::move(message));
        m_good = false;
    }
    bool need(bool holds, Code code, const SourceRange& range, const std::string& message) {
        if (!holds) bad(code, range, message);
        return holds;
    }

    void settings() {
        const SettingsSpec& s = m_experiment.settings;
        need(isIn(s.tick, 1e-6, 1), Code::OutOfRange, {}, "Tick must be from 0.000001 to 1 s");
        need(s.gravity.allFinite() && s.gravity.norm() <= 1e4, Code::OutOfRange, {},
             "Gravity must be finite and at most 10000 m/s^2");
        need(s.iterations >= 1 && s.iterations <= 100000, Code::OutOfRange, {}, "Iterations must be from 1 to 100000");
        need(isIn(s.errorReduction, 0.05, 0.95), Code::OutOfRange, {}, "ErrorReduction must be from 0.05 to 0.95");
        need(!m_experiment.surfaces.empty(), Code::Internal, {}, "there is no default surface");
    }

    void surfaces() {
        for (const SurfaceSpec& s : m_experiment.surfaces) {
            need(isIn(s.friction, 0, 1e6), Code::OutOfRange, s.nameRange, "Friction of " + s.name + " must be 0 or more");
            need(isIn(s.friction2.value_or(0), 0, 1e6), Code::OutOfRange, s.nameRange,
                 "Friction2 of " + s.name + " must be 0 or more");
            need(isIn(s.frictionHeading, -1e6, 1e6), Code::OutOfRange, s.nameRange,
                 "FrictionHeading of " + s.name + " must be an angle");
            need(isIn(s.restitution, 0, 1), Code::OutOfRange, s.nameRange, "Restitution of " + s.name + " must be from 0 to 1");
            need(isIn(s.rollingFriction, 0, 1e3), Code::OutOfRange, s.nameRange,
                 "RollingFriction of " + s.name + " must be 0 or more");
            need(isIn(s.softness, 0, 1e3), Code::OutOfRange, s.nameRange, "Softness of " + s.name + " must be 0 or more");
        }
    }

    void scenery(const StaticSpec& s) {
        need(isPosition(s.pose), Code::OutOfRange, s.nameRange,
             s.name + " has an invalid position: it must be finite and within 100 km");
        if (!s.geoms) return;
        for (const GeomSpec& g : *s.geoms) geom(g, false, s.name);
    }

    void robot(const RobotSpec& r) {
        need(isPosition(r.pose), Code::OutOfRange, r.nameRange,
             r.name + " has an invalid position: it must be finite and within 100 km");
        if (!need(r.config && !r.config->bodies.empty(), Code::BadGeometry, r.nameRange, r.name + " has no body")) return;
        if (!m_seen.insert(r.config.get()).second) return; // checked once, even if several robots share it
        for (const BodySpec& b : r.config->bodies) body(b);
        for (const JointSpec& j : r.config->joints) joint(j, *r.config);
        for (const SpringSpec& s : r.config->springs) spring(s, *r.config);
        for (const GearSpec& g : r.config->gears) gear(g, *r.config);
    }

    void body(const BodySpec& b) {
        need(isPosition(b.pose), Code::OutOfRange, b.nameRange,
             b.name + " has an invalid position: it must be finite and within 100 km");
        if (b.isFixed) return;
        const MassProperties& m = b.mass;
        if (!need(isIn(m.mass, kLightest, kHeaviest), Code::BadMass, b.nameRange,
                  "the mass of " + b.name + " must be from 1e-9 to 1e9 kg"))
            return;
        need(m.centre.allFinite() && m.centre.norm() <= kFarthest, Code::BadMass, b.nameRange,
             "the centre of mass of " + b.name + " is not a valid position");
        inertia(b);
        for (const GeomSpec& g : b.geoms) geom(g, true, b.name);
    }

    void inertia(const BodySpec& b) {
        const Mat3& i = b.mass.inertia;
        if (!need(i.allFinite() && i.isApprox(i.transpose(), 1e-9), Code::BadMass, b.nameRange,
                  "the inertia of " + b.name + " is not symmetric"))
            return;
        const Vec3 e = Eigen::SelfAdjointEigenSolver<Mat3>(i, Eigen::EigenvaluesOnly).eigenvalues();
        if (!need(e[0] > 0 && e[0] > 1e-10 * e[2], Code::BadMass, b.nameRange,
                  "the inertia of " + b.name + " must be positive about every axis"))
            return;
        need(e[0] + e[1] >= e[2] * (1 - 1e-6), Code::BadMass, b.nameRange,
             "no body has the inertia of " + b.name + ": about one axis it is more than about the other two together");
    }

    void geom(const GeomSpec& g, bool onBody, const std::string& where) {
        const std::string name = where + "." + g.name;
        need(isPosition(g.pose), Code::OutOfRange, g.nameRange,
             name + " has an invalid position: it must be finite and within 100 km");
        need(g.surface < m_experiment.surfaces.size(), Code::Internal, g.nameRange, name + " has no surface");
        const auto length = [&](double value, const char* what) {
            need(isIn(value, kSmallest, kFarthest), Code::BadGeometry, g.nameRange,
                 std::string(what) + " of " + name + " must be from 1e-6 to 100000 m");
        };
        switch (g.shape) {
        case GeomShape::Box:
            for (int k = 0; k < 3; ++k) length(g.size[k], "Size");
            break;
        case GeomShape::Sphere: length(g.radius, "Radius"); break;
        case GeomShape::Cylinder:
            length(g.radius, "Radius");
            length(g.length, "Length");
            break;
        case GeomShape::Capsule:
            length(g.radius, "Radius");
            length(g.length, "Length");
            break;
        case GeomShape::Plane:
            need(!onBody, Code::WrongPlace, g.nameRange, name + ": a Plane is allowed in a StaticConfig only");
            break;
        case GeomShape::Heightfield:
            need(!onBody, Code::WrongPlace, g.nameRange, name + ": a Heightfield is allowed in a StaticConfig only");
            for (int k = 0; k < 3; ++k) length(g.size[k], "Size");
            if (g.heightMap) heights(g, name);
            break;
        case GeomShape::Convex:
        case GeomShape::Mesh:
            if (g.mesh) mesh(g, name);
            break;
        }
    }

    void heights(const GeomSpec& g, const std::string& name) {
        for (const float h : g.heightMap->heights)
            if (!isIn(static_cast<double>(h), 0, 1))
                return bad(Code::BadGeometry, g.nameRange, "the heights of " + name + " must be from 0 to 1");
    }

    void mesh(const GeomSpec& g, const std::string& name) {
        for (const auto& p : g.mesh->points)
            for (const double x : p)
                if (!(std::abs(x) <= kFarthest))
                    return bad(Code::BadGeometry, g.nameRange, name + " has a point that is not within 100 km");
        for (const auto& t : g.mesh->triangles)
            for (const std::uint32_t i : t)
                if (i >= g.mesh->points.size())
                    return bad(Code::BadGeometry, g.nameRange, name + " has a triangle with a point it does not have");
    }

    void spring(const SpringSpec& s, const RobotConfigSpec& config) {
        const int bodies = static_cast<int>(config.bodies.size());
        need(s.child >= 0 && s.child < bodies && s.parent >= kWorldBody && s.parent < bodies && s.child != s.parent,
             Code::BadJoint, s.nameRange, s.name + " must join two bodies");
        springValues(s);
    }

    /// Of a joint or spring between robots.
    template <class Spec> bool ends(const Link<Spec>& link) {
        const auto known = [&](int robot, int body) {
            const auto& robots = m_experiment.robots;
            return robot >= 0 && static_cast<std::size_t>(robot) < robots.size() &&
                   robots[static_cast<std::size_t>(robot)].config && body >= 0 &&
                   static_cast<std::size_t>(body) < robots[static_cast<std::size_t>(robot)].config->bodies.size();
        };
        const bool parent = link.parentRobot == kWorldBody || known(link.parentRobot, link.spec.parent);
        return need(parent && known(link.childRobot, link.spec.child), Code::BadJoint, link.spec.nameRange,
                    link.spec.name + " joins a body that is not there");
    }

    void springValues(const SpringSpec& s) {
        for (const Vec3& end : {s.anchor, s.anchor2})
            need(end.allFinite() && end.norm() <= kFarthest, Code::BadJoint, s.nameRange,
                 "an end of " + s.name + " is not a valid position");
        for (const auto& [value, what] : {std::pair{s.damping, "Damping"}, {s.stiffness, "Stiffness"}, {s.length, "Length"}})
            need(isIn(value, 0, 1e12), Code::BadJoint, s.nameRange, std::string(what) + " of " + s.name + " must be 0 or more");
    }

    void gear(const GearSpec& g, const RobotConfigSpec& config) {
        const auto known = [&](int joint) { return joint >= 0 && static_cast<std::size_t>(joint) < config.joints.size(); };
        if (!need(known(g.joint) && known(g.other) && g.joint != g.other, Code::BadJoint, g.nameRange,
                  g.name + " must couple two joints"))
            return;
        const JointSpec &joint = config.joints[static_cast<std::size_t>(g.joint)],
                        &other = config.joints[static_cast<std::size_t>(g.other)];
        const auto isFit = [](const JointSpec& j) { return j.type == JointType::Hinge || j.type == JointType::Slider; };
        if (!need(isFit(joint) && isFit(other), Code::BadJoint, g.nameRange,
                  g.name + " must couple a Hinge or a Slider with another"))
            return;
        if (!need(std::isfinite(g.ratio) && std::abs(g.ratio) >= 1e-6, Code::BadJoint, g.nameRange,
                  "Ratio of " + g.name + " must not be 0"))
            return;
        const auto fault = gearFault(joint, other, g.ratio);
        need(!fault, Code::BadJoint, g.nameRange, g.name + ": " + fault.value_or(""));
    }

    void joint(const JointSpec& j, const RobotConfigSpec& config) {
        const int bodies = static_cast<int>(config.bodies.size());
        const bool known = j.child >= 0 && j.child < bodies && j.parent >= kWorldBody && j.parent < bodies;
        if (!need(known, Code::BadJoint, j.nameRange, j.name + " joins a body that is not there")) return;
        need(j.child != j.parent, Code::BadJoint, j.nameRange,
             j.name + " joins " + config.bodies[static_cast<std::size_t>(j.child)].name + " to itself");
        jointValues(j, j.parent == kWorldBody);
    }

    void jointValues(const JointSpec& j, bool isOnWorld) {
        need(j.anchor.allFinite() && j.anchor.norm() <= kFarthest, Code::BadJoint, j.nameRange,
             "Anchor of " + j.name + " is not a valid position");
        need(isUnit(j.axis), Code::BadJoint, j.nameRange, "Axis of " + j.name + " must have a direction");
        const bool two = j.type == JointType::Universal || j.type == JointType::Suspension;
        if (two && need(isUnit(j.axis2), Code::BadJoint, j.nameRange, "Axis2 of " + j.name + " must have a direction")) {
            const double along = std::abs(j.axis.dot(j.axis2));
            if (j.type == JointType::Universal)
                need(along < 1e-6, Code::BadJoint, j.nameRange, "Axis and Axis2 of " + j.name + " must be at right angles");
            else need(along < 0.99, Code::BadJoint, j.nameRange, "Axis and Axis2 of " + j.name + " must not be parallel");
        }
        if (j.type == JointType::Suspension)
            need(!isOnWorld, Code::BadJoint, j.nameRange, j.name + ": a Suspension needs a body as its Parent");
        const double low = j.lowStop.value_or(-1), high = j.highStop.value_or(1);
        need(isIn(low, -1e6, 1e6) && isIn(high, -1e6, 1e6), Code::BadJoint, j.nameRange,
             "the stops of " + j.name + " must be finite");
        if (j.lowStop && j.highStop)
            need(low <= high, Code::BadJoint, j.nameRange, "LowStop of " + j.name + " is above its HighStop");
        for (const auto& [value, what] :
             {std::pair{j.damping, "Damping"}, {j.friction, "Friction"}, {j.stiffness, "Stiffness"}, {j.travel, "Travel"}})
            need(isIn(value, 0, 1e12), Code::BadJoint, j.nameRange, std::string(what) + " of " + j.name + " must be 0 or more");
    }
};

} // namespace

bool isPosition(const Pose& pose) {
    return pose.position.allFinite() && pose.position.norm() <= kFarthest && std::abs(pose.rotation.norm() - 1) < 1e-6;
}

bool isSurface(const SurfaceSpec& s) {
    return isIn(s.friction, 0, 1e6) && isIn(s.friction2.value_or(0), 0, 1e6) && isIn(s.frictionHeading, -1e6, 1e6) &&
           isIn(s.restitution, 0, 1) && isIn(s.rollingFriction, 0, 1e3) && isIn(s.softness, 0, 1e3);
}

bool isBuildable(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    if (!Check(experiment, diagnostics).all()) return false;
    return (experiment.settings.engine != EngineChoice::Wheeled && experiment.settings.engine != EngineChoice::Planar) ||
           fitsWheeled(experiment, diagnostics);
}

} // namespace trundle
