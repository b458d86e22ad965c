// Seeded faults: each is reported with its name and cause, and its fix, where there is one, removes it. Valid models give no warning.
#include <set>

#include "check/check_fixture.h"
#include "flow/cli.h"
#include "project/wizard/robot_text.h"

using namespace fixture;

namespace {

const std::string kRover = R"(
RobotConfig Rover {
  Param wheelRadius = 0.05
  Body chassis { Pos=0,0,0.08 Box hull { Size=0.3,0.2,0.06 Mass=2 } Sphere caster { Pos=-0.12,0,-0.05 Radius=0.03 Mass=0.1 } }
  Body leftWheel { Pos=0.1,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Body rightWheel { Pos=0.1,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Anchor=0.1,0.15,0.05 Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Anchor=0.1,-0.15,0.05 Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  RotaryMotor rightMotor { Joint=rightAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }
}
)";

/// block.obj is a cube of 10 cm whose origin is at the middle of its lower face.
const std::string kMeshes = R"(
RobotConfig Stone { Body b { Convex c { File=block.obj Mass=1 } } }
RobotConfig Beam { Body b { Convex c { File=block.obj Scale=1,1,6 Mass=1 } } }
RobotConfig Crane {
  Body base { Box g { Size=0.3,0.3,0.1 Mass=4 } }
  Body arm { Pos=0.2,0,0.4 HPR=0,90,0 Convex c { Pos=0.05,0,0 File=block.obj Scale=1,1,6 Mass=0.5 } }
  Fixed f { Parent=base Child=arm }
}
RobotConfig Sized { Param s = 0.1 Body b { Box g { Size=$s,$s,$s Mass=1 } } }
StaticConfig Block { Mesh m { File=block.obj Scale=10 } }
)";

std::string rover(const char* from, const char* to) {
    return QString::fromStdString(kRover).replace(from, to).toStdString() + "Robot r { Config=Rover }\n";
}

} // namespace

class ModelCheckTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

