#include "scene/nodes/geom_pieces.h"

#include "base/mesh_appearance.h"
#include "scene/nodes/geom_ranges.h"
#include "scene/nodes/osg_types.h"
#include "scene/shapes/picture_map.h"

namespace trundle {
namespace {

/// Minimum opacity that casts a planar shadow; more transparent materials cast none, because a planar shadow is on or off.
constexpr double kLeastCasting = 0.5;

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

bool finite(const GeomSpec& g) {
    return g.pose.position.allFinite() && g.pose.rotation.coeffs().allFinite() && g.pose.position.norm() < 1e6;
}

MaterialSpec asMaterial(const MeshMaterial& own) {
    MaterialSpec material;
    material.colour = {own.colour[0], own.colour[1], own.colour[2]};
    material.emission = {own.emission[0], own.emission[1], own.emission[2]};
    material.opacity = own.opacity;
    material.shininess = own.shininess;
    material.picture = own.picture;
    return material;
}

} // namespace

/// Vertex data collected for one drawable.
struct GeomPieces::Batch {
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

void GeomPieces::Batch::add(const GeomSpec& geom, std::uint32_t index, const ShapeMesh& mesh, const MaterialSpec& material) {
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

osg::ref_ptr<osg::Geometry> GeomPieces::Batch::finish(osg::StateSet* state) const {
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

GeomPieces::GeomPieces(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                       std::span<const SpokePattern> spokes)
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

osg::ref_ptr<osg::Geometry> GeomPieces::merged(Fineness fineness, osg::StateSet* state, const Wanted& wanted) {
    Batch batch;
    for (const Piece& piece : m_all)
        if (wanted(m_geoms[piece.geom], piece.material)) add(batch, piece, fineness);
    return batch.points->empty() ? nullptr : batch.finish(state);
}

std::vector<ShadowSolid> GeomPieces::solids() const {
    std::vector<ShadowSolid> all;
    for (const Piece& piece : m_all) {
        if (piece.material.opacity < kLeastCasting) continue;
        if (std::optional<ShadowSolid> solid = shadowSolidOf(m_geoms[piece.geom], piece.geom)) all.push_back(*std::move(solid));
    }
    return all;
}

osg::ref_ptr<osg::Geometry> GeomPieces::bare(Fineness fineness, const SceneShading& look,
                                             std::span<const ShadowSolid> solids) const {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    osg::ref_ptr<GeomRanges> ranges = new GeomRanges;
    bool closed = true;
    for (const Piece& piece : m_all) {
        if (piece.material.opacity < kLeastCasting) continue;
        if (!ranges->ranges.empty() && ranges->ranges.back().geom == piece.geom) continue; // same mesh, other material
        if (std::any_of(solids.begin(), solids.end(), [&](const ShadowSolid& s) { return s.geom == piece.geom; })) continue;
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

std::vector<std::pair<std::shared_ptr<const Raster>, bool>> GeomPieces::pictures() const {
    std::vector<std::pair<std::shared_ptr<const Raster>, bool>> all;
    for (const Piece& piece : m_all) {
        if (!piece.material.picture) continue;
        const std::pair next(piece.material.picture, piece.material.opacity < 1);
        if (std::find(all.begin(), all.end(), next) == all.end()) all.push_back(next);
    }
    return all;
}

void GeomPieces::addParts(std::uint32_t index, const MeshAppearance& look) {
    std::vector<bool> used(look.materials.size(), false);
    for (const std::uint16_t material : look.material)
        if (material < used.size()) used[material] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) m_all.push_back({index, asMaterial(look.materials[i]), static_cast<std::uint16_t>(i)});
}

const ShapeMesh& GeomPieces::partOfMesh(const Piece& piece) {
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

void GeomPieces::add(Batch& batch, const Piece& piece, Fineness fineness) {
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

const SpokePattern* GeomPieces::patternOf(std::uint32_t geom) const {
    const auto it = std::find_if(m_spokes.begin(), m_spokes.end(), [&](const SpokePattern& p) { return p.geom == geom; });
    return it == m_spokes.end() ? nullptr : &*it;
}
void GeomPieces::addSpoked(Batch& batch, const Piece& piece, const SpokePattern& pattern, Fineness fineness) {
    const GeomSpec& geom = m_geoms[piece.geom];
    const auto parts = spokedShapeOf(geom, pattern, fineness);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!parts[i].indices.empty())
            batch.add(geom, piece.geom, parts[i], paintedMaterial(piece.material, static_cast<WheelPaint>(i)));
}

} // namespace trundle
