// Belts and tracks: what friction carries, by closed forms; scenery and bodies; refusals.
#include <numbers>

#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kGravity = 9.81, kPi = std::numbers::pi;

std::string number(double value) { return QByteArray::number(value, 'g', 17).toStdString(); }

/// A belt of scenery at a slope, and a crate on it; x goes up the slope.
std::string slope(double friction, double degrees, const std::string& belt) {
    const double a = degrees * kPi / 180, above = 0.05 + 0.1; // half of both
    return "Tick=0.002\nSurface rough { Friction=" + number(friction) +
           " }\nStaticConfig Conveyor {\n  Box deck { Size=20,1,0.1 Surface=rough }\n  Belt belt { Geom=deck " + belt +
           " }\n}\nStatic line { Config=Conveyor HPR=0," + number(-degrees) +
           ",0 }\nRobotConfig Crate { Body body { Box box { Size=0.2,0.2,0.2 Surface=rough Mass=1 } } }\nRobot crate { "
           "Config=Crate Pos=" +
           number(-above * std::sin(a)) + ",0," + number(above * std::cos(a)) + " HPR=0," + number(-degrees) + ",0 }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

/// Along the slope.
double along(SensorWorld& w, double degrees, const char* path) {
    const double a = degrees * kPi / 180;
    return w.value(path, 0) * std::cos(a) + w.value(path, 2) * std::sin(a);
}

} // namespace

class BeltTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A crate put on a running belt slips at mu g until it has the belt's speed, and then stays on it.
    void carriesAtItsSpeed_data() {
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("speed");
        for (const double friction : {0.05, 0.3, 0.8})
            for (const double speed : {0.2, -0.6, 1.5}) QTest::addRow("%g, %g m/s", friction, speed) << friction << speed;
    }
    void carriesAtItsSpeed() {
        QFETCH(double, friction);
        QFETCH(double, speed);
        SensorWorld w(slope(friction, 0, "MaxSpeed=2 MaxAcceleration=0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(100));
        const double start = w.value("crate/body/pose", 0);
        command(w, "line/belt/speed", speed);
        const double rise = std::abs(speed) / (friction * kGravity); // s
        QVERIFY(w.run(int(0.5 * rise / 0.002)));
        const double half = w.value("crate/body/velocity", 0), now = 0.002 * int(0.5 * rise / 0.002);
        QVERIFY2(std::abs(std::abs(half) - friction * kGravity * now) < 0.01 * std::abs(speed) + friction * kGravity * 0.002,
                 qPrintable(QString::number(half)));
        QVERIFY(w.run(2000 - int(0.5 * rise / 0.002)));
        QVERIFY2(std::abs(w.value("crate/body/velocity", 0) - speed) < 1e-4 * std::abs(speed) + 1e-6,
                 qPrintable(QString::number(w.value("crate/body/velocity", 0))));
        const double way = speed * 4 - speed * rise / 2, gone = w.value("crate/body/pose", 0) - start;
        QVERIFY2(std::abs(gone - way) < 0.004 * std::abs(way), qPrintable(QString("%1, not %2").arg(gone).arg(way)));
        QCOMPARE(w.value("line/belt/rate"), speed);
        QVERIFY(std::abs(w.value("line/belt/travel") - 4 * speed) < 1e-9);
    }

    /// Physics takes a drum that is turned to the right as one that is turned to the left; its belt runs as the text says.
    void runsOnDrumsTurnedToEitherSide() {
        for (const int side : {1, -1}) { // gravity pulls the crate to the drum's side, along which its y axis points
            SensorWorld w(
                "Tick=0.002 Gravity=-9.81,0,0\nSurface rough { Friction=0.8 }\nStaticConfig Conveyor {\n"
                "  Cylinder drum { Radius=5 Length=2 HPR=0,0," +
                number(90 * side) +
                " Surface=rough }\n  Belt belt { Geom=drum MaxSpeed=2 Heading=90 }\n}\nStatic line { Config=Conveyor }\n"
                "RobotConfig Crate { Body body { Box box { Size=0.2,0.2,0.2 Surface=rough Mass=1 } } }\n"
                "Robot crate { Config=Crate Pos=5.1,0,0 }\n");
            QVERIFY2(w.ok(), w.failure().c_str());
            command(w, "line/belt/speed", 0.5);
            QVERIFY(w.run(200));
            const double z = w.value("crate/body/pose", 2);
            QVERIFY2(side * z > 0.1 && side * z < 0.25, qPrintable(QString::number(z)));
        }
    }

    /// On a slope it carries up while tan(slope) < mu; steeper, the crate slides down at g (sin - mu cos).
    void slipsWhereFrictionSays_data() {
        QTest::addColumn<double>("degrees");
        for (const double degrees : {10., 25.5, 27.5, 35.}) QTest::addRow("%g degrees", degrees) << degrees;
    }
    void slipsWhereFrictionSays() {
        QFETCH(double, degrees);
        const double friction = 0.5, a = degrees * kPi / 180;
        SensorWorld w(slope(friction, degrees, "MaxSpeed=1 MaxAcceleration=0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "line/belt/speed", 0.3);
        QVERIFY(w.run(degrees < 26 ? 2500 : 500));
        const double speed = along(w, degrees, "crate/body/velocity");
        if (std::tan(a) < friction) {
            QVERIFY2(std::abs(speed - 0.3) < 1e-3, qPrintable(QString::number(speed)));
            return;
        }
        const double pull = kGravity * (std::sin(a) - friction * std::cos(a));
        QVERIFY2(std::abs(speed + pull) < 0.02 * pull + 0.01, qPrintable(QString("%1, not %2").arg(speed).arg(-pull)));
    }

    /// A body whose own underside runs, on a belt that runs across: no slip is left between the two surfaces.
    void beltsAcrossEachOther() {
        const std::string text =
            "Tick=0.002\nSurface rough { Friction=0.6 }\nStaticConfig Conveyor { Box deck { Size=9,9,0.1 Pos=0,0,-0.05 "
            "Surface=rough }\n"
            "  Belt belt { Geom=deck Heading=90 MaxSpeed=1 } }\nStatic line { Config=Conveyor }\n"
            "RobotConfig Sled { Body body { Box sole { Size=0.4,0.4,0.1 Pos=0,0,0.05 Surface=rough Mass=2 } }\n"
            "  Belt belt { Geom=body.sole MaxSpeed=1 } }\nRobot sled { Config=Sled }\n";
        SensorWorld w(text);
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "line/belt/speed", 0.3);
        command(w, "sled/belt/speed", 0.2);
        QVERIFY(w.run(1500));
        QVERIFY2(std::abs(w.value("sled/body/velocity", 0) + 0.2) < 1e-3 &&
                     std::abs(w.value("sled/body/velocity", 1) - 0.3) < 1e-3,
                 qPrintable(QString("%1, %2").arg(w.value("sled/body/velocity", 0)).arg(w.value("sled/body/velocity", 1))));
    }

    void rampsItsSpeed() {
        SensorWorld w(slope(0.5, 0, "MaxSpeed=0.5 MaxAcceleration=0.25"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "line/belt/speed", 3);
        QVERIFY(w.run(500));
        QVERIFY(std::abs(w.value("line/belt/rate") - 0.25) < 1e-9);
        QVERIFY(w.run(1000));
        QCOMPARE(w.value("line/belt/rate"), 0.5); // MaxSpeed
        command(w, "line/belt/speed", std::nan(""));
        QVERIFY(w.run(2000));
        QCOMPARE(w.value("line/belt/rate"), 0.);
    }

    /// Driven by a battery it runs as fast as the voltage says, and draws its Power.
    void drawsFromTheBattery() {
        SensorWorld w(
            "Tick=0.01\nRobotConfig Cart { Body body { Box top { Size=0.4,0.4,0.1 Mass=2 } }\n"
            "  Belt belt { Geom=body.top MaxSpeed=0.5 MaxAcceleration=0 Power=12 }\n  Battery battery { Capacity=1 Voltage=12 "
            "}\n}\n"
            "StaticConfig Floor { Plane ground { } }\nStatic floor { Config=Floor }\nRobot cart { Config=Cart Pos=0,0,0.05 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "cart/belt/speed", 0.25);
        QVERIFY(w.run(100));
        QVERIFY2(std::abs(w.value("cart/battery/current") * w.value("cart/battery/voltage") - 6) < 0.05,
                 qPrintable(QString::number(w.value("cart/battery/current"))));
    }

    /// A vehicle on two tracks drives forwards at their speed, and turns as kinematics says but for what skids.
    void tracksDrive() {
        const std::string text =
            "Tick=0.002\nSurface pad { Friction=0.7 }\nStaticConfig Floor { Plane ground { Surface=pad } }\nStatic floor { "
            "Config=Floor }\n"
            "RobotConfig Crawler {\n  Body hull { Box box { Size=0.3,0.2,0.1 Pos=0,0,0.1 Mass=4 }\n"
            "    Box left { Size=0.4,0.05,0.08 Pos=0,0.15,0.04 Mass=1 Surface=pad }\n"
            "    Box right { Size=0.4,0.05,0.08 Pos=0,-0.15,0.04 Mass=1 Surface=pad } }\n"
            "  Track leftTrack { Geom=hull.left MaxSpeed=1 }\n  Track rightTrack { Geom=hull.right MaxSpeed=1 }\n"
            "  TrackDrive base { LeftTrack=leftTrack RightTrack=rightTrack TrackSeparation=0.3 }\n}\nRobot r { Config=Crawler "
            "}\n";
        SensorWorld w(text);
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/base/linearVelocity", 0.4);
        command(w, "r/base/linearAmount", 1);
        command(w, "r/base/sequence", 1);
        QVERIFY(w.run(2000));
        QCOMPARE(w.value("r/base/done"), 1.);
        QVERIFY2(std::abs(w.value("r/base/pose", 0) - 1) < 0.01, qPrintable(QString::number(w.value("r/base/pose", 0))));
        QVERIFY(std::abs(w.value("r/base/pose", 1)) < 1e-3);
        QVERIFY(std::abs(w.value("r/base/odometry", 0) - 1) < 1e-6);
        // Turning in place: boxes rest on their ends at +-a, where Coulomb friction along and across the tracks at +-b balances:
        // (v - w b) b = w a^2, so that w = v b / (a^2 + b^2), where the drive expects w = v / b.
        command(w, "r/base/linearVelocity", 0);
        command(w, "r/base/linearAmount", 0);
        command(w, "r/base/angularVelocity", 1);
        QVERIFY(w.run(2000));
        const double rate = w.value("r/hull/velocity", 5), x = w.value("r/base/pose", 0);
        const double coulomb = 0.15 * 0.15 / (0.2 * 0.2 + 0.15 * 0.15);
        qInfo("turns at %.3f of the commanded rate, by Coulomb's law at %.3f", rate, coulomb);
        QVERIFY(std::abs(rate - coulomb) < 0.05 * coulomb && std::abs(x - 1) < 0.05);
    }

    /// Tracks that are bodies of their own: the base is between them, and knows how much faster than the ground goes by they run.
    void aTrackDriveMeasuresItsSlip() {
        SensorWorld w(
            "Tick=0.01\nSurface pad { Friction=0.4 }\nStaticConfig Floor { Plane ground { Surface=pad } }\nStatic floor { "
            "Config=Floor }\nPartConfig Side { Body t { Box g { Size=0.6,0.08,0.1 Pos=0,0,0.05 Mass=1 Surface=pad } } Fixed f { "
            "Parent=$carrier Child=t } Track tr { Geom=t.g MaxSpeed=3 } }\n"
            "RobotConfig Tank { Body ch { Box h { Size=0.5,0.3,0.1 Pos=0,0,0.15 Mass=5 } }\n"
            "  Part L { Config=Side carrier=ch Pos=0,0.21,0 } Part R { Config=Side carrier=ch Pos=0,-0.21,0 }\n"
            "  TrackDrive d { LeftTrack=L.tr RightTrack=R.tr TrackSeparation=0.42 MaxAcceleration=0 } }\n"
            "Robot r { Config=Tank Pos=1,2,0 HPR=40,0,0 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(5));
        QVERIFY(std::hypot(w.value("r/d/pose", 0) - 1, w.value("r/d/pose", 1) - 2) < 1e-3);
        QVERIFY(std::abs(w.value("r/d/pose", 2) - 40 * kPi / 180) < 1e-3);
        QVERIFY(std::abs(w.value("r/d/slip", 0)) < 1e-3 && std::abs(w.value("r/d/slip", 1)) < 1e-3);
        command(w, "r/d/linearVelocity", 2);
        QVERIFY(w.run(10));
        const double speed = w.vector("r/ch/velocity").head<2>().norm();
        QVERIFY(speed > 0.2 && speed < 0.5); // mu g t
        for (const std::size_t side : {0u, 1u}) QVERIFY(std::abs(w.value("r/d/slip", side) - (2 - speed)) < 0.01);
        command(w, "r/d/linearVelocity", 0);
        command(w, "r/d/angularVelocity", 3);
        QVERIFY(w.run(10));
        const double turns = w.value("r/ch/velocity", 5);
        for (const int side : {-1, 1}) {
            const Vec3 forward = rotationFromHpr(Vec3(w.value("r/d/pose", 2), 0, 0)) * Vec3::UnitX();
            const double moves = w.vector("r/ch/velocity").dot(forward) + side * 0.21 * turns;
            const double slip = w.value("r/d/slip", side < 0 ? 0 : 1), rate = w.value(side < 0 ? "r/L.tr/rate" : "r/R.tr/rate");
            QVERIFY2(std::abs(slip - (rate - moves)) < 0.001,
                     qPrintable(QStringLiteral("%1 %2 %3 %4").arg(slip).arg(moves).arg(turns).arg(side)));
        }
    }

    /// Tracks that are geoms of a Repeat in a Body: the base finds the body that they belong to.
    void tracksMayBeInARepeat() {
        SensorWorld w("StaticConfig Floor { Plane ground { } }\nStatic floor { Config=Floor }\nRobotConfig Tank { Body hull { Box h { "
                      "Size=0.4,0.2,0.1 Pos=0,0,0.1 Mass=5 }\n  Repeat pad { Count=2 Pos=0,$(0.3*index - 0.15),0.03 Box b { Size=0.4,0.05,0.06 "
                      "Mass=0.1 } } }\n  Track rt { Geom=hull.pad_0.b MaxSpeed=1 } Track lt { Geom=hull.pad_1.b MaxSpeed=1 }\n"
                      "  TrackDrive base { LeftTrack=lt RightTrack=rt TrackSeparation=0.3 } }\nRobot r { Config=Tank }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/base/linearVelocity", 0.2);
        QVERIFY(w.run(200));
        QVERIFY(w.value("r/base/pose", 0) > 0.2);
    }

    void isRefused_data() {
        QTest::addColumn<QString>("device");
        QTest::addColumn<QString>("message");
        QTest::newRow("unknown geom") << "Belt belt { Geom=body.bax MaxSpeed=1 }"
                                      << "Geom names body.bax";
        QTest::newRow("without contacts") << "Belt belt { Geom=body.ghost MaxSpeed=1 }"
                                          << "does not collide";
        QTest::newRow("a body") << "Belt belt { Geom=body MaxSpeed=1 }"
                                << "it takes a geom";
        QTest::newRow("one track")
            << "Track t { Geom=body.box MaxSpeed=1 } TrackDrive d { LeftTrack=t RightTrack=t TrackSeparation=1 }"
            << "the same track";
    }
    void isRefused() {
        QFETCH(QString, device);
        QFETCH(QString, message);
        SensorWorld w("RobotConfig R { Body body { Box box { Size=1,1,1 Mass=1 } Box ghost { Size=1,1,1 Collide=false } }\n" +
                      device.toStdString() + " }\nRobot r { Config=R }\n");
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains(message), w.failure().c_str());
    }

    void theWheeledEngineHasNone_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("on a robot") << "RobotConfig R { Body body { Box box { Size=1,1,1 Pos=0,0,0.5 Mass=1 } }\n"
                                       "Belt belt { Geom=body.box MaxSpeed=1 } }\nRobot r { Config=R }\n";
        QTest::newRow("in scenery") << "StaticConfig Line { Box deck { Size=1,1,0.5 Pos=3,0,0.25 }\n"
                                       "Belt belt { Geom=deck MaxSpeed=1 } }\nStatic line { Config=Line }\n";
    }
    void theWheeledEngineHasNone() {
        QFETCH(QString, text);
        SensorWorld w("Engine=wheeled\nStaticConfig Floor { Plane ground { } }\nStatic floor { Config=Floor }\n" +
                      text.toStdString());
        QVERIFY(!w.ok());
        QVERIFY2(w.failure().find("Engine = wheeled is not possible") != std::string::npos, w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(BeltTest)
#include "belt_test.moc"
