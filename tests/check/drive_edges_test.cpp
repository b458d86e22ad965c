// Drives, motors and wheels at the limits of what is reported: just beyond a limit there is one finding with its cause, just
// within it nothing is found. The parts differ, so that the other side, the other axis or the other body shows.
#include "check/finding_rows.h"

using namespace fixture;

namespace {

const std::string kMotor = "MaxVoltage=12 Resistance=2 TorqueConstant=0.02 SpeedConstant=50 GearRatio=30 }\n";
const std::string kTyre = "Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } ";
const std::string kBall = "Sphere ball { Pos=-0.1,0,0.02 Radius=0.02 Mass=0.05 }";
const std::string kBase = "RobotConfig B {\n  Body chassis { Box hull { Pos=0,0,0.08 Size=0.3,0.2,0.06 Mass=2 } " + kBall +
                          " }\n  Body left { Pos=0.05,0.15,0.05 " + kTyre + "}\n  Body right { Pos=0.05,-0.15,0.05 " + kTyre +
                          "}\n  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }\n"
                          "  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }\n"
                          "  RotaryMotor leftMotor { Joint=leftAxle " +
                          kMotor + "  RotaryMotor rightMotor { Joint=rightAxle " + kMotor +
                          "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 "
                          "WheelSeparation=0.3 }\n";
const std::string kRobot = "}\nRobot r { Config=B }\n";

/// Three wheels on each side, by a Part.
const std::string kKit = R"(PartConfig W { Param r = 0.05 Param y = 0
  Body wheel { Pos=0,$y,0 Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge axle { Parent=$on Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 } }
RobotConfig Kit { Body hull { Box b { Size=0.3,0.2,0.1 Pos=0,0,0.1 Mass=2 } }
  Part fl { Config=W Pos=0.1,0.12,0.05 on=hull } Part fr { Config=W Pos=0.1,-0.12,0.05 on=hull }
  Part ml { Config=W Pos=0,0.12,0.05 on=hull } Part mr { Config=W Pos=0,-0.12,0.05 on=hull }
  Part bl { Config=W Pos=-0.1,0.12,0.05 on=hull } Part br { Config=W Pos=-0.1,-0.12,0.05 on=hull }
  SkidDrive base { LeftMotors=fl.motor,ml.motor,bl.motor RightMotors=fr.motor,mr.motor,br.motor
             WheelRadius=0.05 WheelSeparation=0.24 } }
)";

using Changes = std::vector<std::pair<std::string, std::string>>;

