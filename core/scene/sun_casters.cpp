#include "scene/sun_casters.h"

#include <osg/ComputeBoundsVisitor>

#include "scene/nodes/masks.h"

namespace trundle {

const Bounds& SunCasters::localBox(osg::Group& shapes) {
    auto [own, isNew] = m_boxes.try_emplace(&shapes);
    if (isNew) {
        osg::ComputeBoundsVisitor visitor;
        visitor.setTraversalMask(kMaskRobots | kMaskStatics);
        shapes.accept(visitor);
        if (const osg::BoundingBox& box = visitor.getBoundingBox(); box.valid())
            own->second = {Vec3(box.xMin(), box.yMin(), box.zMin()), Vec3(box.xMax(), box.yMax(), box.zMax())};
    }
    return own->second;
}

std::vector<Bounds> SunCasters::boxes(const SceneObjects& objects) {
    std::vector<Bounds> boxes;
    for (const auto& [path, object] : objects.all()) {
        const osg::MatrixTransform* place = object.shapes ? object.transform() : nullptr;
        if (!place) continue;
        const Bounds& own = localBox(*object.shapes);
        Bounds world;
        for (int i = 0; i < 8 && !own.empty(); ++i) {
            const Vec3 corner = own.corner(i);
            const osg::Vec3d at = osg::Vec3d(corner.x(), corner.y(), corner.z()) * place->getMatrix();
            world.add(Vec3(at.x(), at.y(), at.z()));
        }
        if (!world.empty()) boxes.push_back(world);
    }
    return boxes;
}

} // namespace trundle
