#pragma once
// Friction that a solution left outside its cone, in a corner of the box of its two rows: those of a contact that is new, or whose load
// is not that of the last tick, do not know how much they yield across the slip. The solution says how the contact slips and what it
// carries; with that its cluster is solved once more.

#include <span>
#include <vector>

#include "world/ode/contacts/contact_rows.h"

namespace trundle {

class FrictionCones {
public:
    /// After the solver, with the velocities that it found and the states before it: marks contacts whose friction is beyond `far` times its limit, and returns
    /// them.
    std::span<const std::uint32_t> find(TickContacts& contacts, const OdeObjects& objects, const ContactRows& rows,
                                        std::span<const RawState> before, double far);

private:
    std::vector<std::uint32_t> m_found;
};

} // namespace trundle
