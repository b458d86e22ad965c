#include "scene/scene_picking.h"

#include <algorithm>

#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/masks.h"
#include "scene/nodes/osg_types.h"

namespace trundle {
namespace {

constexpr double kReach = 1e4; // m

/// Path of the hit geom (robot/body/geom or static/geom), from the names of the nodes above it.
std::string pathOf(const osgUtil::LineSegmentIntersector::Intersection& hit) {
    std::string path;
    for (const osg::Node* node : hit.nodePath) {
        if (!node->getName().empty()) path += (path.empty() ? "" : "/") + node->getName();
        const auto* names = dynamic_cast<const GeomNames*>(node->getUserData());
        const auto* ranges = hit.drawable ? dynamic_cast<const GeomRanges*>(hit.drawable->getUserData()) : nullptr;
        if (!names || !ranges || hit.indexList.empty()) continue;
        const std::uint32_t geom = ranges->geomOf(hit.indexList.front());
        if (geom < names->names.size()) path += "/" + names->names[geom];
    }
    return path;
}

} // namespace

std::vector<SceneHit> pickAll(osg::Node& scene, const ViewRay& ray, std::uint32_t mask) {
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line =
        new osgUtil::LineSegmentIntersector(toOsg(ray.origin), toOsg(Vec3(ray.origin + kReach * ray.direction)));
    osgUtil::IntersectionVisitor visitor(line);
    visitor.setTraversalMask(mask & (kMaskRobots | kMaskStatics | kMaskFloor));
    scene.accept(visitor);
    std::vector<SceneHit> hits;
    for (const auto& hit : line->getIntersections()) { // nearest first
        std::string path = pathOf(hit);
        if (std::any_of(hits.begin(), hits.end(), [&](const SceneHit& known) { return known.path == path; })) continue;
        const osg::Vec3d at = hit.getWorldIntersectPoint();
        const Vec3 point(at.x(), at.y(), at.z());
        hits.push_back({std::move(path), point, (point - ray.origin).norm()});
    }
    return hits;
}

} // namespace trundle
