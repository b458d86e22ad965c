// Values set by path, as with --set.
#include <QTest>

#include "lang/tree_edit.h"
#include "project/loading/set_path.h"
#include "sample_project.h"

using namespace trundle;
using sample::ProjectFixture;

namespace {

std::string scene(const std::string& more) { return std::string(sample::kGoodRobot) + more; }

/// The opened file's text after the assignments are written into it.
std::string edited(const LoadedProject& loaded, FileId file = 0) {
    const auto edits = editsForSets(loaded);
    const auto it = edits.find(file);
    const std::string_view bytes = loaded.trees[file]->source().bytes();
    if (it == edits.end()) return std::string(bytes);
    auto result = applyEdits(bytes, it->second);
    return result.ok() ? result.value() : "edits overlap: " + result.error().message;
}

} // namespace

class SetPathTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void valuesFromTheCommandLine() {
        ProjectFixture fixture;
        fixture.options.sets = {"Tick=0.02",
                                "robot0.leftMotor.Resistance=3",
                                "Surface.rubber.Friction=0.7",
                                "RobotConfig.Rover.chassis.hull.Mass=5 kg",
                                "robot0.brain.Speed=1",
                                "robot0.Pos=0,0,1",
                                "RobotConfig.Rover.wheelRadius=0.06",
                                "Material.grey.Shininess=1"};
        const auto loaded = fixture.open(scene(
            "#loadModule walker\nRobot robot0 { Config=Rover Walker brain { Speed=0.2 } }\nRobot robot1 { Config=Rover }\n"));
        QCOMPARE(sample::rendered(*loaded), "");
        const ExperimentSpec& e = *loaded->experiment;
        QCOMPARE(e.settings.tick, 0.02);
        QCOMPARE(e.surfaces[1].friction, 0.7);
        QCOMPARE(e.materials[1].shininess, 1.0);
        QCOMPARE(e.robots[0].config->devices[0].number("Resistance"), 3.0);
        QCOMPARE(e.robots[1].config->devices[0].number("Resistance"), 2.0);
        QCOMPARE(e.robots[1].config->bodies[0].mass.mass, 5.0);
        QCOMPARE(e.robots[1].config->bodies[1].geoms[0].radius, 0.06);
        QCOMPARE(e.robots[0].controllers.at(0).number("Speed"), 1.0);
        QCOMPARE(e.robots[0].pose.position.z(), 1.0);
    }

    void lastSettingWins() {
        ProjectFixture fixture;
        fixture.options.sets = {"Tick=0.02", "Tick=0.03"};
        const auto loaded = fixture.open("Tick = 0.01 // fine\n");
        QCOMPARE(loaded->experiment->settings.tick, 0.03);
        QCOMPARE(edited(*loaded), "Tick = 0.03 // fine\n");
    }

    void onlyTheValueChanges() {
        ProjectFixture fixture;
        fixture.options.sets = {"robot0.Pos=1,1,1"};
        const auto loaded = fixture.open(scene("Robot robot0 { // mine\n\tConfig=Rover\n\tPos = 0, 0 ,0 // here\n}"));
        QCOMPARE(edited(*loaded), scene("Robot robot0 { // mine\n\tConfig=Rover\n\tPos = 1,1,1 // here\n}"));
    }

    void aJointsPlaceComesBeforeItsStops() {
        const auto config = [](const std::string& place, const std::string& behind) {
            return "RobotConfig Kit {\n  Body a { Sphere s { Radius=0.1 Mass=1 } }\n  Body b { Pos=1,0,0 Sphere s { Radius=0.1 "
                   "Mass=1 } }\n"
                   "  Hinge axle { Parent=a Child=b " +
                   place + "LowStop=-20 HighStop=70 }\n  Hinge other {\n    Parent = a\n" + behind +
                   "    LowStop = -20\n  }\n}\n";
        };
        ProjectFixture fixture;
        fixture.options.sets = {"RobotConfig.Kit.axle.Anchor=0,0,1", "RobotConfig.Kit.axle.Axis=0,1,0",
                                "RobotConfig.Kit.other.Anchor=0,0,2"};
        const auto loaded = fixture.open(config("", "    Child = b\n"));
        QCOMPARE(edited(*loaded), config("Anchor=0,0,1 Axis=0,1,0 ", "    Child = b\n    Anchor = 0,0,2\n"));
    }

    void anOverrideIsAddedToTheRobot() {
        ProjectFixture fixture;
        fixture.options.sets = {"robot0.leftMotor.Resistance=3", "robot0.rightMotor.Resistance=4"};
        const auto loaded = fixture.open(scene("Robot robot0 { Config=Rover }\n"));
        QVERIFY(!setsFailed(*loaded));
        QCOMPARE(edited(*loaded), scene("Robot robot0 { Config=Rover leftMotor.Resistance=3 rightMotor.Resistance=4 }\n"));
    }

    /// The file that contains the config is changed, not the opened one.
    void theOwningFile() {
        ProjectFixture fixture;
        fixture.write("rover.sim", sample::kGoodRobot);
        fixture.options.sets = {"RobotConfig.Rover.leftMotor.Resistance=3"};
        const auto loaded = fixture.open("#import rover.sim\nRobot robot0 { Config=Rover }\n");
        const auto edits = editsForSets(*loaded);
        QCOMPARE(edits.size(), 1u);
        QCOMPARE(edits.begin()->first, FileId{1});
        std::string expected = sample::kGoodRobot;
        expected.replace(expected.find("Resistance=2"), 12, "Resistance=3");
        QCOMPARE(edited(*loaded, 1), expected);
    }

    void aSettingOfAnImportedFileIsChangedThere() {
        ProjectFixture fixture;
        fixture.write("a.sim", "Tick = 0.001\n");
        fixture.options.sets = {"Tick=0.02"};
        const auto loaded = fixture.open("#import a.sim\n");
        QCOMPARE(edited(*loaded, 1), "Tick = 0.02\n");
    }

    void faultsPointIntoTheCommandLine_data() {
        QTest::addColumn<QString>("set");
        QTest::addColumn<QString>("said");
        QTest::newRow("range") << "robot0.leftMotor.Resistance=-3"
                               << "--set#1:1:29: error E203: Resistance is -3, it must be above 0\n";
        QTest::newRow("key") << "Tik=0.02"
                             << "--set#1:1:1: error E201: there is no setting Tik\n";
        QTest::newRow("part") << "robot0.leftMoter.Resistance=3"
                              << "--set#1:1:8: error E314: RobotConfig Rover has no leftMoter; it has chassis, leftWheel, "
                                 "rightWheel, leftAxle, rightAxle, leftMotor, "
                                 "rightMotor, base and touch\n";
        QTest::newRow("robot") << "robot9.leftMotor.Resistance=3"
                               << "--set#1:1:1: error E314: nothing in the world is named robot9; there are robot0 and swarm\n";
        QTest::newRow("surface") << "Surface.ruber.Friction=3"
                                 << "--set#1:1:9: error E314: there is no Surface ruber; there is rubber\n";
        QTest::newRow("member") << "swarm_1.leftMotor.Resistance=3"
                                << "--set#1:1:1: error E323: swarm_1 is a member of Grid swarm and has no text of its own\n";
        QTest::newRow("robot without a property")
            << "robot0=3"
            << "--set#1:1:1: error E314: Robot robot0 takes no value itself; set one of its "
               "properties, robot0. ...\n";
        QTest::newRow("no value") << "Tick"
                                  << "";
        QTest::newRow("nothing") << ""
                                 << "--set#1:1:1: error E101: --set takes PATH=VALUE, as in robot0.leftMotor.Resistance=3\n";
        QTest::newRow("two") << "Tick=1\nDuration=2"
                             << "--set#1:1:1: error E101: --set takes PATH=VALUE, as in robot0.leftMotor.Resistance=3\n";
    }
    void faultsPointIntoTheCommandLine() {
        QFETCH(QString, set);
        QFETCH(QString, said);
        ProjectFixture fixture;
        fixture.options.sets = {set.toStdString()};
        const auto loaded =
            fixture.open(scene("Robot robot0 { Config=Rover }\nGrid swarm { Config=Rover Count=2 Spacing=2 Pos=0,0,1 }\n"));
        QVERIFY(setsFailed(*loaded));
        const std::string all = sample::rendered(*loaded);
        QVERIFY2(all.starts_with(said.toStdString()), all.c_str());
        QVERIFY(all.starts_with("--set#1:1:"));
    }

    /// What the parser could not read leads nowhere, so that there is nothing more to say.
    void aFaultOfSyntaxIsTheOnlyOne() {
        for (const char* set : {"Param.a=4", "swarm*.Pos=1,1,1", "\"robot0\".Pos=1,1,1", "robot0.chassis..hull.Mass=3"}) {
            ProjectFixture fixture;
            fixture.options.sets = {set};
            const auto loaded =
                fixture.open(scene("Robot robot0 { Config=Rover }\nGrid swarm { Config=Rover Count=2 Spacing=2 }\n"));
            QCOMPARE(loaded->diagnostics.errorCount(), std::size_t{1});
            QVERIFY(sample::rendered(*loaded).starts_with("--set#1:1:"));
        }
    }

    /// The fix for a path to a grid member replaces the grid by single instances; the world stays the same.
    void aGridBecomesSingles() {
        ProjectFixture fixture;
        fixture.options.sets = {"swarm_1.leftMotor.Resistance=3"};
        const std::string text = scene("#loadModule walker\nGrid swarm { Config=Rover Count=3,2 Spacing=2 Pos=1,0,1 HPR=30,0,0 "
                                       "wheelRadius=0.06 Walker brain { Speed=1 } }\n");
        const auto loaded = fixture.open(text);
        QCOMPARE(loaded->diagnostics.all().size(), 1u);
        const auto result = applyEdits(text, loaded->diagnostics.all()[0].fixes.at(0).edits);
        QVERIFY(result.ok());
        const auto again = fixture.open(result.value());
        QCOMPARE(sample::rendered(*again), "");
        QCOMPARE(again->experiment->robots.size(), 6u);
        for (std::size_t i = 0; i < 6; ++i) {
            const RobotSpec &a = loaded->experiment->robots[i], &b = again->experiment->robots[i];
            QCOMPARE(a.name, b.name);
            QVERIFY((a.pose.position - b.pose.position).norm() < 1e-5);
            QVERIFY(a.pose.rotation.angularDistance(b.pose.rotation) < 1e-6);
            QCOMPARE(b.controllers.at(0).number("Speed"), 1.0);
        }
        QCOMPARE(again->experiment->robots[1].config->devices[0].number("Resistance"), 3.0);
        QCOMPARE(again->experiment->robots[2].config->devices[0].number("Resistance"), 2.0);
    }
};

QTEST_APPLESS_MAIN(SetPathTest)
#include "set_path_test.moc"
