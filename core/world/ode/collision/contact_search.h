#pragma once
// Which geoms touch. Method: bounding boxes around everything; for each actor first planes, then statics, then partners, each in index
// order, so that contacts are sorted by (actor, partner, geom).

#include <vector>

#include "world/ode/collision/geom_collider.h"

namespace trundle {

class ContactSearch {
public:
    /// All of these outlive this; the centres and boxes of the objects are what it fills.
    ContactSearch(const EngineSettings& settings, OdeObjects& objects, GeomCollider& collider)
        : m_settings(settings), m_objects(objects), m_collider(collider) {}

    /// All contacts, with the bodies where they are.
    void find(std::vector<OdeContact>& contacts);
    /// The same for a step: what was placed since the last one gets contacts also where it only just misses (start_contacts.cpp).
    void findForStep(std::vector<OdeContact>& contacts);
    /// An actor was moved to another place; new ones need not be named.
    void markPlaced(std::uint32_t actor) { m_placed.push_back(actor); }

    /// Finds centres and boxes of a body's geoms.
    void placeGeoms(const OdeBody& body);
    /// Indices in `statics` of those whose boxes touch this one, ascending.
    void staticsNear(const Box3& box, std::vector<std::uint32_t>& found) { m_grid.query(box, found); }

private:
    void updateBoxes();
    [[nodiscard]] bool areBodiesApart(std::uint32_t firstGeom, std::uint32_t secondGeom) const;
    void collideWithScenery(std::uint32_t actor, std::vector<OdeContact>& contacts);
    [[nodiscard]] double reachOf(std::uint32_t geom, const Vec3& way) const;
    [[nodiscard]] bool isOnFace(const OdeContact& contact) const;
    void dropInnerEdges(std::vector<OdeContact>& contacts, std::size_t begin) const;

    const EngineSettings& m_settings;
    OdeObjects& m_objects;
    GeomCollider& m_collider;
    StaticGrid m_grid;
    std::size_t m_gridded = 0; ///< statics in the grid
    std::uint32_t m_known = 0; ///< actors of which the last step knew
    PairGrid m_pairGrid;
    std::vector<std::uint32_t> m_found, m_placed; ///< m_placed: actors, since the last step
    std::vector<IndexPair> m_pairs;
    mutable std::vector<std::size_t> m_seams; ///< contacts that are dropped
};

} // namespace trundle