/// Each change once, from the front; empty if something is not there.
std::string changed(std::string text, const Changes& changes) {
    for (const auto& [from, to] : changes) {
        const std::size_t at = text.find(from);
        if (at == std::string::npos) return {};
        text.replace(at, from.size(), to);
    }
    return text;
}
std::string both(const std::string& from, const std::string& to) {
    const std::size_t first = kBase.find(from), second = kBase.find(from, first + 1);
    return changed(std::string(kBase).replace(second, from.size(), to), {{from, to}}) + kRobot;
}
/// The base with other values of one motor.
std::string withMotor(const std::string& side, const Changes& changes) {
    const std::size_t at = kBase.find("RotaryMotor " + side);
    return kBase.substr(0, at) + changed(kBase.substr(at), changes) + kRobot;
}
std::string withHub(const std::string& hub, const Changes& changes) {
    return changed(changed(kBase, {{"0.15,0.05 " + kTyre, "0.15,0.05 " + kTyre + hub}}), changes) + kRobot;
}
/// Four wheels; the gear ratio of those at the back.
std::string skidSteer(const std::string& ofBack) {
    std::string text = "RobotConfig B {\n  Body chassis { Box hull { Pos=0,0,0.1 Size=0.4,0.2,0.06 Mass=4 } }\n";
    for (const std::string n : {"fl", "fr", "bl", "br"}) {
        const std::string place = std::string(n[0] == 'f' ? "0.12," : "-0.12,") + (n[1] == 'l' ? "0.15,0.05 " : "-0.15,0.05 ");
        text += "  Body " + n + " { Pos=" + place + kTyre + "}\n  Hinge a" + n + " { Parent=chassis Child=" + n +
                " Axis=0,1,0 }\n  RotaryMotor m" + n + " { Joint=a" + n + " " +
                (n[0] == 'f' ? kMotor : changed(kMotor, {{"GearRatio=30", "GearRatio=" + ofBack}}));
    }
    return text +
           "  SkidDrive base { LeftMotors=mfl,mbl RightMotors=mfr,mbr WheelRadius=0.05 WheelSeparation=0.3 SkidFactor=1.5 }\n";
}
std::string withJaws(const std::string& left, const std::string& right, const std::string& leftAxis, const std::string& rightAxis,
                     const std::string& shift) {
    const auto jaw = [&](const std::string& name, const std::string& at, const std::string& axis, const std::string& sign) {
        return "  Body jaw" + name + " { Pos=0.2," + at + ",0.08 Box pad { Size=0.08,0.01,0.03 Mass=0.05 Pos=0," + sign + shift +
               ",0 } }\n  Slider open" + name + " { Parent=chassis Child=jaw" + name + " Axis=" + axis +
               " LowStop=-0.02 HighStop=0.02 }\n";
    };
    return kBase + jaw("Left", left, leftAxis, "") + jaw("Right", right, rightAxis, "-") +
           "  Gripper hand { Left=openLeft Right=openRight Force=10 }\n" + kRobot;
}
std::string withCaster(const std::string& disc, const std::string& joint) {
    return changed(kBase, {{kBall, ""}}) + "  Body caster { Pos=-0.1,0,0.02 Cylinder disc { Radius=0.02 Length=" + disc +
           " HPR=0,0,90 Mass=0.05 } }\n  Hinge roll { Parent=chassis Child=caster Axis=1,0,0" + joint + " }\n" + kRobot;
}
std::string withTail(const std::string& height, const std::string& more) {
    return changed(kBase, {{kBall, ""}}) + "  Body tail { Pos=-0.12,0.1," + height +
           " Cylinder roll { Radius=0.04 Length=0.02 Mass=0.05 HPR=0,0,90 } }\n"
           "  Hinge tailAxle { Parent=chassis Child=tail Axis=0,1,0 }\n" +
           more + kRobot;
}
/// On springs with this damping, N s/m; the axis of the right wheel.
std::string sprung(const std::string& damping, const std::string& rightAxis) {
    std::string text = kBase;
    for (const std::string side : {"left", "right"})
        text =
            changed(text, {{"Hinge " + side + "Axle { Parent=chassis Child=" + side + " Axis=0,1,0",
                            "Suspension " + side + "Axle { Parent=chassis Child=" + side + " Axis=0,0,1 Axis2=" +
                                (side == "left" ? "0,1,0" : rightAxis) + " Stiffness=1500 Damping=" + damping + " Travel=0.04"}});
    return text + kRobot;
}
/// Tracks that are apart along x.
std::string crawler(const std::string& separation, const std::string& leftGeoms) {
    return "RobotConfig Crawler { Body hull { Box b { Size=0.1,0.3,0.06 Pos=0,0,0.06 Mass=3 } Box l { Size=0.05,0.3,0.08 "
           "Pos=-0.1,0,0.04 Mass=0.5 } Box r { Size=0.05,0.3,0.08 Pos=0.1,0,0.04 Mass=0.5 } }\n  Track left { Geom=" +
           leftGeoms +
           " MaxSpeed=0.5 } Track right { Geom=hull.r MaxSpeed=0.5 }\n"
           "  TrackDrive base { LeftTrack=left RightTrack=right TrackSeparation=" +
           separation + " }\n}\nRobot c { Config=Crawler }\n";
}

} // namespace

