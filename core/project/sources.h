#pragma once
// What a project asks of others: modules' kinds (answered by control) and meshes and height maps (answered by assets).

#include <memory>
#include <string>
#include <vector>

#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"
#include "schema/kind.h"

namespace trundle {

/// What is known of a module without running its code.
struct ModuleListing {
    std::string library;    ///< absolute path
    bool described = false; ///< false: no description file beside it; its blocks stay raw text
    std::vector<Kind> kinds;
};

class ModuleCatalog {
public:
    virtual ~ModuleCatalog() = default;
    /// `written` is the path of a #loadModule, `folder` the importing file's. Fails with the paths tried, or with "not trusted".
    [[nodiscard]] virtual Result<ModuleListing> find(const std::string& written, const std::string& folder) = 0;
    /// How a #loadModule names a module that comes with the program and brings this kind; "" where there is none.
    [[nodiscard]] virtual std::string moduleWith(const std::string& /*kind*/) { return {}; }
};

class MeshSource {
public:
    virtual ~MeshSource() = default;
    [[nodiscard]] virtual Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) = 0;
    [[nodiscard]] virtual Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) = 0;
    /// The pixels of a texture; null where nobody looks at them.
    [[nodiscard]] virtual Result<std::shared_ptr<const Raster>> picture(const std::string&) {
        return std::shared_ptr<const Raster>();
    }
    /// Whether some answer was "not yet": asked again later, it may be another.
    [[nodiscard]] virtual bool pending() const { return false; }
};

} // namespace trundle
