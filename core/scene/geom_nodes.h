#pragma once
// What is drawn for a set of geoms that move as one: merged by the way they are drawn, in several degrees of detail.

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
#include "scene/look.h"
#include "scene/pictures.h"
#include "scene/spokes.h"

namespace trundle {

/// Remembered on a drawable: which geom each of its vertices belongs to, so that a hit can be named.
struct GeomRanges : osg::Referenced {
    struct Range {
        std::uint32_t firstVertex, geom;
    };
    std::vector<Range> ranges; ///< ascending
    [[nodiscard]] std::uint32_t geomOf(std::uint32_t vertex) const;
};

/// Remembered on a geom node: the names of its geoms.
struct GeomNames : osg::Referenced {
    std::vector<std::string> names;
};

/// What lights up in a picture are its children; what casts their shadows is kept beside them, as a shadow shows an outline only.
class GeomNode final : public osg::Group {
public:
    osg::ref_ptr<osg::Group> caster; ///< may be null

    void traverse(osg::NodeVisitor& visitor) override;
    void releaseGLObjects(osg::State* state) const override;
};

/// Whether what is drawn now are shadows, below a ShadowTransform.
[[nodiscard]] bool castsShadows(const osg::NodeVisitor& visitor);

/// A transform below which geom nodes show what casts their shadows.
class ShadowTransform final : public osg::MatrixTransform {
public:
    using osg::MatrixTransform::MatrixTransform;
    /// What is out of sight casts one too.
    void castEverywhere() {
        m_everywhere = true;
        setCullingActive(false);
    }
    void traverse(osg::NodeVisitor& visitor) override;

private:
    bool m_everywhere = false;
};

/// Shared by every body, in any robot, that has these geoms. Empty group where none is visible.
/// Planes are left out: they are floors. Geoms with a pattern are drawn with spokes.
[[nodiscard]] osg::ref_ptr<osg::Group> makeGeomNode(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                                    std::span<const SpokePattern> spokes, const Look& look, Pictures& pictures);
/// The same geoms without a look of their own and coarse, for lines.
[[nodiscard]] osg::ref_ptr<osg::Group> makeOutlineNode(std::span<const GeomSpec> geoms);

/// Which geom of a geom node has a name.
[[nodiscard]] std::optional<std::uint32_t> geomNamed(const osg::Group& geomNode, std::string_view name);
/// A geom node with some of its geoms only. Vertices are shared with the whole one.
[[nodiscard]] osg::ref_ptr<osg::Group> partOf(const osg::Group& geomNode, const std::function<bool(std::uint32_t geom)>& keep);

} // namespace trundle
