// Assigning controllers to robots, as edits of the text.
#include "plan_fixture.h"
#include "project/edits/controllers.h"
#include "project/edits/module_lines.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kModules = "#loadModule walker\n#loadModule controllers/linear_motion\n";
const std::string kScene = "RobotConfig Cart { Body chassis { Box hull { Size=0.2,0.2,0.1 Mass=1 } } }\n"
                           "StaticConfig Wall { Box b { Size=1,1,1 } }\n";

} // namespace

class ControllersTest : public QObject {
    Q_OBJECT

    static const Kind& kindOf(const LoadedProject& loaded, const char* name) { return *loaded.registry->find(name); }

    PlanFixture m_fixture;

private Q_SLOTS:
    void listsRobotsAndTheirControllers() {
        const auto loaded = m_fixture.open(kModules + kScene +
                                           "Robot a { Config=Cart Walker brain { Speed=1 } }\nStatic w { Config=Wall }\n"
                                           "Robot a1 { Config=Cart }\nGrid g { Config=Cart Count=2,3 Spacing=9 }\n");
        const std::vector<ControlledRobot> robots = controlledRobots(*loaded);
        QCOMPARE(robots.size(), std::size_t(3));
        QCOMPARE(robots[0].path + " " + robots[0].kind + " " + robots[0].controller, std::string("a Walker brain"));
        QCOMPARE(robots[1].path + robots[1].kind + robots[1].controller, std::string("a1"));
        QCOMPARE(robots[2].members, std::size_t(6));
        QCOMPARE(robotsAmong(*loaded, {"a.chassis", "g_5", "w", "a", "g", "RobotConfig.Cart"}),
                 (std::vector<std::string>{"a", "g"}));
    }

    /// Each of several has a row, and is what its path names: for a new one in its place, or without it.
    void listsEachOfSeveral() {
        const auto loaded = m_fixture.open(kModules + kScene + "Robot a { Config=Cart\n  Walker legs { Speed=1 }\n  LinearMotion arm { }\n}\n");
        const std::vector<ControlledRobot> robots = controlledRobots(*loaded);
        QCOMPARE(robots.size(), std::size_t(2));
        QCOMPARE(robots[0].target() + " " + robots[0].kind, std::string("a.legs Walker"));
        QCOMPARE(robots[1].target() + " " + robots[1].kind, std::string("a.arm LinearMotion"));
        QCOMPARE(robotsAmong(*loaded, {"a.arm", "a.chassis", "a.legs"}), (std::vector<std::string>{"a.arm", "a", "a.legs"}));
        const auto after = [&](const Result<EditPlan>& plan) { return QString::fromStdString(m_fixture.text(loaded, plan)); };
        const QString assigned = after(planAssign(*loaded, {"a.arm"}, kindOf(*loaded, "Walker")));
        QVERIFY2(assigned.contains("Walker legs { Speed=1 }\n  Walker arm {"), qPrintable(assigned));
        const QString first = after(planAssign(*loaded, {"a"}, kindOf(*loaded, "LinearMotion")));
        QVERIFY2(first.contains("LinearMotion legs {") && first.contains("LinearMotion arm { }"), qPrintable(first));
        const QString left = after(planUnassign(*loaded, {"a.arm"}));
        QVERIFY2(left.contains("Walker legs") && !left.contains("arm"), qPrintable(left));
    }

    /// Robots in a Repeat of the world are one row, which members are found by; scenery in a Grid has none.
    void listsRobotsInARepeat() {
        const auto loaded = m_fixture.open(kModules + kScene +
                                           "Repeat row { Count=3 Pos=$(index),0,0 Robot cart { Config=Cart Walker brain { } } }\n"
                                           "Grid walls { Config=Wall Count=2 Spacing=9 }\n");
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const std::vector<ControlledRobot> robots = controlledRobots(*loaded);
        QCOMPARE(robots.size(), std::size_t(1));
        QCOMPARE(robots[0].path + " " + robots[0].kind, std::string("row.cart Walker"));
        QCOMPARE(robots[0].members, std::size_t(3));
        QCOMPARE(robotsAmong(*loaded, {"row_2.cart.chassis", "row.cart", "walls_0"}), (std::vector<std::string>{"row.cart"}));
        const auto after = [&](const Result<EditPlan>& plan) { return QString::fromStdString(m_fixture.text(loaded, plan)); };
        const QString assigned = after(planAssign(*loaded, {"row.cart"}, kindOf(*loaded, "LinearMotion")));
        QVERIFY2(assigned.contains("LinearMotion brain {"), qPrintable(assigned));
        const QString left = after(planUnassign(*loaded, {"row.cart"}));
        QVERIFY2(!left.contains("Walker"), qPrintable(left));
    }

