// Rooms, mazes and paths on the floor as walls: what is closed is closed, a maze is perfect, and the text is clean.
#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/wizard/arena_text.h"
#include "project/wizard/floor_path.h"
#include "project/wizard/heights_text.h"

using namespace trundle;

namespace {

bool isWall(const RoomPlan& plan, double x, double y) {
    return std::ranges::any_of(plan.walls, [&](const RoomWall& w) {
        return std::abs(x - w.x) < w.along / 2 + 1e-9 && std::abs(y - w.y) < w.across / 2 + 1e-9;
    });
}

struct Passages {
    int open = 0;            ///< between neighbouring cells
    std::size_t reached = 0; ///< cells, from the start
    bool isClosed = true;    ///< outside
};

Passages passagesOf(const RoomPlan& plan, const MazeOptions& o) {
    Passages found;
    const auto x = [&](double column) { return (column - (o.columns - 1) / 2.) * o.cell; };
    const auto y = [&](double row) { return (row - (o.rows - 1) / 2.) * o.cell; };
    std::set<std::pair<int, int>> reached{{0, 0}};
    std::vector<std::pair<int, int>> open{{0, 0}};
    const auto passes = [&](int row, int column, int down, int right) {
        return !isWall(plan, x(column + right / 2.), y(row + down / 2.));
    };
    while (!open.empty()) {
        const auto [row, column] = open.back();
        open.pop_back();
        for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
            if (!passes(row, column, down, right)) continue;
            const int r = row + down, c = column + right;
            if (r < 0 || c < 0 || r >= o.rows || c >= o.columns) {
                found.isClosed = false;
                continue;
            }
            ++found.open; // from both sides
            if (reached.insert({r, c}).second) open.push_back({r, c});
        }
    }
    found.open /= 2;
    found.reached = reached.size();
    return found;
}

bool isFormatted(const std::string& text) {
    const auto tree = parse(std::make_shared<const SourceText>("arena.sim", text), 0);
    return format(*tree) == text;
}

} // namespace

class RoomPlanTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyMazeIsPerfect() {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            MazeOptions o;
            o.rows = 1 + int(seed % 9), o.columns = 1 + int(seed * 7 % 12), o.seed = seed;
            const Result<RoomPlan> plan = mazePlan(o);
            QVERIFY(plan.ok());
            const Passages found = passagesOf(plan.value(), o);
            const auto cells = std::size_t(o.rows * o.columns);
            QVERIFY(found.isClosed);
            QCOMPARE(found.reached, cells);
            QCOMPARE(found.open, int(cells) - 1); // a tree: one way alone
            QVERIFY(!isWall(plan.value(), plan.value().startX, plan.value().startY));
        }
    }

    /// Where walls meet, end or pass there is a whole post, and nothing reaches beyond it into a passage.
    void postsOfAMazeAreWhole() {
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            MazeOptions o;
            o.rows = 2 + int(seed % 5), o.columns = 2 + int(seed * 3 % 5), o.seed = seed;
            const RoomPlan plan = mazePlan(o).value();
            for (int row = 0; row <= o.rows; ++row)
                for (int column = 0; column <= o.columns; ++column) {
                    const double x = (column - o.columns / 2.) * o.cell, y = (row - o.rows / 2.) * o.cell;
                    const auto is = [&](double right, double up) { return isWall(plan, x + right, y + up); };
                    const double half = o.cell / 2, edge = 0.49 * o.thickness, beyond = 0.51 * o.thickness;
                    int walls = 0;
                    for (const auto& [right, up] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                        const bool isThere = is(right * half, up * half);
                        walls += isThere;
                        QCOMPARE(is(right * beyond, up * beyond), isThere);
                    }
                    for (const double right : {-edge, edge})
                        for (const double up : {-edge, edge}) QCOMPARE(is(right, up), walls > 0);
                }
        }
    }

    void seedsGiveTheSameMaze() {
        const auto text = [](std::uint64_t seed) {
            MazeOptions o;
            o.seed = seed;
            return roomText("Labyrinth", mazePlan(o).value(), describe(o));
        };
        QCOMPARE(text(7), text(7));
        QVERIFY(text(7) != text(8));
    }

    void wallsInALineAreOne() {
        MazeOptions o;
        o.rows = o.columns = 20;
        const std::vector<RoomWall> walls = mazePlan(o).value().walls;
        // 21 * 20 * 2 places for a wall less 399 passages
        QVERIFY2(walls.size() < 441 * 6 / 10, QByteArray::number(qulonglong(walls.size())));
    }

    void aRoomIsClosedButForItsDoor() {
        RoomOptions o;
        o.doorSide = RoomSide::East;
        const RoomPlan plan = roomPlan(o).value();
        QCOMPARE(plan.walls.size(), std::size_t(5));
        int openings = 0;
        for (int i = 0; i < 3600; ++i) { // along the middle of the walls
            const double turn = i * M_PI / 1800, x = 2.05, y = 1.55;
            const double scale = std::min(x / std::abs(std::cos(turn) + 1e-12), y / std::abs(std::sin(turn) + 1e-12));
            const double px = scale * std::cos(turn), py = scale * std::sin(turn);
            if (isWall(plan, px, py)) continue;
            ++openings;
            QVERIFY(px > 2 && std::abs(py) <= 0.4);
        }
        QVERIFY(openings > 100);
    }

    void refusesImpossibleNumbers_data() {
        QTest::addColumn<RoomOptions>("room");
        RoomOptions o;
        o.length = 0.1;
        QTest::newRow("length") << o;
        o = {}, o.thickness = 0;
        QTest::newRow("thickness") << o;
        o = {}, o.height = std::nan("");
        QTest::newRow("height") << o;
        o = {}, o.doorSide = RoomSide::North, o.doorWidth = 4;
        QTest::newRow("door") << o;
    }
    void refusesImpossibleNumbers() {
        QFETCH(RoomOptions, room);
        const Result<RoomPlan> plan = roomPlan(room);
        QVERIFY(!plan.ok());
        QCOMPARE(plan.error().code, Code::OutOfRange);
    }

    void textsAreClean() {
        RoomOptions o;
        o.doorSide = RoomSide::South;
        const RoomPlan room = roomPlan(o).value();
        const std::string text = roomText("Kitchen", room, describe(o));
        QVERIFY2(isFormatted(text), text.c_str());
        QVERIFY(isFormatted(roomBlocksText("Room", room, true)));
        QVERIFY(isFormatted("StaticConfig Yard {\n  " + heightsText("my hills.png", {10, 8, 1.5}).value() + "}\n"));
        QVERIFY(!heightsText("a\"b.png", {10, 8, 1.5}).ok());
        QVERIFY(!heightsText("hills.png", {10, 0, 1.5}).ok());
    }

    void piecesMeetAtCorners() {
        const std::vector<FloorPiece> open = piecesAlong({{0, 0}, {2, 0}, {2, 1.5}, {2, 1.5}}, 0.1);
        QCOMPARE(open.size(), std::size_t(2));
        QCOMPARE(open[0].length, 2.05); // half a thickness past the corner
        QCOMPARE(open[0].middle[0], 1.025);
        QCOMPARE(open[1].heading, 90.);
        const std::vector<FloorPiece> straight = piecesAlong({{0, 0}, {2, 0}, {3, 0}}, 0.1);
        QCOMPARE(straight[0].length, 2.); // nothing to close
        const std::vector<FloorPiece> closed = piecesAlong({{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}}, 0.1);
        QCOMPARE(closed.size(), std::size_t(4));
        for (const FloorPiece& piece : closed)
            QVERIFY(std::abs(piece.length - 2.1) < 1e-9 || std::abs(piece.length - 1.1) < 1e-9);
        QCOMPARE(closed[2].middle[0], 1.);
        QVERIFY(piecesAlong({{1, 1}, {1, 1}}, 0.1).empty());
    }

    /// The pieces of a closed path are the same from whichever of its corners it is drawn.
    void closedPathsFromEachCorner() {
        const std::vector<FloorPoint> corners{{0, 0}, {2, 0.3}, {2.4, 1.7}, {0.6, 1.9}, {-0.5, 1}};
        std::vector<double> first;
        for (std::size_t start = 0; start < corners.size(); ++start) {
            std::vector<FloorPoint> path;
            for (std::size_t i = 0; i <= corners.size(); ++i) path.push_back(corners[(start + i) % corners.size()]);
            std::vector<double> lengths;
            for (const FloorPiece& piece : piecesAlong(path, 0.1)) lengths.push_back(piece.length);
            std::ranges::sort(lengths);
            if (first.empty()) first = lengths;
            QCOMPARE(lengths.size(), corners.size());
            for (std::size_t i = 0; i < lengths.size(); ++i) QVERIFY(std::abs(lengths[i] - first[i]) < 1e-12);
        }
    }

    /// A wall has no front: the same one drawn from its other end is the same text.
    void directionDoesNotMatter() {
        for (const double degrees : {0., 15., 90., 137.5, 180., -90.}) {
            const double x = std::cos(degrees * M_PI / 180), y = std::sin(degrees * M_PI / 180);
            QCOMPARE(staticsText(piecesAlong({{0, 0}, {x, y}}, 0.1), wallPath()),
                     staticsText(piecesAlong({{x, y}, {0, 0}}, 0.1), wallPath()));
        }
        QCOMPARE(staticsText(piecesAlong({{0, 0}, {0, -2}}, 0.1), wallPath()),
                 std::string("Static wall1 { Config=Wall Pos=0,-1,0 HPR=90,0,0 }\n"));
        QCOMPARE(boxesText(piecesAlong({{0, 0}, {0, -2}}, 0.1), wallPath()),
                 std::string("Box wall1 { Pos=0,-1,0.25 Size=0.1,2,0.5 Material=white Surface=wall }\n"));
    }

    void heightUnderARobot() {
        const HeightMap map{3, 3, {0, 0, 0, 0, 0.5f, 0, 1, 0, 0}};
        QCOMPARE(heightAt(map, {30, 30, 2}, {0, 0}, 0.1), 1.); // a point of the picture is 15 m from the next
        QCOMPARE(heightAt(map, {30, 30, 2}, {-15, -15}, 0.1), 2.);
        QCOMPARE(heightAt(map, {30, 30, 2}, {0, 0}, 30), 2.);
    }
};

QTEST_APPLESS_MAIN(RoomPlanTest)
#include "room_plan_test.moc"
