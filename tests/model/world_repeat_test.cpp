// Repeat and Ring at the top level, Grid and Scatter of scenery: each member is what its blocks say for its number.
#include <QTest>

#include "model/robot_path.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kWorld = "Material g { } Surface s { }\n"
                           "RobotConfig Cart { Param m = 1 Body b { Box hull { Size=1,1,1 Material=g Surface=s Mass=$m } } }\n"
                           "StaticConfig Post { Param h = 1 Box wood { Size=0.1,0.1,$h Material=g Surface=s } }\n";

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }
Resolved world(const std::string& text, const std::vector<std::string>& sets = {}) { return resolved(kWorld + text, sets); }

} // namespace

class WorldRepeatTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void robotsAndSceneryAreThereSeveralTimes() {
        const Resolved r = world("Repeat row { Count=3 Pos=0,$(2*index),1 Param k = $(index+1)\n"
                                 "  Robot cart { Config=Cart m=$k Pos=0.5,0,0 Walker brain { } }\n"
                                 "  Static post { Config=Post h=$(1+index) Pos=1,0,0 } }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(3));
        QCOMPARE(r.experiment->robots[2].name, std::string("row_2.cart"));
        QCOMPARE(r.experiment->robots[2].pose.position, Vec3(0.5, 4, 1));
        QCOMPARE(r.config(2).bodies[0].mass.mass, 3.0);
        QCOMPARE(r.experiment->robots[1].controllers.size(), std::size_t(1));
        QCOMPARE(r.experiment->statics.size(), std::size_t(3));
        QCOMPARE(r.experiment->statics[1].name, std::string("row_1.post"));
        QCOMPARE(r.experiment->statics[1].pose.position, Vec3(1, 2, 1));
        QCOMPARE(r.experiment->statics[1].geoms->at(0).size.z(), 2.0);
    }

