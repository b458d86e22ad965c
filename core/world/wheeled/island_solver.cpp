#include "world/wheeled/island_solver.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr int kMostAlone = 300;        // sweeps
constexpr double kSettledAlone = 1e-6; // of the weight's impulse in a tick: less change of any impulse ends the sweeps

} // namespace

void IslandSolver::step(const Vec3& gravity, double h) {
    findIslands();
    m_batch.begin(gravity, h);
    solveAlone({{gravity.x(), gravity.y(), gravity.z()}, h});
    solveIslands();
}

std::uint32_t IslandSolver::root(std::uint32_t unit) {
    while (m_parent[unit] != unit) unit = m_parent[unit] = m_parent[m_parent[unit]];
    return unit;
}

void IslandSolver::findIslands() {
    const std::size_t count = m_objects.units.size();
    m_parent.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) m_parent[i] = i;
    const auto moves = [&](std::uint32_t unit) { return unit != kNoActor && m_objects.units[unit].isMovable(); };
    for (const UnitContact& c : m_contacts.all()) {
        if (!moves(c.a) || !moves(c.b)) continue;
        const std::uint32_t x = root(c.a), y = root(c.b);
        m_parent[std::max(x, y)] = std::min(x, y);
    }
    m_units.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if (m_contacts.touches(i) && m_objects.units[i].isMovable()) m_units.push_back({root(i), i});
    std::ranges::sort(m_units);
    m_unitContacts.clear();
    for (std::uint32_t i = 0; i < m_contacts.all().size(); ++i) {
        const UnitContact& c = m_contacts.all()[i];
        m_unitContacts.push_back({root(moves(c.a) ? c.a : c.b), i});
    }
    std::ranges::sort(m_unitContacts);
}

void IslandSolver::solveAlone(const VehicleTick& tick) {
    m_alone.resize(m_objects.models.size());
    for (auto& list : m_alone) list.clear();
    for (std::uint32_t i = 0; i < m_objects.units.size(); ++i) {
        const WheeledUnit& unit = m_objects.units[i];
        if (!unit.isMovable() || m_contacts.touches(i)) continue;
        if (!unit.isVehicle()) {
            m_batch.solveLoose(i);
            continue;
        }
        std::vector<std::uint32_t>& list = m_alone[unit.model];
        list.push_back(i);
        if (list.size() < kVehicleLanes) continue;
        solveBlock(list, tick);
        list.clear();
    }
    for (const auto& list : m_alone)
        if (!list.empty()) solveBlock(list, tick);
}

void IslandSolver::solveBlock(std::span<const std::uint32_t> units, const VehicleTick& tick) {
    const VehicleModel& model = m_objects.models[m_objects.units[units[0]].model];
    loadVehicles(*m_block, m_objects, units);
    m_kernel.prepare(*m_block, model, tick);
    m_kernel.settle(*m_block, model, kSettledAlone * m_objects.weight * tick.h * model.mass, kMostAlone);
    m_kernel.finish(*m_block, model, tick);
    for (std::size_t lane = 0; lane < units.size(); ++lane) storeVehicle(*m_block, lane, m_objects, units[lane]);
}

void IslandSolver::solveIslands() {
    std::size_t contact = 0;
    for (std::size_t i = 0; i < m_units.size();) {
        const std::uint32_t island = m_units[i].island;
        m_unitList.clear();
        m_contactList.clear();
        for (; i < m_units.size() && m_units[i].island == island; ++i) m_unitList.push_back(m_units[i].item);
        for (; contact < m_unitContacts.size() && m_unitContacts[contact].island == island; ++contact)
            m_contactList.push_back(m_unitContacts[contact].item);
        m_batch.add(m_unitList, m_contactList);
        if (m_batch.isFull()) m_batch.solve();
    }
    m_batch.solve();
}

} // namespace trundle
