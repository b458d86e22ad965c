#include "scene/nodes/geom_nodes.h"

#include <map>

#include <osg/LOD>
#include <osgUtil/CullVisitor>

#include "base/mesh_appearance.h"
#include "scene/nodes/masks.h"
#include "scene/nodes/osg_types.h"
#include "scene/shapes/picture_map.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

/// Level of detail for objects up to `pixels` in diameter on the screen.
struct Degree {
    float pixels;
    int segments;
    bool bevel;
};
constexpr float kAnyPixels = 1e9f;
constexpr std::array<Degree, 6> kDegrees{
    {{kAnyPixels, 96, true}, {1600, 36, true}, {170, 18, true}, {64, 14, false}, {20, 8, false}, {8, 6, false}}};
constexpr Fineness kFine{36, true}, kOutline{10, false};

/// Minimum opacity that casts a planar shadow; more transparent materials cast none, because a planar shadow is on or off.
constexpr double kLeastCasting = 0.5;

/// User data that ShadowTransform passes to the visitor for the nodes below it.
struct Casting : osg::Referenced {};

/// Vertex data collected for one drawable.
struct Batch {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array, normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> colours = new osg::Vec4ubArray;
    osg::ref_ptr<osg::Vec4Array> glow = new osg::Vec4Array;
    osg::ref_ptr<osg::FloatArray> layers = new osg::FloatArray;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    osg::ref_ptr<GeomRanges> ranges = new GeomRanges;
    osg::ref_ptr<osg::Vec2Array> onPicture = new osg::Vec2Array; // texture coordinates; empty, or one per point

    void add(const GeomSpec& geom, std::uint32_t index, const ShapeMesh& mesh, const MaterialSpec& material);
    [[nodiscard]] osg::ref_ptr<osg::Geometry> finish(osg::StateSet* state) const;
};

std::uint8_t byteOf(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

const MaterialSpec& placeholderMaterial() {
    static const MaterialSpec material = [] {
        MaterialSpec m;
        m.colour = {1, 0, 1};
        m.emission = {0.5, 0, 0.5};
        return m;
    }();
    return material;
}

/// Unshares the vertices: each triangle gets its own, since adjacent triangles may use different parts of the texture.
ShapeMesh apart(const ShapeMesh& mesh) {
    ShapeMesh result;
    for (const std::uint32_t i : mesh.indices) {
        result.indices.push_back(static_cast<std::uint32_t>(result.points.size()));
        result.points.push_back(mesh.points[i]);
        result.normals.push_back(mesh.normals[i]);
    }
    return result;
}

void Batch::add(const GeomSpec& geom, std::uint32_t index, const ShapeMesh& mesh, const MaterialSpec& material) {
    const auto first = static_cast<std::uint32_t>(points->size());
    ranges->ranges.push_back({first, index});
    const Mat3 turn = geom.pose.rotation.toRotationMatrix();
    const osg::Vec4ub colour(byteOf(material.colour[0]), byteOf(material.colour[1]), byteOf(material.colour[2]),
                             byteOf(material.opacity));
    const auto share = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    const osg::Vec4 light(share(material.emission[0]), share(material.emission[1]), share(material.emission[2]),
                          share(material.shininess));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3 p = geom.pose.position + turn * mesh.points[i].cast<double>();
        const Vec3 n = turn * mesh.normals[i].cast<double>();
        points->push_back(osg::Vec3(p.x(), p.y(), p.z()));
        normals->push_back(osg::Vec3(n.x(), n.y(), n.z()));
        colours->push_back(colour);
        glow->push_back(light);
        layers->push_back(static_cast<float>(index));
    }
    for (const std::uint32_t i : mesh.indices) triangles->push_back(first + i);
}

