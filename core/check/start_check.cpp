// Checks for robots that start inside something else or below a floor. Needs: the contacts at the start. Method: all contacts
// between one pair of objects are one finding; pairs of the same two configs are reported once, with their number. The fix for a
// robot is the shortest move that ends its contacts with the scenery, or with the one other robot.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/checks.h"
#include "check/drive_wheels.h"
#include "check/extent.h"
#include "check/free_place.h"
#include "check/inside_mesh.h"
#include "check/pose_fix.h"

namespace trundle {

namespace {

constexpr double kLeastDepth = 1e-3;              // m
constexpr double kLeastShare = 0.02;              // of the smaller object's width
constexpr double kStraightUp = 0.9999;            // cosine
constexpr double kMargin = 1e-4;                  // m, clearance after a fix
constexpr double kLevel = 0.7;                    // cosine of the steepest slope that counts as ground
constexpr int kRounds = 60;                       // iterations of the search for a move out of several contacts
constexpr std::size_t kMaxTriangles = 50'000'000; // limit on triangles tested for robots inside meshes

/// A robot and what it overlaps: another robot or a Static.
struct Pair {
    std::uint32_t robot = 0, other = 0;
    bool withStatic = false;
    EngineContact deepest;
    std::vector<std::pair<Vec3, double>> ways;                  ///< per contact: direction out of it and depth, m
    std::vector<std::pair<std::uint32_t, std::uint32_t>> geoms; ///< per contact: the robot's geom and the other one
};

struct Group {
    const Pair* first = nullptr;
    std::size_t count = 0;
};

class StartCheck {
public:
    StartCheck(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics)
        : m_loaded(loaded), m_scene(scene), m_experiment(scene.experiment()), m_diagnostics(diagnostics) {}

    void check() {
        collect();
        std::map<std::pair<std::string, std::string>, Group> groups;
        for (const Pair& pair : m_pairs) {
            Group& group = groups[{kindOf(pair.robot),
                                   pair.withStatic ? "static " + m_experiment.statics[pair.other].name : kindOf(pair.other)}];
            if (group.count++ == 0) group.first = &pair;
        }
        for (const auto& [kinds, group] : groups) report(*group.first, group.count - 1);
    }

private:
    [[nodiscard]] std::string kindOf(std::uint32_t robot) const { return m_experiment.robots[robot].config->name; }

    [[nodiscard]] static double leastDepth(const GeomSpec& a, const GeomSpec& b) {
        return std::max(kLeastDepth, kLeastShare * std::min(smallestWidth(a), smallestWidth(b)));
    }

    void collect() {
        for (std::size_t i = 0; i < m_scene.contactCount(); ++i) {
            const EngineContact c = m_scene.contact(i);
            const GeomOwner &a = m_scene.owner(c.first), &b = m_scene.owner(c.second);
            if (c.depth <= leastDepth(*a.spec, *b.spec)) {
                m_touches[a.object].push_back(c.normal);
                if (!b.isStatic) m_touches[b.object].push_back(-c.normal);
                continue;
            }
            // The object that is later in the text is the one to be moved.
            const bool swapped = !b.isStatic && b.object > a.object;
            const GeomOwner &mover = swapped ? b : a, &other = swapped ? a : b;
            if (m_pairs.empty() || m_pairs.back().robot != mover.object || m_pairs.back().withStatic != other.isStatic ||
                m_pairs.back().other != other.object)
                m_pairs.push_back({mover.object, other.object, other.isStatic, c, {}, {}});
            Pair& pair = m_pairs.back();
            if (c.depth > pair.deepest.depth) pair.deepest = c;
            pair.ways.emplace_back(swapped ? Vec3(-c.normal) : c.normal, c.depth);
            pair.geoms.emplace_back(swapped ? c.second : c.first, swapped ? c.first : c.second);
        }
        for (Pair& pair : m_pairs) moveOutSideways(pair);
        addEnclosed();
    }

    /// Adds objects that are wholly inside a mesh: they touch none of its triangles, so the engine reports no contact.
    void addEnclosed() {
        std::size_t left = kMaxTriangles;
        for (std::uint32_t m = 0; m < m_scene.geomCount(); ++m) {
            const GeomOwner& mesh = m_scene.owner(m);
            if (!mesh.spec || !mesh.isStatic || mesh.spec->shape != GeomShape::Mesh || !mesh.spec->mesh) continue;
            const Pose X_WM = poseOf(m);
            const std::array<Extent, 3> bounds{extentAlong(*mesh.spec, {}, Vec3::UnitX()),
                                               extentAlong(*mesh.spec, {}, Vec3::UnitY()),
                                               extentAlong(*mesh.spec, {}, Vec3::UnitZ())};
            for (std::uint32_t g = 0; g < m_scene.geomCount(); ++g) {
                const GeomOwner& own = m_scene.owner(g);
                if (!own.spec || own.isStatic) continue;
                const Vec3 p_M = X_WM.rotation.conjugate() * (pointOf(g) - X_WM.position);
                const bool near = p_M.x() > bounds[0].low && p_M.x() < bounds[0].high && p_M.y() > bounds[1].low &&
                                  p_M.y() < bounds[1].high && p_M.z() > bounds[2].low && p_M.z() < bounds[2].high;
                if (!near || isPaired(own.object, mesh.object)) continue;
                if (mesh.spec->mesh->triangles.size() > left) return;
                left -= mesh.spec->mesh->triangles.size();
                if (isInside(*mesh.spec->mesh, p_M)) addEnclosed(g, m, X_WM);
            }
        }
    }

