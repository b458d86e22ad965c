// Groups several objects into one config in a new file.
#include <QTest>

#include "plan_fixture.h"
#include "project/edits/plan_group.h"

using namespace trundle;
using sample::PlanFixture;

class PlansGroupTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void groupingKeepsPoses_data() {
        QTest::addColumn<QString>("objects");
        QTest::addColumn<QStringList>("names");
        QTest::newRow("scenery")
            << "Static a { Config=Wall Pos=1.25,0.5,0 HPR=37.5,0,0 length=3 }\n"
               "Static b { Config=Wall Pos=-2/**/,0.1,0.2 HPR=10,20,30 bricks.Material=own bricks.Size=1,0.2,0.3 }\n"
               "Static keep { Config=Wall Pos=9,9,0 }\n"
               "Static arch { Config=Arch Pos=$(far/3),1,0 HPR=$far,0,0 }\n"
            << QStringList{"a", "arch", "b"};
        QTest::newRow("objects")
            << "Robot a { Config=Crate Pos=1,2,0.5 HPR=15,0,0 side=0.4 }\nRobot b { Config=Crate Pos=1,2,0 }\n"
            << QStringList{"a", "b"};
        QTest::newRow("one") << "Static a { Config=Arch Pos=0.123456789,2,3 HPR=5,6,7 }\n" << QStringList{"a"};
    }
    /// World pose and size of each geom, the pose first.
    static std::vector<std::pair<Pose, GeomSpec>> shapesOf(const ExperimentSpec& e) {
        std::vector<std::pair<Pose, GeomSpec>> all;
        for (const StaticSpec& fixed : e.statics)
            for (const GeomSpec& geom : *fixed.geoms) all.emplace_back(fixed.pose * geom.pose, geom);
        for (const RobotSpec& robot : e.robots)
            for (const BodySpec& body : robot.config->bodies)
                for (const GeomSpec& geom : body.geoms) all.emplace_back(robot.pose * body.pose * geom.pose, geom);
        return all;
    }
    void groupingKeepsPoses() {
        QFETCH(QString, objects);
        QFETCH(QStringList, names);
        const std::string main = "Param far = 1.7\n#import parts.sim\nMaterial own { ColorRGB=1,0,0 }\n" + objects.toStdString() +
                                 "Static last { Config=Wall bricks.Material=own Pos=20,0,0 }\n";
        const std::map<std::string, std::string> files{
            {"configs/main.sim", main},
            {"configs/paint.sim", "Material white { ColorRGB=1,1,1 }\nSurface rough { Friction=1 }\n"},
            {"configs/parts.sim", "#import paint.sim\nStaticConfig Wall {\n  Param length=2\n  Box bricks { Pos=0,0,0.25 "
                                  "Size=$length,0.1,0.5 Material=white }\n}\n"
                                  "StaticConfig Arch {\n  Cylinder left { Pos=-0.5,0,0.5 Radius=0.1 Length=1 Surface=rough }\n"
                                  "  Box top { Pos=0,0,1.1 HPR=0,$(2*5),0 Size=1.2,0.2,0.2 Collide=false }\n}\n"
                                  "RobotConfig Crate {\n  Param side=0.25\n  Body body {\n    Box planks { Pos=0,0,$(side/2) "
                                  "Size=$side,$side,$side Mass=1.5 Material=white }\n  }\n}\n"}};
        const auto before = m_fixture.open(files, "configs/main.sim");
        QVERIFY2(!before->diagnostics.hasErrors(), sample::messages(*before).c_str());
        std::vector<std::string> paths;
        for (const QString& name : names) paths.push_back(name.toStdString());
        const auto group = planGroup(*before, paths, "RedCorner");
        QVERIFY2(group.ok(), group.ok() ? "" : group.error().message.c_str());
        QCOMPARE(QString::fromStdString(group.value().file),
                 QString::fromStdString(m_fixture.path("configs/objects/red_corner.sim")));
        sample::Texts texts = sample::PlanFixture::after(*before, group.value().plan);
        QVERIFY(!texts.empty());
        texts[group.value().file] = group.value().text;
        const auto after = m_fixture.read(texts);
        const std::string said = sample::messages(*after) + group.value().text + texts[m_fixture.path("configs/main.sim")];
        QVERIFY2(!after->diagnostics.hasErrors(), said.c_str());
        QCOMPARE(group.value().plan.selects, std::vector<std::string>{"redCorner"});
        QCOMPARE(after->experiment->statics.size() + after->experiment->robots.size(),
                 before->experiment->statics.size() + before->experiment->robots.size() - paths.size() + 1);
        const auto was = shapesOf(*before->experiment), is = shapesOf(*after->experiment);
        QCOMPARE(is.size(), was.size());
        for (const auto& [pose, geom] : was) {
            const auto same = std::ranges::find_if(is, [&, &pose = pose, &geom = geom](const auto& other) {
                return (other.first.position - pose.position).norm() < 1e-9 &&
                       other.first.rotation.angularDistance(pose.rotation) < 1e-9 && other.second.shape == geom.shape &&
                       (other.second.size - geom.size).norm() < 1e-12 && other.second.radius == geom.radius &&
                       other.second.length == geom.length && other.second.collide == geom.collide &&
                       other.second.mass == geom.mass &&
                       after->experiment->materials.at(other.second.material).name ==
                           before->experiment->materials.at(geom.material).name &&
                       after->experiment->surfaces.at(other.second.surface).name ==
                           before->experiment->surfaces.at(geom.surface).name;
            });
            QVERIFY2(same != is.end(), (geom.name + "\n" + said).c_str());
        }
    }

    /// The members of a Grid become bodies where they were, with its overrides.
    void membersOfAGridBecomeBodies() {
        const auto before = m_fixture.open(
            "RobotConfig C { Param side = 0.2 Body b { Box x { Size=$side,0.2,0.2 Mass=1 } } }\n"
            "RobotConfig V { Config=C b.x.Mass=3 }\nRobot r { Config=V Pos=5,0,0.1 }\n"
            "Grid g { Config=C Pos=1,2,0.1 HPR=30,0,0 Count=3,2 Spacing=0.5 side=$(0.1 + index/100) b.x.Mass=$(2 + index2) }\n");
        QVERIFY2(!before->diagnostics.hasErrors(), sample::messages(*before).c_str());
        const auto group = planGroup(*before, {"r", "g"}, "Piece");
        QVERIFY2(group.ok(), group.ok() ? "" : group.error().message.c_str());
        sample::Texts texts = sample::PlanFixture::after(*before, group.value().plan);
        texts[group.value().file] = group.value().text;
        const auto after = m_fixture.read(texts);
        QVERIFY2(!after->diagnostics.hasErrors(), (sample::messages(*after) + group.value().text).c_str());
        QCOMPARE(after->experiment->robots.size(), std::size_t(1));
        const auto was = shapesOf(*before->experiment), is = shapesOf(*after->experiment);
        QCOMPARE(is.size(), std::size_t(7));
        for (const auto& [pose, geom] : was)
            QVERIFY2(std::ranges::any_of(is,
                                         [&, &pose = pose, &geom = geom](const auto& other) {
                                             return (other.first.position - pose.position).norm() < 1e-6 &&
                                                    other.first.rotation.angularDistance(pose.rotation) < 1e-6 &&
                                                    (other.second.size - geom.size).norm() < 1e-9 &&
                                                    other.second.mass == geom.mass;
                                         }),
                     group.value().text.c_str());
    }

    /// The new file cannot use Params of the experiment: moved values are written out.
    void movedObjectsKeepValues() {
        const auto before =
            m_fixture.open("Param tone = 0.25\nParam grip = 0.7\nMaterial paint { ColorRGB=1,$(tone*2),$tone } // ours\n"
                           "Surface sole { Friction=$grip }\n"
                           "StaticConfig S { Box b { Size=1,1,1 Material=paint Surface=sole } }\nStatic s { Config=S }\n");
        QVERIFY2(!before->diagnostics.hasErrors(), sample::messages(*before).c_str());
        const auto group = planGroup(*before, {"s"}, "Piece");
        QVERIFY2(group.ok(), group.ok() ? "" : group.error().message.c_str());
        QVERIFY2(group.value().text.find('$') == std::string::npos, group.value().text.c_str());
        sample::Texts texts = sample::PlanFixture::after(*before, group.value().plan);
        texts[group.value().file] = group.value().text;
        const auto after = m_fixture.read(texts);
        QVERIFY2(!after->diagnostics.hasErrors(), (sample::messages(*after) + group.value().text).c_str());
        const auto find = [](const auto& all, const std::string& name) {
            return std::ranges::find_if(all, [&](const auto& each) { return each.name == name; });
        };
        const auto was = find(before->experiment->materials, "paint"), is = find(after->experiment->materials, "paint");
        QVERIFY(is != after->experiment->materials.end());
        QCOMPARE(is->colour[1], 0.5);
        QVERIFY(is->colour == was->colour);
        QCOMPARE(find(after->experiment->surfaces, "sole")->friction, find(before->experiment->surfaces, "sole")->friction);
    }

    void reportsUngroupableObjects() {
        const auto loaded = m_fixture.open(
            "#import other.sim\nStaticConfig S { Box b { Size=1,1,1 } }\nStatic s { Config=S }\n"
            "RobotConfig C { Body b { Mass=1 Box x { Size=1,1,1 } } }\nRobot r { Config=C }\n"
            "RobotConfig D { Body b { Mass=1 Box x { Size=1,1,1 } } Camera eye { Body=b } }\nRobot d { Config=D }\n"
            "Grid g { Config=C Count=2 Spacing=9 }\nPoseLog l { Robot=r }\n"
            "StaticConfig Fence { Repeat post { Count=5 Spacing=1 Box wood { Size=0.1,0.1,1 } } }\nStatic fence { Config=Fence "
            "}\n"
            "RobotConfig Bolted { Body b { Box x { Size=1,1,1 Mass=1 } Ring bolt { Count=6 Radius=0.3 Sphere s { Radius=0.1 "
            "Mass=1 } } } }\n"
            "RobotConfig Painted { Config=Bolted }\nRobot crate { Config=Painted }\n"
            "RobotConfig Stack { Body low { Box x { Size=1,1,1 Mass=1 } } Body top { In=low Pos=0,0,1 Box x { Size=1,1,1 Mass=1 "
            "} } }\n"
            "Robot stack { Config=Stack }\nRing posts { Count=3 Radius=9 Static post { Config=S } }\n");
        const auto why = [&](const std::vector<std::string>& paths, const char* name = "Piece") {
            const auto plan = planGroup(*loaded, paths, name);
            return plan.ok() ? std::string() : plan.error().message;
        };
        QCOMPARE(why({"s"}), std::string());
        QCOMPARE(planGroup(*loaded, {"s", "s"}, "Piece").value().text, planGroup(*loaded, {"s"}, "Piece").value().text);
        QVERIFY(why({"s", "r"}).find("cannot be one piece") != std::string::npos);
        QVERIFY(why({"d"}).find("without joints, devices and controller") != std::string::npos);
        QVERIFY(why({"g_1"}).find("select g to group all of them") != std::string::npos);
        QCOMPARE(why({"g"}), std::string());
        QVERIFY(why({"r"}).find("named by PoseLog l") != std::string::npos);
        QVERIFY(why({}).find("select") != std::string::npos);
        QVERIFY(why({"fence"}).find("StaticConfig Fence has Repeat post") != std::string::npos);
        QVERIFY(why({"crate"}).find("RobotConfig Painted has Ring bolt") != std::string::npos);
        QVERIFY(why({"stack"}).find("stack.top has its place In low") != std::string::npos);
        QVERIFY(why({"posts.post"}).find("Static post is in Ring posts") != std::string::npos);
        QVERIFY(why({"s"}, "S").find("already") != std::string::npos);
        QVERIFY(why({"s"}, "my piece").find("no name") != std::string::npos);
    }

    /// A copy that is placed elsewhere takes the point of its joint along, in the units of its text.
    void anchorsShiftWithTheirJoint() {
        const std::string config =
            "RobotConfig C {\n  Body a { Mass=1 Inertia=1,1,1 Pos=0,0,1 }\n  Body b { Mass=1 Inertia=1,1,1 }\n"
            "  Hinge h { Parent=a Child=b Anchor=1, 20 cm,3 }\n  Slider s { Parent=world Child=a }\n}\nRobot r { Config=C }\n";
        const auto loaded = m_fixture.open(config);
        const std::string text = m_fixture.text(loaded, planDuplicate(*loaded, {"r.h"}, Vec3(0.5, -0.1, 0)));
        QVERIFY2(text.find("Hinge h2 { Parent=a Child=b Anchor=1.5, 10 cm,3 }") != std::string::npos, text.c_str());
        const std::string both =
            m_fixture.text(loaded, planDuplicate(*loaded, {"RobotConfig.C.b", "RobotConfig.C.h"}, Vec3(0.5, -0.1, 0)));
        QVERIFY2(both.find("Hinge h2 { Parent=a Child=b2 Anchor=1.5, 10 cm,3 }") != std::string::npos, both.c_str());
        const std::string slider = m_fixture.text(loaded, planDuplicate(*loaded, {"r.s"}, Vec3(0.5, -0.1, 0)));
        QVERIFY2(slider.find("Slider s2 { Parent=world Child=a }") != std::string::npos, slider.c_str()); // no Anchor was written
    }

    /// Unnamed blocks are numbered by their order: naming one leaves the names of the others, and what refers to them.
    void namingOneOfSeveralUnnamed() {
        const std::string before = "StaticConfig C {\n  Box { Size=1,1,1 }\n  Box { Size=2,1,1 }\n  Box { Size=3,1,1 }\n}\n"
                                   "Static s { Config=C box.Pos=1,0,0 box2.Pos=2,0,0 box3.Pos=3,0,0 }\n";
        for (const auto& [path, name, expected] : {std::tuple{"StaticConfig.C.box", "lid", "lid:1 box2:2 box3:3 "},
                                                   {"s.box2", "lid", "box:1 lid:2 box3:3 "},
                                                   {"s.box3", "lid", "box:1 box2:2 lid:3 "},
                                                   {"s.box", "box1", "box1:1 box2:2 box3:3 "}}) {
            const auto loaded = m_fixture.open(before);
            const auto again = m_fixture.apply(loaded, planRename(*loaded, path, name));
            QVERIFY2(again && !again->diagnostics.hasErrors(), path);
            std::string found;
            for (const GeomSpec& g : *again->experiment->statics.at(0).geoms) {
                found += g.name + ":" + std::to_string(int(g.size.x())) + " ";
                QCOMPARE(g.pose.position.x(), g.size.x()); // the override still belongs to it
            }
            QCOMPARE(found, std::string(expected));
        }
    }

    /// A block of a file that several blocks import is one text for all of them: it does not move.
    void sharedBlocksDoNotMove() {
        const std::string piece = "Body x { Mass=1 Inertia=1,1,1 }\n", own = "Body y { Mass=1 Inertia=1,1,1 }\n";
        const auto loaded = m_fixture.open({{"main.sim", "RobotConfig A {\n#import piece.sim\n" + own +
                                                             "}\nRobotConfig B {\n#import piece.sim\n}\n"
                                                             "RobotConfig D { }\n"},
                                            {"piece.sim", piece}});
        const auto shared = planMove(*loaded, {"RobotConfig.A.x"}, "RobotConfig.D", "");
        QVERIFY(!shared.ok());
        QCOMPARE(shared.error().message, std::string("Body x is in a file that several blocks import"));
        QVERIFY(planMove(*loaded, {"RobotConfig.A.y"}, "RobotConfig.D", "").ok());
    }

private:
    PlanFixture m_fixture;
};

QTEST_APPLESS_MAIN(PlansGroupTest)
#include "plans_group_test.moc"