private Q_SLOTS:
    /// One hint, however many robots fall, and a floor as its fix.
    void missesTheFloor() {
        const std::string things = kThings.substr(kThings.find("RobotConfig"));
        const auto loaded = m_fixture.open(things + "Robot a { Config=Crate Pos=0,0,0.1 }\nRobot b { Config=Ball Pos=1,0,0.1 }\n"
                                                    "Grid g { Config=Crate Pos=0,3,0.1 Count=2,2 Spacing=1 }\n");
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        QCOMPARE(found.all().size(), std::size_t(1));
        const Diagnostic& d = found.all()[0];
        QCOMPARE(d.code, Code::Unsupported);
        QCOMPARE(d.severity, Severity::Hint);
        QVERIFY2(d.message.find("no scenery: a and 5 more fall") != std::string::npos, d.message.c_str());
        QCOMPARE(d.fixes.size(), std::size_t(1));
        const auto fixed = m_fixture.open(CheckFixture::applied(*loaded, d.fixes[0]));
        QVERIFY(fixed && !fixed->diagnostics.hasErrors());
        QCOMPARE(CheckFixture::shown(*fixed, CheckFixture::check(*fixed)), std::string());
        const auto held = m_fixture.open("RobotConfig Arm { Body b { Box hull { Size=0.2,0.2,0.2 Mass=1 } } "
                                         "Hinge h { Parent=world Child=b } }\nRobot a { Config=Arm }\n");
        QVERIFY(held);
        QCOMPARE(CheckFixture::shown(*held, CheckFixture::check(*held)), std::string());
    }

    void faults_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("said");  // text that the message contains
        QTest::addColumn<QString>("place"); // text of the source range
        QTest::addColumn<bool>("fix");
        const auto row = [](const char* name, const std::string& text, Code code, const char* said, const char* place, bool fix) {
            QTest::newRow(name) << QString::fromStdString(kThings + text) << static_cast<int>(code) << said << place << fix;
        };
        const Code in = Code::StartOverlap, below = Code::BelowFloor, air = Code::Unsupported;
        row("half in the floor", "Robot a { Config=Crate Pos=0,0,0.05 }", in, "50 mm deep", "a", true);
        row("without a place", "Robot a { Config=Ball }", in, "floor/ground", "a", true);
        row("turned, a corner in the floor", "Robot a { Config=Crate Pos=0,0,0.1 HPR=10,20,45 }", in, "a/b/hull", "a", true);
        row("an offset shape in the floor", "Robot a { Config=Pill Pos=1,2,-0.08 }", in, "a/b/c", "a", true);
        row("wholly below a plane", "Robot a { Config=Crate Pos=0,0,-3 }", below, "3.1 m deep", "a", true);
        row("a post below a plane", "Robot a { Config=Post Pos=0,0,-1 }", below, "below floor/ground", "a", true);
        row("two in one place", "Robot a { Config=Crate Pos=0,0,0.1 }\nRobot b { Config=Crate Pos=0.05,0,0.1 }", in,
            "inside a/b/hull", "b", true);
        row("the later one in the text moves", "Robot z { Config=Ball Pos=0,0,0.1 }\nRobot a { Config=Crate Pos=0.12,0,0.1 }", in,
            "inside z/b/s", "a", true);
        row("in a turned wall",
            "StaticConfig W { Box w { Size=2,0.1,1 Pos=0,0.5,0.5 } }\nStatic wall { Config=W Pos=1,0,0 HPR=30,0,0 }\n"
            "Robot a { Config=Crate Pos=0.8,0.4,0.1 }",
            in, "wall/w", "a", true);
        row("deep in a turned wall, nearest way out through the floor",
            "StaticConfig W { Box w { Size=2,0.5,1 Pos=0,0,0.5 } }\nStatic wall { Config=W HPR=30,0,0 }\n"
            "Robot a { Config=Crate Pos=0.1,0.1,0.1 HPR=77,0,0 }",
            in, "wall/w", "a", true);
        row("in a wall, a little above the floor",
            "StaticConfig W { Box w { Size=2,0.5,1 Pos=0,0,0.5 } }\nStatic wall { Config=W }\n"
            "Robot a { Config=Crate Pos=0.1,0.05,0.101 }",
            in, "wall/w", "a", true);
        row("in a capsule",
            "StaticConfig W { Capsule w { Radius=0.2 Length=1 Pos=0,0,0.7 } }\nStatic pole { Config=W }\n"
            "Robot a { Config=Ball Pos=0.25,0,0.1 }",
            in, "pole/w", "a", true);
        row("in a corner of two walls",
            "StaticConfig W { Box x { Size=0.1,4,1 Pos=1,0,0.5 } Box y { Size=4,0.1,1 Pos=0,1,0.5 } }\n"
            "Static walls { Config=W }\nRobot a { Config=Crate Pos=0.9,0.9,0.1 }",
            in, "walls/", "a", true);
        row("a grid in the floor", "Grid g { Config=Crate Count=3,3 Spacing=1 Pos=0,0,0 }", in, "and 8 more", "g", true);
        row("a grid too narrow", "Grid g { Config=Crate Count=3,1 Spacing=0.1 Pos=0,0,0.1 }", in, "g_", "g", false);
        row("a place from a Param", "Param h = 0.02\nRobot a { Config=Crate Pos=0,0,$h }", in, "80 mm", "a", true);
        row("a place in centimetres", "Robot a { Config=Crate Pos=0,0,5 cm }", in, "50 mm", "a", true);
        row("a place from a formula", "Robot a { Config=Crate Pos=1,1,$(0.1/2) }", in, "50 mm", "a", true);
        row("a mesh in the floor", kMeshes + "Robot a { Config=Stone Pos=0,0,-0.03 }", in, "30 mm deep", "a", true);
        row("a mesh below the floor", kMeshes + "Robot a { Config=Stone Pos=0,0,-2 }", below, "below floor/ground", "a", true);
        row("a turned mesh in the floor", kMeshes + "Robot a { Config=Beam Pos=0,0,0.02 HPR=30,0,90 }", in, "30 mm deep", "a",
            true);
        row("a mesh made larger by an override", kMeshes + "Robot a { Config=Stone Pos=0,0,-0.1 b.c.Scale=3 }", in, "100 mm deep",
            "a", true);
        row("an instance made larger through its Param", kMeshes + "Robot a { Config=Sized Pos=0,0,0.05 s=0.4 }", in,
            "150 mm deep", "a", true);
        row("a turned arm of a mesh in the floor", kMeshes + "Robot a { Config=Crane Pos=0,0,0.05 HPR=0,60,0 }", in, "a/arm/c",
            "a", true);
        row("in a side of a mesh", kMeshes + "Static block { Config=Block }\nRobot a { Config=Crate Pos=0.58,0,0.1 }", in,
            "block/m", "a", true);
        row("in a turned mesh",
            kMeshes + "Static block { Config=Block Pos=1,0,0 HPR=30,0,0 }\nRobot a { Config=Crate Pos=0.4,0,0.1 }", in, "block/m",
            "a", true);
        row("wholly in a mesh", kMeshes + "Static block { Config=Block }\nRobot a { Config=Crate Pos=0.1,0,0.5 }", in, "block/m",
            "a", true);
        row("a mesh in a mesh", kMeshes + "Static block { Config=Block }\nRobot a { Config=Stone Pos=0.52,0.1,0 }", in, "block/m",
            "a", true);
        row("meshes in each other", kMeshes + "Robot a { Config=Stone }\nRobot b { Config=Stone Pos=0.08,0,0 }", in,
            "inside a/b/c", "b", true);
        row("a mesh in the air", kMeshes + "Robot a { Config=Stone Pos=0,0,1 }", air, "1 m above floor/ground", "a", true);
        row("a turned mesh in the air", kMeshes + "Robot a { Config=Beam Pos=0,0,1 HPR=0,0,90 }", air, "950 mm above", "a", true);
        row("an instance above a mesh", kMeshes + "Static block { Config=Block }\nRobot a { Config=Sized s=0.4 Pos=0,0,1.5 }",
            air, "300 mm above block/m", "a", true);
        row("in the air", "Robot a { Config=Ball Pos=0,0,1.5 }", air, "1.4 m above floor/ground", "a", true);
        row("high in the air", "Robot a { Config=Ball Pos=0,0,2500.1 }", air, "2500 m above floor/ground", "a", true);
        row("a robot with wheels in the air", kRover + "Robot r { Config=Rover Pos=0,0,0.4 }", air, "400 mm above floor/ground",
            "r", true);
        row("turned, in the air", "Robot a { Config=Post Pos=0,0,1 HPR=0,90,0 }", air, "950 mm above", "a", true);
        row("in a wall and wholly in a mesh",
            kMeshes + "StaticConfig W { Box w { Size=4,0.02,4 } }\nStatic block { Config=Block }\nStatic wall { Config=W }\n"
                      "Robot a { Config=Crate Pos=0.1,0,0.5 }",
            in, "block/m", "a", true);
        row("beside a table, its edge above it",
            "StaticConfig T { Box t { Size=1,1,0.5 Pos=0,0,0.25 } }\nStatic table { Config=T }\n"
            "Robot a { Config=Crate Pos=0,0.55,1 }",
            air, "400 mm above table/t", "a", true);
        row("above a box",
            "StaticConfig T { Box t { Size=1,1,0.5 Pos=0,0,0.25 } }\nStatic table { Config=T }\n"
            "Robot a { Config=Crate Pos=0,0,1 }",
            air, "above table/t", "a", true);
        row("one of two bodies in the air",
            "RobotConfig Two { Body one { Box g { Size=0.2,0.2,0.2 Mass=1 } } "
            "Body two { Pos=1,0,1 Box g { Size=0.2,0.2,0.2 Mass=1 } } }\nRobot a { Config=Two Pos=0,0,0.1 }",
            air, "a/two, which no joint holds,", "two", false);
        row("wheels of another size", rover("WheelRadius=0.05 Wh", "WheelRadius=0.06 Wh"), Code::WheelGeometry, "radius of 50 mm",
            "0.06", true);
        row("wheels farther apart", rover("WheelSeparation=0.3", "WheelSeparation=25 cm"), Code::WheelGeometry, "apart by 300 mm",
            "25 cm", true);
        row("sprung wheels of another size",
            QString::fromStdString(rover("WheelRadius=0.05 Wh", "WheelRadius=0.06 Wh"))
                .replace("Hinge ", "Suspension ")
                .replace("Axis=0,1,0", "Axis2=0,1,0 Stiffness=2000 Damping=50 Travel=0.02")
                .toStdString(),
            Code::WheelGeometry, "radius of 50 mm", "0.06", true);
        row("wheels from a Param", rover("WheelRadius=0.05 Wh", "WheelRadius=$(2*wheelRadius) Wh"), Code::WheelGeometry,
            "100 % off", "$(2*wheelRadius)", false);
        row("one motor for both wheels", rover("RightMotor=rightMotor", "RightMotor=leftMotor"), Code::DeviceSetup, "same motor",
            "leftMotor", true);
        row("two motors on one joint", rover("Joint=rightAxle", "Joint=leftAxle"), Code::DeviceSetup,
            "move the same joint, leftAxle", "leftAxle", false);
        row("a motor and a servo on one joint", rover("RotaryMotor rightMotor", "Servo arm { Joint=leftAxle MaxTorque=1 MaxSpeed=1 }\n  RotaryMotor rightMotor"), Code::DeviceSetup,
            "move the same joint, leftAxle", "leftAxle", false);
        row("an encoder without a pitch",
            "RobotConfig Rail { Body b { Box g { Size=0.2,0.2,0.2 Mass=2 } } Slider rail { Parent=world Child=b Axis=1,0,0 } "
            "Encoder count { Joint=rail } }\nRobot a { Config=Rail Pos=0,0,0.1 }",
            Code::DeviceSetup, "needs the Pitch", "count", false);
        row("a wheel of a feather",
            rover("Body leftWheel { Pos=0.1,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2",
                  "Body leftWheel { Pos=0.1,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.0001"),
            Code::MassRatio, "leftAxle", "leftWheel", false);
        const std::string arm = "RobotConfig Arm { Body b { Box g { Size=0.2,0.2,0.2 Mass=2 } } "
                                "Slider leg { Parent=world Child=b Axis=0,0,1 Stiffness=";
        row("a spring faster than the tick", arm + "80000 Damping=40 } }\nRobot a { Config=Arm Pos=0,0,0.1 }",
            Code::SpringTooFast, "31.8 Hz; a tick of 10 ms follows up to 28.6 Hz", "leg", false);
        row("a soft floor faster than the tick",
            "Surface felt { Softness=1e-6 }\nRobotConfig Slab { Body b { Box g { Size=0.2,0.2,0.2 Mass=2 Surface=felt } } }\n"
            "Robot a { Config=Slab Pos=0,0,0.1 }",
            Code::SpringTooFast, "Slab on Surface felt", "felt", false);
        row("a chassis of lead", rover("Mass=2 }", "Mass=20000 }"), Code::MassRatio, "1 to 100000", "leftWheel", false);

        // Of the bodies, their joints and what the motors can do.
        const auto changed = [](const char* from, const char* to, const char* more = "Robot r { Config=Rover }\n") {
            return QString::fromStdString(kRover).replace(from, to).toStdString() + more;
        };
        row("a wheel without a joint",
            changed("  Hinge rightAxle", "  Body box { Pos=0,0,0.14 Box b { Size=0.05,0.05,0.05 Mass=0.1 } }\n  Hinge rightAxle"),
            Code::LooseBody, "box of Rover is held by no joint", "box", true);
        row("two bodies without a joint, the child first",
            changed("  Hinge rightAxle", "  Body box { Pos=0,0,0.14 Box b { Size=0.05,0.05,0.05 Mass=0.1 } }\n"
                                         "  Body lid { Pos=0,0,0.2 Box b { Size=0.05,0.05,0.05 Mass=0.1 } }\n"
                                         "  Hinge clasp { Parent=lid Child=box }\n  Hinge rightAxle"),
            Code::LooseBody, "lid of Rover is held by no joint", "lid", true);
        row("a loop of joints",
            changed("  Hinge rightAxle", "  Fixed rod { Parent=leftWheel Child=rightWheel }\n  Hinge rightAxle"),
            Code::ClosedLoop, "rightAxle of Rover closes a loop", "rightAxle", false);
        row("held by the world twice",
            "RobotConfig Gate { Body b { Box g { Size=0.2,0.2,0.2 Mass=1 } } Body c { Pos=0.3,0,0 Box g { Size=0.2,0.2,0.2 "
            "Mass=1 } }\n"
            "Fixed one { Parent=world Child=b } Hinge two { Parent=b Child=c } Fixed three { Parent=world Child=c } }\n"
            "Robot a { Config=Gate Pos=0,0,0.1 }",
            Code::ClosedLoop, "three of Gate closes a loop", "three", false);
        row("an inertia in g cm^2", changed("Body chassis { Pos=0,0,0.08", "Body chassis { Pos=0,0,0.08 Inertia=120,160,250"),
            Code::OddInertia, "about X is 120 kg m^2, more than", "chassis", true);
        row("an inertia of a pin", changed("Body chassis { Pos=0,0,0.08", "Body chassis { Pos=0,0,0.08 Inertia=1e-7,1e-7,1e-7"),
            Code::OddInertia, "far less than", "chassis", true);
        row("a centre of mass in millimetres",
            changed("Body chassis { Pos=0,0,0.08", "Body chassis { Pos=0,0,0.08 CenterOfMass=10,0,0"), Code::OddInertia,
            "outside of its shapes", "chassis", false);
        row("wheels in the air", changed("Radius=0.03 Mass=0.1", "Radius=0.06 Mass=0.1"), Code::WheelOffGround,
            "leftWheel of Rover is 30 mm above the ground when caster touches it", "leftWheel", false);
        row("one of the wheels that a Part makes",
            R"(PartConfig W { Param z = 0 Body wheel { Pos=0,0,$z Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
                 Hinge axle { Parent=$on Child=wheel Axis=0,1,0 }
                 RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 } }
               RobotConfig Kit { Body hull { Box b { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 } }
                 Part fl { Config=W Pos=0.1,0.12,0.05 on=hull } Part fr { Config=W Pos=0.1,-0.12,0.05 on=hull }
                 Part bl { Config=W Pos=-0.1,0.12,0.05 z=0.01 on=hull } Part br { Config=W Pos=-0.1,-0.12,0.05 on=hull }
                 SkidDrive base { LeftMotors=fl.motor,bl.motor RightMotors=fr.motor,br.motor WheelRadius=0.05 WheelSeparation=0.24 } }
               Robot r { Config=Kit })",
            Code::WheelOffGround, "bl.wheel of Kit is 10 mm above the ground when fl.wheel touches it", "wheel", false);
        row("a free wheel in the air",
            QString::fromStdString(
                changed("  Hinge rightAxle",
                        "  Body tail { Pos=-0.12,0.1,0.05 Cylinder roll { Radius=0.04 Length=0.02 Mass=0.05 HPR=0,0,90 } }\n"
                        "  Hinge tailAxle { Parent=chassis Child=tail Axis=0,1,0 }\n  Hinge rightAxle"))
                .replace("Radius=0.03 Mass=0.1", "Radius=0.03 Mass=0.1 Collide=false") // no caster
                .toStdString(),
            Code::WheelOffGround, "tail of Rover is 10 mm above the ground when leftWheel touches it: it carries nothing;",
            "tail", false);
        row("a wheel too small", changed("Cylinder tyre { Radius=0.05", "Cylinder tyre { Radius=0.03"), Code::WheelOffGround,
            "above the ground", "leftWheel", false);
        row("motors too weak for a doorstep", changed("Resistance=2 ", "Resistance=900 "), Code::WeakMotor,
            "a slope of 3 degrees needs", "leftMotor", false);
        row("motors too weak for a ramp",
            changed("MaxVoltage=12", "GearRatio=1 MaxVoltage=12",
                    "StaticConfig Ramp { Box board { Size=1,1,0.02 Pos=2,0,0.3 HPR=0,30,0 } }\nStatic ramp { Config=Ramp }\n"
                    "Robot r { Config=Rover }\n"),
            Code::WeakMotor, "30 degrees, that of ramp/board, needs", "leftMotor", true);
        row("a wall thinner than the way of a tick",
            changed("", "",
                    "StaticConfig W { Box foil { Size=0.05,2,0.5 Pos=2,0,0.25 } }\nStatic wall { Config=W }\nRobot r { "
                    "Config=Rover }\n"),
            Code::ThinPart, "wall/foil is 50 mm thick, and Rover gets 120 mm far in a tick", "foil", true);
        row("a material that nothing has", "Material pink { ColorRGB=1,0.5,0.5 }\nRobot a { Config=Crate Pos=0,0,0.1 }",
            Code::UnusedDefinition, "Material pink is not used", "pink", true);
        row("a surface that nothing has", "Surface ice { Friction=0.05 }\nRobot a { Config=Crate Pos=0,0,0.1 }",
            Code::UnusedDefinition, "Surface ice is not used", "ice", true);

        // Of the other drives.
        const auto drive = [&](const std::string& text) {
            return changed(
                "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }",
                text.c_str());
        };
        row("skid-steered wheels of another size",
            drive("SkidDrive base { LeftMotors=leftMotor RightMotors=rightMotor WheelRadius=0.06 WheelSeparation=0.3 "
                  "SkidFactor=1.5 }"),
            Code::WheelGeometry, "WheelRadius of base is 60 mm", "0.06", true);
        row("skid-steered wheels farther apart",
            drive("SkidDrive base { LeftMotors=leftMotor RightMotors=rightMotor WheelRadius=0.05 WheelSeparation=0.4 "
                  "SkidFactor=1.5 }"),
            Code::WheelGeometry, "apart by 300 mm", "0.4", true);
        row("a skid-steered motor twice",
            drive("SkidDrive base { LeftMotors=leftMotor,leftMotor RightMotors=rightMotor WheelRadius=0.05 WheelSeparation=0.3 "
                  "SkidFactor=1.5 }"),
            Code::DeviceSetup, "names the motor leftMotor twice", "leftMotor,leftMotor", false);
        const auto made = [](BaseShape base, const char* from, const char* to) {
            const RobotDesign design = usualDesign(base);
            const std::string text = robotText(design, chooseMotor(design).value());
            return QString::fromStdString(text).replace(from, to).toStdString() + "Robot r { Config=Rover }\n";
        };
        row("omni wheels nearer", made(BaseShape::Omni, "WheelDistance=$wheelDistance", "WheelDistance=0.1"), Code::WheelGeometry,
            "away from the middle by 125 mm", "0.1", true);
        row("omni wheels of another size", made(BaseShape::Omni, "WheelRadius=$wheelRadius", "WheelRadius=0.04"),
            Code::WheelGeometry, "have a radius of 50 mm", "0.04", true);
        row("mecanum axles farther apart", made(BaseShape::Mecanum, " WheelBase=$wheelBase", " WheelBase=0.3"),
            Code::WheelGeometry, "are apart by 200 mm", "0.3", true);
        row("a car that is shorter", made(BaseShape::Ackermann, " WheelBase=$wheelBase", " WheelBase=0.2"), Code::WheelGeometry,
            "ahead of the driven ones by 280 mm", "0.2", true);
    }
    void faults() {
        QFETCH(QString, text);
        QFETCH(int, code);
        QFETCH(QString, said);
        QFETCH(QString, place);
        QFETCH(bool, fix);
        const auto loaded = m_fixture.open(text.toStdString());
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        const auto at = std::ranges::find_if(found.all(), [&](const Diagnostic& d) { return static_cast<int>(d.code) == code; });
        QVERIFY2(at != found.all().end(), story.c_str());
        QVERIFY2(QString::fromStdString(at->message).contains(said), story.c_str());
        QCOMPARE(QString::fromUtf8(loaded->sources.slice(at->range).data(), qsizetype(loaded->sources.slice(at->range).size())),
                 place);
        QVERIFY2(fix == !at->fixes.empty(), story.c_str());
        if (!fix) return;
        const std::string repaired = CheckFixture::applied(*loaded, at->fixes[0]);
        const auto again = m_fixture.open(repaired);
        const Diagnostics after = CheckFixture::check(*again);
        const std::string afterStory = repaired + "\n" + story + "---\n" + CheckFixture::shown(*again, after);
        QVERIFY2(!again->diagnostics.hasErrors(), afterStory.c_str());
        for (const Diagnostic& d : after.all()) {
            QVERIFY2(static_cast<int>(d.code) != code, afterStory.c_str());
            QVERIFY2(d.code != Code::BelowFloor, afterStory.c_str()); // the fix must not put it below the floor
        }
    }

    /// Of several robots of one config the first is described, the others are counted.
    void countsOthersInTheAir() {
        const auto loaded = m_fixture.open(kThings + "Robot a { Config=Ball Pos=0,0,1 }\nRobot b { Config=Ball Pos=1,0,2 }\n"
                                                     "Robot c { Config=Crate Pos=3,0,4 }\nRobot d { Config=Ball Pos=2,0,3 }");
        const Diagnostics found = CheckFixture::check(*loaded);
        QCOMPARE(found.all().size(), std::size_t{2});
        QCOMPARE(found.all()[0].message,
                 std::string("a starts 900 mm above floor/ground and falls onto it; to start there, lower it "
                             "(and 2 more like it)"));
        QCOMPARE(found.all()[1].message,
                 std::string("c starts 3.9 m above floor/ground and falls onto it; to start there, lower it"));
    }

    /// The fix of a Grid moves the Grid, up only, although its first member stands elsewhere.
    void fixOfAGrid() {
        for (const auto& [given, fixed] : {std::pair("Pos=1,2,0", "Pos=1,2,0.1001"), {"", "Pos=0,0,0.1001"}}) {
            const auto loaded = m_fixture.open(kThings + "Grid g { Config=Crate Count=3,3 Spacing=1 " + given + " }");
            const Diagnostics found = CheckFixture::check(*loaded);
            QCOMPARE(found.all().size(), std::size_t{1});
            QCOMPARE(found.all()[0].fixes.at(0).title, std::string(fixed));
        }
    }

    void acceptsValidWorlds_data() {
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QString::fromStdString(kThings + text);
        };
        row("resting", "Robot a { Config=Crate Pos=0,0,0.1 }\nRobot b { Config=Ball Pos=1,0,0.1 }");
        row("on each other", "Robot a { Config=Crate Pos=0,0,0.1 }\nRobot b { Config=Crate Pos=0,0,0.3 }");
        row("a little drop", "Robot a { Config=Ball Pos=0,0,0.14 }");
        row("hung on the world", "RobotConfig Lamp { Body b { Box g { Size=0.1,0.1,0.1 Mass=1 } } Hinge h { Parent=world Child=b "
                                 "Anchor=0,0,0.5 Axis=1,0,0 } }\n"
                                 "Robot a { Config=Lamp Pos=0,0,2 }");
        row("a mesh on the floor", kMeshes + "Robot a { Config=Stone }\nRobot b { Config=Stone Pos=1,0,0 b.c.Scale=3 }");
        row("a turned mesh on the floor", kMeshes + "Robot a { Config=Beam Pos=0,0,0.05 HPR=20,0,90 }");
        row("on a mesh", kMeshes + "Static block { Config=Block HPR=20,0,0 }\nRobot a { Config=Crate Pos=0,0,1.1 }\n"
                                   "Robot b { Config=Stone Pos=0.3,0,1 }");
        row("a spring that the tick follows", "RobotConfig Arm { Body b { Box g { Size=0.2,0.2,0.2 Mass=2 } } "
                                              "Slider leg { Parent=world Child=b Axis=0,0,1 Stiffness=60000 } }\n"
                                              "Robot a { Config=Arm Pos=0,0,0.1 }");
        row("beside a mesh", kMeshes + "Static block { Config=Block }\nRobot a { Config=Crate Pos=0.601,0,0.1 }");
        row("a larger instance in its place", kMeshes + "Robot a { Config=Sized Pos=0,0,0.2 s=0.4 }");
        row("motors on joints whose names begin alike",
            QString::fromStdString(kRover).replace("rightAxle", "leftAxle1").toStdString() + "Robot r { Config=Rover }");
        row("wheels on the floor", kRover + "Robot r { Config=Rover Pos=1,1,0 HPR=33,0,0 }");
        row("no gravity", "Gravity=0,0,0\nRobot a { Config=Ball Pos=0,0,5 }");
        row("a shape that collides with nothing",
            "RobotConfig Ghost { Body b { Box g { Size=0.2,0.2,0.2 Mass=1 } Box big { Size=3,3,3 Collide=false Mass=1 } } }\n"
            "Robot a { Config=Ghost Pos=0,0,0.1 }");
        row("bodies of one robot",
            "RobotConfig Nested { Body b { Box g { Size=0.2,0.2,0.2 Mass=1 } } Body c { Box g { Size=0.1,0.1,0.1 Mass=1 } } "
            "Fixed f { Parent=b Child=c } }\nRobot a { Config=Nested Pos=0,0,0.1 }");
    }
    void acceptsValidWorlds() {
        QFETCH(QString, text);
        const auto loaded = m_fixture.open(text.toStdString());
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY2(!loaded->diagnostics.hasErrors() && found.all().empty(), CheckFixture::shown(*loaded, found).c_str());
    }

    void acceptsShippedTexts_data() {
        QTest::addColumn<QString>("path");
        for (const QString& path : allConfigs()) QTest::newRow(qPrintable(path.section('/', -2))) << path;
    }
    void acceptsShippedTexts() {
        QFETCH(QString, path);
        const auto loaded = m_fixture.openFile(path.toStdString());
        if (!loaded || loaded->diagnostics.hasErrors()) return; // files that are only imported and do not open alone
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY2(found.all().empty(), CheckFixture::shown(*loaded, found).c_str());
    }

    /// Ten thousand robots that overlap the floor and each other give two messages.
    void reportsManyRobotsOnce() {
        const auto loaded = m_fixture.open(kThings + "Grid g { Config=Crate Count=100,100 Spacing=0.15 Pos=0,0,0.02 }");
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY2(found.all().size() == 2, CheckFixture::shown(*loaded, found).c_str());
        const auto air = m_fixture.open(kThings + "Grid g { Config=Crate Count=100,100 Spacing=1 Pos=0,0,3 }");
        QCOMPARE(CheckFixture::check(*air).all().size(), std::size_t(1));
    }

    /// Closing the window does not wait for a check.
    void aRequestToStopEndsIt() {
        const auto loaded = m_fixture.open(kThings + "Grid g { Config=Crate Count=100,100 Spacing=1 Pos=0,0,3 }");
        std::stop_source stop;
        stop.request_stop();
        Diagnostics found;
        checkModel(*loaded, found, stop.get_token());
        QVERIFY(found.all().empty());
    }

    /// What is wrong in each member of a Repeat is one message; the hint says how many there are.
    void saysOnceWhatMembersShare() {
        const auto loaded = m_fixture.open(
            "Material g { } Surface s { } StaticConfig F { Plane p { Material=g Surface=s } } Static f { Config=F }\n"
            "RobotConfig Cart { Body b { Box hull { Size=1,1,1 Pos=0,0,0.5 Material=g Surface=s Mass=100 } }\n"
            " Repeat w { Count=4 Pos=$(2*index),2,0\n"
            "  Body rim { Sphere t { Radius=0.1 Pos=0,0,0.1 Mass=0.0001 Material=g Surface=s } Inertia=1,1,1 }\n"
            "  Body tip { CenterOfMass=0,0,4 Sphere t { Radius=0.1 Pos=0,0,1 Mass=0.0001 Material=g Surface=s } }\n"
            "  Hinge h { Parent=b Child=rim Axis=0,1,0 Stiffness=1e6 } } }\nRobot x { Config=Cart }\n");
        std::multiset<std::string> codes;
        std::string tip, all;
        const Diagnostics found = CheckFixture::check(*loaded);
        for (const Diagnostic& d : found.all()) {
            codes.insert(codeName(d.code));
            if (d.code == Code::Unsupported) tip = d.message;
        }
        for (const std::string& code : codes) all += code + " ";
        QCOMPARE(all, std::string("E307 E327 E328 E330 E333 E336 E336 "));
        QVERIFY2(tip.ends_with("(and 3 more like it)"), tip.c_str());
    }

    /// A text with errors is not checked further: only its errors are listed.
    void listsErrorsFirst() {
        const auto loaded = m_fixture.open(kThings + "Robot a { Config=Crate Pos=0,0,-1 Mess=3 }");
        QVERIFY(loaded->diagnostics.hasErrors());
        QVERIFY(CheckFixture::check(*loaded).all().empty());
    }
};

QTEST_GUILESS_MAIN(ModelCheckTest)
#include "model_check_test.moc"
