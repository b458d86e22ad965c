// The play of gears: against closed forms, in whole worlds.
#include "sensor_world.h"

#include <numbers>

#include "devices/gear_play.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kKt = 0.02, kKv = 50, kOhms = 2, kGear = 30, kVolts = 12, kPlay = 0.2; // rad
constexpr double kDisc = 0.01;                                                          // kg m^2: 2 kg of 0.1 m radius
constexpr double kFree = kVolts * kKv / kGear;                                          // rad/s without load

/// A disc on a frictionless axle.
std::string spinner(double tick, const std::string& more, double play = kPlay) {
    char text[1000];
    std::snprintf(
        text, sizeof text,
        "Tick=%g Gravity=0,0,0\nRobotConfig Spinner {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
        "  Body wheel { Cylinder disc { Radius=0.1 Length=0.02 Mass=2 } }\n  Fixed hold { Parent=world Child=stand }\n"
        "  Hinge axle { Parent=stand Child=wheel Axis=0,0,1 }\n  RotaryMotor motor { Joint=axle TorqueConstant=%g "
        "SpeedConstant=%g "
        "Resistance=%g GearRatio=%g MaxVoltage=%g Backlash=%.17g ",
        tick, kKt, kKv, kOhms, kGear, kVolts, play * 180 / std::numbers::pi);
    return text + more + " }\n}\nRobot r { Config=Spinner Pos=0,0,3 }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

/// One tick with a torque (N m) about the axle from outside.
bool turnBy(SensorWorld& w, double torque) {
    return w.world().push("r/wheel", {-torque / 2, 0, 0}, {0, 1, 3}).ok() &&
           w.world().push("r/wheel", {torque / 2, 0, 0}, {0, -1, 3}).ok() && w.run();
}

bool isNear(double value, double expected, double within) {
    if (std::abs(value - expected) <= within) return true;
    qWarning("%.9g, not %.9g", value, expected);
    return false;
}

void addTicks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.001, 0.005, 0.01}) QTest::addRow("%g ms", 1e3 * tick) << tick;
}

} // namespace

class BacklashTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aJointIsFreeWithinThePlay_data() { addTicks(); }
    /// Pushed, it turns by half of the play as if no motor were there, then the motor without voltage brakes it.
    void aJointIsFreeWithinThePlay() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, ""));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(turnBy(w, 0.002 / tick));
        const double rate = w.value("r/axle/rate");
        QVERIFY(isNear(rate, 0.2, 1e-6));
        while (w.value("r/axle/position") < kPlay / 2 - 2 * rate * tick) {
            QVERIFY(w.run());
            QVERIFY(isNear(w.value("r/axle/rate"), rate, 1e-9));
            QCOMPARE(w.value("r/motor/torque"), 0.);
        }
        QVERIFY(w.run(int(0.5 / tick)));
        QVERIFY(std::abs(w.value("r/axle/rate")) < 0.01 * rate);
        QVERIFY(isNear(w.value("r/axle/position"), kPlay / 2, 0.02));
    }

    void aReversedMotorCrossesThePlayFirst_data() { addTicks(); }
    /// From full speed one way to full speed the other way: the teeth part at once, and meet after play / (2 x the speed).
    void aReversedMotorCrossesThePlayFirst() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, ""));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", kVolts);
        QVERIFY(w.run(int(3 / tick)));
        const double rate = w.value("r/axle/rate");
        QVERIFY(isNear(rate, kFree, 0.01 * kFree));
        command(w, "r/motor/voltage", -kVolts);
        int ticks = 0;
        while (w.value("r/axle/rate") > rate - 1e-9 && ticks < 1000) {
            QVERIFY(w.run());
            ++ticks;
        }
        QVERIFY2(std::abs(ticks * tick - kPlay / (2 * kFree)) <= 2 * tick, qPrintable(QString::number(ticks)));
        QVERIFY(w.run(int(5 / tick)));
        QVERIFY(isNear(w.value("r/axle/rate"), -kFree, 0.01 * kFree));
    }

    void theRotorBringsItsMomentum_data() {
        QTest::addColumn<double>("rotor"); // kg m^2 at the joint
        QTest::addColumn<double>("tick");
        for (const double rotor : {0.003, 0.02})
            for (const double tick : {0.0005, 0.001})
                QTest::addRow("%g of the disc, %g ms", rotor / kDisc, 1e3 * tick) << rotor << tick;
    }
    /// From rest in the middle of the play it runs up along w0 (1 - exp(-t / T)), with T = J R / (k_t k_e G^2); the teeth meet where it has
    /// turned by half of the play, and then both turn at J w / (J + I).
    void theRotorBringsItsMomentum() {
        QFETCH(double, rotor);
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, "RotorInertia=" + std::to_string(rotor / kGear / kGear * 1e6) + "e-6"));
        QVERIFY2(w.ok(), w.failure().c_str());
        const double T = rotor * kOhms * kKv / (kKt * kGear * kGear);
        double from = 0, to = 10;
        for (int i = 0; i < 100; ++i) {
            const double t = (from + to) / 2;
            (kFree * (t - T * (1 - std::exp(-t / T))) < kPlay / 2 ? from : to) = t;
        }
        const double atContact = kFree * (1 - std::exp(-from / T)), expected = rotor * atContact / (rotor + kDisc);
        command(w, "r/motor/voltage", kVolts);
        int ticks = 0;
        while (!(w.value("r/axle/rate") > 0.01) && ticks < 10000) {
            QVERIFY(w.run());
            ++ticks;
        }
        QVERIFY2(std::abs(ticks * tick - from) <= 3 * tick, qPrintable(QString("%1 s, not %2").arg(ticks * tick).arg(from)));
        const double driven = kKt * kGear * kVolts / kOhms / (rotor + kDisc) * tick; // by the motor in the first tick, at most
        QVERIFY(isNear(w.value("r/axle/rate"), expected + driven / 2, driven / 2 + 0.03 * expected));
    }

    void aServoSeesThePlayOfItsGear_data() { addTicks(); }
    /// At rest on its target, it lets the joint turn within the play, and holds it outside.
    void aServoSeesThePlayOfItsGear() {
        QFETCH(double, tick);
        SensorWorld w(
            "Tick=" + std::to_string(tick) +
            " Gravity=0,0,0\nRobotConfig Arm {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
            "  Body wheel { Cylinder disc { Radius=0.1 Length=0.02 Mass=2 } }\n  Fixed hold { Parent=world Child=stand }\n"
            "  Hinge axle { Parent=stand Child=wheel Axis=0,0,1 }\n"
            "  Servo servo { Joint=axle MaxTorque=1 MaxSpeed=5 Mode=speed Backlash=" +
            std::to_string(kPlay * 180 / std::numbers::pi) + " }\n}\nRobot r { Config=Arm Pos=0,0,3 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(turnBy(w, 0.005 / tick)); // 0.5 rad/s
        while (w.value("r/axle/position") < kPlay / 2 - 0.5 * 2 * tick) {
            QVERIFY(w.run());
            QVERIFY(isNear(w.value("r/axle/rate"), 0.5, 1e-6));
        }
        QVERIFY(w.run(int(0.2 / tick)));
        QVERIFY(isNear(w.value("r/axle/rate"), 0, 1e-6));
        QVERIFY(
            isNear(w.value("r/axle/position"), kPlay / 2, 0.5 * 2 * tick + 0.0015)); // its torque stops the disc within 1.25 mrad
        command(w, "r/servo/target", 1);                                             // the drive has the whole play to go
        int ticks = 0;
        while (w.value("r/axle/rate") < 0.5 && ticks < 10000) {
            QVERIFY(w.run());
            ++ticks;
        }
        QVERIFY2(std::abs(ticks * tick - kPlay) <= 0.02 * kPlay + 0.005 + 3 * tick, qPrintable(QString::number(ticks * tick)));
    }

    void aGearWithoutPlayAlwaysReaches() {
        GearPlay play;
        play.start(0);
        QVERIFY(play.reaches(0) && play.reaches(-1) && play.reaches(0, 1, 0));
        play.start(0.1);
        QVERIFY(!play.reaches(1) && !play.reaches(-1) && !play.reaches(0));
        QCOMPARE(play.turn({2}, 0, 0.01), 0.); // to the front flank in 25 ms
        QCOMPARE(play.follow(0, 0.01), 0.);
        QVERIFY(!play.reaches(1));
        for (int i = 0; i < 2; ++i) {
            play.turn({2}, 0, 0.01);
            play.follow(0, 0.01);
        }
        QVERIFY(play.reaches(1) && !play.reaches(-1));
        QVERIFY(play.reaches(1e-9, 1e-6, 0) && !play.reaches(1e-9, 1e-6, -1)); // at its rate the last torque decides
    }
};

QTEST_APPLESS_MAIN(BacklashTest)
#include "backlash_test.moc"
