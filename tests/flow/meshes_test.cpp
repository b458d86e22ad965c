// Meshes as modelling programs export them: a closed one is solid, whichever side its triangles are counter-clockwise on.
#include <array>
#include <cmath>

#include "flow/cli.h"

namespace {

enum class Way { Outwards, Inwards, Mirrored, Mixed };

/// A box of 2 m x 2 m x 0.5 m on the origin.
QByteArray boxObj(Way way) {
    QByteArray text;
    for (int i = 0; i < 8; ++i) {
        const int x = (i & 1 ? 1 : -1) * (way == Way::Mirrored ? -1 : 1);
        text += "v " + QByteArray::number(x) + (i & 2 ? " 1" : " -1") + (i & 4 ? " 0.5\n" : " 0\n");
    }
    const std::array<std::array<int, 4>, 6> faces{
        {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const bool isReversed = way == Way::Inwards || (way == Way::Mixed && i == 1);
        text += 'f';
        for (std::size_t k = 0; k < 4; ++k) text += ' ' + QByteArray::number(faces[i][isReversed ? 3 - k : k]);
        text += '\n';
    }
    return text;
}

const char* const kThings =
    "Tick=0.01 Duration=1\n#import common/materials.sim\n#import common/surfaces.sim\n#import robots/simple_robot.sim\n"
    "RobotConfig Ball { Body b { Sphere s { Radius=0.05 Mass=0.1 Material=yellow Surface=rubber } } }\n"
    "RobotConfig Can { Body b { Cylinder c { Radius=0.05 Length=0.1 Mass=0.1 Material=yellow Surface=rubber } } }\n"
    "RobotConfig Pill { Body b { Capsule c { Radius=0.05 Length=0.1 HPR=0,90,0 Mass=0.1 Material=yellow Surface=rubber } } }\n"
    "RobotConfig Post { Body b { Box s { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=5 Material=yellow Surface=rubber } }\n"
    "  RangeSensor ahead { Body=b Pos=0.06,0,0.05 MinRange=0.01 MaxRange=5 } }\n"
    "StaticConfig Hall { Plane floor { Material=concrete Surface=ground } Mesh stage { File=box.obj Material=red Surface=wall } "
    "}\n"
    "Static hall { Config=Hall }\nRobot post { Config=Post Pos=-3,0,0 }\n";

} // namespace

class MeshesFlowTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

    QString file(const QByteArray& robots) {
        const QString path = m_folder.filePath("box.sim");
        return writeFile(path, kThings + robots) ? path : QString();
    }

private Q_SLOTS:
    void aClosedMeshIsSolid_data() {
        QTest::addColumn<int>("way");
        QTest::newRow("outwards") << int(Way::Outwards);
        QTest::newRow("inwards") << int(Way::Inwards);
        QTest::newRow("mirrored") << int(Way::Mirrored);
        QTest::newRow("one face inwards") << int(Way::Mixed);
    }
    /// What is round rests on it, wheels do not sink in, a beam ends at it, and what is inside is reported.
    void aClosedMeshIsSolid() {
        QFETCH(int, way);
        QVERIFY(writeFile(m_folder.filePath("box.obj"), boxObj(Way(way))));
        const Outcome run = cli({"run",
                                 file("Robot ball { Config=Ball Pos=-0.5,0.5,0.55 }\nRobot can { Config=Can Pos=0.5,0.5,0.55 }\n"
                                      "Robot pill { Config=Pill Pos=0.5,-0.5,0.55 }\n"
                                      "Robot car { Config=SimpleRobot Pos=-0.4,-0.4,0.5 }\n"),
                                 "--json", "--quiet", "--log-dir", m_folder.filePath("logs")});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject robots = QJsonDocument::fromJson(run.out).object()["robots"].toObject();
        const auto height = [&](const char* name) { return robots[name].toObject()["pos"].toArray()[2].toDouble(); };
        for (const char* name : {"ball", "can", "pill"}) QVERIFY2(std::abs(height(name) - 0.55) < 1e-3, shown(run));
        QVERIFY2(std::abs(height("car") - 0.5) < 1e-3, shown(run));
        const double range = robots["post"].toObject()["signals"].toObject()["ahead/range"].toDouble();
        QVERIFY2(std::abs(range - 1.94) < 1e-6, QByteArray::number(range));

        const Outcome check = cli({"check", file("Robot ball { Config=Ball Pos=0.5,0.5,0.2 }\n")});
        QVERIFY2(check.err.contains("warning E326: ball starts below hall/stage"), shown(check));
    }
};

QTEST_GUILESS_MAIN(MeshesFlowTest)
#include "meshes_test.moc"
