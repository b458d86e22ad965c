#pragma once
// The level ground of the wheeled engine, and what may be above it in the scenery.

#include <optional>
#include <string>
#include <vector>

#include "base/source_range.h"
#include "world/wheeled/planar_shape.h"

namespace trundle {

inline constexpr double kLevelAxis = 1e-6; ///< sine of the angle that still counts as level
inline constexpr double kOnGround = 0.005; ///< m: the farthest from the ground that still counts as on it
inline constexpr double kTouching = 1e-4;  ///< m
inline constexpr double kBridged = 1e-3;   ///< m: what a wheel or ball may be beyond an edge; it hardly sinks there

/// The level ground that carries everything: planes and boxes with their tops at one height.
struct LevelGround {
    struct Slab {
        std::uint32_t geom = 0, surface = 0;
        PlanarPose pose;
        Vec2 half = Vec2::Zero(); ///< 0: endless
    };
    double height = 0; ///< m
    std::vector<Slab> slabs;

    [[nodiscard]] std::uint32_t geom() const { return slabs[0].geom; }
    [[nodiscard]] std::uint32_t surface() const { return slabs[0].surface; }
    [[nodiscard]] bool isEndless() const;
    /// Whether a point is over a slab, by that much inside its edge; less than 0: or that much beyond it.
    [[nodiscard]] bool isBelow(const Vec2& point, double inside = 0) const;
};

/// Why something cannot be in this engine.
struct NotWheeled {
    std::string reason; ///< names the part, without the actor
    SourceRange range;  ///< of the part in the text
};

/// Finds the ground among an experiment's scenery.
class GroundSearch {
public:
    void add(std::uint32_t geom, const GeomSpec& spec, const Pose& pose);
    /// The highest below a place that can carry an actor whose lowest point is at `bottom`; empty where nothing can.
    [[nodiscard]] std::optional<LevelGround> under(double bottom, const Vec2& place) const;
    /// That at this height.
    [[nodiscard]] std::optional<LevelGround> at(double height) const;

private:
    std::vector<LevelGround> m_levels; ///< by height, from above
};

/// What moves over the ground, as far as that decides what it may meet.
struct Movers {
    double wheel = 0;    ///< radius of the largest wheel or caster, m
    double top = -1e300; ///< the highest point of all at the start, m
};

/// "wheel left is ..."
[[nodiscard]] std::string named(const char* kind, const std::string& name, const char* reason);

[[nodiscard]] bool isUpright(const Mat3& axes);

/// Of scenery at a pose, above that ground; nothing for what is the ground or below it, or above all that moves.
[[nodiscard]] std::optional<NotWheeled> whyNotScenery(const GeomSpec& geom, const Pose& pose, const LevelGround& ground,
                                                      const Movers& movers);

} // namespace trundle
