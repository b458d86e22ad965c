// Blocks become parts, their mirror images, or members of a Repeat: the text that is written, and what is refused.
#include <QTest>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/edits/plan_wrap.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kHead = R"(Material red { ColorRGB=1,0,0 }
Surface floor { Friction=1 }

// A robot.
RobotConfig Kit {
  Param r = 5 cm { Min=1 cm Max=20 cm Help="of the wheel" }
  Param half = $(2 * r)
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor }
    Box bumper { Size=0.1,0.2,0.1 Pos=0.2,0,0 Mass=1 Material=red Surface=floor }
  }
)";
const std::string kLeft = R"(  Body leftWheel { // driven
    Pos=0,$half,$r
    Cylinder tyre { Radius=$r Length=0.02 Mass=0.1 Material=red Surface=floor }
  }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=1 SpeedConstant=1 Resistance=2 MaxVoltage=12 } // strong
  TouchSensor leftTouch { Geom=leftWheel.tyre, chassis.bumper }
)";
const std::string kRest = R"(  Encoder count { Joint=leftAxle CountsPerRevolution=512 }
}

Robot a { Config=Kit leftWheel.tyre.Mass=0.2 }
SignalLog volts { Signals="a/leftMotor/voltage" }
)";
const std::vector<std::string> kLeftPaths{"RobotConfig.Kit.leftWheel", "RobotConfig.Kit.leftAxle", "RobotConfig.Kit.leftMotor",
                                          "RobotConfig.Kit.leftTouch"};

const std::string kPart = R"(Material red { ColorRGB=1,0,0 }
Surface floor { Friction=1 }

PartConfig Left {
  Param r = 5 cm { Min=1 cm Max=20 cm Help="of the wheel" }
  Body wheel { // driven
    Cylinder tyre { Radius=$r Length=0.02 Mass=0.1 Material=red Surface=floor }
  }
  Hinge axle { Parent=$chassis Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=1 SpeedConstant=1 Resistance=2 MaxVoltage=12 } // strong
  TouchSensor touch { Geom=wheel.tyre, $bumper }
}

// A robot.
RobotConfig Kit {
  Param r = 5 cm { Min=1 cm Max=20 cm Help="of the wheel" }
  Param half = $(2 * r)
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor }
    Box bumper { Size=0.1,0.2,0.1 Pos=0.2,0,0 Mass=1 Material=red Surface=floor }
  }
  Part left { Config=Left Pos=0,$half,$r chassis=chassis bumper=chassis.bumper r=$r }
)";
const std::string kPartRest = R"(  Encoder count { Joint=left.axle CountsPerRevolution=512 }
}

Robot a { Config=Kit left.wheel.tyre.Mass=0.2 }
SignalLog volts { Signals="a/left.motor/voltage" }
)";

} // namespace

class PlansWrapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open(kHead + kLeft + kRest);
        QVERIFY(m_loaded);
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
    }

    void makesAPart() {
        const auto plan = planMakePart(*m_loaded, kLeftPaths);
        const std::string text = m_fixture.text(m_loaded, plan);
        QVERIFY2(text == kPart + kPartRest, text.c_str());
        checkClean(plan);
        QCOMPARE(plan.value().selects, std::vector<std::string>{"RobotConfig.Kit.left"});
    }

    /// Blocks are mirrored as a part; a Part by another one with the same values.
    void mirrors() {
        const std::string right =
            "  Part right { Config=Left Pos=0,$(-half),$r chassis=chassis bumper=chassis.bumper r=$r Mirror=y }\n";
        const auto plan = planMirror(*m_loaded, kLeftPaths, 'y');
        QCOMPARE(QString::fromStdString(m_fixture.text(m_loaded, plan)), QString::fromStdString(kPart + right + kPartRest));
        checkClean(plan);
        m_loaded = m_fixture.open(kPart + kPartRest);
        const auto again = planMirror(*m_loaded, {"RobotConfig.Kit.left"}, 'y');
        QCOMPARE(QString::fromStdString(m_fixture.text(m_loaded, again)), QString::fromStdString(kPart + right + kPartRest));
        QCOMPARE(again.value().selects, std::vector<std::string>{"RobotConfig.Kit.right"});
    }

    void mirrorsPoses_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("axis");
        QTest::addColumn<QString>("image");
        const auto row = [](const char* text, const char* axis, const char* image) {
            QTest::newRow(text) << text << axis << image;
        };
        row("Pos=0.1,0.2,0.3 HPR=10,20,30", "y", "Pos=0.1,-0.2,0.3 HPR=-10,20,-30 Mirror=y");
        row("Pos=0.1,0.2,0.3 HPR=10,20,30", "x", "Pos=-0.1,0.2,0.3 HPR=-10,-20,30 Mirror=x");
        row("Pos=0.1,0.2,0.3 HPR=10,20,30", "z", "Pos=0.1,0.2,-0.3 HPR=10,-20,-30 Mirror=z");
        row("Pos=1 cm, -2 cm,0", "y", "Pos=1 cm, 2 cm,0 Mirror=y");
        row("Pos=0,$r,$(r + 1)", "y", "Pos=0,$(-r),$(r + 1) Mirror=y");
        row("Pos=0,$(-r),0", "y", "Pos=0,$r,0 Mirror=y");
        row("Pos=0,0,$(r + 1)", "z", "Pos=0,0,$(-(r + 1)) Mirror=z");
        row("Mirror=y Pos=0,1,0", "y", "Pos=0,-1,0");
        row("Mirror=x", "y", "it is mirrored already, along x; it can be mirrored along that axis only");
        row("Mirror=none", "y", "Mirror=y");
    }
    void mirrorsPoses() {
        QFETCH(QString, text);
        QFETCH(QString, axis);
        QFETCH(QString, image);
        const std::string part = "PartConfig Arm { Body b { Box b { Size=1,2,3 Mass=1 Material=red Surface=floor } } Fixed f { "
                                 "Parent=$base Child=b } }\n";
        const std::string kit = kHead + "  Part leftArm { Config=Arm base=chassis " + text.toStdString() + " }\n}\n";
        m_loaded = m_fixture.open(part + kit);
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
        const auto plan = planMirror(*m_loaded, {"RobotConfig.Kit.leftArm"}, axis.toStdString()[0]);
        if (!plan.ok()) {
            QCOMPARE(QString::fromStdString(plan.error().message), image);
            return;
        }
        const std::string after = m_fixture.text(m_loaded, plan);
        const std::string wanted = "  Part rightArm { Config=Arm base=chassis " + image.toStdString() + " }\n";
        QVERIFY2(after.find(wanted) != std::string::npos, after.c_str());
        checkClean(plan);
    }

    void repeats() {
        const auto plan = planRepeat(*m_loaded, kLeftPaths, 3, {0.1, 0, 0});
        const std::string text = m_fixture.text(m_loaded, plan);
        std::string lines;
        for (const char c : "  " + kLeft.substr(0, kLeft.size() - 1)) lines += c == '\n' ? "\n  " : std::string(1, c);
        const std::string wanted = kHead + "  Repeat left {\n    Count=3 Pos=$(0.1*index),0,0\n" + lines +
                                   "\n  }\n  Encoder count { Joint=left_0.leftAxle CountsPerRevolution=512 }\n}\n\n"
                                   "Robot a { Config=Kit left.leftWheel.tyre.Mass=0.2 }\n"
                                   "SignalLog volts { Signals=\"a/left_0.leftMotor/voltage\" }\n";
        QCOMPARE(QString::fromStdString(text), QString::fromStdString(wanted));
        checkClean(plan);
    }

    /// Robots and scenery, with what names them and what is between them.
    void repeatsAtTheTopLevel() {
        const std::string kit = kitWith({}, {}), config = kit.substr(0, kit.find("Robot a"));
        const auto loaded = m_fixture.open(config + R"(
// pulls
Robot a { Config=Kit Pos=0,1,0 } // in front
Robot b { Config=Kit Pos=-2,1,0 }
Fixed hitch { Parent=a.chassis Child=b.chassis }

Robot c { Config=Kit Pos=0,-3,0 }
PoseLog path { Robot=b File=path.csv }
)");
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const auto plan = planRepeat(*loaded, {"b", "a", "hitch"}, 2, {0, 7, 0});
        QCOMPARE(m_fixture.text(loaded, plan), config + R"(
Repeat a {
  Count=2 Pos=0,$(7*index),0
  // pulls
  Robot a { Config=Kit Pos=0,1,0 } // in front
  Robot b { Config=Kit Pos=-2,1,0 }
  Fixed hitch { Parent=a.chassis Child=b.chassis }
}

Robot c { Config=Kit Pos=0,-3,0 }
PoseLog path { Robot=a_0.b File=path.csv }
)");
        const auto after = m_fixture.apply(loaded, plan);
        QVERIFY2(!after->diagnostics.hasErrors(), sample::messages(*after).c_str());
        QCOMPARE(after->experiment->robots.size(), std::size_t{5});
        QCOMPARE(plan.value().selects, std::vector<std::string>{"a"});
        const auto message = [&](const std::vector<std::string>& paths) {
            const auto refused = planRepeat(*loaded, paths, 2, Vec3::Zero());
            return refused.ok() ? std::string() : refused.error().message;
        };
        QCOMPARE(message({"Material.red"}), std::string("a Material is allowed at the top level, not in a Repeat"));
        QCOMPARE(message({"a", "RobotConfig.Kit.chassis"}),
                 std::string("select blocks of one config: Robot a is at the top level, Body chassis is in RobotConfig Kit"));
    }

    /// Blocks that count from one body outside give their In to what is around them; everything stays where it is.
    void takesIn_data() {
        QTest::addColumn<QString>("chassis");
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QStringList>("texts");
        const auto row = [](const char* what, const char* chassis, const char* blocks, const QStringList& texts) {
            QTest::newRow(what) << chassis << blocks << texts;
        };
        const char* const turned = "Pos=0.1,0,0.2 HPR=90,0,0";
        const char* const mast = "Body mast { In=chassis Pos=0,0,0.3 HPR=0,20,0 Box b { Pos=0,1,0 Size=0.1,0.1,1 Mass=1 "
                                 "Material=red Surface=floor } }";
        row("a body", turned, mast, {"In=chassis", "HPR=0,20,0 Box"});
        row("its fixture", turned,
            "Body mast { In=chassis Box b { Pos=0,1,0 Size=0.1,0.1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Fixed foot { Parent=chassis Child=mast }",
            {"In=chassis"});
        row("an axis that is turned", turned,
            "Body mast { In=chassis Pos=1,0,0 Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Hinge foot { Parent=chassis Child=mast Axis=0,1,0 Anchor=0.1,1 m,0.5 }\n  RotaryMotor m { Joint=foot "
            "TorqueConstant=1 "
            "SpeedConstant=1 Resistance=2 MaxVoltage=12 }",
            {"Axis=1,0,0 Anchor=1,0,0.3"});
        row("default axes", turned,
            "Body mast {\n    In=chassis\n    Pos=1,0,0\n    Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor }\n  "
            "}\n"
            "  Universal foot { Parent=chassis Child=mast Axis=1,0,0 Axis2=0,1,0 }\n  Slider more { Parent=chassis Child=other "
            "}\n"
            "  Body other { In=chassis Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }",
            {"Axis=0,-1,0 Axis2=1,0,0", "Body mast {\n"});
        row("expressions are shifted", "Pos=0,0,0.2",
            "Body mast { In=chassis Pos=$r,0,0 Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Hinge foot { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,$r }",
            {"Axis=0,1,0 Anchor=0,0,$(r - 0.2)"});
        row("the body's place is a Param, the axis is not", "Pos=0,0,$r",
            "Body mast { In=chassis Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Hinge foot { Parent=chassis Child=mast Axis=0,1,0 }",
            {"Axis=0,1,0"});
        row("a chain of bodies", turned,
            "Body mast { In=chassis Pos=1,0,0 Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Body tip { In=mast Pos=0,1,0 HPR=0,30,0 Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Spring s { Parent=mast Child=tip Anchor=1,1,0 Anchor2=1,2,0 Stiffness=1 }",
            {"Body tip { In=mast", "Anchor=1,-0.9,-0.2 Anchor2=2,-0.9,-0.2"});
        row("a Repeat", turned,
            "Repeat row { In=chassis Count=2 Pos=$index,0,0 Body b { Box b { Pos=0,1,0 Size=1,1,1 Mass=1 Material=red "
            "Surface=floor } } "
            "Hinge h { Parent=chassis Child=b Axis=0,1,0 Anchor=0,0,1 } }",
            {"Repeat row { Count=2", "Axis=0,1,0 Anchor=0,0,1"});
    }
    void takesIn() {
        QFETCH(QString, chassis);
        QFETCH(QString, blocks);
        QFETCH(QStringList, texts);
        m_loaded = m_fixture.open(kitWith(chassis, blocks));
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
        const std::vector<std::string> paths = pathsOf();
        for (const auto& plan :
             {planMakePart(*m_loaded, paths), planMirror(*m_loaded, paths, 'y'), planRepeat(*m_loaded, paths, 1, {0, 0, 0})}) {
            checkClean(plan);
            const QString text = QString::fromStdString(m_fixture.text(m_loaded, plan));
            for (const QString& part : texts) QVERIFY2(text.contains(part), qPrintable(text));
            checkSamePoses(*m_fixture.apply(m_loaded, plan));
        }
    }

    /// A Part gets the place of its first body, where the text shows it.
    void takesThePlace_data() {
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QStringList>("texts");
        const char* const shape = "Box b { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } }\n  ";
        const auto row = [&](const char* what, const QString& blocks, const QStringList& texts) {
            QTest::newRow(what) << QString(blocks).replace("SHAPE", shape) << texts;
        };
        row("units and formulas", "Body foot { Pos=10 cm,$(2*r),$(-r) HPR=0,0,90 SHAPE",
            {"Body foot { HPR=0,0,90 Box", "Part foot { Config=Foot Pos=10 cm,$(2*r),$(-r) }"});
        row("bodies and anchors count from the first one",
            "Body fork { Pos=0.3,0.1,0.2 SHAPE Body wheel { Pos=0.25,0.1,0.05 SHAPE"
            "Hinge turn { Parent=arm Child=fork Axis=0,0,1 } Hinge roll { Parent=fork Child=wheel Anchor=0.25,0.1,0.05 }",
            {"Body fork { Box", "Body wheel { Pos=-0.05,0,-0.15 Box", "Anchor=-0.05,0,-0.15", "Pos=0.3,0.1,0.2 arm=arm }"});
        row("what counts from the first body keeps its numbers",
            "Body fork { Pos=0.3,0.1,0.2 SHAPE Body wheel { In=fork Pos=0.7,0,0 SHAPE Hinge roll { Parent=fork Child=wheel }",
            {"Body wheel { In=fork Pos=0.7,0,0 Box", "Pos=0.3,0.1,0.2 }"});
        row("its own sensor", "Body fork { Pos=0.3,0.1,0.2 SHAPE Imu imu { Body=fork Pos=0.1,0,0 }",
            {"Imu imu { Body=fork Pos=0.1,0,0 }", "Pos=0.3,0.1,0.2 }"});
        row("a sensor of another body", "Body fork { Pos=0.3,0.1,0.2 SHAPE Imu imu { Body=arm Pos=0.1,0,0 }",
            {"Body fork { Pos=0.3,0.1,0.2 Box"});
        row("formulas of several",
            "Body fork { Pos=$r,0,0 SHAPE Body wheel { Pos=0.3,0,0 SHAPE Hinge a { Parent=fork Child=wheel }",
            {"Body fork { Pos=$r,0,0 Box", "Body wheel { Pos=0.3,0,0 Box"});
        row("digits that a difference does not have",
            "Body fork { Pos=0.1234567890123,0,0 SHAPE Body wheel { Pos=0.3,0,0 SHAPE Hinge a { Parent=fork Child=wheel }",
            {"Body fork { Pos=0.1234567890123,0,0 Box", "Body wheel { Pos=0.3,0,0 Box"});
        row("a Part in it", "Body fork { Pos=0.3,0.1,0.2 SHAPE Repeat row { Count=2 Body wheel { Pos=0.25,0.1,0.05 SHAPE }",
            {"Body fork { Pos=0.3,0.1,0.2 Box"});
    }
    void takesThePlace() {
        QFETCH(QString, blocks);
        QFETCH(QStringList, texts);
        m_loaded = m_fixture.open(kitWith("", blocks));
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
        const auto plan = planMakePart(*m_loaded, pathsOf());
        checkClean(plan);
        const QString text = QString::fromStdString(m_fixture.text(m_loaded, plan));
        for (const QString& part : texts) QVERIFY2(text.contains(part), qPrintable(text));
        checkSamePoses(*m_fixture.apply(m_loaded, plan), blocks.contains("wheel") ? 1e-15 : 0);
    }
    /// An override that sets the place of the body still sets it.
    void leavesThePlaceToOverrides() {
        m_loaded = m_fixture.open(kHead + kLeft + "}\nRobot a { Config=Kit leftWheel.Pos=0,0.2,0.05 }\n");
        const auto plan = planMakePart(*m_loaded, kLeftPaths);
        checkClean(plan);
        const std::string text = m_fixture.text(m_loaded, plan);
        QVERIFY2(text.find("    Pos=0,$half,$r\n") != std::string::npos, text.c_str());
        QVERIFY2(text.find("Robot a { Config=Kit left.wheel.Pos=0,0.2,0.05 }") != std::string::npos, text.c_str());
    }

    void refusesSeveralFrames_data() {
        QTest::addColumn<QString>("chassis");
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QString>("why");
        const QString box = " Box b { Size=1,1,1 Mass=1 Material=red Surface=floor } }\n";
        const QString mast = "Body mast { In=chassis" + box;
        QTest::newRow("none")
            << "Pos=0,0,1" << mast + "  Body pole { Pos=1,0,0" + box
            << "Body pole counts from RobotConfig Kit, Body mast from chassis; give both the same In, or select one of them";
        QTest::newRow("another") << "Pos=0,0,1" << mast + "  Body pole { In=arm" + box
                                 << "Body pole counts from arm, Body mast from chassis; select what counts from one body";
        QTest::newRow("Param")
            << "Pos=0,0,$r" << mast + "  Hinge h { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,1 }"
            << "Anchor of Hinge h counts from RobotConfig Kit and would count from chassis, whose pose depends on "
               "Params; select it without Hinge h";
        QTest::newRow("turned")
            << "HPR=90,0,0" << mast + "  Hinge h { Parent=chassis Child=mast Axis=0,1,0 Anchor=0,0,$r }"
            << "Anchor of Hinge h counts from RobotConfig Kit and would count from chassis, which is turned; write "
               "it as three numbers first";
    }
    void refusesSeveralFrames() {
        QFETCH(QString, chassis);
        QFETCH(QString, blocks);
        QFETCH(QString, why);
        m_loaded = m_fixture.open(kitWith(chassis, blocks));
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
        for (const auto& plan : {planMakePart(*m_loaded, pathsOf()), planRepeat(*m_loaded, pathsOf(), 2, {1, 0, 0})}) {
            QVERIFY(!plan.ok());
            QCOMPARE(QString::fromStdString(plan.error().message), why);
        }
    }

    void refuses() {
        const auto message = [](const Result<EditPlan>& plan) { return plan.ok() ? std::string() : plan.error().message; };
        QCOMPARE(message(planMakePart(*m_loaded, {"a"})),
                 std::string("Robot a is not directly in a config; select bodies, joints and devices of one"));
        QCOMPARE(message(planMakePart(*m_loaded, {"RobotConfig.Kit.chassis.hull"})),
                 std::string("Box hull is not directly in a config; select bodies, joints and devices of one"));
        QCOMPARE(message(planMakePart(*m_loaded, {})), std::string("nothing is selected"));
        QCOMPARE(message(planRepeat(*m_loaded, kLeftPaths, 0, {0, 0, 0})), std::string("a Repeat has from 1 to 200000 members"));
    }

