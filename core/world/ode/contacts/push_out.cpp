#include "world/ode/contacts/push_out.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kParting = 1e-3;   // m/s
constexpr double kExplained = 1e-6; // m
constexpr double kBlow = 0.01;      // s: shorter than a load lasts

/// Contacts deep in a mesh may have any direction, and hold a body between them that has no speed.
bool hasDirections(const OdeGeom& g) { return g.shape != GeomShape::Mesh && g.shape != GeomShape::Heightfield; }

/// Calls `use` for the other contacts of the same two geoms: one that has no force yet would push in place of that which was found.
template <class Use> void eachBeside(const std::vector<OdeContact>& all, std::uint32_t index, const Use& use) {
    const auto isOfPair = [&](std::uint32_t i) { return all[i].first == all[index].first && all[i].second == all[index].second; };
    for (std::uint32_t i = index; i-- > 0 && isOfPair(i);) use(i);
    for (std::uint32_t i = index + 1; i < all.size() && isOfPair(i); ++i) use(i);
}

} // namespace

/// A load explains a depth once it has lasted longer than that of a blow.
std::span<const std::uint32_t> PushOut::find(TickContacts& contacts, const OdeObjects& objects,
                                             std::span<const SurfaceSpec> surfaces, const ContactRows& rows,
                                             std::span<const RawState> before, double h) {
    m_found.clear();
    m_heaped.clear();
    const auto borneOf = [&](const OdeContact& c) { return c.ticks * h < kBlow ? 0 : rows.sag(c); };
    for (const OdeContact& c : contacts.all) {
        if (!c.outside) continue;
        m_heaped.resize(objects.actors.size(), false);
        m_heaped[c.actor] = m_heaped[c.partner] = true;
    }
    for (std::uint32_t i = 0; i < contacts.all.size(); ++i) {
        OdeContact& c = contacts.all[i];
        if (!contacts.rows[i] || c.bounces || !(c.depth > kExplained)) continue;
        if (!m_heaped.empty() && (m_heaped[c.actor] || (c.partner != kNoActor && m_heaped[c.partner]))) continue;
        const Vec3 normal = vec(c.normal);
        if (!(normal.dot(vec(contacts.feedbacks[i].f1)) > 0) || !(normal.dot(objects.contactSpeed(c, before)) > kParting))
            continue;
        const bool known = hasDirections(objects.geoms[c.first]) && hasDirections(objects.geoms[c.second]);
        if (!known && !rows.landsOnSprings(c)) continue;
        if (surfaces[objects.geoms[c.first].surface].softness + surfaces[objects.geoms[c.second].surface].softness > 0) continue;
        const double borne = borneOf(c);
        if (c.depth < borne + kExplained) continue;
        c.borne = borne;
        m_found.push_back(i);
    }
    for (std::size_t k = 0, found = m_found.size(); k < found; ++k)
        eachBeside(contacts.all, m_found[k], [&](std::uint32_t i) {
            OdeContact& c = contacts.all[i];
            const bool isUnloaded = !(vec(c.normal).dot(vec(contacts.feedbacks[i].f1)) > 0);
            if (!contacts.rows[i] || c.bounces || c.borne >= 0 || !isUnloaded || c.depth < borneOf(c) + kExplained) return;
            c.borne = borneOf(c);
            m_found.push_back(i);
        });
    return m_found;
}

} // namespace trundle
