#pragma once
// How the resolver reaches the files that a text names.

#include <functional>
#include <memory>
#include <string>

#include "base/raster.h"
#include "base/result.h"
#include "base/source_range.h"
#include "base/triangle_mesh.h"
#include "model/mesh_shapes.h"

namespace trundle {

/// A file named in the text, and its content.
template <class T> struct FoundAsset {
    std::string path;
    std::shared_ptr<const T> content;
};

/// File access that the project provides to the resolver; `written` is a path in the text of `file`.
struct AssetLookup {
    std::function<Result<FoundAsset<TriangleMesh>>(const std::string& written, FileId file)> mesh;
    std::function<Result<FoundAsset<HeightMap>>(const std::string& written, FileId file)> heightMap;
    /// The path of an image, completed with a file ending if it has none; fails with the searched paths.
    std::function<Result<std::string>(const std::string& written, FileId file)> texture;
    /// The content of a text file with numbers, such as measured antenna gains; fails with the searched paths.
    std::function<Result<std::string>(const std::string& written, FileId file)> table;
    /// The pixels of the image at a path; null if pixels are not needed.
    std::function<Result<std::shared_ptr<const Raster>>(const std::string& path)> picture;
    std::shared_ptr<MeshShapes> shapes = std::make_shared<MeshShapes>(); ///< shared with earlier loads
};

} // namespace trundle
