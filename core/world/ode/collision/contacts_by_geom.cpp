#include "world/ode/collision/contacts_by_geom.h"

namespace trundle {

std::span<const std::uint32_t> ContactsByGeom::of(std::uint32_t geom, std::size_t geoms, std::span<const OdeContact> contacts) {
    m_sorting.ensure([&] { sort(geoms, contacts); });
    const std::uint32_t begin = m_begin[geom], end = m_begin[geom + 1];
    return {m_contacts.data() + begin, end - begin};
}

/// Counts, sums, and puts each contact where its geom's begin: from the last one on, so that they ascend.
void ContactsByGeom::sort(std::size_t geoms, std::span<const OdeContact> contacts) {
    m_begin.assign(geoms + 1, 0);
    for (const OdeContact& c : contacts) {
        ++m_begin[c.first + 1];
        ++m_begin[c.second + 1];
    }
    for (std::size_t i = 1; i < m_begin.size(); ++i) m_begin[i] += m_begin[i - 1];
    m_contacts.resize(2 * contacts.size());
    for (std::size_t i = contacts.size(); i-- > 0;) {
        m_contacts[--m_begin[contacts[i].first + 1]] = static_cast<std::uint32_t>(i);
        m_contacts[--m_begin[contacts[i].second + 1]] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t i = 0; i + 1 < m_begin.size(); ++i) m_begin[i] = m_begin[i + 1];
    m_begin.back() = static_cast<std::uint32_t>(m_contacts.size());
}

} // namespace trundle
