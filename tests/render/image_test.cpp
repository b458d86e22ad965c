// Images and their file formats.
#include <QtTest>

#include <QFile>
#include <QTemporaryDir>

#include <png.h>
#include <turbojpeg.h>

#include "render/image.h"

using namespace trundle;

namespace {

Image pattern(std::uint32_t width, std::uint32_t height) {
    Image image{width, height, {}};
    for (std::uint32_t i = 0; i < width * height * 3; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 7 + i / 13));
    return image;
}

Image readPng(const std::string& bytes) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) return {};
    png.format = PNG_FORMAT_RGB;
    Image image{png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
    return png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) ? image : Image{};
}

} // namespace

class ImageTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pngKeepsEveryPixel() {
        for (const auto& [width, height] : {std::pair{1u, 1u}, {7u, 3u}, {320u, 240u}}) {
            const Image image = pattern(width, height);
            const auto bytes = pngBytes(image);
            QVERIFY(bytes.ok());
            QVERIFY(readPng(bytes.value()) == image);
        }
    }

    void aJpegIsNearlyThePicture() {
        Image image{64, 48, std::vector<std::uint8_t>(64 * 48 * 3, 120)};
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) image.pixels[i] = 200;
        const auto bytes = jpegBytes(image);
        QVERIFY(bytes.ok());
        const tjhandle reader = tjInitDecompress();
        Image read{64, 48, std::vector<std::uint8_t>(64 * 48 * 3)};
        const int failed = tjDecompress2(reader, reinterpret_cast<const unsigned char*>(bytes.value().data()),
                                         bytes.value().size(), read.pixels.data(), 64, 0, 48, TJPF_RGB, 0);
        tjDestroy(reader);
        QCOMPARE(failed, 0);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) QVERIFY(std::abs(int(image.pixels[i]) - int(read.pixels[i])) <= 3);
    }

    void extensionSelectsFormat() {
        QTemporaryDir folder;
        const auto begins = [&](const char* name) {
            const std::string path = folder.filePath(name).toStdString();
            if (const Status saved = saveImage(pattern(8, 8), path); !saved) return codeName(saved.error().code);
            QFile file(folder.filePath(name));
            return file.open(QIODevice::ReadOnly) ? file.read(3).toHex().toStdString() : std::string("nothing");
        };
        QCOMPARE(begins("a.png"), std::string("89504e"));
        QCOMPARE(begins("a.PNG"), std::string("89504e"));
        QCOMPARE(begins("a.b.jpg"), std::string("ffd8ff"));
        QCOMPARE(begins("a.JPEG"), std::string("ffd8ff"));
        for (const char* name : {"a", "a.bmp", "a.png.txt", ".x"}) QCOMPARE(begins(name), std::string("E511"));
        QVERIFY(begins("missing folder/a.png").starts_with("E"));
    }

    void rejectsInconsistentPictureSize() {
        Image image = pattern(8, 8);
        image.height = 9;
        QVERIFY(!pngBytes(image).ok());
        QVERIFY(!jpegBytes(image).ok());
        QVERIFY(!pngBytes(Image{}).ok());
    }
};

QTEST_APPLESS_MAIN(ImageTest)
#include "image_test.moc"