osg::ref_ptr<osg::Geometry> Batch::finish(osg::StateSet* state) const {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(points);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    colours->setNormalize(true);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(kGlowUnit, glow, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(kLayerUnit, layers, osg::Array::BIND_PER_VERTEX);
    if (!onPicture->empty()) geometry->setTexCoordArray(kPictureUnit, onPicture, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(triangles);
    geometry->setStateSet(state);
    geometry->setUserData(ranges);
    return geometry;
}

bool isRound(const GeomSpec& g) {
    return g.shape != GeomShape::Mesh && g.shape != GeomShape::Convex && g.shape != GeomShape::Heightfield;
}
bool finite(const GeomSpec& g) {
    return g.pose.position.allFinite() && g.pose.rotation.coeffs().allFinite() && g.pose.position.norm() < 1e6;
}

/// A geom, or the triangles of one material of a mesh that has materials of its own.
struct Piece {
    std::uint32_t geom = 0;
    MaterialSpec material;
    std::optional<std::uint16_t> part; ///< material index in the mesh
};

MaterialSpec asMaterial(const MeshMaterial& own) {
    MaterialSpec material;
    material.colour = {own.colour[0], own.colour[1], own.colour[2]};
    material.emission = {own.emission[0], own.emission[1], own.emission[2]};
    material.opacity = own.opacity;
    material.shininess = own.shininess;
    material.picture = own.picture;
    return material;
}

/// The visible parts of a set of geoms.
class Pieces {
public:
    Pieces(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials, std::span<const SpokePattern> spokes = {})
        : m_geoms(geoms), m_spokes(spokes) {
        for (std::uint32_t i = 0; i < geoms.size(); ++i) {
            const GeomSpec& geom = geoms[i];
            if (!geom.visible || geom.shape == GeomShape::Plane || !finite(geom)) continue;
            if (isPlaceholder(geom)) m_all.push_back({i, placeholderMaterial(), {}});
            else if (hasOwnAppearance(geom)) addParts(i, *geom.mesh->look);
            else m_all.push_back({i, geom.material < materials.size() ? materials[geom.material] : MaterialSpec{}, {}});
        }
        std::erase_if(m_all, [](const Piece& piece) { return !(piece.material.opacity > 0); }); // invisible, in camera images too
    }

    /// The pieces accepted by `wanted` as one drawable; null if there are none.
    template <class Wanted> osg::ref_ptr<osg::Geometry> merged(Fineness fineness, osg::StateSet* state, Wanted wanted) {
        Batch batch;
        for (const Piece& piece : m_all)
            if (wanted(m_geoms[piece.geom], piece.material)) add(batch, piece, fineness);
        return batch.points->empty() ? nullptr : batch.finish(state);
    }

    /// Shadow caster of all opaque pieces; null if there are none.
    [[nodiscard]] osg::ref_ptr<osg::Geometry> bare(Fineness fineness, const SceneShading& look) const {
        osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
        osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
        osg::ref_ptr<GeomRanges> ranges = new GeomRanges;
        bool closed = true;
        for (const Piece& piece : m_all) {
            if (piece.material.opacity < kLeastCasting) continue;
            if (!ranges->ranges.empty() && ranges->ranges.back().geom == piece.geom) continue; // same mesh, other material
            const GeomSpec& geom = m_geoms[piece.geom];
            const auto first = static_cast<std::uint32_t>(points->size());
            ranges->ranges.push_back({first, piece.geom});
            closed = closed && isRound(geom);
            const ShapeMesh mesh = bareShapeOf(geom, fineness);
            for (const Eigen::Vector3f& point : mesh.points) points->push_back(toOsg(geom.pose * point.cast<double>()));
            for (const std::uint32_t i : mesh.indices) triangles->push_back(first + i);
        }
        if (triangles->empty()) return nullptr;
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(points);
        geometry->addPrimitiveSet(triangles);
        geometry->setUserData(ranges);
        if (!closed) geometry->setStateSet(look.openCasters);
        return geometry;
    }

    /// Each texture once, in the order of the geoms, and whether the material using it is transparent.
    [[nodiscard]] std::vector<std::pair<std::shared_ptr<const Raster>, bool>> pictures() const {
        std::vector<std::pair<std::shared_ptr<const Raster>, bool>> all;
        for (const Piece& piece : m_all) {
            if (!piece.material.picture) continue;
            const std::pair next(piece.material.picture, piece.material.opacity < 1);
            if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
        }
        return all;
    }

private:
    void addParts(std::uint32_t index, const MeshAppearance& look) {
        std::vector<bool> used(look.materials.size(), false);
        for (const std::uint16_t material : look.material)
            if (material < used.size()) used[material] = true;
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i]) m_all.push_back({index, asMaterial(look.materials[i]), static_cast<std::uint16_t>(i)});
    }

    /// The triangles of a mesh that use one material; the mesh is split once.
    const ShapeMesh& partOfMesh(const Piece& piece) {
        auto [whole, isNew] = m_meshes.try_emplace(piece.geom);
        const MeshAppearance& look = *m_geoms[piece.geom].mesh->look;
        if (isNew) {
            const ShapeMesh all = smoothedMesh(*m_geoms[piece.geom].mesh);
            whole->second.resize(look.materials.size());
            for (std::size_t t = 0; t < all.sources.size(); ++t) {
                ShapeMesh& part = whole->second[look.material[all.sources[t]]];
                part.sources.push_back(all.sources[t]);
                for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
                    part.indices.push_back(static_cast<std::uint32_t>(part.points.size()));
                    part.points.push_back(all.points[all.indices[k]]);
                    part.normals.push_back(all.normals[all.indices[k]]);
                }
            }
        }
        return whole->second[*piece.part];
    }

    void add(Batch& batch, const Piece& piece, Fineness fineness) {
        const GeomSpec& geom = m_geoms[piece.geom];
        const MaterialSpec& material = piece.material;
        if (piece.part) {
            const ShapeMesh& mesh = partOfMesh(piece);
            batch.add(geom, piece.geom, mesh, material);
            if (!material.picture) return;
            for (const std::uint32_t source : mesh.sources)
                for (const auto& corner : geom.mesh->look->onPicture[source]) batch.onPicture->push_back({corner[0], corner[1]});
            return;
        }
        if (const SpokePattern* pattern = patternOf(piece.geom)) return addSpoked(batch, piece, *pattern, fineness);
        const ShapeMesh mesh = shapeOf(geom, fineness);
        if (mesh.indices.empty()) return;
        if (!material.picture) return batch.add(geom, piece.geom, mesh, material);
        batch.add(geom, piece.geom, apart(mesh), material);
        const PictureMap map = pictureMapOf(material.textureMap, geom.shape);
        for (const Eigen::Vector2f& at : pictureCoordinates(mesh, map, material.textureScale))
            batch.onPicture->push_back({at.x(), at.y()});
    }

    [[nodiscard]] const SpokePattern* patternOf(std::uint32_t geom) const {
        const auto it = std::find_if(m_spokes.begin(), m_spokes.end(), [&](const SpokePattern& p) { return p.geom == geom; });
        return it == m_spokes.end() ? nullptr : &*it;
    }
    void addSpoked(Batch& batch, const Piece& piece, const SpokePattern& pattern, Fineness fineness) {
        const GeomSpec& geom = m_geoms[piece.geom];
        const auto parts = spokedShapeOf(geom, pattern, fineness);
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (!parts[i].indices.empty())
                batch.add(geom, piece.geom, parts[i], paintedMaterial(piece.material, static_cast<WheelPaint>(i)));
    }

    std::span<const GeomSpec> m_geoms;
    std::span<const SpokePattern> m_spokes;
    std::vector<Piece> m_all;
    std::map<std::uint32_t, std::vector<ShapeMesh>> m_meshes; // by geom, then by material
};

