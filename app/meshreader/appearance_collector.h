#pragma once
#include <map>
#include <memory>
#include <string>

#include <assimp/scene.h>

#include "base/mesh_appearance.h"
#include "base/result.h"
#include "meshreader/restricted_io_system.h"

namespace trundle {

/// Collects the appearance of a scene's triangles: colours and pictures of their materials. A missing, broken or unavailable
/// picture is replaced by a placeholder, with a warning.
class AppearanceCollector {
public:
    /// Encoding of the file's colours. The scene and the files passed to the constructor must outlive this object.
    enum class Colours { AsShown, Linear };
    AppearanceCollector(const aiScene& scene, const RestrictedIOSystem& files, Colours colours)
        : m_scene(scene), m_files(files), m_colours(colours) {}

    /// Adds the triangles one by one, in order. `triangle`: numbers of vertices of `mesh`.
    void add(const aiMesh& mesh, const std::array<std::uint32_t, 3>& triangle);
    void addWarning(const std::string& words);
    /// Null if the file has no appearance.
    [[nodiscard]] std::shared_ptr<const MeshAppearance> take();

private:
    [[nodiscard]] std::uint16_t numberOf(unsigned material);
    [[nodiscard]] MeshMaterial read(const aiMaterial& material);
    [[nodiscard]] std::array<float, 3> shown(const aiColor3D& colour) const;
    [[nodiscard]] std::shared_ptr<const Raster> pictureOf(const std::string& written, const std::string& material);
    [[nodiscard]] Result<Raster> readPicture(const std::string& written) const;

    const aiScene& m_scene;
    const RestrictedIOSystem& m_files;
    Colours m_colours;
    MeshAppearance m_look;
    bool m_hasMessage = false;
    std::uint64_t m_pictureBytes = 0;
    std::vector<TextureTransform> m_placements;                      // of the pictures of m_look's materials
    std::map<unsigned, std::uint16_t> m_numbers;                     // by material index of the scene
    std::map<std::string, std::shared_ptr<const Raster>> m_pictures; // by name as written in the file
};

} // namespace trundle
