// Walls that are drawn into a StaticConfig which nothing places: they are where they were drawn, wherever it is shown.
#include <QtTest>

#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/tools/floor_drawing.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

namespace {

const QByteArray kYard = "StaticConfig Yard { Box post { Size=0.4,0.6,1 Pos=0,0,0.5 } }\n";
const QByteArray kRobot = "RobotConfig Cart { Body hull { Box box { Size=0.4,0.6,0.2 Mass=2 } } }\n";

const StaticSpec* yardOf(const ViewportScene& world) {
    for (const StaticSpec& fixed : world.objects()->experiment().statics)
        if (fixed.name == "StaticConfig.Yard") return &fixed;
    return nullptr;
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

private:
    std::unique_ptr<RenderService> m_render;
};

QTEST_MAIN(FloorDrawingTest)
#include "floor_drawing_test.moc"