/// All levels of detail from one on; null if `make` gives nothing.
template <class Make> osg::ref_ptr<osg::LOD> detailOf(std::size_t first, Make make) {
    const osg::ref_ptr<osg::Geometry> fine = make({kDegrees[first].segments, kDegrees[first].bevel});
    if (!fine) return nullptr;
    const double across = 2 * fine->getBound().radius();
    osg::ref_ptr<osg::LOD> detail = new osg::LOD;
    detail->setRangeMode(osg::LOD::PIXEL_SIZE_ON_SCREEN);
    for (std::size_t i = first; i < kDegrees.size(); ++i) {
        const Degree& degree = kDegrees[i];
        const float least = i + 1 < kDegrees.size() ? kDegrees[i + 1].pixels : 0;
        detail->addChild(i == first ? fine : make({degree.segments, degree.bevel, across > 0 ? degree.pixels / across : 0}), least,
                         i == first ? kAnyPixels : degree.pixels);
    }
    return detail;
}

/// About the number of vertices of a shape.
std::size_t pointsOf(const GeomSpec& geom, std::size_t segments) {
    switch (geom.shape) {
    case GeomShape::Sphere:
    case GeomShape::Capsule: return segments * segments / 2;
    case GeomShape::Cylinder: return 20 * segments;
    default: return 100; // meshes have one level only
    }
}

