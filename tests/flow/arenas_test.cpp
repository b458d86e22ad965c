// Arenas from the command line: what `trundle-cli new arena` writes checks and runs; a robot follows a line that is drawn on the floor.

#include <array>
#include <cmath>

#include "flow/cli.h"

class ArenasFlowTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

private Q_SLOTS:
    void initTestCase() {
        QByteArray hills = "P2\n33 33\n255\n";
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 33; ++x) hills += QByteArray::number(int(127 + 60 * std::sin(x / 5.) * std::cos(y / 5.))) + '\n';
        QVERIFY(writeFile(m_folder.filePath("hills.pgm"), hills));
    }

    void whatIsWrittenChecksAndRuns_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("expected"); // in the text of the arena
        QTest::newRow("Kitchen") << QStringList{"--room", "5", "4", "--door", "south"} << QByteArray("a room, 5 m x 4 m inside");
        QTest::newRow("Tall") << QStringList{"--room", "2", "2", "--wall-height", "1.5"} << QByteArray("Param height = 1.5");
        QTest::newRow("Labyrinth") << QStringList{"--maze", "5", "7", "--maze-seed", "3"} << QByteArray("a maze of 5 rows");
        QTest::newRow("Hills") << QStringList{"--heights", m_folder.filePath("hills.pgm"), "--heights-size", "20", "15", "1.5"}
                               << QByteArray("File=hills.pgm Size=20,15,1.5");
    }
    void whatIsWrittenChecksAndRuns() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, expected);
        const QString name = QTest::currentDataTag(), file = name.toLower(), at = m_folder.filePath(file) + "/" + file;
        const Outcome made = cli(QStringList{"new", "arena", name, "--in", m_folder.path()} + options);
        QVERIFY2(made.code == 0, shown(made));
        QVERIFY2(contentOf(at + ".sim").contains(expected), contentOf(at + ".sim"));
        for (const char* end : {".sim", "_drive.sim"}) {
            const Outcome formatted = cli({"format", "--check", at + end});
            QVERIFY2(formatted.code == 0, shown(formatted));
        }
        const Outcome checked = cli({"check", "--model", at + "_drive.sim"});
        QVERIFY2(checked.code == 0 && !checked.err.contains("warning"), shown(checked));
        const Outcome run = cli({"run", at + "_drive.sim", "--duration", "0.5"});
        QVERIFY2(run.code == 0 && !run.err.contains("warning"), shown(run));
    }

    /// As high as the highest ground below the robot: a peak beside its middle counts, one beyond it does not.
    void onAHeightfieldTheRobotStartsAboveTheGround_data() {
        QTest::addColumn<int>("column"); // of 81 on 4 m
        QTest::addColumn<int>("row");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("in the middle") << 40 << 40 << QByteArray("Pos=0,0,0.5 ");
        QTest::newRow("to the right") << 44 << 40 << QByteArray("Pos=0,0,0.5 ");
        QTest::newRow("above") << 40 << 36 << QByteArray("Pos=0,0,0.5 ");
        QTest::newRow("aslant") << 37 << 43 << QByteArray("Pos=0,0,0.5 ");
        QTest::newRow("far") << 50 << 40 << QByteArray("Pos=0,0,0 ");
    }
    void onAHeightfieldTheRobotStartsAboveTheGround() {
        QFETCH(int, column);
        QFETCH(int, row);
        QFETCH(QByteArray, expected);
        QByteArray peak = "P2\n81 81\n255\n";
        for (int y = 0; y < 81; ++y)
            for (int x = 0; x < 81; ++x) peak += x == column && y == row ? "255\n" : "0\n";
        const QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("peak.pgm"), peak));
        const Outcome made = cli({"new", "arena", "Peak", "--in", folder.path(), "--heights", folder.filePath("peak.pgm"),
                                  "--heights-size", "4", "4", "0.5"});
        QVERIFY2(made.code == 0, shown(made));
        const QByteArray text = contentOf(folder.filePath("peak/peak_drive.sim"));
        QVERIFY2(text.contains("Config=SimpleRobot " + expected), text);
    }

    void impossibleOnesAreRefused_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("no cells") << QStringList{"--maze", "0", "3"} << QByteArray("from 1 to 100 rows and columns");
        QTest::newRow("door") << QStringList{"--room", "2", "2", "--door", "north", "--door-width", "2"}
                              << QByteArray("narrower");
        QTest::newRow("both") << QStringList{"--room", "2", "2", "--maze", "2", "2"}
                              << QByteArray("--maze: an arena is made from one thing: not with --room");
        QTest::newRow("of another") << QStringList{"--plan-width", "3"} << QByteArray("--plan-width: only with --plan");
        QTest::newRow("of others") << QStringList{"--room", "2", "2", "--cell", ".5"} << QByteArray("--cell: only with --maze");
        QTest::newRow("walls") << QStringList{"--obstacles", "4", "--wall-height", "2"}
                               << QByteArray("--wall-height: only with --plan, --room or --maze");
        QTest::newRow("obstacles") << QStringList{"--maze", "2", "2", "--apart", ".5"}
                                   << QByteArray("--apart: it is for an arena with obstacles: not with --maze");
        QTest::newRow("flat") << QStringList{"--heights", m_folder.filePath("hills.pgm"), "--heights-size", "1", "1", "0"}
                              << QByteArray("The ground must be");
    }
    void impossibleOnesAreRefused() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, expected);
        const Outcome made = cli(QStringList{"new", "arena", "Never", "--in", m_folder.path()} + options);
        QVERIFY2(made.code == 2 && made.err.contains(expected), shown(made));
        QVERIFY(!QFileInfo::exists(m_folder.filePath("never")));
    }

    /// The lines as the window draws them, as objects of an experiment and as boxes of an arena: once around a rectangle of 1.6 m x 0.8 m.
    void aRobotFollowsADrawnLine_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::newRow("objects") << QByteArray("#import objects/floor_line.sim\n#import arenas/open_floor.sim\n"
                                               "Static floor { Config=OpenFloor }\n"
                                               "Static line1 { Config=FloorLine Pos=0,-0.4,0 length=1.618 }\n"
                                               "Static line2 { Config=FloorLine Pos=0.8,0,0 HPR=90,0,0 length=0.818 }\n"
                                               "Static line3 { Config=FloorLine Pos=0,0.4,0 length=1.618 }\n"
                                               "Static line4 { Config=FloorLine Pos=-0.8,0,0 HPR=90,0,0 length=0.818 }\n");
        const QByteArray rest = ",0.001 Collide=false Material=black Surface=ground }\n";
        QTest::newRow("boxes") << QByteArray("#import common/materials.sim\n#import common/surfaces.sim\nStaticConfig Course {\n"
                                             "  Plane floor { Material=concrete Surface=ground }\n") +
                                      "  Box line1 { Pos=0,-0.4,0.0005 Size=1.618,0.018" + rest +
                                      "  Box line2 { Pos=0.8,0,0.0005 Size=0.018,0.818" + rest +
                                      "  Box line3 { Pos=0,0.4,0.0005 Size=1.618,0.018" + rest +
                                      "  Box line4 { Pos=-0.8,0,0.0005 Size=0.018,0.818" + rest +
                                      "}\nStatic course { Config=Course }\n";
    }
    void aRobotFollowsADrawnLine() {
        QFETCH(QByteArray, line);
        const QString file = m_folder.filePath("line.sim"), logs = m_folder.filePath("logs");
        QVERIFY(writeFile(
            file, "Tick = 0.01  Duration = 150\n#import robots/round_robot.sim\n#loadModule controllers/line_follow\n" + line +
                      "Robot seeker { Config=RoundRobot Pos=-0.2,-0.3,0 HPR=-45,0,0 LineFollow brain { Speed=0.06 "
                      "Threshold=0.25 } }\nPoseLog path { Robot=seeker Interval=0.1 File=path.csv }\n"));
        const Outcome run = cli({"run", file, "--log-dir", logs});
        QVERIFY2(run.code == 0 && run.out.contains("went around"), shown(run));
        std::array<bool, 4> passed{};
        bool isFound = false;
        double worst = 0;
        for (const QByteArray& row : contentOf(logs + "/path.csv").split('\n')) {
            const QByteArrayList cells = row.split(',');
            if (cells.size() < 6 || cells[0] == "t") continue;
            const double heading = cells[5].toDouble() * M_PI / 180;
            const double x = cells[2].toDouble() + 0.033 * std::cos(heading), y = cells[3].toDouble() + 0.033 * std::sin(heading);
            const double off = std::abs(std::max(std::abs(x) - 0.8, std::abs(y) - 0.4));
            isFound = isFound || off < 0.01;
            if (!isFound) continue;
            worst = std::max(worst, off);
            passed[0] |= x > 0.7, passed[1] |= y > 0.35, passed[2] |= x < -0.7, passed[3] |= y < -0.35;
        }
        qInfo("at most %.1f mm beside the line", worst * 1e3);
        QVERIFY(passed == (std::array{true, true, true, true}));
        QVERIFY2(worst < 0.04, QByteArray::number(worst));
    }
};

QTEST_APPLESS_MAIN(ArenasFlowTest)
#include "arenas_test.moc"
