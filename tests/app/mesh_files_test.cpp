// Which files belong to a mesh, and how they come into a project.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include "app/mesh_files.h"
#include "project/wizard/mesh_text.h"

using namespace trundle;

class MeshFilesTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

    std::string write(const QString& name, const QByteArray& text) {
        const QString path = m_folder.filePath(name);
        QDir().mkpath(QFileInfo(path).path());
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("%s cannot be written", qPrintable(path));
        return path.toStdString();
    }
    static QStringList sorted(const std::vector<std::string>& names) {
        QStringList all;
        for (const std::string& name : names) all << QString::fromStdString(name);
        all.sort();
        return all;
    }

private Q_SLOTS:
    void initTestCase() {
        for (const char* name : {"cup/paint.png", "cup/textures/dots.jpg", "cup/part one.bin", "secret.png"})
            (void)write(QLatin1String(name), "x");
        (void)write(QStringLiteral("cup/cup.mtl"), "newmtl a\r\nmap_Kd -s 1 1 1 paint.png\r\nbump textures\\dots.jpg\n");
    }

    /// Beside their mesh, under free names, with their shares of the mass.
    void hullsAreFilesOfTheirOwn() {
        TriangleMesh hull;
        hull.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.25}};
        hull.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        const std::string folder = m_folder.path().toStdString();
        const auto first = writeHulls({hull, hull}, "cup/cup.obj", folder), second = writeHulls({hull}, "cup/cup.obj", folder);
        QVERIFY(first.ok() && second.ok());
        QCOMPARE(first.value(), std::vector<std::string>({"cup/cup_part1.obj", "cup/cup_part2.obj"}));
        QCOMPARE(second.value(), std::vector<std::string>({"cup/cup2_part1.obj"}));
        QFile file(m_folder.filePath(QStringLiteral("cup/cup_part1.obj")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.25\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
        MeshPart part{.name = "cup", .file = "cup/cup.obj", .mass = 1};
        part.shape = {.kind = CollisionShape::Kind::Hulls, .files = first.value(), .volumes = {1, 2}};
        QCOMPARE(
            meshGeomsText(part),
            std::string("Mesh cup { File=cup/cup.obj Shape=none Material=grey Surface=wall }\n"
                        "Convex cupPart1 { File=cup/cup_part1.obj Visible=false Mass=0.3333 Material=grey Surface=wall }\n"
                        "Convex cupPart2 { File=cup/cup_part2.obj Visible=false Mass=0.6667 Material=grey Surface=wall }\n"));
        QVERIFY(!writeHulls({hull}, "none/cup.obj", folder));
    }

    void findsWhatAMeshRefersTo_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("expected");
        QTest::newRow("OBJ") << "cup.obj" << QByteArray("# mtllib no.mtl\nmtllib cup.mtl\r\nv 0 0 0\n")
                             << QStringList{"cup.mtl", "paint.png", "textures/dots.jpg"};
        (void)write(QStringLiteral("cup/SHINY.MTL"), "map_Kd paint.png\n");
        QTest::newRow("in capital letters") << "CUP2.OBJ" << QByteArray("mtllib SHINY.MTL\n")
                                            << QStringList{"SHINY.MTL", "paint.png"};
        QTest::newRow("COLLADA") << "cup.dae"
                                 << QByteArray(
                                        "<init_from>file://textures/dots.jpg</init_from><init_from> paint.png\n</init_from>")
                                 << QStringList{"paint.png", "textures/dots.jpg"};
        QTest::newRow("glTF")
            << "cup.gltf"
            << QByteArray(
                   R"({"buffers":[{"uri" : "part%20one.bin","byteLength":1},{"uri":"data:x,y"}],"images":[{"uri":"paint.png"}]})")
            << QStringList{"paint.png", "part one.bin"};
        QTest::newRow("another machine") << "far.dae" << QByteArray("<init_from>C:\\models\\paint.png</init_from>")
                                         << QStringList{"paint.png"};
        QTest::newRow("outside") << "out.dae"
                                 << QByteArray("<init_from>../secret.png</init_from><init_from>/etc/passwd</init_from>")
                                 << QStringList{};

        QTest::newRow("glTF with data that is a name")
            << "data.gltf" << QByteArray(R"({"images":[{"uri":"data:paint.png"}]})") << QStringList{};
        QTest::newRow("a path with file:// inside")
            << "odd.dae" << QByteArray("<init_from>file://xfile://paint.png</init_from>") << QStringList{"paint.png"};
        QTest::newRow("twice") << "twice.dae" << QByteArray("<init_from>paint.png</init_from><init_from>./paint.png</init_from>")
                               << QStringList{"paint.png"};
        QTest::newRow("a word alone") << "word.obj" << QByteArray("mtllib\nmtllib cup.mtl\n")
                                      << QStringList{"cup.mtl", "paint.png", "textures/dots.jpg"};
        QTest::newRow("an ending with a Z") << "cup.DAE" << QByteArray("<init_from>paint.png</init_from>")
                                            << QStringList{"paint.png"};

        QTest::newRow("STL") << "cup.stl" << QByteArray("solid mtllib cup.mtl") << QStringList{};
    }
    void findsWhatAMeshRefersTo() {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFETCH(QStringList, expected);
        QCOMPARE(sorted(filesOfMesh(write(QStringLiteral("cup/") + name, text))), expected);
    }

    void copiesAllIntoTheProject() {
        const std::string mesh = write(QStringLiteral("cup/cup.obj"), "mtllib cup.mtl\n");
        QTemporaryDir project;
        const Result<std::string> first = bringMesh(mesh, project.path().toStdString());
        QVERIFY2(first.ok(), first.ok() ? "" : first.error().message.c_str());
        QCOMPARE(first.value(), std::string("meshes/cup/cup.obj"));
        for (const char* name : {"cup.obj", "cup.mtl", "paint.png", "textures/dots.jpg"})
            QVERIFY(QFile::exists(project.filePath(QStringLiteral("meshes/cup/") + QLatin1String(name))));
        QCOMPARE(bringMesh(mesh, project.path().toStdString()).value(), std::string("meshes/cup2/cup.obj"));
        const std::string inside = project.filePath(QStringLiteral("meshes/cup/cup.obj")).toStdString();
        QCOMPARE(bringMesh(inside, project.path().toStdString()).value(), std::string("meshes/cup/cup.obj"));
        QVERIFY(!bringMesh(m_folder.filePath(QStringLiteral("none.obj")).toStdString(), project.path().toStdString()).ok());
        QVERIFY(!QFile::exists(project.filePath(QStringLiteral("meshes/none"))));
    }

    void namesOfBlocks() {
        QCOMPARE(meshName("meshes/Coffee cup (2).stl"), std::string("coffeeCup2"));
        QCOMPARE(meshName("cup.obj"), std::string("cup"));
        QCOMPARE(meshName("meshes.v2/3.stl"), std::string("mesh"));
    }
};

QTEST_APPLESS_MAIN(MeshFilesTest)
#include "mesh_files_test.moc"
