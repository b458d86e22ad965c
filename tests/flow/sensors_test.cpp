// Sensors end to end: a lidar robot goes around its room, a round one around its line, a sensor of a module is like one that comes with the program.

#include <numbers>

#include "flow/cli.h"

namespace {

/// Cells of a log by row, without the header.
QList<QByteArrayList> linesOf(const QString& path) {
    QList<QByteArrayList> lines;
    for (const QByteArray& line : contentOf(path).trimmed().split('\n')) lines << line.split(',');
    if (!lines.isEmpty()) lines.removeFirst();
    return lines;
}

} // namespace

class SensorsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aWallFollowerReadsNothingButItsLidarAndItsWheels() {
        const QByteArray text = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/plugins/controllers/wall_follow/wall_follow.cpp"));
        QVERIFY(text.contains("robot.lidar("));
        for (const char* word : {"groundTruth", "signal(", "camera(", "motor(", "gps(", "compass("})
            QVERIFY2(!text.contains(word), word);
    }

    void aWallFollowerGoesAroundItsRoom_data() {
        QTest::addColumn<int>("seed");
        QTest::addColumn<QString>("side");
        for (int i = 0; i < 20; ++i) QTest::addRow("seed %d", 4000 + 37 * i) << 4000 + 37 * i << "left";
        for (int i = 0; i < 3; ++i) QTest::addRow("seed %d, right", 90 + i) << 90 + i << "right";
    }
    void aWallFollowerGoesAroundItsRoom() {
        QFETCH(int, seed);
        QFETCH(QString, side);
        QTemporaryDir logs;
        const Outcome run = cli({"run", configPath("experiments/wall_follow.sim"), "--seed", QString::number(seed), "--set",
                                 "seeker.brain.Side=" + side, "--json", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject finished = QJsonDocument::fromJson(run.out).object()["finished"].toObject();
        QVERIFY2(finished["reason"].toString() == "went around", shown(run));
        // It was within 0.5 m of every wall, and near the free end of the partition, but in none of them.
        double north = -9, south = 9, east = -9, west = 9, tip = 9;
        for (const QByteArrayList& line : linesOf(logs.filePath("wall_follow.csv"))) {
            const double x = line[2].toDouble(), y = line[3].toDouble();
            north = std::max(north, y);
            south = std::min(south, y);
            east = std::max(east, x);
            west = std::min(west, x);
            tip = std::min(tip, std::hypot(x - 0.7, y - 0.6));
        }
        const QString reached = QString("x %1 to %2, y %3 to %4, tip %5").arg(west).arg(east).arg(south).arg(north).arg(tip);
        QVERIFY2(north > 1.5 && north < 1.95 && south < -1.5 && south > -1.95, qPrintable(reached));
        QVERIFY2(east > 2 && east < 2.45 && west < -2 && west > -2.45, qPrintable(reached));
        QVERIFY2(tip > 0.12 && tip < 0.5, qPrintable(reached));
    }

    void aLineFollowerReadsNothingButItsGroundSensorsAndItsWheels() {
        const QByteArray text = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/plugins/controllers/line_follow/line_follow.cpp"));
        QVERIFY(text.contains("robot.groundSensor("));
        for (const char* word : {"groundTruth", "signal(", "camera(", "motor(", "gps(", "compass(", "lidar("})
            QVERIFY2(!text.contains(word), word);
    }

    void aLineFollowerGoesAroundItsLine_data() {
        QTest::addColumn<int>("seed");
        const int seeds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 20 : 4;
        for (int i = 0; i < seeds; ++i) QTest::addRow("seed %d", 6011 + 53 * i) << 6011 + 53 * i;
    }
    void aLineFollowerGoesAroundItsLine() {
        QFETCH(int, seed);
        QTemporaryDir logs;
        const Outcome run = cli({"run", configPath("experiments/line_follow.sim"), "--seed", QString::number(seed), "--json",
                                 "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject finished = QJsonDocument::fromJson(run.out).object()["finished"].toObject();
        QVERIFY2(finished["reason"].toString() == "went around", shown(run));
        // Where it was on the line, by the formula of the floor: all around, and never far from it once it had found it.
        std::array<bool, 100> passed{};
        bool found = false;
        for (const QByteArrayList& line : linesOf(logs.filePath("line_follow.csv"))) {
            const double heading = line[5].toDouble() * std::numbers::pi / 180,
                         x = line[2].toDouble() + 0.033 * std::cos(heading), y = line[3].toDouble() + 0.033 * std::sin(heading);
            double near = 9;
            int at = 0;
            for (int k = 0; k < 2000; ++k) {
                const double t = 2 * std::numbers::pi * k / 2000;
                const double off = std::hypot(x - (0.88 * std::cos(t) + 0.10 * std::cos(2 * t) - 0.06 * std::sin(3 * t)),
                                              y - (0.50 * std::sin(t) + 0.10 * std::sin(3 * t) + 0.06 * std::cos(2 * t)));
                if (off < near) near = off, at = k / 20;
            }
            found = found || near < 0.012;
            if (!found) continue;
            QVERIFY2(near < 0.06, qPrintable(QString("%1 m off at %2,%3").arg(near).arg(x).arg(y)));
            passed[std::size_t(at)] = true;
        }
        QVERIFY(std::count(passed.begin(), passed.end(), true) >= 95); // it ends within 0.1 m of its beginning
    }

    void vehiclesGoToTheLampOrAwayFromIt_data() {
        QTest::addColumn<int>("seed");
        QTest::addColumn<QString>("vehicle");
        const int seeds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 20 : 3;
        for (int i = 0; i < seeds; ++i) QTest::addRow("love, seed %d", 7003 + 61 * i) << 7003 + 61 * i << "love";
        for (const char* vehicle : {"fear", "explorer"}) QTest::newRow(vehicle) << 11 << vehicle;
    }
    void vehiclesGoToTheLampOrAwayFromIt() {
        QFETCH(int, seed);
        QFETCH(QString, vehicle);
        QTemporaryDir logs;
        const Outcome run = cli({"run", configPath("experiments/braitenberg.sim"), "--seed", QString::number(seed), "--set",
                                 "seeker.brain.Vehicle=" + vehicle, "--set",
                                 vehicle == "fear" ? "seeker.brain.Reference=100" : "seeker.brain.Reference=1000", "--json",
                                 "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject finished = QJsonDocument::fromJson(run.out).object()["finished"].toObject();
        QCOMPARE(finished["reason"].toString(), vehicle == "love" ? "reached the light" : "");
        double nearest = 9, last = 9;
        for (const QByteArrayList& line : linesOf(logs.filePath("braitenberg.csv"))) {
            last = std::hypot(line[2].toDouble() - 1, line[3].toDouble() - 0.4);
            nearest = std::min(nearest, last);
        }
        if (vehicle == "love") QVERIFY2(last < 0.5, qPrintable(QString::number(last)));
        else QVERIFY2(last > nearest + 0.1, qPrintable(QString("%1 m, then %2").arg(nearest).arg(last)));
    }

    void aScanIsLoggedBeamByBeam() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("scan.sim"),
                          "Tick=0.01 Duration=0.5\n#import robots/lidar_robot.sim\n#import arenas/medium_arena.sim\n"
                          "Static arena { Config=MediumArena }\nRobot r { Config=LidarRobot }\n"
                          "SignalLog scan { Signals=r/scan/ranges Interval=0.1 File=scan.csv }\n"));
        const Outcome run = cli({"run", folder.filePath("scan.sim"), "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QByteArrayList header = contentOf(folder.filePath("scan.csv")).split('\n').first().split(',');
        QCOMPARE(header.size(), 361);
        QVERIFY2(header[360].contains("r/scan/ranges/359 [m]"), header[360]);
        for (const QByteArrayList& line : linesOf(folder.filePath("scan.csv")))
            for (const QByteArray& cell : line) {
                bool number = false;
                QVERIFY(cell.toDouble(&number) >= 0 && number && !cell.contains("nan"));
            }
    }

    void aSensorOfAModuleWorksLikeTheOthers() {
        QTemporaryDir folder;
        QVERIFY(writeFile(
            folder.filePath("sonar.sim"),
            "Tick=0.01 Duration=1 Seed=3\n#loadModule components/sonar\n"
            "StaticConfig Wall { Plane floor { } Box wall { Pos=2.05,0,1 Size=0.1,9,2 } }\nStatic wall { Config=Wall }\n"
            "RobotConfig Post { Body base { Box hull { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=2 } }\n"
            "  EchoSonar front { Body=base Pos=0,0,0.5 Noise=0.01 UpdatePeriod=0.1 Latency=0.02 Resolution=0.001 } }\n"
            "Robot post { Config=Post }\nSignalLog log { Signals=\"post/front/*\" Interval=0.01 File=sonar.csv }\n"));
        const Outcome run = cli({"run", folder.filePath("sonar.sim"), "--log-dir", folder.path()});
        QVERIFY2(run.code == 0, shown(run));
        const auto lines = linesOf(folder.filePath("sonar.csv"));
        QVERIFY(lines.size() >= 100);
        const double range = lines.last()[1].toDouble(), strength = lines.last()[2].toDouble(), time = lines.last()[3].toDouble();
        QVERIFY2(std::abs(range - 2) < 0.05 && std::abs(strength - 0.25) < 0.01 && std::abs(time - 0.9) < 0.101,
                 shown(run) + lines.last().join(','));
        const Outcome described = cli({"describe", "EchoSonar", "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle")});
        QVERIFY2(described.code == 0 && described.out.contains("NoisePerMetre"), shown(described));
    }

    /// The belt of a module, in scenery with a controller of its own: two steps of 0.4 m.
    void anActuatorOfAModuleWorksLikeTheOthers() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("feed.py"),
                          "import trundle\n\n\nclass Feed(trundle.Controller):\n    \"\"\"Two steps.\"\"\"\n\n"
                          "    def setup(self, robot):\n        self.line = robot.port(\"line\")\n\n"
                          "    def update(self, since_last):\n        self.line.set(\"steps\", 2)\n"));
        QVERIFY(writeFile(
            folder.filePath("plant.sim"),
            "Tick=0.005 Duration=4\n#loadModule components/conveyor\n#loadModule feed.py\n"
            "StaticConfig Plant { Box deck { Size=4,0.5,0.1 Pos=1,0,-0.05 }\n"
            "  IndexConveyor line { Geom=deck Pitch=0.4 MaxSpeed=0.5 MaxAcceleration=1 } }\n"
            "Static plant { Config=Plant  Feed brain { } }\n"
            "RobotConfig Crate { Body body { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 } } }\nRobot crate { Config=Crate }\n"
            "SignalLog log { Signals=\"plant/line/travel\",\"plant/line/busy\",\"crate/pose\" Interval=0.1 File=plant.csv }\n"));
        const Outcome run = cli({"run", folder.filePath("plant.sim"), "--log-dir", folder.path(), "--trust"});
        QVERIFY2(run.code == 0, shown(run));
        const auto lines = linesOf(folder.filePath("plant.csv"));
        const auto& last = lines.last();
        QVERIFY2(std::abs(last[1].toDouble() - 0.8) < 1e-6 && last[2].toDouble() == 0, shown(run) + last.join(','));
        QVERIFY2(std::abs(last[3].toDouble() - 0.8) < 0.01, last.join(','));
    }

    void aLidarSaysHowManyNumbersItGives() {
        const Outcome text = cli({"describe", "Lidar"});
        QVERIFY2(text.code == 0 && text.out.contains("Beams x Layers numbers in m"), shown(text));
    }
};

QTEST_GUILESS_MAIN(SensorsTest)
#include "sensors_test.moc"
