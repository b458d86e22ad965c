// Bodies, springs, loads, places and scenery at the limits of what is reported: just beyond a limit there is one finding with
// its cause, just within it nothing is found. What is off-centre, turned or written in another order shows the other value.
#include "check/finding_rows.h"

using namespace fixture;

namespace {

const std::string kMotor = "MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 ";
/// A rover `name` of 1 m/s with other values of its motors.
std::string rover(const std::string& name, const std::string& motor) {
    return "RobotConfig " + name +
           " {\n  Body chassis { Box hull { Pos=0,0,0.08 Size=0.3,0.2,0.06 Mass=2 } Sphere ball { Pos=-0.1,0,0.02 Radius=0.02 "
           "Mass=0.05 } }\n"
           "  Body left { Pos=0.05,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n"
           "  Body right { Pos=0.05,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }\n"
           "  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }\n  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 "
           "}\n"
           "  RotaryMotor leftMotor { Joint=leftAxle " +
           motor + "}\n  RotaryMotor rightMotor { Joint=rightAxle " + motor +
           "}\n  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }\n";
}
const std::string kRobot = "}\nRobot r { Config=B }\n";

/// One body of 2 kg, a cube of 0.2 m, and what is more in its config.
std::string block(const std::string& more, const std::string& ofBody = {}) {
    return "RobotConfig C { Body a { " + ofBody + "Box g { Size=0.2,0.2,0.2 Mass=2 } } " + more +
           " }\nRobot r { Config=C Pos=0,0,0.1 }\n";
}
std::string legs(const std::string& second) {
    return "RobotConfig B { Body chassis { Box hull { Pos=0,0,0.12 Size=0.3,0.2,0.04 Mass=1 } }\n"
           "  Body one { Pos=0.1,0,0.05 Cylinder foot { Radius=0.01 Length=0.1 Mass=0.1 } }\n"
           "  Body two { Pos=0.1,0,0.05 Cylinder foot { " +
           second + " Mass=0.1 } }\n  Fixed a { Parent=chassis Child=one } Fixed b { Parent=chassis Child=two }\n" + kRobot;
}
std::string lift(const std::string& joint, const std::string& force) {
    return "RobotConfig B {\n  Body base { Box b { Size=0.4,0.4,0.4 Mass=20 } }\n"
           "  Body mast { Pos=0.25,0,0 Box b { Size=0.1,0.1,0.1 Mass=0.5 } }\n  Slider rail { " +
           joint + " LowStop=-0.1 HighStop=0.1 }\n  LinearMotor lift { Joint=rail MaxForce=" + force +
           " MaxSpeed=0.1 }\n}\nRobot r { Config=B Pos=0,0,0.2 }\n";
}
/// A slab of 0.2 x 0.2 x 0.1 m.
std::string slab(const std::string& config, const std::string& robot, const std::string& place) {
    return "RobotConfig " + config + " { Body b { Box s { Size=0.2,0.2,0.1 Mass=1 } } }\nRobot " + robot + " { Config=" + config +
           " Pos=" + place + ",0.05 }\n";
}
std::string geared(const std::string& last) {
    std::string text = "RobotConfig G { Body h { Box x { Size=0.6,0.2,0.2 Mass=1 } }\n";
    const char* const places[] = {"-0.2", "-0.05", "0.1", "0.25"};
    for (int i = 0; i < 4; ++i) {
        const std::string n(1, static_cast<char>('a' + i));
        text += "  Body w" + n + " { Pos=" + places[i] +
                ",0,0.2 Cylinder t { Radius=0.05 Length=0.03 Mass=0.1 HPR=0,0,90 } } Hinge " + n + " { Parent=h Child=w" + n +
                " Axis=0,1,0 }\n";
    }
    return text + "  Gear g { Joint=a Other=b Ratio=2 } Gear k { Joint=b Other=c Ratio=3 } Gear i { Joint=c Other=d Ratio=-5 } " +
           last + " }\nRobot r { Config=G Pos=0,0,0.1 }\n";
}
std::string wall(const std::string& geoms, const std::string& place = "3,0,0.5") {
    return "StaticConfig W { " + geoms + " }\nStatic wall { Config=W Pos=" + place + " }\n";
}

} // namespace

