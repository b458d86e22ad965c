// Computes the poses of the members of Grid and Scatter.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/rng.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/footprint.h"
#include "model/resolve/resolve_steps.h"
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

} // namespace

std::vector<Pose> gridPoses(ResolveContext& context, const Part& part, const Record& record) {
    const GridFields f = fieldsFrom<GridFields>(record);
    const Pose pattern = poseOf(f.pos, f.hpr);
    const auto nx = static_cast<std::size_t>(f.count[0]),
               ny = f.count.size() > 1 ? static_cast<std::size_t>(f.count[1]) : std::size_t{1};
    const double sx = f.spacing[0], sy = f.spacing.size() > 1 ? f.spacing[1] : sx;
    if ((nx > 1 && sx == 0) || (ny > 1 && sy == 0)) {
        const bool all = (nx == 1 || sx == 0) && (ny == 1 || sy == 0);
        context.diagnostics.warning(Code::OutOfRange, record.rangeOf("Spacing", part.nameRange()),
                                    (all ? "all members of " : "members of ") + part.title() + " are in one place: Spacing is 0");
    }
    std::vector<Pose> poses;
    poses.reserve(nx * ny);
    for (std::size_t iy = 0; iy < ny; ++iy) {
        for (std::size_t ix = 0; ix < nx; ++ix) {
            const Vec3 at((static_cast<double>(ix) - static_cast<double>(nx - 1) / 2) * sx,
                          (static_cast<double>(iy) - static_cast<double>(ny - 1) / 2) * sy, 0);
            poses.push_back({pattern * at, pattern.rotation});
        }
    }
    return poses;
}

std::vector<Pose> scatterPoses(ResolveContext& context, const ExpandedPart& expanded, const Record& record, const RobotDisc& disc,
                               const std::vector<RobotSpec>& moving) {
    const Part& part = *expanded.part;
    const ScatterFields f = fieldsFrom<ScatterFields>(record);
    if (!(f.area[0] < f.area[2]) || !(f.area[1] < f.area[3])) {
        context.diagnostics.error(Code::OutOfRange, record.rangeOf("Area", part.nameRange()),
                                  "Area is x0, y0, x1, y1: x1 must be above x0 and y1 above y0");
        return {};
    }
    const Pose origin = poseOf(f.pos, f.hpr);
    std::vector<Footprint> obstacles;
    const auto addObstacles = [&](const std::vector<GeomSpec>& geoms, const Pose& pose) {
        for (const GeomSpec& geom : geoms)
            for (Footprint& footprint : footprintsOf(geom, pose)) obstacles.push_back(std::move(footprint));
    };
    for (const StaticSpec& s : context.out.statics) addObstacles(*s.geoms, s.pose);
    for (const RobotSpec& robot : moving)
        for (const BodySpec& body : robot.config->bodies) addObstacles(body.geoms, robot.pose * body.pose);
    const std::uint64_t seed = f.seed > 0 ? static_cast<std::uint64_t>(f.seed) : context.out.settings.seed;
    const std::uint64_t path = fnv1a64(expanded.name());
    const auto members = static_cast<std::uint64_t>(f.count);
    PointGrid spread(f.minDistance.value_or(2 * disc.radius));
    std::vector<Pose> poses;
    for (std::uint64_t member = 0; member < members; ++member) {
        bool found = false;
        for (std::uint64_t attempt = 0; attempt < kMaxTries && !found; ++attempt) {
            const auto unit = [&](std::uint64_t k) { return toUnit(randomBits(seed, path, member, attempt * 3 + k)); };
            const Vec3 local(f.area[0] + unit(0) * (f.area[2] - f.area[0]), f.area[1] + unit(1) * (f.area[3] - f.area[1]), 0);
            if (!spread.roomAt(local.x(), local.y())) continue;
            const Vec3 place = origin * local, at = expanded.placed({place, Quat::Identity()}).position;
            const bool clear = std::none_of(obstacles.begin(), obstacles.end(), [&](const Footprint& o) {
                return o.meets({at.x(), at.y()}, disc.radius, at.z() + disc.low, at.z() + disc.high);
            });
            if (!clear) continue;
            found = true;
            spread.add(local.x(), local.y());
            const double heading = f.heading.value_or((unit(2) * 2 - 1) * std::numbers::pi);
            poses.push_back({place, (origin.rotation * rotationFromHpr({heading, 0, 0})).normalized()});
        }
        if (found) continue;
        context.diagnostics.error(Code::PlacementFailed, part.nameRange(),
                                  "no free place for member " + std::to_string(member) + " of " + part.title() +
                                      " after 10000 tries; make Area larger, or Count or MinDistance smaller");
        return {};
    }
    return poses;
}

} // namespace trundle