osg::ref_ptr<osg::Geometry> partOf(const osg::Geometry& whole, const std::function<bool(std::uint32_t)>& keep) {
    osg::ref_ptr<osg::Geometry> part = new osg::Geometry(whole, osg::CopyOp::SHALLOW_COPY);
    part->removePrimitiveSet(0, part->getNumPrimitiveSets());
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    const auto* ranges = dynamic_cast<const GeomRanges*>(whole.getUserData());
    const auto* all =
        whole.getNumPrimitiveSets() ? dynamic_cast<const osg::DrawElementsUInt*>(whole.getPrimitiveSet(0)) : nullptr;
    if (ranges && all) {
        for (std::size_t i = 0; i + 2 < all->size(); i += 3) {
            if (keep(ranges->geomOf((*all)[i])))
                triangles->insert(triangles->end(), all->begin() + long(i), all->begin() + long(i) + 3);
        }
    }
    part->addPrimitiveSet(triangles);
    return part;
}

} // namespace

bool castsShadows(const osg::NodeVisitor& visitor) { return dynamic_cast<const Casting*>(visitor.getUserData()); }

void GeomNode::traverse(osg::NodeVisitor& visitor) {
    if (!castsShadows(visitor)) return osg::Group::traverse(visitor);
    if (caster) caster->accept(visitor);
}

void GeomNode::releaseGLObjects(osg::State* state) const {
    osg::Group::releaseGLObjects(state);
    if (caster) caster->releaseGLObjects(state);
}

void ShadowTransform::traverse(osg::NodeVisitor& visitor) {
    static const osg::ref_ptr<Casting> casting = new Casting;
    const osg::ref_ptr<osg::Referenced> before = visitor.getUserData();
    visitor.setUserData(casting);
    if (auto* cull = m_everywhere ? visitor.asCullVisitor() : nullptr) {
        // Transforms below inherit the culling set of the projection; this transform's own set is already active.
        osg::CullingSet& seen = cull->getProjectionCullingStack().back();
        const osg::CullingSet::Mask mask = seen.getCullingMask();
        seen.setCullingMask(osg::CullingSet::NO_CULLING);
        cull->getCurrentCullingSet().setCullingMask(osg::CullingSet::NO_CULLING);
        osg::MatrixTransform::traverse(visitor);
        seen.setCullingMask(mask);
    } else {
        osg::MatrixTransform::traverse(visitor);
    }
    visitor.setUserData(before);
}

std::uint32_t GeomRanges::geomOf(std::uint32_t vertex) const {
    const auto after =
        std::upper_bound(ranges.begin(), ranges.end(), vertex, [](std::uint32_t v, const Range& r) { return v < r.firstVertex; });
    return after == ranges.begin() ? 0 : std::prev(after)->geom;
}

GeomDetail detailWithin(std::span<const GeomSpec> geoms, std::size_t points) {
    GeomDetail detail;
    for (;; ++detail.level) {
        detail.points = 0;
        for (const GeomSpec& geom : geoms) detail.points += pointsOf(geom, std::size_t(kDegrees[detail.level].segments));
        if (detail.points <= points || detail.level + 1 == kDegrees.size()) return detail;
    }
}