class DriveEdgesTest : public QObject, FindingRows {
    Q_OBJECT

private Q_SLOTS:
    void motors_data() {
        columns();
        const auto constant = [](const char* value) {
            return both("TorqueConstant=0.02", std::string("TorqueConstant=") + value);
        };
        row("constants that give 1.8 times the power", constant("0.036"), "");
        row("constants that give 2.1 times the power", constant("0.042"), "it would give 2.1 times the power that it takes");
        row("constants that give 0.31 of the power", constant("0.0062"), "");
        row("constants that give 0.29 of the power", constant("0.0058"), "it would give 0.29 times the power that it takes");
        row("motors alike that are at the same places", skidSteer("60") + kRobot, "");
        const Changes faster{{"SpeedConstant=50", "SpeedConstant=90"}};
        row("a faster motor on the left", withMotor("left", faster),
            "leftMotor of base turns at up to 36 rad/s with up to 3.6 N m, rightMotor at up to 20 rad/s with up to 3.6 N m: its "
            "SpeedConstant is 90, that of rightMotor 50");
        row("a faster motor on the right", withMotor("right", faster),
            "rightMotor of base turns at up to 36 rad/s with up to 3.6 N m, leftMotor at up to 20 rad/s");
        row("a weaker motor on the left", withMotor("left", {{"Resistance=2", "Resistance=20"}}),
            "leftMotor of base turns at up to 20 rad/s with up to 0.36 N m, rightMotor at up to 20 rad/s with up to 3.6 N m: its "
            "Resistance is 20, that of rightMotor 2");
        row("a weaker motor on the right", withMotor("right", {{"Resistance=2", "Resistance=20"}}),
            "with up to 3.6 N m: its Resistance is 20, that of leftMotor 2");
        row("the value that differs most",
            withMotor("right", {{"MaxVoltage=12", "MaxVoltage=3"}, {"Resistance=2", "Resistance=3"}}),
            "with up to 3.6 N m: its MaxVoltage is 3, that of leftMotor 12");
        row("half of the efficiency", withMotor("right", {{"MaxVoltage=12", "Efficiency=0.5 MaxVoltage=12"}}),
            "rightMotor of base turns at up to 20 rad/s with up to 1.8 N m, leftMotor at up to 20 rad/s with up to 3.6 N m: its "
            "Efficiency is 0.5, that of leftMotor 1");
        row("jaws that move across each other", withJaws("0.03", "-0.03", "0.98,-0.17,0", "0.98,0.17,0", "0"), "");
        row("jaws whose frames are on the other sides", withJaws("-0.03", "0.03", "0,1,0", "0,-1,0", "0.06"), "");
        row("a right jaw that moves inwards", withJaws("0.03", "-0.03", "0,1,0", "0,1,0", "0"),
            "openRight moves its jaw towards");
        row("a left jaw that moves inwards", withJaws("0.03", "-0.03", "0,-1,0", "0,-1,0", "0"),
            "openLeft moves its jaw towards");
        row("a coarse and an absolute encoder",
            kBase +
                "  Encoder one { Joint=leftAxle CountsPerRevolution=100 }\n"
                "  Encoder two { Joint=leftAxle CountsPerRevolution=100 Type=absolute }\n" +
                kRobot,
            "");
        row("one motor twice beside three others",
            changed(skidSteer("30"), {{"SkidDrive base { LeftMotors=mfl,mbl RightMotors=mfr,mbr",
                                       "DifferentialDrive base { LeftMotor=mfl RightMotor=mfl"},
                                      {" SkidFactor=1.5", ""}}) +
                kRobot,
            "LeftMotor and RightMotor of base are the same motor, mfl");
        row("a limit above the current at stall", both("MaxVoltage=12", "CurrentLimit=8 FrictionTorque=0.1195 MaxVoltage=12"),
            "what holds them back is their FrictionTorque of 0.119 N m");
    }
    void motors() { check(); }

