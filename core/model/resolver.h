#pragma once
// Resolves the outline of an experiment into the typed model.

#include <functional>
#include <memory>
#include <string>

#include "base/diagnostic.h"
#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"
#include "model/experiment_spec.h"
#include "model/mesh_shapes.h"
#include "model/outline.h"

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

/// Resolves everything that is valid; reports the rest and leaves it out. The caller fills in the modules.
[[nodiscard]] std::shared_ptr<ExperimentSpec> resolve(const Outline& outline, const AssetLookup& assets,
                                                      Diagnostics& diagnostics);

} // namespace trundle
