// Drives with several wheels on each side: as a DifferentialDrive with one, straight and turning with four, refusals.
#include "sensor_world.h"

#include <numbers>

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi;

std::string wheel(const std::string& name, double x, double y) {
    char text[700];
    std::snprintf(
        text, sizeof text,
        "  Body %s { Pos=%g,%g,0.05 Cylinder tyre { Radius=0.05 Length=0.02 HPR=0,0,90 Mass=0.2 Surface=rubber } }\n"
        "  Hinge %sAxle { Parent=hull Child=%s Axis=0,1,0 }\n"
        "  RotaryMotor %sMotor { Joint=%sAxle TorqueConstant=0.03 SpeedConstant=33 Resistance=1 GearRatio=30 MaxVoltage=12 }\n",
        name.c_str(), x, y, name.c_str(), name.c_str(), name.c_str(), name.c_str());
    return text;
}

/// A base with wheels at the given x, 0.3 m apart.
std::string base(const std::vector<double>& at, const std::string& drive, const std::string& slider = "") {
    std::string text =
        "Tick=0.005\nSurface rubber { Friction=0.8 }\nSurface slick { Friction=0 }\n"
        "StaticConfig Floor { Plane floor { Surface=rubber } }\nStatic floor { Config=Floor }\nRobotConfig Base {\n"
        "  Body hull { Box box { Size=0.3,0.2,0.06 Pos=0,0,0.08 Mass=3 Surface=slick } " +
        slider + " }\n";
    for (std::size_t i = 0; i < at.size(); ++i) {
        text += wheel("left" + std::to_string(i), at[i], 0.15);
        text += wheel("right" + std::to_string(i), at[i], -0.15);
    }
    return text + "  " + drive + "\n}\nRobot r { Config=Base }\n";
}

void command(SensorWorld& w, const char* signal, double value) {
    w.world().block().slots()[w.world().layout().find(std::string("r/base/") + signal)->offset] = value;
}

const std::string kFour =
    "SkidDrive base { LeftMotors=left0Motor,left1Motor RightMotors=right0Motor,right1Motor WheelRadius=0.05 WheelSeparation=0.3 ";

} // namespace

class SkidDriveTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Wheels that roll do not slip; on the spot against a wall they slip by all of their speed.
    void slipIsWhatWheelsRollTooFast() {
        const std::string drive = "DifferentialDrive base { LeftMotor=left0Motor RightMotor=right0Motor WheelRadius=0.05 WheelSeparation=0.3 }",
                          slider = "Sphere foot { Radius=0.02 Pos=-0.12,0,0.02 Mass=0.1 Surface=slick }",
                          wall = "StaticConfig Wall { Box wall { Size=0.2,2,0.4 Surface=slick } }\nStatic wall { Config=Wall Pos=0.9,0,0.2 }\n";
        SensorWorld w(base({0}, drive, slider) + wall);
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "linearVelocity", 0.4);
        command(w, "angularVelocity", 0.05);
        QVERIFY(w.run(200));
        QVERIFY(std::abs(w.value("r/base/slip", 0)) < 1e-3 && std::abs(w.value("r/base/slip", 1)) < 1e-3);
        command(w, "angularVelocity", 0);
        QVERIFY(w.run(1000));
        for (const char* side : {"left0", "right0"}) {
            const double rolls = 0.05 * w.value(std::string("r/") + side + "Motor/rate");
            QVERIFY(rolls > 0.1);
            QVERIFY(std::abs(w.value("r/base/slip", side[0] == 'l' ? 0 : 1) - rolls) < 0.02 * rolls);
        }
    }

    void withOneWheelOnEachSideItIsADifferentialDrive() {
        const std::string sizes = "WheelRadius=0.05 WheelSeparation=0.3 }",
                          slider = "Sphere foot { Radius=0.02 Pos=-0.12,0,0.02 Mass=0.1 Surface=slick }";
        SensorWorld one(base({0}, "DifferentialDrive base { LeftMotor=left0Motor RightMotor=right0Motor " + sizes, slider));
        SensorWorld other(base({0}, "SkidDrive base { LeftMotors=left0Motor RightMotors=right0Motor " + sizes, slider));
        QVERIFY2(one.ok() && other.ok(), (one.failure() + other.failure()).c_str());
        for (SensorWorld* w : {&one, &other}) {
            command(*w, "linearVelocity", 0.4);
            command(*w, "angularVelocity", 0.6);
            QVERIFY(w->run(400));
        }
        QCOMPARE(one.world().stateHash(), other.world().stateHash());
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(one.value("r/base/odometry", i), other.value("r/base/odometry", i));
            QCOMPARE(one.value("r/base/pose", i), other.value("r/base/pose", i));
        }
    }

    void fourWheelsDriveStraight() {
        SensorWorld w(base({0.1, -0.1}, kFour + "}"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(std::abs(w.value("r/base/pose", 0)) < 1e-9 && std::abs(w.value("r/base/pose", 1)) < 1e-9);
        command(w, "linearVelocity", 0.5);
        command(w, "linearAmount", 1);
        command(w, "sequence", 1);
        QVERIFY(w.run(800));
        QCOMPARE(w.value("r/base/done"), 1.);
        QVERIFY2(std::abs(w.value("r/base/pose", 0) - 1) < 0.01, qPrintable(QString::number(w.value("r/base/pose", 0))));
        QVERIFY(std::abs(w.value("r/base/pose", 1)) < 1e-3);
        QVERIFY(std::abs(w.value("r/base/odometry", 0) - w.value("r/base/pose", 0)) < 0.01);
    }

    /// Wheels that skid sideways turn it by less; SkidFactor makes up for it, in the odometry too.
    void turnsAsFarAsTheSkidFactorSays() {
        double first = 1;
        for (const bool corrected : {false, true}) {
            SensorWorld w(
                base({0.1, -0.1}, kFour + (corrected ? "SkidFactor=" + std::to_string(1 / first) : std::string()) + " }"));
            QVERIFY2(w.ok(), w.failure().c_str());
            command(w, "angularVelocity", 0.8);
            command(w, "angularAmount", kPi / 2);
            command(w, "sequence", 1);
            QVERIFY(w.run(800));
            QCOMPARE(w.value("r/base/done"), 1.);
            const double turned = w.value("r/base/pose", 2) / (kPi / 2);
            qInfo("turned by %.4f of the angle", turned);
            if (!corrected) {
                QVERIFY(turned > 0.3 && turned < 0.95);
                first = turned;
            } else {
                QVERIFY(std::abs(turned - 1) < 0.03);
                QVERIFY(std::abs(w.value("r/base/odometry", 2) - kPi / 2) < 0.03);
            }
            QVERIFY(std::hypot(w.value("r/base/pose", 0), w.value("r/base/pose", 1)) < 0.02);
        }
    }

    void isRefused_data() {
        QTest::addColumn<QString>("drive");
        QTest::addColumn<QString>("message");
        QTest::newRow("twice on a side") << "LeftMotors=left0Motor,left0Motor RightMotors=right0Motor"
                                         << "left0Motor is given twice";
        QTest::newRow("on both sides") << "LeftMotors=left0Motor RightMotors=right0Motor,left0Motor"
                                       << "left0Motor is given twice";
        QTest::newRow("unknown") << "LeftMotors=left0Motor RightMotors=rigth0Motor"
                                 << "rigth0Motor";
        QTest::newRow("none") << "LeftMotors=left0Motor"
                              << "RightMotors";
    }
    void isRefused() {
        QFETCH(QString, drive);
        QFETCH(QString, message);
        SensorWorld w(base({0.1, -0.1}, "SkidDrive base { " + drive.toStdString() + " WheelRadius=0.05 WheelSeparation=0.3 }"));
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains(message), w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(SkidDriveTest)
#include "skid_drive_test.moc"
