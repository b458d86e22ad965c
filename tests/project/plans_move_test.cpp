// Moves blocks: their order in the text, and their pose in the world. Removes names of removed blocks from lists.
#include <QTest>

#include "plan_fixture.h"
#include "project/edits/plan_dependents.h"
#include "project/objects/part_values.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kCart = R"(RobotConfig Cart {
  Param r = 0.1
  Body chassis { Pos=1,0,0 HPR=90,0,0
    Box hull { Size=1,1,1 Mass=1 Pos=0.5,0,0.2 HPR=0,0,30 }
    Sphere { Radius=$r Mass=1 } // ball
  }
  Body wheel { Pos=0,2,0 HPR=30,40,50
    Sphere tyre { Radius=0.1 Mass=1 }
  }
  Hinge axle { Parent=chassis Child=wheel }
  TouchSensor touch { Geom=chassis.hull }
}
)";

std::string scene(const std::string& more) { return kCart + more; }

/// World pose of a geom.
Pose worldPose(const LoadedProject& loaded, const std::string& robot, const std::string& body, const std::string& geom) {
    for (const RobotSpec& r : loaded.experiment->robots) {
        if (r.name != robot) continue;
        for (const BodySpec& b : r.config->bodies)
            for (const GeomSpec& g : b.geoms)
                if (b.name == body && g.name == geom) return r.pose * b.pose * g.pose;
    }
    for (const StaticSpec& s : loaded.experiment->statics)
        for (const GeomSpec& g : *s.geoms)
            if (s.name == robot && g.name == geom) return s.pose * g.pose;
    return {Vec3(1e9, 0, 0), Quat::Identity()};
}

} // namespace

class PlansMoveTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void order_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("beside");
        QTest::addColumn<QString>("after");
        QTest::newRow("up") << "Material a { }\n// b's\nMaterial b { }\nMaterial c { } // c\n"
                            << QStringList{"Material.b"} << ""
                            << "Material.a"
                            << "Material b { }\nMaterial a { }\n// b's\nMaterial c { } // c\n";
        QTest::newRow("to the end") << "Material a { }\nMaterial b { }\n"
                                    << QStringList{"Material.a"} << ""
                                    << ""
                                    << "Material b { }\nMaterial a { }\n";
        QTest::newRow("where it is") << "Material a { }\nMaterial b { }\n"
                                     << QStringList{"Material.a"} << ""
                                     << "Material.b"
                                     << "Material a { }\nMaterial b { }\n";
        QTest::newRow("before itself") << "Material a { }\nMaterial b { }\n"
                                       << QStringList{"Material.a"} << ""
                                       << "Material.a"
                                       << "Material a { }\nMaterial b { }\n";
        QTest::newRow("last is last") << "Material a { }\nMaterial b { }\n"
                                      << QStringList{"Material.b"} << ""
                                      << ""
                                      << "Material a { }\nMaterial b { }\n";
        QTest::newRow("two up") << "Material a { }\nMaterial b { }\nMaterial c { }\n"
                                << QStringList{"Material.c", "Material.b"} << ""
                                << "Material.a"
                                << "Material b { }\nMaterial c { }\nMaterial a { }\n";
        QTest::newRow("in one line") << "StaticConfig S { Box a { Size=1,1,1 } Box b { Size=2,1,1 } Box c { Size=3,1,1 } }"
                                     << QStringList{"StaticConfig.S.c"} << "StaticConfig.S"
                                     << "StaticConfig.S.b"
                                     << "StaticConfig S { Box a { Size=1,1,1 } Box c { Size=3,1,1 } Box b { Size=2,1,1 } }";
        QTest::newRow("CRLF and tabs")
            << "StaticConfig S {\r\n\tBox a {\r\n\t\tSize=1,1,1\r\n\t}\r\n\tBox b { Size=2,1,1 }\r\n}\r\n"
            << QStringList{"StaticConfig.S.a"} << "StaticConfig.S"
            << ""
            << "StaticConfig S {\r\n\tBox b { Size=2,1,1 }\r\n\tBox a {\r\n\t\tSize=1,1,1\r\n\t}\r\n}\r\n";
    }
    void order() {
        QFETCH(QString, before);
        QFETCH(QStringList, paths);
        QFETCH(QString, parent);
        QFETCH(QString, beside);
        QFETCH(QString, after);
        const auto loaded = m_fixture.open(before.toStdString());
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        const auto plan = planMove(*loaded, all, parent.toStdString(), beside.toStdString());
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, plan)), after);
        QCOMPARE(plan.value().selects.size(), all.size());
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
        for (const std::string& path : plan.value().selects) QVERIFY2(placeOf(*again, path), path.c_str());
    }

    /// A reordered block stays in its file, whatever its neighbours; it moves to another file only if one is given.
    void filesOfTheOrder() {
        const std::string one =
            "Surface ice { Friction=0 }\nSurface tar { Friction=2 } // black\nMaterial red { ColorRGB=1,0,0 }\n";
        const std::string two = "#import one.sim\nSurface own { Friction=1 }\nRobotConfig Cart { }\nRobot r { Config=Cart }\n";
        const auto loaded = m_fixture.open({{"main.sim", two}, {"one.sim", one}});
        const auto one_ = [&](const Result<EditPlan>& plan) { return m_fixture.text(loaded, plan, "one.sim"); };
        const std::string turned =
            "Surface tar { Friction=2 } // black\nSurface ice { Friction=0 }\nMaterial red { ColorRGB=1,0,0 }\n";
        for (const char* before : {"", "Surface.own"}) { // after the last one of its file, and after the last one of all
            const auto plan = planMove(*loaded, {"Surface.ice"}, "", before);
            QCOMPARE(one_(plan), turned);
            QCOMPARE(m_fixture.text(loaded, plan), two);
        }
        QCOMPARE(one_(planMove(*loaded, {"Surface.tar"}, "", "Surface.ice")), // its comment moves with it
                 "Surface tar { Friction=2 } // black\nSurface ice { Friction=0 }\nMaterial red { ColorRGB=1,0,0 }\n");
        const auto same = planMove(*loaded, {"Surface.tar"}, "", "Surface.own");
        QVERIFY(same.ok() && same.value().edits.empty());
        const auto own = planMove(*loaded, {"Surface.own"}, "", "Surface.ice"); // its own file has no other surface
        QVERIFY(own.ok() && own.value().edits.empty());

        const auto there = planMove(*loaded, {"Surface.own"}, "", "", 1);
        QCOMPARE(one_(there), one + "Surface own { Friction=1 }\n");
        QCOMPARE(m_fixture.text(loaded, there), "#import one.sim\nRobotConfig Cart { }\nRobot r { Config=Cart }\n");
        QCOMPARE(one_(planMove(*loaded, {"Surface.own"}, "", "Surface.tar", 1)),
                 "Surface ice { Friction=0 }\nSurface own { Friction=1 }\nSurface tar { Friction=2 } // black\n"
                 "Material red { ColorRGB=1,0,0 }\n");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"Surface.tar"}, "", "", 0)),
                 two + "Surface tar { Friction=2 } // black\n");
    }

    /// The target file stays readable by itself, and is never made to import a file that imports it.
    void importsDependenciesOfMoved() {
        const std::string main = "#import one.sim\n#import floor.sim\nParam far = 2\n";
        const std::string floor = "#import two.sim\nParam side = 1\nMaterial red { ColorRGB=1,0,0 }\nStaticConfig Floor { "
                                  "Box slab { Size=$side,1,0.1 } }\n";
        const auto moved = [&](const std::string& block, const std::string& path, FileId file) {
            const auto loaded =
                m_fixture.open({{"main.sim", main + block}, {"one.sim", "Seed=1\n"}, {"floor.sim", floor}, {"two.sim", ""}});
            const auto plan = planMove(*loaded, {path}, "", "", file);
            const auto again = m_fixture.apply(loaded, plan);
            const std::string texts = m_fixture.text(loaded, plan, "one.sim") + "|" + m_fixture.text(loaded, plan, "two.sim");
            return again && !again->diagnostics.hasErrors() ? texts : texts + " " + sample::messages(*again);
        };
        const std::string wall = "Static wall { Config=Floor }\n", box = "StaticConfig B { Box b { Size=1,1,1 Material=red } }\n";
        QCOMPARE(moved(wall, "wall", 1), "#import floor.sim\nSeed=1\n" + wall + "|");
        QCOMPARE(moved(box, "StaticConfig.B", 1), "#import floor.sim\nSeed=1\n" + box + "|");
        const std::string post = "Static post { Config=Floor Pos=$side,0,0 }\n";
        QCOMPARE(moved(post, "post", 1), "#import floor.sim\nSeed=1\n" + post + "|");
        const std::string own = "StaticConfig Own { Box b { Size=$far,1,1 } }\n";
        QCOMPARE(moved(own, "StaticConfig.Own", 1), "Seed=1\n" + own + "|"); // depends on the opened file
        QCOMPARE(moved(wall, "wall", 3), "Seed=1\n|" + wall);
    }

    /// No pose in the config keeps the world pose for all of its robots.
    void refusesToLosePoseOfOneRobot() {
        const auto refused = [&](const char* robots, const char* path = "r.chassis.hull", const char* to = "r.wheel") {
            const auto loaded = m_fixture.open(scene(robots));
            const auto plan = planMove(*loaded, {path}, to, "");
            return plan.ok() ? std::string() : plan.error().message;
        };
        QCOMPARE(refused("Robot r { Config=Cart chassis.hull.Pos=1,2,3 }\nRobot s { Config=Cart }\n"),
                 "Box hull cannot keep its pose in Robot r, which sets a Pos, HPR or Param of its own there; reset that first");
        QVERIFY(!refused("Robot r { Config=Cart }\nRobot s { Config=Cart wheel.HPR=1,2,3 }\n").empty());
        QVERIFY(!refused("Robot r { Config=Cart }\nRobot s { Config=Cart chassis.hull.HPR=1,2,3 }\n",
                         "RobotConfig.Cart.chassis.hull", "RobotConfig.Cart.wheel")
                     .empty());
        QCOMPARE(
            refused("Robot r { Config=Cart chassis.hull.Mass=3 r=0.2 Pos=1,2,3 }\nGrid g { Config=Cart Count=2 Spacing=9 }\n"),
            "");
    }

    /// A geom moves to the other body: references follow, and its world pose stays.
    void movedGeomKeepsPose() {
        const auto loaded = m_fixture.open(scene(
            "Robot r { Config=Cart Pos=3,4,5 HPR=10,20,30 chassis.hull.Mass=2 }\nSignalLog l { Signals=r/chassis/pose }\n"));
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const auto plan = planMove(*loaded, {"r.chassis.hull"}, "r.wheel", "r.wheel.tyre");
        const std::string text = m_fixture.text(loaded, plan);
        QVERIFY2(text.find("Geom=wheel.hull") != std::string::npos && text.find("wheel.hull.Mass=2") != std::string::npos,
                 text.c_str());
        QCOMPARE(plan.value().selects.at(0), "r.wheel.hull");
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
        const Pose a = worldPose(*loaded, "r", "chassis", "hull"), b = worldPose(*again, "r", "wheel", "hull");
        QVERIFY2((a.position - b.position).norm() < 1e-9, text.c_str());
        QVERIFY(a.rotation.angularDistance(b.rotation) < 1e-9);
    }

    /// Where a body counts from another one by In, with a robot that has the config and without.
    void movedGeomKeepsPoseInABodyThatCountsFromAnother() {
        const std::string arm = "RobotConfig Arm {\n  Body base { Pos=0,0,0.1 HPR=20,0,0 Box plate { Size=0.3,0.3,0.1 Mass=1 }\n"
                                "    Box foot { Size=0.1,0.1,0.1 Pos=0.1,0,0 Mass=1 } }\n"
                                "  Body lower { Pos=0,0.1,0.3 HPR=0,30,0 Box tube { Size=0.1,0.1,0.4 Mass=1 } }\n"
                                "  Repeat link { Count=2 In=lower Pos=0,0,$index Body upper { Pos=0,0.05,0.4 HPR=0,60,0\n"
                                "    Box beam { Size=0.1,0.1,0.4 Pos=0,0,0.2 HPR=10,0,0 Mass=1 }\n"
                                "    Box cap { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                "    Body hand { In=upper Pos=0,0,0.1 HPR=0,0,20 Box palm { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                                "  Body tip { In=link_1.upper Pos=0,0,0.4 HPR=5,0,0 Box pin { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                "  Body eye { In=lower Pos=0,0.2,0.1 HPR=0,0,70 Box lens { Size=0.1,0.1,0.1 Mass=1 }\n"
                                "    Box lid { Size=0.1,0.1,0.1 Pos=0,0,0.1 Mass=1 } }\n}\n";
        const std::string robot = "Robot r { Config=Arm Pos=1,2,3 HPR=40,0,0 }\n";
        for (const auto& [from, geom, to, hasRobot] : std::vector<std::tuple<std::string, std::string, std::string, bool>>{
                 {"link_1.upper", "beam", "base", true},
                 {"link_1.upper", "beam", "link_1.hand", true},
                 {"base", "foot", "tip", true},
                 {"eye", "lid", "base", true},
                 {"eye", "lid", "base", false},
                 {"base", "foot", "eye", false},
                 {"link_1.upper", "beam", "link_1.hand", false}}) {
            const auto before = m_fixture.open(arm + robot);
            QVERIFY2(!before->diagnostics.hasErrors(), sample::messages(*before).c_str());
            const auto loaded = hasRobot ? before : m_fixture.open(arm);
            const std::string start = hasRobot ? "r." : "RobotConfig.Arm.";
            const std::string text = m_fixture.text(loaded, planMove(*loaded, {start + from + "." + geom}, start + to, ""));
            const auto after = m_fixture.open(hasRobot ? text : text + robot);
            QVERIFY2(!after->diagnostics.hasErrors(), text.c_str());
            const Pose a = worldPose(*before, "r", from, geom), b = worldPose(*after, "r", to, geom);
            QVERIFY2((a.position - b.position).norm() < 1e-9 && a.rotation.angularDistance(b.rotation) < 1e-8, text.c_str());
        }
    }

    /// What is inserted is on top of a body that counts from another one.
    void insertedShapesAreOnTopOfABodyThatCountsFromAnother() {
        const auto loaded = m_fixture.open("RobotConfig Arm {\n"
                                           "  Body lower { Pos=0,0,1 HPR=0,0,90 Box tube { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                           "  Body upper { In=lower Pos=0,0.4,0 Box beam { Size=0.1,0.1,0.1 Mass=1 } }\n}\n"
                                           "Robot r { Config=Arm }\n");
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const Pose upper = loaded->experiment->robots[0].config->bodies[1].pose;
        const auto has = [&](const char* kind, const char* parent, const Vec3& position) {
            const std::string text = templateOf(*loaded, *loaded->registry->find(kind), parent);
            return text.find("Pos=" + positionText(position)) != std::string::npos ? std::string() : text;
        };
        QCOMPARE(has("Box", "r.upper", upper.rotation.conjugate() * Vec3(0, 0, 0.1)), std::string());
        QCOMPARE(has("Body", "r", Vec3(0, 0, upper.position.z() + 0.1)), std::string());
    }

    /// Moving there and back restores the original short numbers.
    void thereAndBack() {
        const auto loaded = m_fixture.open(scene("Robot r { Config=Cart }\n"));
        const auto there = m_fixture.apply(loaded, planMove(*loaded, {"r.chassis.hull"}, "r.wheel", ""));
        const auto back = planMove(*there, {"r.wheel.hull"}, "r.chassis", "r.chassis.sphere");
        QCOMPARE(m_fixture.text(there, back), scene("Robot r { Config=Cart }\n"));
    }

    void intoOtherRobots() {
        const std::string more =
            "RobotConfig Other { Body b { HPR=0,0,45 Mass=1 Box x { Size=1,1,1 } } }\nStaticConfig Yard { }\n"
            "Static yard { Config=Yard Pos=7,0,0 }\nRobot r { Config=Cart Pos=3,4,5 HPR=10,20,30 }\nRobot o { Config=Other "
            "Pos=-3,0,1 HPR=90,0,0 }\n";
        const auto loaded = m_fixture.open(scene(more));
        const auto moved = [&](const char* to, const char* robot, const char* body) {
            const auto plan = planMove(*loaded, {"r.wheel.tyre"}, to, "");
            const auto again = m_fixture.apply(loaded, plan);
            if (!again) return plan.error().message;
            const Pose a = worldPose(*loaded, "r", "wheel", "tyre"), b = worldPose(*again, robot, body, "tyre");
            return (a.position - b.position).norm() < 1e-9 && a.rotation.angularDistance(b.rotation) < 1e-8
                       ? std::string()
                       : m_fixture.text(loaded, plan);
        };
        QCOMPARE(moved("yard", "yard", ""), "");
        QCOMPARE(moved("r.chassis", "r", "chassis"), "");
        const auto refused = planMove(*loaded, {"r.chassis.hull"}, "o.b", "");
        QCOMPARE(m_fixture.text(loaded, refused), "refused: Box hull is still used by TouchSensor touch (Geom)");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"r.chassis.sphere"}, "o.b", "")),
                 "refused: Sphere uses r, which Body b does not have");
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"r.axle"}, "o", "")),
                 "refused: Hinge axle uses chassis, which RobotConfig Other does not have");
        const auto both = planMove(*loaded, {"r.wheel", "r.axle", "r.chassis", "r.touch"}, "o", "");
        QVERIFY(both.ok() || both.error().message.find("uses r,") != std::string::npos);
    }

    /// Two uses of a Param that names what is moved beside it and called otherwise there are one change.
    void namesThatAMovedParamGives() {
        const std::string bodies = "  Body b { Sphere { Radius=1 Mass=1 } }\n  Body w { Sphere { Radius=1 Mass=1 } }\n"
                                   "  Hinge axle { Parent=b Child=w }\n  RotaryMotor m { Joint=axle }\n";
        const std::string drive = "  DifferentialDrive d { Param driven = m LeftMotor=$driven RightMotor=$driven }\n";
        const auto loaded = m_fixture.open("RobotConfig A {\n" + bodies + drive + "}\nRobotConfig B {\n" + bodies +
                                           "}\nRobot a { Config=A }\nRobot b { Config=B }\n");
        const std::string moved = m_fixture.text(loaded, planMove(*loaded, {"a.m", "a.d"}, "b", ""));
        QVERIFY2(moved.find("RotaryMotor m2 { Joint=axle }") != std::string::npos &&
                     moved.find("Param driven = m2 LeftMotor=$driven") != std::string::npos,
                 moved.c_str());
    }

    void refused_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("beside");
        QTest::addColumn<QString>("why");
        QTest::newRow("a body into a body") << "r.wheel"
                                            << "r.chassis"
                                            << ""
                                            << "a Body is allowed in a RobotConfig, a StaticConfig or a PartConfig, not in Body chassis";
        QTest::newRow("a geom to the top") << "r.wheel.tyre"
                                           << ""
                                           << ""
                                           << "a Sphere is allowed in a Body, a StaticConfig or a PartConfig, not at the top level";
        QTest::newRow("beside a stranger") << "r.wheel.tyre"
                                           << "r.chassis"
                                           << "r.wheel.tyre"
                                           << "r.wheel.tyre is not in the same block";
        QTest::newRow("member") << "g_0"
                                << ""
                                << ""
                                << "g_0 is a member of Grid g and has no text of its own; replace that by single robots first";
        QTest::newRow("nowhere") << "r"
                                 << "blob"
                                 << ""
                                 << "there is no blob";
    }
    void refused() {
        QFETCH(QString, path);
        QFETCH(QString, parent);
        QFETCH(QString, beside);
        QFETCH(QString, why);
        const auto loaded = m_fixture.open("#loadModule walker\n" +
                                           scene("Robot r { Config=Cart Walker brain { } }\nRobot s { Config=Cart Walker "
                                                 "brain { } }\nGrid g { Config=Cart Count=2 Spacing=9 }\n"));
        const auto plan = planMove(*loaded, {path.toStdString()}, parent.toStdString(), beside.toStdString());
        QVERIFY(!plan.ok());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }

    void movesControllerToAnotherRobot() {
        const auto loaded = m_fixture.open("#loadModule walker\n" +
                                           scene("Robot r { Config=Cart Walker brain { Speed=1 } }\nRobot s { Config=Cart }\n"));
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"r.brain"}, "s", "")),
                 "#loadModule walker\n" + scene("Robot r { Config=Cart }\nRobot s { Config=Cart Walker brain { Speed=1 } }\n"));
    }

    /// A list that names others too loses the removed name, NoContact the pair; a block goes with its last name.
    void removalsShortenLists_data() {
        QTest::addColumn<QString>("uses");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("removed");
        QTest::addColumn<QString>("shortened");
        const auto row = [](const char* name, const char* uses, const char* after, const char* removed, const char* shortened) {
            QTest::newRow(name) << uses << after << removed << shortened;
        };
        row("region", "Region goal { Size=1,1,1 Robots=a, b,c }\n", "Region goal { Size=1,1,1 Robots=a, c }\n", "",
            "Region goal");
        row("last one", "PoseLog way { Robot=a, b }\n", "PoseLog way { Robot=a }\n", "", "PoseLog way");
        row("first two", "SignalLog s { Signals=\"b/b/pose\", b/b/pose,\n  \"a/b/pose\" }\n",
            "SignalLog s { Signals=\"a/b/pose\" }\n", "", "SignalLog s");
        row("pairs", "NoContact=a,b, b,c, a,c\n", "NoContact=a,c\n", "", "NoContact");
        row("pair in front", "NoContact=a,c, c,b\n", "NoContact=a,c\n", "", "NoContact");
        row("the only pair", "NoContact=a,b\n", "", "", "NoContact");
        row("comments of others stay", "PoseLog way {\n  Robot=a, // 1\n    b, // 2\n    c // 3\n}\n",
            "PoseLog way {\n  Robot=a, // 1\n    c // 3\n}\n", "", "PoseLog way");
        row("both kinds", "NoContact=a,b\nPoseLog way { Robot=b }\nPoseLog all { Robot=c,b }\n", "PoseLog all { Robot=c }\n",
            "way", "NoContact, PoseLog all");
        row("beside members", "Repeat lane { Count=2 Pos=9,$index,0 Robot d { Config=C } }\nPoseLog way { Robot=lane.d,b }\n",
            "Repeat lane { Count=2 Pos=9,$index,0 Robot d { Config=C } }\nPoseLog way { Robot=lane.d }\n", "", "PoseLog way");
    }
    void removalsShortenLists() {
        QFETCH(QString, uses);
        QFETCH(QString, after);
        QFETCH(QString, removed);
        QFETCH(QString, shortened);
        const QString robots = "RobotConfig C { Body b { Sphere s { Radius=0.1 Mass=1 } } }\nRobot a { Config=C }\n",
                      b = "Robot b { Config=C Pos=0,1,0 }\n", c = "Robot c { Config=C Pos=0,2,0 }\n";
        const auto loaded = m_fixture.open((robots + b + c + uses).toStdString());
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const Dependents users = dependentsOf(*loaded, {"b"});
        const auto joined = [](const std::vector<std::string>& texts) {
            QStringList all;
            for (const std::string& text : texts) all << QString::fromStdString(text);
            return all.join(", ");
        };
        QCOMPARE(joined(users.removed), removed);
        QCOMPARE(joined(users.shortened), shortened);
        std::vector<std::string> all = users.removed;
        all.push_back("b");
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, planRemove(*loaded, all))), robots + c + after);
    }

    /// A drive whose motors have angles in the same order is removed with one of them; without angles it keeps the others.
    void listsWithValuesInTheSameOrderStay() {
        for (const bool hasAngles : {true, false}) {
            std::string text = "RobotConfig C {\n  Body b { Sphere s { Radius=0.1 Mass=1 } }\n";
            for (const std::string i : {"0", "1", "2", "3"})
                text += "  Body w" + i + " { Pos=" + i + ",1,0 Sphere s { Radius=0.1 Mass=1 } }\n  Hinge j" + i +
                        " { Parent=b Child=w" + i + " }\n  RotaryMotor m" + i + " { Joint=j" + i +
                        " TorqueConstant=1 SpeedConstant=1 Resistance=1 MaxVoltage=12 }\n";
            const std::string angles = hasAngles ? " WheelAngles=0,90,180,270" : "";
            text += "  OmniDrive drive { Motors=m0,m1,m2,m3 WheelRadius=0.1 WheelDistance=1" + angles + " }\n}\n";
            const auto loaded = m_fixture.open(text);
            QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
            const Dependents users = dependentsOf(*loaded, {"RobotConfig.C.m3"});
            QCOMPARE(users.removed, hasAngles ? std::vector<std::string>{"RobotConfig.C.drive"} : std::vector<std::string>());
            QCOMPARE(users.shortened, hasAngles ? std::vector<std::string>() : std::vector<std::string>{"OmniDrive drive"});
        }
    }

private:
    PlanFixture m_fixture;
};

QTEST_APPLESS_MAIN(PlansMoveTest)
#include "plans_move_test.moc"
