#include "meshreader/picture_file.h"

#include <QBuffer>
#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QImageReader>

#include "assets/mesh_stream.h"
#include "base/platform/read_file.h"

namespace trundle {
namespace {

constexpr int kMostMegabytes = 256; ///< of one decoded picture
constexpr std::uint64_t kMostFileBytes = 256u << 20;

Error failure(const std::string& why) { return Error{Code::MeshUnreadable, why}; }

bool formatIsKnown(const QByteArray& format) {
    static const QList<QByteArray> known{"png", "jpeg", "jpg", "bmp", "pgm", "ppm", "pbm", "tiff", "tif"};
    return known.contains(format.toLower());
}

Status checkSize(const QSize& size) {
    if (!size.isValid()) return {}; // the header does not say; the allocation limit holds
    const auto columns = static_cast<std::uint64_t>(size.width()), rows = static_cast<std::uint64_t>(size.height());
    const std::string text = "it has " + std::to_string(columns) + " x " + std::to_string(rows) + " points, ";
    if (columns < 2 || rows < 2) return failure(text + "at least 2 x 2 are needed");
    if (columns > kMostGreySide || rows > kMostGreySide || columns * rows > kMostGreyPoints)
        return failure(text + "at most 4096 x 4096 can be used");
    return {};
}

HeightMap heightsOf(const QImage& grey) {
    HeightMap map;
    map.columns = static_cast<std::uint32_t>(grey.width());
    map.rows = static_cast<std::uint32_t>(grey.height());
    map.heights.reserve(std::size_t{map.columns} * map.rows);
    for (int row = 0; row < grey.height(); ++row) {
        const auto* line = reinterpret_cast<const quint16*>(grey.constScanLine(row));
        for (int column = 0; column < grey.width(); ++column) map.heights.push_back(static_cast<float>(line[column] / 65535.0));
    }
    return map;
}

Raster coloursOf(const QImage& picture) {
    Raster raster{static_cast<std::uint32_t>(picture.width()), static_cast<std::uint32_t>(picture.height()), {}};
    const std::size_t row = std::size_t{raster.width} * 3;
    raster.pixels.reserve(row * raster.height);
    for (int y = 0; y < picture.height(); ++y) {
        const uchar* line = picture.constScanLine(y);
        raster.pixels.insert(raster.pixels.end(), line, line + row);
    }
    return raster;
}

Result<QImage> decoded(const std::string& content) {
    int count = 1; // Qt looks for its picture plugins beside an application
    char name[] = "trundle-meshreader";
    char* names[] = {name, nullptr};
    const QCoreApplication application(count, names);

    QByteArray bytes = QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size()));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader::setAllocationLimit(kMostMegabytes);
    QImageReader reader(&buffer);
    reader.setAutoTransform(false);
    if (!reader.canRead()) return failure("it is not a picture of a known format, or it is damaged");
    if (!formatIsKnown(reader.format()))
        return failure("a picture is a PNG, JPEG, BMP, PGM or TIFF file, this is " + reader.format().toStdString());
    if (const Status size = checkSize(reader.size()); !size) return size.error();
    QImage picture = reader.read();
    if (picture.isNull()) return failure("the picture is damaged: " + reader.errorString().toStdString());
    if (const Status size = checkSize(picture.size()); !size) return size.error();
    return picture;
}

Result<QImage> readImage(const std::string& path) {
    const Result<std::string> content = readRegularFile(path, kMostFileBytes);
    if (!content) return content.error();
    return decoded(content.value());
}

} // namespace

Result<Raster> readColourFile(const std::string& path) {
    const Result<std::string> content = readRegularFile(path, kMostFileBytes);
    if (!content) return content.error();
    return readColours(content.value());
}

Result<Raster> readColours(const std::string& content) {
    Result<QImage> read = decoded(content);
    if (!read) return read.error();
    QImage picture = std::move(read).value();
    constexpr int most = kMostRasterSide;
    if (picture.width() > most || picture.height() > most)
        picture = picture.scaled(most, most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    picture = picture.convertToFormat(QImage::Format_RGB888);
    if (picture.isNull()) return failure("there is not enough memory for the picture");
    return coloursOf(picture);
}

Result<HeightMap> readPictureFile(const std::string& path) {
    const Result<QImage> picture = readImage(path);
    if (!picture) return picture.error();
    const QImage grey = picture.value().convertToFormat(QImage::Format_Grayscale16);
    if (grey.isNull()) return failure("there is not enough memory for the picture");
    return heightsOf(grey);
}

} // namespace trundle
