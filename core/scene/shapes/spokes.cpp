// Determines which geoms of a robot are drawn with spokes.

#include "scene/shapes/spokes.h"

#include <algorithm>
#include <numeric>

#include "scene/shapes/extents.h"

namespace trundle {
namespace {

constexpr double kTolerance = 0.02;       // rad, and fraction of a radius; smaller deviations are not visible
constexpr double kLeastShare = 0.5;       // fraction of the largest radius; thinner geoms are nuts or shafts
constexpr double kLeastProtrusion = 1e-5; // m

/// In the config frame C at the start pose.
struct Axis {
    Vec3 p_C, direction;
};

/// A geom that is rotationally symmetric about an axis, between two positions along it (m).
struct RoundGeom {
    std::size_t body;
    std::uint32_t geom;
    double radius, low, high;
    bool flatEnds, plain; ///< a cylinder; no texture
    bool reversed;        ///< its z is antiparallel to the axis
};

/// Distance along an axis and distance from it (m).
std::pair<double, double> alongAndFrom(const Axis& axis, const Vec3& p_C) {
    const Vec3 offset = p_C - axis.p_C;
    const double along = axis.direction.dot(offset);
    return {along, (offset - along * axis.direction).norm()};
}

bool isRoundAbout(const GeomSpec& geom, const Pose& X_CG, const Axis& axis) {
    if (alongAndFrom(axis, X_CG.position).second > kTolerance * geom.radius) return false;
    if (geom.shape == GeomShape::Sphere) return true;
    if (geom.shape != GeomShape::Cylinder && geom.shape != GeomShape::Capsule) return false;
    return (X_CG.rotation * Vec3::UnitZ()).cross(axis.direction).norm() < kTolerance;
}

/// Group number of each body: bodies joined by Fixed joints share one. The last entry is the world's.
std::vector<std::size_t> rigidGroups(const RobotConfigSpec& config) {
    std::vector<std::size_t> group(config.bodies.size() + 1);
    std::iota(group.begin(), group.end(), std::size_t(0));
    for (const JointSpec& joint : config.joints) {
        if (joint.type != JointType::Fixed) continue;
        const std::size_t parent = joint.parent == kWorldBody ? config.bodies.size() : std::size_t(joint.parent);
        const std::size_t from = group[std::size_t(joint.child)], to = group[parent];
        std::replace(group.begin(), group.end(), from, to);
    }
    return group;
}

/// The bodies that rotate together about an axis.
class TurningGroup {
public:
    TurningGroup(const RobotConfigSpec& config, const std::vector<MaterialSpec>& materials, const Axis& axis)
        : m_config(config), m_materials(materials), m_axis(axis) {}

    void add(std::size_t body) {
        const std::vector<GeomSpec>& geoms = m_config.bodies[body].geoms;
        for (std::uint32_t i = 0; i < geoms.size(); ++i) {
            const MaterialSpec* material = geoms[i].material < m_materials.size() ? &m_materials[geoms[i].material] : nullptr;
            if (!geoms[i].visible || (material && !(material->opacity > 0))) continue;
            const Pose X_CG = m_config.bodies[body].pose * geoms[i].pose;
            if (isRoundAbout(geoms[i], X_CG, m_axis)) addRound(body, i, X_CG, !material || !material->picture);
            else m_others.push_back(boundsOf(geoms[i], m_config.bodies[body].pose));
        }
    }

    void addPatterns(std::vector<std::vector<SpokePattern>>& patterns) const {
        if (!std::all_of(m_others.begin(), m_others.end(), [this](const Bounds& box) { return isInside(box); })) return;
        double largest = 0;
        for (const RoundGeom& round : m_round) largest = std::max(largest, round.radius);
        for (const RoundGeom& round : m_round) {
            if (!round.plain || round.radius < kLeastShare * largest) continue;
            const bool high = !isCovered(round, round.high), low = !isCovered(round, round.low);
            const BodySpec& body = m_config.bodies[round.body];
            const Quat turn = (body.pose.rotation * body.geoms[round.geom].pose.rotation).conjugate();
            patterns[round.body].push_back(
                {round.geom, turn * m_axis.direction, round.reversed ? low : high, round.reversed ? high : low});
        }
    }

private:
    void addRound(std::size_t body, std::uint32_t index, const Pose& X_CG, bool plain) {
        const GeomSpec& geom = m_config.bodies[body].geoms[index];
        const double middle = alongAndFrom(m_axis, X_CG.position).first;
        const double half = geom.shape == GeomShape::Sphere ? geom.radius : 0.5 * geom.length;
        const bool reversed = (X_CG.rotation * Vec3::UnitZ()).dot(m_axis.direction) < 0;
        m_round.push_back(
            {body, index, geom.radius, middle - half, middle + half, geom.shape == GeomShape::Cylinder, plain, reversed});
    }
    /// True if a round geom encloses the box on all sides.
    [[nodiscard]] bool isInside(const Bounds& box) const {
        return box.empty() || std::any_of(m_round.begin(), m_round.end(), [&](const RoundGeom& round) {
                   for (int i = 0; round.flatEnds && i < 8; ++i) {
                       const auto [along, from] = alongAndFrom(m_axis, box.corner(i));
                       if (from > round.radius || along < round.low || along > round.high) return false;
                   }
                   return round.flatEnds;
               });
    }
    /// True if another geom protrudes from the end of a cylinder so widely that it would half hide the spokes.
    [[nodiscard]] bool isCovered(const RoundGeom& round, double end) const {
        return std::any_of(m_round.begin(), m_round.end(), [&](const RoundGeom& other) {
            return &other != &round && other.radius >= kLeastShare * round.radius && other.low < end - kLeastProtrusion &&
                   other.high > end + kLeastProtrusion;
        });
    }

    const RobotConfigSpec& m_config;
    const std::vector<MaterialSpec>& m_materials;
    Axis m_axis;
    std::vector<RoundGeom> m_round;
    std::vector<Bounds> m_others; // bounds of geoms that are not round, in C
};

} // namespace

std::vector<std::vector<SpokePattern>> spokePatternsOf(const RobotConfigSpec& config,
                                                       const std::vector<MaterialSpec>& materials) {
    const std::size_t bodies = config.bodies.size();
    std::vector<std::vector<SpokePattern>> patterns(bodies);
    if (bodies == 0) return patterns;
    const std::vector<std::size_t> group = rigidGroups(config);
    const std::size_t world = group[bodies], base = group[0]; // the base does not rotate about its wheels, nor does the world
    std::vector<bool> done(bodies + 1, false);
    const auto groupOf = [&](int body) { return body == kWorldBody ? world : group[std::size_t(body)]; };
    for (const JointSpec& joint : config.joints) {
        if (joint.type != JointType::Hinge && joint.type != JointType::Suspension) continue;
        const Axis axis{joint.anchor, joint.type == JointType::Hinge ? joint.axis : joint.axis2};
        const std::size_t child = groupOf(joint.child), parent = groupOf(joint.parent);
        for (const auto& [turning, other] : {std::pair{child, parent}, std::pair{parent, child}}) {
            if (turning == world || (turning == base && other != world) || done[turning]) continue;
            TurningGroup all(config, materials, axis);
            for (std::size_t body = 0; body < bodies; ++body)
                if (group[body] == turning) all.add(body);
            std::vector<std::vector<SpokePattern>> found(bodies);
            all.addPatterns(found);
            for (std::size_t body = 0; body < bodies; ++body) {
                if (found[body].empty()) continue;
                patterns[body] = std::move(found[body]);
                done[turning] = true;
            }
        }
    }
    return patterns;
}

} // namespace trundle
