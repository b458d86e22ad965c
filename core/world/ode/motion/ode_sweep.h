#pragma once
// Bodies that move farther in a tick than they are thick are swept: where one would have entered the scenery on its way, its actor
// stops just there, with the velocity that it has, and the next tick makes the contact. A robot with joints stops only at what it
// would have passed, and with it all that joints or latches join to it. Passing through another moving body is only recorded. Method: contacts at poses along the path, no farther apart
// than the body is thick, then halving.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "world/ode/collision/contact_search.h"
#include "world/ode/motion/body_rotation.h"
#include "world/ode/motion/linked_actors.h"

namespace trundle {

class OdeSweep {
public:
    /// All of these outlive this.
    OdeSweep(const EngineSettings& settings, const OdeObjects& objects, const BodyRotation& rotation, ContactSearch& search,
             GeomCollider& collider)
        : m_settings(settings), m_objects(objects), m_rotation(rotation), m_search(search), m_collider(collider) {}
    /// Once the bodies have moved, before they are published: the states published last are where they come from. `contacts`: of the
    /// tick.
    void run(double h, std::span<const OdeContact> contacts);
    /// Bodies times ticks that were swept.
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    /// Geoms of different actors that passed through each other, once for two actors.
    [[nodiscard]] std::span<const IndexPair> passages() const { return m_passages; }
    void addScenery(const OdeGeom& geom);

private:
    struct Path {
        Vec3 from, to;
        Quat start;
        Vec3 turned; ///< axis times angle
        double time; ///< s
    };
    struct Obstacle {
        std::uint32_t geom, plane; ///< kNone: not a plane
        double before;             ///< m: how deep it was at the start
    };
    [[nodiscard]] bool outruns(const OdeGeom& geom, double h) const;
    [[nodiscard]] double thinnestFor(const OdeGeom& geom) const;
    [[nodiscard]] double safeWay(const OdeGeom& geom) const;
    [[nodiscard]] Path pathOf(std::uint32_t body, double h) const;
    void put(std::uint32_t body, const Path& path, double t);
    void putBack(std::uint32_t body, const RawState& state);
    void findObstacles(std::uint32_t geom, const Path& path);
    [[nodiscard]] double depthIn(std::uint32_t geom, const Obstacle& obstacle, const Path& path);
    [[nodiscard]] bool isStopped(std::uint32_t geom, const Path& path, double t);
    [[nodiscard]] double freeShare(std::uint32_t geom, const Path& path, bool jointed);
    [[nodiscard]] double touch(std::uint32_t first, std::uint32_t second, const Vec3& way, bool& ahead);
    void findPassages(std::uint32_t geom, double h);
    [[nodiscard]] double shareOf(std::uint32_t actor, double h);
    [[nodiscard]] double borneShare(std::uint32_t body);
    void stopAt(std::uint32_t actor, double t, double h, std::span<const OdeContact> contacts);

    const EngineSettings& m_settings;
    const OdeObjects& m_objects;
    const BodyRotation& m_rotation;
    ContactSearch& m_search;
    GeomCollider& m_collider;
    LinkedActors m_links;
    std::uint64_t m_count = 0;
    double m_thinnestBox = 1e300; ///< m, of the scenery
    bool m_bounces = false;       ///< what stops the actor at hand
    std::vector<IndexPair> m_passages;
    std::vector<OdeContact> m_contacts;
    std::vector<std::uint32_t> m_found, m_fast; ///< m_fast: geoms of one actor
    std::vector<Obstacle> m_obstacles;
};

} // namespace trundle