    void axles_data() {
        columns();
        row("the larger of two cylinders is the wheel",
            withHub("Cylinder hub { Radius=0.02 Length=0.06 HPR=0,0,90 Mass=0.05 } ",
                    {{"Child=left Axis=0,1,0", "Child=left Axis=1,0,0"}}),
            "is not along the axis of left's tyre: the wheel does not roll; its axis is that of Axis=0,1,0", "Axis=0,1,0");
        row("a flat tyre in a body that is turned",
            changed(kBase, {{"left { Pos=0.05,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 }",
                             "left { Pos=0.05,0.15,0.05 HPR=90,0,0 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 }"}}) +
                kRobot,
            "tyre of left lies flat, across its axle leftAxle: the wheel does not roll; a Cylinder is along z, and HPR turns it: "
            "HPR=0,90,0",
            "HPR=0,90,0");
        row("a disc across its axle", withCaster("0.019", ""), "roll of B is not along the axis of caster's disc");
        row("a roller across its axle", withCaster("0.021", ""), "");
        row("a disc across an axle beside it", withCaster("0.01", " Anchor=-0.1,0,0.034"), "");
        row("an axle along x whose cylinder points back",
            changed(kBase, {{"0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 }",
                             "0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,-90,0 }"},
                            {"Child=left Axis=0,1,0", "Child=left Axis=0,0,1"}}) +
                kRobot,
            "its axis is that of Axis=1,0,0", "Axis=1,0,0");
        row("a sprung axle reversed", sprung("50", "0,-1,0"), "rightAxle, the axle of right, points the other way",
            "reverse the axis");
        row("springs that are damped enough", sprung("5", "0,1,0"), "");
        row("springs that are hardly damped", sprung("1", "0,1,0"), "leftAxle of B hardly damps its spring");
        row("both axles reversed",
            changed(kBase, {{"left Axis=0,1,0", "left Axis=0,-1,0"}, {"right Axis=0,1,0", "right Axis=0,-1,0"}}) + kRobot,
            "the axles of left and right point to the right", "reverse their axes");
    }
    void axles() { check(); }
    /// Of a Suspension the axle is its second axis.
    void aFixReversesTheAxle() {
        const auto loaded = m_fixture.open(kThings + sprung("50", "0,-1,0"));
        const Diagnostics found = CheckFixture::check(*loaded);
        QVERIFY(found.all().size() == 1 && found.all()[0].fixes.size() == 1);
        QCOMPARE(CheckFixture::applied(*loaded, found.all()[0].fixes[0]), kThings + sprung("50", "0,1,0"));
    }

