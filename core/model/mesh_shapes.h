#pragma once
// Cache of results computed from meshes: scaled copies, hulls, masses. Kept across loads, so that an unrelated edit does not
// compute them again.

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "base/result.h"
#include "base/triangle_mesh.h"
#include "model/body_spec.h"

namespace trundle {

/// Returns the same results as the uncached functions. Meshes are identified by address; only weak references are kept, so the
/// cache keeps no mesh alive. Thread-safe.
class MeshShapes {
public:
    using Mesh = std::shared_ptr<const TriangleMesh>;

    /// Negative factors give mirror images.
    [[nodiscard]] Mesh scaled(const Mesh& mesh, const std::array<double, 3>& scale);
    /// Null if the points are in one plane.
    [[nodiscard]] Mesh hull(const Mesh& mesh);
    [[nodiscard]] Result<MassProperties> solid(const Mesh& mesh);
    /// The mesh that a scaled copy or a hull was made from, followed back to the first one; `shape` itself if it was not made
    /// here. Null if the original no longer exists.
    [[nodiscard]] Mesh originalOf(const Mesh& shape);

private:
    struct CachedShape {
        std::weak_ptr<const TriangleMesh> mesh, hull;
        std::map<std::array<double, 3>, std::weak_ptr<const TriangleMesh>> scaled;
        bool flat = false; ///< has no hull
        std::optional<Result<MassProperties>> solid;
    };
    CachedShape& known(const Mesh& mesh);

    std::mutex m_mutex;
    std::map<const TriangleMesh*, CachedShape> m_known;
};

} // namespace trundle
