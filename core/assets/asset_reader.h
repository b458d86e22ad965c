#pragma once
// Meshes and height maps by path. The foreign formats are read by trundle-meshreader, a process with limits of time and memory, so
// that a hostile or broken file can cost a message but never us.

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
    double seconds = 10;                  ///< wall clock for one file
    std::uint64_t memoryBytes = 1u << 30; ///< of the reading process
    std::uint64_t fileBytes = 256u << 20; ///< of the file itself
};

/// Keeps what it read, and what it could not read, until the file changes. Safe to ask from several threads; one file is read at a
/// time, and what is kept is answered at once meanwhile.
class AssetReader {
public:
    /// `program` is the path of trundle-meshreader, beside our own program.
    explicit AssetReader(std::string program, AssetLimits limits = {});

    /// OBJ, STL, DAE, glTF or GLB; node transforms applied, equal points joined, z up. An error of code MeshUnreadable names the
    /// path and the reason.
    [[nodiscard]] Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path);
    /// PNG, JPEG, BMP, PGM or PPM (8 or 16 bit), as grey.
    [[nodiscard]] Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path);

    /// The same files in colour, for textures; a large one is made smaller.
    [[nodiscard]] Result<std::shared_ptr<const Raster>> picture(const std::string& path);

    /// The same answers where they need no reading, else nothing. Never waits.
    [[nodiscard]] std::optional<Result<std::shared_ptr<const TriangleMesh>>> keptMesh(const std::string& path);
    [[nodiscard]] std::optional<Result<std::shared_ptr<const HeightMap>>> keptHeightMap(const std::string& path);
    [[nodiscard]] std::optional<Result<std::shared_ptr<const Raster>>> keptPicture(const std::string& path);

private:
    template <class Asset> struct Kept {
        FileStamp stamp;
        Result<std::shared_ptr<const Asset>> answer;
    };
    template <class Asset> using Shelf = std::map<std::string, Kept<Asset>>;

    template <class Asset> using Answer = Result<std::shared_ptr<const Asset>>;
    template <class Asset> std::optional<Answer<Asset>> kept(const Shelf<Asset>& shelf, const std::string& path);
    template <class Asset, class Decode>
    Answer<Asset> find(Shelf<Asset>& shelf, const char* kind, const std::string& path, Decode decode);
    [[nodiscard]] Result<std::string> ask(const char* kind, const std::string& path) const;

    std::string m_program;
    AssetLimits m_limits;
    std::mutex m_reading; // held while a file is read
    std::mutex m_mutex;   // of the shelves
    Shelf<TriangleMesh> m_meshes;
    Shelf<HeightMap> m_heightMaps;
    Shelf<Raster> m_pictures;
};

} // namespace trundle
