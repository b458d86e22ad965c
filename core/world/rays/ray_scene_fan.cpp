// The cast of a fan: its layers against planes, then against each candidate the beams of its bearings, then meshes and height maps, whose
// search is shortened by what was hit before.

#include <algorithm>

#include "world/rays/beam_table.h"
#include "world/rays/fan_view.h"
#include "world/rays/mesh_roots.h"
#include "world/rays/ray_scene.h"

namespace trundle {

namespace {

const RayRoots kNoRoots; // for what has no parts

/// Working memory of the casts of one thread, which keeps its size from one to the next.
struct FanMemory {
    BeamTables tables;
    std::vector<const GeomBall*> candidates;
    std::vector<double> distances, nearest, parts; ///< of the beams of a cast, layer by layer; nearest: geoms
};

FanMemory& memoryOfThread() {
    static thread_local FanMemory memory;
    return memory;
}

} // namespace

struct RayScene::FanCast {
    const RayScene& scene;
    FanMemory& memory;
    FanView view;
    std::uint32_t without;

    /// Of one geom: its fan in its axes.
    struct Local {
        LocalBeams turned; ///< a, b, c: forwards, left, up
        /// The beams of a layer.
        [[nodiscard]] LocalBeams of(const Direction& layer) const {
            LocalBeams beams = turned;
            for (int k = 0; k < 3; ++k) {
                beams.a[k] *= layer.cosine;
                beams.b[k] *= layer.cosine;
                beams.c[k] *= layer.sine;
            }
            return beams;
        }
    };

    [[nodiscard]] Local localOf(const RayGeom& geom) const {
        const RayFan& f = view.fan();
        return {scene.local(geom, f.origin, f.axes.col(0), f.axes.col(1), f.axes.col(2))};
    }
    [[nodiscard]] BeamRow row(std::size_t layer) const {
        const BeamTable& t = view.table();
        const std::size_t at = layer * t.stride();
        return {t.cosines.data(),
                t.sines.data(),
                &memory.distances[at],
                &memory.nearest[at],
                &memory.parts[at],
                0,
                static_cast<int>(t.count) - 1};
    }
    [[nodiscard]] bool isOwn(std::uint32_t actor) const { return actor == without && without != kNoGeom; }

    void plane(std::uint32_t index) {
        const Local local = localOf(scene.m_geoms[index]);
        for (std::size_t layer = 0; layer < view.table().layers.size(); ++layer) {
            const LocalBeams beams = local.of(view.table().layers[layer]);
            const double steepest = std::abs(beams.a[2]) + std::abs(beams.b[2]) + std::abs(beams.c[2]);
            if (std::abs(beams.origin[2]) <= view.fan().range * steepest * (1 + 1e-9))
                scene.cast(index, row(layer), beams, kNoRoots);
        }
    }

    void ball(const GeomBall& ball) {
        FanView::Aim aim;
        if (!view.aim(ball, aim)) return;
        const RayGeom& g = scene.m_geoms[ball.geom];
        if (aim.holds) aim.sector = view.sectorOf(g.centre, g.axes, g.half);
        const Local local = localOf(g);
        for (std::size_t layer = 0; layer < view.table().layers.size(); ++layer) {
            if (!view.crosses(layer, aim, ball.r)) continue;
            BeamRow beams = row(layer);
            const LocalBeams turned = local.of(view.table().layers[layer]);
            view.beamsIn(aim.sector, [&](int first, int last) {
                beams.first = first;
                beams.last = last;
                scene.cast(ball.geom, beams, turned, kNoRoots);
            });
        }
    }

    void mesh(std::uint32_t index) {
        const RayGeom& g = scene.m_geoms[index];
        const double far = view.fan().range + g.bound * (1 + 1e-9) + 1e-9;
        if (isOwn(g.actor) || !((g.centre - view.fan().origin).squaredNorm() <= far * far)) return;
        const Local local = localOf(g);
        const RayRoots roots = g.tree ? rootsOf(*g.tree, local.turned, view) : rootsOf(*g.shape.heights, local.turned, view);
        if (roots.count == 0) return;
        for (std::size_t layer = 0; layer < view.table().layers.size(); ++layer)
            scene.cast(index, row(layer), local.of(view.table().layers[layer]), roots);
    }

    void write(const RayHits& hits) const {
        const BeamTable& t = view.table();
        for (std::size_t layer = 0; layer < t.layers.size(); ++layer) {
            const std::size_t from = layer * t.stride(), at = layer * t.count;
            std::copy_n(&memory.distances[from], t.count, hits.distances + at);
            if (hits.geoms)
                for (std::uint32_t k = 0; k < t.count; ++k)
                    hits.geoms[at + k] = static_cast<std::uint32_t>(memory.nearest[from + k]);
            if (!hits.normals) continue;
            for (std::uint32_t k = 0; k < t.count; ++k)
                scene.writeNormal(memory.nearest[from + k], memory.parts[from + k], view.fan().origin,
                                  memory.distances[from + k] * (view.fan().axes * t.direction(layer, k)),
                                  hits.normals + 3 * (at + k));
        }
    }
};

void RayScene::castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const {
    FanMemory& memory = memoryOfThread();
    const BeamTable& table = memory.tables.of(fan);
    const std::size_t size = table.layers.size() * table.stride();
    memory.distances.assign(size, fan.range);
    memory.nearest.assign(size, double{kNoGeom});
    memory.parts.resize(size);
    FanCast cast{*this, memory, FanView(fan, table), without};
    for (const std::uint32_t plane : m_planes) cast.plane(plane);
    Vec3 lo, hi;
    cast.view.bounds(lo, hi);
    memory.candidates.resize(m_geoms.size() + 1);
    std::size_t count = 0; // without branches: which balls are in range cannot be foreseen
    const auto take = [&](const GeomBall& ball) {
        memory.candidates[count] = &ball;
        count += std::size_t{cast.view.reaches(ball)} * std::size_t{!cast.isOwn(ball.actor)};
    };
    m_still.near(lo.x(), hi.x(), lo.y(), hi.y(), take);
    m_moving.near(lo.x(), hi.x(), lo.y(), hi.y(), take);
    for (const GeomBall& large : m_large) take(large);
    for (std::size_t i = 0; i < count; ++i) cast.ball(*memory.candidates[i]);
    for (const std::uint32_t mesh : m_meshes) cast.mesh(mesh);
    cast.write(hits);
}

} // namespace trundle
