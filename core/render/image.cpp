#include "render/image.h"

#include <png.h>
#include <turbojpeg.h>

#include "base/platform/atomic_file.h"

namespace trundle {
namespace {

bool isWhole(const Image& image) {
    return image.width > 0 && image.height > 0 && image.pixels.size() == std::size_t(image.width) * image.height * 3;
}

Error broken(const std::string& why) { return {Code::PictureFailed, "the picture cannot be encoded: " + why}; }

} // namespace

Result<std::string> pngBytes(const Image& image) {
    if (!isWhole(image)) return broken("its size and its pixels disagree");
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = image.width;
    png.height = image.height;
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) return broken(png.message);
    bytes.resize(size);
    return bytes;
}

Result<std::string> jpegBytes(const Image& image, int quality) {
    if (!isWhole(image)) return broken("its size and its pixels disagree");
    const tjhandle encoder = tjInitCompress();
    if (!encoder) return broken(tjGetErrorStr2(nullptr));
    unsigned char* data = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(encoder, image.pixels.data(), int(image.width), 0, int(image.height), TJPF_RGB, &data, &size,
                                   TJSAMP_444, std::clamp(quality, 1, 100), TJFLAG_ACCURATEDCT);
    const std::string why = failed ? tjGetErrorStr2(encoder) : "";
    std::string bytes(reinterpret_cast<const char*>(data), failed ? 0 : size);
    tjFree(data);
    tjDestroy(encoder);
    if (failed) return broken(why);
    return bytes;
}

Result<std::string> imageBytes(const Image& image, const std::string& path) {
    std::string ending = path.substr(std::min(path.size(), path.find_last_of('.')));
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool png = ending == ".png", jpeg = ending == ".jpg" || ending == ".jpeg";
    if (!png && !jpeg) return Error{Code::PictureFailed, "a picture is written as .png, .jpg or .jpeg, not \"" + path + '"'};
    return png ? pngBytes(image) : jpegBytes(image);
}

Status saveImage(const Image& image, const std::string& path) {
    const Result<std::string> bytes = imageBytes(image, path);
    if (!bytes) return bytes.error();
    return writeFileAtomically(path, bytes.value());
}

} // namespace trundle
