#pragma once
// Interfaces that a project needs: kinds of modules (implemented by control), meshes and height maps (implemented by assets).

#include <memory>
#include <string>
#include <vector>

#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"
#include "schema/kind.h"

namespace trundle {

/// Facts about a module that are available without running its code.
struct ModuleListing {
    std::string library;    ///< absolute path
    bool described = false; ///< false: it has no description file; its blocks are kept as raw text
    std::vector<Kind> kinds;
};

/// The description file of a module's library: "d/libn.so" → "d/libn.so.kinds.json".
[[nodiscard]] inline std::string kindsJsonPath(const std::string& library) { return library + ".kinds.json"; }

class ModuleCatalog {
public:
    virtual ~ModuleCatalog() = default;
    /// `written` is the path of a #loadModule, `folder` that of the importing file. Fails with the tried paths, or with "not
    /// trusted".
    [[nodiscard]] virtual Result<ModuleListing> find(const std::string& written, const std::string& folder) = 0;
    /// The #loadModule path of a shipped module that provides this kind; "" if there is none.
    [[nodiscard]] virtual std::string moduleWith(const std::string& /*kind*/) { return {}; }
};

class MeshSource {
public:
    virtual ~MeshSource() = default;
    [[nodiscard]] virtual Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) = 0;
    [[nodiscard]] virtual Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) = 0;
    /// The pixels of a texture; null if pixels are not needed.
    [[nodiscard]] virtual Result<std::shared_ptr<const Raster>> picture(const std::string&) {
        return std::shared_ptr<const Raster>();
    }
    /// Whether a result was "not read yet", so that a later call may succeed.
    [[nodiscard]] virtual bool pending() const { return false; }
};

} // namespace trundle
