#pragma once
// Conversions between Trundle's types and OSG's. For the sources of core/scene only.

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

/// Excludes a drawable from the bounds of its scene.
struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

/// Stencil layout: the two high bits number the floors that receive shadows; each of the six low bits is one shadow layer.
inline constexpr unsigned kShadowedFloors = 3, kFloorBits = 0xc0, kMaxShadowLayers = 6;
[[nodiscard]] inline unsigned floorMark(unsigned index) { return index < kShadowedFloors ? (index + 1) << 6 : 0; }

} // namespace trundle
