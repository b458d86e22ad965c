// Faults that a person makes in a robot that is right otherwise: wheels of other sizes and heights, no joints, motors that something holds back,
// a robot that is turned over, joints between robots in a ring, definitions of a model that nothing uses.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

const std::string kMotor = "MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }\n";
const std::string kTyre = "Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n";
const std::string kBase =
    "RobotConfig B {\n"
    "  Body chassis { Box hull { Pos=0,0,0.08 Size=0.3,0.2,0.06 Mass=2 } Sphere ball { Pos=-0.1,0,0.02 "
    "Radius=0.02 Mass=0.05 } }\n"
    "  Body left { Pos=0.05,0.15,0.05 " +
    kTyre + "  Body right { Pos=0.05,-0.15,0.05 " + kTyre +
    "  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }\n"
    "  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }\n"
    "  RotaryMotor leftMotor { Joint=leftAxle " +
    kMotor + "  RotaryMotor rightMotor { Joint=rightAxle " + kMotor +
    "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }\n";
const std::string kRobot = "}\nRobot r { Config=B }\n";

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? std::string() : text.replace(at, from.size(), to);
}
/// Both motors.
std::string held(const std::string& more) {
    return changed(changed(kBase, "Joint=leftAxle", "Joint=leftAxle " + more), "Joint=rightAxle", "Joint=rightAxle " + more);
}

/// Four wheels, of which one is at `height`.
std::string skidSteer(const std::string& height) {
    std::string text = "RobotConfig B {\n  Body chassis { Box hull { Pos=0,0,0.1 Size=0.4,0.2,0.06 Mass=4 } }\n";
    const char* const names[] = {"fl", "fr", "bl", "br"};
    for (int i = 0; i < 4; ++i) {
        const std::string n = names[i], place = std::string(i < 2 ? "0.12," : "-0.12,") + (i % 2 == 0 ? "0.15," : "-0.15,");
        text += "  Body " + n + " { Pos=" + place + (i == 3 ? height : "0.05") + " " + kTyre + "  Hinge a" + n +
                " { Parent=chassis Child=" + n + " Axis=0,1,0 }\n  RotaryMotor m" + n + " { Joint=a" + n + " " + kMotor;
    }
    return text +
           "  SkidDrive base { LeftMotors=mfl,mbl RightMotors=mfr,mbr WheelRadius=0.05 WheelSeparation=0.3 SkidFactor=1.5 }\n";
}

/// Wheels on struts that slide along an axis.
std::string onStruts(const std::string& axis) {
    std::string text = "RobotConfig B {\n  Body chassis { Box hull { Pos=0,0,0.1 Size=0.4,0.2,0.06 Mass=2 } }\n";
    const char* const places[] = {"0.12,0.15,0.05", "0.12,-0.15,0.05", "-0.12,0.15,0.05", "-0.12,-0.15,0.05"};
    for (int i = 0; i < 4; ++i) {
        const std::string n = std::to_string(i);
        text +=
            "  Body knuckle" + n + " { Pos=" + places[i] +
            " Box b { Size=0.02,0.02,0.02 Mass=0.1 Collide=false } }\n  Slider strut" + n + " { Parent=chassis Child=knuckle" +
            n + axis + " Stiffness=3000 Damping=90 RestPosition=-0.002 LowStop=-0.02 HighStop=0.02 }\n  Body w" + n +
            " { Pos=" + places[i] + " " + kTyre + "  Hinge a" + n + " { Parent=knuckle" + n + " Child=w" + n + " Axis=0,1,0 }\n";
    }
    return text;
}

const std::string kHull = "RobotConfig %1 { Body b { Box s { Size=0.2,0.2,0.1 Mass=1 } } }\nRobot %2 { Config=%1 Pos=%3,0.05 }\n";
std::string boxRobot(const char* config, const char* name, const char* place) {
    return QString::fromStdString(kHull).arg(config, name, place).toStdString();
}

} // namespace

class FaultsTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void faults_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Code>("code");
        QTest::addColumn<std::string>("said"); // empty: nothing is found
        QTest::addColumn<std::string>("place");
        const auto row = [](const char* name, std::string text, Code code, const char* said, const char* place) {
            QTest::newRow(name) << std::move(text) << code << std::string(said) << std::string(place);
        };
        const auto right = [](const char* name, std::string text) {
            QTest::newRow(name) << std::move(text) << Code::WheelGeometry << std::string() << std::string();
        };
        right("a robot that is right", kBase + kRobot);
        row("a smaller wheel on one side",
            changed(kBase, "right { Pos=0.05,-0.15,0.05 Cylinder tyre { Radius=0.05",
                    "right { Pos=0.05,-0.15,0.04 Cylinder tyre { Radius=0.04") +
                kRobot,
            Code::WheelGeometry, "right has a radius of 40 mm, and the WheelRadius of base is 50 mm for all its wheels", "right");
        right("four wheels", skidSteer("0.05") + kRobot);
        right("one of four wheels hardly higher", skidSteer("0.052") + kRobot);
        row("one of four wheels in the air", skidSteer("0.055") + kRobot, Code::WheelOffGround,
            "br of B is 5 mm above the ground when fl touches it: its motor turns it in the air", "br");
        std::string trailer = "RobotConfig B { Body frame { Box deck { Pos=0,0,0.1 Size=0.3,0.2,0.04 Mass=1 } Sphere nose { "
                              "Pos=0.1,0,0.04 Radius=0.04 Mass=0.1 } }\n"
                              "  Body wheel { Pos=-0.1,0,0.05 " +
                              kTyre;
        row("a wheel without any joint", trailer + kRobot, Code::LooseBody, "wheel of B is held by no joint", "wheel");
        right("loose things that are no robot", "RobotConfig Pins { Body a { Pos=0,0,0.05 Cylinder p { Radius=0.02 Length=0.1 "
                                                "Mass=0.1 } } Body b { Pos=0.1,0,0.05 Cylinder p { "
                                                "Radius=0.02 Length=0.1 Mass=0.1 } } }\nRobot pins { Config=Pins }\n");
        row("a CurrentLimit that holds the motors back", held("CurrentLimit=0.05") + kRobot, Code::WeakMotor,
            "what holds them back is their CurrentLimit of 0.05 A", "leftMotor");
        right("a CurrentLimit that is enough", held("CurrentLimit=1") + kRobot);
        row("a CurrentLimit of the second robot that holds its motors back",
            held("CurrentLimit=1") + kRobot +
                "Robot second { Config=B Pos=0,2,0 leftMotor.CurrentLimit=0.05 rightMotor.CurrentLimit=0.05 }\n",
            Code::WeakMotor, "what holds them back is their CurrentLimit of 0.05 A", "leftMotor");
        row("a FrictionTorque that holds the motors back", held("FrictionTorque=0.1195") + kRobot, Code::WeakMotor,
            "what holds them back is their FrictionTorque of 0.119 N m", "leftMotor");
        row("a battery that is too weak", kBase + "  Battery cell { Voltage=0.1 Capacity=1 }\n" + kRobot, Code::WeakMotor,
            "what holds them back is the battery, which gives 0.1 V at stall", "leftMotor");
        row("a battery with too much resistance",
            kBase + "  Battery cell { Cells=10 Capacity=1 InternalResistance=200 }\n" + kRobot, Code::WeakMotor,
            "what holds them back is the battery, which gives 0.0597 V at stall", "leftMotor");
        right("a battery that is enough", kBase + "  Battery cell { Cells=10 Capacity=1 InternalResistance=0.1 }\n" + kRobot);
        right("struts that spring upwards", onStruts("") + kRobot);
        row("struts that slide ahead", onStruts(" Axis=1,0,0") + kRobot, Code::BadJoint,
            "strut0 of B has a spring and carries a wheel, but slides along the ground", "strut0");
        row("on its side", kBase + "}\nRobot r { Config=B Pos=0,0,0.2 HPR=0,0,90 }\n", Code::WheelOffGround,
            "r lies on its side: the axles of its wheels are upright; check its HPR", "r");
        row("with its ball on a pole",
            kBase + "}\nStaticConfig Pole { Box b { Size=0.06,0.06,0.5 Pos=-0.1,0,0.25 } }\nStatic pole { Config=Pole }\n"
                    "Robot r { Config=B Pos=0,0,0.5 }\n",
            Code::WheelOffGround,
            "r is placed over an edge: the ground below left is 500 mm lower than elsewhere below it; check its Pos", "r");
        row("upside down", kBase + "}\nRobot r { Config=B Pos=0,0,0.111 HPR=0,0,180 }\n", Code::WheelOffGround,
            "r is upside down: its wheels are above; check its HPR", "r");
        row("Parent and Child swapped",
            changed(kBase, "leftAxle { Parent=chassis Child=left", "leftAxle { Parent=left Child=chassis") + kRobot,
            Code::WheelGeometry, "it is at the origin of its Child, chassis: swap its Parent and Child", "leftAxle");
        const std::string ring = boxRobot("One", "a", "0,0") + boxRobot("Two", "b", "0.21,0") + boxRobot("Three", "c", "0.42,0");
        right(
            "robots in a row",
            ring +
                "Ball one { Parent=a.b Child=b.b Anchor=0.105,0,0.05 }\nBall two { Parent=b.b Child=c.b Anchor=0.315,0,0.05 }\n");
        row("robots in a ring",
            ring +
                "Ball one { Parent=a.b Child=b.b Anchor=0.105,0,0.05 }\nBall two { Parent=b.b Child=c.b Anchor=0.315,0,0.05 }\n"
                "Fixed three { Parent=a.b Child=c.b }\n",
            Code::ClosedLoop, "three closes a loop of joints: other joints connect what it joins already", "three");
        row("a tilted floor that is too steep",
            changed(
                held("CurrentLimit=0.5") + kRobot, "Robot r { Config=B }",
                "StaticConfig Hill { Plane p { } }\nStatic hill { Config=Hill Pos=-50,0,-30 HPR=0,35,0 }\nRobot r { Config=B }"),
            Code::WeakMotor, "a slope of 35 degrees, that of hill/p, needs", "leftMotor");
    }
    void faults() {
        QFETCH(std::string, text);
        QFETCH(Code, code);
        QFETCH(std::string, said);
        QFETCH(std::string, place);
        QVERIFY(!text.empty());
        const auto loaded = m_fixture.open(kThings + text);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(!loaded->diagnostics.hasErrors() && found.all().size() == (said.empty() ? 0u : 1u),
                 (story + CheckFixture::shown(*loaded, loaded->diagnostics)).c_str());
        if (said.empty()) return;
        const Diagnostic& d = found.all()[0];
        QVERIFY2(d.message.find(said) != std::string::npos, story.c_str());
        QCOMPARE(d.code, code);
        QCOMPARE(loaded->sources.slice(d.range), std::string_view(place));
    }

    /// What trying the robot finds has its cause.
    void trials_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("said");
        QTest::newRow("fixed to the world") << kBase + "  Fixed foot { Parent=world Child=chassis }\n" + kRobot
                                            << std::string("foot fixes chassis to the world");
        std::string bare = kBase;
        for (int i = 0; i < 2; ++i) bare = changed(bare, "Mass=0.2 HPR=0,0,90 }", "Mass=0.2 HPR=0,0,90 Surface=oil }");
        QTest::newRow("slick tyres") << "Surface oil { Friction=0.01 }\n" + bare + kRobot
                                     << std::string("the Surface of left has hardly any Friction");
    }
    void trials() {
        QFETCH(std::string, text);
        QFETCH(std::string, said);
        const auto loaded = m_fixture.open(kThings + text);
        QVERIFY(loaded);
        Diagnostics found = CheckFixture::check(*loaded);
        tryRobots(*loaded, found);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(std::ranges::any_of(found.all(), [&](const Diagnostic& d) { return d.message.find(said) != std::string::npos; }),
                 story.c_str());
    }
};

QTEST_APPLESS_MAIN(FaultsTest)
#include "faults_test.moc"
