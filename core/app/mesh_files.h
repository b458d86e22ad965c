#pragma once
// The files of a mesh: itself, its materials, buffers and textures.

#include <string>
#include <vector>

#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

/// Names, relative to the folder of the mesh, of the files that it refers to and that are in that folder or below. OBJ with MTL, COLLADA
/// and glTF; STL and GLB refer to none.
[[nodiscard]] std::vector<std::string> filesOfMesh(const std::string& mesh);

/// Copies a mesh and its files into meshes/NAME below `folder`, with a number after the name if that exists, and returns the path of the copy
/// relative to `folder`. A mesh that is in `folder` or below is not copied.
[[nodiscard]] Result<std::string> bringMesh(const std::string& mesh, const std::string& folder);

/// Writes each hull as an OBJ file beside a mesh whose path relative to `folder` is `mesh`: meshes/cup/cup_part1.obj. Nothing that exists
/// is written over. Returns their paths relative to `folder`.
[[nodiscard]] Result<std::vector<std::string>> writeHulls(const std::vector<TriangleMesh>& hulls, const std::string& mesh,
                                                          const std::string& folder);

} // namespace trundle
