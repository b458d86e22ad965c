#pragma once
// Cache of drawn shapes, shared by all scenes of a context: after an edit only changed shapes are tessellated again.

#include <map>
#include <span>
#include <string>
#include <vector>

#include <osg/Group>

#include "model/experiment_spec.h"
#include "scene/nodes/pictures.h"
#include "scene/shaders/scene_shading.h"
#include "scene/shapes/spokes.h"

namespace trundle {

/// Used only on the thread that owns the scenes.
class ShapeStore {
public:
    const SceneShading look;
    Pictures pictures;

    /// One node for all sets of geoms that are drawn alike, in whatever experiment.
    [[nodiscard]] osg::ref_ptr<osg::Group> nodeOf(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                                  std::span<const SpokePattern> spokes = {});
    /// Collision shapes as coarse lines.
    [[nodiscard]] osg::ref_ptr<osg::Group> collisionNodeOf(std::span<const GeomSpec> geoms);
    /// Drops shapes that no scene uses any more.
    void forgetUnused();
    void releaseGlObjects(osg::State* state);
    /// Number of geom sets tessellated so far.
    [[nodiscard]] std::size_t made() const { return m_made; }

private:
    struct Shape {
        osg::ref_ptr<osg::Group> node;
        std::size_t points = 0; ///< about so many vertices in its finest level
    };

    std::map<std::string, Shape> m_shapes; // by Key
    std::size_t m_made = 0, m_points = 0;
};

} // namespace trundle
