// A latch picks up, carries, lets go, is torn off, holds to scenery.
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

std::string scene(const std::string& latch, const std::string& more = "") {
    return "Tick=0.005\nSurface rubber { Friction=0.8 }\nStaticConfig Floor { Plane floor { Surface=rubber } }\n"
           "Static floor { Config=Floor }\n"
           "RobotConfig Crane { Body post { Pos=0,0,1 Box b { Size=0.1,0.1,0.1 Mass=50 Collide=false } }\n"
           " Body hook { Pos=0,0,0.2 Box b { Size=0.06,0.06,0.1 Mass=1 Surface=rubber } }\n"
           " Fixed hold { Parent=world Child=post }\n Slider rope { Parent=post Child=hook Axis=0,0,1 }\n"
           " LinearMotor winch { Joint=rope MaxForce=200 MaxSpeed=0.5 }\n" +
           latch +
           " }\nRobot crane { Config=Crane }\n"
           "RobotConfig Crate { Body body { Box b { Size=0.2,0.2,0.13 Pos=0,0,0.065 Mass=2 Surface=rubber } } }\n"
           "Robot crate { Config=Crate }\n" +
           more;
}

const std::string kLatch = " Latch magnet { Body=hook Pos=0,0,-0.05 HPR=0,90,0 Reach=0.03 }\n";

void set(SensorWorld& w, const char* signal, double value) {
    w.world().block().slots()[w.world().layout().find(signal)->offset] = value;
}

} // namespace

class LatchTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void liftsAndLetsGo() {
        SensorWorld w(scene(kLatch));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("crane/magnet/inReach"), 1.0);
        QVERIFY(w.run(5));
        QCOMPARE(w.value("crane/magnet/engaged"), 0.0);
        set(w, "crane/magnet/engage", 1);
        set(w, "crane/winch/target", 0);
        QVERIFY(w.run(20));
        QCOMPARE(w.value("crane/magnet/engaged"), 1.0);
        set(w, "crane/winch/target", 0.5);
        QVERIFY(w.run(500));
        const double high = w.pose("crate").position.z() - 0.065; // of its lower side
        QVERIFY2(std::abs(high - 0.5) < 0.03, qPrintable(QString::number(high)));
        QVERIFY2(std::abs(w.value("crane/magnet/force") - 2 * 9.81) < 0.5,
                 qPrintable(QString::number(w.value("crane/magnet/force"))));
        const Vec3 grip = w.pose("crate").position - w.pose("crane/hook").position;
        QVERIFY2((grip - Vec3(0, 0, -0.135)).norm() < 2e-3, qPrintable(QString::number(grip.z())));
        set(w, "crane/magnet/engage", 0);
        QVERIFY(w.run(200));
        QCOMPARE(w.value("crane/magnet/engaged"), 0.0);
        QVERIFY(w.pose("crate").position.z() < 0.07);
        QVERIFY(w.pose("crane/hook").position.z() > 0.6);
    }

    void reachesOnlySoFar() {
        SensorWorld w(scene(" Latch magnet { Body=hook Pos=0,0,-0.05 HPR=0,90,0 Reach=0.01 }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("crane/magnet/inReach"), 0.0);
        set(w, "crane/magnet/engage", 1);
        QVERIFY(w.run(20));
        QCOMPARE(w.value("crane/magnet/engaged"), 0.0);
    }

    /// More than it can carry tears it off, until engage begins again.
    void isTornOff() {
        SensorWorld w(scene(" Latch magnet { Body=hook Pos=0,0,-0.05 HPR=0,90,0 Reach=0.03 MaxForce=22 }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        set(w, "crane/magnet/engage", 1);
        QVERIFY(w.run(10));
        QCOMPARE(w.value("crane/magnet/engaged"), 1.0);
        set(w, "crane/winch/target", 0.5);
        QVERIFY(w.run(500));
        QCOMPARE(w.value("crane/magnet/engaged"), 0.0);
        QVERIFY(w.pose("crate").position.z() < 0.07);
    }

    void holdsToScenery() {
        SensorWorld w(scene(kLatch, "StaticConfig Board { Box b { Size=0.3,0.3,0.02 Pos=0,0,0.13 Surface=rubber } }\n"
                                    "Static board { Config=Board }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        set(w, "crane/magnet/engage", 1);
        QVERIFY(w.run(10));
        QCOMPARE(w.value("crane/magnet/engaged"), 1.0);
        set(w, "crane/winch/target", 0.5);
        QVERIFY(w.run(200));
        QVERIFY(std::abs(w.pose("crane/hook").position.z() - 0.2) < 5e-3);
        QVERIFY(w.value("crane/magnet/force") > 100);
    }

    void letsGoOfWhatIsPlacedElsewhere() {
        SensorWorld w(scene(kLatch));
        QVERIFY2(w.ok(), w.failure().c_str());
        set(w, "crane/magnet/engage", 1);
        QVERIFY(w.run(10));
        QVERIFY(w.world().place("crate", {Vec3(2, 0, 0), Quat::Identity()}).ok());
        QVERIFY(w.run(10));
        QCOMPARE(w.value("crane/magnet/engaged"), 0.0);
        QVERIFY(std::abs(w.pose("crate").position.x() - 2) < 1e-3);
        QVERIFY(w.world().robotFaults().ends.empty());
    }

    void wheeledEngineRefuses() {
        SensorWorld w("Engine=wheeled\n" + scene(kLatch));
        QVERIFY(!w.ok());
        QVERIFY2(w.failure().find("magnet is a Latch") != std::string::npos, w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(LatchTest)
#include "latch_test.moc"
