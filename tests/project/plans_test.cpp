// Renaming, removing, duplicating, overriding: each case is a text before and after.
#include <QTest>

#include "plan_fixture.h"
#include "project/edits/plan_dependents.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

/// One object of each kind that refers to others.
const char* const kScene = R"(// all names
#loadModule walker
#loadModule controllers/linear_motion
Param look = red
Material red { ColorRGB=1,0,0 }  // red
Material blue { ColorRGB=0,0,1 }
Surface rubber { Friction=1 }
RobotConfig Cart {
  Param width = 0.3
  Param paint = red
  Body chassis { Box hull { Size=$width,$(width/2),0.1 Pos=0,0,0.1 Mass=2 Material=$look Surface=rubber }
    Box { Size=0.1,0.1,0.1 Material=$paint } }
  Body left { Pos=0,$(width/2),0.05  Sphere tyre { Radius=0.05 Mass=0.1 Material="red" } }
  Body right { Pos=0,$(-width/2),0.05  Sphere tyre { Radius=0.05 Mass=0.1 } }
  Hinge leftAxle { Parent=chassis Child=left Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=1 BackEmfConstant=1 Resistance=2 MaxVoltage=12 }
  RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=1 BackEmfConstant=1 Resistance=2 MaxVoltage=12 }
  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=$width }
  TouchSensor frontTouch { Geom=chassis.hull,chassis.box }
}
Robot robot0 { Config=Cart leftMotor.Resistance=3 chassis.hull.Mass=4 paint=blue LinearMotion brain { Drive=base } }
Robot robot1 { Config=Cart Pos=2,0,0 width=0.4 LinearMotion brain { } }
Grid swarm { Config=Cart Count=2 Spacing=3 Pos=0,8,0 }
PoseLog where { Robot=robot0,swarm }
SignalLog what { Signals=robot0/leftMotor/voltage,robot0/brain/way,"swarm_*/leftAxle/position","robot?/left/pose" }
)";

std::string with(std::string text, std::initializer_list<std::pair<const char*, const char*>> changes) {
    for (const auto& [from, to] : changes)
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + std::strlen(to)))
            text.replace(at, std::strlen(from), to);
    return text;
}

} // namespace

class PlansTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void renames_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("selects");
        const auto row = [](const char* what, const char* path, const char* name, const char* selects,
                            std::initializer_list<std::pair<const char*, const char*>> changes) {
            QTest::newRow(what) << path << name << QString::fromStdString(with(kScene, changes)) << selects;
        };
        row("material, by Params too", "Material.red", "pink", "Material.pink",
            {{"= red", "= pink"}, {"Material red", "Material pink"}, {"\"red\"", "\"pink\""}});
        row("material set by an instance", "Material.blue", "navy", "Material.navy",
            {{"Material blue", "Material navy"}, {"paint=blue", "paint=navy"}});
        row("surface", "Surface.rubber", "gum", "Surface.gum", {{"rubber", "gum"}});
        row("config", "RobotConfig.Cart", "Wagon", "RobotConfig.Wagon", {{"Cart", "Wagon"}});
        row("body", "robot0.chassis", "frame", "robot0.frame", {{"chassis", "frame"}});
        row("body in signals", "RobotConfig.Cart.left", "links", "RobotConfig.Cart.links",
            {{"Body left ", "Body links "}, {"Child=left ", "Child=links "}, {"/left/", "/links/"}});
        row("geom", "robot1.chassis.hull", "shell", "robot1.chassis.shell", {{"hull", "shell"}});
        row("joint", "RobotConfig.Cart.leftAxle", "axleL", "RobotConfig.Cart.axleL", {{"leftAxle", "axleL"}});
        row("motor", "RobotConfig.Cart.leftMotor", "m1", "RobotConfig.Cart.m1",
            {{"=leftMotor", "=m1"}, {" leftMotor", " m1"}, {"/leftMotor", "/m1"}});
        row("unnamed geom", "RobotConfig.Cart.chassis.box", "lid", "RobotConfig.Cart.chassis.lid",
            {{"Box {", "Box lid {"}, {"chassis.box", "chassis.lid"}});
        row("robot", "robot0", "alpha", "alpha", {{"robot0", "alpha"}});
        row("grid", "swarm", "flock", "flock", {{"swarm", "flock"}});
        row("controller", "robot0.brain", "mind", "robot0.mind",
            {{"brain { Drive", "mind { Drive"}, {"robot0/brain/", "robot0/mind/"}});
        row("what a controller finds by default", "RobotConfig.Cart.base", "drive", "RobotConfig.Cart.drive",
            {{"Drive base", "Drive drive"}, {"Drive=base", "Drive=drive"}, {"brain { }", "brain { Drive=drive }"}});
        row("Param", "RobotConfig.Cart.width", "w", "", {{"width", "w"}});
        row("Param, through an instance", "robot1.width", "w", "", {{"width", "w"}});
        row("global Param", "look", "finish", "", {{"look", "finish"}});
        row("log", "where", "there", "there", {{"PoseLog where", "PoseLog there"}});
    }
    void renames() {
        QFETCH(QString, path);
        QFETCH(QString, name);
        QFETCH(QString, after);
        QFETCH(QString, selects);
        const auto loaded = m_fixture.open(kScene);
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const auto plan = planRename(*loaded, path.toStdString(), name.toStdString());
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, plan)), after);
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
        QCOMPARE(plan.value().selects.empty() ? QString() : QString::fromStdString(plan.value().selects[0]), selects);
        if (!selects.isEmpty()) QVERIFY(placeOf(*again, selects.toStdString()));
    }

    void refusedNames_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("why");
        QTest::newRow("taken") << "robot0"
                               << "robot1"
                               << "the name robot1 is taken by Robot robot1";
        QTest::newRow("of another kind") << "robot0"
                                         << "where"
                                         << "the name where is taken by PoseLog where";
        QTest::newRow("member") << "robot0"
                                << "swarm_1"
                                << "the name swarm_1 is taken by a member of Grid swarm";
        QTest::newRow("in the config") << "robot0.chassis"
                                       << "leftAxle"
                                       << "the name leftAxle is taken by Hinge leftAxle";
        QTest::newRow("a Param's") << "robot0.chassis"
                                   << "width"
                                   << "the name width is taken by Param width";
        QTest::newRow("an unnamed one's") << "robot0.chassis.hull"
                                          << "box"
                                          << "the name box is taken by Box";
        QTest::newRow("empty") << "robot0"
                               << ""
                               << "a name is missing";
        QTest::newRow("digit") << "robot0"
                               << "0robot"
                               << "`0robot` cannot be a name: only A-Z a-z 0-9 and _, and no digit at the beginning";
        QTest::newRow("blank") << "robot0"
                               << "my robot"
                               << "`my robot` cannot be a name: only A-Z a-z 0-9 and _, and no digit at the beginning";
        QTest::newRow("reserved") << "robot0"
                                  << "world"
                                  << "`world` is reserved and cannot be a name";
        QTest::newRow("default") << "Material.red"
                                 << "default"
                                 << "the name default is taken by the built-in default";
        QTest::newRow("a kind") << "robot0"
                                << "Material"
                                << "the name Material is taken by a kind of block";
        QTest::newRow("nothing") << "robot7"
                                 << "x"
                                 << "there is no robot7";
        QTest::newRow("experiment") << ""
                                    << "x"
                                    << "the experiment has no name";
        QTest::newRow("a member") << "swarm_0"
                                  << "x"
                                  << "swarm_0 is a member of Grid swarm and has no name of its own";
        QTest::newRow("Param pi") << "look"
                                  << "pi"
                                  << "the name pi is taken by the number pi";
        QTest::newRow("Param Pos") << "robot0.width"
                                   << "Pos"
                                   << "the name Pos is taken by a property of Grid";
        QTest::newRow("Param as part") << "robot0.width"
                                       << "base"
                                       << "the name base is taken by DifferentialDrive base";
        QTest::newRow("Param hidden") << "look"
                                      << "width"
                                      << "the name width is taken by another Param";
    }
    void refusedNames() {
        QFETCH(QString, path);
        QFETCH(QString, name);
        QFETCH(QString, why);
        const auto loaded = m_fixture.open(kScene);
        const auto plan = planRename(*loaded, path.toStdString(), name.toStdString());
        QVERIFY(!plan.ok());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }

    /// The config is in one file and used in another.
    void acrossFiles() {
        const auto loaded = m_fixture.open(std::map<std::string, std::string>{
            {"main.sim", "#import a/cart.sim\nRobot r { Config=Cart body.Mass=3 }\n"},
            {"a/cart.sim", "#import looks.sim\nRobotConfig Cart { Body body { Mass=1 Box b { Size=1,1,1 Material=red } } }\n"},
            {"a/looks.sim", "Material red { ColorRGB=1,0,0 }\n"}});
        auto plan = planRename(*loaded, "r.body", "hull");
        QCOMPARE(m_fixture.text(loaded, plan), "#import a/cart.sim\nRobot r { Config=Cart hull.Mass=3 }\n");
        QCOMPARE(m_fixture.text(loaded, plan, "a/cart.sim"),
                 "#import looks.sim\nRobotConfig Cart { Body hull { Mass=1 Box b { Size=1,1,1 Material=red } } }\n");
        plan = planRename(*loaded, "Material.red", "rot");
        QCOMPARE(plan.value().edits.size(), 2u);
        QVERIFY(!m_fixture.apply(loaded, plan)->diagnostics.hasErrors());
    }

    void removes_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("after");
        QTest::newRow("a line") << "Material a { }\nMaterial b { } // b\nMaterial c { }\n"
                                << QStringList{"Material.a"} << "Material b { } // b\nMaterial c { }\n";
        QTest::newRow("all of a line") << "Tick=0.01\nMaterial a { } Material b { }\r\nMaterial c { }\n"
                                       << QStringList{"Material.b", "Material.a"} << "Tick=0.01\nMaterial c { }\n";
        QTest::newRow("first and third") << "Material a { } Material b { } Material c { }\n"
                                         << QStringList{"Material.a", "Material.c"} << "Material b { }\n";
        QTest::newRow("with those that use it") << "Material a { }\nStaticConfig C { Box x { Size=1,1,1 Material=a } }\n"
                                                << QStringList{"StaticConfig.C.x", "Material.a"} << "StaticConfig C { }\n";
        QTest::newRow("inside another") << "StaticConfig C { Box x { Size=1,1,1 } }\n"
                                        << QStringList{"StaticConfig.C.x", "StaticConfig.C"} << "";
        QTest::newRow("the last name keeps")
            << "#loadModule walker\nRobotConfig C { Body b { Mass=1 Box { Size=1,1,1 } Box { Size=2,1,1 } } TouchSensor t { "
               "Geom=b.box2 } }\n"
            << QStringList{"RobotConfig.C.b.box"}
            << "#loadModule walker\nRobotConfig C { Body b { Mass=1 Box box2 { Size=2,1,1 } } TouchSensor t { Geom=b.box2 } }\n";
    }
    void removes() {
        QFETCH(QString, text);
        QFETCH(QStringList, paths);
        QFETCH(QString, after);
        const auto loaded = m_fixture.open(text.toStdString());
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, planRemove(*loaded, all))), after);
    }

    void refusedRemovals_data() {
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("why");
        QTest::newRow("material") << QStringList{"Material.red"}
                                  << "Material red is still used by Box hull (Material), Box (Material), Sphere tyre (Material)";
        QTest::newRow("motor") << QStringList{"robot0.leftMotor"}
                               << "RotaryMotor leftMotor is still used by DifferentialDrive base (LeftMotor), Robot robot0 "
                                  "(leftMotor.Resistance)";
        QTest::newRow("drive by name") << QStringList{"robot0.base"}
                                       << "DifferentialDrive base is still used by LinearMotion brain (Drive)";
        QTest::newRow("member")
            << QStringList{"swarm_0"}
            << "swarm_0 is a member of Grid swarm and has no text of its own; replace that by single robots first";
        QTest::newRow("experiment") << QStringList{""} << "the experiment itself is no block";
        QTest::newRow("nothing") << QStringList{} << "nothing is selected";
        QTest::newRow("not there") << QStringList{"robot0.chassis", "blob"} << "there is no blob";
        QTest::newRow("body") << QStringList{"robot0.left", "robot0.leftAxle"}
                              << "Hinge leftAxle is still used by RotaryMotor leftMotor (Joint)";
    }
    void refusedRemovals() {
        QFETCH(QStringList, paths);
        QFETCH(QString, why);
        const auto loaded = m_fixture.open(kScene);
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        const auto plan = planRemove(*loaded, all);
        QVERIFY(!plan.ok());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }

    void listsRemovableDependents_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QStringList>("users");
        QTest::newRow("robot in lists with others") << "robot0" << QStringList{};
        QTest::newRow("drive") << "robot0.base" << QStringList{"robot0.brain"};
        QTest::newRow("right axle, and what hangs on it")
            << "robot1.rightAxle" << QStringList{"RobotConfig.Cart.rightMotor", "RobotConfig.Cart.base", "robot0.brain"};
        QTest::newRow("config") << "RobotConfig.Cart" << QStringList{"robot0", "robot1", "swarm", "where"};
        QTest::newRow("nobody uses it") << "robot1" << QStringList{};
        QTest::newRow("a shape stays without its material") << "Material.red" << QStringList{};
        QTest::newRow("a robot stays without its override") << "robot0.leftMotor" << QStringList{};
        QTest::newRow("not there") << "blob" << QStringList{};
    }
    void listsRemovableDependents() {
        QFETCH(QString, path);
        QFETCH(QStringList, users);
        const auto loaded = m_fixture.open(kScene);
        std::vector<std::string> all{path.toStdString()};
        QStringList found;
        for (const std::string& user : dependentsOf(*loaded, all).removed) {
            found.append(QString::fromStdString(user));
            all.push_back(user);
        }
        found.sort();
        users.sort();
        QCOMPARE(found, users);
        if (!users.isEmpty()) QVERIFY(planRemove(*loaded, all).ok());
    }

    void doubles_data() {
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::newRow("robot") << QStringList{"robot1"}
                               << "Robot robot1 { Config=Cart Pos=2,0,0 width=0.4 LinearMotion brain { } }\n"
                               << "Robot robot1 { Config=Cart Pos=2,0,0 width=0.4 LinearMotion brain { } }\n"
                                  "Robot robot2 { Config=Cart Pos=3,0.5,0 width=0.4 LinearMotion brain { } }\n";
        QTest::newRow("no Pos, many keys")
            << QStringList{"robot0"} << "LinearMotion brain { Drive=base } }\n"
            << "LinearMotion brain { Drive=base } }\nRobot robot2 { Config=Cart leftMotor.Resistance=3 chassis.hull.Mass=4 "
               "paint=blue Pos=1,0.5,0 LinearMotion brain { Drive=base } }\n";
        QTest::newRow("formula") << QStringList{"robot0.left"} << "Material=\"red\" } }\n"
                                 << "Material=\"red\" } }\n  Body left2 { Pos=1,$((width/2) + 0.5),0.05  Sphere tyre { "
                                    "Radius=0.05 Mass=0.1 Material=\"red\" } }\n";
        QTest::newRow("comment stays with its line") << QStringList{"Material.red"} << "// red\n"
                                                     << "// red\nMaterial red2 { ColorRGB=1,0,0 }\n";
        QTest::newRow("in one line") << QStringList{"robot0.right.tyre"}
                                     << "  Body right { Pos=0,$(-width/2),0.05  Sphere tyre { Radius=0.05 Mass=0.1 } }"
                                     << "  Body right { Pos=0,$(-width/2),0.05  Sphere tyre { Radius=0.05 Mass=0.1 } Sphere "
                                        "tyre2 { Radius=0.05 Mass=0.1 Pos=1,0.5,0 } }";
        QTest::newRow("joint with its body")
            << QStringList{"robot0.right", "robot0.rightAxle"} << "  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }\n"
            << "  Hinge rightAxle { Parent=chassis Child=right Axis=0,1,0 }\n  Hinge rightAxle2 { Parent=chassis Child=right2 "
               "Axis=0,1,0 }\n";
    }
    void doubles() {
        QFETCH(QStringList, paths);
        QFETCH(QString, from);
        QFETCH(QString, to);
        const auto loaded = m_fixture.open(kScene);
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        const auto plan = planDuplicate(*loaded, all, Vec3(1, 0.5, 0));
        const QString text = QString::fromStdString(m_fixture.text(loaded, plan));
        QVERIFY2(text.contains(to), qPrintable(text));
        QVERIFY(QString(kScene).contains(from));
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
        QCOMPARE(plan.value().selects.size(), all.size());
        for (const std::string& path : plan.value().selects) QVERIFY2(placeOf(*again, path), path.c_str());
    }

    void unitsStayWhenDoubled() {
        const auto loaded =
            m_fixture.open("StaticConfig C { Box b { Size=1,1,1 Pos = 10 cm, 5mm , 1 } }\nStatic a { Config=C }\n");
        QCOMPARE(m_fixture.text(loaded, planDuplicate(*loaded, {"a.b"}, Vec3(0.1, 0.2, 0))),
                 "StaticConfig C { Box b { Size=1,1,1 Pos = 10 cm, 5mm , 1 } Box b2 { Size=1,1,1 Pos = 20 cm, 205mm , 1 } "
                 "}\nStatic a { Config=C }\n");
    }

    void overrides() {
        const auto loaded = m_fixture.open(kScene);
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot0.leftMotor.Resistance"})),
                 with(kScene, {{" leftMotor.Resistance=3", ""}}));
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot0.leftMotor.Resistance", "robot1.leftMotor.Resistance",
                                                            "robot0.chassis.hull.Mass", "robot0.paint"})),
                 with(kScene, {{" leftMotor.Resistance=3 chassis.hull.Mass=4 paint=blue", ""}}));
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot1.Pos", "RobotConfig.Cart.left.Pos"})),
                 with(kScene, {{"Pos=2,0,0 ", ""}, {"{ Pos=0,$(width/2),0.05  S", "{  S"}}));
        QCOMPARE(m_fixture.text(loaded, planPushOverride(*loaded, "robot0.leftMotor.Resistance")),
                 with(kScene, {{" leftMotor.Resistance=3", ""},
                               {"Joint=leftAxle TorqueConstant=1 BackEmfConstant=1 Resistance=2",
                                "Joint=leftAxle TorqueConstant=1 BackEmfConstant=1 Resistance=3"}}));
        QCOMPARE(m_fixture.text(loaded, planPushOverride(*loaded, "robot1.width")),
                 with(kScene, {{" width=0.4", ""}, {"width = 0.3", "width = 0.4"}}));
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot1.leftMotor.Resistance")),
                 with(kScene, {{"width=0.4 LinearMotion brain { }", "width=0.4 leftMotor.Resistance=2 LinearMotion brain { }"}}));
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot1.left.Pos")),
                 with(kScene, {{"width=0.4 LinearMotion brain { }", "width=0.4 left.Pos=0,0.2,0.05 LinearMotion brain { }"}}));
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot0.leftMotor.GearRatio")),
                 with(kScene, {{"paint=blue LinearMotion", "paint=blue leftMotor.GearRatio=1 LinearMotion"}}));
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "swarm_1.paint")),
                 with(kScene, {{"Pos=0,8,0 }", "Pos=0,8,0 paint=red }"}}));
    }

    void refusedOverrides() {
        const auto loaded = m_fixture.open(kScene);
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot0.Config"})),
                 "refused: Config of Robot robot0 must be given, it has no default");
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot1.leftMotor.Resistance"})),
                 "refused: Resistance has no value of its own in Robot robot1");
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"Duration"})), "refused: Duration has its default already");
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"RobotConfig.Cart.leftMotor.BackEmfConstant"})),
                 "refused: BackEmfConstant of RotaryMotor leftMotor must be given, it has no default");
        QCOMPARE(m_fixture.text(loaded, planReset(*loaded, {"robot0.Wheels"})), "refused: there is no property robot0.Wheels");
        QCOMPARE(m_fixture.text(loaded, planPushOverride(*loaded, "robot1.leftMotor.Resistance")),
                 "refused: robot1.leftMotor.Resistance is no override: there is nothing to be moved into a config");
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot0.leftMotor.Resistance")),
                 "refused: Resistance is set in Robot robot0 already");
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot0.Pos")), "refused: robot0.Pos comes from no config");
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "robot0.leftAxle.LowStop")),
                 "refused: LowStop has no value that could be copied");
    }

    void anOverrideHasTheLineEndsOfItsFile() {
        const std::string cart = "RobotConfig Cart {\r\n  Body b { Box hull { Size=1,\r\n    2,3 } }\r\n}\r\n";
        const auto loaded = m_fixture.open({{"main.sim", "#import cart.sim\nRobot r { Config=Cart }\n"}, {"cart.sim", cart}});
        QCOMPARE(m_fixture.text(loaded, planPullOverride(*loaded, "r.b.hull.Size")),
                 "#import cart.sim\nRobot r { Config=Cart b.hull.Size=1,\n    2,3 }\n");
    }

    void singles() {
        const auto loaded = m_fixture.open(with(kScene, {{"Grid swarm", "\r\n  Grid swarm"}}));
        const auto plan = planReplaceBySingles(*loaded, "swarm_1");
        const std::string text = m_fixture.text(loaded, plan);
        QVERIFY2(text.find("  Robot swarm_0 { Pos=-1.5,8,0 HPR=0,0,0 Config=Cart }") != std::string::npos, text.c_str());
        QVERIFY(!m_fixture.apply(loaded, plan)->diagnostics.hasErrors());
        QCOMPARE(plan.value().selects, (std::vector<std::string>{"swarm_0", "swarm_1"}));
        QCOMPARE(m_fixture.text(loaded, planReplaceBySingles(*loaded, "robot0")), "refused: robot0 is no Grid or Scatter");
    }

    void textsToCopy() {
        const auto loaded = m_fixture.open(kScene);
        QCOMPARE(textOf(*loaded, {"where", "Material.blue", "where", "nothing"}),
                 "Material blue { ColorRGB=0,0,1 }\nPoseLog where { Robot=robot0,swarm }\n");
        QCOMPARE(textOf(*loaded, {"robot0.chassis.box", "robot0.chassis"}),
                 "Body chassis { Box hull { Size=$width,$(width/2),0.1 Pos=0,0,0.1 Mass=2 Material=$look Surface=rubber }\n  Box "
                 "{ Size=0.1,0.1,0.1 Material=$paint } }\n");
        QCOMPARE(textOf(*loaded, {}), "");
    }

    void freeNames() {
        const auto loaded = m_fixture.open(kScene);
        QCOMPARE(freeName(*loaded, "", "robot0"), "robot2");
        QCOMPARE(freeName(*loaded, "", "red"), "red2");
        QCOMPARE(freeName(*loaded, "", "swarm_0"), "swarm2");
        QCOMPARE(freeName(*loaded, "robot0.chassis", "box"), "box2");
        QCOMPARE(freeName(*loaded, "robot0", "width"), "width2");
        QCOMPARE(freeName(*loaded, "", "3 D robot"), "_3_D_robot");
        QCOMPARE(freeName(*loaded, "", ""), "_");
        QCOMPARE(freeName(*loaded, "nowhere", "x"), "x");
    }

    void shippedDefinitionsGoWithTheirImport() {
        PlanFixture fixture;
        fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
        const auto removed = [&](const std::string& text, const char* path) {
            return fixture.text(fixture.open(text), planRemove(*fixture.open(text), {path}));
        };
        const std::string import = "#import robots/evbot.sim\n", rest = "Material mine { ColorRGB=1,0,0 }\n";
        QCOMPARE(removed(import + rest, "RobotConfig.EvBot"), rest);
        QCOMPARE(removed(import + rest + "Robot r { Config=EvBot }\n", "RobotConfig.EvBot"),
                 "refused: RobotConfig EvBot is still used by Robot r (Config)");
        const std::string own = "StaticConfig A { Box b { Size=1,1,1 Material=black } }\n";
        QCOMPARE(removed(import + own, "RobotConfig.EvBot"), "#import common/materials.sim\n" + own);
        QVERIFY(
            removed(import + own, "Material.green").starts_with("refused: Material green is read-only, it came with Trundle"));
    }

    /// A file imported by two configs is kept when either is removed.
    void sharedPieceIsNotExclusive() {
        PlanFixture fixture;
        const auto loaded = fixture.open(
            {{"main.sim", "RobotConfig A {\n  #import piece.sim\n  Body c { Box { Size=1,1,1 Mass=1 } }\n}\nRobotConfig B { "
                          "#import piece.sim\n"
                          "Hinge j { Parent=base Child=arm } }\nRobot a { Config=A base.hull.Mass=9 }\nRobot b { Config=B "
                          "base.hull.Mass=2 }\n"},
             {"piece.sim", "Body base { Box hull { Size=1,1,1 Mass=1 } }\nBody arm { Pos=1,0,0 Box { Size=1,1,1 Mass=1 } }\n"}});
        QCOMPARE(fixture.text(loaded, planRemove(*loaded, {"RobotConfig.B", "b"})),
                 "RobotConfig A {\n  #import piece.sim\n  Body c { Box { Size=1,1,1 Mass=1 } }\n}\nRobot a { Config=A "
                 "base.hull.Mass=9 }\n");
        QCOMPARE(fixture.text(loaded, planRemove(*loaded, {"RobotConfig.B"})),
                 "refused: RobotConfig B is still used by Robot b (Config)");
    }

private:
    PlanFixture m_fixture;
};

QTEST_APPLESS_MAIN(PlansTest)
#include "plans_test.moc"
