#pragma once
// Drawn shapes, shared by all scenes of a context: after an edit only what it changed is turned into triangles anew.

#include <map>
#include <span>
#include <string>
#include <vector>

#include <osg/Group>

#include "model/experiment_spec.h"
#include "scene/look.h"
#include "scene/pictures.h"
#include "scene/spokes.h"

namespace trundle {

/// Used on one thread, with the scenes.
class ShapeStore {
public:
    const Look look;
    Pictures pictures;

    /// One node for all sets of geoms that are drawn alike, whatever experiment they come from.
    [[nodiscard]] osg::ref_ptr<osg::Group> nodeOf(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                                  std::span<const SpokePattern> spokes = {});
    /// The shapes that collide, as coarse lines.
    [[nodiscard]] osg::ref_ptr<osg::Group> collisionNodeOf(std::span<const GeomSpec> geoms);
    /// Drops what no scene holds any more.
    void forgetUnused();
    void releaseGlObjects(osg::State* state);
    /// How many sets of geoms were turned into triangles so far.
    [[nodiscard]] std::size_t made() const { return m_made; }

private:
    std::map<std::string, osg::ref_ptr<osg::Group>> m_nodes; // by the bytes of all that is drawn
    std::size_t m_made = 0;
};

} // namespace trundle
