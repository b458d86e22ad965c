#include "assets/mesh_appearance_stream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace trundle {
namespace {

constexpr float kFarthestOnPicture = 1e6f; // largest accepted texture coordinate; larger values have lost their precision

Error damagedAppearance(const std::string& why) { return Error{Code::MeshUnreadable, "its reader's output is damaged: " + why}; }

struct Counts {
    std::uint32_t materials = 0, pictures = 0, warnings = 0, onPictures = 0;
};

struct PlainMaterial {
    std::array<float, 3> colour, emission;
    float opacity, shininess;
    std::uint32_t picture;
};
static_assert(sizeof(PlainMaterial) == 36);

template <class Item> void append(std::string& bytes, const Item& item) {
    static_assert(std::is_trivially_copyable_v<Item>);
    bytes.append(reinterpret_cast<const char*>(&item), sizeof item);
}

/// Reads values from the front of a byte string.
class Cursor {
public:
    explicit Cursor(std::string_view bytes) : m_bytes(bytes) {}

    template <class Item> bool take(Item& item) { return take(&item, 1); }
    template <class Item> bool take(Item* items, std::size_t count) {
        if (count > m_bytes.size() / sizeof(Item)) return false;
        if (count == 0) return true; // an empty vector has no memory to copy to
        std::memcpy(items, m_bytes.data(), count * sizeof(Item));
        m_bytes.remove_prefix(count * sizeof(Item));
        return true;
    }
    template <class Item> bool take(std::vector<Item>& items, std::size_t count) {
        if (count > m_bytes.size() / sizeof(Item)) return false;
        items.resize(count);
        return take(items.data(), count);
    }
    [[nodiscard]] bool atEnd() const { return m_bytes.empty(); }

private:
    std::string_view m_bytes;
};

bool isShare(float value) { return value >= 0 && value <= 1; } // also false for NaN

bool allShares(const PlainMaterial& m) {
    return std::all_of(m.colour.begin(), m.colour.end(), isShare) && std::all_of(m.emission.begin(), m.emission.end(), isShare) &&
           isShare(m.opacity) && isShare(m.shininess);
}

} // namespace

std::string encodeAppearance(const MeshAppearance& look) {
    std::map<const Raster*, std::uint32_t> numbers;
    std::vector<const Raster*> pictures;
    for (const MeshMaterial& m : look.materials) {
        if (!m.picture || numbers.contains(m.picture.get())) continue;
        pictures.push_back(m.picture.get());
        numbers[m.picture.get()] = static_cast<std::uint32_t>(pictures.size());
    }
    std::string bytes;
    append(bytes, Counts{static_cast<std::uint32_t>(look.materials.size()), static_cast<std::uint32_t>(pictures.size()),
                         static_cast<std::uint32_t>(look.warnings.size()), look.onPicture.empty() ? 0u : 1u});
    for (const MeshMaterial& m : look.materials)
        append(bytes, PlainMaterial{m.colour, m.emission, m.opacity, m.shininess, m.picture ? numbers[m.picture.get()] : 0});
    for (const std::uint16_t material : look.material) append(bytes, material);
    for (const auto& corners : look.onPicture) append(bytes, corners);
    for (const Raster* picture : pictures) {
        append(bytes, std::array{picture->width, picture->height});
        bytes.append(reinterpret_cast<const char*>(picture->pixels.data()), picture->pixels.size());
    }
    for (const std::string& warning : look.warnings) {
        append(bytes, static_cast<std::uint32_t>(warning.size()));
        bytes += warning;
    }
    return bytes;
}

Result<std::shared_ptr<const MeshAppearance>> decodeAppearance(std::string_view bytes, std::size_t triangles) {
    Cursor cursor(bytes);
    Counts counts;
    if (!cursor.take(counts)) return damagedAppearance("it ends early");
    if (counts.materials > kMaxMeshMaterials || counts.pictures > kMaxMeshPictures || counts.warnings > kMaxWarnings)
        return damagedAppearance("too many materials, pictures or warnings");
    auto look = std::make_shared<MeshAppearance>();
    std::vector<PlainMaterial> plain;
    if (!cursor.take(plain, counts.materials) || !cursor.take(look->material, triangles))
        return damagedAppearance("it ends early");
    if (counts.onPictures && !cursor.take(look->onPicture, triangles)) return damagedAppearance("it ends early");
    for (const std::uint16_t material : look->material)
        if (material >= counts.materials) return damagedAppearance("a triangle names a material that is not there");
    for (const auto& corners : look->onPicture)
        for (const auto& corner : corners)
            for (const float value : corner)
                if (!(std::abs(value) <= kFarthestOnPicture)) return damagedAppearance("a texture coordinate is not a number");
    std::vector<std::shared_ptr<const Raster>> pictures;
    std::uint64_t room = kMaxMeshPictureBytes;
    for (std::uint32_t i = 0; i < counts.pictures; ++i) {
        auto raster = std::make_shared<Raster>();
        if (!cursor.take(raster->width) || !cursor.take(raster->height)) return damagedAppearance("it ends early");
        const std::uint64_t size = std::uint64_t{raster->width} * raster->height * 3;
        if (size == 0 || raster->width > kMaxRasterSide || raster->height > kMaxRasterSide || size > room)
            return damagedAppearance("a picture of an impossible size");
        room -= size;
        if (!cursor.take(raster->pixels, size)) return damagedAppearance("it ends early");
        pictures.push_back(std::move(raster));
    }
    for (const PlainMaterial& m : plain) {
        if (!allShares(m)) return damagedAppearance("a colour is outside 0..1");
        if (m.picture > pictures.size() || (m.picture && look->onPicture.empty() && triangles))
            return damagedAppearance("a material names a picture that is not there");
        look->materials.push_back({m.colour, m.emission, m.opacity, m.shininess, m.picture ? pictures[m.picture - 1] : nullptr});
    }
    for (std::uint32_t i = 0; i < counts.warnings; ++i) {
        std::uint32_t length = 0;
        std::vector<char> words;
        if (!cursor.take(length) || length > kMaxWarningBytes || !cursor.take(words, length))
            return damagedAppearance("it ends early");
        look->warnings.emplace_back(words.begin(), words.end());
    }
    if (!cursor.atEnd()) return damagedAppearance("its length does not fit its counts");
    return std::shared_ptr<const MeshAppearance>(std::move(look));
}

} // namespace trundle
