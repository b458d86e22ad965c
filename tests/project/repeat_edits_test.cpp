// Repeat and Ring in the editor's view of a text: what a path leads to, values of a member, where an edit goes, renaming, templates.
#include <QTest>

#include "model/provenance.h"
#include "plan_fixture.h"
#include "project/edits/edit_target.h"
#include "project/edits/path_after_edit.h"
#include "project/edits/repeat_step.h"
#include "project/edits/value_edits.h"
#include "project/objects/object_values.h"
#include "project/objects/part_values.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kKit = R"(Material red { ColorRGB=1,0,0 }
Surface floor { Friction=1 }
RobotConfig Kit {
  Param n = 1
  Body hub { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }
  Repeat roller { Count=3,2 Pos=$(0.1*index),$(0.2*index2),0
    Body rim { Pos=0.01,0,0 Sphere t { Radius=$(0.01*(1+index)) Mass=0.1 Material=red Surface=floor } }
    Hinge axle { Parent=hub Child=rim }
    RotaryMotor motor { Joint=axle TorqueConstant=1 SpeedConstant=1 Resistance=$(2+index) MaxVoltage=12 }
  }
  Ring spoke { Count=4 Radius=0.5 Pos=0,0,1 Axis=0,1,0 Body bar { Box b { Size=0.1,0.1,0.1 Mass=0.1 Material=red Surface=floor } } }
  Encoder e { Joint=roller_1.axle CountsPerRevolution=100 }
}
)";
const std::string kRobots =
    "Robot a { Config=Kit }\nRobot b { Config=Kit roller.motor.Resistance=7 roller_4.motor.Resistance=9 }\n"
    "SignalLog log { Signals=\"a/roller_2.motor/voltage\" }\n";

std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all())
        if (d.severity == Severity::Error) all += d.message + "\n";
    return all;
}

} // namespace

class RepeatEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open(kKit + kRobots);
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
    }

    /// What is selected by the name of a member is still after a rename, also in the world.
    void pathsOfMembersFollowRenames() {
        const std::string world = kKit + "Repeat row { Count=2 Pos=0,$(9*index),0\n Robot cart { Config=Kit }\n"
                                         " Grid herd { Config=Kit Count=2 Spacing=3 Pos=4,0,0 } }\n";
        const auto before = m_fixture.open(world);
        QCOMPARE(messages(*before), std::string());
        for (const auto& [path, now, from, to] : std::vector<std::array<std::string, 4>>{
                 {"row_1.cart", "row_1.wagon", "Robot cart", "Robot wagon"},
                 {"row.cart.hub.hull", "line.cart.hub.hull", "Repeat row", "Repeat line"},
                 {"row_1.cart.roller_3.rim", "row_1.cart.wheel_3.rim", "Repeat roller", "Repeat wheel"},
                 {"row_0.herd_1.hub", "row_0.flock_1.hub", "Grid herd", "Grid flock"},
                 {"row_0.herd_1", "row_0.herd_1", "Robot cart", "Robot wagon"}}) {
            std::string text = world;
            text.replace(text.find(from), from.size(), to);
            if (from == "Repeat roller") text.replace(text.find("roller_1"), 6, "wheel");
            const auto after = m_fixture.open(text);
            QCOMPARE(messages(*after), std::string());
            QCOMPARE(pathAfterEdit(*before, *after, path).value_or("none"), now);
        }
    }

    /// A Grid that is replaced by singles: what depends on the number of a member is written with it.
    void singlesHaveTheirNumbers() {
        const auto loaded = m_fixture.open(kKit + "Grid herd { Config=Kit Count=3,2 Spacing=2 hub.hull.Mass=$(1 + 0.5*index)\n"
                                                  "  roller.motor.Resistance=$(1 + index) n=$index2 }\n");
        QCOMPARE(messages(*loaded), std::string());
        const auto plan = planReplaceBySingles(*loaded, "herd");
        const std::string text = m_fixture.text(loaded, plan);
        QVERIFY2(text.find("Robot herd_5 { Pos=2,1,0 HPR=0,0,0 Config=Kit hub.hull.Mass=$(1 + 0.5*2) roller.motor.Resistance=$(1 "
                           "+ 2) n=1 }") != std::string::npos,
                 text.c_str());
        QCOMPARE(text.find("index", text.find("herd_0")), std::string::npos);
        const auto after = m_fixture.apply(loaded, plan);
        QCOMPARE(messages(*after), std::string());
        QCOMPARE(after->experiment->robots.size(), loaded->experiment->robots.size());
        for (std::size_t i = 0; i < 6; ++i) {
            const RobotSpec &was = loaded->experiment->robots[i], &is = after->experiment->robots[i];
            QCOMPARE(is.name, was.name);
            QVERIFY(was.config->bodies[0].mass.mass > 0.9);
            QCOMPARE(is.config->bodies[0].mass.mass, was.config->bodies[0].mass.mass);
        }
    }

    /// A Grid in a Repeat of the world: its members lead to it, a rename follows them.
    void gridsInRepeatsOfTheWorld() {
        const auto loaded =
            m_fixture.open(kKit + "Repeat row { Count=2 Pos=0,$(9*index),0\n"
                                  " Grid herd { Config=Kit Count=2 Spacing=3 Pos=4,0,0 } }\n"
                                  "SignalLog s { Signals=\"row_1.herd_0/e/count\" }\nPoseLog p { Robot=row_0.herd_1 }\n"
                                  "PoseLog all { Robot=row.herd }\nFixed f { Parent=world Child=row_1.herd_1.hub }\n");
        QCOMPARE(messages(*loaded), std::string());
        for (const char* path : {"row_1.herd_0", "row.herd_0", "row_1.herd_0.hub.hull", "row.herd", "row_1.herd.hub"}) {
            const auto place = placeOf(*loaded, path);
            QVERIFY2(place && place->instance && place->instance->name == "herd", path);
            QCOMPARE(place->member, std::string(path).find("herd_") != std::string::npos);
        }
        QVERIFY(!placeOf(*loaded, "row_1.herd_2"));
        QVERIFY(!placeOf(*loaded, "row_2.herd_0"));
        QCOMPARE(ObjectValues(loaded, "row_1.herd_0").property("Spacing")->path, std::string("row_1.herd.Spacing"));
        const std::string renamed = m_fixture.text(loaded, planRename(*loaded, "row_1.herd", "flock"));
        QVERIFY2(renamed.find("herd") == std::string::npos && renamed.find("\"row_1.flock_0/e/count\"") != std::string::npos &&
                     renamed.find("Robot=row_0.flock_1") != std::string::npos &&
                     renamed.find("Child=row_1.flock_1.hub") != std::string::npos,
                 renamed.c_str());
        QCOMPARE(m_fixture.text(loaded, planReplaceBySingles(*loaded, "row.herd")),
                 std::string("refused: row.herd is in Repeat row: its members would be written once for all of that"));
    }

    /// Names with a member in front cannot follow to the top level, also not with what uses them.
    void namesOfMembersStay() {
        const auto loaded = m_fixture.open(kKit + "Repeat row { Count=2 Pos=0,$(9*index),0\n Robot cart { Config=Kit }\n"
                                                  " Region here { Size=1,1,1 Robots=row_0.cart } }\n");
        QCOMPARE(messages(*loaded), std::string());
        const std::string refused = "refused: Robot cart is still used by Region here (Robots)";
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"row.cart"}, "", {})), refused);
        QCOMPARE(m_fixture.text(loaded, planMove(*loaded, {"row.cart", "row.here"}, "", {})), refused);
    }

    void pathsLeadToMembers() {
        for (const char* path : {"a.roller_4.rim.t", "a.roller.rim.t", "RobotConfig.Kit.roller_4.rim.t"}) {
            const auto place = placeOf(*m_loaded, path);
            QVERIFY2(place && place->part, path);
            QCOMPARE(place->part->name, std::string("t"));
            QCOMPARE(place->members.size(), std::size_t(std::string(path).find('_') != std::string::npos));
        }
        QVERIFY(!placeOf(*m_loaded, "a.roller_x.rim"));
        QVERIFY(!placeOf(*m_loaded, "a.rolle_1.rim"));
        QCOMPARE(pathOf(*m_loaded, {m_loaded->outline->configs.find("Kit"), placeOf(*m_loaded, "a.roller_1")->part}),
                 std::string("RobotConfig.Kit.roller"));
    }

    void values_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("origin");
        const auto row = [](const char* path, double value, ValueOrigin origin) {
            QTest::newRow(path) << path << value << int(origin);
        };
        row("a.roller_4.motor", 3, ValueOrigin::Config);
        row("a.roller.motor", 2, ValueOrigin::Config);
        row("b.roller_3.motor", 7, ValueOrigin::Override);
        row("b.roller_4.motor", 9, ValueOrigin::Override);
        row("b.roller.motor", 7, ValueOrigin::Override);
        row("RobotConfig.Kit.roller_2.motor", 4, ValueOrigin::Own);
    }
    void values() {
        QFETCH(QString, path);
        QFETCH(double, value);
        QFETCH(int, origin);
        ObjectValues values(m_loaded, path.toStdString());
        const auto resistance = values.property("Resistance");
        QVERIFY(resistance && resistance->value);
        QCOMPARE(resistance->value->numbers.at(0), value);
        QCOMPARE(int(resistance->origin), origin);
        if (path.startsWith("b.")) {
            const auto from = provenanceOf(*m_loaded->outline, path.toStdString() + ".Resistance");
            QVERIFY(from);
            QCOMPARE(QString::fromStdString(std::string(m_loaded->sources.slice(from->value))), QString::number(value));
        }
    }

    /// The frame that a member describes its blocks in is where the world has it.
    void frames() {
        const RobotConfigSpec& config = *m_loaded->experiment->robots[0].config;
        for (const BodySpec& body : config.bodies) {
            const auto place = placeOf(*m_loaded, "a." + body.name);
            const DescribedFrame frame = describedFrame(*m_loaded, *place);
            const Pose inConfig = frame.pose * poseAt(*m_loaded, *place);
            QVERIFY2((inConfig.position - body.pose.position).norm() < 1e-12, body.name.c_str());
            QVERIFY2(inConfig.rotation.angularDistance(body.pose.rotation) < 1e-7, body.name.c_str());
        }
        QCOMPARE(config.bodies.size(), std::size_t(11));
    }

    /// Of two robots one gets an override, for the member that the path names or for all.
    void editTargets_data() {
        QTest::addColumn<QString>("asked");
        QTest::addColumn<QString>("text");
        QTest::newRow("one") << "a.roller_4.rim.t.Mass"
                             << "a { Config=Kit roller_4.rim.t.Mass=9 }";
        QTest::newRow("all") << "a.roller.rim.t.Mass"
                             << "a { Config=Kit roller.rim.t.Mass=9 }";
        QTest::newRow("count") << "a.roller.Count"
                               << "a { Config=Kit roller.Count=9 }";
        QTest::newRow("in the config") << "RobotConfig.Kit.roller_4.rim.t.Mass"
                                       << "Radius=$(0.01*(1+index)) Mass=9";
        QTest::newRow("of the ring") << "RobotConfig.Kit.spoke.Radius"
                                     << "Count=4 Radius=9";
    }
    void editTargets() {
        QFETCH(QString, asked);
        QFETCH(QString, text);
        ConfigUsers users;
        const EditTarget found = targetOfValue(*m_loaded, asked.toStdString(), users);
        const Result<FileEdits> edits = editsForValues(*m_loaded, {{found.path, std::string("9")}});
        QVERIFY2(edits.ok(), edits.ok() ? "" : edits.error().message.c_str());
        EditPlan plan;
        plan.edits = edits.value();
        const std::string after = m_fixture.text(m_loaded, plan);
        QVERIFY2(after.find(text.toStdString()) != std::string::npos, after.c_str());
    }

    void renames_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("the Repeat") << "RobotConfig.Kit.roller"
                                    << "wheel"
                                    << QStringList{"Repeat wheel {", "Joint=wheel_1.axle",
                                                   "wheel.motor.Resistance=7 wheel_4.motor", "a/wheel_2.motor/voltage"};
        QTest::newRow("a block in it") << "RobotConfig.Kit.roller.axle"
                                       << "pin" << QStringList{"Hinge pin {", "Joint=pin", "Joint=roller_1.pin"};
        QTest::newRow("what it names around it") << "RobotConfig.Kit.hub"
                                                 << "core" << QStringList{"Body core {", "Parent=core"};
        QTest::newRow("what it names in it") << "a.roller_1.rim"
                                             << "tread" << QStringList{"Body tread {", "Child=tread"};
    }
    void renames() {
        QFETCH(QString, path);
        QFETCH(QString, name);
        QFETCH(QStringList, texts);
        const auto plan = planRename(*m_loaded, path.toStdString(), name.toStdString());
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QCOMPARE(messages(*after), std::string());
        const QString bytes = QString::fromStdString(std::string(after->trees[0]->source().bytes()));
        for (const QString& text : texts) QVERIFY2(bytes.contains(text), qPrintable(bytes));
    }
    void refusesNamesOfMembers() {
        QVERIFY(!planRename(*m_loaded, "RobotConfig.Kit.hub", "roller_2").ok());
        QVERIFY(!planRename(*m_loaded, "RobotConfig.Kit.hub", "spoke_77").ok());
    }

    /// At the top level: paths, values, edits and names.
    void repeatsOfTheWorld() {
        m_loaded =
            m_fixture.open("Material red { } Surface floor { }\nRobotConfig Cart { Param m = 1 Body b { Box hull { Size=1,1,1 "
                           "Mass=$m Material=red Surface=floor } } }\n"
                           "Repeat row { Count=3 Pos=0,$(2*index),0\n  Robot a { Config=Cart m=$(1+index) } Robot c { "
                           "Config=Cart Pos=1.5,0,0 }\n"
                           "  Fixed f { Parent=a.b Child=c.b } }\n"
                           "Fixed g { Parent=row_0.a.b Child=row_1.c.b }\nPoseLog log { Robot=row.a }\n");
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
        for (const char* path : {"row_2.a", "row.a", "row_2.a.b.hull", "row.f"}) {
            const auto place = placeOf(*m_loaded, path);
            QVERIFY2(place && place->part, path);
            QCOMPARE(place->members.size(), std::size_t(std::string(path).find('_') != std::string::npos));
        }
        QVERIFY(!placeOf(*m_loaded, "row_2.b"));
        const auto mass = [&](const char* path) { return ObjectValues(m_loaded, path).property("Mass")->value->numbers.at(0); };
        QCOMPARE(mass("row_2.a.b.hull"), 3.0);
        QCOMPARE(mass("row.a.b.hull"), 1.0);
        const DescribedFrame frame = describedFrame(*m_loaded, *placeOf(*m_loaded, "row_2.c"));
        QCOMPARE(frame.pose.position, Vec3(0, 4, 0));
        const auto edited = [&](const char* path) {
            ConfigUsers users;
            const EditTarget found = targetOfValue(*m_loaded, path, users);
            const Result<FileEdits> edits = editsForValues(*m_loaded, {{found.path, std::string("9")}});
            EditPlan plan;
            if (edits.ok()) plan.edits = edits.value();
            return QString::fromStdString(m_fixture.text(m_loaded, plan));
        };
        QVERIFY2(edited("row_1.a.m").contains("Robot a { Config=Cart m=9 }"), qPrintable(edited("row_1.a.m")));
        QVERIFY2(edited("row_1.a.b.hull.Mass").contains("m=$(1+index) b.hull.Mass=9 }"),
                 qPrintable(edited("row_1.a.b.hull.Mass")));
        QVERIFY2(edited("row.Count").contains("Repeat row { Count=9"), qPrintable(edited("row.Count")));
        const auto renamed = [&](const char* path, const char* name) {
            const auto after = m_fixture.apply(m_loaded, planRename(*m_loaded, path, name));
            return after && messages(*after).empty() ? QString::fromStdString(std::string(after->trees[0]->source().bytes()))
                                                     : QString::fromStdString(after ? messages(*after) : std::string("no plan"));
        };
        const QString robot = renamed("row.a", "cart");
        for (const char* text : {"Parent=cart.b", "row_0.cart.b", "Robot=row.cart"})
            QVERIFY2(robot.contains(text), qPrintable(robot));
        const QString repeat = renamed("row", "line");
        for (const char* text : {"Repeat line", "line_0.a.b Child=line_1.c.b", "Robot=line.a"})
            QVERIFY2(repeat.contains(text), qPrintable(repeat));
        const QString body = renamed("RobotConfig.Cart.b", "box");
        for (const char* text : {"Parent=a.box", "row_1.c.box"}) QVERIFY2(body.contains(text), qPrintable(body));
        for (const char* kind : {"Repeat", "Ring", "Robot", "Static", "Region", "Light"}) {
            for (const char* parent : {"", "row"}) {
                const auto plan = planInsert(*m_loaded, parent, templateOf(*m_loaded, *m_loaded->registry->find(kind), parent));
                const auto after = m_fixture.apply(m_loaded, plan);
                QVERIFY2(after, plan.ok() ? kind : plan.error().message.c_str());
                QVERIFY2(messages(*after).empty(), (std::string(kind) + " in " + parent + ": " + messages(*after)).c_str());
            }
        }
    }

    /// What a template inserts is valid, at every place that may hold one.
    void templatesAreValid_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("parent");
        for (const char* kind : {"Repeat", "Ring", "Body", "Hinge", "RotaryMotor"})
            for (const char* parent : {"RobotConfig.Kit", "RobotConfig.Kit.roller", "RobotConfig.Kit.spoke"})
                QTest::addRow("%s in %s", kind, parent) << kind << parent;
        for (const char* kind : {"Repeat", "Ring", "Box"})
            for (const char* parent : {"StaticConfig.Fence", "StaticConfig.Fence.post", "PartConfig.Rail"})
                QTest::addRow("%s in %s", kind, parent) << kind << parent;
    }
    void templatesAreValid() {
        QFETCH(QString, kind);
        QFETCH(QString, parent);
        m_loaded = m_fixture.open(
            kKit + kRobots +
            "StaticConfig Fence { Repeat post { Count=2 Pos=$index,0,0 Box b { Size=1,1,1 Material=red Surface=floor } } }\n"
            "PartConfig Rail { Repeat bar { Count=2 Box b { Size=1,1,1 Material=red Surface=floor } } }\n");
        QCOMPARE(messages(*m_loaded), std::string());
        const std::string text = templateOf(*m_loaded, *m_loaded->registry->find(kind.toStdString()), parent.toStdString());
        const auto plan = planInsert(*m_loaded, parent.toStdString(), text);
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QVERIFY2(messages(*after).empty(), (text + "\n" + messages(*after)).c_str());
        QVERIFY(placeOf(*after, plan.value().selects.at(plan.value().selects.size() - 1)));
    }

    /// On top of the robot, not in it; also where what is selected is in the config that gets them.
    void templatesAreOnTop() {
        m_loaded = m_fixture.open("RobotConfig Cart {\n  Body chassis { Pos=0,0,0.1 Box hull { Size=0.4,0.3,0.2 Mass=1 } }\n"
                                  "  Body arm { Pos=0,0,0.25 Box b { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                  "  Hinge elbow { Parent=chassis Child=arm }\n}\nRobot r { Config=Cart }\n");
        const auto text = [&](const char* kind, const char* parent) {
            return QString::fromStdString(templateOf(*m_loaded, *m_loaded->registry->find(kind), parent));
        };
        for (const char* parent : {"RobotConfig.Cart", "r", "r.elbow"}) {
            QCOMPARE(text("Repeat", parent),
                     QStringLiteral("Repeat repeat { Count=3 Pos=$(0.2*index),0,0\n"
                                    "  Body body { Pos=0,0,0.35 Box box { Size=0.1,0.1,0.1 Mass=0.1 } }\n}"));
            QCOMPARE(text("Ring", parent), QStringLiteral("Ring ring { Count=3 Radius=0.1 Pos=0,0,0.35\n"
                                                          "  Body body { Box box { Size=0.1,0.1,0.1 Mass=0.1 } }\n}"));
        }
    }

    /// The proposed step of a Repeat: the width of the blocks, rounded up.
    void stepsKeepMembersApart_data() {
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<double>("step");
        QTest::newRow("body") << QStringList{"RobotConfig.Cart.chassis"} << 0.35;
        QTest::newRow("through a robot") << QStringList{"r.chassis"} << 0.35;
        QTest::newRow("small body") << QStringList{"r.arm"} << 0.04;
        QTest::newRow("two bodies") << QStringList{"r.arm", "r.hand"} << 0.25;
        QTest::newRow("the second counts from the first") << QStringList{"r.arm", "r.finger"} << 0.55;
        QTest::newRow("turned") << QStringList{"r.hand"} << 0.25;
        QTest::newRow("geom") << QStringList{"r.chassis.hull"} << 0.35;
        QTest::newRow("ball") << QStringList{"r.eye"} << 0.25; // 0.2 wide
        QTest::newRow("joint") << QStringList{"r.elbow"} << 0.1;
        QTest::newRow("Part") << QStringList{"r.left"} << 0.06;
        QTest::newRow("Repeat") << QStringList{"r.row"} << 0.45;
        QTest::newRow("robot") << QStringList{"r"} << 1.1;
    }
    void stepsKeepMembersApart() {
        QFETCH(QStringList, paths);
        QFETCH(double, step);
        m_loaded =
            m_fixture.open("PartConfig Wheel { Body wheel { Cylinder tyre { Radius=0.1 Length=0.05 HPR=0,0,90 Mass=1 } } }\n"
                           "RobotConfig Cart {\n  Body chassis { Box hull { Size=0.4,0.3,0.2 Mass=1 } }\n"
                           "  Body arm { Pos=0,0,0.25 Box b { Size=0.1,0.03,0.1 Mass=1 } }\n"
                           "  Body hand { Pos=0,0.05,0.25 HPR=90,0,0 Box b { Size=0.2,0.01,0.1 Mass=1 } }\n"
                           "  Body finger { In=arm Pos=0,0.5,0 Box b { Size=0.01,0.01,0.1 Mass=1 } }\n"
                           "  Part left { Config=Wheel Pos=0,0.2,0 Mirror=y }\n"
                           "  Repeat row { Count=3 Pos=0,$(0.2*index),0 Body b { Box b { Size=0.1,0.02,0.1 Mass=1 } } }\n"
                           "  Body eye { Pos=0,0,0.4 Sphere b { Radius=0.1 Mass=1 } }\n"
                           "  Hinge elbow { Parent=chassis Child=arm }\n}\nRobot r { Config=Cart }\n");
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        const Vec3 found = repeatStep(*m_loaded, all);
        QVERIFY(found.x() == 0 && found.z() == 0);
        QVERIFY2(std::abs(found.y() - step) < 1e-9, qPrintable(QString::number(found.y())));
    }

    /// A value changed in a variant is written there; what is added, too; names are renamed in it.
    void variantsGetOverrides() {
        const std::string variant =
            kKit + "RobotConfig Big { Config=Kit hub.hull.Mass=4 }\nRobot a { Config=Kit }\nRobot b { Config=Big }\n"
                   "Robot c { Config=Big }\n";
        m_loaded = m_fixture.open(variant);
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
        const auto place = placeOf(*m_loaded, "RobotConfig.Big.hub.hull");
        QVERIFY(place && place->part && place->instance);
        QCOMPARE(place->instance->name, std::string("Big"));
        QCOMPARE(place->within, std::string("hub.hull"));
        const auto mass = [&](const char* path) { return ObjectValues(m_loaded, path).property("Mass")->value->numbers.at(0); };
        QCOMPARE(mass("a.hub.hull"), 2.0);
        QCOMPARE(mass("b.hub.hull"), 4.0);
        QCOMPARE(mass("RobotConfig.Big.hub.hull"), 4.0);
        const auto edited = [&](const char* path) {
            ConfigUsers users;
            const EditTarget found = targetOfValue(*m_loaded, path, users);
            const Result<FileEdits> edits = editsForValues(*m_loaded, {{found.path, std::string("9")}});
            EditPlan plan;
            if (edits.ok()) plan.edits = edits.value();
            return QString::fromStdString(m_fixture.text(m_loaded, plan));
        };
        QVERIFY2(edited("RobotConfig.Big.roller.rim.t.Mass").contains("hub.hull.Mass=4 roller.rim.t.Mass=9 }"),
                 qPrintable(edited("RobotConfig.Big.roller.rim.t.Mass")));
        QVERIFY2(edited("RobotConfig.Big.n").contains("hub.hull.Mass=4 n=9 }"), qPrintable(edited("RobotConfig.Big.n")));
        QVERIFY(edited("RobotConfig.Big.hub.hull.Mass").contains("Config=Kit hub.hull.Mass=9 }"));
        QVERIFY(edited("b.hub.hull.Mass").contains("Robot b { Config=Big hub.hull.Mass=9 }"));
        const auto added =
            m_fixture.apply(m_loaded, planInsert(*m_loaded, "RobotConfig.Big.hub",
                                                 "Body mast { Box b { Size=1,1,1 Mass=1 Material=red Surface=floor } }"));
        QVERIFY(added);
        QCOMPARE(messages(*added), std::string());
        QVERIFY(std::string(added->trees[0]->source().bytes()).find("Big { Config=Kit hub.hull.Mass=4 Body mast") !=
                std::string::npos);
        m_loaded = m_fixture.open(variant);
        const auto renamed = m_fixture.apply(m_loaded, planRename(*m_loaded, "RobotConfig.Kit.hub", "core"));
        QVERIFY(renamed);
        QCOMPARE(messages(*renamed), std::string());
        QVERIFY(std::string(renamed->trees[0]->source().bytes()).find("Config=Kit core.hull.Mass=4") != std::string::npos);
        m_loaded = m_fixture.open(variant);
        const auto config = m_fixture.apply(m_loaded, planRename(*m_loaded, "RobotConfig.Kit", "Base"));
        QVERIFY(config);
        QCOMPARE(messages(*config), std::string());
    }

private:
    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(RepeatEditsTest)
#include "repeat_edits_test.moc"
