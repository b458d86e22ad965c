// Checks for robots that start unsupported. Needs: the contacts at the start. Method: bodies connected by joints form one piece.
// For a piece that touches nothing and has no joint to the world, rays down from its lowest points measure how far it would fall.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "check/checks.h"
#include "check/extent.h"
#include "check/pose_fix.h"
#include "project/edits/plans.h"

namespace trundle {

namespace {

constexpr double kHigh = 0.05;            // m; smaller drops are not reported
constexpr double kHighForMachines = 0.35; // m; articulated robots are often placed above the ground, in the thesis by 0.3 m
constexpr double kHighShare = 0.75;       // the same of the diagonal of the robot: a small one is not
constexpr double kUpright = 0.999;        // cosine of the angle between up and z at which a plane at z = 0 is a floor
constexpr double kFar = 1e4;              // m, range of a ray
constexpr double kLeave = 1e-4;           // m, clearance after a fix
constexpr std::size_t kMaxMeasured = 300; // pieces measured; further ones of the same config are only counted

/// A piece of one robot: bodies joined to each other.
struct Piece {
    std::uint32_t robot = 0;
    std::vector<std::uint32_t> bodies;
};

class SupportCheck {
public:
    SupportCheck(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics)
        : m_loaded(loaded), m_scene(scene), m_experiment(scene.experiment()), m_diagnostics(diagnostics), m_up(scene.up()) {}

    void check(const std::stop_token& stop) {
        if (m_up.isZero()) return;
        if (m_experiment.statics.empty()) return reportNoScenery();
        markTouching();
        for (std::uint32_t r = 0; r < m_experiment.robots.size() && !stop.stop_requested(); ++r)
            for (const Piece& piece : loosePieces(r)) measure(piece);
        for (SupportFinding& f : m_findings) report(f);
    }

private:
    struct SupportFinding {
        Piece piece;
        std::optional<double> height; ///< m; nothing: there is no ground below
        std::string ground;
        std::size_t others = 0;
    };

    /// How high robots of one block in the text start, as the members of a Grid.
    struct Heights {
        std::ptrdiff_t pieces = 0;                 ///< in the air
        double least = HUGE_VAL, most = -HUGE_VAL; ///< m, of those that were measured

        void add(double height) { least = std::min(least, height), most = std::max(most, height); }
    };

    /// Without scenery everything falls that no joint holds: one finding for all robots, at the first.
    void reportNoScenery() {
        const RobotSpec* first = nullptr;
        std::size_t others = 0;
        for (std::uint32_t r = 0; r < m_experiment.robots.size(); ++r) {
            if (loosePieces(r).empty()) continue;
            if (first) ++others;
            else first = &m_experiment.robots[r];
        }
        if (!first) return;
        const std::string who = first->name + (others > 0 ? " and " + std::to_string(others) + " more fall" : " falls");
        Diagnostic& d =
            m_diagnostics.hint(Code::Unsupported, first->nameRange,
                               "the experiment has no scenery: " + who + " without an end; a Static with a Plane is a floor");
        const auto floor = planInsert(m_loaded, {}, "StaticConfig Floor { Plane floor { } }\nStatic floor { Config=Floor }\n");
        if (floor.ok() && floor.value().edits.size() == 1 && m_up.z() > kUpright)
            d.fixes.push_back({"add a floor", floor.value().edits.begin()->second});
    }

    void markTouching() {
        for (std::size_t i = 0; i < m_scene.contactCount(); ++i) {
            const EngineContact c = m_scene.contact(i);
            for (const std::uint32_t geom : {c.first, c.second})
                if (const GeomOwner& o = m_scene.owner(geom); !o.isStatic) m_touching.insert({o.object, o.body});
        }
    }