    void choicesAreTheLoadedOnesThenThoseOfModules() {
        const auto loaded = m_fixture.open("#loadModule walker\n" + kScene);
        Kind shipped = kindOf(*loaded, "Walker");
        shipped.name = "Arc";
        shipped.module = "/program/controllers/libarc.so";
        Kind device = shipped;
        device.name = "NoController";
        device.role = Role::Device;
        const auto choices = controllerChoices(*loaded, {shipped, device, kindOf(*loaded, "Walker")}, "/program");
        QCOMPARE(choices.size(), std::size_t(2));
        QCOMPARE(choices[0].kind.name + ":" + choices[0].module, std::string("Walker:"));
        QCOMPARE(choices[1].kind.name + ":" + choices[1].module, std::string("Arc:controllers/arc"));
    }

    /// A new block in a robot without controller; a replaced one keeps its name and the values that both kinds have.
    void assigns() {
        const auto loaded =
            m_fixture.open(kModules + kScene +
                           "Robot a { Config=Cart Walker mind { Speed=1 } }\nRobot b {\n  Config=Cart\n}\n"
                           "Grid g { Config=Cart Count=2 Spacing=9 }\nRobot c { Config=Cart LinearMotion own { } }\n");
        const auto plan = planAssign(*loaded, {"g", "a", "b", "c"}, kindOf(*loaded, "LinearMotion"));
        QCOMPARE(
            m_fixture.text(loaded, plan),
            kModules + kScene +
                "Robot a { Config=Cart LinearMotion mind { Speed=1 } }\nRobot b {\n  Config=Cart\n  LinearMotion brain { }\n}\n"
                "Grid g { Config=Cart Count=2 Spacing=9 LinearMotion brain { } }\nRobot c { Config=Cart LinearMotion own { } "
                "}\n");
        QCOMPARE(plan.value().selects, (std::vector<std::string>{"g.brain", "a.mind", "b.brain"}));
        QVERIFY(!m_fixture.apply(loaded, plan)->diagnostics.hasErrors());
    }

    void refusesWhatHasNoController() {
        const auto loaded =
            m_fixture.open(kModules + kScene + "Robot a { Config=Cart Walker w { } }\nStatic w { Config=Wall }\n");
        const Kind& walker = kindOf(*loaded, "Walker");
        QCOMPARE(m_fixture.text(loaded, planAssign(*loaded, {}, walker)), "refused: no robot is selected");
        QCOMPARE(m_fixture.text(loaded, planAssign(*loaded, {"w"}, walker)), "refused: w is no robot");
        QCOMPARE(m_fixture.text(loaded, planAssign(*loaded, {"a"}, walker)), "refused: a has this controller already");
        QCOMPARE(m_fixture.text(loaded, planUnassign(*loaded, {"w"})), "refused: there is no controller to remove");
    }

    void removesControllers() {
        const auto loaded =
            m_fixture.open(kModules + kScene + "Robot a { Config=Cart Walker mind { Speed=1 } }\nRobot b { Config=Cart }\n");
        const auto plan = planUnassign(*loaded, {"a", "b"});
        QCOMPARE(m_fixture.text(loaded, plan), kModules + kScene + "Robot a { Config=Cart }\nRobot b { Config=Cart }\n");
        QCOMPARE(plan.value().selects, (std::vector<std::string>{"a", "b"}));
    }

    void loadsAndUnloadsModules() {
        const auto loaded = m_fixture.open("#loadModule walker\n" + kScene);
        QCOMPARE(m_fixture.text(loaded, planLoadModule(*loaded, "controllers/arc_motion")),
                 "#loadModule walker\n#loadModule controllers/arc_motion\n" + kScene);
        QCOMPARE(m_fixture.text(loaded, planLoadModule(*loaded, "walker")), "refused: the module walker is loaded already");
        QCOMPARE(m_fixture.text(loaded, planUnloadModule(*loaded, 0, "walker")), kScene);
        QCOMPARE(m_fixture.text(loaded, planUnloadModule(*loaded, 0, "walk")), "refused: no text loads walk");
        QCOMPARE(m_fixture.text(loaded, planUnloadModule(*loaded, 9, "walker")), "refused: no text loads walker");
    }
};

QTEST_APPLESS_MAIN(ControllersTest)
#include "controllers_test.moc"
