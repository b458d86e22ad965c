#include "scene/nodes/shape_store.h"

#include <algorithm>
#include <cstring>

#include "base/mesh_appearance.h"
#include "scene/nodes/geom_nodes.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr std::size_t kMostPoints = 8'000'000; // some 500 MB of vertices; what comes then is drawn coarsely

/// Bytes that identify a drawable: equal keys draw equally.
struct Key {
    std::string bytes;

    template <class T> void plain(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void number(double value) { plain(value); }
    void vector(const Vec3& v) {
        for (int i = 0; i < 3; ++i) plain(v[i]);
    }
    template <class T> void array(const std::vector<T>& values) {
        std::uint64_t hash = 0xcbf29ce484222325ull;
        const auto* data = reinterpret_cast<const unsigned char*>(values.data());
        const std::size_t size = values.size() * sizeof(T);
        std::size_t i = 0;
        for (; i + 8 <= size; i += 8) {
            std::uint64_t word;
            std::memcpy(&word, data + i, 8);
            hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 29;
        }
        for (; i < size; ++i) hash = (hash ^ data[i]) * 0x100000001b3ull;
        plain(size);
        plain(hash);
    }
};

void addShape(Key& key, const GeomSpec& g) {
    key.plain(g.shape);
    key.vector(g.pose.position);
    for (int i = 0; i < 4; ++i) key.number(g.pose.rotation.coeffs()[i]);
    key.vector(g.size);
    key.number(g.radius);
    key.number(g.length);
    key.plain(bool(g.mesh));
    if (g.mesh) key.array(g.mesh->points), key.array(g.mesh->triangles);
    key.plain(bool(g.heightMap));
    if (g.heightMap) key.plain(g.heightMap->columns), key.plain(g.heightMap->rows), key.array(g.heightMap->heights);
}

void addMaterial(Key& key, const MaterialSpec& m) {
    for (const double c : m.colour) key.number(c);
    for (const double c : m.emission) key.number(c);
    key.number(m.opacity);
    key.number(m.shininess);
    key.plain(m.picture.get()); // kept alive by the cached node, so the address stays unique
    if (!m.picture) return;
    key.number(m.textureScale);
    key.bytes += m.textureMap + '\n';
}

void addAppearance(Key& key, const MeshAppearance& look) {
    key.array(look.material), key.array(look.onPicture);
    for (const MeshMaterial& m : look.materials) {
        for (int i = 0; i < 3; ++i) key.plain(m.colour[std::size_t(i)]), key.plain(m.emission[std::size_t(i)]);
        key.plain(m.opacity), key.plain(m.shininess);
        key.plain(m.picture.get());
    }
}

} // namespace

osg::ref_ptr<osg::Group> ShapeStore::nodeOf(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                            std::span<const SpokePattern> spokes) {
    static const MaterialSpec kPlain;
    Key key;
    for (const GeomSpec& g : geoms) {
        key.bytes += g.name + '\n';
        key.plain(g.visible);
        addShape(key, g);
        addMaterial(key, g.material < materials.size() ? materials[g.material] : kPlain);
        if (hasOwnAppearance(g)) addAppearance(key, *g.mesh->look);
    }
    for (const SpokePattern& s : spokes) key.plain(s.geom), key.vector(s.axis), key.plain(s.top), key.plain(s.bottom);
    auto [entry, isNew] = m_shapes.try_emplace(std::move(key.bytes));
    if (isNew) {
        const GeomDetail detail = detailWithin(geoms, kMostPoints - std::min(m_points, kMostPoints));
        entry->second = {makeGeomNode(geoms, materials, spokes, look, pictures, detail.level), detail.points};
        m_points += detail.points;
        ++m_made;
    }
    return entry->second.node;
}

osg::ref_ptr<osg::Group> ShapeStore::collisionNodeOf(std::span<const GeomSpec> geoms) {
    std::vector<GeomSpec> shapes;
    for (GeomSpec g : geoms) {
        if (!g.collide) continue;
        if (g.collideAsHull && g.hull) g.mesh = g.hull;
        g.visible = true;
        shapes.push_back(std::move(g));
    }
    Key key;
    key.bytes = "collision\n";
    for (const GeomSpec& g : shapes) addShape(key, g);
    auto [entry, isNew] = m_shapes.try_emplace(std::move(key.bytes));
    if (isNew) entry->second.node = makeOutlineNode(shapes);
    return entry->second.node;
}

void ShapeStore::forgetUnused() {
    std::erase_if(m_shapes, [this](const auto& entry) {
        const bool isUnused = entry.second.node->referenceCount() == 1;
        if (isUnused) m_points -= entry.second.points;
        return isUnused;
    });
    pictures.forgetUnused();
}

void ShapeStore::releaseGlObjects(osg::State* state) {
    for (auto& [key, shape] : m_shapes) shape.node->releaseGLObjects(state);
}

} // namespace trundle
