// Faults of bodies, joints and settings, each reported once with its cause, beside robots that are right although they look unusual.
#include "check/check_fixture.h"

using namespace fixture;

namespace {

const std::string kWheels = R"(
  Body left { Pos=0.05,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Body right { Pos=0.05,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }
  RotaryMotor rightMotor { Joint=rightAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }
  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }
)";
const std::string kBase = "RobotConfig B {\n"
                          "  Body chassis { Box hull { Pos=0,0,0.08 Size=0.3,0.2,0.06 Mass=2 } Sphere ball { Pos=-0.1,0,0.02 "
                          "Radius=0.02 Mass=0.05 } }" +
                          kWheels;
const std::string kRobot = "}\nRobot r { Config=B }\n";

std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? std::string() : text.replace(at, from.size(), to);
}

/// A chassis on a wheel of a roller's friction, on a ball that no joint holds.
std::string ballRobot() {
    std::string text = "Surface roll { Friction=0.8 Friction2=0 }\nRobotConfig B {\n"
                       "  Body chassis { Cylinder hull { Radius=0.1 Length=0.5 Pos=0,0,0.5 Mass=3 } }\n"
                       "  Body ball { Pos=0,0,0.1 Sphere s { Radius=0.1 Mass=2 } }\n  Imu imu { Body=chassis }\n";
    const char* const places[] = {"0.04596,0.07961", "-0.09192,0", "0.04596,-0.07961"};
    const char* const axes[] = {"-0.35355,-0.61237,0.70711", "0.70711,0,0.70711", "-0.35355,0.61237,0.70711"};
    for (int i = 0; i < 3; ++i) {
        const std::string n = std::to_string(i);
        text += "  Body w" + n + " { Pos=" + places[i] + ",0.19192 HPR=" + std::to_string(60 + 120 * i) +
                ",135,0 Cylinder c { Radius=0.03 Length=0.02 Mass=0.1 Surface=roll } }\n  Hinge a" + n +
                " { Parent=chassis Child=w" + n + " Axis=" + axes[i] + " }\n  RotaryMotor m" + n + " { Joint=a" + n +
                " MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }\n";
    }
    return text + "  OmniDrive base { Motors=m0,m1,m2 WheelRadius=0.03 WheelDistance=0.0919 WheelAngles=60,180,300 }\n";
}

/// Stars of three wheels in place of four wheels: two of each are on the floor.
std::string starRobot() {
    std::string text = "PartConfig Star {\n  Body hub { Cylinder c { Radius=0.03 Length=0.02 HPR=0,0,90 Mass=0.2 } }\n"
                       "  Hinge axle { Parent=$on Child=hub Axis=0,1,0 }\n";
    const char* const places[] = {"0,0,0.1", "-0.0866,0,-0.05", "0.0866,0,-0.05"};
    for (int i = 0; i < 3; ++i) {
        const std::string n = std::to_string(i);
        text += "  Body w" + n + " { Pos=" + places[i] +
                " Cylinder t { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }\n  Hinge h" + n + " { Parent=hub Child=w" + n +
                " Axis=0,1,0 }\n  RotaryMotor m" + n + " { Joint=h" + n +
                " MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }\n";
    }
    return text + R"(}
RobotConfig B {
  Body chassis { Box hull { Pos=0,0,0.2 Size=0.6,0.2,0.1 Mass=8 } }
  Part fl { Config=Star Pos=0.2,0.16,0.1 on=chassis }
  Part bl { Config=Star Pos=-0.2,0.16,0.1 on=chassis }
  Part fr { Config=Star Pos=0.2,-0.16,0.1 on=chassis }
  Part br { Config=Star Pos=-0.2,-0.16,0.1 on=chassis }
  SkidDrive base { LeftMotors=fl.m0,fl.m1,fl.m2,bl.m0,bl.m1,bl.m2 RightMotors=fr.m0,fr.m1,fr.m2,br.m0,br.m1,br.m2
    WheelRadius=0.05 WheelSeparation=0.32 SkidFactor=2 }
)";
}

} // namespace

class CausesTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    void faults_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Code>("code");
        QTest::addColumn<std::string>("said");
        QTest::addColumn<std::string>("place");
        QTest::addColumn<bool>("fix");
        const auto row = [](const char* name, std::string text, Code code, const char* said, const char* place,
                            bool fix = false) {
            QTest::newRow(name) << std::move(text) << code << std::string(said) << std::string(place) << fix;
        };
        row("gravity upwards", "Gravity = 0,0,9.81\n" + kBase + kRobot, Code::Unsupported,
            "Gravity=0,0,9.81 points out of floor: robots fall away from it; Gravity=0,0,-9.81 points into it", "0,0,9.81", true);
        std::string direct = kBase;
        for (int i = 0; i < 2; ++i) direct = changed(direct, " GearRatio=30", "");
        row("motors without their gears", direct + kRobot, Code::WeakMotor,
            "leftMotor of B turns its wheel at up to 600 rad/s: that is 30 m/s, 90.9 times the length of the robot in a second; "
            "a "
            "larger GearRatio, now 1, or a smaller SpeedConstant is more usual",
            "leftMotor");
        const std::string leg = "Cylinder foot { Radius=0.01 Length=0.1 Mass=0.1 } }\n";
        row("two legs in one place",
            "RobotConfig B { Body chassis { Box hull { Pos=0,0,0.12 Size=0.3,0.2,0.04 Mass=1 } }\n  Body one { Pos=0.1,0,0.05 " +
                leg + "  Body two { Pos=0.1,0,0.05 " + leg + "  Body three { Pos=-0.1,0.05,0.05 " + leg +
                "  Body four { Pos=-0.1,-0.05,0.05 " + leg +
                "  Fixed a { Parent=chassis Child=one } Fixed b { Parent=chassis Child=two }\n"
                "  Fixed c { Parent=chassis Child=three } Fixed d { Parent=chassis Child=four }\n" +
                kRobot,
            Code::StartOverlap, "two of B is in the place of one, which has the same shapes; check its Pos and HPR", "two");
        row("two wheels in one place",
            changed(kBase, "Body right { Pos=0.05,-0.15,0.05", "Body right { Pos=0.05,0.15,0.05") + kRobot, Code::StartOverlap,
            "right of B is in the place of left", "right");
        std::string sprung = kBase;
        for (const char* side : {"left", "right"})
            sprung = changed(sprung, std::string("Hinge ") + side + "Axle { Parent=chassis Child=" + side + " Axis=0,1,0",
                             std::string("Suspension ") + side + "Axle { Parent=chassis Child=" + side +
                                 " Axis=0,0,1 Axis2=0,1,0 Stiffness=1500 Damping=0 Travel=0.04");
        row("springs without damping", sprung + kRobot, Code::SpringTooFast,
            "leftAxle of B hardly damps its spring: after a bump the robot keeps swinging at 6.09 Hz; a Damping of 23.5 N s/m, "
            "now 0, calms it",
            "leftAxle");
        std::string towing = sprung + "  Body trailer { Pos=-0.5,0,0.1 Box t { Size=0.3,0.2,0.04 Mass=1 } }\n"
                                      "  Ball hitch { Parent=chassis Child=trailer Anchor=-0.25,0,0.08 }\n";
        for (const char* side : {"l", "r"})
            towing += std::string("  Body ") + side + " { Pos=-0.5," + (*side == 'l' ? "" : "-") +
                      "0.15,0.05 Cylinder t { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n  Suspension " + side +
                      "Leg { Parent=trailer Child=" + side + " Axis=0,0,1 Axis2=0,1,0 Stiffness=1500 Damping=20 Travel=0.04 }\n";
        row("springs without damping, before a trailer on springs", towing + kRobot, Code::SpringTooFast,
            "leftAxle of B hardly damps its spring: after a bump the robot keeps swinging at 6.09 Hz", "leftAxle");
        row("a wheel farther out than its mirror image",
            changed(kBase, "Body right { Pos=0.05,-0.15,0.05", "Body right { Pos=0.05,-0.12,0.05") + kRobot, Code::WheelGeometry,
            "right is 120 mm from the middle of B, left 150 mm, as the WheelSeparation of base has both: check the Pos of right",
            "right");
        row("a caster across its axle",
            changed(kBase, "Sphere ball { Pos=-0.1,0,0.02 Radius=0.02 Mass=0.05 }", "") +
                "  Body caster { Pos=-0.1,0,0.02 Cylinder disc { Radius=0.02 Length=0.01 HPR=0,0,90 Mass=0.05 } }\n"
                "  Hinge roll { Parent=chassis Child=caster Axis=1,0,0 }\n" +
                kRobot,
            Code::WheelGeometry, "roll of B is not along the axis of caster's disc: the wheel does not roll", "roll");
        row("jaws that move the same way",
            kBase +
                "  Body jawLeft { Pos=0.2,0.03,0.08 Box pad { Size=0.08,0.01,0.03 Mass=0.05 } }\n"
                "  Body jawRight { Pos=0.2,-0.03,0.08 Box pad { Size=0.08,0.01,0.03 Mass=0.05 } }\n"
                "  Slider openLeft { Parent=chassis Child=jawLeft Axis=0,1,0 LowStop=-0.02 HighStop=0.02 }\n"
                "  Slider openRight { Parent=chassis Child=jawRight Axis=0,1,0 LowStop=-0.02 HighStop=0.02 }\n"
                "  Gripper hand { Left=openLeft Right=openRight Force=10 }\n" +
                kRobot,
            Code::DeviceSetup,
            "openRight moves its jaw towards the other one at a positive position, at which hand takes it for open; reverse its "
            "Axis",
            "openRight");
        const std::string mast = "  Body mast { Pos=0,0,0.2 Box b { Size=0.04,0.04,0.1 Mass=0.5 } }\n";
        row("a lift that does not lift",
            kBase + mast +
                "  Slider rail { Parent=chassis Child=mast Axis=0,0,1 LowStop=0 HighStop=0.1 }\n"
                "  LinearMotor lift { Joint=rail MaxForce=3 MaxSpeed=0.1 }\n" +
                kRobot,
            Code::WeakMotor, "lift of B cannot lift what is on rail: that weighs 4.91 N along its axis, MaxForce is 3 N", "lift");
        row("a servo that holds its arm upright only",
            kBase + mast +
                "  Hinge tip { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,0.15 LowStop=-90 HighStop=30 }\n"
                "  Servo arm { Joint=tip MaxTorque=0.2 MaxSpeed=3 }\n" +
                kRobot,
            Code::WeakMotor,
            "arm of B cannot hold tip everywhere: at -90 degrees what hangs on it takes 0.245 N m, MaxTorque is 0.2 N m", "arm");
        row("a lift of a robot that stands on its back",
            "RobotConfig B {\n  Body base { Box b { Size=0.4,0.4,0.4 Mass=20 } }\n"
            "  Body mast { Pos=0.25,0,0 Box b { Size=0.1,0.1,0.1 Mass=0.5 } }\n"
            "  Slider rail { Parent=base Child=mast Axis=1,0,0 LowStop=0 HighStop=0.1 }\n"
            "  LinearMotor lift { Joint=rail MaxForce=3 MaxSpeed=0.1 }\n}\nRobot r { Config=B Pos=0,0,0.2 HPR=0,-90,0 }\n",
            Code::WeakMotor, "lift of B cannot lift what is on rail: that weighs 4.91 N along its axis, MaxForce is 3 N", "lift");
        row("a lift of the second robot, which stands on its back",
            "RobotConfig B {\n  Body base { Box b { Size=0.4,0.4,0.4 Mass=20 } }\n"
            "  Body mast { Pos=0.25,0,0 Box b { Size=0.1,0.1,0.1 Mass=0.5 } }\n"
            "  Slider rail { Parent=base Child=mast Axis=1,0,0 LowStop=0 HighStop=0.1 }\n"
            "  LinearMotor lift { Joint=rail MaxForce=3 MaxSpeed=0.1 }\n}\nRobot first { Config=B Pos=0,3,0.2 }\n"
            "Robot r { Config=B Pos=0,0,0.2 HPR=0,-90,0 }\n",
            Code::WeakMotor, "lift of B cannot lift what is on rail: that weighs 4.91 N along its axis, MaxForce is 3 N", "lift");
        row("a lift on a mast that is lighter than what it lifts",
            "RobotConfig B {\n  Body mast { Box b { Size=0.05,0.05,1 Pos=0,0,0.6 Mass=1 } }\n"
            "  Body car { Pos=0.2,0,0.5 Box b { Size=0.2,0.2,0.2 Mass=5 } }\n  Fixed f { Parent=world Child=mast }\n"
            "  Slider rail { Parent=mast Child=car Axis=0,0,1 LowStop=0 HighStop=0.1 }\n"
            "  LinearMotor lift { Joint=rail MaxForce=20 MaxSpeed=0.1 }\n}\nRobot r { Config=B }\n",
            Code::WeakMotor, "lift of B cannot lift what is on rail: that weighs 49.1 N along its axis, MaxForce is 20 N",
            "lift");
        row("an inertia of the second robot alone",
            "Robot first { Config=Crate Pos=3,0,0.1 }\nRobot r { Config=Crate Pos=0,0,0.1 b.Inertia=9,9,9 }\n", Code::OddInertia,
            "the inertia of b in Crate about X is 9 kg m^2, more than its mass can have inside its shapes", "b", true);
        for (const char* thin : {"Box foil { Size=0.005,2,0.5", "Box foil { Size=2,2,0.005",
                                 "Cylinder foil { Radius=0.3 Length=0.005", "Cylinder foil { Radius=0.0025 Length=0.5",
                                 "Capsule foil { Radius=0.0025 Length=0.5", "Sphere foil { Radius=0.0025"})
            row(thin, kBase + kRobot + "StaticConfig W { " + thin + " Pos=3,0,0.5 } }\nStatic wall { Config=W }\n",
                Code::ThinPart, "wall/foil is 5 mm thick, and B gets 10 mm far in a tick", "foil", true);
        row("tracks in the air",
            "RobotConfig B { Body hull { Box deck { Pos=0,0,0.06 Size=0.4,0.2,0.12 Mass=6 }\n"
            "  Box onLeft { Pos=0,0.14,0.06 Size=0.4,0.06,0.08 Mass=1 } Box onRight { Pos=0,-0.14,0.06 Size=0.4,0.06,0.08 Mass=1 "
            "} }\n"
            "  Track left { Geom=hull.onLeft MaxSpeed=0.5 } Track right { Geom=hull.onRight MaxSpeed=0.5 }\n"
            "  TrackDrive base { LeftTrack=left RightTrack=right TrackSeparation=0.28 SkidFactor=3 }\n" +
                kRobot,
            Code::WheelOffGround, "left of B is 20 mm above the ground when deck touches it: it moves in the air", "left");
    }
    void faults() {
        QFETCH(std::string, text);
        QFETCH(Code, code);
        QFETCH(std::string, said);
        QFETCH(std::string, place);
        QFETCH(bool, fix);
        QVERIFY(!text.empty());
        const auto loaded = m_fixture.open(kThings + text);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(!loaded->diagnostics.hasErrors() && found.all().size() == 1, story.c_str());
        const Diagnostic& d = found.all()[0];
        QVERIFY2(d.message.find(said) != std::string::npos, story.c_str());
        QCOMPARE(d.code, code);
        QCOMPARE(loaded->sources.slice(d.range), std::string_view(place));
        QVERIFY2(fix == !d.fixes.empty(), story.c_str());
        if (!fix) return;
        const auto again = m_fixture.open(CheckFixture::applied(*loaded, d.fixes[0]));
        const Diagnostics after = CheckFixture::check(*again);
        QVERIFY2(after.all().empty(), CheckFixture::shown(*again, after).c_str());
    }

    /// The shortest way out of a block of 1 m is down, through the floor: the fix goes to the nearest side.
    void insideAMeshNearItsBottom() {
        const auto loaded = m_fixture.open(kThings + "StaticConfig Block { Mesh m { File=block.obj Scale=10 } }\n"
                                                     "Static block { Config=Block }\nRobot a { Config=Crate Pos=0.1,0,0.102 }\n");
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(found.all().size() == 1 && found.all()[0].code == Code::StartOverlap, story.c_str());
        QVERIFY2(found.all()[0].fixes.size() == 1, story.c_str());
        const auto again = m_fixture.open(CheckFixture::applied(*loaded, found.all()[0].fixes[0]));
        QVERIFY(again && again->experiment->robots.size() == 1);
        const Vec3 place = again->experiment->robots[0].pose.position;
        QVERIFY2(place.x() > 0.6 - 1e-6 && place.z() > 0.1, qPrintable(QString("%1 %2").arg(place.x()).arg(place.z())));
    }

    /// A track is as high as the lowest of its geoms, whichever is written first.
    void tracksOfTwoGeomsInTheAir_data() {
        QTest::addColumn<std::string>("geoms");
        const std::string low = "  Box low { Pos=0,0.14,0.06 Size=0.4,0.06,0.08 Mass=1 }\n";
        const std::string high = "  Box high { Pos=0,0.14,0.13 Size=0.3,0.06,0.04 Mass=0.2 }\n";
        QTest::newRow("the lower first") << low + high;
        QTest::newRow("the higher first") << high + low;
    }
    void tracksOfTwoGeomsInTheAir() {
        QFETCH(std::string, geoms);
        const auto loaded = m_fixture.open(
            kThings + "RobotConfig B { Body hull { Box deck { Pos=0,0,0.06 Size=0.4,0.2,0.12 Mass=6 }\n" + geoms +
            "  Box onRight { Pos=0,-0.14,0.06 Size=0.4,0.06,0.08 Mass=1 } }\n"
            "  Track left { Geom=hull.low,hull.high MaxSpeed=0.5 } Track right { Geom=hull.onRight MaxSpeed=0.5 }\n"
            "  TrackDrive base { LeftTrack=left RightTrack=right TrackSeparation=0.28 SkidFactor=3 }\n" +
            kRobot);
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QVERIFY2(!loaded->diagnostics.hasErrors() && found.all().size() == 1, story.c_str());
        QCOMPARE(found.all()[0].code, Code::WheelOffGround);
        QVERIFY2(found.all()[0].message.starts_with("left of B is 20 mm above the ground when deck touches it"), story.c_str());
    }

    /// Bodies in the air at the same place of two files are two findings.
    void bodiesOfTwoFilesInTheAir() {
        const auto folder = std::filesystem::path(m_fixture.folder.path().toStdString()) / "configs";
        std::filesystem::create_directories(folder);
        for (const char* name : {"K", "L"})
            std::ofstream(folder / (std::string(name) + ".sim"))
                << "PartConfig " << name << " { Body b { Box x { Size=0.1,0.1,0.1 Mass=1 } } }\n";
        const auto loaded = m_fixture.open("#import K.sim\n#import L.sim\n" + kThings +
                                           "RobotConfig R { Body a { Box x { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                           "  Part k { Config=K Pos=1,0,2 } Part l { Config=L Pos=2,0,3 } }\n"
                                           "Robot r { Config=R Pos=0,0,0.05 }\n");
        QVERIFY(loaded);
        const std::string story = CheckFixture::shown(*loaded, CheckFixture::check(*loaded));
        for (const char* body :
             {"r/k.b, which no joint holds, starts 2 m above", "r/l.b, which no joint holds, starts 3 m above"})
            QVERIFY2(story.find(body) != std::string::npos, story.c_str());
    }

    void unusualRobots_data() {
        QTest::addColumn<std::string>("text");
        QTest::newRow("on a ball") << ballRobot() + kRobot;
        QTest::newRow("on stars of wheels") << starRobot() + kRobot;
        QTest::newRow("hung from a spring") << std::string(
            "RobotConfig Lamp { Body b { Box b { Size=0.1,0.1,0.1 Mass=1 } }\n"
            "  Spring cord { Parent=world Child=b Anchor=0,0,1 Anchor2=0,0,0.05 Stiffness=100 Damping=5 } }\n"
            "Robot lamp { Config=Lamp Pos=0,0,1 }\n");
        QTest::newRow("no floor, and gravity upwards")
            << std::string("Gravity = 0,0,9.81\nStaticConfig Roof { Box b { Size=9,9,0.1 Pos=0,0,0.3 } }\n"
                           "Static roof { Config=Roof }\n");
    }
    void unusualRobots() {
        QFETCH(std::string, text);
        const bool isWithoutFloor = text.find("Roof") != std::string::npos;
        const auto loaded = m_fixture.open((isWithoutFloor ? std::string() : kThings) + text);
        QVERIFY(loaded);
        Diagnostics found = CheckFixture::check(*loaded);
        tryRobots(*loaded, found);
        QVERIFY2(found.all().empty() && !loaded->diagnostics.hasErrors(), CheckFixture::shown(*loaded, found).c_str());
    }
};

QTEST_APPLESS_MAIN(CausesTest)
#include "causes_test.moc"
