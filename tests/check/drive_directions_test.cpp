// Wheels that turn the wrong way: each fault is reported once, with its cause, and its fix, where there is one, removes it. Such a robot,
// run, moves as the message says.
#include "check/check_fixture.h"
#include "project/wizard/robot_text.h"

using namespace fixture;

namespace {

const std::string kRover = R"(
RobotConfig Rover {
  Body chassis { Pos=0,0,0.08 Box hull { Size=0.3,0.2,0.06 Mass=2 } Sphere caster { Pos=-0.12,0,-0.05 Radius=0.03 Mass=0.1 } }
  Body leftWheel { Pos=0.1,0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Body rightWheel { Pos=0.1,-0.15,0.05 Cylinder tyre { Radius=0.05 Length=0.03 Mass=0.2 HPR=0,0,90 } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  RotaryMotor rightMotor { Joint=rightAxle MaxVoltage=12 Resistance=2 TorqueConstant=0.05 BackEmfConstant=0.05 }
  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.3 }
}
)";

QString made(BaseShape base) {
    const RobotDesign design = usualDesign(base);
    return QString::fromStdString(robotText(design, chooseMotor(design).value()));
}

} // namespace

class DriveDirectionsTest : public QObject {
    Q_OBJECT
    CheckFixture m_fixture;

