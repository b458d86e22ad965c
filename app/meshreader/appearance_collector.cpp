#include "meshreader/appearance_collector.h"

#include <algorithm>
#include <cmath>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include "assets/mesh_appearance_stream.h"
#include "base/missing_asset.h"
#include "meshreader/picture_file.h"

namespace trundle {
namespace {

constexpr float kFarthest = 1e5f; // limit of texture coordinates, in picture widths

float share(float value) { return value > 0 ? std::min(value, 1.f) : 0.f; } // clamped to 0..1; NaN becomes 0

constexpr std::size_t kMaxNameBytes = 80; // in messages

/// A name from the file, which may contain any bytes, made safe for messages.
std::string printable(const std::string& name) {
    std::string line;
    for (const char letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        line += code < 0x20 || code == 0x7f ? '?' : letter;
    }
    return line;
}

std::array<float, 2> onPictureAt(const aiMesh& mesh, unsigned corner, const TextureTransform& placed) {
    if (mesh.mTextureCoords[0] == nullptr || corner >= mesh.mNumVertices) return {0, 0};
    const aiVector3D& at = mesh.mTextureCoords[0][corner];
    const float x = at.x * placed.scale[0] + placed.offset[0];
    const float y = 1 - (at.y * placed.scale[1] + placed.offset[1]); // v = 0 is the bottom row in the file
    if (!(std::fabs(x) < kFarthest) || !(std::fabs(y) < kFarthest)) return {0, 0};
    return {x, y};
}

} // namespace

void AppearanceCollector::add(const aiMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const std::uint16_t number = numberOf(mesh.mMaterialIndex);
    m_look.material.push_back(number);
    std::array<std::array<float, 2>, 3> corners{};
    for (unsigned i = 0; i < 3; ++i) corners[i] = onPictureAt(mesh, triangle[i], m_placements[number]);
    m_look.onPicture.push_back(corners);
}

std::uint16_t AppearanceCollector::numberOf(unsigned material) {
    const auto [entry, fresh] = m_numbers.try_emplace(material, std::uint16_t(0));
    if (!fresh) return entry->second;
    if (m_look.materials.size() == kMaxMeshMaterials) {
        addWarning("it has more than " + std::to_string(kMaxMeshMaterials) + " materials; some were merged");
        return entry->second = kMaxMeshMaterials - 1;
    }
    const aiMaterial* read = material < m_scene.mNumMaterials ? m_scene.mMaterials[material] : nullptr;
    m_look.materials.push_back(read ? this->read(*read) : MeshMaterial{});
    m_placements.push_back(read ? m_files.placementOf(read->GetName().C_Str()) : TextureTransform{});
    return entry->second = static_cast<std::uint16_t>(m_look.materials.size() - 1);
}

std::array<float, 3> AppearanceCollector::shown(const aiColor3D& colour) const {
    const auto one = [&](float value) { return m_colours == Colours::Linear ? std::sqrt(share(value)) : share(value); };
    return {one(colour.r), one(colour.g), one(colour.b)};
}

MeshMaterial AppearanceCollector::read(const aiMaterial& material) {
    MeshMaterial result;
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor3D colour(1, 1, 1);
    const bool coloured = material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS;
    // assimp's default material, and glTF's material for objects without one, are not an appearance.
    const bool madeUp = std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME ||
                        (name.length == 0 && colour.r == 1 && colour.g == 1 && colour.b == 1);
    if (coloured && !madeUp) result.colour = shown(colour);
    aiColor3D emission(0, 0, 0);
    if (material.Get(AI_MATKEY_COLOR_EMISSIVE, emission) == AI_SUCCESS) result.emission = shown(emission);

    aiString mode;
    float value = 1;
    const bool blends = material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != AI_SUCCESS || std::string(mode.C_Str()) == "BLEND";
    if (blends && material.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS) result.opacity = share(value);
    if (result.opacity <= 0) result.opacity = 1; // some exporters invert opacity, which is more likely than an invisible object
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
    if (!madeUp || pictured) m_hasMessage = true;
    return result;
}

std::shared_ptr<const Raster> AppearanceCollector::pictureOf(const std::string& written, const std::string& material) {
    const auto [entry, fresh] = m_pictures.try_emplace(written);
    if (!fresh) return entry->second;
    const auto missingAsset = [&, entry = entry](const std::string& why) {
        // An embedded picture is named "*" and a number.
        const std::string picture = written[0] == '*' ? "embedded picture " + written.substr(1) : "picture " + written;
        addWarning("the " + picture.substr(0, kMaxNameBytes) +
                   (material.empty() ? "" : " of its material " + material.substr(0, kMaxNameBytes)) + " " + why);
        return entry->second = missingAssetPicture();
    };
    if (m_pictures.size() > kMaxMeshPictures - 1) return missingAsset("is one too many");
    Result<Raster> picture = readPicture(written);
    if (!picture) return missingAsset("cannot be shown: " + picture.error().message);
    if (picture.value().pixels.size() > kMaxMeshPictureBytes - m_pictureBytes - missingAssetPicture()->pixels.size())
        return missingAsset("is too large together with the others");
    m_pictureBytes += picture.value().pixels.size();
    return entry->second = std::make_shared<const Raster>(std::move(picture).value());
}

Result<Raster> AppearanceCollector::readPicture(const std::string& written) const {
    if (const aiTexture* inside = m_scene.GetEmbeddedTexture(written.c_str())) {
        if (inside->mHeight != 0 || inside->pcData == nullptr) return Error{Code::MeshUnreadable, "it is of an unknown form"};
        return readColours(std::string(reinterpret_cast<const char*>(inside->pcData), inside->mWidth));
    }
    const Result<std::string> path = m_files.pictureFile(written);
    if (!path) return path.error();
    return readColourFile(path.value());
}

void AppearanceCollector::addWarning(const std::string& words) {
    m_hasMessage = true;
    if (m_look.warnings.size() + 1 < kMaxWarnings) m_look.warnings.push_back(printable(words.substr(0, kMaxWarningBytes)));
    else if (m_look.warnings.size() + 1 == kMaxWarnings) m_look.warnings.emplace_back("and more of the kind");
}

std::shared_ptr<const MeshAppearance> AppearanceCollector::take() {
    if (!m_hasMessage || m_look.materials.empty()) return nullptr;
    const auto& all = m_look.materials;
    if (std::none_of(all.begin(), all.end(), [](const MeshMaterial& m) { return m.picture != nullptr; }))
        m_look.onPicture.clear();
    return std::make_shared<const MeshAppearance>(std::move(m_look));
}

} // namespace trundle