    /// Pieces that touch nothing and have no joint to the world.
    [[nodiscard]] std::vector<Piece> loosePieces(std::uint32_t r) const {
        const RobotConfigSpec& config = *m_experiment.robots[r].config;
        std::vector<std::uint32_t> piece(config.bodies.size());
        std::iota(piece.begin(), piece.end(), 0u);
        const auto root = [&](std::uint32_t b) {
            while (piece[b] != b) b = piece[b] = piece[piece[b]];
            return b;
        };
        std::vector<bool> held(config.bodies.size());
        for (const JointSpec& j : config.joints) {
            const auto child = static_cast<std::uint32_t>(j.child);
            if (j.parent == kWorldBody) held[child] = true;
            else piece[root(child)] = root(static_cast<std::uint32_t>(j.parent));
        }
        for (const SpringSpec& s : config.springs) {
            const auto child = static_cast<std::uint32_t>(s.child);
            if (s.parent == kWorldBody) held[child] = true;
            else piece[root(child)] = root(static_cast<std::uint32_t>(s.parent));
        }
        std::map<std::uint32_t, Piece> pieces;
        std::set<std::uint32_t> supported;
        for (std::uint32_t b = 0; b < config.bodies.size(); ++b) {
            pieces[root(b)].bodies.push_back(b);
            if (held[b] || m_scene.isJoined(r, b) || m_touching.contains({r, b})) supported.insert(root(b));
        }
        std::vector<Piece> loose;
        for (auto& [at, p] : pieces) {
            p.robot = r;
            const auto isChild = [&](std::uint32_t b) {
                return std::ranges::any_of(config.joints, [&](const JointSpec& j) { return j.child == static_cast<int>(b); });
            };
            const auto top = std::ranges::find_if_not(p.bodies, isChild); // what has to be held names the piece
            if (top != p.bodies.end()) std::iter_swap(p.bodies.begin(), top);
            if (!supported.contains(at)) loose.push_back(std::move(p));
        }
        return loose;
    }

    void measure(const Piece& piece) {
        const RobotSpec& robot = m_experiment.robots[piece.robot];
        Heights& heights = m_heights[robot.nameRange];
        ++heights.pieces;
        const RobotConfigSpec* config = robot.config.get();
        const Block block{config->name, config->bodies[piece.bodies.front()].nameRange};
        const auto known = m_byConfig.find(block);
        if (m_measured >= kMaxMeasured) {
            if (known != m_byConfig.end()) ++m_findings[known->second].others;
            return;
        }
        ++m_measured;
        SupportFinding finding{piece, std::nullopt, {}, 0};
        const double high = piece.bodies.size() > 1 ? highFor(piece) : kHigh;
        if (!fall(finding)) return;
        heights.add(finding.height.value_or(HUGE_VAL));
        if (finding.height && *finding.height <= high) return;
        if (known != m_byConfig.end()) {
            ++m_findings[known->second].others;
            return;
        }
        m_byConfig.emplace(block, m_findings.size());
        m_findings.push_back(std::move(finding));
    }

    /// m, up to which a robot of several bodies may be placed above the ground.
    [[nodiscard]] double highFor(const Piece& piece) const {
        const RobotSpec& robot = m_experiment.robots[piece.robot];
        Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
        for (const std::uint32_t b : piece.bodies)
            for (const GeomSpec& g : robot.config->bodies[b].geoms)
                for (int k = 0; k < 3; ++k) {
                    const Extent e = extentAlong(g, robot.config->bodies[b].pose * g.pose, Vec3::Unit(k));
                    low[k] = std::min(low[k], e.low), high[k] = std::max(high[k], e.high);
                }
        return low.x() > high.x() ? kHigh : std::clamp(kHighShare * (high - low).norm(), kHigh, kHighForMachines);
    }

    /// Measures how far the piece would fall, and onto which geom. False if it has no shape.
    [[nodiscard]] bool fall(SupportFinding& finding) const {
        const RobotSpec& robot = m_experiment.robots[finding.piece.robot];
        bool hasShape = false;
        for (const std::uint32_t b : finding.piece.bodies)
            for (const GeomSpec& g : robot.config->bodies[b].geoms) {
                if (!g.collide) continue;
                hasShape = true;
                for (const Vec3& from : lowestPoints(g, robot.pose * robot.config->bodies[b].pose * g.pose)) {
                    // From a little above: a ray that starts on a face passes it.
                    const auto hit = m_scene.ray(from + kLeave * m_up, -m_up, kFar, finding.piece.robot);
                    if (!hit) continue;
                    const double height = std::max(hit->distance - kLeave, 0.0);
                    if (finding.height && height >= *finding.height) continue;
                    finding.height = height;
                    finding.ground = m_scene.pathOf(hit->geom);
                }
            }
        return hasShape;
    }

