// Bodies, joints and devices of a StaticConfig: doors, turntables, sensors fixed to the world; the same motion as a robot's.
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

const std::string kLeaf = "  Body leaf { Pos=0.5,0,0.6 Box panel { Size=0.98,0.04,1 Mass=8 } }\n"
                          "  Hinge hinge { Parent=world Child=leaf Anchor=0,0,0.6 Axis=0,0,1 Damping=0.2 }\n"
                          "  Servo opener { Joint=hinge MaxTorque=20 MaxSpeed=2 }\n";

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

} // namespace

class MovingSceneryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A door of scenery moves bit for bit as one that is a robot.
    void aDoorMovesAsARobotDoes() {
        const std::string pose = " Pos=1,2,0 HPR=30,0,0 }\n";
        SensorWorld scenery("Tick=0.005\nStaticConfig Door {\n  Box post { Size=0.1,0.1,2 Pos=-0.2,0,1 }\n" + kLeaf +
                            "}\nStatic door { Config=Door" + pose);
        SensorWorld robot("Tick=0.005\nRobotConfig Door {\n" + kLeaf + "}\nRobot door { Config=Door" + pose);
        QVERIFY2(scenery.ok(), scenery.failure().c_str());
        QVERIFY2(robot.ok(), robot.failure().c_str());
        for (SensorWorld* w : {&scenery, &robot}) command(*w, "door/opener/target", 1.2);
        QVERIFY(scenery.run(600) && robot.run(600));
        QVERIFY2(std::abs(scenery.value("door/hinge/position") - 1.2) < 1e-3,
                 qPrintable(QString::number(scenery.value("door/hinge/position"))));
        for (std::size_t i = 0; i < 7; ++i) QCOMPARE(scenery.value("door/leaf/pose", i), robot.value("door/leaf/pose", i));
        for (std::size_t i = 0; i < 3; ++i) QCOMPARE(scenery.value("door/pose", i), i == 0 ? 1. : i == 1 ? 2. : 0.);
        QCOMPARE(scenery.world().place("door", Pose()).ok(), false);
        QVERIFY(scenery.world().push("door/world", {1e6, 0, 0}, {0, 0, 0}).ok()); // nothing moves the world
        QVERIFY(scenery.run(10));
        QCOMPARE(scenery.value("door/world/velocity", 0), 0.);
        QCOMPARE(scenery.value("door/world/pose", 0), 1.);
    }

    /// A turntable carries a crate round, which does not sink into it.
    void aTurntableCarries() {
        SensorWorld w(
            "Tick=0.005\nStaticConfig Table {\n  Box base { Size=1,1,0.2 Pos=0,0,0.1 }\n"
            "  Body disc { Pos=0,0,0.24 Cylinder plate { Radius=0.5 Length=0.04 Mass=5 } }\n"
            "  Hinge pivot { Parent=world Child=disc Axis=0,0,1 }\n  Servo drive { Joint=pivot Mode=speed MaxTorque=20 "
            "MaxSpeed=2 }\n}\n"
            "Static table { Config=Table Pos=2,0,0 }\nRobotConfig Crate { Body body { Box box { Size=0.1,0.1,0.1 Mass=0.5 } } }\n"
            "Robot crate { Config=Crate Pos=2.3,0,0.31 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "table/drive/target", 0.5);
        QVERIFY(w.run(800));
        QVERIFY2(std::abs(w.value("crate/body/pose", 2) - 0.31) < 2e-4, qPrintable(QString::number(w.value("crate/body/pose", 2))));
        const double angle = w.value("table/pivot/position");
        const double x = w.value("crate/body/pose", 0) - 2, y = w.value("crate/body/pose", 1);
        QVERIFY2(std::abs(std::atan2(y, x) - angle) < 0.03 && std::abs(std::hypot(x, y) - 0.3) < 0.01,
                 qPrintable(QString("%1 of %2").arg(std::atan2(y, x)).arg(angle)));
    }

    /// Sensors on the world and on geoms of the scenery itself.
    void sensorsOfSceneryMeasure() {
        SensorWorld w(
            "Tick=0.01\nStaticConfig Gate {\n  Box plate { Size=0.4,0.4,0.1 Pos=0,0,0.05 }\n"
            "  RangeSensor eye { Body=world Pos=-1,0,0.2 MaxRange=5 Type=infrared }\n  TouchSensor scale { Geom=plate }\n}\n"
            "Static gate { Config=Gate Pos=0,3,0 }\nRobotConfig Crate { Body body { Box box { Size=0.2,0.2,0.2 Mass=2 } } }\n"
            "Robot crate { Config=Crate Pos=0,3,0.2 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(200));
        QVERIFY2(std::abs(w.value("gate/eye/range") - 0.9) < 1e-3, qPrintable(QString::number(w.value("gate/eye/range"))));
        QCOMPARE(w.value("gate/scale/pressed"), 1.);
        QVERIFY2(std::abs(w.value("gate/scale/force") - 2 * 9.81) < 0.01,
                 qPrintable(QString::number(w.value("gate/scale/force"))));
    }

    /// Two conveyors of one StaticConfig by its Part, in frames of their own.
    void partsAndMembersOfScenery() {
        SensorWorld w("Tick=0.01\nPartConfig Segment {\n  Box deck { Size=2,0.5,0.1 Pos=0,0,-0.05 }\n  Belt belt { Geom=deck "
                      "MaxSpeed=1 MaxAcceleration=0 }\n}\n"
                      "StaticConfig Line {\n  Part near { Config=Segment }\n  Part far { Config=Segment Pos=2,0,0 }\n}\n"
                      "Static line { Config=Line }\nRobotConfig Crate { Body body { Box box { Size=0.2,0.2,0.2 Mass=2 } } }\n"
                      "Robot crate { Config=Crate Pos=0,0,0.1 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "line/near.belt/speed", 0.5);
        command(w, "line/far.belt/speed", 0.25);
        QVERIFY(w.run(150));
        QVERIFY(std::abs(w.value("crate/body/velocity", 0) - 0.5) < 1e-3);
        QVERIFY(w.run(200));
        QVERIFY2(std::abs(w.value("crate/body/velocity", 0) - 0.25) < 1e-3,
                 qPrintable(QString::number(w.value("crate/body/velocity", 0))));
    }

    void isRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const QString box = "Box box { Size=1,1,1 Mass=1 }";
        QTest::newRow("loose") << "StaticConfig S { Body b { " + box + " } }\nStatic s { Config=S }\n"
                               << "no joint holds Body b";
        QTest::newRow("chain of loose bodies") << "StaticConfig S { Body a { " + box + " } Body b { Pos=2,0,0 " + box +
                                                      " } Hinge h { Parent=a Child=b } }\nStatic s { Config=S }\n"
                                               << "no joint holds Body a";
        QTest::newRow("world on a robot") << "RobotConfig R { Body b { " + box +
                                                 " } Imu i { Body=world } }\nRobot r { Config=R }\n"
                                          << "Body cannot be the world";
        QTest::newRow("world as child") << "StaticConfig S { Body b { " + box +
                                               " } Hinge h { Parent=b Child=world } }\nStatic s { Config=S }\n"
                                        << "Child cannot be the world, a Parent can";
    }
    void isRefused() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        SensorWorld w(text.toStdString());
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains(message), w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(MovingSceneryTest)
#include "moving_scenery_test.moc"
