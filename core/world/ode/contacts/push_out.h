#pragma once
// What stands deeper in something than its load explains, as all things do that met within a tick, is pushed out. That moves it and must
// not throw it: where a contact parts with a speed that no blow gave it, the tick is solved once more without that depth, and gives the
// velocities.

#include <span>
#include <vector>

#include "world/ode/contacts/contact_rows.h"

namespace trundle {

class PushOut {
public:
    /// After the solver, with the velocities that it found and the states before it: marks such contacts, and returns them.
    std::span<const std::uint32_t> find(TickContacts& contacts, const OdeObjects& objects, std::span<const SurfaceSpec> surfaces,
                                        const ContactRows& rows, std::span<const RawState> before, double h);

private:
    std::vector<std::uint32_t> m_found;
    std::vector<bool> m_heaped; ///< by actor: HeapForces push it, and press it against what it touches; empty without any
};

} // namespace trundle