    /// Points at the level of a geom's lowest point: one at its centre and four around it.
    [[nodiscard]] std::vector<Vec3> lowestPoints(const GeomSpec& g, const Pose& pose) const {
        const Vec3 side = m_up.unitOrthogonal(), other = m_up.cross(side);
        const Extent height = extentAlong(g, pose, m_up), x = extentAlong(g, pose, side), y = extentAlong(g, pose, other);
        const Vec3 middle = 0.5 * (x.low + x.high) * side + 0.5 * (y.low + y.high) * other + height.low * m_up;
        const Vec3 dx = 0.35 * (x.high - x.low) * side, dy = 0.35 * (y.high - y.low) * other;
        return {middle, middle + dx, middle - dx, middle + dy, middle - dy};
    }

    /// A Grid is moved as a whole: whether all robots of the block are in the air by the same amount.
    [[nodiscard]] bool areAllAsHigh(const RobotSpec& robot) const {
        const Heights& heights = m_heights.at(robot.nameRange);
        const auto all = std::ranges::count(m_experiment.robots, robot.nameRange, &RobotSpec::nameRange);
        return heights.pieces == all && heights.most - heights.least <= kLeave;
    }

    void report(const SupportFinding& f) {
        const RobotSpec& robot = m_experiment.robots[f.piece.robot];
        const bool whole = f.piece.bodies.size() == robot.config->bodies.size();
        const BodySpec& body = robot.config->bodies[f.piece.bodies.front()];
        const std::string who = whole ? robot.name : robot.name + "/" + body.name + ", which no joint holds,";
        const std::string more = f.others > 0 ? " (and " + std::to_string(f.others) + " more like it)" : "";
        if (!f.height) return hasNoSupport(f, who, more);
        Diagnostic& d = m_diagnostics.hint(Code::Unsupported, whole ? robot.nameRange : body.nameRange,
                                           who + " starts " + lengthText(*f.height) + " above " + f.ground +
                                               " and falls onto it; to start there, lower it" + more);
        if (!whole) d.notes.push_back({"of this robot", robot.nameRange});
        if (!whole || !areAllAsHigh(robot)) return;
        if (auto fix = moveFix(m_loaded, robot, -(*f.height - kLeave) * m_up)) d.fixes.push_back(std::move(*fix));
    }

    /// Reports a piece without ground below: it is either below the scenery or beside it.
    void hasNoSupport(const SupportFinding& f, const std::string& who, const std::string& more) {
        const RobotSpec& robot = m_experiment.robots[f.piece.robot];
        const Vec3 at = robot.pose.position;
        const auto roof = m_scene.ray(at, m_up, kFar, f.piece.robot);
        if (!roof) {
            m_diagnostics.hint(Code::Unsupported, robot.nameRange,
                               "nothing is beneath " + who +
                                   " at the start: it falls without an end; a Static with a Plane is a floor" + more);
            return;
        }
        Diagnostic& d =
            m_diagnostics.warning(Code::BelowFloor, robot.nameRange,
                                  who + " starts " + lengthText(roof->distance) + " below " + m_scene.pathOf(roof->geom) +
                                      ", with nothing beneath: it falls without an end" + more);
        const auto top = m_scene.ray(at + kFar * m_up, -m_up, 2 * kFar, f.piece.robot);
        if (!top) return;
        const double level = (at + (kFar - top->distance) * m_up).dot(m_up);
        if (auto fix = moveFix(m_loaded, robot, (level - extentAlong(*robot.config, robot.pose, m_up).low + kLeave) * m_up))
            d.fixes.push_back(std::move(*fix));
    }

    const LoadedProject& m_loaded;
    const StartScene& m_scene;
    const ExperimentSpec& m_experiment;
    Diagnostics& m_diagnostics;
    Vec3 m_up;
    std::set<std::pair<std::uint32_t, std::uint32_t>> m_touching; ///< (robot, body)
    std::vector<SupportFinding> m_findings;
    using Block = std::pair<std::string, SourceRange>; ///< a config and the place of the block of the piece's first body
    std::map<Block, std::size_t> m_byConfig;
    std::map<SourceRange, Heights> m_heights; ///< by the name of the block of the robots
    std::size_t m_measured = 0;
};

} // namespace

void checkSupport(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics, const std::stop_token& stop) {
    SupportCheck(loaded, scene, diagnostics).check(stop);
}

} // namespace trundle
