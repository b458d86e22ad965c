// Method: rejection. The numbers of an attempt depend on the Seed, the Scatter's name, the member and the attempt alone.
#include "model/resolve/scatter_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/rng.h"
#include "model/kinds/world_fields.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMaxTries = 10000;

/// Points in square cells whose side is the minimum distance, so that all near points are in nine cells.
class PointGrid {
public:
    explicit PointGrid(double distance) : m_distance(distance) {}

    bool roomAt(double x, double y) const {
        if (!(m_distance > 0)) return true;
        for (long dx = -1; dx <= 1; ++dx) {
            for (long dy = -1; dy <= 1; ++dy) {
                const auto it = m_cells.find({cell(x) + dx, cell(y) + dy});
                if (it == m_cells.end()) continue;
                for (const auto& [px, py] : it->second) {
                    if (std::hypot(px - x, py - y) < m_distance) return false;
                }
            }
        }
        return true;
    }
    void add(double x, double y) {
        if (m_distance > 0) m_cells[{cell(x), cell(y)}].emplace_back(x, y);
    }

private:
    long cell(double v) const { return static_cast<long>(std::floor(std::clamp(v / m_distance, -1e15, 1e15))); }
    double m_distance;
    std::map<std::pair<long, long>, std::vector<std::pair<double, double>>> m_cells;
};

void set(std::vector<bool>& flags, std::size_t index, bool value) {
    if (flags.size() <= index) flags.resize(index + 1);
    flags[index] = value;
}

bool isSet(const std::vector<bool>& flags, std::size_t index) { return index < flags.size() && flags[index]; }

template <class Spec> void removeSet(std::vector<Spec>& all, const std::vector<bool>& flags) {
    std::size_t index = 0;
    std::erase_if(all, [&](const Spec&) { return isSet(flags, index++); });
}

/// Whether nothing of a robot is in the ground area.
bool isOutside(const RobotSpec& robot, const RobotDisc& disc, const Eigen::AlignedBox2d& area) {
    const double reach = std::hypot(disc.radius, std::max(std::abs(disc.low), std::abs(disc.high))); // however it is turned
    return area.exteriorDistance(Eigen::Vector2d(robot.pose.position.head<2>())) > reach;
}

} // namespace

void ScatterPlaces::add(const ExpandedPart& scatter, const Record& record, const RobotDisc& disc) {
    m_scatters.insert_or_assign(&scatter, Scatter{record, disc, {}});
}

void ScatterPlaces::addStatic(const ExpandedPart& part, std::size_t member, bool moves) {
    const auto scatter = m_scatters.find(&part);
    if (scatter == m_scatters.end()) return;
    Member& added = scatter->second.members.emplace_back(Member{member, m_context.out.statics.size() - 1, {}, {}});
    set(m_stillWaits, *added.still, true);
    if (!moves) return;
    added.moving = m_moving.size() - 1;
    set(m_movingWaits, *added.moving, true);
}

void ScatterPlaces::addRobot(const ExpandedPart& part, std::size_t member) {
    const auto scatter = m_scatters.find(&part);
    if (scatter == m_scatters.end()) return;
    scatter->second.members.push_back({member, {}, {}, m_context.out.robots.size() - 1});
    set(m_robotWaits, m_context.out.robots.size() - 1, true);
}

void ScatterPlaces::place(const ExpandedPart& part) {
    const auto scatter = m_scatters.find(&part);
    if (scatter == m_scatters.end()) return;
    const std::vector<Pose> found = poses(part, scatter->second);
    if (found.empty()) m_context.failedRobots.insert(part.part);
    for (const Member& member : scatter->second.members) {
        if (member.number >= found.size()) continue;
        const Pose pose = part.placed(found[member.number]);
        const auto put = [&](auto& all, std::vector<bool>& waits, const std::optional<std::size_t>& index) {
            if (!index) return;
            all[*index].pose = pose;
            waits[*index] = false;
        };
        put(m_context.out.statics, m_stillWaits, member.still);
        put(m_moving, m_movingWaits, member.moving);
        put(m_context.out.robots, m_robotWaits, member.robot);
    }
}

void ScatterPlaces::removeLeftOut() {
    removeSet(m_context.out.statics, m_stillWaits);
    removeSet(m_moving, m_movingWaits);
    removeSet(m_context.out.robots, m_robotWaits);
}

