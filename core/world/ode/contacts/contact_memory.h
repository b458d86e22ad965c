#pragma once
// What each contact carried in the last tick. Contacts are found anew in every tick; one continues another of the same two geoms
// and the same side that is nearest to where that has moved. What vanished leaves its load to its neighbours.

#include <cstdint>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class ContactMemory {
public:
    /// Fills load, grip and ticks of the contacts of a new tick, sorted by actor.
    void recall(std::vector<OdeContact>& contacts);
    /// Takes over a contact as it was solved: the force on its first body, how far it has moved since it was found, and the work
    /// that it did along its normal (J).
    void keep(const OdeContact& contact, const Vec3& force, const Vec3& moved, double work);
    void clear() { m_kept.clear(); }
    /// Nothing that an actor carried is of use where it was put.
    void forget(std::uint32_t actor);

private:
    struct Kept {
        std::uint32_t first, second, actor, ticks;
        Vec3 position, normal, grip;
        double load, earlier, stored;
        bool taken;
    };
    void recallPair(OdeContact* begin, OdeContact* end, Kept* from, Kept* to) const;

    std::vector<Kept> m_kept;
};

} // namespace trundle
