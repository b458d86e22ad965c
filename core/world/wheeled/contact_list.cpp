#include "world/wheeled/contact_list.h"

#include <algorithm>
#include <tuple>

namespace trundle {

const std::vector<EngineContact>& ContactList::all() const {
    if (!m_ready) make();
    return m_all;
}

/// Unit by unit, with those among units first.
void ContactList::make() const {
    m_ready = true;
    m_all.clear();
    auto next = m_contacts.all().begin();
    for (std::uint32_t i = 0; i < m_objects.units.size(); ++i) {
        for (; next != m_contacts.all().end() && next->a == i && next->b != kNoActor; ++next) addUnit(*next, m_all);
        const std::size_t first = m_all.size();
        for (; next != m_contacts.all().end() && next->a == i; ++next) addUnit(*next, m_all);
        if (!m_objects.units[i].isMovable()) continue;
        if (m_objects.units[i].isVehicle()) addSupports(i);
        else addGround(i);
        std::sort(m_all.begin() + static_cast<std::ptrdiff_t>(first), m_all.end(),
                  [](const EngineContact& x, const EngineContact& y) {
                      return std::tuple(x.first, x.second) < std::tuple(y.first, y.second);
                  });
    }
}

void ContactList::addUnit(const UnitContact& c, std::vector<EngineContact>& to) const {
    const Vec3 normal(c.normal.x(), c.normal.y(), 0), tangent(-normal.y(), normal.x(), 0);
    for (const UnitContactPoint& p : c.points())
        if (p.gap <= 0 || p.normal > 0)
            to.push_back(
                {c.a, c.b, c.geomA, c.geomB, p.at, -normal, std::max(-p.gap, 0.), p.normal / m_h, -p.tangent / m_h * tangent});
}

void ContactList::addSupports(std::uint32_t index) const {
    const WheeledUnit& unit = m_objects.units[index];
    for (std::uint32_t i = 0; i < unit.shape->supports.size(); ++i) {
        const Support& s = unit.shape->supports[i];
        const SupportState& state = m_objects.supports[unit.supports + i];
        const Vec3 at = unit.position + unit.rotation * s.centre - Vec3(0, 0, s.radius);
        const double depth = m_objects.ground->height - at.z();
        if (depth < 0 && state.normal == 0) continue;
        const Vec2 way = unit.plane.turn(s.way);
        const Vec3 friction(state.along * way.x() - state.across * way.y(), state.along * way.y() + state.across * way.x(), 0);
        m_all.push_back({index, kNoActor, unit.geoms + s.geom, m_objects.ground->geom(), at, Vec3::UnitZ(), std::max(depth, 0.),
                         state.normal / m_h, friction / m_h});
    }
}

/// Of something loose: what it carries as a whole, below its centre of mass.
void ContactList::addGround(std::uint32_t index) const {
    const WheeledUnit& unit = m_objects.units[index];
    const auto& footprints = unit.shape->footprints;
    const auto base = std::ranges::min_element(footprints, {}, &PlanarShape::low);
    const auto geom = static_cast<std::uint32_t>(base - footprints.begin());
    const Vec3 at(unit.position.x(), unit.position.y(), m_objects.ground->height);
    m_all.push_back({index, kNoActor, unit.geoms + geom, m_objects.ground->geom(), at, Vec3::UnitZ(), 0,
                     unit.shape->mass * m_objects.weight, Vec3(unit.grip.x(), unit.grip.y(), 0) / m_h});
}

std::span<const std::uint32_t> ContactList::of(std::uint32_t geom) const {
    if (const std::uint32_t unit = m_objects.aloft[geom]; unit != kNoActor) return amongUnits(unit, geom);
    if (!m_filed) file();
    return {m_byGeom.data() + m_begin[geom], m_begin[geom + 1] - m_begin[geom]};
}

std::span<const std::uint32_t> ContactList::amongUnits(std::uint32_t unit, std::uint32_t geom) const {
    if (!m_contacts.touches(unit)) return {};
    if (!m_amongReady) makeAmong();
    m_found.clear();
    for (auto at = std::ranges::lower_bound(m_amongOf, IndexPair{unit, 0}); at != m_amongOf.end() && at->first == unit; ++at)
        if (const EngineContact& c = m_among[at->second]; c.first == geom || c.second == geom)
            m_found.push_back(kAmongUnits + at->second);
    return m_found;
}

void ContactList::makeAmong() const {
    m_amongReady = true;
    m_among.clear();
    m_amongOf.clear();
    for (const UnitContact& c : m_contacts.all()) {
        const auto first = static_cast<std::uint32_t>(m_among.size());
        addUnit(c, m_among);
        for (std::uint32_t i = first; i < m_among.size(); ++i) {
            m_amongOf.emplace_back(c.a, i);
            if (c.b != kNoActor) m_amongOf.emplace_back(c.b, i);
        }
    }
    std::ranges::sort(m_amongOf);
}

void ContactList::file() const {
    m_filed = true;
    m_begin.assign(m_objects.geoms.size() + 2, 0);
    for (const EngineContact& c : all())
        for (const std::uint32_t geom : {c.first, c.second}) ++m_begin[geom + 2];
    for (std::size_t i = 1; i < m_begin.size(); ++i) m_begin[i] += m_begin[i - 1];
    m_byGeom.resize(2 * m_all.size());
    for (std::uint32_t i = 0; i < m_all.size(); ++i)
        for (const std::uint32_t geom : {m_all[i].first, m_all[i].second}) m_byGeom[m_begin[geom + 1]++] = i;
}

} // namespace trundle
