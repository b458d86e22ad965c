// Parts in the editor's view of a text: what a path leads to, values with their origin, where an edit goes, renaming.
#include <QTest>

#include "plan_fixture.h"
#include "project/edits/edit_target.h"
#include "project/edits/insert_positions.h"
#include "project/edits/path_after_edit.h"
#include "project/edits/value_edits.h"
#include "project/objects/object_values.h"
#include "project/objects/part_values.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kWheel = R"(Material red { ColorRGB=1,0,0 }
Surface floor { Friction=1 }
PartConfig Wheel {
  Param r = 0.05
  Body wheel { Pos=0,0.01,0 Cylinder tyre { Radius=$r Length=0.02 Mass=0.1 Material=red Surface=floor } }
  Hinge axle { Parent=$carrier Child=wheel }
  RotaryMotor motor { Joint=axle TorqueConstant=1 SpeedConstant=1 Resistance=2 MaxVoltage=12 }
}
)";
const std::string kKit = R"(RobotConfig Kit {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }
  Part left { Config=Wheel Pos=0,0.1,0 carrier=chassis motor.Resistance=5 }
  Part right { Config=Wheel Pos=0,-0.1,0 HPR=0,0,90 Mirror=y carrier=chassis r=0.06 }
}
)";
const std::string kRobots = "Robot a { Config=Kit }\nRobot b { Config=Kit left.motor.Resistance=7 right.r=0.07 }\n";

std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all())
        if (d.severity == Severity::Error) all += d.message + "\n";
    return all;
}

} // namespace

class PartsEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_loaded = m_fixture.open(kWheel + kKit + kRobots);
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
    }

    void pathsLeadIntoParts() {
        const auto wheel = placeOf(*m_loaded, "a.left.wheel.tyre");
        QVERIFY(wheel && wheel->part);
        QCOMPARE(wheel->part->kind->name, std::string("Cylinder"));
        QCOMPARE(wheel->instance->name, std::string("a"));
        QCOMPARE(wheel->within, std::string("left.wheel.tyre"));
        std::string above;
        for (const Part* part : wheel->above) above += part->name + " ";
        QCOMPARE(above, std::string("Kit left Wheel wheel "));
        const auto inConfig = placeOf(*m_loaded, "RobotConfig.Kit.left.wheel");
        QCOMPARE(inConfig->instance->name, std::string("left"));
        QCOMPARE(inConfig->within, std::string("wheel"));
        QVERIFY(!placeOf(*m_loaded, "RobotConfig.Kit.chassis")->instance);
        QCOMPARE(placeOf(*m_loaded, "RobotConfig.Kit.left")->instance, placeOf(*m_loaded, "RobotConfig.Kit.left")->part);
        QVERIFY(!placeOf(*m_loaded, "a.left.nothing"));
    }

    /// Shapes for a body of a Part belong in its PartConfig; the menu and planInsert() agree.
    void insertionsGoIntoThePartConfig() {
        const auto loaded = m_fixture.open(kWheel + kKit + "RobotConfig Big { Config=Kit }\nRobot a { Config=Kit }\nRobot big { Config=Big }\n");
        const std::pair<const char*, const char*> all[] = {{"a.left.wheel.tyre", "PartConfig.Wheel.wheel.tyre"},
                                                           {"RobotConfig.Kit.right.axle", "PartConfig.Wheel.axle"},
                                                           {"a.left", "RobotConfig.Kit.left"},
                                                           {"big.chassis", "RobotConfig.Kit.chassis"}};
        for (const auto& [path, block] : all) QCOMPARE(definedAt(*loaded, path), std::string(block));
        const auto placeOfKind = [&](const char* selected, const char* kind) {
            const Kind* one[] = {loaded->registry->find(kind)};
            return placeFor(*loaded, selected, one).value_or("nowhere");
        };
        QCOMPARE(placeOfKind("a.left.wheel.tyre", "Box"), std::string("PartConfig.Wheel.wheel"));
        QCOMPARE(placeOfKind("a.left.axle", "Encoder"), std::string("PartConfig.Wheel"));
        QCOMPARE(placeOfKind("a.left", "Body"), std::string("RobotConfig.Kit"));
        QCOMPARE(placeOfKind("big.chassis", "Box"), std::string("RobotConfig.Kit.chassis"));
        const auto plan = planInsert(*loaded, "a.left.wheel", "Box cap { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor }");
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        QCOMPARE(plan.value().selects.at(0).c_str(), "a.left.wheel.cap");
    }

    /// A Param of a Part that a robot sets: back, up into the Part, down from it; one that is declared nowhere is declared.
    void paramsOfPartsMoveUpAndDown() {
        const auto text = [&](const Result<EditPlan>& plan) { return m_fixture.text(m_loaded, plan); };
        const std::string all = kWheel + kKit + kRobots;
        const auto with = [&](std::string from, const std::string& to, std::string in) {
            const std::size_t at = in.find(from);
            return at == std::string::npos ? "no " + from : in.replace(at, from.size(), to);
        };
        const std::string reset = with(" right.r=0.07", "", all);
        QCOMPARE(text(planReset(*m_loaded, {"b.right.r"})), reset);
        QCOMPARE(text(planPushOverride(*m_loaded, "b.right.r")), with("r=0.06", "r=0.07", reset));
        QCOMPARE(text(planPullOverride(*m_loaded, "a.right.r")),
                 with("Robot a { Config=Kit }", "Robot a { Config=Kit right.r=0.06 }", all));
        QCOMPARE(text(planPullOverride(*m_loaded, "a.left.r")),
                 with("Robot a { Config=Kit }", "Robot a { Config=Kit left.r=0.05 }", all));
        QVERIFY(text(planReset(*m_loaded, {"RobotConfig.Kit.left.carrier"})).find("must be given") != std::string::npos);
        const std::string pushed = text(planPushOverride(*m_loaded, "RobotConfig.Kit.left.carrier"));
        QVERIFY2(pushed.find("  Param r = 0.05\n  Param carrier = chassis\n  Body wheel ") != std::string::npos &&
                     pushed.find("Parent=$carrier Child") != std::string::npos &&
                     pushed.find("Pos=0,0.1,0 motor") != std::string::npos,
                 pushed.c_str());
        const auto after = m_fixture.open(pushed);
        QCOMPARE(messages(*after), std::string());
        m_loaded = m_fixture.open(all);
        const Result<FileEdits> edits =
            editsForValues(*m_loaded, {{DottedPath("PartConfig.Wheel.carrier"), ParsedValue("chassis")}});
        QVERIFY(edits.ok());
        const std::string declared = text(EditPlan{edits.value(), {}});
        QVERIFY2(declared.find("  Param r = 0.05\n  Param carrier = chassis\n  Body wheel ") != std::string::npos &&
                     declared.find("Parent=$carrier Child") != std::string::npos,
                 declared.c_str());
        QCOMPARE(messages(*m_fixture.open(declared)), std::string());
    }

    void values_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<QString>("property");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("origin");
        const auto row = [](const char* object, const char* property, const char* text, ValueOrigin origin) {
            QTest::newRow((std::string(object) + "." + property).c_str()) << object << property << text << int(origin);
        };
        row("a.left.motor", "Resistance", "5", ValueOrigin::Config);
        row("b.left.motor", "Resistance", "7", ValueOrigin::Override);
        row("b.right.motor", "Resistance", "2", ValueOrigin::Config);
        row("RobotConfig.Kit.left.motor", "Resistance", "5", ValueOrigin::Override);
        row("RobotConfig.Kit.right.motor", "Resistance", "2", ValueOrigin::Config);
        row("PartConfig.Wheel.motor", "Resistance", "2", ValueOrigin::Own);
        row("RobotConfig.Kit.right", "Mirror", "y", ValueOrigin::Own);
        row("a.right", "Mirror", "y", ValueOrigin::Config);
        row("a.left", "Mirror", "none", ValueOrigin::Default);
    }
    void values() {
        QFETCH(QString, object);
        QFETCH(QString, property);
        QFETCH(QString, text);
        QFETCH(int, origin);
        ObjectValues values(m_loaded, object.toStdString());
        const auto value = values.property(property.toStdString());
        QVERIFY(value);
        QCOMPARE(QString::fromStdString(value->text), text);
        QCOMPARE(int(value->origin), origin);
    }

    /// What an override replaces is the value that holds without it: here that of the Part.
    void inheritedValues() {
        ObjectValues motor(m_loaded, "b.left.motor");
        const auto value = motor.property("Resistance");
        QCOMPARE(value->config, std::string("Kit"));
        QVERIFY2(value->inherited.starts_with("5"), value->inherited.c_str());
    }

    /// A formula in a part shows its value with the Params of each use.
    void paramsOfEachUse() {
        const auto radius = [&](const char* path) {
            ObjectValues tyre(m_loaded, path);
            return tyre.property("Radius")->value->numbers.at(0);
        };
        QCOMPARE(radius("PartConfig.Wheel.wheel.tyre"), 0.05);
        QCOMPARE(radius("RobotConfig.Kit.right.wheel.tyre"), 0.06);
        QCOMPARE(radius("a.right.wheel.tyre"), 0.06);
        QCOMPARE(radius("b.right.wheel.tyre"), 0.07);
        ObjectValues right(m_loaded, "b.right");
        QVERIFY(right.isInstance());
        QCOMPARE(right.config()->name, std::string("Wheel"));
        const std::vector<FieldValue> params = right.params(10);
        QCOMPARE(params.size(), std::size_t(2));
        QCOMPARE(params[0].path, std::string("b.right.r"));
        QCOMPARE(params[0].text, std::string("0.07"));
        QCOMPARE(params[1].path, std::string("b.right.carrier"));
        QCOMPARE(params[1].text, std::string("chassis"));
    }

    /// A value changed on an instance is an override there; the outermost instance of the path has it.
    void editTargets_data() {
        QTest::addColumn<QString>("robots");
        QTest::addColumn<QString>("asked");
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, const std::string& robots, const char* asked, const char* target,
                            const char* text) {
            QTest::newRow(name) << QString::fromStdString(robots) << asked << target << text;
        };
        const std::string one = "Robot a { Config=Kit }\n";
        row("of one of two robots", kRobots, "a.left.wheel.tyre.Mass", "a.left.wheel.tyre.Mass",
            "a { Config=Kit left.wheel.tyre.Mass=9");
        row("of the only robot: in its config", one, "a.left.wheel.tyre.Mass", "RobotConfig.Kit.left.wheel.tyre.Mass",
            "motor.Resistance=5 wheel.tyre.Mass=9");
        row("of a Part", kRobots, "RobotConfig.Kit.left.wheel.tyre.Mass", "RobotConfig.Kit.left.wheel.tyre.Mass",
            "motor.Resistance=5 wheel.tyre.Mass=9");
        row("an override of a Part", kRobots, "RobotConfig.Kit.left.motor.Resistance", "RobotConfig.Kit.left.motor.Resistance",
            "carrier=chassis motor.Resistance=9");
        row("a Param of a Part", kRobots, "RobotConfig.Kit.right.r", "RobotConfig.Kit.right.r", "carrier=chassis r=9");
        row("a Param through a robot", kRobots, "b.left.r", "b.left.r", "right.r=0.07 left.r=9");
        row("its own property", kRobots, "RobotConfig.Kit.left.Pos", "RobotConfig.Kit.left.Pos", "left { Config=Wheel Pos=9");
        row("the part for all uses", kRobots, "PartConfig.Wheel.motor.Resistance", "PartConfig.Wheel.motor.Resistance",
            "SpeedConstant=1 Resistance=9");
    }
    void editTargets() {
        QFETCH(QString, robots);
        QFETCH(QString, asked);
        QFETCH(QString, target);
        QFETCH(QString, text);
        m_loaded = m_fixture.open(kWheel + kKit + robots.toStdString());
        ConfigUsers users;
        const EditTarget found = targetOfValue(*m_loaded, asked.toStdString(), users);
        QCOMPARE(QString::fromStdString(found.path), target);
        const Result<FileEdits> edits = editsForValues(*m_loaded, {{found.path, std::string("9")}});
        QVERIFY2(edits.ok(), edits.ok() ? "" : edits.error().message.c_str());
        EditPlan plan;
        plan.edits = edits.value();
        const std::string after = m_fixture.text(m_loaded, plan);
        QVERIFY2(after.find(text.toStdString()) != std::string::npos, after.c_str());
    }

    /// A PartConfig with one use, in the same file, is changed itself, as a RobotConfig with one robot is.
    void changesAPartWithOneUse() {
        std::string kit = kKit;
        kit.erase(kit.find("  Part right"), kit.find("}\n}") + 2 - kit.find("  Part right"));
        m_loaded = m_fixture.open(kWheel + kit + "Robot a { Config=Kit }\n");
        QVERIFY(m_loaded);
        ConfigUsers users;
        QCOMPARE(targetOfValue(*m_loaded, "a.left.wheel.tyre.Mass", users).path, std::string("PartConfig.Wheel.wheel.tyre.Mass"));
        QCOMPARE(targetOfValue(*m_loaded, "a.left.motor.Resistance", users).path,
                 std::string("RobotConfig.Kit.left.motor.Resistance")); // it is overridden there
    }

    void resetsAndMovesOverrides() {
        const auto text = [&](const Result<EditPlan>& plan) { return m_fixture.text(m_loaded, plan); };
        QVERIFY(text(planReset(*m_loaded, {"RobotConfig.Kit.left.motor.Resistance"})).find("carrier=chassis }") !=
                std::string::npos);
        QVERIFY(text(planReset(*m_loaded, {"b.left.motor.Resistance"})).find("Kit right.r=0.07") != std::string::npos);
        const std::string pushed = text(planPushOverride(*m_loaded, "RobotConfig.Kit.left.motor.Resistance"));
        QVERIFY2(pushed.find("SpeedConstant=1 Resistance=5") != std::string::npos, pushed.c_str());
        const std::string pulled = text(planPullOverride(*m_loaded, "RobotConfig.Kit.right.motor.Resistance"));
        QVERIFY2(pulled.find("r=0.06 motor.Resistance=2") != std::string::npos, pulled.c_str());
    }

    /// Names of bodies given to Parts, and of what is in parts, are renamed everywhere.
    void renames() {
        const std::string drive =
            "RobotConfig Two { Body chassis { Box hull { Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Part left { Config=Wheel carrier=chassis } Part right { Config=Wheel carrier=chassis }\n"
            "  DifferentialDrive base { LeftMotor=left.motor RightMotor=right.motor WheelRadius=1 "
            "WheelSeparation=1 } }\nRobot t { Config=Two right.motor.Resistance=1 right.motor.Joint=axle }\n"
            "SignalLog log { Signals=\"t/left.motor/voltage\" }\n";
        m_loaded = m_fixture.open(kWheel + drive);
        QCOMPARE(messages(*m_loaded), std::string());
        const auto renamed = [&](const char* path, const char* name) {
            const auto plan = planRename(*m_loaded, path, name);
            const auto after = m_fixture.apply(m_loaded, plan);
            if (!after) return "refused: " + plan.error().message;
            const std::string errors = messages(*after);
            const std::string now = pathAfterEdit(*m_loaded, *after, "t.left.motor").value_or("nothing");
            m_loaded = m_fixture.open(kWheel + drive);
            return errors + now + " " + std::string(after->trees[0]->source().bytes());
        };
        QVERIFY(QString::fromStdString(renamed("RobotConfig.Two.chassis", "frame"))
                    .contains("carrier=frame } Part right { Config=Wheel carrier=frame"));
        const QString motor = QString::fromStdString(renamed("PartConfig.Wheel.motor", "engine"));
        QVERIFY2(motor.startsWith("t.left.engine ") && motor.contains("LeftMotor=left.engine RightMotor=right.engine") &&
                     motor.contains("right.engine.Resistance=1") && motor.contains("t/left.engine/voltage"),
                 qPrintable(motor));
        const QString axle = QString::fromStdString(renamed("PartConfig.Wheel.axle", "hub"));
        QVERIFY2(axle.startsWith("t.left.motor ") && axle.contains("right.motor.Joint=hub }"), qPrintable(axle));
        const QString captured =
            QString::fromStdString(renamed("PartConfig.Wheel.axle", "chassis")); // what Two has is looked up first
        QVERIFY2(captured.startsWith("refused: ") && captured.contains("would then name Body chassis"), qPrintable(captured));
        const QString use = QString::fromStdString(renamed("RobotConfig.Two.left", "port"));
        QVERIFY2(use.startsWith("t.port.motor ") && use.contains("LeftMotor=port.motor") && use.contains("t/port.motor/voltage"),
                 qPrintable(use));
    }

    /// `$carrier` that no text declares, with what Parts, variants and robots give for it.
    /// The word of a Param that an expression chooses, takes out of a list, or is.
    void renamesThroughExpressions() {
        const QString more =
            QStringLiteral("PartConfig Post { Param looks = red,red  Param other = red  Body p { "
                           "Box a { Size=1,1,1 Mass=1 Material=$(element(looks, 0)) Surface=floor } "
                           "Box b { Size=1,1,1 Mass=1 Material=$(if(1 > 2, other, more)) Surface=floor } } Param more = red }\n"
                           "RobotConfig One { Part post { Config=Post looks=red,red other=red } }\nRobot o { Config=One }\n");
        m_loaded = m_fixture.open(kWheel + more.toStdString());
        QCOMPARE(messages(*m_loaded), std::string());
        const auto after = m_fixture.apply(m_loaded, planRename(*m_loaded, "Material.red", "ruby"));
        QVERIFY(after);
        QCOMPARE(messages(*after), std::string());
        QCOMPARE(QString::fromStdString(std::string(after->trees[0]->source().bytes())),
                 QString::fromStdString(kWheel + more.toStdString()).replace(QLatin1String("red"), QLatin1String("ruby")));
    }

    void renamesWhatPartsGive() {
        const std::string more =
            "PartConfig Hub { Body hub { Box b { Size=1,1,1 Mass=1 Material=red Surface=floor } } Hinge h { Parent=$frame "
            "Child=hub }\n  Part wheel { Config=Wheel carrier=$frame } Part other { Config=Wheel carrier=hub } }\n"
            "RobotConfig Two { Body chassis { Box hull { Size=1,1,1 Mass=1 Material=red Surface=floor } }\n"
            "  Part left { Config=Wheel carrier=chassis } Part hub { Config=Hub frame=chassis } }\n"
            "Robot t { Config=Two left.carrier=chassis }\n";
        const auto renamed = [&](const char* path, const char* name) {
            m_loaded = m_fixture.open(kWheel + more);
            const auto plan = planRename(*m_loaded, path, name);
            const auto after = m_fixture.apply(m_loaded, plan);
            return QString::fromStdString(after ? messages(*after) + std::string(after->trees[0]->source().bytes())
                                                : "refused: " + plan.error().message);
        };
        const auto with = [&](std::initializer_list<std::pair<const char*, const char*>> all) {
            QString text = QString::fromStdString(kWheel + more);
            for (const auto& [was, now] : all) text.replace(QLatin1String(was), QLatin1String(now));
            return text;
        };
        QCOMPARE(renamed("PartConfig.Wheel.carrier", "on"), with({{"carrier", "on"}}));
        QCOMPARE(renamed("PartConfig.Hub.frame", "on"), with({{"frame", "on"}}));
        QCOMPARE(renamed("RobotConfig.Two.chassis", "body"), with({{"chassis", "body"}}));
        QCOMPARE(renamed("PartConfig.Wheel.carrier", "wheel"), QStringLiteral("refused: the name wheel is taken by Body wheel"));
        QCOMPARE(renamed("PartConfig.Wheel.carrier", "Pos"),
                 QStringLiteral("refused: the name Pos is taken by a property of Grid"));
        m_loaded = m_fixture.open(with({{"Param r ", "Param radius = 1 Param r "}}).toStdString());
        const auto near = planRename(*m_loaded, "PartConfig.Wheel.carrier", "radios");
        QCOMPARE(near.ok() ? std::string() : near.error().message, std::string("$radios would be taken for a misspelt $radius"));
    }

    /// The frame of what is in a Part: pose of the Part, then the mirror image.
    void frames() {
        const auto place = placeOf(*m_loaded, "a.right.wheel");
        const DescribedFrame frame = describedFrame(*m_loaded, *place);
        QCOMPARE(frame.signs, Vec3(1, -1, 1));
        const Pose inConfig = frame.pose * frame.mirrored(poseAt(*m_loaded, *place));
        const BodySpec& body = m_loaded->experiment->robots[0].config->bodies[2];
        QCOMPARE(body.name, std::string("right.wheel"));
        QVERIFY((inConfig.position - body.pose.position).norm() < 1e-12);
        QVERIFY(inConfig.rotation.angularDistance(body.pose.rotation) < 1e-9);
    }

    /// What a template inserts is valid: Parts that fit the config, joined to its first body.
    void templatesAreValid() {
        const Kind* part = m_loaded->registry->find("Part");
        const std::string text = templateOf(*m_loaded, *part, "RobotConfig.Kit");
        QCOMPARE(text, std::string("Part part { Config=Wheel carrier=chassis Pos=0,0,0 }"));
        const auto after = m_fixture.apply(m_loaded, planInsert(*m_loaded, "RobotConfig.Kit", text));
        QVERIFY(after);
        QCOMPARE(messages(*after), std::string());
        QVERIFY(templateOf(*m_loaded, *part, "PartConfig.Wheel").find("Config=MyPart") != std::string::npos);
    }

    /// What a config cannot get through a Part: geoms without a body in robots, itself.
    void insertsFitTheConfigs() {
        m_loaded =
            m_fixture.open(kWheel + kKit + kRobots + R"(PartConfig Post { Box post { Size=1,1,1 Material=red Surface=floor } }
PartConfig Pair { Part one { Config=Wheel carrier=$carrier } }
PartConfig Empty { Part none { Config=Pair carrier=$carrier } }
StaticConfig Gate { Part a { Config=Post } }
)");
        QVERIFY(m_loaded);
        const auto refusal = [&](const char* parent, const char* text) {
            const auto plan = planInsert(*m_loaded, parent, text);
            return plan.ok() ? std::string() : codeName(plan.error().code) + std::string(" ") + plan.error().message;
        };
        QVERIFY2(refusal("PartConfig.Wheel", "Part p { Config=Post }").starts_with("E302 Part p cannot be in PartConfig Wheel"),
                 refusal("PartConfig.Wheel", "Part p { Config=Post }").c_str());
        QVERIFY(refusal("RobotConfig.Kit", "Part p { Config=Post }").starts_with("E302 Part p cannot be in RobotConfig Kit"));
        QCOMPARE(refusal("StaticConfig.Gate", "Part p { Config=Wheel carrier=world }"), std::string()); // on a joint
        QCOMPARE(refusal("PartConfig.Post", "Part p { Config=Wheel carrier=world }"), std::string());
        QVERIFY(refusal("PartConfig.Empty", "Box b { }").starts_with("E302 "));
        QCOMPARE(refusal("PartConfig.Wheel", "Part p { Config=Empty }"),
                 std::string("E302 Part p uses PartConfig Wheel, which cannot contain itself"));
        QCOMPARE(refusal("StaticConfig.Gate", "Part p { Config=Post }"), std::string());
        QCOMPARE(refusal("RobotConfig.Kit", "Part p { Config=Pair carrier=chassis }"), std::string());
        const auto moved = planMove(*m_loaded, {"StaticConfig.Gate.a"}, "RobotConfig.Kit", {});
        QVERIFY(!moved.ok() && moved.error().code == Code::WrongPlace);
    }

    /// What a plan cannot foresee block by block is found in the text that it would leave.
    void refusesWhatBreaksNames() {
        const std::string kit = R"(RobotConfig Kit {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } Box bumper { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } }
  Part left { Config=Wheel carrier=chassis }
  Repeat rows { Count=2 Body body { Pos=$(index),1,0 Box box { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } } Fixed foot { Parent=chassis Child=body } }
  TouchSensor touch { Geom=chassis.bumper }
}
RobotConfig Other { Body red { Box hull { Size=0.1,0.1,0.1 Mass=1 Material=red Surface=floor } } TouchSensor chassis { Geom=red.hull } }
Robot a { Config=Kit }
)";
        m_loaded = m_fixture.open(kWheel + kit);
        QVERIFY(m_loaded);
        QCOMPARE(messages(*m_loaded), std::string());
        const auto refusal = [](const Result<EditPlan>& plan) {
            return plan.ok() ? std::string() : codeName(plan.error().code) + " " + plan.error().message;
        };
        const std::string moved =
            refusal(planMove(*m_loaded, {"RobotConfig.Kit.chassis.bumper"}, "RobotConfig.Kit.rows.body", {}));
        QVERIFY2(moved.starts_with("E208 the text would have an error after this, in line 13: Geom names body.bumper"),
                 moved.c_str());
        const std::string pasted =
            refusal(planInsert(*m_loaded, "RobotConfig.Other", "Part left { Config=Wheel carrier=chassis }"));
        QVERIFY2(
            pasted.starts_with("E208 the text would have an error after this, in line 15: Parent names chassis, a TouchSensor"),
            pasted.c_str());
        QCOMPARE(refusal(planInsert(*m_loaded, "RobotConfig.Other", "Part left { Config=Wheel carrier=red }")), std::string());
        QCOMPARE(refusal(planRename(*m_loaded, "a.left", "robot0")), std::string());
    }

private:
    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(PartsEditsTest)
#include "parts_edits_test.moc"
