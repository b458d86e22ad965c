// Parts of the Sensors dock without the panel: which devices belong to a selected part of a robot, and the plot of a lidar.

#include <QtTest>

#include "app/application.h"
#include "editor/running/session_fixture.h"
#include "editor/sensors/polar_plot.h"
#include "editor/sensors/shown_devices.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/theme.h"

using namespace trundle;

namespace {

/// Whether a plot has a dot at these parts of its radius above its middle and to the left of it.
bool hasDot(const QImage& plot, double up, double left) {
    const double radius = std::min(plot.width(), plot.height()) / 2.0 - 3;
    const QPoint at(int(std::lround(plot.width() / 2.0 - left * radius)), int(std::lround(plot.height() / 2.0 - up * radius)));
    for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x)
            if (plot.valid(at + QPoint(x, y)) && plot.pixelColor(at + QPoint(x, y)) == ink(Ink::Accent)) return true;
    return false;
}

} // namespace

class SensorPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    /// The names of other parts may begin alike.
    void devicesOfAPart_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("devices");
        QTest::newRow("a body") << "r.arm"
                                << "r.near r.feel";
        QTest::newRow("another one") << "r.arm2"
                                     << "r.far r.press";
        QTest::newRow("a geom") << "r.arm.hull"
                                << "r.near r.feel";
        QTest::newRow("a geom of the other") << "r.arm2.hull"
                                             << "r.far r.press";
        QTest::newRow("a body of a Part") << "r.head.rod"
                                          << "r.head.tip";
        QTest::newRow("a device") << "r.far"
                                  << "r.far";
        QTest::newRow("in the config") << "RobotConfig.C.arm"
                                       << "r.near r.feel";
    }
    void devicesOfAPart() {
        QFETCH(QString, path);
        QFETCH(QString, devices);
        SessionFixture o;
        QVERIFY(
            o.open(R"(PartConfig Head { Body rod { Box b { Size=0.1,0.1,0.1 Mass=1 } } RangeSensor tip { Body=rod MaxRange=4 } }
RobotConfig C {
  Body arm { Box hull { Size=0.1,0.1,0.1 Mass=1 } }
  Body arm2 { Pos=1,0,0 Box hull { Size=0.1,0.1,0.1 Mass=1 } }
  Part head { Config=Head Pos=0,2,0 }
  Fixed f { Parent=arm Child=arm2 }
  Fixed g { Parent=arm Child=head.rod }
  RangeSensor near { Body=arm MaxRange=4 }
  RangeSensor far { Body=arm2 MaxRange=4 }
  TouchSensor feel { Geom=arm.hull }
  TouchSensor press { Geom=arm2.hull }
}
Robot r { Config=C }
)"));
        const LoadedProject& loaded = *o.document.loaded();
        QCOMPARE(loaded.diagnostics.errorCount(), 0u);
        QStringList found;
        for (const std::string& device : devicesOf(*loaded.experiment, *loaded.registry, path.toStdString()))
            found << QString::fromStdString(device);
        QCOMPARE(found.join(u' '), devices);
    }

    /// x is upwards and y to the left; what is out of reach has no dot.
    void aPlotIsSeenFromAbove() {
        const auto fan = std::make_shared<RangeModel>();
        fan->maxRange = 4;
        fan->beams = 3;
        fan->layers = 2;
        fan->directions = {Vec3(1, 0, 0),     Vec3(0, 1, 0),     Vec3(0.6, -0.8, 0),
                           Vec3(0.6, 0, 0.8), Vec3(0, 0.6, 0.8), Vec3(-1, 0, 0)};
        PolarPlot plot;
        plot.resize(300, 260);
        plot.setFan(fan);
        QVERIFY(!hasDot(plot.grab().toImage(), 0.25, 0));
        const double distances[] = {1, 2, 3, 3, 4, 3.5};
        plot.setDistances(distances);
        const QImage image = plot.grab().toImage();
        QVERIFY(hasDot(image, 0.25, 0));
        QVERIFY(hasDot(image, 0, 0.5));
        QVERIFY(hasDot(image, 0.45, -0.6));
        QVERIFY(hasDot(image, 0.45, 0)); // foreshortened
        QVERIFY(hasDot(image, -0.875, 0));
        QVERIFY(!hasDot(image, 0, -0.5));
        QVERIFY(!hasDot(image, 0.45, 0.6));
        QVERIFY(!hasDot(image, 0, 0.6)); // as far as it sees
        plot.setDistances({});
        QVERIFY(!hasDot(plot.grab().toImage(), 0, 0.5));
    }
};

QTEST_MAIN(SensorPartsTest)
#include "parts_test.moc"