    void aCountMayBeAQuotientOfFractions() {
        const Resolved r = world("Repeat row { Count=$(0.3 / 0.1) Pos=0,$(2*index),0 Robot cart { Config=Cart } }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(3));
        QVERIFY(messagesOf(world("Repeat row { Count=$(0.3 / 0.1 + 1e-9) Robot cart { Config=Cart } }\n"))
                    .contains("a whole number"));
    }

    void aRingTurnsItsMembers() {
        const Resolved r = world("Ring fence { Count=4 Radius=2 Pos=1,0,0 Static post { Config=Post } Light lamp { Mode=lamp "
                                 "Pos=0,0,3 } }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->statics.size(), std::size_t(4));
        QVERIFY((r.experiment->statics[1].pose.position - Vec3(1, 2, 0)).norm() < 1e-12);
        QVERIFY((r.experiment->statics[1].pose.rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
        QCOMPARE(r.experiment->looks.size(), std::size_t(4));
        QCOMPARE(r.experiment->looks[2].name, std::string("fence_2.lamp"));
        const std::vector<double>& at = r.experiment->looks[2].find("Pos")->value.numbers;
        QVERIFY((Vec3(at.data()) - Vec3(-1, 0, 3)).norm() < 1e-12);
    }

    /// A joint finds the robots of its own member first, then those around it.
    void jointsAndRegionsBelongToTheirMember() {
        const Resolved r = world("Robot base { Config=Cart Pos=0,-5,0 }\n"
                                 "Repeat row { Count=2 Pos=0,$(3*index),0\n"
                                 "  Robot a { Config=Cart } Robot b { Config=Cart Pos=2,0,0 }\n"
                                 "  Hinge h { Parent=a.b Child=b.b Anchor=1,0,0 }\n"
                                 "  Spring tie { Parent=base.b Child=b.b Stiffness=1 }\n"
                                 "  Region goal { Size=1,1,1 Pos=1,0,0 Robots=b,base } }\n"
                                 "Fixed last { Parent=base.b Child=row_1.a.b }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->joints.size(), std::size_t(3));
        QCOMPARE(r.experiment->joints[1].spec.name, std::string("row_1.h"));
        QCOMPARE(r.experiment->joints[1].spec.anchor, Vec3(1, 3, 0));
        QCOMPARE(r.experiment->robots[std::size_t(r.experiment->joints[1].parentRobot)].name, std::string("row_1.a"));
        QCOMPARE(r.experiment->robots[std::size_t(r.experiment->joints[2].childRobot)].name, std::string("row_1.a"));
        QCOMPARE(r.experiment->springs[1].spec.anchor2, Vec3(2, 3, 0));
        QCOMPARE(r.experiment->springs[1].spec.anchor, Vec3(0, -5, 0));
        QCOMPARE(r.experiment->regions[1].pose.position, Vec3(1, 3, 0));
        QCOMPARE(r.experiment->regions[1].robots.size(), std::size_t(2));
    }

    /// Logs and views of a member name what is in it first; files of members have their names in front.
    void logsAndViewsBelongToTheirMember() {
        const Resolved r = world("Robot base { Config=Cart Pos=0,-5,0 }\n"
                                 "Repeat row { Count=2 Pos=0,$(3*index),0\n"
                                 "  Robot cart { Config=Cart }\n"
                                 "  PoseLog way { Robot=cart,base File=ways/track.csv }\n"
                                 "  View side { Eye=1,0,1 Target=0,0,0 }\n"
                                 "  View behind { Mode=follow Robot=cart Eye=-1,0,1 Target=0,0,0 } }\n");
        QCOMPARE(messagesOf(r), QString());
        const ExperimentSpec& e = *r.experiment;
        QCOMPARE(e.logs.size(), std::size_t(2));
        QCOMPARE(e.logs[1].name, std::string("row_1.way"));
        QCOMPARE(e.logs[1].text("File"), std::string("ways/row_1.track.csv"));
        QCOMPARE(e.logs[1].find("Robot")->value.texts, (std::vector<std::string>{"row_1.cart", "base"}));
        QCOMPARE(e.looks.size(), std::size_t(4));
        QCOMPARE(e.looks[2].name, std::string("row_1.side"));
        QCOMPARE(e.looks[2].find("Eye")->value.numbers, (std::vector<double>{1, 3, 1}));
        QCOMPARE(e.looks[2].find("Target")->value.numbers, (std::vector<double>{0, 3, 0}));
        QCOMPARE(e.looks[3].text("Robot"), std::string("row_1.cart"));
        QCOMPARE(e.looks[3].find("Eye")->value.numbers, (std::vector<double>{-1, 0, 1})); // goes along with the robot
    }

    void repeatsAreInRepeats() {
        const Resolved r = world("Repeat y { Count=2 Pos=0,$index,0 Param j = $index Repeat x { Count=3 Pos=$index,0,0\n"
                                 "  Static p { Config=Post h=$(1 + 10*j + index) } } }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->statics.size(), std::size_t(6));
        QCOMPARE(r.experiment->statics[5].name, std::string("y_1.x_2.p"));
        QCOMPARE(r.experiment->statics[5].pose.position, Vec3(2, 1, 0));
        QCOMPARE(r.experiment->statics[5].geoms->at(0).size.z(), 13.0);
    }

    void namesLeadToMembers() {
        const Resolved r = world("Repeat row { Count=2 Robot cart { Config=Cart } }\n");
        for (const char* name : {"row_1.cart", "row.cart"}) {
            const Part* part = r.outline->world.find(name);
            QVERIFY2(part && part->name == "cart", name);
        }
        QVERIFY(r.outline->world.find("row_1")->isRepeat());
        QVERIFY(!r.outline->world.find("row_1.car"));
        QVERIFY(!r.outline->world.find("rows_1.cart"));
        QCOMPARE(provenanceOf(*r.outline, "row_1.cart.Config")->origin, Origin::Instance);
        QCOMPARE(int(provenanceOf(*r.outline, "row_1.cart.b.hull.Mass")->origin), int(Origin::Param));
    }

    void valuesAreSetForAllMembers() {
        const Resolved r = world("Repeat row { Count=2 Robot cart { Config=Cart } }\n", {"row.cart.m=4", "row.Count=3"});
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(3));
        QCOMPARE(r.config(2).bodies[0].mass.mass, 4.0);
    }

    /// Its own values count by the Repeat, those of its members by itself.
    void gridsAreInRepeats() {
        const Resolved r = world("Repeat row { Count=2 Pos=0,$(10*index),0 Param k = $index\n"
                                 "  Grid g { Config=Cart Count=$(2+index) Spacing=2 Pos=$(5*index),0,0 m=$(1 + 10*k + index) }\n"
                                 "  Region pool { Size=1,1,1 Robots=g } }\n"
                                 "PoseLog one { Robot=row_1.g_2 }\nPoseLog all { Robot=row.g }\n"
                                 "Fixed f { Parent=row_0.g_0.b Child=row_0.g_1.b }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(5));
        const RobotSpec& last = r.experiment->robots[4];
        QCOMPARE(last.name, std::string("row_1.g_2"));
        QCOMPARE(last.pose.position, Vec3(7, 10, 0));
        QCOMPARE(r.config(4).bodies[0].mass.mass, 13.0);
        QCOMPARE(r.config(1).bodies[0].mass.mass, 2.0);
        QCOMPARE(r.experiment->logs[0].find("Robot")->value.texts, (std::vector<std::string>{"row_1.g_2"}));
        QCOMPARE(r.experiment->logs[1].find("Robot")->value.texts.size(), std::size_t(5));
        QCOMPARE(r.experiment->robots[std::size_t(r.experiment->joints[0].childRobot)].name, std::string("row_0.g_1"));
        QCOMPARE(r.experiment->regions[1].robots, (std::vector<std::size_t>{2, 3, 4}));
        QCOMPARE(layoutMemberIn(*r.outline, "row_1.g_2.b.hull").name, std::string_view("row_1.g_2"));
        QCOMPARE(layoutMemberIn(*r.outline, "row_1.g_2").all(), std::string_view("row_1.g"));
        QVERIFY(!layoutMemberIn(*r.outline, "row_1.g").layout);
        QCOMPARE(int(provenanceOf(*r.outline, "row_1.g_2.Spacing")->origin), int(Origin::Instance));
    }

    /// Each member has places of its own, clear of the scenery that is there.
    void scattersAreInRepeats() {
        const Resolved r =
            world("Repeat row { Count=2 Pos=0,$(10*index),0 HPR=$(90*index),0,0 Static post { Config=Post Pos=1,0,0 }\n"
                  "  Scatter s { Config=Cart Count=4 Area=0,-2,4,2 Heading=0 } }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(8));
        const Pose second{Vec3(0, 10, 0), rotationFromHpr({90 * M_PI / 180, 0, 0})};
        for (std::size_t i = 0; i < 8; ++i) {
            const Vec3 at = r.experiment->robots[i].pose.position;
            const Vec3 local = i < 4 ? at : Vec3(second.inverse() * at);
            QVERIFY(local.x() > 0 && local.x() < 4 && std::abs(local.y()) < 2);
            QVERIFY((local - Vec3(1, 0, 0)).norm() > 0.5);
        }
        QVERIFY((second.inverse() * r.experiment->robots[4].pose.position - r.experiment->robots[0].pose.position).norm() > 1e-6);
    }

    void gridsAndScattersOfScenery() {
        const Resolved r = world("Grid crate { Config=Post Count=2,2 Spacing=1 h=$(1+index2) }\n"
                                 "Scatter bush { Config=Post Count=5 Area=-3,-3,3,3 h=$(1+index) }\n"
                                 "Scatter swarm { Config=Cart Count=3 Area=-3,-3,3,3 }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->statics.size(), std::size_t(9));
        QCOMPARE(r.experiment->statics[3].name, std::string("crate_3"));
        QCOMPARE(r.experiment->statics[3].pose.position, Vec3(0.5, 0.5, 0));
        QCOMPARE(r.experiment->statics[3].geoms->at(0).size.z(), 2.0);
        QCOMPARE(r.experiment->statics[8].geoms->at(0).size.z(), 5.0);
        QCOMPARE(r.experiment->robots.size(), std::size_t(3));
        for (std::size_t i = 0; i < 9; ++i) {
            for (std::size_t k = 0; k < i; ++k)
                QVERIFY((r.experiment->statics[i].pose.position - r.experiment->statics[k].pose.position).norm() > 0.1);
            for (const RobotSpec& robot : r.experiment->robots) // clear of scenery
                QVERIFY((r.experiment->statics[i].pose.position - robot.pose.position).norm() > 0.5);
        }
    }

    /// cart_2 is a robot of its own, and no member of cart.
    void robotsOfAlikeNamesAreNotMembers() {
        using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
        const auto apart = [](const std::string& text) { return world(text).experiment->noContact; };
        const std::string alike = "Robot cart { Config=Cart } Robot cart_2 { Config=Cart Pos=3,0,0 }\n"
                                  "Robot box { Config=Cart Pos=6,0,0 }\n";
        QCOMPARE(apart(alike + "NoContact=cart,box\n"), (Pairs{{0, 2}}));
        QCOMPARE(apart(alike + "NoContact=cart_2,box\n"), (Pairs{{1, 2}}));
        const std::string row = "Repeat row { Count=2 Pos=0,$(3*index),0\n"
                                "  Robot cart { Config=Cart } Robot cart_2 { Config=Cart Pos=3,0,0 } }\n"
                                "Robot box { Config=Cart Pos=9,0,0 }\n";
        QCOMPARE(apart(row + "NoContact=row.cart,box\n"), (Pairs{{0, 4}, {2, 4}}));
        const Resolved r = world(row);
        const IsOwnName isOwn{*r.outline};
        QVERIFY(isNamedBy("row_1.cart", "row.cart", isOwn) && !isNamedBy("row_1.cart_2", "row.cart", isOwn));
        QVERIFY(isNamedBy("row_1.cart_2", "row.cart_2", isOwn) && isNamedBy("box", "box", isOwn));
        const std::string grid = "Grid cart { Config=Cart Count=2 Spacing=3 } Robot box { Config=Cart Pos=9,0,0 }\n";
        QCOMPARE(apart(grid + "NoContact=cart,box\n"), (Pairs{{0, 2}, {1, 2}}));
    }

    /// What moves in a Static is scenery that a Scatter keeps clear of.
    void aScatterIsClearOfWhatMoves() {
        const std::string door =
            "StaticConfig Door { Body leaf { Pos=0,0,0.5 Box b { Size=1,3,1 Mass=5 Material=g Surface=s } }\n"
            "  Hinge h { Parent=world Child=leaf Axis=0,0,1 } }\nStatic door { Config=Door Pos=2,0,0 }\n";
        const Resolved r = world(door + "Scatter swarm { Config=Cart Count=4 Area=0,-1,4,1 MinDistance=0 }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.experiment->robots.size(), std::size_t(5));
        for (const RobotSpec& robot : r.experiment->robots)
            if (!robot.scenery) QVERIFY(std::abs(robot.pose.position.x() - 2) > 1);
    }

    void errors_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* text, const char* message, const char* place) {
            QTest::newRow(name) << text << message << place;
        };
        row("a body", "Repeat row { Count=2 Body b { } }\n",
            "E302 Body is allowed in a RobotConfig, a StaticConfig or a PartConfig, not in a Repeat at the top level\n", "Body");
        row("in a config",
            "RobotConfig K { Body c { Mass=1 Box h { Size=1,1,1 Material=g Surface=s } } Repeat r { Count=2 Robot x { "
            "Config=Cart } } }\n",
            "E302 Robot is allowed at the top level, not in a Repeat of a RobotConfig\n", "Robot");
        row("a log in a config",
            "RobotConfig K { Body c { Mass=1 Box h { Size=1,1,1 Material=g Surface=s } } Repeat r { Count=2 PoseLog x { } } }\n",
            "E302 PoseLog is allowed at the top level, not in a Repeat of a RobotConfig\n", "PoseLog");
        row("a robot of a log", "Repeat row { Count=2 Robot cart { Config=Cart } PoseLog way { Robot=card } }\n",
            "E208 Robot names card, but there is no such robot; there are row.cart, row_0.cart and row_1.cart\n", "card");
        row("a name in a grid", "Repeat row { Count=2 Grid g { Config=Cart Count=2 Spacing=1 } Robot g_1 { Config=Cart } }\n",
            "E303 the name row_0.g_1 belongs to a member of Grid g\n", "g_1");
        row("a full scatter", "Repeat row { Count=2 Scatter s { Config=Cart Count=20 Area=-0.1,-0.1,0.1,0.1 } }\n",
            "E317 no free place for member 1 of Scatter s after 10000 tries; make Area larger, or Count or MinDistance smaller\n",
            "s");
        row("a name", "Repeat row { Count=2 Robot cart { Config=Cart } }\nRobot row_1 { Config=Cart }\n",
            "E303 the name row_1 belongs to a member of Repeat row\n", "row_1");
        row("a value", "Repeat row { Count=3 Robot cart { Config=Cart m=$(2-index) } }\n", "E203 Mass is 0, it must be above 0\n",
            "$(2-index)");
        row("too many", "Repeat row { Count=1000,1000 Static p { Config=Post } }\n",
            "E312 with Repeat row the world would hold more than 200000 objects\n", "row");
        row("no body",
            "Robot c { Config=Cart } Repeat row { Count=2 Robot cart { Config=Cart } Fixed f { Parent=c.b Child=cart.c } }\n",
            "E208 Child names cart.c, but there is no such body of a robot (robot.body); there is cart.b\n", "cart.c");
        row("no robot", "Repeat row { Count=2 Robot cart { Config=Cart } Region r { Size=1,1,1 Robots=row_2.cart } }\n",
            "E208 Robots names row_2.cart, but Repeat row has no member row_2; the last one is row_1\n", "row_2.cart");
        row("no robot of a grid",
            "Repeat row { Count=2 Grid g { Config=Cart Count=3 Spacing=2 } Region r { Size=1,1,1 Robots=g_3 } }\n",
            "E208 Robots names row_0.g_3, but Grid g has no member g_3; the last one is g_2\n", "g_3");
        row("scenery in a region",
            "Grid posts { Config=Post Count=2 Spacing=1 } Robot c { Config=Cart } Region r { Size=1,1,1 Robots=posts }\n",
            "E208 Robots names posts, a Grid of scenery; it takes a robot\n", "posts");
        row("scenery that touches nothing",
            "Grid posts { Config=Post Count=2 Spacing=1 } Robot c { Config=Cart }\nNoContact=posts,c\n",
            "E208 NoContact names posts, a Grid of scenery; it takes a robot\n", "posts");
        row("no parts", "Repeat row { Count=2 In=b Static p { Config=Post } }\n",
            "E302 In places what is in a config; at the top level there are no bodies to count from\n", "b");
        row("no parts, a Repeat inside", "Repeat row { Count=2 Repeat more { Count=2 In=b Static p { Config=Post } } }\n",
            "E302 In places what is in a config; at the top level there are no bodies to count from\n", "b");
        row("no parts, a Ring inside", "Repeat row { Count=2 Ring more { Count=2 Radius=1 In=row Static p { Config=Post } } }\n",
            "E302 In places what is in a config; at the top level there are no bodies to count from\n", "row");
    }
    void errors() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        QFETCH(QString, place);
        const Resolved r = world(text.toStdString());
        QString errors;
        for (const Diagnostic& d : r.diagnostics.all())
            if (d.severity == Severity::Error) errors += QString::fromStdString(codeName(d.code) + " " + d.message) + u'\n';
        QCOMPARE(errors, message);
        for (const Diagnostic& d : r.diagnostics.all())
            if (d.severity == Severity::Error) QCOMPARE(QString::fromStdString(r.slice(d.range)), place);
    }
};

QTEST_APPLESS_MAIN(WorldRepeatTest)
#include "world_repeat_test.moc"
