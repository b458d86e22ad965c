// Bases that move in any direction, and bases that steer: straight ways and arcs in simulation, odometry, kinematics, refusals.
#include "sensor_world.h"

#include <numbers>

#include "devices/omni_kinematics.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// A wheel at a place, its axle turned by `heading` from +y.
std::string wheel(const std::string& name, double x, double y, double heading, const char* surface, const char* parent = "hull") {
    char text[900];
    std::snprintf(
        text, sizeof text,
        "  Body %s { Pos=%.9g,%.9g,0.05 HPR=%.9g,0,0 Cylinder tyre { Radius=0.05 Length=0.02 HPR=0,0,90 Mass=0.2 Surface=%s } }\n"
        "  Hinge %sAxle { Parent=%s Child=%s Axis=%.12g,%.12g,0 }\n"
        "  RotaryMotor %sMotor { Joint=%sAxle TorqueConstant=0.03 SpeedConstant=33 Resistance=1 GearRatio=30 MaxVoltage=12 }\n",
        name.c_str(), x, y, heading, surface, name.c_str(), parent, name.c_str(), -std::sin(heading * kPi / 180),
        std::cos(heading * kPi / 180), name.c_str(), name.c_str());
    return text;
}

std::string experiment(const std::string& parts, const char* hull = "Size=0.2,0.2,0.06 Pos=0,0,0.08") {
    return "Tick=0.005\nSurface rubber { Friction=0.8 }\nSurface slick { Friction=0 }\n"
           "Surface rollers { Friction=0.8 Friction2=0 }\nSurface leftRollers { Friction=0.8 Friction2=0 FrictionHeading=-45 }\n"
           "Surface rightRollers { Friction=0.8 Friction2=0 FrictionHeading=45 }\n"
           "StaticConfig Floor { Plane floor { Surface=rubber } }\nStatic floor { Config=Floor }\nRobotConfig Base {\n"
           "  Body hull { Box box { " +
           std::string(hull) + " Mass=3 Surface=slick } }\n" + parts + "}\nRobot r { Config=Base Pos=0.1,-0.2,0 HPR=30,0,0 }\n";
}

std::string omni(int count, const std::string& more = "", double first = 0.5) {
    std::string text, motors;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * kPi * (i + first) / count;
        const std::string name = "w" + std::to_string(i);
        // The axle's positive end points to the middle: a positive rate turns the base to the left.
        text += wheel(name, 0.15 * std::cos(angle), 0.15 * std::sin(angle), angle * 180 / kPi + 90, "rollers");
        motors += (i ? "," : "") + name + "Motor";
    }
    return experiment(text + "  OmniDrive base { Motors=" + motors + " WheelRadius=0.05 WheelDistance=0.15 " + more + " }\n");
}

std::string mecanum(const std::string& more = "", const char* first = "fl") {
    return experiment(
        wheel("fl", 0.12, 0.14, 0, "leftRollers") + wheel("fr", 0.12, -0.14, 0, "rightRollers") +
        wheel("bl", -0.12, 0.14, 0, "rightRollers") + wheel("br", -0.12, -0.14, 0, "leftRollers") +
        "  MecanumDrive base { FrontLeftMotor=" + first +
        "Motor FrontRightMotor=frMotor BackLeftMotor=blMotor BackRightMotor=brMotor WheelRadius=0.05 WheelBase=0.24 "
        "WheelSeparation=0.28 " +
        more + " }\n");
}

