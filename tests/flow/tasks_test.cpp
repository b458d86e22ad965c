// Whole tasks, on seeds that no file contains: cans are brought home, a room is mapped, a battery is charged.

#include <deque>
#include <map>
#include <numbers>

#include <QRegularExpression>

#include "flow/cli.h"

namespace {

int seedsOf(int few) { return qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 20 : few; }

QJsonObject run(const QString& experiment, int seed, const QStringList& more = {}) {
    const Outcome outcome =
        cli(QStringList{"run", configPath("experiments/" + experiment), "--seed", QString::number(seed), "--json"} + more);
    if (outcome.code != 0) qWarning("%s", shown(outcome).constData());
    return QJsonDocument::fromJson(outcome.out).object();
}

QString reasonOf(const QJsonObject& run) { return run["finished"].toObject()["reason"].toString(); }

/// Numbers of a log's row without its texts; row 0 is the first after the header.
QList<double> rowOf(const QString& path, int row) {
    QList<double> numbers;
    for (const QByteArray& cell : contentOf(path).split('\n').value(row + 1).split(',')) numbers << cell.toDouble();
    return numbers;
}

/// Steps from the cell 0,0 of a maze's arena to another one, by its walls alone; 8 x 8 cells of 18 cm around the origin. -1: no way.
int shortestWay(const QString& arena, QPoint goal) {
    struct Wall {
        double x, y, sizeX, sizeY;
    };
    QList<Wall> walls;
    static const QRegularExpression box("Box wall\\d+ \\{ Pos=([-\\d.]+),([-\\d.]+),.* Size=([\\d.]+),([\\d.]+),");
    for (auto it = box.globalMatch(QString::fromUtf8(contentOf(arena))); it.hasNext();) {
        const auto m = it.next();
        walls.append({m.captured(1).toDouble(), m.captured(2).toDouble(), m.captured(3).toDouble(), m.captured(4).toDouble()});
    }
    const auto isWall = [&](double x, double y) {
        return std::ranges::any_of(walls, [&](const Wall& w) {
            return std::abs(x - w.x) < w.sizeX / 2 && std::abs(y - w.y) < w.sizeY / 2;
        });
    };
    std::map<std::pair<int, int>, int> steps{{{0, 0}, 0}};
    for (std::deque<std::pair<int, int>> open{{0, 0}}; !open.empty(); open.pop_front()) {
        const auto [c, r] = open.front();
        for (const auto& [dc, dr] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
            const double x = (c - 3.5 + 0.5 * dc) * 0.18, y = (r - 3.5 + 0.5 * dr) * 0.18;
            if (!isWall(x, y) && steps.emplace(std::pair(c + dc, r + dr), steps[{c, r}] + 1).second) open.emplace_back(c + dc, r + dr);
        }
    }
    const auto found = steps.find({goal.x(), goal.y()});
    return found == steps.end() ? -1 : found->second;
}

struct Box {
    double x, y, sizeX, sizeY, heading; // m, deg
};
/// Of configs/arenas/furnished_room.sim, as far as it is in the plane of the lidar.
constexpr Box kBoxes[] = {
    {0.7, 1.3, 0.1, 1.4, 0}, {-2.05, -1.7, 0.9, 0.6, 0}, {-2.3, 1.75, 0.04, 1, -45}, {0.3, -1.9, 0.6, 0.2, 0}};

bool isOccupied(double x, double y) {
    if (std::abs(x) > 2.5 || std::abs(y) > 2 || std::hypot(x - 2.4, y + 0.5) < 0.25) return true;
    return std::any_of(std::begin(kBoxes), std::end(kBoxes), [&](const Box& b) {
        const double c = std::cos(b.heading * std::numbers::pi / 180), s = std::sin(b.heading * std::numbers::pi / 180);
        return std::abs(c * (x - b.x) + s * (y - b.y)) < b.sizeX / 2 && std::abs(c * (y - b.y) - s * (x - b.x)) < b.sizeY / 2;
    });
}

struct Agreement {
    int cells = 0, right = 0;
};

/// Of the map's cells in the room and up to 5 cm in its walls: free where the room is, else not free. The map's frame is that of the start.
Agreement compare(const QByteArray& map, double cell, double startX, double startY, double heading) {
    Agreement result;
    const QList<QByteArray> parts = map.left(32).split('\n');
    const int count = parts.value(1).split(' ').value(0).toInt(),
              header = int(parts[0].size() + parts[1].size() + parts[2].size()) + 3;
    if (parts[0] != "P5" || map.size() != header + count * count) return result;
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            const double mx = (column + 0.5 - count / 2) * cell, my = (count - row - 0.5 - count / 2) * cell;
            const double x = startX + std::cos(heading) * mx - std::sin(heading) * my,
                         y = startY + std::sin(heading) * mx + std::cos(heading) * my;
            if (std::abs(x) > 2.55 || std::abs(y) > 2.05) continue;
            ++result.cells;
            result.right += (std::uint8_t(map[header + row * count + column]) == 254) != isOccupied(x, y);
        }
    return result;
}

} // namespace

class TasksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theControllersReadNothingButSensors_data() {
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("sensor");
        QTest::newRow("collect") << "collect/collect.cpp"
                                 << "robot.gripper(";
        QTest::newRow("lidar_map") << "lidar_map/lidar_map.cpp"
                                   << "robot.lidar(";
        QTest::newRow("docking") << "docking/docking.cpp"
                                 << "robot.lightSensor(";
    }
    void theControllersReadNothingButSensors() {
        QFETCH(QString, source);
        QFETCH(QString, sensor);
        const QByteArray text = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/plugins/controllers/") + source);
        QVERIFY(text.contains(sensor.toUtf8()));
        for (const char* word : {"groundTruth", "signal(", "gps(", "compass("}) QVERIFY2(!text.contains(word), word);
    }

    void allCansAreBroughtHome_data() {
        QTest::addColumn<int>("seed");
        for (int i = 0; i < seedsOf(3); ++i) QTest::addRow("seed %d", 3011 + 67 * i) << 3011 + 67 * i;
    }
    void allCansAreBroughtHome() {
        QFETCH(int, seed);
        QTemporaryDir logs;
        const QJsonObject done = run("collect.sim", seed, {"--log-dir", logs.path()});
        QCOMPARE(reasonOf(done), QString("all are home"));
        for (int i = 0; i < 6; ++i) {
            const QJsonArray at = done["robots"].toObject()[QString("cans_%1").arg(i)].toObject()["pos"].toArray();
            const double x = at[0].toDouble(), y = at[1].toDouble(), z = at[2].toDouble();
            QVERIFY2(at.size() == 3 && std::abs(x + 2.25) < 0.5 && std::abs(y) < 1.25 && std::abs(z - 0.11) < 0.005,
                     qPrintable(QString("can %1 at %2,%3,%4").arg(i).arg(x).arg(y).arg(z)));
        }
    }

    /// Its jaws carry 2 mu F: 2.4 N of the can's 4.9 N.
    void withWeakJawsNoCanIsBrought() {
        QTemporaryDir logs;
        const QJsonObject done =
            run("collect.sim", 3011, {"--log-dir", logs.path(), "--duration", "120", "--set", "collector.gripper.Force=2"});
        QVERIFY(!done.isEmpty());
        QCOMPARE(reasonOf(done), QString());
    }

    /// Beside its back, where its lidar sees nothing, is a can: while it looks around its sonars keep it off, without them it falls over.
    void theSonarsKeepItsBackOffACan() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("tail.sim"),
                          "Tick = 0.01 Duration = 8\n#import robots/research_base.sim\n#import objects/can.sim\n"
                          "#import arenas/depot.sim\n#loadModule controllers/collect\nStatic depot { Config=Depot }\n"
                          "Robot collector { Config=ResearchBase Collect brain { Count=1 } }\n"
                          "Robot near { Config=Can Pos=-0.1,-0.285,0 }\n"));
        for (const auto& [clearance, stays] : {std::pair("0.2", true), {"0", false}}) {
            const Outcome outcome = cli({"run", folder.filePath("tail.sim"), "--json", "--set",
                                         QStringLiteral("collector.brain.Clearance=%1").arg(clearance)});
            const QJsonObject robots = QJsonDocument::fromJson(outcome.out).object()["robots"].toObject();
            const QJsonArray at = robots["near"].toObject()["pos"].toArray();
            QVERIFY2(at.size() == 3, shown(outcome));
            const double moved = std::hypot(at[0].toDouble() + 0.1, at[1].toDouble() + 0.285);
            QVERIFY2(stays ? moved < 1e-4 : moved > 0.1, qPrintable(QString::number(moved)));
        }
    }

    /// Twice it finds its charger by the light on it, charges and works on.
    void theRobotCharges_data() {
        QTest::addColumn<int>("seed");
        for (int i = 0; i < seedsOf(2); ++i) QTest::addRow("seed %d", 4001 + 53 * i) << 4001 + 53 * i;
    }
    void theRobotCharges() {
        QFETCH(int, seed);
        QTemporaryDir logs;
        const QJsonObject done = run("docking.sim", seed, {"--log-dir", logs.path()});
        QCOMPARE(reasonOf(done), QString("it works, charged"));
        const QJsonObject robots = done["robots"].toObject();
        const double given = robots["station"].toObject()["signals"].toObject()["charger/energy"].toDouble();
        QVERIFY2(given > 2 * 100 && given < 2 * 250, qPrintable(QString::number(given))); // 3.7 V x 72 C x 0.4 and more, twice
    }

    /// In a room without the light on it, it is not found.
    void withoutItsLightTheChargerIsNotFound() {
        QTemporaryDir logs;
        const QJsonObject done = run("docking.sim", 4001, {"--log-dir", logs.path(), "--set", "station.beacon.On=false"});
        QCOMPARE(reasonOf(done), QString("its battery is empty"));
    }

    /// A mouse finds the way through mazes that it does not know. The shipped one has loops; those of the generator have one way only.
    void aMouseRunsTheShortestWay_data() {
        QTest::addColumn<int>("maze"); // its seed; 0: the shipped one
        QTest::newRow("shipped") << 0;
        for (int i = 0; i < seedsOf(1); ++i) QTest::addRow("maze %d", 6007 + 17 * i) << 6007 + 17 * i;
    }
    void aMouseRunsTheShortestWay() {
        QFETCH(int, maze);
        QTemporaryDir folder;
        QString arena = configPath("arenas/maze.sim"), experiment = configPath("experiments/maze.sim");
        if (maze > 0) {
            const Outcome made = cli({"new", "arena", "Maze", "--in", folder.path(), "--maze", "8", "8", "--cell", "0.18", "--wall-thickness",
                                      "0.012", "--wall-height", "0.05", "--maze-seed", QString::number(maze)});
            QVERIFY2(made.code == 0, shown(made));
            arena = folder.filePath("maze/maze.sim");
            experiment = folder.filePath("run.sim");
            QVERIFY(writeFile(experiment, contentOf(configPath("experiments/maze.sim")).replace("arenas/maze.sim", "maze/maze.sim")));
        }
        const int shortest = shortestWay(arena, {4, 4});
        QVERIFY(shortest >= 8);
        const Outcome outcome = cli({"run", experiment, "--json", "--log-dir", folder.filePath("logs"), "--seed", QString::number(maze + 5), "--set",
                                     "Duration=600"});
        const QJsonObject done = QJsonDocument::fromJson(outcome.out).object();
        QVERIFY2(reasonOf(done) == "solved", shown(outcome));
        const QList<QByteArray> rows = contentOf(folder.filePath("logs/maze_run.csv")).trimmed().split('\n');
        const QList<QByteArray> titles = rows.first().split(','), last = rows.last().split(',');
        QCOMPARE(last.value(titles.indexOf("mouse/brain/way")).toInt(), shortest);
        QCOMPARE(last.value(titles.indexOf("middle/count")).toInt(), 1);
    }

    void aMapAgreesWithItsRoom_data() {
        QTest::addColumn<int>("seed");
        for (int i = 0; i < seedsOf(3); ++i) QTest::addRow("seed %d", 5003 + 71 * i) << 5003 + 71 * i;
    }
    void aMapAgreesWithItsRoom() {
        QFETCH(int, seed);
        QTemporaryDir logs;
        QCOMPARE(reasonOf(run("lidar_map.sim", seed, {"--log-dir", logs.path()})), QString("mapped"));
        const QList<double> start = rowOf(logs.filePath("lidar_map.csv"), 0); // time, name, x, y, z, heading
        const Agreement all =
            compare(contentOf(logs.filePath("map.pgm")), 0.05, start[2], start[3], start[5] * std::numbers::pi / 180);
        qInfo("%d of %d cells agree: %.2f %%", all.right, all.cells, 100. * all.right / std::max(1, all.cells));
        QVERIFY(all.cells > 8000);
        QVERIFY(all.right >= 0.97 * all.cells);
        QVERIFY(contentOf(logs.filePath("map.yaml")).contains("image: map.pgm\nresolution: 0.05\norigin: [-7, -7, 0]\n"));
    }
};

QTEST_GUILESS_MAIN(TasksTest)
#include "tasks_test.moc"
