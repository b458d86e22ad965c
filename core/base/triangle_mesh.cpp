#include "base/triangle_mesh.h"

#include <algorithm>

#include "base/mesh_appearance.h"

namespace trundle {

void reverseTriangles(TriangleMesh& mesh, const std::vector<bool>& which) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (which[i]) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    if (!mesh.look || mesh.look->onPicture.empty()) return;
    auto look = std::make_shared<MeshAppearance>(*mesh.look);
    for (std::size_t i = 0; i < std::min(which.size(), look->onPicture.size()); ++i)
        if (which[i]) std::swap(look->onPicture[i][1], look->onPicture[i][2]);
    mesh.look = std::move(look);
}

} // namespace trundle
