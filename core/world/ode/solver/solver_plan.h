#pragma once
// Which solver takes what, tick by tick: each cluster by itself, so that a body without contacts is solved the same whatever happens
// elsewhere. A robot with what it touches is exact. Robots that touch each other, and what stands on the floor beside them, push each
// other through HeapForces, but for arms among up to three robots; what then still hangs together is exact if it is small. A larger pile
// is tried exactly, as many that rest can be; what cannot, and larger ones, are left to RowSweeps. What is larger still is iterated in
// short steps.

#include <span>
#include <vector>

#include "world/ode/solver/body_clusters.h"

namespace trundle {

class SolverPlan {
public:
    void setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, std::span<const OdeCoupling> couplings,
               std::span<const OdeLatch> latches);
    /// Marks the contacts: `outside`, `iterated`.
    void make(SolverChoice choice, const Vec3& up, std::span<OdeContact> contacts, std::span<const OdeGeom> geoms);
    /// Once the contacts between bodies are known to matter: a solver failed.
    void findClusters(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms);

    [[nodiscard]] BodyClusters& clusters() { return m_clusters; }
    // By cluster name, ascending:
    [[nodiscard]] std::span<const std::uint32_t> iterated() const { return m_iterated; }
    [[nodiscard]] std::span<const std::uint32_t> piles() const { return m_piles; }
    /// A pile that could not be solved exactly is not tried again for some ticks; nor is one that was charged for more multiplications
    /// than it is worth.
    void markHard(std::uint32_t cluster) { m_hardUntil[cluster] = m_tick + kHardTicks; }
    void charge(std::uint32_t cluster, std::uint64_t work);
    [[nodiscard]] bool isHard(std::uint32_t pile) const;
    [[nodiscard]] bool hasOutside() const { return m_hasOutside; }
    /// Contacts in the largest cluster of this tick that is solved exactly, and its name; 0 without contacts between bodies.
    [[nodiscard]] std::uint32_t largest() const { return m_largest; }
    [[nodiscard]] std::uint32_t largestName() const { return m_largestName; }

private:
    [[nodiscard]] bool cut(const Vec3& up, std::span<OdeContact> contacts, std::span<const OdeGeom> geoms);
    void iterateLarge(std::span<OdeContact> contacts, std::span<const OdeGeom> geoms);
    void findLargest(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms);

    BodyClusters m_clusters;
    std::vector<std::uint32_t> m_iterated, m_piles;
    static constexpr std::uint64_t kHardTicks = 100;
    std::vector<std::uint64_t> m_hardUntil, m_owed; ///< by the body that names a cluster; m_hardUntil: tick
    std::uint64_t m_tick = 0;
    std::vector<bool> m_stands;  ///< by group
    std::vector<bool> m_carries; ///< by body: itself or what it carries touches the floor
    std::vector<std::uint32_t> m_parents;
    bool m_found = false, m_hasOutside = false;
    std::uint32_t m_largest = 0, m_largestName = 0;
};

} // namespace trundle