class BodyEdgesTest : public QObject, FindingRows {
    Q_OBJECT

private Q_SLOTS:
    void bodies_data() {
        columns();
        const std::string shapes = "take it from the shapes";
        row("a centre of mass far to the negative side", block("", "CenterOfMass=-10,0,0 "), "is 9.9 m outside of its shapes");
        row("a centre of mass 30 mm outside", block("", "CenterOfMass=0,-0.13,0 "), "is 30 mm outside of its shapes");
        row("a centre of mass 15 mm outside", block("", "CenterOfMass=0,-0.115,0 "), "");
        row("an inertia of a pin", "Robot a { Config=Crate Pos=0,0,0.1 b.Inertia=4e-6,4e-6,4e-6 }\n",
            "about X is 4e-06 kg m^2, far less than", shapes);
        row("an inertia of a heavy core", "Robot a { Config=Crate Pos=0,0,0.1 b.Inertia=8e-6,8e-6,8e-6 }\n", "");
        row("an inertia of millions", "Robot a { Config=Crate Pos=0,0,0.1 b.Inertia=2500000,2500000,2500000 }\n",
            "about X is 2500000 kg m^2, more than", shapes);
        row("a second joint the other way round",
            block("Body b { Pos=0.3,0,0 Box h { Size=0.2,0.2,0.2 Mass=1 } } Hinge one { Parent=a Child=b } Fixed two { Parent=b "
                  "Child=a }"),
            "");
        const std::string wheel = "Cylinder h { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=1 } } ";
        row("loose wheels alone",
            "RobotConfig C { Body a { Pos=0,0,0.05 " + wheel + "Body b { Pos=0.3,0,0.05 " + wheel + "}\nRobot a { Config=C }\n",
            "");
        row("a loose disc that lies beside a box",
            "RobotConfig C { Body a { Pos=0,0,0.015 Cylinder h { Radius=0.05 Length=0.03 Mass=1 } } Body b { Pos=0.3,0,0.1 Box h "
            "{ "
            "Size=0.2,0.2,0.2 Mass=1 } } }\nRobot a { Config=C }\n",
            "");
        row("legs alike in one place", legs("Radius=0.01 Length=0.1"), "two of B is in the place of one");
        row("a shorter leg in the place of another", legs("Radius=0.01 Length=0.09"), "");
        row("a thicker leg in the place of another", legs("Radius=0.011 Length=0.1"), "");
        row("a heavy child", block("Body b { Pos=0.3,0,0 Box h { Size=0.2,0.2,0.2 Mass=40000 } } Fixed f { Parent=a Child=b }"),
            "a of C weighs 2 kg and b, which f joins to it, 40000 kg: 1 to 20000");
        row("a chain of gears that agree", geared("Gear j { Joint=a Other=d Ratio=-30 }"), "");
        row("a chain of gears that contradict", geared("Gear j { Joint=a Other=d Ratio=-29 }"),
            "by its Ratio, a turns at -29 times the rate of d, by other Gears at -30 times");
    }
    void bodies() { check(); }

