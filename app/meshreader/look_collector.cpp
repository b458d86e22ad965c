#include "meshreader/look_collector.h"

#include <algorithm>
#include <cmath>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include "assets/mesh_look_stream.h"
#include "base/stand_in.h"
#include "meshreader/picture_file.h"

namespace trundle {
namespace {

constexpr float kFarthest = 1e5f; // pictures from the first one

float share(float value) { return value > 0 ? std::min(value, 1.f) : 0.f; } // NaN is 0

constexpr std::size_t kMostNameBytes = 80; // in a message

/// What a file calls a thing may be anything.
std::string printable(const std::string& name) {
    std::string line;
    for (const char letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        line += code < 0x20 || code == 0x7f ? '?' : letter;
    }
    return line;
}

std::array<float, 2> onPictureAt(const aiMesh& mesh, unsigned corner, const PicturePlacement& placed) {
    if (mesh.mTextureCoords[0] == nullptr || corner >= mesh.mNumVertices) return {0, 0};
    const aiVector3D& at = mesh.mTextureCoords[0][corner];
    const float x = at.x * placed.scale[0] + placed.offset[0];
    const float y = 1 - (at.y * placed.scale[1] + placed.offset[1]); // the file's rows begin at the bottom
    if (!(std::fabs(x) < kFarthest) || !(std::fabs(y) < kFarthest)) return {0, 0};
    return {x, y};
}

} // namespace

void LookCollector::add(const aiMesh& mesh, const aiFace& face) {
    const std::uint16_t number = numberOf(mesh.mMaterialIndex);
    m_look.material.push_back(number);
    std::array<std::array<float, 2>, 3> corners{};
    for (unsigned i = 0; i < 3; ++i) corners[i] = onPictureAt(mesh, face.mIndices[i], m_placements[number]);
    m_look.onPicture.push_back(corners);
}

std::uint16_t LookCollector::numberOf(unsigned material) {
    const auto [entry, fresh] = m_numbers.try_emplace(material, std::uint16_t(0));
    if (!fresh) return entry->second;
    if (m_look.materials.size() == kMostMeshMaterials) {
        complain("it has more than " + std::to_string(kMostMeshMaterials) + " materials, some look like others");
        return entry->second = kMostMeshMaterials - 1;
    }
    const aiMaterial* read = material < m_scene.mNumMaterials ? m_scene.mMaterials[material] : nullptr;
    m_look.materials.push_back(read ? this->read(*read) : MeshMaterial{});
    m_placements.push_back(read ? m_files.placementOf(read->GetName().C_Str()) : PicturePlacement{});
    return entry->second = static_cast<std::uint16_t>(m_look.materials.size() - 1);
}

std::array<float, 3> LookCollector::shown(const aiColor3D& colour) const {
    const auto one = [&](float value) { return m_colours == Colours::Linear ? std::sqrt(share(value)) : share(value); };
    return {one(colour.r), one(colour.g), one(colour.b)};
}

MeshMaterial LookCollector::read(const aiMaterial& material) {
    MeshMaterial result;
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor3D colour(1, 1, 1);
    const bool coloured = material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS;
    // What assimp makes up, and what glTF says of a thing without a material, is no look.
    const bool madeUp = std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME ||
                        (name.length == 0 && colour.r == 1 && colour.g == 1 && colour.b == 1);
    if (coloured && !madeUp) result.colour = shown(colour);
    aiColor3D emission(0, 0, 0);
    if (material.Get(AI_MATKEY_COLOR_EMISSIVE, emission) == AI_SUCCESS) result.emission = shown(emission);

    aiString mode;
    float value = 1;
    const bool blends = material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != AI_SUCCESS || std::string(mode.C_Str()) == "BLEND";
    if (blends && material.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS) result.opacity = share(value);
    if (result.opacity <= 0) result.opacity = 1; // exporters that mean the opposite are more common than things nobody can see
    aiColor3D gloss(0, 0, 0);
    if (material.Get(AI_MATKEY_ROUGHNESS_FACTOR, value) == AI_SUCCESS) {
        result.shininess = share(1 - value);
    } else if (material.Get(AI_MATKEY_SHININESS, value) == AI_SUCCESS &&
               material.Get(AI_MATKEY_COLOR_SPECULAR, gloss) == AI_SUCCESS) {
        result.shininess = share((gloss.r + gloss.g + gloss.b) / 3) * share(value / 500);
    }

    aiString path;
    const bool pictured = material.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == AI_SUCCESS ||
                          material.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS;
    if (pictured && path.length > 0) result.picture = pictureOf(path.C_Str(), name.C_Str());
    if (!madeUp || pictured) m_saysSomething = true;
    return result;
}

std::shared_ptr<const Raster> LookCollector::pictureOf(const std::string& written, const std::string& material) {
    const auto [entry, fresh] = m_pictures.try_emplace(written);
    if (!fresh) return entry->second;
    const auto standIn = [&, entry = entry](const std::string& why) {
        // One inside the file has a star and a number for a name.
        const std::string picture = written[0] == '*' ? "embedded picture " + written.substr(1) : "picture " + written;
        complain("the " + picture.substr(0, kMostNameBytes) +
                 (material.empty() ? "" : " of its material " + material.substr(0, kMostNameBytes)) + " " + why);
        return entry->second = standInPicture();
    };
    if (m_pictures.size() > kMostMeshPictures - 1) return standIn("is one too many");
    Result<Raster> picture = readPicture(written);
    if (!picture) return standIn("cannot be shown: " + picture.error().message);
    if (picture.value().pixels.size() > kMostMeshPictureBytes - m_pictureBytes - standInPicture()->pixels.size())
        return standIn("is too large together with the others");
    m_pictureBytes += picture.value().pixels.size();
    return entry->second = std::make_shared<const Raster>(std::move(picture).value());
}

Result<Raster> LookCollector::readPicture(const std::string& written) const {
    if (const aiTexture* inside = m_scene.GetEmbeddedTexture(written.c_str())) {
        if (inside->mHeight != 0 || inside->pcData == nullptr) return Error{Code::MeshUnreadable, "it is of an unknown form"};
        return readColours(std::string(reinterpret_cast<const char*>(inside->pcData), inside->mWidth));
    }
    const Result<std::string> path = m_files.pictureFile(written);
    if (!path) return path.error();
    return readColourFile(path.value());
}

void LookCollector::complain(const std::string& words) {
    m_saysSomething = true;
    if (m_look.complaints.size() + 1 < kMostComplaints)
        m_look.complaints.push_back(printable(words.substr(0, kMostComplaintBytes)));
    else if (m_look.complaints.size() + 1 == kMostComplaints) m_look.complaints.emplace_back("and more of the kind");
}

std::shared_ptr<const MeshLook> LookCollector::take() {
    if (!m_saysSomething || m_look.materials.empty()) return nullptr;
    const auto& all = m_look.materials;
    if (std::none_of(all.begin(), all.end(), [](const MeshMaterial& m) { return m.picture != nullptr; }))
        m_look.onPicture.clear();
    return std::make_shared<const MeshLook>(std::move(m_look));
}

} // namespace trundle
