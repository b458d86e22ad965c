// Walls that are drawn into a StaticConfig which nothing places: they are where they were drawn, wherever it is shown.
#include <algorithm>
#include <cmath>

#include <QtTest>

#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/tools/floor_drawing.h"
#include "editor/viewport/tools/floor_snap.h"
#include "editor/viewport/view_window.h"
#include "scene/queries/object_index.h"

using namespace trundle;

namespace {

const QByteArray kYard = "StaticConfig Yard { Box post { Size=0.4,0.6,1 Pos=0,0,0.5 } }\n";
const QByteArray kRobot = "RobotConfig Cart { Body hull { Box box { Size=0.4,0.6,0.2 Mass=2 } } }\n";

const StaticSpec* yardOf(const ViewportScene& world) {
    for (const StaticSpec& fixed : world.objects()->experiment().statics)
        if (fixed.name == "StaticConfig.Yard") return &fixed;
    return nullptr;
}

StaticSpec wallAt(const Vec3& place, const Vec3& size) {
    GeomSpec wall;
    wall.size = size;
    StaticSpec fixed;
    fixed.name = "wall" + std::to_string(int(size.x()));
    fixed.pose.position = place;
    fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::vector{wall});
    return fixed;
}

} // namespace

class FloorDrawingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }

    void aWallIsWhereItWasDrawn_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("isMoved");
        QTest::newRow("alone") << kYard << false;
        QTest::newRow("beside a robot") << kRobot + kYard << true;
        QTest::newRow("before a robot") << kYard + kRobot << true;
    }
    void aWallIsWhereItWasDrawn() {
        QFETCH(QByteArray, text);
        QFETCH(bool, isMoved);
        ViewWindow window(m_render.get());
        QVERIFY(window.open(text));
        const ViewContext& context = window.view().context();
        const StaticSpec* yard = yardOf(context.world);
        QVERIFY(yard);
        const Pose place = yard->pose;
        QCOMPARE(place.position.norm() > 0.1, isMoved);
        context.settings.setTool(Tool::DrawWalls);
        QVERIFY(context.drawing.begin());
        context.drawing.add({1, -0.5});
        context.drawing.add({3, -0.5});
        context.drawing.finish();
        yard = yardOf(context.world);
        QVERIFY(yard && yard->geoms);
        QCOMPARE(yard->geoms->size(), std::size_t(2));
        const Vec3 middle = place * yard->geoms->back().pose.position;
        QVERIFY2(std::abs(middle.x() - 2) < 1e-6 && std::abs(middle.y() + 0.5) < 1e-6, window.text().constData());
        QVERIFY2(window.refusals.empty(), "refused");
    }

    /// A wall of 4 m along x, and one of 0.5 m along y: whichever of them is first, each may end a thickness before the other.
    void wallsOfTwoLengthsMeet_data() {
        QTest::addColumn<double>("x"); // of the middle of the short one
        QTest::addColumn<double>("y");
        QTest::addColumn<bool>("meet");
        QTest::newRow("the short one ends before the long one") << 1. << 0.3 << true;
        QTest::newRow("it ends too far before it") << 1. << 0.37 << false;
        QTest::newRow("the long one ends before the short one") << 4.06 << 0. << true;
        QTest::newRow("that ends too far before it") << 4.3 << 0. << false;
        QTest::newRow("it begins behind the short one") << -0.06 << 0.1 << true;
        QTest::newRow("it begins too far behind it") << -0.3 << 0.1 << false;
    }
    void wallsOfTwoLengthsMeet() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(bool, meet);
        for (const bool isLongFirst : {true, false}) {
            auto experiment = std::make_shared<ExperimentSpec>();
            experiment->statics = {wallAt({2, 0, 0.5}, {4, 0.08, 1}), wallAt({x, y, 0.5}, {0.1, 0.5, 1})};
            if (!isLongFirst) std::swap(experiment->statics[0], experiment->statics[1]);
            const std::vector<FloorPoint> ends = wallEnds(ObjectIndex(experiment));
            const auto has = [&](double atX, double atY) {
                return std::ranges::any_of(ends,
                                           [&](const FloorPoint& end) { return std::hypot(end[0] - atX, end[1] - atY) < 1e-9; });
            };
            QCOMPARE(has(x, 0), meet);
            QVERIFY(has(x, y + 0.25)); // its free end
            QCOMPARE(has(0, 0), !meet || x > 0);
            QCOMPARE(has(4, 0), !meet || x < 4);
        }
    }

private:
    std::unique_ptr<RenderService> m_render;
};

QTEST_MAIN(FloorDrawingTest)
#include "floor_drawing_test.moc"