osg::ref_ptr<osg::Group> makeGeomNode(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                      std::span<const SpokePattern> spokes, const SceneShading& look, Pictures& pictures,
                                      std::size_t level) {
    osg::ref_ptr<GeomNode> group = new GeomNode;
    osg::ref_ptr<GeomNames> names = new GeomNames;
    for (const GeomSpec& geom : geoms) names->names.push_back(geom.name);
    group->setUserData(names);
    const auto isClear = [](const MaterialSpec& m) { return m.opacity < 1; };
    Pieces pieces(geoms, materials, spokes);
    const auto addWhole = [&](const osg::ref_ptr<osg::Node>& drawable, bool clear = false) {
        if (!drawable) return;
        if (clear) drawable->setNodeMask(~unsigned(kMaskSolid | kMaskFloor)); // these two masks are always used together
        group->addChild(drawable);
    };
    addWhole(detailOf(level, [&](Fineness fineness) {
        return pieces.merged(fineness, look.bodies,
                             [&](const GeomSpec& g, const MaterialSpec& m) { return !m.picture && !isClear(m) && isRound(g); });
    }));
    addWhole(pieces.merged(kFine, look.surfaces,
                           [&](const GeomSpec& g, const MaterialSpec& m) { return !m.picture && !isClear(m) && !isRound(g); }));
    addWhole(pieces.merged(kFine, look.clear, [&](const GeomSpec&, const MaterialSpec& m) { return !m.picture && isClear(m); }),
             true);
    for (const auto& [picture, clearOnes] : pieces.pictures()) {
        const osg::ref_ptr<osg::StateSet> state = pictures.stateFor(picture, clearOnes, look);
        const auto wears = [&, picture = picture, clearOnes = clearOnes](const MaterialSpec& m) {
            return m.picture == picture && isClear(m) == clearOnes;
        };
        addWhole(detailOf(level, [&](Fineness fineness) {
                     return pieces.merged(fineness, state,
                                          [&](const GeomSpec& g, const MaterialSpec& m) { return wears(m) && isRound(g); });
                 }),
                 clearOnes);
        addWhole(pieces.merged(kFine, state, [&](const GeomSpec& g, const MaterialSpec& m) { return wears(m) && !isRound(g); }),
                 clearOnes);
    }
    group->caster = detailOf(level, [&](Fineness fineness) { return pieces.bare(fineness, look); });
    return group;
}

osg::ref_ptr<osg::Group> makeOutlineNode(std::span<const GeomSpec> geoms) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    Pieces pieces(geoms, {});
    if (const auto lines = pieces.merged(kOutline, nullptr, [](const GeomSpec&, const MaterialSpec&) { return true; }))
        group->addChild(lines);
    return group;
}

std::optional<std::uint32_t> geomNamed(const osg::Group& geomNode, std::string_view name) {
    const auto* names = dynamic_cast<const GeomNames*>(geomNode.getUserData());
    if (!names) return std::nullopt;
    const auto it = std::find(names->names.begin(), names->names.end(), name);
    if (it == names->names.end()) return std::nullopt;
    return static_cast<std::uint32_t>(it - names->names.begin());
}

osg::ref_ptr<osg::Group> partOf(const osg::Group& geomNode, const std::function<bool(std::uint32_t)>& keep) {
    osg::ref_ptr<osg::Group> part;
    if (const auto* detail = dynamic_cast<const osg::LOD*>(&geomNode)) {
        osg::ref_ptr<osg::LOD> copy = new osg::LOD;
        copy->setRangeMode(detail->getRangeMode());
        copy->setRangeList(detail->getRangeList());
        part = copy;
    } else if (const auto* node = dynamic_cast<const GeomNode*>(&geomNode); node && node->caster) {
        osg::ref_ptr<GeomNode> copy = new GeomNode;
        copy->caster = partOf(*node->caster, keep);
        part = copy;
    } else {
        part = new osg::Group;
    }
    part->setUserData(const_cast<osg::Referenced*>(geomNode.getUserData()));
    part->setNodeMask(geomNode.getNodeMask());
    for (unsigned i = 0; i < geomNode.getNumChildren(); ++i) {
        const osg::Node* child = geomNode.getChild(i);
        if (const auto* geometry = dynamic_cast<const osg::Geometry*>(child)) {
            part->osg::Group::addChild(partOf(*geometry, keep));
        } else if (const auto* group = dynamic_cast<const osg::Group*>(child)) {
            part->osg::Group::addChild(partOf(*group, keep));
        }
    }
    return part;
}

} // namespace trundle
