#include "meshreader/picture_file.h"

#include <QBuffer>
#include <QByteArray>
#include <QCoreApplication>
#include <QImage>
#include <QImageReader>
#include <QPainter>

#include <algorithm>
#include <climits>
#include <string>
#include <string_view>
#include <vector>

#include "assets/mesh_stream.h"
#include "base/platform/quiet_errors.h"
#include "base/platform/read_file.h"
#include "meshreader/deep_pgm.h"

namespace trundle {
namespace {

constexpr int kMaxMegabytes = 256; ///< limit of one decoded picture
constexpr std::uint64_t kMaxFileBytes = 256u << 20;
constexpr std::uint64_t kFewestHeights = 2, kFewestPixels = 1; ///< minimum along each side

Error failure(const std::string& why) { return Error{Code::MeshUnreadable, why}; }

bool formatIsKnown(const QByteArray& format) {
    static const QList<QByteArray> known{"png", "jpeg", "jpg", "bmp", "pgm", "ppm", "pbm"};
    return known.contains(format.toLower());
}

std::uint32_t littleEndianAt(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// Scans from marker to marker and over entropy-coded data, so that an end marker in a thumbnail or after the picture does not
/// count.
bool jpegEnds(std::string_view bytes) {
    std::size_t at = 0;
    while ((at = bytes.find('\xff', at)) != std::string_view::npos && at + 1 < bytes.size()) {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        if (marker == 0xd9) return true;
        if (marker == 0xff) ++at;
        else if (marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8)) at += 2;
        else if (at + 3 < bytes.size())
            at += 2u + (static_cast<unsigned char>(bytes[at + 2]) << 8) + static_cast<unsigned char>(bytes[at + 3]);
        else return false;
    }
    return false;
}

bool bmpEnds(std::string_view bytes) {
    if (bytes.size() < 54) return false;
    const bool packed = littleEndianAt(bytes, 30, 4) == 1 || littleEndianAt(bytes, 30, 4) == 2;
    if (littleEndianAt(bytes, 14, 4) < 40) return true; // a header version without a known length
    const std::uint64_t columns = littleEndianAt(bytes, 18, 4), bits = littleEndianAt(bytes, 28, 2);
    const auto rows = static_cast<std::int32_t>(littleEndianAt(bytes, 22, 4));  // negative: rows from the top
    const std::uint64_t rowBytes = packed ? 2 : (columns * bits + 31) / 32 * 4; // packed: only the minimum size is known
    return littleEndianAt(bytes, 10, 4) + rowBytes * static_cast<std::uint64_t>(std::abs(std::int64_t{rows})) <= bytes.size();
}

/// Qt accepts a truncated JPEG or BMP and fills in the rest, so truncation is detected here.
bool isWhole(const QByteArray& format, std::string_view bytes) {
    if (format == "jpeg") return jpegEnds(bytes);
    if (format == "png") return bytes.find("IEND") != std::string_view::npos;
    return format != "bmp" || bmpEnds(bytes);
}

/// Captures Qt's messages while it reads a picture, and suppresses libpng's output to standard error.
class ReaderMessages {
public:
    ReaderMessages() : m_before(qInstallMessageHandler(&take)) { s_words.clear(); }
    ~ReaderMessages() { qInstallMessageHandler(m_before); }
    ReaderMessages(const ReaderMessages&) = delete;
    ReaderMessages& operator=(const ReaderMessages&) = delete;

