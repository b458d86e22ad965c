// Repeat and Ring in a Body, in the editor's view of a text: paths, values, frames, edits, names, templates.
#include <QTest>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/edits/edit_target.h"
#include "project/edits/plan_wrap.h"
#include "project/edits/value_edits.h"
#include "project/objects/object_values.h"
#include "project/objects/part_values.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kKit = R"(Material red { ColorRGB=1,0,0 }
Surface floor { Friction=1 }

RobotConfig Kit {
  Body hub {
    Pos=1,0,0
    Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor }
    Box fin { Size=0.3,0.2,0.1 Pos=0,0,0.2 Mass=1 Material=red Surface=floor }
    Repeat disc {
      Count=3 Pos=$(0.1*index),0,0 HPR=90,0,0
      Sphere t { Radius=0.01 Pos=0.01,0,0 Mass=0.1 Material=red Surface=floor }
    }
  }
  Repeat post {
    Count=2 Pos=$index,1,0
    Body b {
      Mass=1
      Ring spoke { Count=4 Radius=0.5 Box w { Size=0.1,0.1,0.1 Material=red Surface=floor } }
    }
  }
  TouchSensor touch { Geom=hub.disc_1.t, hub.fin, post_1.b.spoke_3.w }
}

Robot a { Config=Kit }
Robot c { Config=Kit hub.disc.t.Radius=0.02 hub.disc_2.t.Radius=0.03 }
)";

std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all())
        if (d.severity == Severity::Error) all += d.message + "\n";
    return all;
}

} // namespace

class BodyRepeatEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open(kKit);
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
    }

    void pathsAndValuesOfMembers() {
        const auto radius = [&](const char* path) { return ObjectValues(m_loaded, path).property("Radius")->value->numbers.at(0); };
        QCOMPARE(radius("a.hub.disc_1.t"), 0.01);
        QCOMPARE(radius("c.hub.disc_1.t"), 0.02);
        QCOMPARE(radius("c.hub.disc_2.t"), 0.03);
        QCOMPARE(radius("c.hub.disc.t"), 0.02);
        QVERIFY(!placeOf(*m_loaded, "a.hub.disk_1.t"));
        QCOMPARE(placeOf(*m_loaded, "a.post_1.b.spoke_3.w")->members.size(), std::size_t(2));
    }

    /// The frame that a geom is described in is where the world has it.
    void frames() {
        std::size_t geoms = 0;
        for (const BodySpec& body : m_loaded->experiment->robots[0].config->bodies) {
            for (const GeomSpec& geom : body.geoms) {
                const auto place = placeOf(*m_loaded, "a." + body.name + "." + geom.name);
                QVERIFY2(place && place->part, geom.name.c_str());
                const Pose there = describedFrame(*m_loaded, *place).pose * poseAt(*m_loaded, *place), &is = geom.pose;
                QVERIFY2((there.position - is.position).norm() < 1e-12, geom.name.c_str());
                QVERIFY2(there.rotation.angularDistance(is.rotation) < 1e-7, geom.name.c_str());
                ++geoms;
            }
        }
        QCOMPARE(geoms, std::size_t(13));
    }

    void valuesAreWritten_data() {
        QTest::addColumn<QString>("asked");
        QTest::addColumn<QString>("text");
        QTest::newRow("one") << "a.hub.disc_1.t.Radius" << "Robot a { Config=Kit hub.disc_1.t.Radius=9 }";
        QTest::newRow("all") << "a.hub.disc.t.Radius" << "Robot a { Config=Kit hub.disc.t.Radius=9 }";
        QTest::newRow("count") << "a.hub.disc.Count" << "Robot a { Config=Kit hub.disc.Count=9 }";
        QTest::newRow("in the config") << "RobotConfig.Kit.hub.disc_1.t.Radius" << "Sphere t { Radius=9 Pos";
        QTest::newRow("in both") << "RobotConfig.Kit.post.b.spoke.w.Mass" << "Material=red Surface=floor Mass=9 } }";
    }
    void valuesAreWritten() {
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
        QTest::newRow("the Repeat") << "RobotConfig.Kit.hub.disc" << "plate"
                                    << QStringList{"Repeat plate {", "Geom=hub.plate_1.t,", "hub.plate.t.Radius=0.02", "hub.plate_2.t"};
        QTest::newRow("a geom in it") << "RobotConfig.Kit.hub.disc.t" << "ball"
                                      << QStringList{"Sphere ball {", "hub.disc_1.ball,", "hub.disc_2.ball.Radius"};
        QTest::newRow("the body") << "RobotConfig.Kit.hub" << "core" << QStringList{"core.disc_1.t, core.fin", "core.disc.t.Radius"};
        QTest::newRow("in a Repeat") << "a.post_1.b.spoke_2.w" << "arm" << QStringList{"post_1.b.spoke_3.arm"};
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

    void templatesAreValid_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("begins");
        for (const char* kind : {"Repeat", "Ring", "Box", "Sphere", "Mesh"})
            for (const char* parent : {"RobotConfig.Kit.hub", "RobotConfig.Kit.hub.disc", "RobotConfig.Kit.post.b.spoke", "a.post_1.b"})
                QTest::addRow("%s in %s", kind, parent) << kind << parent;
    }
    void templatesAreValid() {
        QFETCH(QString, kind);
        QFETCH(QString, parent);
        const std::string text = templateOf(*m_loaded, *m_loaded->registry->find(kind.toStdString()), parent.toStdString());
        const auto plan = planInsert(*m_loaded, parent.toStdString(), text);
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QVERIFY2(messages(*after).empty(), (text + "\n" + messages(*after)).c_str());
        const std::string added = plan.value().selects.at(plan.value().selects.size() - 1);
        QVERIFY(placeOf(*after, added));
        QVERIFY2(added.find("hub.") != std::string::npos || added.find("b.") != std::string::npos, added.c_str());
    }

    /// A Repeat of what no Body can hold goes around it.
    void repeatsOfSensorsGoAroundTheBody() {
        const auto plan = planInsert(*m_loaded, "RobotConfig.Kit.hub", "Repeat eye { Count=2 RangeSensor r { Body=hub Pos=0,$index,0 MaxRange=2 } }");
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QCOMPARE(messages(*after), std::string());
        QCOMPARE(plan.value().selects, std::vector<std::string>{"RobotConfig.Kit.eye"});
    }

    /// What no Body can hold goes around the Repeat in it, too.
    void partsGoAroundTheRepeatOfABody() {
        const auto plan = planInsert(*m_loaded, "RobotConfig.Kit.hub.disc", "Hinge h { Parent=hub Child=post_0.b Axis=0,1,0 }");
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QCOMPARE(messages(*after), std::string());
        QCOMPARE(plan.value().selects, std::vector<std::string>{"RobotConfig.Kit.h"});
    }

    /// Nor a Part, also one that has geoms only.
    void noPartsComeIntoABody() {
        const auto loaded = m_fixture.open(kKit + "PartConfig Slab { Box slab { Size=1,1,1 Material=red Surface=floor } }\n"
                                                  "StaticConfig Yard { Repeat slabs { Count=1 Part slab { Config=Slab } } }\n");
        for (const char* inside : {"hub", "hub.disc"})
            QVERIFY(!planMove(*loaded, {"StaticConfig.Yard.slabs"}, std::string("RobotConfig.Kit.") + inside, {}).ok());
    }

    /// Geoms of a body become members of a Repeat, and names follow.
    void geomsAreRepeated() {
        const auto plan = planRepeat(*m_loaded, {"RobotConfig.Kit.hub.fin"}, 3, {0, 0, 0.25});
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(after, plan.ok() ? "" : plan.error().message.c_str());
        QCOMPARE(messages(*after), std::string());
        const std::string text(after->trees[0]->source().bytes());
        QVERIFY2(text.find("    Repeat fin {\n      Count=3 Pos=0,0,$(0.25*index)\n      Box fin {") != std::string::npos,
                 text.c_str());
        QVERIFY2(text.find("hub.fin_0.fin, post_1") != std::string::npos, text.c_str());
        QCOMPARE(format(*after->trees[0]), text);
        QCOMPARE(after->experiment->robots[0].config->bodies[0].geoms.size(), std::size_t(7));
    }

    /// Patterns of logs into Repeats of the world, and into Repeats of a robot, follow renames; what they name is still used.
    void patternsIntoRepeatsFollowRenames() {
        const std::string ball = " { Sphere s { Radius=0.1 Mass=1 Material=red Surface=floor } }\n";
        const std::string motor = "TorqueConstant=1 SpeedConstant=1 Resistance=1 MaxVoltage=12 }\n";
        const auto loaded = m_fixture.open(
            "Material red { }\nSurface floor { }\nRobotConfig Cart {\n  Body hull" + ball + "  Body wheel" + ball +
            "  Hinge axle { Parent=hull Child=wheel }\n  RotaryMotor leftMotor { Joint=axle " + motor +
            "  Repeat roller { Count=2\n    Body rim" + ball +
            "    Hinge pin { Parent=hull Child=rim }\n    RotaryMotor motor { Joint=pin " + motor +
            "  }\n}\nRepeat lane { Count=2 Pos=0,$(9*index),0\n  Robot cart { Config=Cart }\n"
            "  Grid crowd { Config=Cart Count=2 Spacing=3 Pos=4,0,0 }\n}\n"
            "SignalLog one { Signals=\"lane_*.cart/leftMotor/current\" }\n"
            "SignalLog two { Signals=\"lane_1.crowd_*/leftMotor/current\", \"lane_?.cart/roller_*.motor/current\" }\n"
            "SignalLog three { Signals=\"lane_*/wheel/pose\" }\nPoseLog all { Robot=\"lane_*\" }\n");
        QCOMPARE(messages(*loaded), std::string());
        for (const auto& [path, name, texts] : std::vector<std::tuple<std::string, std::string, QStringList>>{
                 {"lane",
                  "track",
                  {"\"track_*.cart/left", "\"track_1.crowd_*/", "\"track_?.cart/", "\"track_*/wheel", "Robot=\"track_*\""}},
                 {"lane.cart", "wagon", {"\"lane_*.wagon/left", "\"lane_?.wagon/roller"}},
                 {"lane.crowd", "flock", {"\"lane_1.flock_*/"}},
                 {"RobotConfig.Cart.leftMotor", "drive", {"lane_*.cart/drive/current", "crowd_*/drive/current"}},
                 {"RobotConfig.Cart.roller", "drum", {"cart/drum_*.motor/current"}},
                 {"RobotConfig.Cart.roller.motor", "drive", {"cart/roller_*.drive/current"}},
                 {"RobotConfig.Cart.wheel", "tyre", {"\"lane_*/tyre/pose"}}}) {
            const QString text = QString::fromStdString(m_fixture.text(loaded, planRename(*loaded, path, name)));
            for (const QString& part : texts) QVERIFY2(text.contains(part), qPrintable(text));
        }
        const std::string removed = m_fixture.text(loaded, planRemove(*loaded, {"RobotConfig.Cart.leftMotor"}));
        QVERIFY2(removed.starts_with("refused: ") && removed.find("SignalLog one") != std::string::npos, removed.c_str());
    }

    void moves() {
        const auto text = [&](const Result<EditPlan>& plan) { return QString::fromStdString(m_fixture.text(m_loaded, plan)); };
        const QString moved = text(planMove(*m_loaded, {"RobotConfig.Kit.hub.hull"}, "RobotConfig.Kit.hub.disc", {}));
        QVERIFY2(moved.contains("Surface=floor }\n      Box hull { Size=0.3,0.2,0.1 Mass=2"), qPrintable(moved));
        QCOMPARE(text(planMove(*m_loaded, {"RobotConfig.Kit.hub.fin"}, "RobotConfig.Kit.hub.disc", {})),
                 QString("refused: Box fin is still used by TouchSensor touch (Geom)"));
        for (const char* outside : {"post", "post.b"})
            for (const char* inside : {"hub.disc", "hub"})
                QCOMPARE(text(planMove(*m_loaded, {std::string("RobotConfig.Kit.") + outside}, std::string("RobotConfig.Kit.") + inside, {})).left(8),
                         QString("refused:"));
        QCOMPARE(text(planMove(*m_loaded, {"RobotConfig.Kit.touch"}, "RobotConfig.Kit.hub.disc", {})).left(8), QString("refused:"));
        const QString part = text(planMakePart(*m_loaded, {"RobotConfig.Kit.hub.disc"}));
        QCOMPARE(part, QString("refused: Repeat disc is not directly in a config; select bodies, joints and devices of one"));
    }

private:
    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(BodyRepeatEditsTest)
#include "body_repeat_edits_test.moc"