    void springs_data() {
        columns();
        // At 200 rad/s, of which a tick of 10 ms follows 180: a Slider with both masses, a Spring beside the middle of its
        // body, 0.8 kg, a Hinge about the middle, 1/75 kg m^2, and one 0.1 m beside it, 1/30 kg m^2, where a distance along
        // the axis counts nothing.
        const std::string swings = " swings at 31.8 Hz; a tick of 10 ms follows up to 28.6 Hz";
        row("two bodies",
            block("Body b { Pos=0.3,0,0 Box g { Size=0.2,0.2,0.2 Mass=2 } } Slider s { Parent=a Child=b Axis=1,0,0 "
                  "Stiffness=40000 }"),
            "the spring of s in C" + swings);
        row("a spring off the middle",
            block("Spring s { Parent=world Child=a Anchor=0.1,0,2 Anchor2=0.1,0,0.1 Stiffness=32000 }"),
            "the spring s in C" + swings);
        row("a spring through the middle",
            block("Spring s { Parent=world Child=a Anchor=0,0,2 Anchor2=0,0,0.1 Stiffness=62000 }"), "");
        row("a hinge through the middle", block("Hinge s { Parent=world Child=a Axis=0,1,0 Anchor=0,3,0 Stiffness=533.3 }"),
            "the spring of s in C" + swings);
        row("a hinge beside the middle", block("Hinge s { Parent=world Child=a Axis=0,1,0 Anchor=0.1,3,0 Stiffness=1333.3 }"),
            "the spring of s in C" + swings);
        row("soft ground",
            "Surface felt { Softness=1e-6 }\n" + wall("Box x { Size=1,1,0.1 Pos=0,0,-0.05 Surface=felt }", "5,0,0.1") +
                "RobotConfig Slab { Body b { Box g { Size=0.2,0.2,0.2 Mass=2 } } }\nRobot a { Config=Slab Pos=5,0,0.2 }\n",
            "Slab on Surface felt swings at 79.6 Hz");
    }
    void springs() { check(); }

    void loads_data() {
        columns();
        row("a lift upwards", lift("Parent=base Child=mast Axis=0,0,1", "4.8"),
            "that weighs 4.91 N along its axis, MaxForce is 4.8 N");
        row("a lift that is written from its load", lift("Parent=mast Child=base Axis=0,0,1", "10"), "");
        row("a slider that is almost level", lift("Parent=base Child=mast Axis=1,0,0.03", "0.1"), "");
        row("a slider that climbs a little", lift("Parent=base Child=mast Axis=1,0,0.1", "0.1"),
            "that weighs 0.488 N along its axis");
        row("a lift whose mast is the child",
            "RobotConfig B {\n  Body mast { Box b { Size=0.05,0.05,1 Pos=0,0,0.6 Mass=1 } }\n"
            "  Body car { Pos=0.2,0,0.5 Box b { Size=0.2,0.2,0.2 Mass=5 } }\n  Fixed f { Parent=world Child=mast }\n"
            "  Slider rail { Parent=car Child=mast Axis=0,0,1 LowStop=-0.1 HighStop=0 }\n"
            "  LinearMotor lift { Joint=rail MaxForce=20 MaxSpeed=0.1 }\n}\nRobot r { Config=B }\n",
            "lift of B cannot lift what is on rail: that weighs 49.1 N along its axis, MaxForce is 20 N");
        row("an arm that is too heavy at the start, which is tried",
            rover("B", kMotor) +
                "  Body mast { Pos=0.3,0,0.2 Box b { Size=0.04,0.04,0.1 Mass=0.5 } }\n"
                "  Hinge tip { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,0.15 LowStop=-90 HighStop=30 }\n"
                "  Servo arm { Joint=tip MaxTorque=0.2 MaxSpeed=3 }\n" +
                kRobot,
            "");
        const std::string pair = slab("One", "a", "0,0") + slab("Two", "b", "0.21,0");
        row("an anchor above both bodies", pair + "Ball one { Parent=a.b Child=b.b Anchor=0.105,0,0.3 }\n",
            "the Anchor of one is 200 mm away from a.b");
        row("an anchor a little above", pair + "Ball one { Parent=a.b Child=b.b Anchor=0.105,0,0.23 }\n", "");
        row("an anchor at a body far from the middle of its robot",
            "RobotConfig C { Body m { Box h { Size=0.2,0.2,0.1 Mass=1 } } Body b { Pos=2,0,0 Box h { Size=0.2,0.2,0.1 Mass=1 } } "
            "Fixed f { Parent=m Child=b } }\nRobot a { Config=C Pos=0,0,0.05 }\n" +
                slab("Two", "t", "2.21,0") + "Ball one { Parent=a.b Child=t.b Anchor=2.105,0,0.05 }\n",
            "");
    }
    void loads() { check(); }