    void add(const char* name, QString text, const std::vector<std::pair<const char*, const char*>>& changes, const char* said,
             const char* place, bool fix) {
        for (const auto& [from, to] : changes) {
            QVERIFY2(text.contains(QLatin1String(from)), from);
            text.replace(QLatin1String(from), QLatin1String(to));
        }
        QTest::newRow(name) << text << said << place << fix;
    }

private Q_SLOTS:
    void faults_data() {
        QTest::addColumn<QString>("config"); ///< Rover
        QTest::addColumn<QString>("said");   ///< text of the message; empty: nothing is reported
        QTest::addColumn<QString>("place");
        QTest::addColumn<bool>("fix");
        const QString rover = QString::fromStdString(kRover);
        add("as it should be", rover, {}, "", "", false);
        add("motors of the other sides", rover,
            {{"LeftMotor=leftMotor RightMotor=rightMotor", "LeftMotor=rightMotor RightMotor=leftMotor"}},
            "rightWheel, which rightMotor turns, is on the right, but LeftMotor of base names it: its motion will be wrong; swap "
            "LeftMotor and RightMotor",
            "rightMotor", true);
        add("one axis reversed", rover, {{"Child=leftWheel Axis=0,1,0", "Child=leftWheel Axis=0,-1,0"}},
            "leftAxle, the axle of leftWheel, points the other way than that of rightWheel: at one speed of both, base turns the "
            "robot instead of driving it; reverse the axis of leftAxle",
            "leftAxle", true);
        add("the other axis reversed", rover, {{"Child=rightWheel Axis=0,1,0", "Child=rightWheel Axis=0,-1,0"}},
            "rightAxle, the axle of rightWheel, points the other way than that of leftWheel", "rightAxle", true);
        add("both axes reversed", rover, {{"Axis=0,1,0", "Axis=0,-1,0"}},
            "the axles of leftWheel and rightWheel point to the right: base drives backwards at a positive speed, and turns the "
            "other way; reverse their axes",
            "leftAxle", true);
        add("built to drive to the back", rover,
            {{"Axis=0,1,0", "Axis=0,-1,0"},
             {"LeftMotor=leftMotor RightMotor=rightMotor", "LeftMotor=rightMotor RightMotor=leftMotor"}},
            "", "", false);
        add("the chassis as the child", rover,
            {{"Parent=chassis Child=leftWheel Axis=0,1,0", "Parent=leftWheel Child=chassis Anchor=0.1,0.15,0.05 Axis=0,-1,0"},
             {"Parent=chassis Child=rightWheel Axis=0,1,0", "Parent=rightWheel Child=chassis Anchor=0.1,-0.15,0.05 Axis=0,-1,0"}},
            "", "", false);
        add("the chassis as the child of one, reversed", rover,
            {{"Parent=chassis Child=leftWheel Axis=0,1,0", "Parent=leftWheel Child=chassis Anchor=0.1,0.15,0.05 Axis=0,1,0"}},
            "leftAxle, the axle of leftWheel, points the other way than that of rightWheel", "leftAxle", true);
        add("an axle ahead", rover, {{"Child=leftWheel Axis=0,1,0", "Child=leftWheel Axis=1,0,0"}},
            "leftAxle, which leftMotor of base turns, is not along the axis of leftWheel's tyre: the wheel does not roll; its "
            "axis is "
            "that of Axis=0,1,0",
            "leftAxle", true);
        add("an axle without an Axis", rover, {{"Child=rightWheel Axis=0,1,0", "Child=rightWheel"}}, "Axis=0,1,0", "rightAxle",
            true);
        add("a sprung axle upright", rover,
            {{"Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0",
              "Suspension leftAxle { Parent=chassis Child=leftWheel Axis2=1,0,0 Stiffness=2000 Damping=50 Travel=0.02"}},
            "its axis is that of Axis2=0,1,0", "leftAxle", true);
        add("both wheels in one place", rover, {{"Pos=0.1,-0.15,0.05", "Pos=0.1,0.15,0.05"}},
            "rightWheel of Rover is in the place of leftWheel, which has the same shapes; check its Pos and HPR, or those of its "
            "Part",
            "rightWheel", false);
        add("a strut whose axes are exchanged", rover,
            {{"Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0",
              "Suspension leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 Axis2=0,0,1 Stiffness=2000 Damping=50 "
              "Travel=0.02"}},
            "Axis and Axis2 of leftAxle are exchanged: along Axis it springs, about Axis2 leftWheel rolls", "leftAxle", true);
        add("a tyre that lies flat", rover, {{"Mass=0.2 HPR=0,0,90 } }\n  Body rightWheel", "Mass=0.2 } }\n  Body rightWheel"}},
            "tyre of leftWheel lies flat, across its axle leftAxle: the wheel does not roll; a Cylinder is along z, and HPR "
            "turns it: "
            "HPR=0,0,90",
            "tyre", true);
        add("axles that are not in line", rover, {{"Pos=0.1,-0.15,0.05", "Pos=0.08,-0.15,0.05"}},
            "rightWheel is 20 mm behind leftWheel: their axles are not in line", "rightWheel", false);
        add("a motor of a tenth of the voltage", rover, {{"Joint=rightAxle MaxVoltage=12", "Joint=rightAxle MaxVoltage=1.2"}},
            "rightMotor of base turns at up to 24 rad/s with up to 0.03 N m, leftMotor at up to 240 rad/s with up to 0.3 N m: "
            "its "
            "MaxVoltage is 1.2, that of leftMotor 12",
            "rightMotor", false);
        add("two encoders on one joint", rover,
            {{"  DifferentialDrive", "  Encoder one { Joint=leftAxle CountsPerRevolution=100 }\n  Encoder two { Joint=leftAxle "
                                     "CountsPerRevolution=100 }\n  DifferentialDrive"}},
            "two and one count the same joint, leftAxle, and no encoder counts rightAxle, which rightMotor turns", "leftAxle",
            false);
        add("an axle beside its wheel", rover,
            {{"Child=leftWheel Axis=0,1,0", "Child=leftWheel Anchor=0.1,0.15,0.09 Axis=0,1,0"}},
            "leftAxle, the axle of leftWheel, is 40 mm beside the middle of its tyre: it turns out of round", "leftAxle", false);
        add("both wheels on the left", rover, {{"Pos=0.1,-0.15,0.05", "Pos=-0.02,0.15,0.05"}},
            "rightWheel is as far to the side as leftWheel: base cannot turn the robot; check the sign of its Pos", "rightWheel",
            false);

        const QString skid = made(BaseShape::SkidSteer), omni = made(BaseShape::Omni), mecanum = made(BaseShape::Mecanum),
                      car = made(BaseShape::Ackermann);
        add("skid-steered as it should be", skid, {}, "", "", false);
        add("skid-steered from the other sides", skid,
            {{" LeftMotors=", " Xs="}, {"RightMotors=", "LeftMotors="}, {" Xs=", " RightMotors="}},
            "is on the right, but LeftMotors of base names it", "frontRight.motor,backRight.motor", true);
        add("skid-steered wheels exchanged", skid,
            {{"LeftMotors=frontLeft.motor,backLeft.motor", "LeftMotors=frontLeft.motor,backRight.motor"},
             {"RightMotors=frontRight.motor,backRight.motor", "RightMotors=frontRight.motor,backLeft.motor"}},
            "backRight.wheel, which backRight.motor turns, is on the right, but LeftMotors of base names it: its motion will be "
            "wrong; swap backRight.motor and backLeft.motor",
            "backRight.motor", true);
        add("skid-steered wheel turned around", skid,
            {{"$(-wheelBase/2),$(wheelSeparation/2),$wheelRadius",
              "$(-wheelBase/2),$(wheelSeparation/2),$wheelRadius HPR=180,0,0"}},
            "backLeft.axle, the axle of backLeft.wheel, points the other way than that of frontLeft.wheel", "axle", false);
        add("omni as it should be", omni, {}, "", "", false);
        add("omni wheels elsewhere", omni, {{"HPR=60,0,0", "HPR=45,0,0"}},
            "base, which has no WheelAngles, takes left.wheel for a wheel at 60 degrees, but it is at 45: base will move askew; "
            "WheelAngles=45,180,300 are its angles",
            "base", false);
        add("omni wheels elsewhere than said", omni, {{"OmniDrive base {", "OmniDrive base { WheelAngles=60,180,-75"}},
            "WheelAngles of base takes right.wheel for a wheel at -75 degrees, but it is at 300", "60,180,-75", true);
        add("omni wheels as said", omni, {{"OmniDrive base {", "OmniDrive base { WheelAngles=60,180,-60"}}, "", "", false);
        add("omni wheels outwards", omni, {{"Axis=-1,0,0", "Axis=1,0,0"}},
            "left.axle, the axle of left.wheel, points away from the middle: base turns its wheel the wrong way (and 2 more like "
            "it)",
            "axle", false);
        add("mecanum as it should be", mecanum, {}, "", "", false);
        add("mecanum front and back", mecanum,
            {{"FrontLeftMotor=frontLeft.motor FrontRightMotor=frontRight.motor",
              "FrontLeftMotor=backLeft.motor FrontRightMotor=backRight.motor"},
             {"BackLeftMotor=backLeft.motor BackRightMotor=backRight.motor",
              "BackLeftMotor=frontLeft.motor BackRightMotor=frontRight.motor"}},
            "the wheels that the front motors of base turn are at the back", "backLeft.motor", false);
        add("mecanum front and back of one side", mecanum,
            {{"FrontLeftMotor=frontLeft.motor", "FrontLeftMotor=backLeft.motor"},
             {"BackLeftMotor=backLeft.motor", "BackLeftMotor=frontLeft.motor"}},
            "backLeft.wheel, which backLeft.motor turns, is at the back, but FrontLeftMotor of base names it: its motion will be "
            "wrong; swap backLeft.motor and frontLeft.motor",
            "backLeft.motor", true);
        add("mecanum rollers all alike", mecanum, {{" Mirror=y", ""}},
            "the rollers of frontRight.wheel lie across those that base needs there: the FrictionHeading of its Surface is -45 "
            "degrees, not 45",
            "tyre", false);
        add("a car as it should be", car, {}, "", "", false);
        add("a car steered about axes that point down", car, {{"Axis=0,0,1", "Axis=0,0,-1"}},
            "frontLeft.pivot points down: base steers its wheel to the other side; reverse its axis", "pivot", false);
        add("a car steered from the other sides", car,
            {{"LeftSteering=frontLeft.steering RightSteering=frontRight.steering",
              "LeftSteering=frontRight.steering RightSteering=frontLeft.steering"}},
            "the wheel that frontRight.steering steers is on the right, but LeftSteering of base names it", "frontRight.steering",
            true);
    }
    void faults() {
        QFETCH(QString, config);
        QFETCH(QString, said);
        QFETCH(QString, place);
        QFETCH(bool, fix);
        const auto loaded = m_fixture.open(kThings + config.toStdString() + "Robot r { Config=Rover }\n");
        QVERIFY(loaded);
        const Diagnostics found = CheckFixture::check(*loaded);
        const std::string story = CheckFixture::shown(*loaded, found);
        QCOMPARE(found.all().size(), said.isEmpty() ? std::size_t(0) : std::size_t(1));
        QVERIFY2(!loaded->diagnostics.hasErrors(), story.c_str());
        if (said.isEmpty()) return;
        const Diagnostic& warning = found.all()[0];
        QVERIFY2(QString::fromStdString(warning.message).contains(said), story.c_str());
        const std::string_view at = loaded->sources.slice(warning.range);
        QCOMPARE(QString::fromUtf8(at.data(), qsizetype(at.size())), place);
        QVERIFY2(fix == !warning.fixes.empty(), story.c_str());
        if (!fix) return;
        const std::string repaired = CheckFixture::applied(*loaded, warning.fixes[0]);
        const auto again = m_fixture.open(repaired);
        const Diagnostics after = CheckFixture::check(*again);
        QVERIFY2(!again->diagnostics.hasErrors() && after.all().empty(), (repaired + CheckFixture::shown(*again, after)).c_str());
    }
};

QTEST_APPLESS_MAIN(DriveDirectionsTest)
#include "drive_directions_test.moc"
