#pragma once
// What is worked out from a mesh: scaled copies, hulls, masses. Kept from one load to the next, so that an edit elsewhere in the text
// does not work it out again.

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "base/result.h"
#include "base/triangle_mesh.h"
#include "model/body_spec.h"

namespace trundle {

/// The answers are those of the functions themselves. A mesh is known by its address as long as somebody keeps it; nothing is kept
/// here that nobody else keeps, but masses. May be asked from several threads.
class MeshShapes {
public:
    using Mesh = std::shared_ptr<const TriangleMesh>;

    [[nodiscard]] Mesh scaled(const Mesh& mesh, const std::array<double, 3>& scale);
    /// Null where the points lie in one plane.
    [[nodiscard]] Mesh hull(const Mesh& mesh);
    [[nodiscard]] Result<MassProperties> solid(const Mesh& mesh);
    /// The mesh that a scaled copy or a hull was made from, or what that was made from; itself where it was made from none. Null where that
    /// is gone.
    [[nodiscard]] Mesh originalOf(const Mesh& shape);

private:
    struct Known {
        std::weak_ptr<const TriangleMesh> mesh, hull;
        std::map<std::array<double, 3>, std::weak_ptr<const TriangleMesh>> scaled;
        bool flat = false; ///< has no hull
        std::optional<Result<MassProperties>> solid;
    };
    Known& known(const Mesh& mesh);

    std::mutex m_mutex;
    std::map<const TriangleMesh*, Known> m_known;
};

} // namespace trundle
