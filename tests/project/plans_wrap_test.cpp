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
  Param half = $(2 * r)
  Body leftWheel { // driven
    Pos=0,$half,$r
    Cylinder tyre { Radius=$r Length=0.02 Mass=0.1 Material=red Surface=floor }
  }
  Hinge leftAxle { Parent=$chassis Child=leftWheel Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=1 SpeedConstant=1 Resistance=2 MaxVoltage=12 } // strong
  TouchSensor leftTouch { Geom=leftWheel.tyre, $bumper }
}

// A robot.
RobotConfig Kit {
  Param r = 5 cm { Min=1 cm Max=20 cm Help="of the wheel" }
  Param half = $(2 * r)
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor }
    Box bumper { Size=0.1,0.2,0.1 Pos=0.2,0,0 Mass=1 Material=red Surface=floor }
  }
  Part left { Config=Left chassis=chassis bumper=chassis.bumper half=$half r=$r }
)";
const std::string kPartRest = R"(  Encoder count { Joint=left.leftAxle CountsPerRevolution=512 }
}

Robot a { Config=Kit left.leftWheel.tyre.Mass=0.2 }
SignalLog volts { Signals="a/left.leftMotor/voltage" }
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
        const std::string right = "  Part right { Config=Left chassis=chassis bumper=chassis.bumper half=$half r=$r Mirror=y }\n";
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
        const std::string wanted = kHead + "  Repeat lefts {\n    Count=3 Pos=$(0.1*index),0,0\n" + lines +
                                   "\n  }\n  Encoder count { Joint=lefts_0.leftAxle CountsPerRevolution=512 }\n}\n\n"
                                   "Robot a { Config=Kit lefts.leftWheel.tyre.Mass=0.2 }\n"
                                   "SignalLog volts { Signals=\"a/lefts_0.leftMotor/voltage\" }\n";
        QCOMPARE(QString::fromStdString(text), QString::fromStdString(wanted));
        checkClean(plan);
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
