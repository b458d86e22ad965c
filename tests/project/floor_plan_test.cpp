// Walls from pictures: which boxes they become, that nothing is lost or added, and how many there are of a large plan.
#include <QTest>

#include <algorithm>
#include <cstdlib>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/wizard/arena_text.h"

using namespace trundle;

namespace {

/// A picture from lines of text: # is black.
HeightMap drawn(const std::vector<std::string>& lines) {
    HeightMap map{static_cast<std::uint32_t>(lines[0].size()), static_cast<std::uint32_t>(lines.size()), {}};
    for (const std::string& line : lines)
        for (const char c : line) map.heights.push_back(c == '#' ? 0.f : 1.f);
    return map;
}

/// The cells of the walls, drawn again; a cell that two boxes cover is an X.
std::vector<std::string> drawnAgain(const FloorPlan& plan) {
    std::vector<std::string> lines(plan.rows, std::string(plan.columns, '.'));
    for (const PlanBox& box : plan.walls)
        for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
            for (std::uint32_t x = box.x; x < box.x + box.width; ++x) lines[y][x] = lines[y][x] == '.' ? '#' : 'X';
    return lines;
}

/// Rooms of an office: walls 3 pixels wide with doors, and slanted ones in some rooms.
HeightMap office(std::uint32_t side) {
    HeightMap map{side, side, std::vector<float>(std::size_t(side) * side, 1.f)};
    const auto wall = [&](std::uint32_t x, std::uint32_t y) { map.heights[std::size_t(y) * side + x] = 0.f; };
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t k = 0; k < side; k += 32)
            for (std::uint32_t w = 0; w < 3 && k + w < side; ++w) {
                if (i % 32 > 12 || k == 0) wall(i, k + w);
                if (i % 32 < 22 || k == 0) wall(k + w, i);
            }
    for (std::uint32_t room = 0; room + 32 < side; room += 64)
        for (std::uint32_t i = 8; i < 20; ++i)
            for (std::uint32_t w = 0; w < 3; ++w) wall(room + i, room + i + w);
    return map;
}

FloorPlan planOf(const HeightMap& map, const FloorPlanOptions& options = {}) {
    const Result<FloorPlan> plan = floorPlanFrom(map, options);
    return plan ? plan.value() : FloorPlan{};
}

} // namespace

class FloorPlanTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void mergesWalls() {
        const std::vector<std::string> room{"#######.", "#.....#.", "#.....#.", "#..####.", "#.......", "########"};
        const FloorPlan plan = planOf(drawn(room));
        QCOMPARE(drawnAgain(plan), room);
        QCOMPARE(plan.walls.size(), std::size_t(5)); // top, left, right, partition, bottom
        QCOMPARE(plan.cell, 10. / 8);
        QCOMPARE(plan.step, 1u);
    }

    void coversExactlyTheDarkPixels() {
        std::srand(7);
        for (int i = 0; i < 50; ++i) {
            std::vector<std::string> lines(1 + std::size_t(std::rand()) % 20,
                                           std::string(1 + std::size_t(std::rand()) % 20, '.'));
            for (std::string& line : lines)
                for (char& c : line) c = std::rand() % 3 ? '.' : '#';
            const auto plan = floorPlanFrom(drawn(lines), {});
            if (plan) QCOMPARE(drawnAgain(plan.value()), lines);
        }
    }

    void aLargePlanIsAtMost2000Boxes() {
        const HeightMap map = office(512);
        const FloorPlan plan = planOf(map);
        qInfo("an office of 512 x 512 pixels: %zu boxes", plan.walls.size());
        QVERIFY(plan.walls.size() > 100 && plan.walls.size() <= 2000);
        QCOMPARE(plan.step, 1u);
        HeightMap noise{512, 512, {}};
        std::srand(1);
        for (int i = 0; i < 512 * 512; ++i) noise.heights.push_back(float(std::rand() % 1000) / 1000);
        const FloorPlan coarse = planOf(noise);
        QVERIFY(!coarse.walls.empty() && coarse.walls.size() <= 2000);
        QVERIFY(coarse.step > 1);
        QCOMPARE(coarse.cell, 10. / 512 * coarse.step);
        QBENCHMARK_ONCE { (void)planOf(map); }
    }

    void lightWalls() {
        FloorPlanOptions options;
        options.isInverted = true;
        QCOMPARE(drawnAgain(planOf(drawn({"##.", "###"}), options)), (std::vector<std::string>{"..#", "..."}));
    }

    /// The middle of the largest room is free.
    void findsRoomForARobot() {
        const FloorPlan plan =
            planOf(drawn({"##########", "#..#.....#", "#..#.....#", "####.....#", "#..#.....#", "#..#.....#", "##########"}));
        QCOMPARE(plan.freest[0], 1.5); // m: column 6.5 of 10, each 1 m
        QCOMPARE(plan.freest[1], 0.);
        QCOMPARE(plan.room, 2.5);
    }

    /// In each quarter of the plan: x to the right of its middle, y up, as the picture is seen.
    void theRoomIsWhereThePictureShowsIt() {
        const std::vector<std::string> picture{"##########", "##########", "#######..#", "#######..#",
                                               "##########", "##########", "#.....####", "#.....####",
                                               "#.....####", "#.....####", "#.....####", "##########"};
        for (const bool right : {false, true})
            for (const bool top : {false, true}) {
                std::vector<std::string> lines = picture;
                if (top) std::ranges::reverse(lines);
                if (right)
                    for (std::string& line : lines) std::ranges::reverse(line);
                FloorPlanOptions options;
                options.width = 20; // cells of 2 m
                const FloorPlan plan = planOf(drawn(lines), options);
                QCOMPARE(plan.freest[0], right ? 3. : -3.); // the middle of column 3 or 6 of 0 to 9
                QCOMPARE(plan.freest[1], top ? 5. : -5.);   // of row 8 or 3 of 0 to 11
                QCOMPARE(plan.room, 5.);
            }
    }

    void saysWhyAPlanIsRefused_data() {
        QTest::addColumn<double>("threshold");
        QTest::addColumn<double>("width");
        QTest::addColumn<QString>("expected");
        QTest::newRow("dark") << 0.5 << 10. << "All of the picture is wall";
        QTest::newRow("threshold") << 1.5 << 10. << "The threshold must be between 0 and 1";
        QTest::newRow("width") << 0.5 << 0. << "The width of the plan must be";
    }
    void saysWhyAPlanIsRefused() {
        QFETCH(double, threshold);
        QFETCH(double, width);
        QFETCH(QString, expected);
        FloorPlanOptions options;
        options.threshold = threshold;
        options.width = width;
        const auto plan = floorPlanFrom(drawn({"###"}), options);
        QVERIFY(!plan);
        QVERIFY2(QString::fromStdString(plan.error().message).startsWith(expected), plan.error().message.c_str());
        QVERIFY(!floorPlanFrom(drawn({"..."}), {}));
    }

    /// Both arenas load without a problem, and the formatter changes nothing.
    void theTextsAreGood() {
        const Result<std::string> field = obstacleText("Arena", {});
        QVERIFY2(field.ok(), field.ok() ? "" : field.error().message.c_str());
        QCOMPARE(obstacleText("Arena", {}).value(), field.value());
        ObstacleField other;
        other.seed = 2;
        QVERIFY(obstacleText("Arena", other).value() != field.value());
        for (const std::string& arena : {arenaText("Arena", planOf(office(128)), 0.5, "office.png"), field.value()}) {
            sample::PlanFixture fixture;
            fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
            const auto loaded =
                fixture.open({{"arena.sim", arena}, {"main.sim", arenaExperimentText("Arena", "arena", {1, 2}, 5)}});
            QVERIFY(loaded);
            QCOMPARE(QString::fromStdString(sample::messages(*loaded)), QString());
            QVERIFY(loaded->experiment && loaded->experiment->statics.at(0).geoms->size() > 5);
            int compared = 0;
            for (std::size_t f = 0; f < loaded->paths.size(); ++f)
                if (loaded->paths[f].ends_with("arena.sim") || loaded->paths[f].ends_with("main.sim")) {
                    QCOMPARE(QString::fromStdString(format(*loaded->trees[f])), QString::fromStdString(print(*loaded->trees[f])));
                    ++compared;
                }
            QCOMPARE(compared, 2);
        }
    }

    /// What is there stays free, by the least distance.
    void obstaclesStayClear() {
        ObstacleField field;
        field.seed = 5;
        field.free = {{-2, 1, 0.4}};
        field.occupied = {{0, -2, 0.1, 2}};
        const auto placed = obstacleField(field);
        QVERIFY(placed.ok());
        QCOMPARE(placed.value().size(), std::size_t(12));
        for (const FieldObstacle& o : placed.value()) {
            const double radius = (o.isRound ? o.across : std::hypot(o.across, o.deep)) / 2;
            QVERIFY(std::hypot(o.x + 2, o.y - 1) >= 0.4 + radius + field.apart);
            QVERIFY(std::max(-o.x, o.x - 0.1) >= radius + field.apart);
            QVERIFY(std::abs(o.x) + radius <= 3 && std::abs(o.y) + radius <= 2);
        }
    }

    void anObstacleFieldThatIsFull() {
        ObstacleField field;
        field.count = 500;
        const Result<std::string> text = obstacleText("Arena", field);
        QVERIFY(!text);
        QVERIFY2(text.error().message.starts_with("There is no room for 500 obstacles: the room has "),
                 text.error().message.c_str());
    }
};
QTEST_APPLESS_MAIN(FloorPlanTest)
#include "floor_plan_test.moc"
