// Robots that are tried on a plain floor: what the text does not show is found by what the robot does.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

const std::string kMotor = "TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12";

/// Named by what it stands on: `name` its body, `nameAxle`, `nameMotor`.
std::string wheel(const std::string& name, const std::string& at, const std::string& more = {}) {
    return "  Body " + name + " { Pos=" + at + " Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 } }\n  Hinge " +
           name + "Axle { Parent=chassis Child=" + name + " Axis=0,1,0" + more + " }\n  RotaryMotor " + name +
           "Motor { Joint=" + name + "Axle " + kMotor + " }\n";
}

const std::string kRover = "RobotConfig Rover {\n"
                           "  Body chassis { Box hull { Size=0.3,0.2,0.06 Pos=0,0,0.08 Mass=2 } Sphere caster { Radius=0.02 "
                           "Pos=-0.12,0,0.02 Mass=0.05 } }\n" +
                           wheel("left", "0.08,0.13,0.05") + wheel("right", "0.08,-0.13,0.05") +
                           "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 "
                           "WheelSeparation=0.26 }\n}\nRobot r { Config=Rover }\n";

/// Four wheels, of which those in front have no motor but a Gear.
const std::string kGeared =
    "RobotConfig Geared {\n  Body chassis { Box hull { Size=0.3,0.2,0.06 Pos=0,0,0.08 Mass=2 } }\n" +
    wheel("left", "-0.1,0.13,0.05") + wheel("right", "-0.1,-0.13,0.05") +
    "  Body leftFront { Pos=0.1,0.13,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 } }\n"
    "  Body rightFront { Pos=0.1,-0.13,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 } }\n"
    "  Hinge leftRoll { Parent=chassis Child=leftFront Axis=0,1,0 }\n"
    "  Hinge rightRoll { Parent=chassis Child=rightFront Axis=0,1,0 }\n"
    "  Gear leftBelt { Joint=leftRoll Other=leftAxle Ratio=1 }\n"
    "  Gear rightBelt { Joint=rightRoll Other=rightAxle Ratio=1 }\n"
    "  SkidDrive base { LeftMotors=leftMotor RightMotors=rightMotor WheelRadius=0.05 WheelSeparation=0.26 "
    "}\n}\nRobot r { Config=Geared }\n";

std::string sprung(const std::string& name, const std::string& at) {
    return "  Body " + name + " { Pos=" + at + " Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 } }\n  Suspension " +
           name + "Strut { Parent=chassis Child=" + name + " Axis2=0,1,0 Stiffness=$stiffness Damping=40 Travel=0.02 }\n";
}

const std::string kSprung =
    "RobotConfig Sprung {\n  Param stiffness = 1000\n  Body chassis { Box hull { Size=0.3,0.2,0.06 Pos=0,0,0.1 "
    "Mass=2 } }\n" +
    sprung("a", "0.1,0.13,0.05") + sprung("b", "0.1,-0.13,0.05") + sprung("c", "-0.1,0.13,0.05") +
    sprung("d", "-0.1,-0.13,0.05") +
    "  Body mast { Pos=0,0,0.16 Box rod { Size=0.2,0.02,0.02 Pos=0.1,0,0 Mass=0.2 } }\n"
    "  Hinge tilt { Parent=chassis Child=mast Axis=0,1,0 }\n"
    "  Servo lift { Joint=tilt MaxTorque=2 MaxSpeed=3 }\n}\nRobot r { Config=Sprung }\n";

const std::string kCar = "#import robots/car.sim\nRobot r { Config=Car }\n";

} // namespace

class TrialTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

    [[nodiscard]] static Diagnostics tried(const LoadedProject& loaded) {
        Diagnostics found;
        checkModel(loaded, found);
        tryRobots(loaded, found);
        return found;
    }

