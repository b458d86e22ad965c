// Parts pasted into another file, with their PartConfigs.
#include <QTest>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/edits/plan_copies.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kMaterials = "Material red { ColorRGB=1,0,0 }\nSurface floor { Friction=1 }\n";
const std::string kWheel = R"(PartConfig Wheel {
  Body wheel { Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 Material=red Surface=floor } }
  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
}
)";
const std::string kPart = "Part left { Config=Wheel Pos=0.06,0.125,0.05 carrier=chassis }\n";
const std::string kKit = R"(
// My robot.
RobotConfig Kit {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }
)";
const std::string kRest = R"(}

Robot a { Config=Kit }
)";

} // namespace

class PlansPasteTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The PartConfig and what that needs come before the config that uses them.
    void pastesAPart() {
        const std::string line = "  Part left { Config=Wheel Pos=0.06,0.125,0.05 carrier=chassis }\n";
        for (const char* place : {"RobotConfig.Kit", "a"}) {
            m_loaded = m_fixture.open(kMaterials + kKit + kRest);
            const auto plan = planInsert(*m_loaded, place, kWheel + kPart);
            QCOMPARE(QString::fromStdString(m_fixture.text(m_loaded, plan)),
                     QString::fromStdString(kMaterials + "\n" + kWheel + kKit + line + kRest));
            checkClean(plan);
            QCOMPARE(plan.value().selects.front(), std::string("PartConfig.Wheel"));
        }
    }

    /// Array Copy: behind the original, and the comments around that are written once.
    void copiesComeBehindTheirOriginals() {
        const std::string part = "  // the wheel\n  Part left { Config=Wheel Pos=0.06,0.125,0.05 carrier=chassis } // driven\n";
        const std::string imu = "\n  // measures\n  Imu imu { Body=chassis }\n";
        m_loaded = m_fixture.open(kMaterials + kWheel + kKit + part + imu + kRest);
        const auto plan = planCopies(*m_loaded, {"a.left"}, {{0.1, 0, 0}, {0.2, 0, 0}});
        QCOMPARE(QString::fromStdString(m_fixture.text(m_loaded, plan)),
                 QString::fromStdString(kMaterials + kWheel + kKit + part +
                                        "  Part left2 { Config=Wheel Pos=0.16,0.125,0.05 carrier=chassis }\n"
                                        "  Part left3 { Config=Wheel Pos=0.26,0.125,0.05 carrier=chassis }\n" +
                                        imu + kRest));
        checkClean(plan);
        QCOMPARE(plan.value().selects, (std::vector<std::string>{"a.left2", "a.left3"}));
    }

    /// A body and its joint: each copy of the joint has the copy of the body that was made with it.
    void copiesHoldTogether() {
        const std::string arm = "  Body arm { Box b { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } }\n"
                                "  Hinge elbow { Parent=chassis Child=arm Anchor=0,0,0.1 }\n";
        m_loaded = m_fixture.open(kMaterials + kKit + arm + kRest);
        const auto plan = planCopies(*m_loaded, {"a.arm", "a.elbow"}, {{0.5, 0, 0}, {1, 0, 0}});
        checkClean(plan);
        const std::string text = m_fixture.text(m_loaded, plan);
        const std::string joints = "  Hinge elbow { Parent=chassis Child=arm Anchor=0,0,0.1 }\n"
                                   "  Hinge elbow2 { Parent=chassis Child=arm2 Anchor=0.5,0,0.1 }\n"
                                   "  Hinge elbow3 { Parent=chassis Child=arm3 Anchor=1,0,0.1 }\n";
        QVERIFY2(text.find(joints) != std::string::npos, text.c_str());
    }

    /// Each end of a spring moves with its copy, also where a line gives only one of them.
    void bothEndsOfACopiedSpringMove() {
        const std::string arm = "  Body arm { Box b { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } }\n";
        const auto spring = [](const std::string& name, const std::string& child, const std::string& anchors) {
            return "  Spring " + name + " { Parent=chassis Child=" + child + anchors + " Stiffness=50 Damping=1 }\n";
        };
        m_loaded = m_fixture.open(kMaterials + kKit + arm + spring("strut", "arm", " Anchor=0.1,0,0.2 Anchor2=0.3,-0.1,0.4") +
                                  spring("cord", "arm", " Anchor2=0,0.25,0.5") + kRest);
        const auto plan = planCopies(*m_loaded, {"a.arm", "a.strut", "a.cord"}, {{0.5, 0.25, -1}, {-1, 0, 2}});
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        const std::string text = m_fixture.text(m_loaded, plan);
        for (const std::string& line :
             {spring("strut", "arm", " Anchor=0.1,0,0.2 Anchor2=0.3,-0.1,0.4"),
              spring("strut2", "arm2", " Anchor=0.6,0.25,-0.8 Anchor2=0.8,0.15,-0.6"),
              spring("strut3", "arm3", " Anchor=-0.9,0,2.2 Anchor2=-0.7,-0.1,2.4"),
              spring("cord2", "arm2", " Anchor2=0.5,0.5,-0.5"), spring("cord3", "arm3", " Anchor2=-1,0.25,2.5")})
            QVERIFY2(text.find(line) != std::string::npos, (line + text).c_str());
    }

    void pastesNestedParts() {
        const std::string pair = "PartConfig Pair {\n  Part one { Config=Wheel carrier=$base }\n  Part two { Config=Wheel "
                                 "Pos=0,0,1 carrier=$base }\n}\n";
        m_loaded = m_fixture.open(kMaterials + kKit + kRest);
        const auto plan = planInsert(*m_loaded, "a",
                                     "Param side = 0.1\n" + kWheel + pair + "Part p { Config=Pair base=chassis Pos=0,$side,0 }");
        checkClean(plan);
        const std::string text = m_fixture.text(m_loaded, plan);
        QVERIFY2(text.find("\nParam side = 0.1\n\n" + kWheel + "\n" + pair + "\n// My robot.\nRobotConfig Kit {") !=
                     std::string::npos,
                 text.c_str());
    }

    /// Into a config of another file than the opened one.
    void pastesIntoAnImportedConfig() {
        m_loaded =
            m_fixture.open({{"main.sim", "#import kit.sim\n\nRobot a { Config=Kit }\n"}, {"kit.sim", kMaterials + kKit + "}\n"}});
        const auto plan = planInsert(*m_loaded, "a", kWheel + kPart);
        checkClean(plan);
        const std::string text = m_fixture.text(m_loaded, plan, "kit.sim");
        QVERIFY2(text.find("\n" + kWheel + kKit) != std::string::npos, text.c_str());
    }

    /// The names that a Part gives must be there.
    void refusesWhatIsMissing() {
        const std::string other =
            "\nRobotConfig Kit {\n  Body frame { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }\n}\n";
        m_loaded = m_fixture.open(kMaterials + other + "Robot a { Config=Kit }\n");
        const auto plan = planInsert(*m_loaded, "a", kWheel + kPart);
        QVERIFY(!plan.ok());
        QVERIFY2(plan.error().message.find("chassis") != std::string::npos, plan.error().message.c_str());
        const std::string wrong =
            "PartConfig Wheel { Body b { Sphere s { Radius=$r Mass=1 Material=$colour Surface=floor } } }\n";
        const auto unknown = planInsert(*m_loaded, "a", wrong + "Part p { Config=Wheel }");
        QCOMPARE(unknown.ok() ? std::string() : unknown.error().message,
                 std::string("PartConfig Wheel uses $r, which is not here"));
    }

private:
    /// The text after a plan has neither errors nor hints, and formatting it changes nothing.
    void checkClean(const Result<EditPlan>& plan) {
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        const auto after = m_fixture.apply(m_loaded, plan);
        QCOMPARE(sample::messages(*after), std::string());
        for (const auto& tree : after->trees) QCOMPARE(format(*tree), std::string(tree->source().bytes()));
    }

    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(PlansPasteTest)
#include "plans_paste_test.moc"
