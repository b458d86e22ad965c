#pragma once
// Blows: contacts that meet fast. Restitution is that of Newton at every point where two bodies meet, receding points included, which
// alone never adds energy. With friction, or where materials differ, it can; the work of all contact forces of what touches then comes
// out positive, and the tick is taken again with less restitution there.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class Impacts {
public:
    /// Actors that joints, springs or latches join.
    void setUp(std::vector<IndexPair> joined) { m_linked = std::move(joined); }
    /// Marks the blows of a tick, before anything else prepares it.
    void find(std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
              std::span<const SurfaceSpec> surfaces);
    /// By body: has a contact in this tick.
    [[nodiscard]] const std::vector<bool>& touching() const { return m_touching; }
    /// After the solver, with the states before it: true if the tick has to be taken again, with the contacts as changed here.
    [[nodiscard]] bool needRepeat(std::span<OdeContact> contacts, std::span<const dJointFeedback> forces,
                                  std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                                  std::span<const RawState> before);

private:
    /// Of actors that touch each other or are joined.
    struct Cluster {
        bool bounces = false, driven = false; ///< driven: by a surface velocity, which may add energy, or not solved exactly
        double work = 0, size = 0;            ///< W s of all contacts over the tick, and the sum of their amounts
        double full = 0, none = 0;            ///< work with all and with no restitution
        double share = 1;                     ///< of the restitution
        int tries = 0;
    };
    void join(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms, std::size_t actors);
    [[nodiscard]] std::uint32_t rootOf(std::uint32_t actor);
    [[nodiscard]] static bool reduce(Cluster& cluster);

    bool m_bounces = false, m_joined = false;
    std::vector<bool> m_touching, m_struck; ///< by body; struck: takes a blow, empty where none does
    std::vector<std::uint32_t> m_parents;   ///< by actor
    std::vector<IndexPair> m_linked;        ///< actors
    std::vector<Cluster> m_clusters;        ///< by their first actor
};

} // namespace trundle
