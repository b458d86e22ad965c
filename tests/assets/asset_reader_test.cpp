// Reading meshes, height maps and images through the reader process, with its cache and limits.
#include <QImage>
#include <QImageWriter>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>

#include "assets/asset_reader.h"
#include "sample_files.h"

using namespace trundle;

namespace {

using Point = std::array<double, 3>;

bool holds(const TriangleMesh& mesh, const Point& wanted) {
    return std::any_of(mesh.points.begin(), mesh.points.end(), [&](const Point& point) {
        return std::fabs(point[0] - wanted[0]) < 1e-6 && std::fabs(point[1] - wanted[1]) < 1e-6 &&
               std::fabs(point[2] - wanted[2]) < 1e-6;
    });
}

} // namespace

class AssetReaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_reader = std::make_unique<AssetReader>(TRUNDLE_MESHREADER);
    }

    void aQuadOfAnObjBecomesTwoTriangles() {
        const auto mesh = m_reader->mesh(sample("quad.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\n"));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QCOMPARE(mesh.value()->triangles.size(), std::size_t(2));
        QCOMPARE(mesh.value()->points.size(), std::size_t(4));
        QVERIFY(holds(*mesh.value(), {1, 2, 0}));
    }

    /// Some programs write .5 for 0.5.
    void numbersOfAnObjMayBeginWithTheirPoint() {
        const auto mesh = m_reader->mesh(sample("short.obj", "# .5 .5\nv .5 0 -.25\nv 1\t.75 0\nv 0 1 .125\nf 1 2 3\n"));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QVERIFY(holds(*mesh.value(), {0.5, 0, -0.25}) && holds(*mesh.value(), {1, 0.75, 0}) &&
                holds(*mesh.value(), {0, 1, 0.125}));
    }

    void negativeObjIndicesCountFromTheEnd() {
        const auto mesh = m_reader->mesh(sample("back.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf -3 -2 -1\n"));
        QVERIFY(mesh.ok());
        QVERIFY(holds(*mesh.value(), {0, 3, 0}));
    }

    void theRepeatedCornersOfAnStlAreJoined() {
        const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, -0.0f};
        const auto mesh = m_reader->mesh(sample("two.STL", binaryStl(2, corners)));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QCOMPARE(mesh.value()->triangles.size(), std::size_t(2));
        QCOMPARE(mesh.value()->points.size(), std::size_t(4));
    }

    void aTextStlIsReadToo() {
        const auto mesh = m_reader->mesh(sample("text.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                                                            "0\nvertex 0 4 0\nendloop\nendfacet\nendsolid s\n"));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QVERIFY(holds(*mesh.value(), {0, 4, 0}));
    }

    /// Same points in the same winding order; with the reverse winding it is a different triangle.
    void trianglesThatRepeatOthersAreDropped() {
        const auto mesh = m_reader->mesh(sample("many.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\n" +
                                                                QByteArray("f 1 2 3\nf 4 3 1\nf 1 3 2\n").repeated(1000)));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QCOMPARE(mesh.value()->triangles.size(), std::size_t(2));
        QCOMPARE(mesh.value()->points.size(), std::size_t(3));
    }
    void trianglesWithoutAreaAreDropped() {
        const auto mesh =
            m_reader->mesh(sample("thin.stl", binaryStl(2, {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 5, 0, 0, 0, 1, 0})));
        QVERIFY(mesh.ok());
        QCOMPARE(mesh.value()->triangles.size(), std::size_t(1));
    }

    /// An STL repeats its corners in each triangle.
    void aClosedMeshThatIsInsideOutIsReversed() {
        const std::array<std::array<float, 3>, 4> points{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}}};
        const auto read = [&](std::initializer_list<std::array<std::size_t, 3>> faces) {
            std::vector<float> corners;
            for (const auto& face : faces)
                for (const std::size_t i : face) corners.insert(corners.end(), points[i].begin(), points[i].end());
            return m_reader->mesh(sample("solid.stl", binaryStl(std::uint32_t(faces.size()), corners)));
        };
        const std::vector<std::array<std::uint32_t, 3>> outwards{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
        const auto inside = read({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
        QVERIFY2(inside.ok(), inside.ok() ? "" : inside.error().message.c_str());
        QCOMPARE(inside.value()->points.size(), std::size_t(4));
        QCOMPARE(inside.value()->points[3], (Point{0, 0, 3}));
        QCOMPARE(inside.value()->triangles, outwards);
        const auto open = read({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}});
        QVERIFY(open.ok());
        QCOMPARE(open.value()->triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}}));
    }

    /// A node that mirrors does not exchange the sides of its triangles.
    void mirroredNodesKeepTheirOutside() {
        sample("triangle.bin", gltfBuffer());
        const auto normalOf = [&](const QByteArray& node) {
            const auto mesh = m_reader->mesh(sample("a.gltf", gltf("triangle.bin").replace("\"translation\":[0,5,0]", node)));
            if (!mesh.ok() || mesh.value()->triangles.size() != 1) return std::nan("");
            const auto& t = mesh.value()->triangles[0];
            const Point &a = mesh.value()->points[t[0]], &b = mesh.value()->points[t[1]], &c = mesh.value()->points[t[2]];
            return (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]); // along y
        };
        QCOMPARE(normalOf("\"scale\":[1,1,1]"), -2.0); // z of the file
        QCOMPARE(normalOf("\"scale\":[-1,1,1]"), -2.0);
        QCOMPARE(normalOf("\"scale\":[1,1,-1]"), 2.0);
        QCOMPARE(normalOf("\"scale\":[-1,-1,1]"), -2.0);
    }

    // z is up in the result, whichever axis is up in the file.
    void convertsColladaUpAxis_data() {
        QTest::addColumn<QByteArray>("upAxis");
        QTest::addColumn<QByteArray>("meter");
        QTest::addColumn<QByteArray>("moved");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        // the corner (0,0,2) of the file, moved by the node
        QTest::newRow("z up") << QByteArray("Z_UP") << QByteArray("1") << QByteArray("0 0 5") << 0.0 << 0.0 << 7.0;
        QTest::newRow("y up") << QByteArray("Y_UP") << QByteArray("1") << QByteArray("0 5 0") << 0.0 << -2.0 << 5.0;
        QTest::newRow("centimetres") << QByteArray("Z_UP") << QByteArray("0.01") << QByteArray("0 0 0") << 0.0 << 0.0 << 0.02;
    }
    void convertsColladaUpAxis() {
        QFETCH(QByteArray, upAxis);
        QFETCH(QByteArray, meter);
        QFETCH(QByteArray, moved);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        const QByteArray node = "<node><translate>" + moved + "</translate><instance_geometry url=\"#g\"/></node>";
        const auto mesh = m_reader->mesh(sample("a.dae", collada(node, {}, upAxis, meter)));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        const Point& corner = mesh.value()->points.back();
        QVERIFY2(holds(*mesh.value(), {x, y, z}), qPrintable(QString("%1 %2 %3").arg(corner[0]).arg(corner[1]).arg(corner[2])));
    }

    void gltfReadsItsBufferFromItsFolder() {
        sample("triangle.bin", gltfBuffer());
        const auto mesh = m_reader->mesh(sample("a.gltf", gltf("triangle.bin")));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().message.c_str());
        QVERIFY(holds(*mesh.value(), {0, 0, 7})); // y up in the file: (0,2,0) moved by (0,5,0)
        const auto same =
            m_reader->mesh(sample("b.gltf", gltf("data:application/octet-stream;base64," + gltfBuffer().toBase64())));
        QVERIFY2(same.ok(), same.ok() ? "" : same.error().message.c_str());
        QVERIFY(same.value()->points == mesh.value()->points);
    }

    void aFileIsReadOnceUntilItChanges() {
        const std::string path = sample("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const auto first = m_reader->mesh(path), second = m_reader->mesh(path);
        QVERIFY(first.ok() && second.ok());
        QVERIFY(first.value() == second.value());
        sample("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2.5 0\nf 1 2 3\n");
        const auto third = m_reader->mesh(path);
        QVERIFY(third.ok());
        QVERIFY(holds(*third.value(), {0, 2.5, 0}));
        QVERIFY(holds(*first.value(), {0, 1, 0})); // a mesh that is still referenced stays unchanged
    }

    void rereadsFixedFile() {
        const std::string path = sample("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 30\n");
        QVERIFY(!m_reader->mesh(path).ok());
        QVERIFY(!m_reader->mesh(path).ok());
        sample("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QVERIFY(m_reader->mesh(path).ok());
    }

    void greyBecomesHeight_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<QString>("name");
        QTest::newRow("8 bit") << int(QImage::Format_Grayscale8) << "a.png";
        QTest::newRow("16 bit") << int(QImage::Format_Grayscale16) << "a.png";
        QTest::newRow("colour") << int(QImage::Format_RGB32) << "a.png";
        QTest::newRow("bitmap") << int(QImage::Format_RGB32) << "a.bmp";
        QTest::newRow("pgm") << int(QImage::Format_Grayscale8) << "a.pgm";
    }
    void greyBecomesHeight() {
        QFETCH(int, format);
        QFETCH(QString, name);
        QImage picture(3, 2, QImage::Format_RGB32);
        picture.fill(Qt::black);
        picture.setPixel(2, 0, qRgb(255, 255, 255)); // top right
        picture.setPixel(0, 1, qRgb(51, 51, 51));    // bottom left
        QVERIFY(picture.convertToFormat(QImage::Format(format)).save(m_folder->filePath(name)));
        const auto map = m_reader->heightMap(m_folder->filePath(name).toStdString());
        QVERIFY2(map.ok(), map.ok() ? "" : map.error().message.c_str());
        QCOMPARE(map.value()->columns, 3u);
        QCOMPARE(map.value()->rows, 2u);
        const std::vector<float> wanted{0, 0, 1, 0.2f, 0, 0};
        for (std::size_t i = 0; i < wanted.size(); ++i) QVERIFY(std::fabs(map.value()->heights[i] - wanted[i]) < 1e-3);
    }

    /// Every grey value counts as much in a coloured picture as in a grey one.
    void everyGreyIsItsHeight() {
        QImage picture(256, 2, QImage::Format_RGB32);
        for (int x = 0; x < 256; ++x)
            for (int y = 0; y < 2; ++y) picture.setPixel(x, y, qRgb(x, x, x));
        for (const char* name : {"ramp.png", "ramp.bmp"}) {
            QVERIFY(picture.save(m_folder->filePath(name)));
            const auto map = m_reader->heightMap(m_folder->filePath(name).toStdString());
            QVERIFY2(map.ok(), map.ok() ? "" : map.error().message.c_str());
            for (std::size_t x = 0; x < 256; ++x) QVERIFY(std::fabs(map.value()->heights[x] - x / 255.0) < 1e-6);
        }
    }

    /// Heights of a PGM file with more than 8 bits, which are not those of its upper 8; comments and spaces as the format has them.
    void heightsOf16Bits_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("bytes") << QByteArray("P5\n# of a survey\n3 2 1000\n") +
                                      QByteArray::fromHex("0000 0001 03e8 00c8 0101 0102");
        QTest::newRow("text") << QByteArray("P2 3\n2 # points\n1000\n0 1 1000\n200 257\t258 \n");
    }
    void heightsOf16Bits() {
        QFETCH(QByteArray, content);
        QFile file(m_folder->filePath("deep.pgm"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        const auto map = m_reader->heightMap(file.fileName().toStdString());
        QVERIFY2(map.ok(), map.ok() ? "" : map.error().message.c_str());
        QCOMPARE(map.value()->columns, 3u);
        QCOMPARE(map.value()->rows, 2u);
        QCOMPARE(map.value()->heights, (std::vector<float>{0, 0.001f, 1, 0.2f, 0.257f, 0.258f}));
    }
    void aDamagedPictureOf16Bits_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("words");
        QTest::newRow("cut off") << QByteArray("P5 2 2 65535\n") + QByteArray(7, '\1') << "ends too early";
        QTest::newRow("cut off text") << QByteArray("P2 2 2 65535\n1 2 3") << "ends too early";
        QTest::newRow("beyond its white") << QByteArray("P2 2 2 300\n1 2 3 301\n") << "brighter than its white";
        QTest::newRow("no number") << QByteArray("P2 2 2 300\n1 2 x 301\n") << "damaged";
        QTest::newRow("huge") << QByteArray("P5 4294967295 4294967295 65535\nab") << "at most 4096 x 4096";
        QTest::newRow("one column") << QByteArray("P5 1 3 65535\nabcdef") << "at least 2 x 2";
    }
    void aDamagedPictureOf16Bits() {
        QFETCH(QByteArray, content);
        QFETCH(QString, words);
        QFile file(m_folder->filePath("damaged.pgm"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        const auto map = m_reader->heightMap(file.fileName().toStdString());
        QVERIFY(!map.ok());
        QVERIFY2(QString::fromStdString(map.error().message).contains(words), map.error().message.c_str());
    }

    void keepsColoursOfPictures() {
        QImage picture(3, 2, QImage::Format_RGB32);
        picture.fill(qRgb(10, 20, 30));
        picture.setPixel(2, 0, qRgb(250, 0, 5)); // top right
        QVERIFY(picture.save(m_folder->filePath("c.png")));
        const auto raster = m_reader->picture(m_folder->filePath("c.png").toStdString());
        QVERIFY2(raster.ok(), raster.ok() ? "" : raster.error().message.c_str());
        QCOMPARE(raster.value()->width, 3u);
        QCOMPARE(raster.value()->height, 2u);
        const std::vector<std::uint8_t> wanted{10, 20, 30, 10, 20, 30, 250, 0, 5, 10, 20, 30, 10, 20, 30, 10, 20, 30};
        QVERIFY(raster.value()->pixels == wanted);
    }

    void transparentPixelsAreWhite() {
        QImage picture(2, 1, QImage::Format_ARGB32);
        picture.setPixel(0, 0, qRgba(0, 0, 0, 0));
        picture.setPixel(1, 0, qRgba(255, 0, 0, 128));
        QVERIFY(picture.save(m_folder->filePath("clear.png")));
        const auto raster = m_reader->picture(m_folder->filePath("clear.png").toStdString());
        QVERIFY(raster);
        QCOMPARE(raster.value()->pixels, (std::vector<std::uint8_t>{255, 255, 255, 255, 127, 127}));
    }

    void appliesPhotoOrientation() {
        QImage picture(16, 8, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QImageWriter writer(m_folder->filePath("photo.jpg"));
        writer.setTransformation(QImageIOHandler::TransformationRotate90);
        QVERIFY(writer.write(picture));
        const auto raster = m_reader->picture(m_folder->filePath("photo.jpg").toStdString());
        QVERIFY(raster);
        QCOMPARE(raster.value()->width, 8u);
        QCOMPARE(raster.value()->height, 16u);
    }

    void aLargePictureIsMadeSmaller() {
        QImage picture(3000, 30, QImage::Format_RGB888);
        picture.fill(qRgb(10, 20, 30));
        QVERIFY(picture.save(m_folder->filePath("wide.png")));
        const auto raster = m_reader->picture(m_folder->filePath("wide.png").toStdString());
        QVERIFY(raster.ok());
        QCOMPARE(raster.value()->width, 2048u);
        QCOMPARE(raster.value()->pixels.size(), std::size_t(raster.value()->height) * 2048 * 3);
        QVERIFY(picture.copy(0, 0, 3000, 1).save(m_folder->filePath("thin.png")));
        const auto thin = m_reader->picture(m_folder->filePath("thin.png").toStdString());
        QVERIFY2(thin.ok(), thin.ok() ? "" : thin.error().message.c_str());
        QCOMPARE(thin.value()->pixels.size(), std::size_t(2048 * 3));
    }

    void withoutTheReadingProgramTheMessageNamesIt() {
        AssetReader lost("/nowhere/trundle-meshreader");
        const auto mesh = lost.mesh(sample("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(!mesh.ok());
        QVERIFY(mesh.error().message.find("/nowhere/trundle-meshreader") != std::string::npos);
    }

    /// Of what a reader writes about a failure a message has the first line that is not empty, its beginning.
    void aFailureHasTheFirstLineOfItsReader() {
        const std::string program =
            sample("reader", "#!/bin/sh\nprintf '\\n\\nno \\ttri\\033angles\177%0400d\\nmore' 7 >&2\nexit 1\n");
        QVERIFY(QFile::setPermissions(QString::fromStdString(program), QFile::ReadOwner | QFile::ExeOwner));
        const std::string path = sample("a.obj", "v 0 0 0\n");
        const auto mesh = AssetReader(program).mesh(path);
        QVERIFY(!mesh.ok());
        QCOMPARE(mesh.error().message, "cannot read " + path + ": no triangles" + std::string(288, '0'));
    }

    void aFileMayBeAsLargeAsTheLimit() {
        const QByteArray text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        const std::string path = sample("a.obj", text);
        const auto size = std::uint64_t(text.size());
        QVERIFY(AssetReader(TRUNDLE_MESHREADER, {.fileBytes = size}).mesh(path).ok());
        const auto mesh = AssetReader(TRUNDLE_MESHREADER, {.fileBytes = size - 1}).mesh(path);
        QVERIFY(!mesh.ok());
        QCOMPARE(mesh.error().message, "cannot read " + path + ": it is larger than 0 MiB");
    }

    /// By its ending, in letters of any size, at the end of the path; also for what is cached.
    void otherFilesAreNotRead() {
        const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        QVERIFY(m_reader->mesh(sample("a.OBJ", triangle)).ok());
        QVERIFY(m_reader->mesh(sample("z.obj", triangle)).ok());
        QVERIFY(QDir(m_folder->path()).mkdir("b.obj"));
        const std::string inside = sample("b.obj/plain", triangle), picture = sample("a.png", "x"),
                          text = sample("a.txt", triangle);
        for (const std::string& path : {inside, picture, text}) {
            const auto cached = m_reader->cachedMesh(path);
            QVERIFY(cached && !cached->ok() && cached->error().message.find("a mesh is an OBJ") != std::string::npos);
            QCOMPARE(m_reader->mesh(path).error().message, cached->error().message);
        }
        for (const auto& message :
             {m_reader->cachedPicture(text)->error().message, m_reader->cachedHeightMap(text)->error().message,
              m_reader->picture(text).error().message, m_reader->heightMap(text).error().message})
            QVERIFY(message.find("a picture is a PNG") != std::string::npos);
        const auto large =
            AssetReader(TRUNDLE_MESHREADER, {.fileBytes = 3u << 20}).mesh(sample("l.obj", QByteArray((3 << 20) + 1, ' ')));
        QVERIFY2(large.error().message.ends_with("it is larger than 3 MiB"), large.error().message.c_str());
    }

private:
    std::string sample(const QString& name, const QByteArray& bytes) const { return writeSample(m_folder->path(), name, bytes); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<AssetReader> m_reader;
};

QTEST_APPLESS_MAIN(AssetReaderTest)
#include "asset_reader_test.moc"