    void places_data() {
        columns();
        const std::string kit = kKit + "Robot r { Config=Kit }\n";
        const std::string apart = "WheelSeparation of base is 400 mm, but the middles of the wheels left and right are apart by "
                                  "300 mm: turns will be 33.3 % off";
        const Changes wider{{"WheelSeparation=0.3", "WheelSeparation=0.4"}};
        row("wheels nearer than said", changed(kBase, wider) + kRobot, apart, "WheelSeparation=0.3");
        row("the same with hubs", withHub("Cylinder hub { Radius=0.02 Length=0.02 HPR=0,0,90 Mass=0.05 } ", wider), apart,
            "WheelSeparation=0.3");
        row("the same with a tread behind a flange",
            withHub("Cylinder tread { Radius=0.045 Length=0.015 HPR=0,0,90 Mass=0.05 } ",
                    {{"Length=0.03", "Length=0.01"}, {"WheelSeparation=0.3", "WheelSeparation=0.4"}}),
            apart, "WheelSeparation=0.3");
        row("tracks apart along x", crawler("0.1", "hull.l"), "the middles of its tracks are apart by 200 mm",
            "TrackSeparation=0.2");
        row("a track of two geoms", crawler("0.1", "hull.l,hull.b"), "");
        row("a wheel 18 mm farther out", changed(kit, {{"Part bl { Config=W", "Part bl { Config=W y=0.018"}}),
            "bl.wheel is 18 mm farther out than the other wheels of its side");
        row("a wheel 10 mm farther out", changed(kit, {{"Part bl { Config=W", "Part bl { Config=W y=0.01"}}), "");
        row("a left wheel farther in", changed(kit, {{"Part bl { Config=W", "Part bl { Config=W y=-0.05"}}),
            "bl.wheel is 50 mm farther in than the other wheels of its side");
        row("a right wheel farther in", changed(kit, {{"Part fr { Config=W", "Part fr { Config=W y=0.05"}}),
            "fr.wheel is 50 mm farther in than the other wheels of its side");
        row("two wheels of one side on the other",
            changed(kit, {{"fl { Config=W Pos=0.1,0.12", "fl { Config=W Pos=0.22,-0.12"},
                          {"ml { Config=W Pos=0,0.12", "ml { Config=W Pos=-0.22,-0.12"}}),
            "fl.wheel, which fl.motor turns, is on the right, but LeftMotors of base names it: its motion will be wrong");
        row("8 mm behind", changed(kBase, {{"Pos=0.05,-0.15", "Pos=0.042,-0.15"}}) + kRobot, "right is 8 mm behind left");
        row("8 mm ahead", changed(kBase, {{"Pos=0.05,-0.15", "Pos=0.058,-0.15"}}) + kRobot, "right is 8 mm ahead of left");
        row("4 mm behind", changed(kBase, {{"Pos=0.05,-0.15", "Pos=0.046,-0.15"}}) + kRobot, "");
        row("almost in one place", changed(kBase, {{"Pos=0.05,-0.15", "Pos=0.05,0.145"}}) + kRobot,
            "right is in the place of left; check its Pos and HPR");
    }
    void places() { check(); }

    void robots_data() {
        columns();
        const std::string kit = kKit + "Robot r { Config=Kit }\n";
        const std::string off = "WheelSeparation of base is 500 mm, but";
        const Changes half{{"WheelSeparation=0.24", "WheelSeparation=0.5"}};
        row("a robot of another config beside it", changed(kit, half) + "Robot a { Config=Crate Pos=3,0,0.1 }\n", off,
            "WheelSeparation=0.24");
        row("a robot with other values of the config", changed(kit, half) + "Robot s { Config=Kit Pos=2,0,0 fl.r=0.0501 }\n",
            off);
        row("a value of one robot alone",
            kKit + "Robot r { Config=Kit base.WheelSeparation=0.5 }\nRobot s { Config=Kit Pos=2,0,0 }\n", off,
            "WheelSeparation=0.24");
        row("a free wheel with an encoder", withTail("0.05", "  Encoder e { Joint=tailAxle CountsPerRevolution=100 }\n"),
            "tail of B is 10 mm above the ground when left touches it: it carries nothing");
        row("a free wheel 19 mm up", withTail("0.059", ""), "tail of B is 19 mm above the ground");
        row("a free wheel more than half of its radius up", withTail("0.062", ""), "");
        row("wheels above what touches the ground",
            changed(kBase, {{"Pos=0,0,0.08 Size", "Pos=0,0,0.03 Size"},
                            {kBall, ""},
                            {"0.15,0.05", "0.15,0.1"},
                            {"-0.15,0.05", "-0.15,0.1"}}) +
                kRobot,
            "left of B is 50 mm above the ground when hull touches it: its motor turns it in the air");
        row("a flag that does not collide, on motors without gears",
            changed(kBase, {{" GearRatio=30", ""},
                            {" GearRatio=30", ""},
                            {kBall, kBall + " Box flag { Size=2,0.01,0.01 Pos=0,0,0.3 Collide=false Mass=0.01 }"}}) +
                kRobot,
            "that is 30 m/s, 90.9 times the length of the robot in a second");
    }
    void robots() { check(); }
};

QTEST_APPLESS_MAIN(DriveEdgesTest)
#include "drive_edges_test.moc"
