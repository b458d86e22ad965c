#include "render/image_metadata.h"

#include <cstdio>
#include <numbers>

namespace trundle {
namespace {

std::string bigEndian(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>((value >> (8 * i)) & 0xffu);
    return text;
}

/// The CRC at the end of each PNG chunk (PNG specification, annex D).
std::uint32_t crcOf(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
}

const char* modeName(CameraMode mode) {
    switch (mode) {
    case CameraMode::Grey: return "grey";
    case CameraMode::Depth: return "depth";
    case CameraMode::Segmentation: return "segmentation";
    case CameraMode::Colour: break;
    }
    return "color";
}

constexpr std::size_t kPngHeader = 8 + 25; // signature and IHDR
constexpr std::size_t kMaxJpegComment = 65533;

} // namespace

std::string imageMetadata(const CameraImage& frame, const CameraModel* camera, const SettingsSpec& settings) {
    char text[160];
    std::snprintf(text, sizeof text, "time = %.9g s; tick = %llu; seed = %llu; size = %u x %u", frame.time,
                  static_cast<unsigned long long>(frame.tick), static_cast<unsigned long long>(settings.seed), frame.width,
                  frame.height);
    std::string note = text;
    if (camera) {
        std::snprintf(text, sizeof text, "; mode = %s; field of view = %.9g deg", modeName(camera->mode),
                      camera->fieldOfView * 180 / std::numbers::pi);
        note += "; camera = " + camera->path + text;
    }
    if (!settings.title.empty()) note += "; experiment = " + settings.title;
    return note;
}

std::string withMetadata(std::string file, const std::string& note) {
    if (file.size() > kPngHeader && file.starts_with("\x89PNG")) {
        const std::string chunk = "tEXt" + std::string("Comment") + '\0' + note;
        file.insert(kPngHeader, bigEndian(static_cast<std::uint32_t>(chunk.size() - 4), 4) + chunk + bigEndian(crcOf(chunk), 4));
    } else if (file.size() > 2 && file.starts_with("\xff\xd8") && note.size() <= kMaxJpegComment) {
        file.insert(2, "\xff\xfe" + bigEndian(static_cast<std::uint32_t>(note.size() + 2), 2) + note);
    }
    return file;
}

} // namespace trundle
