// The DifferentialDrive device on simulated joints.
#include "bench_robot.h"

#include <QtTest>

using namespace trundle;
using namespace trundle::test;

namespace {
/// Two wheels in the air with the given control mode; their inertia includes the robot's mass.
struct Base {
    explicit Base(const std::string& control, double tick = .01) : robot(tick) {
        BenchDevice& drive = robot.device("DifferentialDrive", "base"); // before its motors, as the world orders it
        drive.texts = {{"LeftMotor", {"left"}}, {"RightMotor", {"right"}}, {"Control", {control}}};
        drive.numbers = {{"WheelRadius", {.05}}, {"WheelSeparation", {.25}}};
        addMotor(robot, "left", "leftAxle");
        addMotor(robot, "right", "rightAxle");
        for (const char* axle : {"leftAxle", "rightAxle"}) robot.joint(axle).inertia = .0058;
    }
    double& at(const std::string& signal, int i = 0) { return robot.signal("base/" + signal)[i]; }
    void command(double v, double w, double x, double angle) {
        at("linearVelocity") = v;
        at("angularVelocity") = w;
        at("linearAmount") = x;
        at("angularAmount") = angle;
        at("sequence") += 1;
    }
    BenchRobot robot;
};
} // namespace

class DifferentialDriveTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void drivesAnAmount_data() {
        QTest::addColumn<QString>("control");
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("tolerance"); // m
        for (const double tick : {.001, .01, .03}) {
            QTest::addRow("servo %g", tick) << "servo" << tick << 1e-12;
            QTest::addRow("pi %g", tick) << "pi" << tick << 1e-4;
            QTest::addRow("voltage %g", tick) << "voltage" << tick << 1e-4; // the lag at the start cancels at the end
        }
    }
    void drivesAnAmount() {
        QFETCH(QString, control);
        QFETCH(double, tick);
        QFETCH(double, tolerance);
        Base base(control.toStdString(), tick);
        QCOMPARE(base.robot.setup(), std::string());
        base.command(.5, 0, 2, 0);
        base.robot.tick();
        QCOMPARE(base.at("busy"), 1.);
        QCOMPARE(base.at("done"), 0.);
        base.robot.run(6);
        QCOMPARE(base.at("done"), 1.);
        QCOMPARE(base.at("finished"), 1.);
        QVERIFY2(std::abs(base.at("odometry", 0) - 2) < tolerance, qPrintable(QString::number(base.at("odometry", 0), 'g', 12)));
        QVERIFY(std::abs(base.at("odometry", 1)) < 1e-9 && std::abs(base.at("odometry", 2)) < 1e-9);
        QVERIFY(base.robot.warnings.empty());
    }

    void odometryFollowsTheArc() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.command(.3, 1, 0, M_PI / 2);
        base.robot.run(4);
        QVERIFY(std::abs(base.at("odometry", 0) - .3) < 1e-9);
        QVERIFY(std::abs(base.at("odometry", 1) - .3) < 1e-9);
        QVERIFY(std::abs(base.at("odometry", 2) - M_PI / 2) < 1e-12);
    }

    /// Open loop, without ramps: the base lags by v * tau, tau = I / b.
    void voltageLagsByItsTimeConstant_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {.001, .01, .03}) QTest::addRow("%g s", tick) << tick;
    }
    void voltageLagsByItsTimeConstant() {
        QFETCH(double, tick);
        Base base("voltage", tick);
        base.robot.devices[0].numbers["MaxAcceleration"] = {0};
        QCOMPARE(base.robot.setup(), std::string());
        base.at("linearVelocity") = .5;
        base.robot.run(3);
        const double lag = .5 * 3 - base.at("odometry", 0);
        QVERIFY2(std::abs(lag - .5 * .0058 / .405) < 1e-6, qPrintable(QString::number(lag, 'g', 9)));
    }

    void computesOdometryFromWheels() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.robot.joint("leftAxle").inertia = base.robot.joint("rightAxle").inertia = 1e12; // practically locked
        base.command(.5, 0, 2, 0);
        base.robot.run(6);
        QVERIFY(std::abs(base.at("odometry", 0)) < 1e-6);
    }

    void truthIsTheMiddleBetweenTheWheels() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        for (const double heading : {0., .3, M_PI / 2, 2.5, -3., -1.2}) {
            const double aside = std::cos(heading) / 8, ahead = -std::sin(heading) / 8; // from the middle to the left wheel
            std::copy_n(std::array{1 + ahead, 2 + aside, .05}.data(), 3, base.robot.joint("leftAxle").anchor);
            std::copy_n(std::array{1 - ahead, 2 - aside, .05}.data(), 3, base.robot.joint("rightAxle").anchor);
            base.robot.tick();
            QVERIFY(std::abs(base.at("pose", 0) - 1) < 1e-12);
            QVERIFY(std::abs(base.at("pose", 1) - 2) < 1e-12);
            QVERIFY(std::abs(base.at("pose", 2) - heading) < 1e-12);
        }
    }

    void rejectsInvalidCommandAndReportsIt() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.command(0, 0, 1, 0);
        base.robot.run(1);
        QCOMPARE(base.robot.warnings.size(), std::size_t(1));
        QVERIFY(base.robot.warnings[0].find("refused") != std::string::npos);
        QCOMPARE(base.at("finished"), 1.); // so a controller that waits for it continues
        QCOMPARE(base.at("odometry", 0), 0.);
        base.command(0, 0, 1, 0); // the same once more
        base.robot.run(1);
        QCOMPARE(base.robot.warnings.size(), std::size_t(1));
        QCOMPARE(base.at("finished"), 2.);
        base.command(.2, 0, .1, 0);
        base.robot.run(2);
        QVERIFY(std::abs(base.at("odometry", 0) - .1) < 1e-12);
        base.command(0, 0, 1, 0);
        base.robot.run(1);
        QCOMPARE(base.robot.warnings.size(), std::size_t(2));
    }

    void newAmountStartsOnlyWithTheSequence() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.command(.2, 0, .1, 0);
        base.robot.run(4);
        QVERIFY(std::abs(base.at("odometry", 0) - .1) < 1e-12);
        base.at("sequence") += 1;
        base.robot.run(4);
        QVERIFY(std::abs(base.at("odometry", 0) - .2) < 1e-12);
    }

    /// `finished` is the sequence of the last amount that ended: it does not run ahead of one that is being driven.
    void finishedFollowsTheSequence() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.robot.run(.1);
        QCOMPARE(base.at("finished"), 0.);
        for (int number = 1; number <= 3; ++number) {
            base.command(.2, 0, .1, 0);
            base.robot.run(.2);
            QCOMPARE(base.at("busy"), 1.);
            QCOMPARE(base.at("done"), 0.);
            QCOMPARE(base.at("finished"), number - 1.);
            base.robot.run(4);
            QCOMPARE(base.at("busy"), 0.);
            QCOMPARE(base.at("done"), 1.);
            QCOMPARE(base.at("finished"), double(number));
        }
    }

    void moveEndsAnAmount() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.command(.2, 0, 100, 0);
        base.robot.run(1);
        base.at("linearVelocity") = base.at("linearAmount") = 0;
        base.robot.run(1);
        QCOMPARE(base.at("finished"), 1.);
        const double x = base.at("odometry", 0);
        base.robot.run(1);
        QCOMPARE(base.at("odometry", 0), x);
    }

    void warnsOnceOfTurnsTooFastForTheTick() {
        Base base("servo", .03);
        QCOMPARE(base.robot.setup(), std::string());
        base.at("angularVelocity") = 5;
        base.robot.run(3);
        QCOMPARE(base.robot.warnings.size(), std::size_t(1));
    }

    void treatsNanAsZero() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        for (const char* slot : {"linearVelocity", "angularVelocity", "linearAmount", "angularAmount", "sequence"})
            base.at(slot) = std::nan("");
        base.robot.run(.1);
        QCOMPARE(base.at("odometry", 0), 0.);
        QCOMPARE(base.robot.warnings.size(), std::size_t(5));
    }

    /// Two unlike motors: each wheel gets the voltage of its own gear and constant, so that open loop drives straight.
    void unlikeMotors_data() {
        QTest::addColumn<QString>("control");
        for (const char* control : {"servo", "pi", "voltage"}) QTest::newRow(control) << control;
    }
    void unlikeMotors() {
        QFETCH(QString, control);
        Base base(control.toStdString());
        auto& right = base.robot.devices[2].numbers;
        right.erase("BackEmfConstant");
        right["SpeedConstant"] = {50};
        right["GearRatio"] = {20};
        QCOMPARE(base.robot.setup(), std::string());
        base.at("linearVelocity") = .3;
        base.robot.run(4);
        QVERIFY(std::abs(base.robot.joint("leftAxle").rate - 6) < 1e-6 &&
                std::abs(base.robot.joint("rightAxle").rate - 6) < 1e-6);
        if (control != "servo") {
            QVERIFY(std::abs(base.robot.signal("left/voltage")[0] - 6 * 30 * .03) < 1e-3);
            QVERIFY(std::abs(base.robot.signal("right/voltage")[0] - 6. * 20 / 50) < 1e-3);
        }
        QVERIFY(base.robot.warnings.empty());
        base.at("linearVelocity") = .05 * 14; // above 12 V of the left one: 13.3 rad/s; the right one reaches 30
        base.robot.run(.5);
        QCOMPARE(base.robot.warnings.size(), std::size_t(1));
    }

    /// Each wheel turns the way its side asks for: left is positive y.
    void turnsOnTheSpot() {
        Base base("servo");
        QCOMPARE(base.robot.setup(), std::string());
        base.at("angularVelocity") = 1;
        base.robot.run(2);
        QVERIFY(std::abs(base.robot.joint("leftAxle").rate + 2.5) < 1e-9 &&
                std::abs(base.robot.joint("rightAxle").rate - 2.5) < 1e-9);
        QVERIFY(base.at("odometry", 2) > 1);
    }

    /// Against its limit of voltage the integral stops growing, in both directions: freed, the wheel does not overshoot.
    void piDoesNotWindUp_data() {
        QTest::addColumn<double>("speed");
        QTest::newRow("forwards") << .4;
        QTest::newRow("backwards") << -.4;
    }
    void piDoesNotWindUp() {
        QFETCH(double, speed);
        Base base("pi");
        base.robot.devices[0].numbers["MaxAcceleration"] = {0};
        QCOMPARE(base.robot.setup(), std::string());
        for (const char* axle : {"leftAxle", "rightAxle"}) base.robot.joint(axle).inertia = 1e6; // held
        base.at("linearVelocity") = speed;
        base.robot.run(20);
        for (const char* axle : {"leftAxle", "rightAxle"}) base.robot.joint(axle).inertia = .0058;
        double fastest = 0;
        for (int i = 0; i < 300; ++i) {
            base.robot.tick();
            fastest = std::max(fastest, std::abs(base.robot.joint("leftAxle").rate));
        }
        QVERIFY2(fastest < 12, qPrintable(QString::number(fastest)));
        QVERIFY(std::abs(base.robot.joint("leftAxle").rate - speed / .05) < .1);
    }

    void needsTwoMotors() {
        Base same("servo"), missing("servo");
        same.robot.devices[0].texts["RightMotor"] = {"left"};
        missing.robot.devices[0].texts["RightMotor"] = {"rigth"};
        QVERIFY(same.robot.setup().find("the same motor") != std::string::npos);
        QVERIFY(missing.robot.setup().find("'rigth'") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(DifferentialDriveTest)
#include "differential_drive_test.moc"
