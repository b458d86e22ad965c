#pragma once
// From the outline of a text to the typed model.

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

/// A file that a text names, as found.
template <class T> struct FoundAsset {
    std::string path;
    std::shared_ptr<const T> content;
};

/// What the resolver asks of the project: `written` stands in the text of `file`.
struct AssetLookup {
    std::function<Result<FoundAsset<TriangleMesh>>(const std::string& written, FileId file)> mesh;
    std::function<Result<FoundAsset<HeightMap>>(const std::string& written, FileId file)> heightMap;
    /// The picture's path, an ending added where none is written; fails with the places looked at.
    std::function<Result<std::string>(const std::string& written, FileId file)> texture;
    /// The content of a file of numbers (an antenna's measured gains); fails with the places looked at.
    std::function<Result<std::string>(const std::string& written, FileId file)> table;
    /// The pixels of the picture at a path; null where nobody reads pictures.
    std::function<Result<std::shared_ptr<const Raster>>(const std::string& path)> picture;
    std::shared_ptr<MeshShapes> shapes = std::make_shared<MeshShapes>(); ///< of this load and of former ones
};

/// Resolves everything that can be; what is wrong is said and left out. Modules are filled in by the caller.
[[nodiscard]] std::shared_ptr<ExperimentSpec> resolve(const Outline& outline, const AssetLookup& assets,
                                                      Diagnostics& diagnostics);

} // namespace trundle
