#pragma once
// Which actors hang together in a tick by joints at the top level and latches; springs give way. Those of ended actors hold nothing any
// more.

#include <vector>

#include "world/ode/objects/ode_objects.h"

namespace trundle {

class LinkedActors {
public:
    void update(const OdeObjects& objects);

    /// By joints of its own, or to another actor or the world.
    [[nodiscard]] bool isJointed(std::uint32_t actor) const { return m_jointed[actor]; }
    /// Of its group, in the order of actors.
    [[nodiscard]] bool isFirst(std::uint32_t actor) const { return m_first.empty() || m_first[actor] == actor; }
    /// The next one of its group; kNone after the last.
    [[nodiscard]] std::uint32_t next(std::uint32_t actor) const { return m_next.empty() ? kNone : m_next[actor]; }

private:
    void join(const OdeObjects& objects, std::uint32_t body, std::uint32_t other);
    void numberGroups();

    std::vector<bool> m_jointed;                ///< by actor
    std::vector<std::uint32_t> m_first, m_next; ///< by actor; empty: no actor is joined to another one
    std::vector<std::uint32_t> m_last;          ///< by first actor, of its group so far
};

} // namespace trundle
