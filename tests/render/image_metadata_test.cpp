// Notes in files of images: any reader finds them in their place, and the image stays the same.
#include <QtTest>

#include <map>

#include <png.h>
#include <turbojpeg.h>

#include "render/image.h"
#include "render/image_metadata.h"

using namespace trundle;

namespace {

Image pattern() {
    Image image{24, 16, {}};
    for (std::uint32_t i = 0; i < 24 * 16 * 3; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 7 + i / 13));
    return image;
}

std::string fileOf(const char* name) { return imageBytes(pattern(), name).value(); }

std::size_t numberAt(const std::string& bytes, std::size_t at, int size) {
    std::size_t value = 0;
    for (int i = 0; i < size; ++i) value = 256 * value + static_cast<unsigned char>(bytes.at(at + std::size_t(i)));
    return value;
}

/// The comments of a JPEG file, whose segments follow each other as far as its image.
std::vector<std::string> jpegComments(const std::string& file) {
    std::vector<std::string> comments;
    std::size_t at = 2;
    while (numberAt(file, at, 2) != 0xffda) {
        if (numberAt(file, at, 1) != 0xff) return {"no segment begins at " + std::to_string(at)};
        const std::size_t length = numberAt(file, at + 2, 2); // of itself and what follows
        if (numberAt(file, at, 2) == 0xfffe) comments.push_back(file.substr(at + 4, length - 2));
        at += 2 + length;
    }
    return comments;
}

std::vector<std::uint8_t> jpegPixels(const std::string& file) {
    std::vector<std::uint8_t> pixels(24 * 16 * 3);
    const tjhandle reader = tjInitDecompress();
    const int failed = tjDecompress2(reader, reinterpret_cast<const unsigned char*>(file.data()), file.size(), pixels.data(), 24,
                                     0, 16, TJPF_RGB, 0);
    tjDestroy(reader);
    return failed ? std::vector<std::uint8_t>{} : pixels;
}

struct PngSource {
    const std::string* file;
    std::size_t at;
};

/// Texts of a PNG file; a chunk with a wrong length or a wrong sum is an error.
std::map<std::string, std::string> pngTexts(const std::string& file) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    PngSource source{&file, 0};
    std::map<std::string, std::string> texts;
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_read_fn(png, &source, [](png_structp p, png_bytep out, std::size_t size) {
            auto* from = static_cast<PngSource*>(png_get_io_ptr(p));
            if (from->at + size > from->file->size()) png_error(p, "the file ends");
            std::copy_n(from->file->begin() + long(from->at), size, out);
            from->at += size;
        });
        png_read_info(png, info);
        png_textp found = nullptr;
        int count = 0;
        png_get_text(png, info, &found, &count);
        for (int i = 0; i < count; ++i) texts[found[i].key] = found[i].text;
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return texts;
}

} // namespace

class ImageMetadataTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void readersOfJpegFindIt() {
        const std::string plain = fileOf("a.jpg");
        QCOMPARE(jpegComments(plain), std::vector<std::string>());
        for (const std::string& note : {std::string("time = 0.5 s; tick = 50"), std::string("x"), std::string(65533, 'y')}) {
            const std::string file = withMetadata(plain, note);
            QCOMPARE(jpegComments(file), std::vector{note});
            QVERIFY(jpegPixels(file) == jpegPixels(plain) && !jpegPixels(file).empty());
        }
        QCOMPARE(withMetadata(plain, std::string(65534, 'y')), plain); // more than a segment holds
    }

    void readersOfPngFindIt() {
        const std::string plain = fileOf("a.png");
        QVERIFY(pngTexts(plain).empty());
        for (const std::string& note : {std::string("time = 0.5 s; tick = 50"), std::string("x"), std::string(70000, 'y')})
            QCOMPARE(pngTexts(withMetadata(plain, note)), (std::map<std::string, std::string>{{"Comment", note}}));
    }

    void otherFilesStayAsTheyAre() {
        for (const char* bytes : {"", "GIF89a", "\xff\xd8", "\x89PNG"}) QCOMPARE(withMetadata(bytes, "note"), std::string(bytes));
    }

    void itSaysWhenAndFromWhere() {
        CameraImage frame;
        frame.time = 0.5, frame.tick = 50, frame.width = 320, frame.height = 240;
        SettingsSpec settings;
        settings.seed = 7;
        QCOMPARE(imageMetadata(frame, nullptr, settings), std::string("time = 0.5 s; tick = 50; seed = 7; size = 320 x 240"));
        CameraModel camera;
        camera.path = "r/eye";
        camera.mode = CameraMode::Depth;
        camera.fieldOfView = 1.0471975511965976;
        settings.title = "Two lamps";
        QCOMPARE(imageMetadata(frame, &camera, settings),
                 std::string("time = 0.5 s; tick = 50; seed = 7; size = 320 x 240; camera = r/eye; mode = depth; "
                             "field of view = 60 deg; experiment = Two lamps"));
    }
};

QTEST_APPLESS_MAIN(ImageMetadataTest)
#include "image_metadata_test.moc"