    void addEnclosed(std::uint32_t own, std::uint32_t mesh, const Pose& X_WM) {
        std::pair<Vec3, double> best{Vec3::Zero(), HUGE_VAL};
        for (int k = 0; k < 6; ++k) {
            const Vec3 side = X_WM.rotation * Vec3::Unit(k / 2) * (k % 2 == 0 ? 1.0 : -1.0);
            if (side.dot(m_scene.up()) < -kLevel) continue; // no fix may move a robot down through the floor
            const double missing = extentAlong(*m_scene.owner(mesh).spec, X_WM, side).high -
                                   extentAlong(*m_scene.owner(own).spec, poseOf(own), side).low;
            if (missing < best.second) best = {side, missing};
        }
        EngineContact contact;
        contact.first = own;
        contact.second = mesh;
        contact.normal = best.first;
        contact.depth = best.second;
        m_pairs.push_back({m_scene.owner(own).object, m_scene.owner(mesh).object, true, contact, {best}, {{own, mesh}}});
    }

    [[nodiscard]] bool isPaired(std::uint32_t robot, std::uint32_t other) const {
        return std::ranges::any_of(m_pairs, [&](const Pair& p) { return p.withStatic && p.robot == robot && p.other == other; });
    }

    /// A point of a geom's surface or its origin, in the world frame.
    [[nodiscard]] Vec3 pointOf(std::uint32_t geom) const {
        const GeomSpec& spec = *m_scene.owner(geom).spec;
        const auto& mesh = spec.hull ? spec.hull : spec.mesh;
        if (!mesh || mesh->points.empty()) return poseOf(geom).position;
        const auto& p = mesh->points.front();
        return poseOf(geom) * Vec3(p[0], p[1], p[2]);
    }

    [[nodiscard]] Pose poseOf(std::uint32_t geom) const {
        const GeomOwner& o = m_scene.owner(geom);
        if (o.isStatic) return m_experiment.statics[o.object].pose * o.spec->pose;
        const RobotSpec& robot = m_experiment.robots[o.object];
        return robot.pose * robot.config->bodies[o.body].pose * o.spec->pose;
    }

    /// If the shortest way out of a wall is downwards, through the floor, moves the whole robot out to the nearest side instead.
    void moveOutSideways(Pair& pair) const {
        const Vec3 up = m_scene.up();
        const bool down = std::ranges::any_of(pair.ways, [&](const auto& way) { return way.first.dot(up) < -kLevel; });
        const GeomShape shape = m_scene.owner(pair.geoms[0].second).spec->shape;
        if (!down || !pair.withStatic || shape == GeomShape::Plane || shape == GeomShape::Heightfield) return;
        std::pair<Vec3, double> best{Vec3::Zero(), HUGE_VAL};
        for (int k = 0; k < 6; ++k) {
            Vec3 side = poseOf(pair.geoms[0].second).rotation * Vec3::Unit(k / 2) * (k % 2 == 0 ? 1.0 : -1.0);
            side -= side.dot(up) * up;
            if (side.norm() < 1e-3) continue;
            side.normalize();
            double missing = 0;
            for (const auto& [own, other] : pair.geoms)
                missing = std::max(missing, extentAlong(*m_scene.owner(other).spec, poseOf(other), side).high -
                                                extentAlong(*m_scene.owner(own).spec, poseOf(own), side).low);
            if (missing < best.second) best = {side, missing};
        }
        pair.ways = {best};
    }