private Q_SLOTS:
    void robots_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("from"); ///< what is changed
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("said"); ///< empty: nothing
        const auto row = [](const char* name, const std::string& text, const char* from, const char* to, const char* said) {
            QTest::newRow(name) << text << QString(from) << QString(to) << QString(said);
        };
        row("good", kRover, "", "", "");
        row("good, geared", kGeared, "", "", "");
        row("good, sprung", kSprung, "", "", "");
        row("wheel on the other wheel", kRover, "Parent=chassis Child=right ", "Parent=left Child=right ",
            "instead of driving it straight ahead");
        row("wheel on the world", kRover, "Parent=chassis Child=right ", "Parent=world Child=right ", "base of Rover");
        row("wheel with stops", kRover, "Child=right Axis=0,1,0", "Child=right Axis=0,1,0 LowStop=-20 HighStop=20",
            "turns the robot to the right instead of driving it straight ahead");
        row("wheel that is held by friction", kRover, "Child=left Axis=0,1,0", "Child=left Axis=0,1,0 Friction=100",
            "base of Rover");
        row("wheel that touches nothing", kRover, "HPR=0,0,90 Mass=0.2 }", "HPR=0,0,90 Mass=0.2 Collide=false }",
            "base of Rover");
        row("no caster", kRover, "Sphere caster { Radius=0.02", "Sphere caster { Collide=false Radius=0.02", "leans by");
        row("mass in front", kRover, "Body chassis {", "Body chassis { CenterOfMass=0.14,0,0.1", "Rover falls over at rest");
        row("chassis on the world", kRover, "  DifferentialDrive",
            "  Fixed hold { Parent=world Child=chassis }\n  DifferentialDrive",
            "base of Rover does not move the robot when commanded to drive at 161 mm/s");
        row("wheels geared one against the other", kGeared, "leftRoll Other=leftAxle Ratio=1", "leftRoll Other=leftAxle Ratio=-1",
            "Geared");
        row("front wheel twice as fast", kGeared, "leftRoll Other=leftAxle Ratio=1", "leftRoll Other=leftAxle Ratio=2",
            "leftFront rolls at");
        row("front wheel with a brake", kGeared, "  Gear leftBelt { Joint=leftRoll Other=leftAxle Ratio=1 }\n",
            "  Gear leftBelt { Joint=leftRoll Other=leftAxle Ratio=0.01 }\n", "leftFront rolls at");
        row("no springs", kSprung, "stiffness = 1000", "stiffness = 0",
            "rests at its stop, 20 mm from where it starts: its Stiffness, 0 N/m");
        row("soft springs", kSprung, "stiffness = 1000", "stiffness = 50",
            "its Stiffness, 50 N/m, is too low for what it carries");
        row("weak servo", kSprung, "MaxTorque=2", "MaxTorque=0.05",
            "lift of Sprung cannot hold tilt where it starts: it gives way by");
        row("good, car", kCar, "", "", "");
    }
    void robots() {
        QFETCH(const std::string, text);
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        QFETCH(const QString, said);
        QString changed = QString::fromStdString(kThings + text);
        QVERIFY(from.isEmpty() || changed.contains(from));
        if (!from.isEmpty()) changed.replace(changed.indexOf(from), from.size(), to);
        const auto loaded = m_fixture.open(changed.toStdString());
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const Diagnostics found = tried(*loaded);
        const std::string shown = CheckFixture::shown(*loaded, found);
        int reported = 0;
        for (const Diagnostic& d : found.all())
            if (d.code == Code::FailsToStand || d.code == Code::MovesOtherwise || d.code == Code::WeakMotor) {
                ++reported;
                QVERIFY(d.range.known());
            }
        if (said.isEmpty()) QVERIFY2(reported == 0, shown.c_str());
        else QVERIFY2(reported > 0 && QString::fromStdString(shown).contains(said), shown.c_str());
    }

    /// A warning with a cause is not followed by its effect.
    void causesBeforeEffects() {
        std::string text = kThings + kRover;
        text.replace(text.find("Axis=0,1,0"), 10, "Axis=0,-1,0");
        const auto loaded = m_fixture.open(text);
        const Diagnostics found = tried(*loaded);
        QCOMPARE(found.all().size(), std::size_t(1));
        QCOMPARE(found.all()[0].code, Code::WheelGeometry);
    }

    /// One with an Imu may be kept upright by its controller.
    void balancing() {
        std::string text = kThings + kRover;
        text.replace(text.find("Sphere caster"), 13, "Sphere lamp");
        text.replace(text.find("Pos=-0.12,0,0.02"), 16, "Pos=-0.12,0,0.12");
        text.replace(text.find("Body chassis {"), 14, "Body chassis { CenterOfMass=0.08,0,0.09");
        const auto falls = m_fixture.open(text);
        QVERIFY(!tried(*falls).all().empty());
        text.replace(text.find("  DifferentialDrive"), 0, "  Imu imu { Body=chassis }\n");
        const auto loaded = m_fixture.open(text);
        const Diagnostics found = tried(*loaded);
        QVERIFY2(found.all().empty(), CheckFixture::shown(*loaded, found).c_str());
        text.replace(text.find("CenterOfMass=0.08,0,0.09"), 24, "CenterOfMass=0,0,0.09"); // not above its wheels
        QVERIFY(!tried(*m_fixture.open(text)).all().empty());
    }

    /// A stop request ends it; a robot with very many bodies is not tried to the end.
    void ends() {
        const auto loaded = m_fixture.open(kThings + kRover + "Robot s { Config=Rover Pos=1,0,0 }\n");
        std::stop_source stop;
        stop.request_stop();
        Diagnostics found;
        tryRobots(*loaded, found, stop.get_token());
        QVERIFY(found.all().empty());
        std::string slow = kThings + kRover;
        slow.replace(slow.find("Tick = 0.01"), 11, "Tick = 1e-6");
        QVERIFY(tried(*m_fixture.open(slow)).all().empty());
    }
};

QTEST_GUILESS_MAIN(TrialTest)
#include "trial_test.moc"
