#pragma once
// The tick of all units: those that touch nothing a block of equal vehicles at a time, islands in batches; all threads of the team take
// from both.
//
// Assumes: contacts sorted by their units. The bits of an island depend on nothing else in the world.

#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "base/platform/work_team.h"
#include "world/wheeled/island_batch.h"

namespace trundle {

class IslandSolver {
public:
    /// All of these outlive this.
    IslandSolver(WheeledObjects& objects, UnitContacts& contacts, WorkTeam& team);

    /// New velocities and impulses of all units; vehicles move on.
    void step(const Vec3& gravity, double h);

private:
    struct Member {
        std::uint32_t island = 0, item = 0;
        auto operator<=>(const Member&) const = default;
    };
    struct Island {
        std::span<const std::uint32_t> units, contacts;
    };
    struct Worker {
        IslandBatch batch;
        std::unique_ptr<VehicleBlock> block = std::make_unique<VehicleBlock>();
    };
    void findMembers();
    void findIslands();
    void findAlone();
    [[nodiscard]] std::uint32_t root(std::uint32_t unit);
    void solveBlock(VehicleBlock& block, std::span<const std::uint32_t> units, const VehicleTick& tick) const;

    WheeledObjects& m_objects;
    UnitContacts& m_contacts;
    const VehicleKernel& m_kernel = vehicleKernel();
    WorkTeam& m_team;
    std::vector<Worker> m_workers;
    std::vector<std::uint32_t> m_parent;                  ///< by unit, of the union of those that touch
    std::vector<Member> m_members, m_memberContacts;      ///< sorted
    std::vector<std::uint32_t> m_unitList, m_contactList; ///< of all islands, one after another
    std::vector<Island> m_islands;
    std::vector<std::vector<std::uint32_t>> m_alone;      ///< by model
    std::vector<std::span<const std::uint32_t>> m_blocks; ///< of these
};

} // namespace trundle
