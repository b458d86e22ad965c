#pragma once
// Reads meshes, height maps and pictures by path. Foreign formats are read by trundle-meshreader, a process with limits on time
// and memory, so that a hostile or broken file can fail to load but cannot harm this process.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "base/platform/read_file.h"
#include "base/raster.h"
#include "base/result.h"
#include "base/triangle_mesh.h"

namespace trundle {

struct AssetLimits {
    double seconds = 10;                  ///< wall-clock limit for one file
    std::uint64_t memoryBytes = 1u << 30; ///< limit on the reader process
    std::uint64_t fileBytes = 256u << 20; ///< limit on the file itself
};

/// Caches results and failures until the file changes. Thread-safe; one file is read at a time, and cached results are returned
/// without waiting for it.
class AssetReader {
public:
    /// `program` is the path of trundle-meshreader.
    explicit AssetReader(std::string program, AssetLimits limits = {});

    /// OBJ, STL, DAE, glTF or GLB; node transforms applied, duplicate points merged, z up, closed surfaces counter-clockwise seen
    /// from outside. A MeshUnreadable error names the path and the reason.
    [[nodiscard]] Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path);
    /// PNG, JPEG, BMP, PGM or PPM (8 or 16 bit), converted to grey.
    [[nodiscard]] Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path);

    /// The same formats in colour, for textures; large images are scaled down.
    [[nodiscard]] Result<std::shared_ptr<const Raster>> picture(const std::string& path);

    /// The cached result of mesh(), or nothing if the file would have to be read. Never waits.
    [[nodiscard]] std::optional<Result<std::shared_ptr<const TriangleMesh>>> cachedMesh(const std::string& path);
    [[nodiscard]] std::optional<Result<std::shared_ptr<const HeightMap>>> cachedHeightMap(const std::string& path);
    [[nodiscard]] std::optional<Result<std::shared_ptr<const Raster>>> cachedPicture(const std::string& path);

private:
    template <class Asset> struct CacheEntry {
        FileStamp stamp;
        Result<std::shared_ptr<const Asset>> answer;
    };
    template <class Asset> using Cache = std::map<std::string, CacheEntry<Asset>>;

    template <class Asset> using ReaderOutput = Result<std::shared_ptr<const Asset>>;
    template <class Asset> std::optional<ReaderOutput<Asset>> cached(const Cache<Asset>& cache, const std::string& path);
    template <class Asset, class Decode>
    ReaderOutput<Asset> find(Cache<Asset>& cache, const char* kind, const std::string& path, Decode decode);
    [[nodiscard]] Result<std::string> ask(const char* kind, const std::string& path) const;

    std::string m_program;
    AssetLimits m_limits;
    std::mutex m_reading; // held while a file is read; allows one reader process at a time
    std::mutex m_mutex;   // guards the caches
    Cache<TriangleMesh> m_meshes;
    Cache<HeightMap> m_heightMaps;
    Cache<Raster> m_pictures;
};

} // namespace trundle