    void report(const Pair& pair, std::size_t others) {
        const RobotSpec& robot = m_experiment.robots[pair.robot];
        const bool swapped = m_scene.owner(pair.deepest.first).object != pair.robot || m_scene.owner(pair.deepest.first).isStatic;
        const std::uint32_t own = swapped ? pair.deepest.second : pair.deepest.first;
        const std::string partner = m_scene.pathOf(swapped ? pair.deepest.first : pair.deepest.second);
        const Vec3 out = swapped ? Vec3(-pair.deepest.normal) : pair.deepest.normal;
        const bool below = pair.withStatic && out.dot(m_scene.up()) > kLevel && isBeyond(own, out, pair.deepest.depth);
        std::string message = robot.name + (below ? " starts below " : " starts inside ") + partner + ": its geom " +
                              m_scene.pathOf(own) + " is " + lengthText(pair.deepest.depth) +
                              " deep in it, and would be thrown out";
        const double lower = pair.withStatic && out.dot(m_scene.up()) > kLevel ? belowWheels(own) : 0;
        if (lower > 0) message += "; it reaches " + lengthText(lower) + " lower than the wheels";
        if (others > 0) message += " (and " + std::to_string(others) + " more like it)";
        Diagnostic& d = m_diagnostics.warning(below ? Code::BelowFloor : Code::StartOverlap, robot.nameRange, std::move(message));
        const RobotSpec* second = pair.withStatic || pair.other == pair.robot ? nullptr : &m_experiment.robots[pair.other];
        if (second) d.notes.push_back({"what it starts in", second->nameRange});
        else if (pair.withStatic) d.notes.push_back({"what it starts in", m_experiment.statics[pair.other].nameRange});
        if (pair.other == pair.robot && !pair.withStatic) return; // contacts among its own bodies: moving the robot does not help
        if (robot.scenery) return;                                // moving all of it would not part it from itself
        if (lower > 0) return;                                    // moved up, its wheels would be in the air
        const std::optional<Vec3> move = second ? moveBesideOther(pair) : std::optional(moveOutOf(pair));
        if (!move) return;
        if (auto fix = moveFix(m_loaded, robot, *move)) d.fixes.push_back(std::move(*fix));
    }

    /// From another robot. Nothing if there is no free place, or the robot has to be moved out of scenery first.
    [[nodiscard]] std::optional<Vec3> moveBesideOther(const Pair& pair) const {
        const auto isInScenery = [&](const Pair& p) { return p.withStatic && p.robot == pair.robot; };
        return std::ranges::any_of(m_pairs, isInScenery) ? std::nullopt : moveBeside(m_scene, pair.robot, pair.other);
    }

    /// m, by which a geom is lower than all other wheels of an upright robot.
    [[nodiscard]] double belowWheels(std::uint32_t geom) const {
        const GeomOwner& o = m_scene.owner(geom);
        const RobotConfigSpec& config = *m_experiment.robots[o.object].config;
        if ((m_experiment.robots[o.object].pose.rotation * Vec3::UnitZ()).dot(m_scene.up()) < kStraightUp) return 0;
        double lowest = HUGE_VAL;
        for (const DriveWheel& wheel : drivenWheelsOf(config)) {
            if (wheel.geom == o.spec) continue;
            const Pose pose = m_experiment.robots[o.object].pose * config.bodies[wheel.body].pose * wheel.geom->pose;
            lowest = std::min(lowest, extentAlong(*wheel.geom, pose, m_scene.up()).low);
        }
        const double lower = lowest - extentAlong(*o.spec, poseOf(geom), m_scene.up()).low;
        return std::isfinite(lower) && lower > kLeastDepth ? lower : 0;
    }

    /// Whether a geom is wholly behind the surface that it is `depth` deep in.
    [[nodiscard]] bool isBeyond(std::uint32_t geom, const Vec3& out, double depth) const {
        const GeomOwner& o = m_scene.owner(geom);
        const Extent e = extentAlong(*o.spec, poseOf(geom), out);
        return depth >= (e.high - e.low) * (1 - 1e-9);
    }

    /// The move (m, world frame) that frees a robot from everything it overlaps: the scenery, or the other robot of the pair.
    [[nodiscard]] Vec3 moveOutOf(const Pair& pair) const {
        Vec3 way = Vec3::Zero();
        const auto touches = m_touches.find(pair.robot);
        for (int round = 0; round < kRounds; ++round) {
            if (touches != m_touches.end()) // do not move into objects that it only touches
                for (const Vec3& direction : touches->second) way += std::max(0.0, -direction.dot(way)) * direction;
            for (const Pair& p : m_pairs) {
                if (p.robot != pair.robot || (!p.withStatic && p.other != pair.other)) continue;
                for (const auto& [direction, depth] : p.ways) {
                    const double missing = depth + kMargin - direction.dot(way);
                    if (missing > 1e-12) way += missing * direction;
                }
            }
        }
        for (int k = 0; k < 3; ++k)
            if (std::abs(way[k]) < 1e-7) way[k] = 0;
        return way;
    }

    const LoadedProject& m_loaded;
    const StartScene& m_scene;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    std::vector<Pair> m_pairs;
    std::map<std::uint32_t, std::vector<Vec3>> m_touches; ///< by robot: directions away from objects that it only touches
};

} // namespace

void checkStart(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics) {
    StartCheck(loaded, scene, diagnostics).check();
}

} // namespace trundle
