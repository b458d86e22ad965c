#include "world/ode/contacts/friction_cones.h"

namespace trundle {

std::span<const std::uint32_t> FrictionCones::find(TickContacts& contacts, const OdeObjects& objects, const ContactRows& rows,
                                                   std::span<const RawState> before, double far) {
    m_found.clear();
    for (std::uint32_t i = 0; i < contacts.all.size(); ++i) {
        OdeContact& c = contacts.all[i];
        if (!contacts.rows[i] || c.level) continue;
        const Vec3 force = vec(contacts.feedbacks[i].f1), normal = vec(c.normal);
        const double load = normal.dot(force);
        if (!(load > 0)) continue;
        const Vec3 grip = force - load * normal;
        if (isInside(rows.frictionLaw(c), grip / (far * load))) continue;
        c.solved = true;
        c.solvedLoad = load;
        Vec3::Map(c.solvedGrip) = grip;
        Vec3::Map(c.solvedSpeed) = objects.contactSpeed(c, before);
        m_found.push_back(i);
    }
    return m_found;
}

} // namespace trundle
