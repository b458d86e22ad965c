#include "model/mesh_shapes.h"

#include <algorithm>

#include "model/convex_hull.h"
#include "model/mass_properties.h"

namespace trundle {

namespace {
constexpr std::size_t kMaxForgotten = 64; ///< cached meshes before expired ones are removed
} // namespace

MeshShapes::CachedShape& MeshShapes::known(const Mesh& mesh) {
    if (m_known.size() >= kMaxForgotten) std::erase_if(m_known, [](const auto& entry) { return entry.second.mesh.expired(); });
    CachedShape& known = m_known[mesh.get()];
    if (known.mesh.lock() == mesh) return known;
    known = {}; // the address was used by another mesh before
    known.mesh = mesh;
    return known;
}

MeshShapes::Mesh MeshShapes::scaled(const Mesh& mesh, const std::array<double, 3>& scale) {
    if (scale == std::array<double, 3>{1, 1, 1}) return mesh;
    const std::lock_guard lock(m_mutex);
    auto& all = known(mesh).scaled;
    if (Mesh kept = all[scale].lock()) return kept;
    std::erase_if(all, [](const auto& entry) { return entry.second.expired(); });
    auto made = std::make_shared<TriangleMesh>(*mesh);
    for (auto& p : made->points)
        for (std::size_t i = 0; i < 3; ++i) p[i] *= scale[i];
    if (scale[0] * scale[1] * scale[2] < 0) // or the image would be inside out
        reverseTriangles(*made, std::vector<bool>(made->triangles.size(), true));
    all[scale] = made;
    return made;
}

MeshShapes::Mesh MeshShapes::hull(const Mesh& mesh) {
    const std::lock_guard lock(m_mutex);
    CachedShape& shapes = known(mesh);
    if (shapes.flat) return nullptr;
    if (Mesh kept = shapes.hull.lock()) return kept;
    std::optional<TriangleMesh> hull = convexHull(mesh->points);
    shapes.flat = !hull;
    if (!hull) return nullptr;
    auto made = std::make_shared<const TriangleMesh>(std::move(*hull));
    shapes.hull = made;
    return made;
}

Result<MassProperties> MeshShapes::solid(const Mesh& mesh) {
    const std::lock_guard lock(m_mutex);
    CachedShape& shapes = known(mesh);
    if (!shapes.solid) shapes.solid = solidOf(*mesh);
    return *shapes.solid;
}

MeshShapes::Mesh MeshShapes::originalOf(const Mesh& shape) {
    const std::lock_guard lock(m_mutex);
    const auto isMadeFrom = [](const Mesh& made, const CachedShape& from) {
        const auto same = [&](const auto& copy) { return copy.second.lock() == made; };
        return from.hull.lock() == made || std::any_of(from.scaled.begin(), from.scaled.end(), same);
    };
    Mesh original = shape;
    for (auto at = m_known.begin(); original && at != m_known.end();) {
        const bool other = at->first != original.get() && isMadeFrom(original, at->second);
        if (other) original = at->second.mesh.lock();
        at = other ? m_known.begin() : std::next(at);
    }
    return original;
}

} // namespace trundle
