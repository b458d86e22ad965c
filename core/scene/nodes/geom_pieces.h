#pragma once
// The visible parts of geoms that move as one, as drawables and as casters of shadows.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <osg/Geometry>

#include "model/experiment_spec.h"
#include "scene/shaders/scene_shading.h"
#include "scene/shapes/flat_shadow.h"
#include "scene/shapes/shape_mesh.h"
#include "scene/shapes/spokes.h"

namespace trundle {

/// False for meshes and height maps.
[[nodiscard]] bool isRound(const GeomSpec& geom);

class GeomPieces {
public:
    using Wanted = std::function<bool(const GeomSpec&, const MaterialSpec&)>;

    /// The geoms and spokes must outlive it.
    GeomPieces(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
               std::span<const SpokePattern> spokes = {});
    /// The pieces accepted by `wanted` as one drawable; null if there are none.
    [[nodiscard]] osg::ref_ptr<osg::Geometry> merged(Fineness fineness, osg::StateSet* state, const Wanted& wanted);
    /// The opaque convex geoms.
    [[nodiscard]] std::vector<ShadowSolid> solids() const;
    /// Shadow caster of the opaque pieces, without the geoms of `solids`; null if there are none.
    [[nodiscard]] osg::ref_ptr<osg::Geometry> bare(Fineness fineness, const SceneShading& look,
                                                   std::span<const ShadowSolid> solids) const;
    /// Each texture once, in the order of the geoms, and whether the material using it is transparent.
    [[nodiscard]] std::vector<std::pair<std::shared_ptr<const Raster>, bool>> pictures() const;

private:
    struct Batch;
    /// A geom, or the triangles of one material of a mesh that has materials of its own.
    struct Piece {
        std::uint32_t geom = 0;
        MaterialSpec material;
        std::optional<std::uint16_t> part; ///< material index in the mesh
    };
    void addParts(std::uint32_t index, const MeshAppearance& look);
    /// The triangles of a mesh that use one material; the mesh is split once.
    const ShapeMesh& partOfMesh(const Piece& piece);
    void add(Batch& batch, const Piece& piece, Fineness fineness);
    [[nodiscard]] const SpokePattern* patternOf(std::uint32_t geom) const;
    void addSpoked(Batch& batch, const Piece& piece, const SpokePattern& pattern, Fineness fineness);

    std::span<const GeomSpec> m_geoms;
    std::span<const SpokePattern> m_spokes;
    std::vector<Piece> m_all;
    std::map<std::uint32_t, std::vector<ShapeMesh>> m_meshes; // by geom, then by material
};

} // namespace trundle
