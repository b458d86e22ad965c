#include "check/free_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "check/extent.h"

namespace trundle {

namespace {

constexpr double kMargin = 1e-4, kInFloor = 2e-3; // m

/// Along two level directions and up.
struct Bounds {
    Vec3 low = Vec3::Constant(HUGE_VAL), high = Vec3::Constant(-HUGE_VAL);
};

class Places {
public:
    explicit Places(const StartScene& scene) : m_experiment(scene.experiment()) {
        if (!scene.up().isZero()) m_axes[2] = scene.up();
        m_axes[0] =
            std::abs(m_axes[2].z()) > 0.9 ? Vec3(Vec3::UnitY().cross(m_axes[2]).normalized()) : m_axes[2].unitOrthogonal();
        m_axes[1] = m_axes[2].cross(m_axes[0]);
    }

    [[nodiscard]] std::optional<Vec3> beside(std::size_t robot, std::size_t other) const {
        const Bounds own = boundsOf(robot), away = boundsOf(other);
        std::vector<Vec3> moves; // along the axes
        for (int k = 0; k < 2; ++k)
            for (const double way : {away.high[k] - own.low[k] + kMargin, away.low[k] - own.high[k] - kMargin})
                moves.push_back(way * Vec3::Unit(k));
        std::ranges::sort(moves, {}, [](const Vec3& move) { return move.norm(); });
        if (own.low.z() > (away.low.z() + away.high.z()) / 2)
            moves.insert(moves.begin(), (away.high.z() - own.low.z() + kMargin) * Vec3::UnitZ()); // it is on it
        for (const Vec3& move : moves)
            if (isFree({own.low + move, own.high + move}, robot))
                return move.x() * m_axes[0] + move.y() * m_axes[1] + move.z() * m_axes[2];
        return std::nullopt;
    }

private:
    void include(Bounds& bounds, const GeomSpec& geom, const Pose& pose) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Extent e = extentAlong(geom, pose, m_axes[k]);
            const auto i = static_cast<Eigen::Index>(k);
            bounds.low[i] = std::min(bounds.low[i], e.low), bounds.high[i] = std::max(bounds.high[i], e.high);
        }
    }
    [[nodiscard]] Bounds boundsOf(std::size_t robot) const {
        Bounds bounds;
        const RobotSpec& spec = m_experiment.robots[robot];
        for (const BodySpec& body : spec.config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (geom.collide) include(bounds, geom, spec.pose * body.pose * geom.pose);
        return bounds;
    }
    static bool meet(const Bounds& a, const Bounds& b) {
        return (a.low.array() < b.high.array()).all() && (b.low.array() < a.high.array()).all();
    }
    [[nodiscard]] bool isFree(const Bounds& at, std::size_t robot) const {
        for (std::size_t i = 0; i < m_experiment.robots.size(); ++i)
            if (i != robot && meet(at, boundsOf(i))) return false;
        for (const StaticSpec& object : m_experiment.statics)
            for (std::size_t g = 0; object.geoms && g < object.geoms->size(); ++g) {
                const GeomSpec& geom = (*object.geoms)[g];
                if (!geom.collide || geom.shape == GeomShape::Plane || geom.shape == GeomShape::Heightfield) continue;
                Bounds bounds;
                include(bounds, geom, object.pose * geom.pose);
                bounds.high.z() -= kInFloor; // what it is on is not in its way
                if (meet(at, bounds)) return false;
            }
        return true;
    }

    const ExperimentSpec& m_experiment;
    std::array<Vec3, 3> m_axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
};

} // namespace

std::optional<Vec3> moveBeside(const StartScene& scene, std::size_t robot, std::size_t other) {
    return Places(scene).beside(robot, other);
}

} // namespace trundle
