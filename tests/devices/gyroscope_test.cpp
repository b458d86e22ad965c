// Wheels that spin on what turns: the gyroscopic torque of bodies that joints hold.
#include <cmath>
#include <numbers>

#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

/// A hub that a servo turns about the vertical, and on it a wheel (or a rod) that a motor spins about a level axis.
std::string spinner(double tick, double radius, double length) {
    char text[2000];
    std::snprintf(text, sizeof text,
                  "Tick=%g\nRobotConfig C {\n  Body hub { Box c { Size=0.3,0.3,0.1 Mass=5 Collide=false } }\n"
                  "  Body w { Pos=0,0.2,0.1 Cylinder c { Radius=%g Length=%g HPR=0,0,90 Mass=5 Collide=false } }\n"
                  "  Hinge ax { Parent=world Child=hub Axis=0,0,1 } Hinge wx { Parent=hub Child=w Axis=0,1,0 }\n"
                  "  Servo turn { Joint=ax Mode=speed MaxTorque=1000 MaxSpeed=1000 }\n"
                  "  RotaryMotor spin { Joint=wx TorqueConstant=1 BackEmfConstant=1 Resistance=0.1 MaxVoltage=400 }\n"
                  "}\nRobot r { Config=C Pos=0,0,2 }\n",
                  tick, radius, length);
    return text;
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

/// A wheel on one end of its axle, whose other end a ball holds to the world. `joint`: of the wheel on the axle.
std::string onePointTop(double tick, const std::string& joint) {
    return "Tick=" + std::to_string(tick) +
           "\nRobotConfig G { Body rod { Mass=0.1 Inertia=0.0001,0.001,0.001 CenterOfMass=0.15,0,0 Box b { Size=0.3,0.02,0.02 "
           "Pos=0.15,0,0 "
           "Collide=false } }\n  Body w { Pos=0.3,0,0 Mass=2 Inertia=0.06,0.03,0.03 Cylinder c { Radius=0.25 Length=0.02 "
           "HPR=0,90,0 "
           "Collide=false } }\n  Ball p { Parent=world Child=rod } " +
           joint + " }\nRobot r { Config=G Pos=0,0,2 }\n";
}

} // namespace

class GyroscopeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void turningNeedsNoTorque_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("length");
        QTest::addColumn<double>("spin");
        QTest::addColumn<double>("turn");
        QTest::addColumn<double>("tick");
        const auto row = [](const char* name, double radius, double length, double spin, double turn, double tick) {
            QTest::newRow(name) << radius << length << spin << turn << tick;
        };
        row("disc, 1 ms", 0.1, 0.05, 60, 1.5, 0.001);
        row("disc, 10 ms", 0.1, 0.05, 60, 1.5, 0.01);
        row("rod, 10 ms", 0.03, 0.3, 60, 1.5, 0.01);
        row("fast disc, 3 ms", 0.1, 0.05, 150, 3, 0.003);
        row("disc, 30 ms", 0.12, 0.04, 25, -2, 0.03);
    }
    /// About the axis about which it turns, steadily: the moment is across it.
    void turningNeedsNoTorque() {
        QFETCH(double, radius);
        QFETCH(double, length);
        QFETCH(double, spin);
        QFETCH(double, turn);
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, radius, length));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/spin/voltage", spin);
        QVERIFY(w.run(static_cast<int>(std::lround(1.5 / tick))));
        command(w, "r/turn/target", turn);
        QVERIFY(w.run(static_cast<int>(std::lround(1.5 / tick))));
        const double moment = 5 * radius * radius / 2 * w.value("r/wx/rate") * turn, torque = w.value("r/turn/torque");
        qInfo("%.3g N m about the axis, beside a moment of %.4g across it", torque, moment);
        QVERIFY(std::abs(moment) > 0.2 && std::abs(torque) < 0.003 * std::abs(moment));
    }

    void aTopOfTwoBodiesStaysUp_data() {
        QTest::addColumn<QString>("joint");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.005, 0.01}) {
            QTest::addRow("fixed, %g ms", 1e3 * tick) << "Fixed j { Parent=rod Child=w }" << tick;
            QTest::addRow("hinge, %g ms", 1e3 * tick) << "Hinge j { Parent=rod Child=w Axis=1,0,0 }" << tick;
        }
    }
    /// It goes round steadily, its axle level.
    void aTopOfTwoBodiesStaysUp() {
        QFETCH(QString, joint);
        QFETCH(double, tick);
        SensorWorld w(onePointTop(tick, joint.toStdString()));
        QVERIFY2(w.ok(), w.failure().c_str());
        const double spin = 30, momentum = 0.0601 * spin, round = 0.615 * 9.81 / momentum;
        for (const double side : {1., -1.}) (void)w.world().push("r/w", {0, 0, side * momentum / tick / 2}, {0.3, side, 2});
        (void)w.world().push("r/w", {0, 0.2133 * round / 0.3 / tick, 0}, {0.3, 0, 2});
        double lowest = 0;
        for (int k = 0; k < 10; ++k) {
            QVERIFY(w.run(static_cast<int>(std::lround(1 / tick))));
            const Vec3 axle = w.pose("r/w").rotation * Vec3::UnitX();
            lowest = std::min(lowest, std::asin(axle.z()) * 180 / std::numbers::pi);
        }
        qInfo("sinks by %.2f degrees in 10 s", -lowest);
        QVERIFY(lowest > -3);
    }
};

QTEST_GUILESS_MAIN(GyroscopeTest)
#include "gyroscope_test.moc"
