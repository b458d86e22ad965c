#pragma once
#include <string>

#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// Reads a mesh with assimp: triangles only, node transforms applied, equal points joined, triangles without area dropped; with
/// the colours and pictures of its materials. Formats
/// that have an up axis (COLLADA, glTF) are turned so that up is z; OBJ and STL have none and stay as they are.
/// The message does not name the file.
[[nodiscard]] Result<TriangleMesh> readMeshFile(const std::string& path);

} // namespace trundle
