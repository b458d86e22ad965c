// Where a value comes from, by its path; the resolved values name the same origin and range.
#include <QTest>

#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;

namespace {

/// Robots whose names are prefixes of each other, with values from every origin.
const std::string kText = sample::rover(R"(
Param strong = 7  Param which = Rover
RobotConfig Strong { Body b { Sphere s { Radius=0.1 Mass=9 Material=grey Surface=rubber } } }
Robot robot1 { Config=Rover leftMotor.Resistance=3 Walker brain { Speed=1 } }
Robot robot10 { Config=Rover wheelRadius=6cm leftMotor.Resistance=$strong rightMotor.Resistance=$(strong + 1) Walker brain { Mood=wild } }
Robot robot { Config=$which chassis.hull.Mass=4 }
Robot own { Param which = Strong Config=$which }
Grid swarm { Config=Rover Count=2 Spacing=3 Pos=0,9,0 leftMotor.Resistance=5 Walker brain { } }
Grid swarm_1x { Config=Strong Count=11 Spacing=1 }
StaticConfig Slab { Box block { Size=1,1,1 Material=grey Surface=rubber } }
Static slab { Config=Slab block.Size=1,2,3 }
PoseLog poses { Robot=robot1 }
Tick = 0.02
)");

const std::vector<std::string> kSets = {
    "robot1.rightMotor.Resistance=4", "Seed=$(strong * 2)", "robot10.brain.Speed=$strong",
    "Surface.rubber.Friction=0.25",   "strong=1.5",         "RobotConfig.Rover.wheelRadius=7cm"};

const char* const kOrigins[] = {"default", "config", "instance", "param", "command line"};

} // namespace

class ProvenanceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void paths_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("found");
        const auto row = [](const char* path, const char* found) { QTest::newRow(path) << path << found; };
        row("robot1.chassis.hull.Mass", "config 2 in hull");
        row("robot1.leftMotor.Resistance", "instance 3 in robot1");
        row("robot1.rightMotor.Resistance", "command line 4 in robot1");
        row("robot1.leftMotor.GearRatio", "default  in leftMotor");
        row("robot1.leftWheel.tyre.Radius", "param $wheelRadius in tyre");
        row("robot1.brain.Speed", "instance 1 in brain");
        row("robot1.brain.Mood", "default  in brain");
        row("robot1.brain.UpdatePeriod", "default  in brain");
        row("robot1.Config", "instance Rover in robot1");
        row("robot1.HPR", "default  in robot1");
        row("robot10.leftMotor.Resistance", "param $strong in robot10");
        row("robot10.rightMotor.Resistance", "param $(strong + 1) in robot10");
        row("robot10.brain.Speed", "command line $strong in brain");
        row("robot10.brain.Mood", "instance wild in brain");
        row("robot.leftMotor.Resistance", "config 2 in leftMotor");
        row("robot.chassis.hull.Mass", "instance 4 in robot");
        row("robot.Config", "param $which in robot");
        row("own.b.s.Mass", "config 9 in s");
        row("swarm.leftMotor.Resistance", "instance 5 in swarm");
        row("swarm_1.leftMotor.Resistance", "instance 5 in swarm");
        row("swarm_1.chassis.hull.Mass", "config 2 in hull");
        row("swarm_1.brain.Speed", "default  in brain");
        row("swarm_1.Count", "instance 2 in swarm");
        row("swarm_1x_1.b.s.Mass", "config 9 in s");
        row("slab.block.Size", "instance 1,2,3 in slab");
        row("slab.block.Pos", "default  in block");
        row("poses.Robot", "config robot1 in poses");
        row("poses.Interval", "default  in poses");
        row("Surface.rubber.Friction", "command line 0.25 in rubber");
        row("Material.grey.ColorRGB", "config 0.5,0.5,0.5 in grey");
        row("RobotConfig.Rover.leftAxle.Axis", "config 0,2,0 in leftAxle");
        row("RobotConfig.Rover.leftWheel.tyre.Radius", "param $wheelRadius in tyre");
        row("RobotConfig.Rover.SelfCollision", "default  in Rover");
        row("Tick", "config 0.02 in ");
        row("Seed", "command line $(strong * 2) in ");
        row("Gravity", "default  in ");
        for (const char* nothing :
             {"", ".", "robot1", "robot1.", "robot1.chassis", "robot1.chassis.hull.Weight", "robot2.Config",
              "robot1.chassis.Mass.Mass", "swarm_.Count", "swarm_x.Count", "RobotConfig.Rover", "RobotConfig.Slab.block.Size",
              "StaticConfig.Rover.SelfCollision", "Material.rubber.Friction", "tick", "strong", "robot1.wheelRadius",
              "robot10.wheelRadius", "swarm_1x_1.leftMotor.Resistance"})
            row(nothing, "nothing");
    }
    void paths() {
        QFETCH(QString, path);
        QFETCH(QString, found);
        static const Resolved r = sample::resolved(kText, kSets);
        SAYS(r, "");
        const std::optional<Provenance> p = provenanceOf(*r.outline, path.toStdString());
        std::string text = "nothing";
        if (p) text = std::string(kOrigins[static_cast<int>(p->origin)]) + " " + r.slice(p->value) + " in " + r.slice(p->block);
        QCOMPARE(QString::fromStdString(text), found);
        if (p) QVERIFY(p->property && path.endsWith(QString::fromStdString(p->property->name)));
    }

    /// Each value of each device, controller and log: the record and the path agree about origin and range.
    void agreesWithTheResolvedValues() {
        const Resolved r = sample::resolved(kText, kSets);
        std::size_t compared = 0;
        const auto compare = [&](const std::string& path, const ComponentSpec& component) {
            for (const auto& [key, value] : component.values) {
                const std::optional<Provenance> p = provenanceOf(*r.outline, path + "." + key);
                QVERIFY2(p, (path + "." + key).c_str());
                QVERIFY2(p->origin == value.origin && p->value == value.range, (path + "." + key).c_str());
                ++compared;
            }
        };
        for (const RobotSpec& robot : r.experiment->robots) {
            for (const ComponentSpec& device : robot.config->devices) compare(robot.name + "." + device.name, device);
            for (const ControllerSpec& controller : robot.controllers) compare(robot.name + "." + controller.name, controller);
        }
        for (const ComponentSpec& log : r.experiment->logs) compare(log.name, log);
        QVERIFY(compared > 60);
    }

    /// The targets of the command line, and what they replace.
    void setsReplaceValues() {
        const Resolved r = sample::resolved(kText, kSets);
        std::string all;
        for (const SetTarget& t : r.sets.targets)
            all += (t.part ? t.part->name : "-") + " " + t.key + ": " + r.slice(t.before) + " > " + r.slice(t.value) + "\n";
        QCOMPARE(QString::fromStdString(all),
                 "robot1 rightMotor.Resistance:  > 4\n- Seed:  > $(strong * 2)\nbrain Speed:  > $strong\n"
                 "rubber Friction: 1 > 0.25\n- strong: 7 > 1.5\nRover wheelRadius: 0.05 > 7cm\n");
        QCOMPARE(r.experiment->settings.seed, 3u);
        QCOMPARE(r.experiment->surfaces.at(1).friction, 0.25);
        QCOMPARE(r.config(0).bodies.at(1).geoms[0].radius, 0.07);
        QCOMPARE(r.config(1).bodies.at(1).geoms[0].radius, 0.06);
        QCOMPARE(r.config(0).devices.at(1).number("Resistance"), 4.0);
        QCOMPARE(r.config(1).devices.at(0).number("Resistance"), 1.5);
        QCOMPARE(r.config(1).devices.at(1).number("Resistance"), 2.5);
        QCOMPARE(r.experiment->robots.at(1).controllers.at(0).number("Speed"), 1.5);
    }

    void invalidSets_data() {
        QTest::addColumn<QString>("set");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* set, const char* said) { QTest::newRow(set) << set << said; };
        row("robot2.Config=Rover", "E314 nothing in the world is named robot2");
        row("robot1.leftMotr.Resistance=1", "E314 Robot robot1 has no leftMotr");
        row("robot1.leftMotor.Resistence=1", "E314 RotaryMotor leftMotor has no Resistence");
        row("Surface.ruber.Friction=1", "E314 there is no Surface ruber");
        row("Surface.rubber=1", "E314 a path into a Surface is Surface.name.property");
        row("RobotConfig.Rover.chassis.hul.Mass=1", "E314 Body chassis has no hul");
        row("slab.block.Sise=1,1,1", "E314 Box block has no Sise");
        row("Tik=1", "E201 there is no setting Tik");
        row("Tick=1 A", "E206 Tick is a time (s), A is a current");
    }
    void invalidSets() {
        QFETCH(QString, set);
        QFETCH(QString, said);
        const Resolved r = sample::resolved(kText, {set.toStdString()});
        QVERIFY2(r.messages().starts_with(said.toStdString()), r.messages().c_str());
        QCOMPARE(r.diagnostics.errorCount(), std::size_t{1});
        QVERIFY(r.texts->commandLine(r.diagnostics.all()[0].range.file));
    }

    /// A path into one member of a layout is reported as such: members have no text of their own.
    void membersOfLayouts() {
        const Resolved r = sample::resolved(kText, {"swarm_1.leftMotor.Resistance=1", "swarm_1x_3.b.s.Mass=1"});
        QCOMPARE(r.sets.members.size(), std::size_t{2});
        QCOMPARE(r.sets.members[0].layout->name, std::string("swarm"));
        QCOMPARE(r.sets.members[1].layout->name, std::string("swarm_1x"));
        QCOMPARE(r.slice(r.sets.members[1].range), std::string("swarm_1x_3"));
    }
};

QTEST_APPLESS_MAIN(ProvenanceTest)
#include "provenance_test.moc"
