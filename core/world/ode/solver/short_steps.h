#pragma once
// What is too large for any other solver of a tick: short steps of ODE's quick solver, with the contacts that the tick began with.

#include <span>
#include <vector>

#include "world/ode/contacts/contact_rows.h"

namespace trundle {

class ShortSteps {
public:
    /// All of these outlive this.
    ShortSteps(OdeWorld& world, const OdeObjects& objects, TickContacts& contacts, const ContactRows& rows);

    /// Of these bodies, ascending, all of whose joints and contacts are among them. `saved`: by body, before the tick. All bodies are
    /// disabled before and after.
    void run(double h, std::span<const std::uint32_t> bodies, std::span<const RawState> saved);

private:
    void prepare(std::span<const std::uint32_t> bodies);
    void step(double part, std::span<const std::uint32_t> bodies, std::span<const RawState> saved);

    OdeWorld& m_world;
    const OdeObjects& m_objects;
    TickContacts& m_contacts;
    const ContactRows& m_rows;
    OwnedJointGroup m_group;          ///< contacts of a short step
    std::vector<std::size_t> m_which; ///< contacts; by these:
    std::vector<OdeContact> m_moved;
    std::vector<dJointFeedback> m_felt;
};

} // namespace trundle
