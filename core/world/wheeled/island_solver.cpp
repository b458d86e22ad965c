#include "world/wheeled/island_solver.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr int kMostAlone = 300; // sweeps
constexpr std::size_t kBlocksAtOnce = 4, kIslandsAtOnce = 6;
constexpr double kSettledAlone = 1e-6; // of the weight's impulse in a tick: less change of any impulse ends the sweeps

} // namespace

IslandSolver::IslandSolver(WheeledObjects& objects, UnitContacts& contacts, WorkTeam& team)
    : m_objects(objects), m_contacts(contacts), m_team(team) {
    for (unsigned i = 0; i < team.size(); ++i) m_workers.push_back({IslandBatch(objects, contacts)});
}

void IslandSolver::step(const Vec3& gravity, double h) {
    findMembers();
    findIslands();
    findAlone();
    const VehicleTick tick{{gravity.x(), gravity.y(), gravity.z()}, h};
    for (Worker& worker : m_workers) worker.batch.begin(gravity, h);
    for (std::uint32_t i = 0; i < m_objects.units.size(); ++i)
        if (const WheeledUnit& unit = m_objects.units[i]; unit.isMovable() && !unit.isVehicle() && !m_contacts.touches(i))
            m_workers[0].batch.solveLoose(i);
    m_team.split(m_blocks.size(), kBlocksAtOnce, [&](unsigned worker, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) solveBlock(*m_workers[worker].block, m_blocks[i], tick);
    });
    m_team.split(m_islands.size(), kIslandsAtOnce, [&](unsigned worker, std::size_t begin, std::size_t end) {
        IslandBatch& batch = m_workers[worker].batch;
        for (std::size_t i = begin; i < end; ++i) {
            batch.add(m_islands[i].units, m_islands[i].contacts);
            if (batch.isFull()) batch.solve();
        }
        batch.solve();
    });
}

std::uint32_t IslandSolver::root(std::uint32_t unit) {
    while (m_parent[unit] != unit) unit = m_parent[unit] = m_parent[m_parent[unit]];
    return unit;
}

/// Which movable unit and which contact is in which island, by the lowest unit of the island.
void IslandSolver::findMembers() {
    const std::size_t count = m_objects.units.size();
    m_parent.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) m_parent[i] = i;
    const auto moves = [&](std::uint32_t unit) { return unit != kNoActor && m_objects.units[unit].isMovable(); };
    for (const UnitContact& c : m_contacts.all()) {
        if (!moves(c.a) || !moves(c.b)) continue;
        const std::uint32_t x = root(c.a), y = root(c.b);
        m_parent[std::max(x, y)] = std::min(x, y);
    }
    m_members.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if (m_contacts.touches(i) && m_objects.units[i].isMovable()) m_members.push_back({root(i), i});
    std::ranges::sort(m_members);
    m_memberContacts.clear();
    for (std::uint32_t i = 0; i < m_contacts.all().size(); ++i) {
        const UnitContact& c = m_contacts.all()[i];
        m_memberContacts.push_back({root(moves(c.a) ? c.a : c.b), i});
    }
    std::ranges::sort(m_memberContacts);
}

void IslandSolver::findIslands() {
    m_unitList.clear();
    m_contactList.clear();
    for (const Member& unit : m_members) m_unitList.push_back(unit.item);
    for (const Member& contact : m_memberContacts) m_contactList.push_back(contact.item);
    m_islands.clear();
    std::size_t contact = 0;
    for (std::size_t i = 0; i < m_members.size();) {
        const std::size_t first = i, firstContact = contact;
        const std::uint32_t island = m_members[i].island;
        while (i < m_members.size() && m_members[i].island == island) ++i;
        while (contact < m_memberContacts.size() && m_memberContacts[contact].island == island) ++contact;
        m_islands.push_back({std::span(m_unitList).subspan(first, i - first),
                             std::span(m_contactList).subspan(firstContact, contact - firstContact)});
    }
}

/// Vehicles of one model side by side.
void IslandSolver::findAlone() {
    m_alone.resize(m_objects.models.size());
    for (auto& list : m_alone) list.clear();
    for (std::uint32_t i = 0; i < m_objects.units.size(); ++i)
        if (const WheeledUnit& unit = m_objects.units[i]; unit.isMovable() && unit.isVehicle() && !m_contacts.touches(i))
            m_alone[unit.model].push_back(i);
    m_blocks.clear();
    for (const auto& list : m_alone)
        for (std::size_t i = 0; i < list.size(); i += kVehicleLanes)
            m_blocks.push_back(std::span(list).subspan(i, std::min<std::size_t>(kVehicleLanes, list.size() - i)));
}

void IslandSolver::solveBlock(VehicleBlock& block, std::span<const std::uint32_t> units, const VehicleTick& tick) const {
    const VehicleModel& model = m_objects.models[m_objects.units[units[0]].model];
    loadVehicles(block, m_objects, units);
    m_kernel.prepare(block, model, tick);
    m_kernel.settle(block, model, kSettledAlone * m_objects.weight * tick.h * model.mass, kMostAlone);
    m_kernel.finish(block, model, tick);
    for (std::size_t lane = 0; lane < units.size(); ++lane) storeVehicle(block, lane, m_objects, units[lane], tick.h);
}

} // namespace trundle