std::string car(const std::string& more = "", const std::string& right = "frSteer", const std::string& servo = "") {
    std::string text;
    for (const auto& [name, y] : {std::pair<std::string, double>("fl", 0.1), {"fr", -0.1}}) {
        char knuckle[700];
        std::snprintf(
            knuckle, sizeof knuckle,
            "  Body %sKnuckle { Pos=0.3,%g,0.05 Box block { Size=0.03,0.02,0.03 Mass=0.1 Surface=slick } }\n"
            "  Hinge %sPivot { Parent=hull Child=%sKnuckle Axis=0,0,1 }\n"
            "  Servo %sSteer { Joint=%sPivot MaxTorque=2 MaxSpeed=6 %s }\n"
            "  Body %s { Pos=0.3,%g,0.05 Cylinder tyre { Radius=0.05 Length=0.02 HPR=0,0,90 Mass=0.2 Surface=rubber } }\n"
            "  Hinge %sAxle { Parent=%sKnuckle Child=%s Axis=0,1,0 }\n",
            name.c_str(), y, name.c_str(), name.c_str(), name.c_str(), name.c_str(), servo.c_str(), name.c_str(), y, name.c_str(),
            name.c_str(), name.c_str());
        text += knuckle;
    }
    text += wheel("left", 0, 0.12, 0, "rubber") + wheel("right", 0, -0.12, 0, "rubber");
    return experiment(
        text + "  AckermannDrive base { LeftMotor=leftMotor RightMotor=rightMotor LeftSteering=flSteer RightSteering=" + right +
            " WheelRadius=0.05 WheelSeparation=0.24 WheelBase=0.3 SteeringSeparation=0.2 " + more + " }\n",
        "Size=0.4,0.12,0.06 Pos=0.15,0,0.1");
}

void command(SensorWorld& w, const std::string& signal, double value) {
    w.world().block().slots()[w.world().layout().find("r/base/" + signal)->offset] = value;
}

/// The end of a motion in the frame of its start.
PlanePose moved(const PlanePose& from, const PlanePose& to) {
    const double c = std::cos(from.heading), s = std::sin(from.heading), x = to.x - from.x, y = to.y - from.y;
    return {c * x + s * y, c * y - s * x, std::remainder(to.heading - from.heading, 2 * kPi)};
}
PlanePose poseOf(SensorWorld& w, const char* signal = "r/base/pose") {
    return {w.value(signal, 0), w.value(signal, 1), w.value(signal, 2)};
}

void compare(const char* what, const PlanePose& is, const PlanePose& expected, double metres, double radians) {
    const double way = std::hypot(is.x - expected.x, is.y - expected.y);
    const double turn = std::abs(std::remainder(is.heading - expected.heading, 2 * kPi));
    qInfo("%s: %.2f mm and %.3f degrees off", what, way * 1e3, turn * 180 / kPi);
    QVERIFY2(way < metres, what);
    QVERIFY2(turn < radians, what);
}

} // namespace

class SteeredDrivesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Muir and Neuman's solution of a base with mecanum wheels, and that of three omni wheels.
    void kinematicsAreThoseOfTheLiterature() {
        const double r = 0.05, c = std::sqrt(0.5), a = 0.12, b = 0.14;
        const OmniKinematics four(r, {{a, b, c, -c, c}, {a, -b, c, c, c}, {-a, b, c, c, c}, {-a, -b, c, -c, c}});
        QVERIFY(four.isComplete());
        const ChassisMotion v{0.3, 0.7, -0.2};
        const double turn = v.angular * (a + b);
        const double expected[] = {(v.linear - v.lateral - turn) / r, (v.linear + v.lateral + turn) / r,
                                   (v.linear + v.lateral - turn) / r, (v.linear - v.lateral + turn) / r};
        std::vector<double> rates;
        for (std::size_t i = 0; i < 4; ++i) {
            rates.push_back(four.wheelFromChassis(i, v));
            QVERIFY(std::abs(rates[i] - expected[i]) < 1e-12);
        }
        const ChassisMotion back = four.chassisFromWheels(rates);
        QVERIFY(std::abs(back.linear - 0.3) + std::abs(back.angular - 0.7) + std::abs(back.lateral + 0.2) < 1e-12);
        const OmniKinematics three(r, {{0.1, 0, 0, 1, 1}, {-0.1, 0, 0, -1, 1}, {0, 0.1, 0, 1, 1}});
        QVERIFY(!three.isComplete()); // no wheel grips along x
        QVERIFY(!OmniKinematics(r, {{0.1, 0, 1, 0, 1}, {0, 0, 0, 1, 1}, {0, 0, 1, 0, 1}}).isComplete());
        const PlanePose at = four.poseFrom({{1, 2}, {1, 2}, {1, 2}, {1, 2}});
        QCOMPARE(at.x, 1.);
    }

    /// A way in any direction while it turns ends where the arc through both ends; 1 m and a quarter turn.
    void movesInAnyDirection_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("direction");
        QTest::addColumn<double>("turn");
        for (const auto& [name, text] : {std::pair<const char*, std::string>("three omni wheels", omni(3)),
                                         {"four omni wheels", omni(4)},
                                         {"given angles", omni(4, "WheelAngles=0,90,180,270", 0)},
                                         {"pi", omni(3, "Control=pi")},
                                         {"mecanum", mecanum()}})
            for (const double direction : {0., 90., 180., 30., -135.})
                for (const double turn : {0., kPi / 2})
                    QTest::addRow("%s, %g degrees, turning %.2f", name, direction, turn)
                        << QString::fromStdString(text) << direction << turn;
    }
    void movesInAnyDirection() {
        QFETCH(QString, text);
        QFETCH(double, direction);
        QFETCH(double, turn);
        SensorWorld w(text.toStdString());
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(20));
        const PlanePose start = poseOf(w), counted = poseOf(w, "r/base/odometry");
        compare("start", start, {0.1, -0.2, kPi / 6}, 1e-4, 1e-3);
        const double angle = direction * kPi / 180;
        command(w, "linearVelocity", 0.3 * std::cos(angle));
        command(w, "lateralVelocity", 0.3 * std::sin(angle));
        command(w, "linearAmount", 1);
        command(w, "angularVelocity", 0.3 * turn);
        command(w, "angularAmount", turn);
        command(w, "sequence", 1);
        QVERIFY(w.run(800));
        QCOMPARE(w.value("r/base/done"), 1.);
        const PlanePose expected = alongArc({}, {std::cos(angle), turn, std::sin(angle)});
        compare("true", moved(start, poseOf(w)), expected, 0.01, 0.01);
        compare("odometry", moved(counted, poseOf(w, "r/base/odometry")), expected, 0.01, 0.01);
    }

    void turnsOnTheSpot_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("omni") << QString::fromStdString(omni(3));
        QTest::newRow("mecanum") << QString::fromStdString(mecanum());
    }
    void turnsOnTheSpot() {
        QFETCH(QString, text);
        SensorWorld w(text.toStdString());
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(20));
        const PlanePose start = poseOf(w);
        command(w, "angularVelocity", 1.5);
        command(w, "angularAmount", 2 * kPi);
        command(w, "sequence", 1);
        QVERIFY(w.run(1200));
        QCOMPARE(w.value("r/base/done"), 1.);
        compare("true", moved(start, poseOf(w)), {}, 0.005, 0.02);
    }

    /// A change of direction ramps the velocity, it does not stop.
    void followsVelocities() {
        SensorWorld w(omni(3));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "linearVelocity", 0.3);
        QVERIFY(w.run(200));
        const PlanePose first = poseOf(w);
        command(w, "linearVelocity", 0);
        command(w, "lateralVelocity", -0.3);
        QVERIFY(w.run(200));
        const PlanePose way = moved(first, poseOf(w));
        // Both components ramp within sqrt(2) 0.3 m/s / (1 m/s^2).
        const double ramp = std::sqrt(2.) * 0.3;
        compare("turned off", way, {0.3 * ramp / 2, -0.3 * (1 - ramp / 2), 0}, 0.01, 0.01);
    }

    void slipIsTheMotionThatTheWheelsDoNotGive_data() {
        QTest::addColumn<bool>("ice");
        QTest::newRow("on rubber") << false;
        QTest::newRow("on ice") << true;
    }
    /// A base that grips has hardly any; where nothing grips all that the wheels do is slip.
    void slipIsTheMotionThatTheWheelsDoNotGive() {
        QFETCH(bool, ice);
        const auto on = [&](std::string text) {
            const std::string floor = "Plane floor { Surface=rubber }";
            if (ice) text.replace(text.find(floor), floor.size(), "Plane floor { Surface=slick }");
            return text;
        };
        SensorWorld omniWorld(on(omni(4))), carWorld(on(car()));
        QVERIFY2(omniWorld.ok() && carWorld.ok(), (omniWorld.failure() + carWorld.failure()).c_str());
        command(omniWorld, "linearVelocity", 0.2);
        command(omniWorld, "lateralVelocity", -0.3);
        command(omniWorld, "angularVelocity", 0.5);
        command(carWorld, "linearVelocity", 0.4);
        QVERIFY(omniWorld.run(400) && carWorld.run(400));
        const auto isSlip = [&](SensorWorld& w, std::size_t element, double whole) {
            const double slip = w.value("r/base/slip", element), expected = ice ? whole : 0;
            if (std::abs(slip - expected) < 0.03 * std::abs(whole)) return true;
            qWarning("%zu: %.4f, not %.4f", element, slip, expected);
            return false;
        };
        QVERIFY(isSlip(omniWorld, 0, 0.2) && isSlip(omniWorld, 1, -0.3) && isSlip(omniWorld, 2, 0.5));
        QVERIFY(isSlip(carWorld, 0, 0.4) && isSlip(carWorld, 1, 0.4));
    }

    void carDrivesStraightAndArcs_data() {
        QTest::addColumn<double>("steering");
        QTest::addColumn<double>("way");
        QTest::newRow("straight") << 0. << 2.;
        QTest::newRow("back") << 0. << -1.;
        QTest::newRow("left") << 20. << 2.;
        QTest::newRow("right") << -30. << 2.;
        QTest::newRow("backwards to the left") << 25. << -1.;
    }
    /// The radius of the driven axle's middle is WheelBase / tan(steering).
    void carDrivesStraightAndArcs() {
        QFETCH(double, steering);
        QFETCH(double, way);
        SensorWorld w(car());
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "steeringAngle", steering * kPi / 180);
        QVERIFY(w.run(200)); // steers while it rests
        QVERIFY(std::abs(w.value("r/base/steering") - steering * kPi / 180) < 0.002);
        const PlanePose start = poseOf(w), counted = poseOf(w, "r/base/odometry");
        command(w, "linearVelocity", std::copysign(0.5, way));
        command(w, "linearAmount", way);
        command(w, "sequence", 1);
        QVERIFY(w.run(1100));
        QCOMPARE(w.value("r/base/done"), 1.);
        const double curvature = std::tan(steering * kPi / 180) / 0.3;
        const PlanePose expected = alongArc({}, {way, way * curvature, 0});
        compare("true", moved(start, poseOf(w)), expected, 0.01 * std::abs(way), 0.01 * std::max(1., std::abs(way * curvature)));
        compare("odometry", moved(counted, poseOf(w, "r/base/odometry")), expected, 0.01 * std::abs(way),
                0.01 * std::max(1., std::abs(way * curvature)));
    }

    /// The inner wheel is steered more: cot(outer) - cot(inner) = separation / wheel base.
    void innerWheelIsSteeredMore() {
        SensorWorld w(car());
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "steeringAngle", 1); // beyond the limit of 30 degrees
        QVERIFY(w.run(400));
        const double left = w.value("r/flSteer/position"), right = w.value("r/frSteer/position");
        QVERIFY(left > right);
        QVERIFY(std::abs(1 / std::tan(right) - 1 / std::tan(left) - 0.2 / 0.3) < 0.01);
        QVERIFY(std::abs(w.value("r/base/steering") - kPi / 6) < 0.002);
    }

    void isRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << message;
        };
        row("number of angles", omni(4, "WheelAngles=0,90,180"), "4 Motors need as many WheelAngles, not 3");
        row("two directions", omni(3, "WheelAngles=0,180,180"), "leave a motion open");
        row("two wheels", omni(2), "Motors");
        row("twice", mecanum("", "fr"), "the motor frMotor is given twice");
        row("one servo", car("", "flSteer"), "LeftSteering and RightSteering are the same servo");
        row("a speed", car("", "frSteer", "Mode=speed"), "must have Mode=position");
        row("too far", car("MaxSteeringAngle=75"), "between the wheels");
    }
    void isRefused() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        SensorWorld w(text.toStdString());
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains(message), w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(SteeredDrivesTest)
#include "steered_drives_test.moc"
