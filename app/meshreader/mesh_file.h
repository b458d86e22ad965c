#pragma once
#include <string>

#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// Reads a mesh with assimp, including colours and pictures of its materials: triangles only, node transforms applied, equal
/// points merged, triangles without area removed, closed surfaces counter-clockwise seen from outside. Formats with an up axis
/// (COLLADA, glTF) are rotated to z up; OBJ and STL have none and are unchanged. Error messages do not contain the file name.
[[nodiscard]] Result<TriangleMesh> readMeshFile(const std::string& path);

} // namespace trundle