private:
    /// The blocks behind the first two bodies of a config.
    static std::string kitWith(const QString& chassis, const QString& blocks) {
        return "Material red { ColorRGB=1,0,0 }\nSurface floor { Friction=1 }\nRobotConfig Kit {\n  Param r = 5 cm\n  Body "
               "chassis { " +
               chassis.toStdString() +
               " Box hull { Size=1,1,1 Mass=2 Material=red Surface=floor } }\n  Body arm { Pos=5,0,0 Box b { Size=1,1,1 Mass=2 "
               "Material=red Surface=floor } }\n  " +
               blocks.trimmed().toStdString() + "\n}\nRobot a { Config=Kit }\n";
    }
    std::vector<std::string> pathsOf() const {
        std::vector<std::string> paths;
        const Part& kit = *m_loaded->outline->configs.find("Kit");
        for (std::size_t i = 2; i < kit.parts.size(); ++i) paths.push_back("RobotConfig.Kit." + kit.parts[i].name);
        return paths;
    }
    /// All bodies and joints of the robot are in the other one too, under longer names.
    void checkSamePoses(const LoadedProject& after, double within = 1e-9) const {
        const RobotConfigSpec &was = *m_loaded->experiment->robots.at(0).config, &is = *after.experiment->robots.at(0).config;
        const auto find = [](const auto& all, const std::string& name) {
            return std::ranges::find_if(all, [&](const auto& one) { return one.name == name || one.name.ends_with("." + name); });
        };
        for (const BodySpec& body : was.bodies) {
            const auto same = find(is.bodies, body.name);
            QVERIFY2(same != is.bodies.end(), body.name.c_str());
            QVERIFY2((same->pose.position - body.pose.position).norm() <= within, body.name.c_str());
            QVERIFY2(same->pose.rotation.angularDistance(body.pose.rotation) < 1e-7, body.name.c_str());
        }
        for (const JointSpec& joint : was.joints) {
            const auto same = find(is.joints, joint.name);
            QVERIFY2(same != is.joints.end(), joint.name.c_str());
            const bool hasTwo = joint.type == JointType::Universal || joint.type == JointType::Suspension;
            const bool hasAxis = joint.type != JointType::Fixed && joint.type != JointType::Ball;
            QVERIFY2((same->anchor - joint.anchor).norm() <= within, joint.name.c_str());
            QVERIFY2(!hasAxis || (same->axis - joint.axis).norm() < 1e-9, joint.name.c_str());
            QVERIFY2(!hasTwo || (same->axis2 - joint.axis2).norm() < 1e-9, joint.name.c_str());
        }
        for (const SpringSpec& spring : was.springs) {
            const auto same = find(is.springs, spring.name);
            QVERIFY2(same != is.springs.end(), spring.name.c_str());
            QVERIFY((same->anchor - spring.anchor).norm() < 1e-9 && (same->anchor2 - spring.anchor2).norm() < 1e-9);
        }
    }
    /// The text after a plan has no errors, and formatting it changes nothing.
    void checkClean(const Result<EditPlan>& plan) {
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(!after->diagnostics.hasErrors(), sample::rendered(*after).c_str());
        const Tree& tree = *after->trees[0];
        QCOMPARE(format(tree), std::string(tree.source().bytes()));
        for (const std::string& path : plan.value().selects) QVERIFY2(placeOf(*after, path), path.c_str());
    }

    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(PlansWrapTest)
#include "plans_wrap_test.moc"
