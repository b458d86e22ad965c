#include "world/ode/contacts/push_out.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kParting = 1e-3;   // m/s
constexpr double kExplained = 1e-6; // m
constexpr double kBlow = 0.01;      // s: shorter than a load lasts

/// Contacts deep in a mesh may have any direction, and hold a body between them that has no speed.
bool hasDirections(const OdeGeom& g) { return g.shape != GeomShape::Mesh && g.shape != GeomShape::Heightfield; }

} // namespace

/// A load explains a depth once it has lasted longer than that of a blow.
std::span<const std::uint32_t> PushOut::find(TickContacts& contacts, const OdeObjects& objects,
                                             std::span<const SurfaceSpec> surfaces, const ContactRows& rows,
                                             std::span<const RawState> before, double h) {
    m_found.clear();
    m_heaped.clear();
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
        const double borne = c.ticks * h < kBlow ? 0 : std::min(kMaxSag, std::min(c.load, c.earlier) / rows.stiffness(c));
        if (c.depth < borne + kExplained) continue;
        c.borne = borne;
        m_found.push_back(i);
    }
    return m_found;
}

} // namespace trundle
