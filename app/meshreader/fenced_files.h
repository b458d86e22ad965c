#pragma once
#include <map>
#include <string>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "base/result.h"
#include "meshreader/picture_options.h"

namespace trundle {

/// All that assimp sees of the disk: the mesh file itself, the binary buffers (.bin) and the materials (.mtl) beside or below it.
/// Anything else is "not there", writing is refused, and a reference that leaves the folder is remembered, so that the whole file can
/// be refused.
class FencedFiles final : public Assimp::IOSystem {
public:
    explicit FencedFiles(const std::string& meshFile);

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override { delete stream; }

    /// The mesh file with links resolved: read it by this name, then its neighbours are those of the real file.
    [[nodiscard]] const std::string& meshFile() const { return m_meshFile; }
    /// The first reference that was refused; empty where there was none.
    [[nodiscard]] const std::string& refused() const { return m_refused; }
    /// Why the last file that may be read could not be; empty where all could.
    [[nodiscard]] const std::string& unreadable() const { return m_unreadable; }
    /// "paint.mtl, is not there": the first file of materials that was asked for and cannot be had; empty where all could.
    [[nodiscard]] const std::string& missingMaterials() const { return m_missingMaterials; }
    /// How the picture of a material lies by its file of materials.
    [[nodiscard]] PicturePlacement placementOf(const std::string& material) const;
    /// Where a picture is that the mesh names: at its path, or by its name alone beside the mesh, as one exported elsewhere names
    /// it. Never outside the mesh's folder.
    [[nodiscard]] Result<std::string> pictureFile(std::string written) const;

private:
    enum class Verdict { Readable, Ignored, Outside };
    [[nodiscard]] Verdict judge(const std::string& file) const;

    std::string m_meshFile; ///< canonical
    std::string m_folder;   ///< canonical, ends in a slash
    std::string m_refused, m_unreadable, m_missingMaterials;
    std::map<std::string, PicturePlacement> m_placements; // by material
};

} // namespace trundle