    void places_data() {
        columns();
        row("3 mm in the floor", "Robot a { Config=Crate Pos=0,0,0.097 }\n", "");
        row("5 mm in the floor", "Robot a { Config=Crate Pos=0,0,0.095 }\n", "is 5 mm deep in it", "Pos=0,0,0.1001");
        row("a capsule upright in the air",
            "RobotConfig C { Body b { Capsule c { Radius=0.05 Length=0.4 Mass=1 } } }\nRobot a { Config=C Pos=0,0,1 }\n",
            "a starts 750 mm above floor/ground", "Pos=0,0,0.2501");
        row("a capsule that leans in the air",
            "RobotConfig C { Body b { Capsule c { Radius=0.05 Length=0.4 Mass=1 } } }\nRobot a { Config=C Pos=0,0,1 HPR=0,60,0 "
            "}\n",
            "a starts 850 mm above floor/ground", "Pos=0,0,0.1501");
        const std::string one = "Robot a { Config=Crate Pos=0,0,0.1 }\n", two = "Robot b { Config=Crate Pos=0.05,0,0.1 }\n";
        row("two that touch nothing of each other", "NoContact = a,b\n" + one + two, "");
        row("another pair that does not touch", "NoContact = a,c\n" + one + two + "Robot c { Config=Crate Pos=3,0,0.1 }\n",
            "b starts inside a/b/hull", "Pos=0.2001,0,0.1");
        row("a little in a table, in each other",
            wall("Box t { Size=2,2,0.4 Pos=0,0,0.2 }", "0,0,0") +
                "Robot a { Config=Crate Pos=0,0,0.4995 }\nRobot b { Config=Crate Pos=0.15,0,0.4995 }\n",
            "b starts inside a/b/hull", "Pos=0.2001,0,0.4995");
        row("members of a Repeat in the floor",
            "Repeat row { Count=2 Pos=$(3*index),0,0 Robot a { Config=Crate Pos=0,0,0.05 } }\n",
            "row_0.a starts inside floor/ground");
        row("two thin walls, the thinner one first",
            rover("B", kMotor) + kRobot + wall("Box foil { Size=0.004,2,0.5 } Box film { Size=0.007,2,0.5 Pos=1,0,0 }"),
            "wall/foil is 4 mm thick, and B gets 10 mm far in a tick at its top speed of 1 m/s: it may be inside before it "
            "touches; "
            "make it thicker or the Tick 2 ms (and 1 more like it)",
            "Tick = 0.002");
        row("two thin walls, the thinner one last",
            rover("B", kMotor) + kRobot + wall("Box film { Size=0.007,2,0.5 } Box foil { Size=0.004,2,0.5 Pos=1,0,0 }"),
            "wall/foil is 4 mm thick", "Tick = 0.002");
        const std::string slow = kMotor.substr(0, kMotor.find("30 ")) + "90 ";
        row("the faster robot first",
            rover("B", kMotor) + kRobot + rover("S", slow) + "}\nRobot s { Config=S Pos=2,2,0 }\n" +
                wall("Box foil { Size=0.005,2,0.5 }"),
            "wall/foil is 5 mm thick, and B gets 10 mm far", "Tick = 0.005");
        row("the faster robot last",
            rover("S", slow) + "}\nRobot s { Config=S Pos=2,2,0 }\n" + rover("B", kMotor) + kRobot +
                wall("Box foil { Size=0.005,2,0.5 }"),
            "wall/foil is 5 mm thick, and B gets 10 mm far", "Tick = 0.005");
    }
    void places() { check(); }
};

QTEST_APPLESS_MAIN(BodyEdgesTest)
#include "body_edges_test.moc"
