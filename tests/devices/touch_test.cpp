// Touch sensors against the forces of a weight at rest.
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

class TouchTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void feelsItsWeight_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    /// 1.2 kg press with 11.77 N, and with what pushes from above: pressed from 15 N on until less than 13 N.
    void feelsItsWeight() {
        QFETCH(double, tick);
        SensorWorld w("Tick=" + std::to_string(tick) +
                      "\nStaticConfig Floor { Plane floor { } }\nStatic floor { Config=Floor }\n"
                      "RobotConfig Block { Body b { Box g { Size=0.2,0.2,0.1 Mass=1.2 } } TouchSensor pad { Geom=b.g MinForce=15 "
                      "ReleaseForce=13 } }\nRobot r { Config=Block Pos=0,0,0.05 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        double before = 0;
        const auto pressedAt = [&](double more) { // slowly, so that nothing overshoots
            for (int i = 1; i <= 200; ++i)
                if (const double now = before + (more - before) * std::min(1., i / 100.);
                    !w.world().push("r/b", {0, 0, -now}, {0, 0, 0.05}).ok() || !w.run())
                    return -1.;
            before = more;
            const double force = 1.2 * 9.81 + more;
            return std::abs(w.value("r/pad/force") - force) < 1e-3 * force ? w.value("r/pad/pressed") : -1;
        };
        QCOMPARE(pressedAt(0), 0.);
        QCOMPARE(pressedAt(3.1), 0.); // 14.87 N
        QCOMPARE(pressedAt(3.4), 1.);
        QCOMPARE(pressedAt(1.4), 1.); // 13.17 N
        QCOMPARE(pressedAt(1.1), 0.);
        QCOMPARE(pressedAt(3.1), 0.);
    }
};

QTEST_GUILESS_MAIN(TouchTest)
#include "touch_test.moc"
