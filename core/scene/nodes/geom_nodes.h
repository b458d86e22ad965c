#pragma once
// Draw nodes of geoms that move as one: merged by draw state, in several levels of detail.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <osg/Geometry>
#include <osg/Group>
#include <osg/MatrixTransform>

#include "model/experiment_spec.h"
#include "scene/nodes/geom_ranges.h"
#include "scene/nodes/pictures.h"
#include "scene/shaders/scene_shading.h"
#include "scene/shapes/flat_shadow.h"
#include "scene/shapes/spokes.h"

namespace trundle {

/// User data of a geom node: the names of its geoms.
struct GeomNames : osg::Referenced {
    std::vector<std::string> names;
};

/// Its children are the visible surfaces; their shadow caster is kept separately, since a shadow needs only the outline.
class GeomNode final : public osg::Group {
public:
    osg::ref_ptr<osg::Group> caster;     ///< all opaque geoms; may be null
    std::vector<ShadowSolid> solids;     ///< the convex ones of them
    osg::ref_ptr<osg::Group> openCaster; ///< the others; may be null

    void traverse(osg::NodeVisitor& visitor) override;
    void releaseGLObjects(osg::State* state) const override;
};

/// True while the visitor is below a ShadowTransform, which draws shadow casters.
[[nodiscard]] bool castsShadows(const osg::NodeVisitor& visitor);
/// True if any geom below the node casts a shadow and is not convex.
[[nodiscard]] bool hasOpenCasters(osg::Node& node);

/// True if some of it is drawn as transparent.
[[nodiscard]] bool hasClearParts(const osg::Group& geomNode);

/// A transform below which geom nodes draw their shadow casters.
class ShadowTransform final : public osg::MatrixTransform {
public:
    using osg::MatrixTransform::MatrixTransform;
    /// Disables culling: casters outside the view cast shadows too.
    void castEverywhere() {
        m_everywhere = true;
        setCullingActive(false);
    }
    /// Leaves out the convex geoms.
    void castOpenOnes() { m_openOnes = true; }
    void traverse(osg::NodeVisitor& visitor) override;

private:
    bool m_everywhere = false, m_openOnes = false;
};

/// How finely geoms are drawn from near by: 0 is the finest level.
struct GeomDetail {
    std::size_t level = 0;
    std::size_t points = 0; ///< about so many vertices
};
/// The finest one with at most so many vertices, else the coarsest one: ten thousand different balls would fill gigabytes.
[[nodiscard]] GeomDetail detailWithin(std::span<const GeomSpec> geoms, std::size_t points);

/// Shared by all bodies of all robots that have these geoms; an empty group if none is visible. Planes are left out, since they
/// are drawn as floors. Geoms with a spoke pattern are drawn with spokes.
[[nodiscard]] osg::ref_ptr<osg::Group> makeGeomNode(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                                    std::span<const SpokePattern> spokes, const SceneShading& look,
                                                    Pictures& pictures, std::size_t level = 0);
/// The same geoms as coarse shapes without materials, for outlines.
[[nodiscard]] osg::ref_ptr<osg::Group> makeOutlineNode(std::span<const GeomSpec> geoms);

/// Index of the geom with that name; nullopt if there is none.
[[nodiscard]] std::optional<std::uint32_t> geomNamed(const osg::Group& geomNode, std::string_view name);
/// A geom node with only the selected geoms. Vertices are shared with the full node.
[[nodiscard]] osg::ref_ptr<osg::Group> partOf(const osg::Group& geomNode, const std::function<bool(std::uint32_t geom)>& keep);

} // namespace trundle
