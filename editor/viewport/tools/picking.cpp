#include "editor/viewport/tools/picking.h"

#include <algorithm>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr double kSamePlace = 5; // pixels

/// The objects that a box selects.
std::vector<ObjectRef> boxableObjects(const ViewportScene& world) {
    const std::vector<ObjectRef> instances = world.objects()->instances();
    if (!showsModel(world)) return instances;
    std::vector<ObjectRef> inside;
    for (const ObjectRef& object : instances) {
        const auto bodies = world.objects()->bodiesOf(object);
        const RobotSpec* robot = bodies ? &world.objects()->experiment().robots[*bodies] : nullptr;
        const StaticSpec* fixed = world.objects()->staticOf(object);
        for (std::uint32_t i = 0; robot && robot->config && i < robot->config->bodies.size(); ++i)
            inside.push_back({ObjectKind::Body, *bodies, i});
        for (std::uint32_t i = 0; fixed && fixed->geoms && i < fixed->geoms->size(); ++i)
            inside.push_back({ObjectKind::StaticGeom, object.instance, 0, i});
    }
    return inside;
}

} // namespace

std::vector<std::string> pickChain(const ViewportScene& world, const std::vector<RayHit>& hits) {
    std::vector<std::string> chain;
    const auto add = [&](const ObjectRef& object) {
        std::string path = world.objects()->pathOf(object);
        if (std::find(chain.begin(), chain.end(), path) == chain.end()) chain.push_back(std::move(path));
    };
    for (const RayHit& hit : hits) {
        const GeomSpec* geom = world.objects()->geomOf(hit.geom);
        if (chain.empty() && geom && geom->shape == GeomShape::Plane) chain.emplace_back();
        std::vector<ObjectRef> levels{hit.geom};
        while (const auto owner = world.objects()->ownerOf(levels.back())) levels.push_back(*owner);
        if (showsModel(world) && levels.size() > 1) levels.pop_back();
        for (auto level = levels.rbegin(); level != levels.rend(); ++level) add(*level);
    }
    return chain;
}

std::vector<std::string> boxPick(const ToolView& view, const QRectF& box) {
    const ViewportScene& world = view.context().world;
    std::vector<std::string> paths;
    for (const ObjectRef& object : boxableObjects(world)) {
        const Bounds bounds = world.boundsOf(object);
        if (bounds.empty() || world.isHidden(object) || world.isLocked(object)) continue;
        const auto isIn = [&](const Vec3& point) {
            const auto at = view.camera().pixelOf(point);
            return at && box.contains(*at);
        };
        bool taken = isIn(bounds.centre());
        for (int i = 0; i < 8 && taken && world.objects()->staticOf(object); ++i) taken = isIn(bounds.corner(i));
        if (taken) paths.push_back(world.objects()->pathOf(object));
    }
    return paths;
}

std::string PickCycle::next(const QPointF& at, std::vector<std::string> chain, const std::string& selected) {
    const bool again =
        (at - m_at).manhattanLength() <= kSamePlace && chain == m_chain && !chain.empty() && chain[m_index] == selected;
    m_index = again ? (m_index + 1) % chain.size() : 0;
    m_at = at;
    m_chain = std::move(chain);
    return m_chain.empty() ? std::string() : m_chain[m_index];
}

} // namespace trundle
