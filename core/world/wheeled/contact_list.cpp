#include "world/wheeled/contact_list.h"

#include <algorithm>
#include <tuple>

namespace trundle {

const std::vector<EngineContact>& ContactList::all() const {
    m_making.ensure([this] { make(); });
    return m_all;
}

/// Unit by unit, with those among units first.
void ContactList::make() const {
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
    for (const UnitContactPoint& p : c.points())
        if (carries(p)) to.push_back(contactOf(c, p));
}

EngineContact ContactList::contactOf(const UnitContact& c, const UnitContactPoint& p) const {
    const Vec3 normal(c.normal.x(), c.normal.y(), 0), tangent(-normal.y(), normal.x(), 0);
    return {c.a, c.b, c.geomA, c.geomB, p.at, -normal, std::max(-p.gap, 0.), p.normal / m_h, -p.tangent / m_h * tangent};
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
    (void)all();
    m_filing.ensure([this] { file(); });
    return {m_byGeom.data() + m_begin[geom], m_begin[geom + 1] - m_begin[geom]};
}

EngineContact ContactList::at(std::uint32_t index) const {
    if (index < kAmongUnits) return all()[index];
    const UnitContact& contact = m_contacts.all()[(index - kAmongUnits) / kMostPoints];
    return contactOf(contact, contact.list[(index - kAmongUnits) % kMostPoints]);
}

std::span<const std::uint32_t> ContactList::amongUnits(std::uint32_t unit, std::uint32_t geom) const {
    if (!m_contacts.touches(unit)) return {};
    m_linking.ensure([this] { link(); });
    static thread_local std::vector<std::uint32_t> found;
    found.clear();
    if (m_heads[geom].round != m_round) return found;
    for (std::uint32_t k = m_heads[geom].contact; k != kNone;) {
        const UnitContact& c = m_contacts.all()[k];
        for (std::uint32_t i = 0; i < c.count; ++i)
            if (carries(c.list[i])) found.push_back(kAmongUnits + k * kMostPoints + i);
        k = geom == c.geomA ? m_next[k].ofA : m_next[k].ofB;
    }
    return found;
}

/// From the last contact to the first, so that those of a geom ascend.
void ContactList::link() const {
    ++m_round;
    m_heads.resize(m_objects.geoms.size());
    m_next.resize(m_contacts.all().size());
    const auto put = [&](std::uint32_t geom, std::uint32_t contact) {
        Head& head = m_heads[geom];
        const std::uint32_t before = head.round == m_round ? head.contact : kNone;
        head = {m_round, contact};
        return before;
    };
    for (auto k = static_cast<std::uint32_t>(m_next.size()); k-- > 0;) {
        const UnitContact& c = m_contacts.all()[k];
        m_next[k] = {put(c.geomA, k), put(c.geomB, k)};
    }
}

void ContactList::file() const {
    m_begin.assign(m_objects.geoms.size() + 2, 0);
    for (const EngineContact& c : m_all)
        for (const std::uint32_t geom : {c.first, c.second}) ++m_begin[geom + 2];
    for (std::size_t i = 1; i < m_begin.size(); ++i) m_begin[i] += m_begin[i - 1];
    m_byGeom.resize(2 * m_all.size());
    for (std::uint32_t i = 0; i < m_all.size(); ++i)
        for (const std::uint32_t geom : {m_all[i].first, m_all[i].second}) m_byGeom[m_begin[geom + 1]++] = i;
}

} // namespace trundle
