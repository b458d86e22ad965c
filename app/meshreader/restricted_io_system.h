#pragma once
#include <map>
#include <string>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "base/result.h"
#include "meshreader/picture_options.h"

namespace trundle {

/// Restricts assimp's file access to the mesh file itself and to binary buffers (.bin) and materials (.mtl) in or below its
/// folder. Any other file appears missing, and writing is refused. A reference outside the folder is recorded, so that the whole
/// mesh can be refused.
class RestrictedIOSystem final : public Assimp::IOSystem {
public:
    explicit RestrictedIOSystem(const std::string& meshFile);

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override { delete stream; }

    /// The mesh file with links resolved. Read it by this path, so that its other files are found next to the real file.
    [[nodiscard]] const std::string& meshFile() const { return m_meshFile; }
    /// The first refused reference; empty if there was none.
    [[nodiscard]] const std::string& refused() const { return m_refused; }
    /// Why the last accessible file could not be read; empty if all could.
    [[nodiscard]] const std::string& unreadable() const { return m_unreadable; }
    /// "paint.mtl, is not there": the first requested materials file that is not available; empty if all are.
    [[nodiscard]] const std::string& missingMaterials() const { return m_missingMaterials; }
    /// Texture transformation of a material according to its MTL file.
    [[nodiscard]] TextureTransform placementOf(const std::string& material) const;
    /// Finds a picture named by the mesh: at the given path, otherwise by its file name alone next to the mesh, since exporters
    /// write paths of other machines. Never outside the mesh's folder.
    [[nodiscard]] Result<std::string> pictureFile(std::string written) const;

private:
    enum class FileAccess { Readable, Ignored, Outside };
    [[nodiscard]] FileAccess accessOf(const std::string& file) const;

    std::string m_meshFile; ///< canonical
    std::string m_folder;   ///< canonical, ends in a slash
    std::string m_refused, m_unreadable, m_missingMaterials;
    std::map<std::string, TextureTransform> m_placements; // by material name
};

} // namespace trundle
