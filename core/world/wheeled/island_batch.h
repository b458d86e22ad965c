#pragma once
// Several islands (units that hang together through contacts) solved side by side: vehicles in the lanes of blocks, loose bodies and
// contacts as further rows of one Gauss-Seidel solver.
//
// Order of work in an island: vehicles ascending, loose bodies, its contacts; every second sweep runs backwards. The bits of an island depend
// neither on others in the batch nor on what is beside its vehicles in a block.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "world/wheeled/unit_contacts.h"
#include "world/wheeled/vehicle_blocks.h"

namespace trundle {

class IslandBatch {
public:
    IslandBatch(WheeledObjects& objects, UnitContacts& contacts) : m_objects(objects), m_contacts(contacts) {}

    void begin(const Vec3& gravity, double h);
    /// Units and contacts (indices) of one island, ascending.
    void add(std::span<const std::uint32_t> units, std::span<const std::uint32_t> contacts);
    [[nodiscard]] bool isFull() const;
    /// New velocities and impulses; all move on. Then it is empty.
    void solve();

    /// A loose body that touches nothing: it moves on.
    void solveLoose(std::uint32_t unit);

private:
    struct Loose {
        std::uint32_t unit = 0;
        double mass = 0, inertia = 0;              ///< that a push moves
        double limit = 0, reach = 0;               ///< of the ground's impulse, N s; 0: it does not hold the turning
        std::array<double, 5 * kVehicleLanes> v{}; ///< vx, vy, wx, wy, wz, as far apart as in a block
    };
    struct ContactRow {
        double *va = nullptr, *vb = nullptr; ///< velocities; nullptr where it does not move
        VehiclePushes a, b;
        double normalMass = 0, tangentMass = 0; ///< kg
        double bias = 0, friction = 0, normal = 0, tangent = 0;
        double kept = 0, taken = 0; ///< of bias, the speed that remains after the tick; the impulse that gave the rest of it, N s
    };
    struct Range {
        std::size_t first = 0, last = 0;
    };
    struct Island {
        Range units, contacts, loose, rows;
        double settled = 0; ///< less change of any impulse ends the sweeps, N s
        bool isOpen = true;
    };
    struct Block {
        std::uint32_t model = 0;
        std::vector<std::uint32_t> units;
        std::size_t open = 0; ///< lanes that are not settled
        std::unique_ptr<VehicleBlock> lanes = std::make_unique<VehicleBlock>();
    };
    struct Place { ///< of a unit: in a block, or among the loose ones
        std::uint32_t block = 0, lane = 0;
    };

    void place(std::uint32_t unit);
    void prepare();
    [[nodiscard]] Loose looseOf(std::uint32_t unit) const;
    void addLoose(std::uint32_t unit);
    void addRows(UnitContact& contact);
    [[nodiscard]] VehiclePushes pushesOf(std::uint32_t unit, const Vec3& point, const Vec2& normal) const;
    [[nodiscard]] Vec2 velocityAt(std::uint32_t unit, const Vec3& point) const;
    [[nodiscard]] double* velocitiesOf(std::uint32_t unit);
    [[nodiscard]] static double hold(Loose& loose, Vec3& grip);
    [[nodiscard]] static double solveContact(ContactRow& row);
    [[nodiscard]] double sweep(const Island& island, bool backwards);
    void settle(Island& island);
    void takeOutPushes(const Island& island);
    [[nodiscard]] static double takeOut(ContactRow& row);
    void finish();
    void writeBack(const Loose& loose);

    WheeledObjects& m_objects;
    UnitContacts& m_contacts;
    const VehicleKernel& m_kernel = vehicleKernel();
    VehicleTick m_tick;
    std::vector<Island> m_islands;
    std::vector<std::uint32_t> m_units, m_contactList; ///< of all islands
    std::vector<Place> m_place;                        ///< by unit
    std::vector<Block> m_blocks;
    std::size_t m_blockCount = 0;
    std::vector<Loose> m_loose;
    std::vector<ContactRow> m_rows;
};

} // namespace trundle
