// Malicious asset files. Each must give an error that names the file; none may crash this process or exceed the reader's own
// time limit, so a hang fails here.

#include <QBuffer>
#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include <sys/stat.h>
#include <unistd.h>

#include "assets/asset_reader.h"
#include "base/platform/limits.h"
#include "sample_files.h"

using namespace trundle;

namespace {

std::uint32_t crc32(const QByteArray& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char letter : bytes) {
        crc ^= static_cast<unsigned char>(letter);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
    }
    return ~crc;
}

QByteArray bigEndian(std::uint32_t number) {
    QByteArray bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.append(static_cast<char>(number >> shift));
    return bytes;
}

QByteArray pngChunk(const QByteArray& kind, const QByteArray& content) {
    return bigEndian(static_cast<std::uint32_t>(content.size())) + kind + content + bigEndian(crc32(kind + content));
}

QByteArray png(std::uint32_t columns, std::uint32_t rows) {
    const QByteArray header = bigEndian(columns) + bigEndian(rows) + QByteArray("\x08\x00\x00\x00\x00", 5);
    return QByteArray("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", header) +
           pngChunk("IDAT", qCompress(QByteArray(100, '\0')).mid(4)) + pngChunk("IEND", {});
}

/// An image of `columns` x 48 pixels, written by Qt.
QByteArray savedAs(const char* format, int columns = 64) {
    QImage picture(columns, 48, QImage::Format_RGB32);
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < columns; ++x) picture.setPixel(x, y, qRgb(x * 4, y * 5, x * y % 256));
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, format)) qFatal("no %s", format);
    return buffer.data();
}

QByteArray withThumbnail(QByteArray jpeg) {
    const QByteArray small = savedAs("jpg", 8);
    return jpeg.insert(2, "\xff\xe1" + bigEndian(static_cast<std::uint32_t>(small.size()) + 2).mid(2) + small);
}

/// Replaces the height in the header.
QByteArray tallerThanItIs(QByteArray jpeg, int height = 4000) {
    const qsizetype at = jpeg.indexOf("\xff\xc0") + 5;
    return jpeg.replace(at, 2, bigEndian(static_cast<std::uint32_t>(height)).mid(2));
}

/// Run-length encoded, 64 columns of 8 bits, all of colour 0.
QByteArray packedBmp(int rows) {
    const auto little = [](std::uint32_t number) {
        QByteArray bytes = bigEndian(number);
        std::reverse(bytes.begin(), bytes.end());
        return bytes;
    };
    const QByteArray colours(1024, '\0'), runs = QByteArray("\x40\x00\x00\x00", 4).repeated(rows) + QByteArray("\x00\x01", 2);
    return "BM" + little(1078 + static_cast<std::uint32_t>(runs.size())) + little(0) + little(1078) + little(40) + little(64) +
           little(static_cast<std::uint32_t>(rows)) + QByteArray("\x01\x00\x08\x00", 4) + little(1) +
           little(static_cast<std::uint32_t>(runs.size())) + little(2835) + little(2835) + little(256) + little(0) + colours +
           runs;
}

QByteArray doublingNodes(int levels) {
    QByteArray nodes;
    for (int i = 0; i < levels; ++i) {
        const QByteArray next = "<instance_node url=\"#n" + QByteArray::number(i + 1) + "\"/>";
        nodes += "<node id=\"n" + QByteArray::number(i) + "\">" + next + next + "</node>";
    }
    return nodes + "<node id=\"n" + QByteArray::number(levels) + "\"><instance_geometry url=\"#g\"/></node>";
}

} // namespace

class HostileFilesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_reader = std::make_unique<AssetReader>(TRUNDLE_MESHREADER); }

    void aHostileMeshIsAnError_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("word");
        const QByteArray points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("empty") << "a.obj" << QByteArray() << "empty";
        QTest::newRow("one blank") << "a.stl" << QByteArray(" ") << "";
        QTest::newRow("text that is no OBJ") << "a.obj" << QByteArray("hello, I am a text of some length\n") << "";
        QTest::newRow("text that is no glTF") << "a.gltf" << QByteArray("hello, I am a text of some length\n") << "format";
        QTest::newRow("zeros") << "a.glb" << QByteArray(1000, '\0') << "";
        QTest::newRow("an STL that lies about its count")
            << "a.stl" << binaryStl(4000000000u, {0, 0, 0, 1, 0, 0, 0, 1, 0}) << "count";
        QTest::newRow("a truncated STL") << "a.stl" << binaryStl(2, {0, 0, 0, 1, 0, 0, 0, 1, 0}) << "count";
        QTest::newRow("a NaN in an STL") << "a.stl" << binaryStl(1, {0, 0, 0, nan, 0, 0, 0, 1, 0}) << "not a number";
        QTest::newRow("a NaN in an OBJ") << "a.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n") << "not a number";
        QTest::newRow("a number too large") << "a.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1e99 0\nf 1 2 3\n") << "not a number";
        QTest::newRow("a point out of this world") << "a.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n") << "away";
        QTest::newRow("an index too large") << "a.obj" << points + "f 1 2 4\n"
                                            << "out of range";
        QTest::newRow("an index far too large") << "a.obj" << points + "f 1 2 99999999999999999999\n"
                                                << "";
        QTest::newRow("an index zero") << "a.obj" << points + "f 0 1 2\n"
                                       << "index";
        QTest::newRow("an index too negative") << "a.obj" << points + "f 1 2 -9\n"
                                               << "out of range";
        QTest::newRow("points without faces") << "a.obj" << points << "no triangle";
        QTest::newRow("triangles without area") << "a.obj" << points + "f 1 1 1\n"
                                                << "no triangle";
        QTest::newRow("a COLLADA node that holds itself")
            << "a.dae" << collada("<node id=\"a\"><instance_node url=\"#a\"/></node>") << "damaged";
        QTest::newRow("two COLLADA nodes that hold each other")
            << "a.dae"
            << collada("<node><instance_node url=\"#a\"/></node>",
                       "<node id=\"a\"><instance_node url=\"#b\"/></node><node id=\"b\"><instance_node url=\"#a\"/></node>")
            << "damaged";
        QTest::newRow("a hundred thousand nodes deep")
            << "a.dae" << collada(QByteArray("<node>").repeated(100000) + QByteArray("</node>").repeated(100000)) << "";
        QTest::newRow("XML cut off") << "a.dae" << collada("<node/>").left(300) << "";
        QTest::newRow("a glTF node that holds itself")
            << "a.gltf"
            << QByteArray(
                   "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[0]}]}")
            << "recursive";
        QTest::newRow("a glTF that counts more than it has")
            << "a.gltf" << gltf("data:application/octet-stream;base64," + gltfBuffer().toBase64(), "1000000000") << "range";
        QTest::newRow("a glTF that reads outside its folder")
            << "a.gltf" << gltf("../../../../etc/passwd") << "outside its folder";
        QTest::newRow("a glTF through a link to outside") << "a.gltf" << gltf("link.bin") << "outside its folder";
        QTest::newRow("another format in disguise")
            << "a.obj" << QByteArray("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n") << "";
        QTest::newRow("a name of no mesh") << "a.exe" << QByteArray("MZ") << "OBJ, STL";
    }
    void aHostileMeshIsAnError() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, word);
        const QTemporaryDir folder;
        QCOMPARE(::symlink("/etc/passwd", qPrintable(folder.filePath("link.bin"))), 0);
        expectError(m_reader->mesh(writeSample(folder.path(), name, bytes)), folder.filePath(name), word);
    }

    // 2^40 triangles in 6 kB of text: stopped by the memory limit.
    void limitsDecompression() {
        if (memoryLimitsAreOff()) return; // memory limits do not work under a sanitizer
        const QTemporaryDir folder;
        const std::string path =
            writeSample(folder.path(), "bomb.dae", collada("<node><instance_node url=\"#n0\"/></node>", doublingNodes(40)));
        expectError(m_reader->mesh(path), folder.filePath("bomb.dae"), "memory");
    }

    void aReaderThatNeverEndsIsStopped() {
        const QTemporaryDir folder;
        const std::string stub = writeSample(folder.path(), "reader", "#!/bin/sh\nexec sleep 1000\n");
        QCOMPARE(::chmod(stub.c_str(), 0700), 0);
        AssetReader impatient(stub, {.seconds = 0.2});
        expectError(impatient.mesh(writeSample(folder.path(), "a.obj", "v")), folder.filePath("a.obj"), "longer than 0.2 s");
    }

    void rejectsInvalidReaderOutput() {
        const QTemporaryDir folder;
        const std::string stub =
            writeSample(folder.path(), "reader", "#!/bin/sh\nprintf 'TRMESH02\\377\\377\\377\\377\\377\\377\\377\\377'\n");
        QCOMPARE(::chmod(stub.c_str(), 0700), 0);
        AssetReader gullible(stub);
        expectError(gullible.mesh(writeSample(folder.path(), "a.obj", "v")), folder.filePath("a.obj"), "too many");
    }

    void aHostilePictureIsAnError_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("word");
        QTest::newRow("32768 x 32768") << "a.png" << png(32768, 32768) << "32768 x 32768";
        QTest::newRow("2147483647 x 2147483647") << "a.png" << png(0x7fffffff, 0x7fffffff) << "";
        QTest::newRow("nothing wide") << "a.png" << png(0, 8) << "";
        QTest::newRow("text") << "a.png" << QByteArray("no picture at all") << "not a picture";
        QTest::newRow("cut off") << "a.png" << png(64, 64).left(40) << "";
        for (const char* format : {"png", "jpg", "bmp", "ppm"}) {
            const QByteArray good = savedAs(format);
            QTest::addRow("half a %s", format)
                << QString("a.") + format << good.left(good.size() / 2) << (QByteArray(format) == "ppm" ? "damaged" : "cut off");
        }
        QTest::newRow("a JPEG without its last byte") << "a.jpg" << savedAs("jpg").chopped(1) << "cut off";
        QTest::newRow("a JPEG with a whole thumbnail, cut off")
            << "a.jpg" << withThumbnail(savedAs("jpg")).chopped(200) << "cut off";
        QTest::newRow("a JPEG cut off, with an end put on") << "a.jpg" << savedAs("jpg").chopped(400) + "\xff\xd9"
                                                            << "damaged";
        QTest::newRow("a JPEG taller than it says") << "a.jpg" << tallerThanItIs(savedAs("jpg")) << "damaged";
        QTest::newRow("a packed BMP cut off") << "a.bmp" << packedBmp(48).left(1080) << "cut off";
        QTest::newRow("a PNG without points") << "a.png" << png(0, 8) << "no points";
        QTest::newRow("a JPEG without points") << "a.jpg" << tallerThanItIs(savedAs("jpg"), 0) << "";
        QTest::newRow("a wrong sum") << "a.png" << png(64, 64).replace("IDAT", "IDAX") << "";
        QTest::newRow("a drawing in XML") << "a.png"
                                          << QByteArray("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>") << "";
        QTest::newRow("empty") << "a.png" << QByteArray() << "empty";
        QTest::newRow("a name of no picture") << "a.obj" << png(2, 2) << "PNG, JPEG";
    }
    void aHostilePictureIsAnError() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, word);
        const QTemporaryDir folder;
        const std::string path = writeSample(folder.path(), name, bytes);
        expectError(m_reader->heightMap(path), folder.filePath(name), word);
        expectError(m_reader->picture(path), folder.filePath(name), word);
    }

    void aWholeJpegIsReadWhateverFollowsIt() {
        const QTemporaryDir folder;
        const QByteArray good = withThumbnail(savedAs("jpg"));
        for (const QByteArray& bytes : {good, good + QByteArray(100, '\0'), good + good.left(good.size() / 2)}) {
            const auto picture = m_reader->picture(writeSample(folder.path(), "a.jpg", bytes));
            QVERIFY2(picture.ok(), picture.ok() ? "" : picture.error().message.c_str());
            QCOMPARE(picture.value()->width, 64u);
        }
    }

    void aPackedBmpIsRead() {
        const QTemporaryDir folder;
        const auto picture = m_reader->picture(writeSample(folder.path(), "a.bmp", packedBmp(48)));
        QVERIFY2(picture.ok(), picture.ok() ? "" : picture.error().message.c_str());
        QCOMPARE(picture.value()->height, 48u);
    }

    // A height map needs at least 2 x 2 heights, an image one pixel.
    void aPictureOfOneRowIsNoGround() {
        const QTemporaryDir folder;
        const std::string path = writeSample(folder.path(), "a.png", png(8, 1));
        expectError(m_reader->heightMap(path), folder.filePath("a.png"), "at least 2 x 2");
        QVERIFY(m_reader->picture(path).ok());
    }

    void reportsNonFilesAtOnce() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir("folder.obj"));
        QCOMPARE(::mkfifo(qPrintable(folder.filePath("pipe.obj")), 0600), 0);
        QCOMPARE(::symlink("/dev/zero", qPrintable(folder.filePath("zero.obj"))), 0);
        expectError(m_reader->mesh(folder.filePath("folder.obj").toStdString()), folder.filePath("folder.obj"), "folder");
        expectError(m_reader->mesh(folder.filePath("pipe.obj").toStdString()), folder.filePath("pipe.obj"), "pipe");
        expectError(m_reader->mesh(folder.filePath("zero.obj").toStdString()), folder.filePath("zero.obj"), "device");
        expectError(m_reader->mesh(folder.filePath("none.obj").toStdString()), folder.filePath("none.obj"), "No such file");
    }

    // Valid files truncated at every length and with many flipped bytes: the result is an error or a mesh.
    void damagedFilesNeverCrash() {
        const QTemporaryDir folder;
        const std::vector<std::pair<QString, QByteArray>> good{
            {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
            {"a.stl", binaryStl(1, {0, 0, 0, 1, 0, 0, 0, 1, 0})},
            {"a.dae", collada("<node><instance_geometry url=\"#g\"/></node>")},
            {"a.gltf", gltf("data:application/octet-stream;base64," + gltfBuffer().toBase64())}};
        const int rounds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 200 : 10;
        for (const auto& [name, bytes] : good) {
            for (int round = 0; round < rounds; ++round) {
                QByteArray damaged = bytes;
                const qsizetype at = (round * 7919 + 13) % damaged.size();
                if (round % 2 == 0) damaged.truncate(at);
                else damaged[at] = static_cast<char>(damaged[at] ^ (1 << round % 7));
                const auto mesh = m_reader->mesh(writeSample(folder.path(), name, damaged));
                if (!mesh.ok()) QVERIFY(mesh.error().message.find("took longer") == std::string::npos);
            }
        }
    }

private:
    template <class Asset> void expectError(const Result<Asset>& result, const QString& path, const QString& word) {
        QVERIFY(!result.ok());
        const QString message = QString::fromStdString(result.error().message);
        QVERIFY2(message.contains(path), qPrintable(message));
        // A sanitizer reports the reader's crash with its own message; on a busy machine the time limit can be reached first.
        QVERIFY2(message.contains(word) || message.contains("its reader took longer than") ||
                     (memoryLimitsAreOff() && message.contains("Sanitizer")),
                 qPrintable(message));
        QVERIFY2(!message.contains('\n'), qPrintable(message));
        QCOMPARE(int(result.error().code), int(Code::MeshUnreadable));
    }

    std::unique_ptr<AssetReader> m_reader;
};

QTEST_APPLESS_MAIN(HostileFilesTest)
#include "hostile_files_test.moc"
