// The RotaryMotor device against the motor equations.
#include "bench_robot.h"
#include "devices/rotary_motor.h"

#include <QtTest>

using namespace trundle;
using namespace trundle::test;

namespace {
constexpr MotorConstants kM0{.03, 1 / .03, 2, 30, 12, 0, 1};
} // namespace

class RotaryMotorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Thesis eq. 3.1 at 12 V: the motor constraint gives T = (rate - w) / softness.
    void torqueFallsWithTheRate_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("torque");
        QTest::newRow("at rest") << 0. << 5.4;
        QTest::newRow("5 rad/s") << 5. << 3.375;
        QTest::newRow("10 rad/s") << 10. << 1.35;
        QTest::newRow("without load") << 40. / 3 << 0.;
    }
    void torqueFallsWithTheRate() {
        QFETCH(double, rate);
        QFETCH(double, torque);
        const VoltageConstraint row = voltageConstraint(kM0, 12, 0, .01);
        QVERIFY(std::abs((row.rate - rate) / row.softness - torque) < 1e-12);
        QVERIFY(std::abs(row.limit - 5.4) < 1e-12);
        QVERIFY(std::abs(1 / row.softness - .405) < 1e-12);
    }

    /// A wheel in the air reaches the no-load rate at any tick length, without overshoot.
    void isStableAtAnyTick_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {.001, .01, .03, .05, .5}) QTest::addRow("%g s", tick) << tick;
    }
    void isStableAtAnyTick() {
        QFETCH(double, tick);
        BenchRobot robot(tick);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 12;
        double last = 0;
        for (int i = 0; i < 2000; ++i) {
            robot.tick();
            const double rate = robot.signal("motor/rate")[0];
            QVERIFY(rate >= last - 1e-12 && rate < 40. / 3 + 1e-9);
            last = rate;
        }
        QVERIFY(std::abs(last - 40. / 3) < 1e-6);
    }

    void aVoltageWhileADriveTurnsItIsReportedOnce() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/servo")[0] = 1;
        for (int i = 0; i < 3; ++i) robot.tick();
        QCOMPARE(robot.warnings.size(), std::size_t(0));
        robot.signal("motor/voltage")[0] = 6;
        for (int i = 0; i < 3; ++i) robot.tick();
        QCOMPARE(robot.warnings.size(), std::size_t(1));
        QVERIFY(robot.warnings[0].find("voltage has no effect") != std::string::npos);
    }

    void spinsUpWithItsTimeConstant() {
        BenchRobot robot(.0001);
        robot.joint("axle").inertia = .0405; // tau = I / b = .1 s
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 6;
        robot.run(.1);
        QVERIFY(std::abs(robot.signal("motor/rate")[0] / (20. / 3) - (1 - std::exp(-1.))) < 1e-3);
        // i = (V - G w / kv) / R
        const double current = (6 - 30 * robot.signal("motor/rate")[0] * .03) / 2;
        QVERIFY(std::abs(robot.signal("motor/current")[0] - current) < 1e-9);
    }

    void clipsTheVoltage() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = -100;
        robot.run(2);
        QVERIFY(std::abs(robot.signal("motor/rate")[0] + 40. / 3) < 1e-6);
    }

    /// The voltage between its terminals, also when the joint is driven from outside.
    void reportsTerminalVoltage() {
        BenchRobot robot(.01);
        robot.joint("axle").inertia = .0405;
        addMotor(robot, "motor", "axle").numbers["Inductance"] = {.002};
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 6;
        for (int i = 0; i < 20; ++i) {
            robot.tick();
            QVERIFY(std::abs(robot.signal("motor/terminalVoltage")[0] - 6) < 1e-6);
        }
        robot.signal("motor/servo")[0] = 1;
        robot.signal("motor/targetRate")[0] = 5;
        robot.run(1);
        QVERIFY(std::abs(robot.signal("motor/rate")[0] - 5) < 1e-6);
        QVERIFY(std::abs(robot.signal("motor/terminalVoltage")[0] - 30 * 5 * .03) < 1e-3); // without load: the back EMF
    }

    /// At any tick: I = V / R (1 - exp(-t R / L)), of a joint that is held.
    void theCurrentOfACoilIsExact_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {.001, .005, .01, .02, .03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    void theCurrentOfACoilIsExact() {
        QFETCH(double, tick);
        BenchRobot robot(tick);
        robot.joint("axle").inertia = 1e12;
        addMotor(robot, "motor", "axle").numbers["Inductance"] = {.4}; // L / R = 0.2 s
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 10;
        for (int i = 1; i <= 20; ++i) {
            robot.tick();
            QVERIFY(std::abs(robot.signal("motor/current")[0] - 5 * (1 - std::exp(-i * tick / .2))) < 1e-6);
        }
    }
    void inductanceDelaysTheCurrent() {
        BenchRobot robot(1e-5);
        robot.joint("axle").inertia = 1e9;                              // held
        addMotor(robot, "motor", "axle").numbers["Inductance"] = {.02}; // L / R = 10 ms
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 10;
        robot.run(.01);
        QVERIFY2(std::abs(robot.signal("motor/current")[0] - 5 * (1 - std::exp(-1.))) < 2e-3,
                 qPrintable(QString::number(robot.signal("motor/current")[0])));
        robot.run(.1);
        QVERIFY(std::abs(robot.signal("motor/current")[0] - 5) < 1e-3);
    }

    void rotorWeighsGearRatioSquared() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle").numbers["RotorInertia"] = {2e-6};
        QCOMPARE(robot.setup(), std::string());
        QVERIFY(std::abs(robot.joint("axle").inertia - (1e-3 + 900 * 2e-6)) < 1e-15);
    }

    void servoKeepsRateWithinTorque() {
        BenchRobot robot(.01);
        robot.joint("axle").inertia = .0054;
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/servo")[0] = 1;
        robot.signal("motor/targetRate")[0] = 5;
        robot.tick();
        QVERIFY(std::abs(robot.signal("motor/rate")[0] - 5) < 1e-12);
        QCOMPARE(robot.signal("motor/saturated")[0], 0.);
        robot.joint("axle").inertia = 5.4;
        robot.signal("motor/targetRate")[0] = 6;
        robot.tick();
        const double torque = robot.signal("motor/torque")[0], rate = robot.signal("motor/rate")[0];
        QVERIFY(std::abs(torque - (5.4 - .405 * rate)) < 1e-12); // on the line of 12 V at the rate reached
        QVERIFY(std::abs(rate - (5 + .01 * torque / 5.4)) < 1e-12);
        QCOMPARE(robot.signal("motor/saturated")[0], 1.);
        robot.signal("motor/targetRate")[0] = 4; // against the motion it has the stall torque
        robot.tick();
        QVERIFY(std::abs(robot.signal("motor/torque")[0] + 5.4) < 1e-12);
        QVERIFY(robot.warnings.empty());
    }

    /// A rate that no voltage gives: it ends at the no-load rate, says so in a signal, and once in words.
    void servoBeyondReachSaturates() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/servo")[0] = 1;
        robot.signal("motor/targetRate")[0] = -20;
        robot.run(1);
        QVERIFY(std::abs(robot.signal("motor/rate")[0] + 40. / 3) < 1e-6);
        QCOMPARE(robot.signal("motor/saturated")[0], 1.);
        QCOMPARE(robot.warnings.size(), std::size_t(1));
        QVERIFY(robot.warnings[0].find("-20 rad/s") != std::string::npos && robot.warnings[0].find("13.3") != std::string::npos);
    }

    void voltageAboveTheHighestSaturates() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 12;
        robot.tick();
        QCOMPARE(robot.signal("motor/saturated")[0], 0.);
        robot.signal("motor/voltage")[0] = 12.1;
        robot.tick();
        QCOMPARE(robot.signal("motor/saturated")[0], 1.);
    }

    /// Each live value holds from the next tick on; the others do not change.
    void takesLiveValues_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("torque"); // held at 12 V
        QTest::newRow("Efficiency") << "Efficiency" << .5 << 2.7;
        QTest::newRow("Resistance") << "Resistance" << 4. << 2.7;
        QTest::newRow("TorqueConstant") << "TorqueConstant" << .06 << 10.8;
        QTest::newRow("Inductance") << "Inductance" << .02 << 5.4 * 2 / (2 + .02 / .01) + 5.4 * 2 / (2 + .02 / .01);
    }
    void takesLiveValues() {
        QFETCH(QString, field);
        QFETCH(double, value);
        QFETCH(double, torque);
        BenchRobot robot(.01);
        robot.joint("axle").inertia = 1e12; // held
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 12;
        robot.tick();
        QVERIFY(std::abs(robot.signal("motor/torque")[0] - 5.4) < 1e-9);
        BenchDevice& motor = robot.devices[0];
        std::uint32_t index = 0;
        while (field != motor.code->fields[index].name) ++index;
        QVERIFY(motor.code->fields[index].flags & TRUNDLE_LIVE);
        const TrundleValue live{&value, nullptr, 1};
        QCOMPARE(motor.code->set(motor.instance, index, &live), 0);
        robot.tick();
        QVERIFY2(std::abs(robot.signal("motor/torque")[0] - torque) < 1e-6,
                 qPrintable(QString::number(robot.signal("motor/torque")[0])));
        const double current =
            field == "TorqueConstant" ? torque / (.06 * 30) : torque / (.03 * 30 * (field == "Efficiency" ? .5 : 1));
        QVERIFY(std::abs(robot.signal("motor/current")[0] - current) < 1e-6);
    }

    /// Of a held joint at 12 V, then at -4 V: I = V / R + (6 - V / R) exp(-t R / L), with the coil that it has by then.
    void aLiveInductanceDelaysTheNextChange_data() {
        QTest::addColumn<double>("before");
        QTest::addColumn<double>("after"); // H
        QTest::newRow("a coil from now on") << 0. << .4;
        QTest::newRow("a larger one") << .1 << .8;
        QTest::newRow("a smaller one") << .8 << .1;
        QTest::newRow("none any more") << .4 << 0.;
    }
    void aLiveInductanceDelaysTheNextChange() {
        QFETCH(double, before);
        QFETCH(const double, after);
        BenchRobot robot(.01);
        robot.joint("axle").inertia = 1e12; // held
        addMotor(robot, "motor", "axle").numbers["Inductance"] = {before};
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = 12;
        robot.run(8); // at least 20 L / R
        QVERIFY(std::abs(robot.signal("motor/current")[0] - 6) < 1e-6);
        BenchDevice& motor = robot.devices[0];
        std::uint32_t index = 0;
        while (std::string("Inductance") != motor.code->fields[index].name) ++index;
        const TrundleValue live{&after, nullptr, 1};
        QCOMPARE(motor.code->set(motor.instance, index, &live), 0);
        robot.signal("motor/voltage")[0] = -4;
        for (int i = 1; i <= 20; ++i) {
            robot.tick();
            const double expected = -2 + (after > 0 ? 8 * std::exp(-i * .01 * 2 / after) : 0.);
            QVERIFY2(std::abs(robot.signal("motor/current")[0] - expected) < 1e-6,
                     qPrintable(QString("%1 A, %2 A").arg(robot.signal("motor/current")[0]).arg(expected)));
        }
    }

    void needsExactlyOneSpeedConstant() {
        BenchRobot both(.01), neither(.01);
        addMotor(both, "motor", "axle").numbers["SpeedConstant"] = {33};
        addMotor(neither, "motor", "axle").numbers.erase("BackEmfConstant");
        QVERIFY(both.setup().find("one of them") != std::string::npos);
        QVERIFY(neither.setup().find("give SpeedConstant or") != std::string::npos);
    }

    void namesAJointThatIsNotThere() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle").texts["Joint"] = {"axel"};
        QVERIFY(robot.setup().find("'axel'") != std::string::npos);
    }

    void treatsNanAsZeroAndReportsOnce() {
        BenchRobot robot(.01);
        addMotor(robot, "motor", "axle");
        QCOMPARE(robot.setup(), std::string());
        robot.signal("motor/voltage")[0] = std::nan("");
        robot.tick();
        robot.signal("motor/voltage")[0] = HUGE_VAL;
        robot.tick();
        QCOMPARE(robot.signal("motor/rate")[0], 0.);
        QCOMPARE(robot.warnings.size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(RotaryMotorTest)
#include "rotary_motor_test.moc"
