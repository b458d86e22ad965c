#pragma once
// The tick of all units: those that touch nothing a block of equal vehicles at a time, islands in batches.
//
// Assumes: contacts sorted by their units. The bits of an island depend on nothing else in the world.

#include <compare>
#include <vector>

#include "world/wheeled/island_batch.h"

namespace trundle {

class IslandSolver {
public:
    IslandSolver(WheeledObjects& objects, UnitContacts& contacts)
        : m_objects(objects), m_contacts(contacts), m_batch(objects, contacts) {}

    /// New velocities and impulses of all units; vehicles move on.
    void step(const Vec3& gravity, double h);

private:
    void findIslands();
    [[nodiscard]] std::uint32_t root(std::uint32_t unit);
    void solveAlone(const VehicleTick& tick);
    void solveBlock(std::span<const std::uint32_t> units, const VehicleTick& tick);
    void solveIslands();

    WheeledObjects& m_objects;
    UnitContacts& m_contacts;
    const VehicleKernel& m_kernel = vehicleKernel();
    IslandBatch m_batch;
    std::vector<std::uint32_t> m_parent; ///< by unit, of the union of those that touch
    struct Member {
        std::uint32_t island = 0, item = 0;
        auto operator<=>(const Member&) const = default;
    };
    std::vector<Member> m_units, m_unitContacts; ///< sorted
    std::vector<std::uint32_t> m_unitList, m_contactList;
    std::vector<std::vector<std::uint32_t>> m_alone; ///< by model
    std::unique_ptr<VehicleBlock> m_block = std::make_unique<VehicleBlock>();
};

} // namespace trundle
