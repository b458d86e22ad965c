#pragma once
// Bodies that move farther in a tick than they are thick are swept: where one would have entered the scenery on its way, its actor
// stops just there, with the velocity that it has, and the next tick makes the contact. A robot with joints stops only at what it
// would have passed. Passing through another moving body is only recorded. Method: contacts at poses along the path, no farther apart
// than the body is thick, then halving.

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "world/ode/ode_records.h"

namespace trundle {

/// What a sweep needs of the engine.
struct SweepScene {
    const std::vector<OdeActor>& actors;
    const std::vector<OdeBody>& bodies;
    const std::vector<BodyState>& states;
    const std::vector<OdeGeom>& geoms;
    const std::vector<GroundPlane>& planes;
    const std::vector<std::uint32_t>& statics;
    const std::vector<Vec3>& centres;
    const std::vector<Box3>&boxes, &actorBoxes;
    const Vec3& gravity;
    const std::vector<SurfaceSpec>& surfaces;
    StaticGrid& grid;
    std::vector<OdeContact>& contacts;
    std::function<void(const OdeBody&)> place; ///< finds centres and boxes of its geoms
    std::function<void(std::uint32_t, const GroundPlane&)> meetPlane;
    std::function<void(std::uint32_t, std::uint32_t)> meet; ///< two geoms: adds to the contacts
    std::function<Mat3(const OdeGeom&)> axesOf;
    std::function<void(std::uint32_t, double)> rewind; ///< a body, to where it was so long after the tick began
};

class OdeSweep {
public:
    explicit OdeSweep(SweepScene scene) : m_scene(std::move(scene)) {}
    /// Once the bodies have moved, before they are published: the states published last are where they come from.
    void run(double h);
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
    [[nodiscard]] Path pathOf(std::uint32_t body, double h) const;
    void put(std::uint32_t body, const Path& path, double t);
    void putBack(std::uint32_t body, const RawState& state);
    void findObstacles(std::uint32_t geom, const Path& path);
    [[nodiscard]] double depthIn(std::uint32_t geom, const Obstacle& obstacle, const Path& path);
    [[nodiscard]] bool isStopped(std::uint32_t geom, const Path& path, double t);
    [[nodiscard]] double freeShare(std::uint32_t geom, const Path& path, bool jointed);
    [[nodiscard]] bool touch(std::uint32_t first, std::uint32_t second, const Vec3& way, bool& ahead);
    void findPassages(std::uint32_t geom, double h);
    void stopAt(std::uint32_t actor, double t, double h);

    SweepScene m_scene;
    std::uint64_t m_count = 0;
    double m_thinnestBox = 1e300; ///< m, of the scenery
    bool m_bounces = false;       ///< what stops the actor at hand
    std::vector<IndexPair> m_passages;
    std::vector<OdeContact> m_contacts;
    std::vector<std::uint32_t> m_found, m_fast; ///< m_fast: geoms of one actor
    std::vector<Obstacle> m_obstacles;
};

} // namespace trundle
