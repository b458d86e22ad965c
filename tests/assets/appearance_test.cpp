// Appearance of meshes as given by their files: colours, textures, and the locations from which textures may be read.
#include <QBuffer>
#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include <unistd.h>

#include "assets/asset_reader.h"
#include "base/mesh_appearance.h"
#include "base/missing_asset.h"
#include "pictured_files.h"
#include "sample_files.h"

using namespace trundle;

namespace {

QByteArray saved(const QImage& picture, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, format)) qFatal("no %s", format);
    return bytes;
}

/// 2 x 2: red, green / blue, white.
QByteArray fourColours() {
    QImage picture(2, 2, QImage::Format_RGB32);
    picture.setPixel(0, 0, qRgb(255, 0, 0));
    picture.setPixel(1, 0, qRgb(0, 255, 0));
    picture.setPixel(0, 1, qRgb(0, 0, 255));
    picture.setPixel(1, 1, qRgb(255, 255, 255));
    return saved(picture, "PNG");
}

/// A triangle whose corners map to the lower left, lower right and upper left corner of its texture.
QByteArray objWith(const QByteArray& materials) {
    return "mtllib " + materials +
           "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl paint\nf 1/1 2/2 3/3\nv 0 0 5\nv 1 0 5\nv 0 1 5\n"
           "usemtl steel\nf 4/1 5/2 6/3\n";
}

} // namespace

class LooksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir("meshes"));
        m_reader = std::make_unique<AssetReader>(TRUNDLE_MESHREADER);
        sample("paint.png", fourColours());
        writeSample(m_folder->path(), "secret.png", fourColours());
    }

    void meshWithoutMaterialsHasNoAppearance() {
        QVERIFY(!look("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(!look("a.stl", binaryStl(1, {0, 0, 0, 1, 0, 0, 0, 1, 0})));
        QVERIFY(!look("a.dae", collada("<node><instance_geometry url=\"#g\"/></node>")));
        QVERIFY(!look("a.gltf", gltf("data:application/octet-stream;base64," + gltfBuffer().toBase64())));
    }

    void readsMaterialColours() {
        sample("m.mtl", "newmtl paint\nKd 0.5 0.25 1\nd 0.5\nnewmtl steel\nKd 0.1 0.2 0.3\nKs 1 1 1\nNs 1000\nKe 0 0.5 0\n");
        const auto look = this->look("a.obj", objWith("m.mtl"));
        QVERIFY(look);
        QCOMPARE(look->materials.size(), std::size_t(2));
        QCOMPARE(look->material.size(), std::size_t(2));
        const MeshMaterial &paint = look->materials[look->material[0]], &steel = look->materials[look->material[1]];
        QCOMPARE(paint.colour, (std::array<float, 3>{0.5f, 0.25f, 1}));
        QCOMPARE(paint.opacity, 0.5f);
        QCOMPARE(steel.colour, (std::array<float, 3>{0.1f, 0.2f, 0.3f}));
        QCOMPARE(steel.emission, (std::array<float, 3>{0, 0.5f, 0}));
        QCOMPARE(steel.shininess, 1.f);
        QVERIFY(look->onPicture.empty());
        QVERIFY(look->warnings.empty());
    }

    // Every format maps the texture the same way: the first corner is its lower left one.
    void resolvesTexturePaths_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        const QByteArray data = "\"uri\":\"data:application/octet-stream;base64," + gltfNumbers().toBase64() + "\",";
        QTest::newRow("OBJ") << "a.obj" << objWith("p.mtl");
        QTest::newRow("COLLADA") << "a.dae" << daeWith("paint.png");
        QTest::newRow("COLLADA, with a dot") << "a.dae" << daeWith("./paint.png");
        QTest::newRow("COLLADA, from another machine") << "a.dae" << daeWith("file:///C:/Wood/paint.png");
        QTest::newRow("glTF") << "a.gltf" << gltfWith(gltfImage("paint.png"), data, 60);
        QTest::newRow("glTF, the picture in it")
            << "a.gltf" << gltfWith(gltfImage("data:image/png;base64," + fourColours().toBase64()), data, 60);
        QTest::newRow("GLB") << "a.glb" << glbWith(fourColours());
    }
    void resolvesTexturePaths() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        sample("p.mtl", "newmtl paint\nmap_Kd paint.png\nnewmtl steel\nmap_Kd paint.png\n");
        const auto look = this->look(name, bytes);
        QVERIFY(look);
        QVERIFY2(look->warnings.empty(), look->warnings.empty() ? "" : look->warnings[0].c_str());
        const auto& picture = look->materials[look->material[0]].picture;
        QVERIFY(picture);
        QCOMPARE(picture->width, 2u);
        QCOMPARE(picture->pixels, (std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}));
        QCOMPARE(look->onPicture[0], (std::array<std::array<float, 2>, 3>{{{0, 1}, {1, 1}, {0, 0}}}));
        for (const MeshMaterial& m : look->materials) QVERIFY(m.picture == picture); // stored once, however many materials use it
    }

    // Option numbers may be omitted, file names may contain blanks, and a file name may be a number.
    void theOptionsOfAnObjsPictureMoveIt_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<std::array<float, 2>>("scale");
        QTest::addColumn<std::array<float, 2>>("offset");
        using Two = std::array<float, 2>;
        QTest::newRow("none") << QByteArray("paint.png") << Two{1, 1} << Two{0, 0};
        QTest::newRow("one number") << QByteArray("-s 2 paint.png") << Two{2, 1} << Two{0, 0};
        QTest::newRow("two numbers") << QByteArray("-s 2 4 paint.png\r") << Two{2, 4} << Two{0, 0};
        QTest::newRow("three numbers") << QByteArray("-s 2 4 1 paint.png") << Two{2, 4} << Two{0, 0};
        QTest::newRow("two options") << QByteArray("-o 0.5 .25  -s\t2 3 paint.png") << Two{2, 3} << Two{0.5f, 0.25f};
        QTest::newRow("others") << QByteArray("-clamp on -blendu off -mm 0 1 -bm 1.0 -imfchan l -t 1 paint.png") << Two{1, 1}
                                << Two{0, 0};
        QTest::newRow("an unknown one") << QByteArray("-new 3 paint.png") << Two{1, 1} << Two{0, 0};
        QTest::newRow("a name with blanks") << QByteArray("-s 2 2 2 my 2 paint.png") << Two{2, 2} << Two{0, 0};
        QTest::newRow("a name that is a number") << QByteArray("-s 2 2 7") << Two{2, 2} << Two{0, 0};
    }
    void theOptionsOfAnObjsPictureMoveIt() {
        QFETCH(QByteArray, written);
        using Two = std::array<float, 2>;
        QFETCH(Two, scale);
        QFETCH(Two, offset);
        for (const char* name : {"my 2 paint.png", "7"}) sample(name, fourColours());
        sample("p.mtl", "newmtl paint \nKd 1 1 1\n  map_Kd " + written + "\nnewmtl steel\nmap_Kd paint.png\n");
        const auto look = this->look("a.obj", objWith("p.mtl"));
        QVERIFY(look);
        QVERIFY2(look->warnings.empty(), look->warnings.empty() ? "" : look->warnings[0].c_str());
        const auto& picture = look->materials[look->material[0]].picture;
        QVERIFY(picture && picture->width == 2);
        const float left = offset[0], lower = 1 - offset[1];
        QCOMPARE(look->onPicture[0], (std::array<Two, 3>{{{left, lower}, {left + scale[0], lower}, {left, lower - scale[1]}}}));
        QCOMPARE(look->onPicture[1], (std::array<Two, 3>{{{0, 1}, {1, 1}, {0, 0}}}));
    }

    void aPictureOfOnePixelIsOne() {
        QImage one(1, 1, QImage::Format_RGB32);
        one.fill(qRgb(9, 8, 7));
        const auto look = this->look("a.glb", glbWith(saved(one, "PNG")));
        QVERIFY(look && look->warnings.empty());
        QCOMPARE(look->materials[0].picture->pixels, (std::vector<std::uint8_t>{9, 8, 7}));
    }

    void aPictureInsideAFileIsNamedByItsNumber() {
        const QByteArray jpeg = saved(QImage(64, 64, QImage::Format_RGB32), "JPG");
        QByteArray bytes = glbWith(jpeg.left(jpeg.size() - 30));
        const auto reported = [&] {
            const auto look = this->look("a.glb", bytes);
            return look && !look->warnings.empty() ? look->warnings[0] : std::string();
        };
        const std::string why = "cannot be shown: the picture is cut off: its file ends too early";
        QCOMPARE(reported(), "the embedded picture 0 of its material paint " + why);
        bytes.replace("\"paint\"", "\"\"     ");
        QCOMPARE(reported(), "the embedded picture 0 " + why);
    }

    void colourOfGltfIsLight() {
        const auto look = this->look(
            "a.gltf", gltfWith(gltfImage("paint.png"),
                               "\"uri\":\"data:application/octet-stream;base64," + gltfNumbers().toBase64() + "\",", 60));
        QVERIFY(look);
        QCOMPARE(look->materials[0].colour, (std::array<float, 3>{0.5f, 0.5f, 0.5f}));
        QCOMPARE(look->materials[0].shininess, 0.75f);
    }

    // The mesh is valid; a missing part of its appearance is reported and replaced by a placeholder.
    void reportsUnavailablePicture_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QString>("word");
        QTest::newRow("missing") << QByteArray("none.png") << "not there";
        QTest::newRow("no picture") << QByteArray("text.png") << "not a picture";
        QTest::newRow("cut off") << QByteArray("short.png") << "shown";
        QTest::newRow("empty") << QByteArray("empty.png") << "shown";
        QTest::newRow("missing, after options") << QByteArray("-s 2 2 none.png") << "picture none.png";
        QTest::newRow("only options") << QByteArray("-s 2") << "picture 2";
        QTest::newRow("a folder") << QByteArray("folder.png") << "not there";
        QTest::newRow("a device") << QByteArray("/dev/zero") << "outside";
        QTest::newRow("out by dots") << QByteArray("../secret.png") << "outside";
        QTest::newRow("out by many dots") << QByteArray("x/../../../../../../../../etc/hostname") << "outside";
        QTest::newRow("out by its root") << QByteArray("/etc/passwd") << "outside";
        QTest::newRow("out through a link") << QByteArray("link.png") << "outside";
        QTest::newRow("out by backslashes") << QByteArray("..\\secret.png") << "outside";
        QTest::newRow("another scheme") << QByteArray("http://example.org/wood.png") << "not there";
        QTest::newRow("letters that are none") << QByteArray("\x01\x02 .png") << "not there";
        QTest::newRow("a very long name") << QByteArray(900, 'a') << "not there";
        QTest::newRow("a name that assimp forgets") << QByteArray(3000, 'a') << "not there";
    }
    void reportsUnavailablePicture() {
        QFETCH(QByteArray, written);
        QFETCH(QString, word);
        sample("text.png", "no picture at all");
        sample("short.png", fourColours().left(50));
        sample("empty.png", "");
        QVERIFY(QDir(folder()).mkdir("folder.png"));
        QCOMPARE(::symlink(qPrintable(m_folder->filePath("secret.png")), qPrintable(folder() + "/link.png")), 0);
        sample("p.mtl", "newmtl paint\nmap_Kd " + written + "\nnewmtl steel\n");
        const auto look = this->look("a.obj", objWith("p.mtl"));
        QVERIFY(look);
        QVERIFY(!look->warnings.empty());
        const QString reported = QString::fromStdString(look->warnings[0]);
        QVERIFY2(reported.contains(word), qPrintable(reported));
        QVERIFY2(!reported.contains('\n') && reported.size() <= 300, qPrintable(reported));
        const auto& worn = look->materials[look->material[0]].picture;
        QVERIFY(worn);
        QCOMPARE(worn->pixels, missingAssetPicture()->pixels);
    }

    void reportsMissingMaterialsFile() {
        QVERIFY(QDir(folder()).mkdir("folder.mtl"));
        QCOMPARE(::symlink("loop.mtl", qPrintable(folder() + "/loop.mtl")), 0);
        sample("text.txt", "newmtl paint\n");
        for (const auto& [name, why] : {std::pair{"none.mtl", "is not there"},
                                        {"folder.mtl", "is a folder"},
                                        {"loop.mtl", "is a link that leads back to itself"},
                                        {"text.txt", "does not end in .mtl"},
                                        {"/etc/passwd", "is not there"}}) {
            const auto look = this->look("a.obj", objWith(name));
            QVERIFY(look);
            QCOMPARE(look->warnings, (std::vector<std::string>{std::string("its file of materials, ") + name + ", " + why}));
        }
    }

    void materialsOutsideTheFolderAreRefused() {
        writeSample(m_folder->path(), "secret.mtl", "newmtl paint\nKd 1 0 0\n");
        const auto mesh = m_reader->mesh(sample("a.obj", objWith("../secret.mtl")));
        QVERIFY(!mesh.ok());
        QVERIFY2(mesh.error().message.find("outside its folder") != std::string::npos, mesh.error().message.c_str());
    }

    void aThousandPicturesAreTooMany() {
        QByteArray materials, faces = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nvt 0 0\n";
        for (int i = 0; i < 1000; ++i) {
            const QByteArray number = QByteArray::number(i);
            sample("p" + QString::number(i) + ".png", fourColours());
            materials += "newmtl m" + number + "\nmap_Kd p" + number + ".png\n";
            faces += "usemtl m" + number + "\nv 0 1 " + number + "\nf 1/1 2/1 -1/1\n";
        }
        sample("m.mtl", materials);
        const auto look = this->look("a.obj", faces);
        QVERIFY(look);
        QVERIFY(!look->warnings.empty() && look->warnings.size() <= 16);
        QVERIFY2(look->warnings[0].find("one too many") != std::string::npos, look->warnings[0].c_str());
    }

private:
    [[nodiscard]] QString folder() const { return m_folder->filePath("meshes"); }
    std::string sample(const QString& name, const QByteArray& bytes) { return writeSample(folder(), name, bytes); }
    /// The appearance of a mesh that must be readable.
    std::shared_ptr<const MeshAppearance> look(const QString& name, const QByteArray& bytes) {
        const auto mesh = m_reader->mesh(sample(name, bytes));
        if (!mesh.ok()) qFatal("%s", mesh.error().message.c_str());
        return mesh.value()->look;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<AssetReader> m_reader;
};

QTEST_APPLESS_MAIN(LooksTest)
#include "appearance_test.moc"
