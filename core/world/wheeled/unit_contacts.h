#pragma once
// Which units touch each other and the scenery, over x and y; found anew in every tick.
//
// Method: candidates from grids of bounding boxes, then footprints whose heights overlap. Contacts are sorted by their units and geoms, and
// take over the impulses of the same points in the tick before.

#include <array>
#include <tuple>
#include <vector>

#include "world/broad_phase.h"
#include "world/wheeled/wheeled_objects.h"

namespace trundle {

struct UnitContact {
    std::uint32_t a = 0, b = 0;         ///< units; `b`: kNoActor for scenery
    std::uint32_t geomA = 0, geomB = 0; ///< of the engine
    FootprintTouch touch;
    double height = 0; ///< m, in the world
    double friction = 0, restitution = 0;
    std::array<Vec2, 2> local{Vec2::Zero(), Vec2::Zero()}; ///< points in the frame of `a`
    std::array<double, 2> normal{}, tangent{};             ///< impulses, N s

    [[nodiscard]] auto key() const { return std::tuple(a, b, geomA, geomB); }
};

class UnitContacts {
public:
    explicit UnitContacts(const WheeledObjects& objects) : m_objects(objects) {}

    void find();
    /// Contacts of the units start from nothing in the next tick.
    void forget(std::uint32_t unit);
    [[nodiscard]] std::vector<UnitContact>& all() { return m_now; }
    [[nodiscard]] const std::vector<UnitContact>& all() const { return m_now; }

private:
    void meet(std::uint32_t a, std::uint32_t b);
    void meetScenery(std::uint32_t a, const WheeledScenery& scenery);
    void add(UnitContact contact, const Footprint& fa, const PlanarPose& pa, const Footprint& fb, const PlanarPose& pb);
    [[nodiscard]] bool overlap(const Footprint& a, double atA, const Footprint& b, double atB, double& height) const;
    void takeOver();

    const WheeledObjects& m_objects;
    std::vector<UnitContact> m_now, m_last;
    std::vector<Box3> m_boxes;
    std::vector<IndexPair> m_pairs;
    std::vector<std::uint32_t> m_near;
    PairGrid m_grid;
    StaticGrid m_sceneryGrid;
    std::size_t m_filed = 0; ///< scenery in its grid
};

} // namespace trundle
