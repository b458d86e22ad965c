// Walls that are drawn into a StaticConfig which nothing places: they are where they were drawn, wherever it is shown.
#include <algorithm>
#include <cmath>

#include <QtTest>

#include "editor/document/structure_edits.h"
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

    /// A corner on the last one does not count; a new corner, the end of the tool and another document remove what was typed and drawn.
    void cornersOfADrawing() {
        ViewWindow window(nullptr);
        QVERIFY(window.open(kYard));
        const ViewContext& context = window.view().context();
        FloorDrawing& drawing = context.drawing;
        const auto begin = [&] {
            context.settings.setTool(Tool::DrawWalls);
            QVERIFY(drawing.begin());
            drawing.add({1, 1});
            QVERIFY(drawing.type(Qt::Key_5, QStringLiteral("5")));
        };
        begin();
        QCOMPARE(drawing.typedLength(), std::optional(5.));
        drawing.add({1, 1.00005});
        QCOMPARE(drawing.corners().size(), std::size_t(1));
        QVERIFY(drawing.typed().empty());
        drawing.add({2, 1});
        drawing.add({2, 3});
        drawing.removeLast();
        QCOMPARE(drawing.corners(), (std::vector<FloorPoint>{{1, 1}, {2, 1}}));
        context.settings.setTool(Tool::Select);
        QVERIFY(drawing.corners().empty());
        begin();
        drawing.clear();
        QVERIFY(drawing.corners().empty() && drawing.typed().empty());
        begin();
        QVERIFY(window.open(kYard));
        QVERIFY(drawing.corners().empty() && drawing.typed().empty());
    }

    void typedLengthsAndAngles_data() {
        QTest::addColumn<QString>("length");
        QTest::addColumn<QString>("angle");
        QTest::addColumn<QList<double>>("numbers"); // 9999: none
        QTest::newRow("plain") << QStringLiteral("2.5") << QStringLiteral("-90") << QList<double>{2.5, -90};
        QTest::newRow("with units") << QStringLiteral("250 cm") << QStringLiteral("0.5 deg") << QList<double>{2.5, 0.5};
        QTest::newRow("zero") << QStringLiteral("0") << QStringLiteral("0") << QList<double>{9999, 0};
        QTest::newRow("the largest") << QStringLiteral("1000") << QStringLiteral("360") << QList<double>{1000, 360};
        QTest::newRow("too large") << QStringLiteral("1001") << QStringLiteral("-361") << QList<double>{9999, 9999};
        QTest::newRow("more than half a turn") << QStringLiteral("1") << QStringLiteral("-270") << QList<double>{1, -270};
    }
    void typedLengthsAndAngles() {
        QFETCH(QString, length);
        QFETCH(QString, angle);
        QFETCH(QList<double>, numbers);
        ViewWindow window(nullptr);
        QVERIFY(window.open(kYard));
        FloorDrawing& drawing = window.view().context().drawing;
        for (const QChar c : length) QVERIFY(drawing.type(0, c));
        QVERIFY(drawing.type(Qt::Key_Tab, {}));
        for (const QChar c : angle) QVERIFY(drawing.type(0, c));
        QCOMPARE(drawing.typedLength().value_or(9999), numbers[0]);
        QCOMPARE(drawing.typedAngle().value_or(9999), numbers[1]);
    }

    /// Ends of walls are those of the present text, of slender upright boxes alone.
    void endsFollowTheText() {
        ViewWindow window(nullptr);
        const QByteArray text = "StaticConfig Wall { Box w { Size=0.1,2,1 Pos=0,0,0.5 } }\n"
                                "StaticConfig Post { Box w { Size=0.5,0.4,1 Pos=0,0,0.5 } }\n"
                                "StaticConfig Plank { Box w { Size=0.1,2,1 Pos=0,0,0.5 HPR=0,50,0 } }\n"
                                "Static post { Config=Post Pos=5,5,0 }\nStatic plank { Config=Plank Pos=-5,5,0 }\n"
                                "Static wall { Config=Wall Pos=3,1,0 HPR=90,0,0 }\n";
        QVERIFY(window.open(text));
        const FloorDrawing& drawing = window.view().context().drawing;
        const auto has = [&](double x, double y) {
            return std::ranges::any_of(drawing.ends(),
                                       [&](const FloorPoint& end) { return std::hypot(end[0] - x, end[1] - y) < 1e-9; });
        };
        QVERIFY(has(2, 1) && has(4, 1));
        QCOMPARE(drawing.ends().size(), std::size_t(2));
        QVERIFY(window.document.structure().setValues(QStringLiteral("Set"), {{"wall.Pos", "0,1,0"}}).ok());
        QVERIFY(has(-1, 1) && has(1, 1) && !has(4, 1));
    }

private:
    std::unique_ptr<RenderService> m_render;
};

QTEST_MAIN(FloorDrawingTest)
#include "floor_drawing_test.moc"
