#pragma once
#include <map>
#include <memory>
#include <string>

#include <assimp/scene.h>

#include "base/mesh_look.h"
#include "base/result.h"
#include "meshreader/fenced_files.h"

namespace trundle {

/// How the triangles of a scene look: colours and pictures of the materials that they name. A picture that is missing, broken or not
/// to be had gives a complaint and a stand-in.
class LookCollector {
public:
    /// Both outlive it. `colours` says what the numbers of a colour mean.
    enum class Colours { AsShown, Linear };
    LookCollector(const aiScene& scene, const FencedFiles& files, Colours colours)
        : m_scene(scene), m_files(files), m_colours(colours) {}

    /// For each triangle, in their order.
    void add(const aiMesh& mesh, const aiFace& face);
    void complain(const std::string& words);
    /// Null where the file says nothing of looks.
    [[nodiscard]] std::shared_ptr<const MeshLook> take();

private:
    [[nodiscard]] std::uint16_t numberOf(unsigned material);
    [[nodiscard]] MeshMaterial read(const aiMaterial& material);
    [[nodiscard]] std::array<float, 3> shown(const aiColor3D& colour) const;
    [[nodiscard]] std::shared_ptr<const Raster> pictureOf(const std::string& written, const std::string& material);
    [[nodiscard]] Result<Raster> readPicture(const std::string& written) const;

    const aiScene& m_scene;
    const FencedFiles& m_files;
    Colours m_colours;
    MeshLook m_look;
    bool m_saysSomething = false;
    std::uint64_t m_pictureBytes = 0;
    std::vector<PicturePlacement> m_placements;                      // of the pictures of the look's materials
    std::map<unsigned, std::uint16_t> m_numbers;                     // by the scene's number
    std::map<std::string, std::shared_ptr<const Raster>> m_pictures; // by what is written
};

} // namespace trundle
