#pragma once
// Which units touch each other and the scenery, over x and y; found anew in every tick.
//
// Method: candidates from grids of bounding boxes, then footprints whose heights overlap. Contacts are sorted by their units and
// geoms, and take over the impulses of the same points in the tick before. A vehicle that leans is displaced, at the heights that
// both share; where the look-ahead covers that, only its gaps change. Each thread of the team finds those of a range of units.

#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "base/platform/work_team.h"
#include "world/broad_phase.h"
#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// A point of a contact. Upright sides touch at the lower and at the upper end of what they share, so that what leans is held.
struct UnitContactPoint {
    Vec3 at = Vec3::Zero();         ///< in the world
    Vec2 local = Vec2::Zero();      ///< in the frame of `a`
    double gap = 0;                 ///< m, negative where they overlap
    double normal = 0, tangent = 0; ///< impulses, N s
};

struct UnitContact {
    std::uint32_t a = 0, b = 0;         ///< units; `b`: kNoActor for scenery
    std::uint32_t geomA = 0, geomB = 0; ///< of the engine
    Vec2 normal{1, 0};                  ///< from `a` to `b`
    double friction = 0, restitution = 0;
    std::uint32_t count = 0; ///< of points
    std::array<UnitContactPoint, 4> list;

    [[nodiscard]] auto key() const { return std::tuple(a, b, geomA, geomB); }
    [[nodiscard]] std::span<UnitContactPoint> points() { return {list.data(), count}; }
    [[nodiscard]] std::span<const UnitContactPoint> points() const { return {list.data(), count}; }
};

class UnitContacts {
public:
    UnitContacts(const WheeledObjects& objects, WorkTeam& team) : m_objects(objects), m_team(team), m_searches(team.size()) {}

    void find();
    /// Contacts of the units start from nothing in the next tick.
    void forget(std::uint32_t unit);
    /// Whether the unit has a contact, scenery included.
    [[nodiscard]] bool touches(std::uint32_t unit) const { return unit < m_touches.size() && m_touches[unit] != 0; }
    [[nodiscard]] std::vector<UnitContact>& all() { return m_now; }
    [[nodiscard]] const std::vector<UnitContact>& all() const { return m_now; }

private:
    /// A footprint where it is now.
    struct Side {
        const PlanarShape* footprint = nullptr;
        PlanarPose pose;
        double height = 0;          ///< of the origin of its heights
        double level = 0;           ///< height at which it is at the pose
        Vec2 lean = Vec2::Zero();   ///< m that it is displaced per metre above that
        Vec2 centre = Vec2::Zero(); ///< of the footprint, in the world
        double bound = 0;           ///< farthest point from there, wherever it leans
        [[nodiscard]] double low() const { return height + footprint->low; }
        [[nodiscard]] double high() const { return height + footprint->high; }
        [[nodiscard]] Vec2 leanAt(double at) const { return (at - level) * lean; }
        void moveTo(double height);
    };
    struct Other {
        Side side;
        std::uint32_t geom = 0;
    };
    /// Of one thread.
    struct Search {
        std::vector<UnitContact> found; ///< of its units
        std::vector<Side> sides;        ///< of the unit whose contacts are looked for
        std::vector<std::uint32_t> facing; ///< of those, the ones near the unit that it meets
        std::vector<Other> others;         ///< of that unit
        std::vector<std::uint32_t> near;
    };
    void fileBoxes();
    void findOf(std::uint32_t unit, Search& search) const;
    void meet(std::uint32_t a, std::uint32_t b, Search& search) const;
    void meetScenery(std::uint32_t a, Search& search) const;
    static void seeSides(const WheeledUnit& unit, Search& search);
    [[nodiscard]] static Side sideOf(const WheeledUnit& unit, std::size_t footprint);
    [[nodiscard]] bool isNear(const Side& side, std::uint32_t unit) const;
    [[nodiscard]] static bool areNear(const Side& a, const Side& b);
    void add(const UnitContact& pair, Side a, Side b, Search& search) const;
    void addPoints(UnitContact& contact, const Side& a, const Side& b, const PlanarTouch& touch, double most) const;
    void takeOver(std::span<UnitContact> contacts) const;

    const WheeledObjects& m_objects;
    WorkTeam& m_team;
    std::vector<Search> m_searches; ///< by worker
    std::vector<UnitContact> m_now, m_last;
    std::vector<std::uint8_t> m_touches; ///< by unit
    std::vector<double> m_reaches;       ///< by unit
    std::vector<Box3> m_boxes;
    PairGrid m_grid;
    StaticGrid m_sceneryGrid;
    std::size_t m_filed = 0; ///< scenery in its grid
};

} // namespace trundle