    /// Extraneous bytes between the segments of a JPEG are harmless.
    [[nodiscard]] bool reportDamage() const {
        return std::ranges::any_of(s_words, [](const std::string& words) {
            const bool corrupt = words.find("Corrupt JPEG data") != std::string::npos;
            return (corrupt && words.find("extraneous bytes") == std::string::npos) ||
                   words.find("Premature end") != std::string::npos;
        });
    }
    [[nodiscard]] bool reportTooFewPoints() const {
        return std::ranges::any_of(s_words, [](const std::string& words) {
            return words.find("is zero in IHDR") != std::string::npos || words.find("Empty JPEG") != std::string::npos;
        });
    }
    /// The last message; `otherwise` if there is none.
    [[nodiscard]] std::string lastOr(const QString& otherwise) const {
        if (s_words.empty()) return otherwise.toStdString();
        std::string words = s_words.back();
        for (const char* prefix : {"libpng error: ", "libpng warning: "})
            if (words.starts_with(prefix)) words.erase(0, std::string_view(prefix).size());
        return words;
    }

private:
    static void take(QtMsgType, const QMessageLogContext&, const QString& words) {
        if (s_words.size() < 100) s_words.push_back(words.toStdString());
    }
    static inline std::vector<std::string> s_words;
    QtMessageHandler m_before;
    QuietErrors m_quiet;
};

Status checkSize(const QSize& size, std::uint64_t fewest) {
    if (!size.isValid()) return {}; // the header has no size; the allocation limit applies
    const auto columns = static_cast<std::uint64_t>(size.width()), rows = static_cast<std::uint64_t>(size.height());
    const std::string text = "it has " + std::to_string(columns) + " x " + std::to_string(rows) + " points, ";
    if (columns < fewest || rows < fewest)
        return failure(text + "at least " + std::to_string(fewest) + " x " + std::to_string(fewest) + " are needed");
    if (columns > kMaxGreySide || rows > kMaxGreySide || columns * rows > kMaxGreyPoints)
        return failure(text + "at most 4096 x 4096 can be used");
    return {};
}

/// Grey values as they are in the file, without a way through linear light, of which dark shades have too few; those of a coloured
/// picture with the weights of qGray.
HeightMap heightsOf(const QImage& picture) {
    HeightMap map;
    map.columns = static_cast<std::uint32_t>(picture.width());
    map.rows = static_cast<std::uint32_t>(picture.height());
    map.heights.reserve(std::size_t{map.columns} * map.rows);
    const bool grey = picture.format() == QImage::Format_Grayscale16;
    for (int row = 0; row < picture.height(); ++row) {
        const uchar* line = picture.constScanLine(row);
        for (int column = 0; column < picture.width(); ++column) {
            if (grey) {
                map.heights.push_back(static_cast<float>(reinterpret_cast<const quint16*>(line)[column] / 65535.0));
                continue;
            }
            const QRgba64 colour = reinterpret_cast<const QRgba64*>(line)[column];
            map.heights.push_back(
                static_cast<float>((colour.red() * 11 + colour.green() * 16 + colour.blue() * 5) / (32 * 65535.0)));
        }
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

Result<HeightMap> heightsOf(const DeepPgm& picture) {
    constexpr auto largest = static_cast<std::uint32_t>(INT_MAX);
    const QSize size(static_cast<int>(std::min(picture.columns, largest)), static_cast<int>(std::min(picture.rows, largest)));
    if (const Status possible = checkSize(size, kFewestHeights); !possible) return possible.error();
    auto heights = picture.heights();
    if (!heights) return failure("the picture is damaged: its file ends too early, or a point is brighter than its white");
    return HeightMap{picture.columns, picture.rows, std::move(*heights)};
}

Result<QImage> decoded(const std::string& content, std::uint64_t fewest) {
    int count = 1; // Qt needs an application object to find its image plugins
    char name[] = "trundle-meshreader";
    char* names[] = {name, nullptr};
    const QCoreApplication application(count, names);

    QByteArray bytes = QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size()));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader::setAllocationLimit(kMaxMegabytes);
    QImageReader reader(&buffer);
    reader.setAutoTransform(true); // applies the orientation stored in EXIF
    const ReaderMessages words;
    if (!reader.canRead()) return failure("it is not a picture of a known format, or it is damaged");
    if (!formatIsKnown(reader.format()))
        return failure("a picture is a PNG, JPEG, BMP, PGM or PPM file, this is " + reader.format().toStdString());
    if (const Status size = checkSize(reader.size(), fewest); !size) return size.error();
    if (!isWhole(reader.format(), content)) return failure("the picture is cut off: its file ends too early");
    QImage picture = reader.read();
    if (words.reportTooFewPoints()) return failure("it has no points");
    if (picture.isNull()) return failure("the picture is damaged: " + words.lastOr(reader.errorString()));
    if (words.reportDamage()) return failure("the picture is damaged: " + words.lastOr({}));
    if (const Status size = checkSize(picture.size(), fewest); !size) return size.error();
    return picture;
}

} // namespace

Result<Raster> readColourFile(const std::string& path) {
    const Result<std::string> content = readRegularFile(path, kMaxFileBytes);
    if (!content) return content.error();
    return readColours(content.value());
}

Result<Raster> readColours(const std::string& content) {
    Result<QImage> read = decoded(content, kFewestPixels);
    if (!read) return read.error();
    QImage picture = std::move(read).value();
    constexpr int most = kMaxRasterSide;
    if (picture.width() > most || picture.height() > most)
        picture = picture.scaled(most, most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (picture.hasAlphaChannel()) { // the colour of transparent pixels is undefined
        QImage onWhite(picture.size(), QImage::Format_RGB32);
        onWhite.fill(Qt::white);
        QPainter(&onWhite).drawImage(0, 0, picture);
        picture = onWhite;
    }
    picture = picture.convertToFormat(QImage::Format_RGB888);
    if (picture.isNull()) return failure("there is not enough memory for the picture");
    return coloursOf(picture);
}

Result<HeightMap> readPictureFile(const std::string& path) {
    const Result<std::string> content = readRegularFile(path, kMaxFileBytes);
    if (!content) return content.error();
    if (const auto pgm = deepPgmIn(content.value())) return heightsOf(*pgm);
    const Result<QImage> picture = decoded(content.value(), kFewestHeights);
    if (!picture) return picture.error();
    const bool isGrey = picture.value().format() == QImage::Format_Grayscale16;
    const QImage deep = isGrey ? picture.value() : picture.value().convertToFormat(QImage::Format_RGBX64);
    if (deep.isNull()) return failure("there is not enough memory for the picture");
    return heightsOf(deep);
}

} // namespace trundle
