#pragma once
#include <vector>

#include "world/world.h"

namespace trundle {

/// What a world reports of itself while it runs on, each once: clusters too large for the solver, piles that are iterated, bodies that passed through each other,
/// joints that were closed again, robots that ended.
class WorldWarnings {
public:
    /// After each tick, also after one that ended the run: appends what is new.
    void update(const World& world, std::vector<Diagnostic>& warnings);

private:
    bool m_cluster = false, m_pile = false;
    std::size_t m_passages = 0, m_ends = 0, m_closedJoints = 0;
};

} // namespace trundle
