#pragma once
// What hangs together through contacts, and its solution: vehicles, loose bodies and contacts as rows of one Gauss-Seidel solver.
//
// Assumes: contacts sorted by their units. Order of work: units of an island ascending, then its contacts; every second sweep runs
// backwards. So the bits of an island depend on nothing else in the world.

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "world/wheeled/unit_contacts.h"
#include "world/wheeled/vehicle_rows.h"

namespace trundle {

class IslandSolver {
public:
    IslandSolver(WheeledObjects& objects, UnitContacts& contacts) : m_objects(objects), m_contacts(contacts) {}

    /// New velocities and impulses of all units.
    void step(const Vec3& gravity, double h);

private:
    using Velocities = std::array<double, 5>; ///< vx, vy, wx, wy, wz
    struct Loose {
        std::uint32_t unit = 0;
        double mass = 0, inertia = 0; ///< that a push moves
        double limit = 0, reach = 0;  ///< of the ground's impulse, N s; 0: it does not hold the turning
        Velocities v{};
    };
    struct ContactRow {
        double *va = nullptr, *vb = nullptr;
        VehicleRows::Push normalA, normalB, tangentA, tangentB;
        double normalMass = 0, tangentMass = 0, bias = 0, friction = 0, normal = 0, tangent = 0;
        [[nodiscard]] double speed(const VehicleRows::Push& a, const VehicleRows::Push& b) const;
        void push(const VehicleRows::Push& a, const VehicleRows::Push& b, double impulse) const;
    };

    void findIslands();
    [[nodiscard]] std::uint32_t root(std::uint32_t unit);
    void solveAlone(std::uint32_t unit);
    void solve(std::span<const std::uint32_t> units, std::span<const std::uint32_t> contacts);
    void prepare(std::span<const std::uint32_t> units);
    [[nodiscard]] Loose looseOf(std::uint32_t unit) const;
    void addRows(UnitContact& contact);
    [[nodiscard]] VehicleRows::Push pushOf(std::uint32_t unit, const Vec3& point, const Vec2& way) const;
    [[nodiscard]] double* velocitiesOf(std::uint32_t unit);
    [[nodiscard]] static double hold(Loose& loose, Vec3& grip);
    [[nodiscard]] static double solveContact(ContactRow& row);
    [[nodiscard]] double sweep(bool backwards);
    void finish(std::span<const std::uint32_t> contacts);
    void writeBack(const Loose& loose);

    WheeledObjects& m_objects;
    UnitContacts& m_contacts;
    Vec3 m_gravity = Vec3::Zero();
    double m_h = 0;
    std::vector<std::uint32_t> m_parent; ///< by unit, of the union of those that touch
    std::vector<bool> m_touches;         ///< by unit
    struct Member {
        std::uint32_t island = 0, item = 0;
        auto operator<=>(const Member&) const = default;
    };
    std::vector<Member> m_units, m_unitContacts; ///< sorted
    std::vector<std::uint32_t> m_unitList, m_contactList;
    std::vector<std::uint32_t> m_slot; ///< by unit, among the vehicles or the loose bodies of its island
    std::vector<VehicleRows> m_vehicles;
    std::size_t m_vehicleCount = 0;
    std::vector<Loose> m_loose;
    std::vector<ContactRow> m_rows;
    Velocities m_still{}; ///< of what does not move
};

} // namespace trundle
