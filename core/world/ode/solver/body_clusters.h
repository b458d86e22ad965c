#pragma once
// The clusters of a tick: bodies connected by joints and contacts. What does not move connects none. A cluster is named by its body of
// lowest index.

#include <cstdint>
#include <span>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class BodyClusters {
public:
    /// Once all bodies and joints are there.
    void setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, std::span<const OdeCoupling> couplings,
               std::span<const OdeLatch> latches);
    /// Joins the bodies of all contacts that are not `outside`.
    void find(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms);

    [[nodiscard]] std::size_t bodyCount() const { return m_cluster.size(); }
    [[nodiscard]] std::uint32_t of(std::uint32_t body) const { return m_cluster[body]; }
    /// Bodies joined by joints, for good; named like clusters.
    [[nodiscard]] std::uint32_t groupOf(std::uint32_t body) const { return m_group[body]; }
    [[nodiscard]] bool isJointed(std::uint32_t group) const { return m_jointed[group]; }
    // Of a cluster:
    [[nodiscard]] std::uint32_t contacts(std::uint32_t cluster) const { return m_contacts[cluster]; }
    [[nodiscard]] std::uint32_t robots(std::uint32_t cluster) const { return m_robots[cluster]; } ///< groups with joints
    /// Ascending. Builds a table at the first call after find().
    [[nodiscard]] std::span<const std::uint32_t> bodies(std::uint32_t cluster);
    /// All, ascending. Builds the same table.
    [[nodiscard]] std::span<const std::uint32_t> all();

private:
    [[nodiscard]] std::uint32_t root(std::uint32_t body);
    void join(std::uint32_t first, std::uint32_t second);
    void sortBodies();

    std::vector<std::uint32_t> m_group;  ///< by body
    std::vector<bool> m_jointed;         ///< by group
    std::vector<std::uint32_t> m_groups; ///< all of them
    std::vector<std::uint32_t> m_cluster, m_contacts, m_robots;
    bool m_sorted = false;
    std::vector<std::uint32_t> m_names, m_begin, m_next, m_sortedBodies; ///< m_begin: by body, of the cluster that it names
};

} // namespace trundle
