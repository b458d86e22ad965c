#pragma once
// Floors, sky and shadows: what surrounds the bodies.

#include <optional>
#include <vector>

#include <osg/Group>

#include "model/experiment_spec.h"
#include "scene/bounds.h"
#include "scene/lighting.h"
#include "scene/look.h"
#include "scene/pictures.h"

namespace trundle {

/// An endless plane of a static, in the world.
struct FloorPlane {
    Pose pose; ///< the plane is z = 0 of it
    std::array<double, 3> colour{0.6, 0.6, 0.6};
    std::shared_ptr<const Raster> picture; ///< in place of the colour
    double pictureScale = 1;               ///< pictures on each metre
    std::string path;                      ///< "arena/floor"
    [[nodiscard]] Vec3 normal() const { return pose.rotation * Vec3::UnitZ(); }
};

/// All visible planes, each only once where several statics bring the same one.
[[nodiscard]] std::vector<FloorPlane> floorPlanes(const ExperimentSpec& experiment);
/// The highest of them that is level, if any.
[[nodiscard]] std::optional<std::size_t> levelFloor(const std::vector<FloorPlane>& floors);

/// A quad so large that its edge is lost in the haze; its centre lies below the middle of `about`. `index` counts floors.
[[nodiscard]] osg::ref_ptr<osg::Node> makeFloorNode(const FloorPlane& floor, unsigned index, const Bounds& about, double reach,
                                                    const Look& look, Pictures& pictures, const Lighting& lighting);
/// The lines of a floor at z = 0, as large as one.
[[nodiscard]] osg::ref_ptr<osg::Node> makeGuideNode(const Bounds& about, double reach, const Look& look);
[[nodiscard]] osg::ref_ptr<osg::Node> makeSkyNode(const Look& look);
/// One triangle over the whole picture.
[[nodiscard]] osg::ref_ptr<osg::Node> makeWholeNode();
/// `casters` flattened onto the floor: one sharp shadow of the sun, and one of several layers that is soft; and those of lamps. Drawn
/// only on that floor.
[[nodiscard]] osg::ref_ptr<osg::Node> makeSharpShadow(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                      const Look& look, const Lighting& lighting);
[[nodiscard]] osg::ref_ptr<osg::Node> makeSoftShadow(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                     const Look& look, const Lighting& lighting);
[[nodiscard]] osg::ref_ptr<osg::Node> makeLampShadows(const FloorPlane& floor, unsigned index, osg::Group& casters,
                                                      const Look& look, const Lighting& lighting);

} // namespace trundle