/// Of everything that has its pose, near the area; `area` is relative to `origin`.
ObstacleGrid ScatterPlaces::obstacles(const ExpandedPart& part, const Pose& origin, const std::array<double, 4>& area,
                                      double radius) const {
    Eigen::AlignedBox2d ground;
    for (const double x : {area[0], area[2]})
        for (const double y : {area[1], area[3]})
            ground.extend(Eigen::Vector2d(part.placed({origin * Vec3(x, y, 0), Quat::Identity()}).position.head<2>()));
    ObstacleGrid all(ground, radius);
    for (std::size_t i = 0; i < m_context.out.statics.size(); ++i)
        if (!isSet(m_stillWaits, i)) all.add(*m_context.out.statics[i].geoms, m_context.out.statics[i].pose);
    const Eigen::AlignedBox2d reach(ground.min().array() - radius, ground.max().array() + radius);
    std::map<const RobotConfigSpec*, RobotDisc> discs;
    const auto addBodies = [&](const RobotSpec& robot) {
        const auto [disc, isNew] = discs.try_emplace(robot.config.get());
        if (isNew) disc->second = discOf(*robot.config);
        if (isOutside(robot, disc->second, reach)) return;
        for (const BodySpec& body : robot.config->bodies) all.add(body.geoms, robot.pose * body.pose);
    };
    for (std::size_t i = 0; i < m_moving.size(); ++i)
        if (!isSet(m_movingWaits, i)) addBodies(m_moving[i]);
    for (std::size_t i = 0; i < m_context.out.robots.size(); ++i)
        if (!isSet(m_robotWaits, i)) addBodies(m_context.out.robots[i]);
    return all;
}

/// In the world or in the member of a Repeat that it is in. Empty, with a diagnostic (E317), on failure.
std::vector<Pose> ScatterPlaces::poses(const ExpandedPart& part, const Scatter& scatter) const {
    const ScatterFields f = fieldsFrom<ScatterFields>(scatter.record);
    if (!(f.area[0] < f.area[2]) || !(f.area[1] < f.area[3])) {
        m_context.diagnostics.error(Code::OutOfRange, scatter.record.rangeOf("Area", part.part->nameRange()),
                                    "Area is x0, y0, x1, y1: x1 must be above x0 and y1 above y0");
        return {};
    }
    const Pose origin = poseOf(f.pos, f.hpr);
    const RobotDisc& disc = scatter.disc;
    const ObstacleGrid taken = obstacles(part, origin, f.area, disc.radius);
    const std::uint64_t seed = f.seed > 0 ? static_cast<std::uint64_t>(f.seed) : m_context.out.settings.seed;
    const std::uint64_t path = fnv1a64(part.name());
    const auto members = static_cast<std::uint64_t>(f.count);
    PointGrid spread(f.minDistance.value_or(2 * disc.radius));
    std::vector<Pose> poses;
    for (std::uint64_t member = 0; member < members; ++member) {
        bool found = false;
        for (std::uint64_t attempt = 0; attempt < kMaxTries && !found; ++attempt) {
            const auto unit = [&](std::uint64_t k) { return toUnit(randomBits(seed, path, member, attempt * 3 + k)); };
            const Vec3 local(f.area[0] + unit(0) * (f.area[2] - f.area[0]), f.area[1] + unit(1) * (f.area[3] - f.area[1]), 0);
            if (!spread.roomAt(local.x(), local.y())) continue;
            const Vec3 place = origin * local, at = part.placed({place, Quat::Identity()}).position;
            if (taken.meets({at.x(), at.y()}, at.z() + disc.low, at.z() + disc.high)) continue;
            found = true;
            spread.add(local.x(), local.y());
            const double heading = f.heading.value_or((unit(2) * 2 - 1) * std::numbers::pi);
            poses.push_back({place, (origin.rotation * rotationFromHpr({heading, 0, 0})).normalized()});
        }
        if (found) continue;
        m_context.diagnostics.error(Code::PlacementFailed, part.part->nameRange(),
                                    "no free place for member " + std::to_string(member) + " of " + part.part->title() +
                                        " after 10000 tries; make Area larger, or Count or MinDistance smaller");
        return {};
    }
    return poses;
}

} // namespace trundle
