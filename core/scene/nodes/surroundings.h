#pragma once
// Floors, sky and planar shadows.

#include <optional>
#include <vector>

#include <osg/Group>

#include "model/experiment_spec.h"
#include "scene/nodes/lighting.h"
#include "scene/nodes/pictures.h"
#include "scene/shaders/scene_shading.h"
#include "scene/shapes/bounds.h"

namespace trundle {

/// An infinite plane of a static, in world coordinates.
struct FloorPlane {
    Pose pose; ///< the plane is z = 0 of this frame
    std::array<double, 3> colour{0.6, 0.6, 0.6};
    std::shared_ptr<const Raster> picture; ///< texture; replaces the colour
    double pictureScale = 1;               ///< repetitions per metre
    std::string path;                      ///< "arena/floor"
    [[nodiscard]] Vec3 normal() const { return pose.rotation * Vec3::UnitZ(); }
};

/// All visible planes; a plane that several statics share is listed once.
[[nodiscard]] std::vector<FloorPlane> floorPlanes(const ExperimentSpec& experiment);
/// Index of the highest level floor, if any.
[[nodiscard]] std::optional<std::size_t> levelFloor(const std::vector<FloorPlane>& floors);

/// A quad so large that its edge disappears in the haze, centred below the middle of `about`. `index`: number of the floor.
[[nodiscard]] osg::ref_ptr<osg::Node> makeFloorNode(const FloorPlane& floor, unsigned index, const Bounds& about, double reach,
                                                    const SceneShading& look, Pictures& pictures, const Lighting& lighting);
/// Grid lines of a floor at z = 0, as large as a floor.
[[nodiscard]] osg::ref_ptr<osg::Node> makeGuideNode(const Bounds& about, double reach, const SceneShading& look);
[[nodiscard]] osg::ref_ptr<osg::Node> makeSkyNode(const SceneShading& look);
/// One triangle that covers the whole image.
[[nodiscard]] osg::ref_ptr<osg::Node> makeWholeNode();
/// `casters` flattened onto the floor and drawn only there: one hard shadow of the sun, a soft one of several layers, and the
/// shadows of lamps.
[[nodiscard]] osg::ref_ptr<osg::Node> makeSharpShadow(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                      const SceneShading& look, const Lighting& lighting);
[[nodiscard]] osg::ref_ptr<osg::Node> makeSoftShadow(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                     const SceneShading& look, const Lighting& lighting);
[[nodiscard]] osg::ref_ptr<osg::Node> makeLampShadows(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                      const SceneShading& look, const Lighting& lighting);

} // namespace trundle
