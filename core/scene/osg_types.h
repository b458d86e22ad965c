#pragma once
// Between our types and OSG's. For the sources of scene only.

#include <osg/Drawable>
#include <osg/Matrixd>
#include <osg/Vec3>

#include <trundle/geometry.h>

namespace trundle {

[[nodiscard]] inline osg::Matrixd toOsg(const Pose& pose) {
    const Quat& q = pose.rotation;
    osg::Matrixd m = osg::Matrixd::rotate(osg::Quat(q.x(), q.y(), q.z(), q.w()));
    m.setTrans(pose.position.x(), pose.position.y(), pose.position.z());
    return m;
}
[[nodiscard]] inline osg::Vec3d toOsg(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Leaves a drawable out of the bounds of its scene.
struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

/// Stencil: the high two bits tell the floors that take shadows apart, each layer of shadow has one of the low six.
inline constexpr unsigned kShadowedFloors = 3, kFloorBits = 0xc0, kMostShadowLayers = 6;
[[nodiscard]] inline unsigned floorMark(unsigned index) { return index < kShadowedFloors ? (index + 1) << 6 : 0; }

} // namespace trundle
