// Where an edit goes: into an instance, its config, or a copy of the config.
#include <QTest>

#include <fstream>

#include "plan_fixture.h"
#include "project/edits/edit_target.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kRover = R"(// rovers
#import common.sim
RobotConfig Rover {
  Param width = 0.3
  // The only body.
  Body chassis { Box hull { Size=$width,0.2,0.1 Mass=2 Material=red Surface=floor } }
}
)";
const char* const kCommon = "Material red { ColorRGB=1,0,0 }\nSurface floor { Friction=1 }\n";

/// The config and one or more robots in one text.
std::string alone(const std::string& robots) {
    return std::string(kCommon) +
           "RobotConfig Rover {\n  Param width = 0.3\n"
           "  Body chassis { Box hull { Size=$width,0.2,0.1 Mass=2 Material=red Surface=floor } }\n}\n" +
           robots;
}

/// The same with a Repeat.
std::string conveyor(const std::string& robots) {
    return std::string(kCommon) +
           "RobotConfig Conveyor {\n  Body frame { Box bed { Size=1,1,0.1 Mass=2 Material=red Surface=floor } }\n"
           "  Repeat roller { Count=5 Pos=$(0.2*index),0,0.2\n"
           "    Body drum { Sphere s { Radius=0.05 Mass=1 Material=red Surface=floor } }\n"
           "    Hinge axle { Parent=frame Child=drum Damping=0.001 }\n  }\n}\n" +
           robots;
}

const Part& config(const LoadedProject& loaded, const char* name = "Rover") { return *loaded.outline->configs.find(name); }

} // namespace

class EditTargetTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void values_data() {
        QTest::addColumn<QString>("main");
        QTest::addColumn<QString>("asked");
        QTest::addColumn<QString>("set");
        QTest::addColumn<bool>("isOverride");
        const auto row = [](const char* name, const std::string& main, const char* asked, const char* set, bool isOverride) {
            QTest::newRow(name) << QString::fromStdString(main) << asked << set << isOverride;
        };
        const std::string one = alone("Robot r { Config=Rover }\n"),
                          two = alone("Robot r { Config=Rover }\nRobot s { Config=Rover }\n"),
                          imported = "#import rover.sim\nRobot r { Config=Rover }\n";
        row("config in the same file", one, "r.chassis.hull.Mass", "RobotConfig.Rover.chassis.hull.Mass", false);
        row("its Param", one, "r.width", "RobotConfig.Rover.width", false);
        row("its own property", one, "r.SelfCollision", "RobotConfig.Rover.SelfCollision", false);
        row("what is the instance's", one, "r.Pos", "r.Pos", false);
        row("two instances", two, "s.chassis.hull.Mass", "s.chassis.hull.Mass", true);
        row("the config itself", two, "RobotConfig.Rover.chassis.hull.Mass", "RobotConfig.Rover.chassis.hull.Mass", false);
        row("a Grid is one instance", alone("Grid g { Config=Rover Count=3 Spacing=1 }\n"), "g.chassis.hull.Mass",
            "RobotConfig.Rover.chassis.hull.Mass", false);
        row("config in another file", imported, "r.chassis.hull.Mass", "r.chassis.hull.Mass", true);
        row("a Param there", imported, "r.width", "r.width", true);
        row("overridden already", alone("Robot r { Config=Rover chassis.hull.Mass=3 }\n"), "r.chassis.hull.Mass",
            "r.chassis.hull.Mass", true);
        const std::string set = "roller.axle.Damping=0.1 }\n", path = "belt.roller_3.axle.Damping";
        const std::string belt = conveyor("Robot belt { Config=Conveyor " + set),
                          variant = conveyor("RobotConfig Stiff { Config=Conveyor " + set + "Robot belt { Config=Stiff }\n");
        row("overridden for all members", belt, path.c_str(), path.c_str(), true);
        row("another value of that member", belt, "belt.roller_3.axle.Friction", "RobotConfig.Conveyor.roller_3.axle.Friction",
            false);
        row("by the only variant for all", variant, path.c_str(), "RobotConfig.Stiff.roller_3.axle.Damping", true);
        row("a setting", one, "Tick", "Tick", false);
        row("nothing", one, "nobody.Mass", "nobody.Mass", false);
    }
    void values() {
        QFETCH(QString, main);
        QFETCH(QString, asked);
        QFETCH(QString, set);
        QFETCH(bool, isOverride);
        PlanFixture fixture;
        const auto loaded = fixture.open({{"main.sim", main.toStdString()}, {"rover.sim", kRover}, {"common.sim", kCommon}});
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::rendered(*loaded).c_str());
        ConfigUsers users;
        const EditTarget target = targetOfValue(*loaded, asked.toStdString(), users);
        QCOMPARE(QString::fromStdString(target.path), set);
        QCOMPARE(target.isOverride, isOverride);
    }

    /// One member has no value to be reset where the value is set for all of them.
    void resetOfOneMember() {
        PlanFixture fixture;
        const auto loaded =
            fixture.open(conveyor("Robot belt { Config=Conveyor roller.axle.Damping=0.1 roller_2.axle.Damping=0.2 }\n"));
        const auto reset = [&](const char* roller) {
            return fixture.text(loaded, planReset(*loaded, {std::string("belt.") + roller + ".axle.Damping"}));
        };
        const std::string there = "is set for all members, by roller.axle.Damping in Robot belt; ",
                          own = " it there, or give this member a value of its own";
        QCOMPARE(reset("roller_3"), "refused: Damping of Hinge axle " + there + "reset" + own);
        QCOMPARE(fixture.text(loaded, planPushOverride(*loaded, "belt.roller_3.axle.Damping")),
                 "refused: Damping of Hinge axle " + there + "push" + own);
        QVERIFY(reset("roller_2").ends_with("Robot belt { Config=Conveyor roller.axle.Damping=0.1 }\n"));
        QVERIFY(reset("roller").ends_with("Robot belt { Config=Conveyor roller_2.axle.Damping=0.2 }\n"));
    }

    /// An instance in a file that is not open counts as well.
    void anotherFileOfTheProject() {
        PlanFixture fixture;
        const auto loaded = fixture.open({{"configs/main.sim", alone("Robot r { Config=Rover }\n")}}, "configs/main.sim");
        ConfigUsers users;
        QVERIFY(!targetOfValue(*loaded, "r.width", users).isOverride);
        const std::string other = fixture.path("configs/deep/other.sim");
        std::filesystem::create_directories(fixture.path("configs/deep"));
        std::ofstream(other) << "#import main.sim\nRobot second { Config=Rover Pos=2,0,0 }\n";
        std::ofstream(fixture.path("configs/main.sim")) << alone("Robot r { Config=Rover }\n"); // imported by other.sim
        QVERIFY(targetOfValue(*loaded, "r.width", users).isOverride);
        const std::vector<std::string> both{other, fixture.path("configs/main.sim")};
        QCOMPARE(users.of(*loaded, config(*loaded)), both);
        const EditTarget structure = targetOfStructure(*loaded, config(*loaded), nullptr, users);
        QCOMPARE(structure.users, both);
        std::ofstream(other) << "#import main.sim\nRobotConfig Other { Body b { Sphere s { Radius=1 Mass=1 } } }\n"
                                "Robot second { Config=Other }\n";
        QCOMPARE(targetOfStructure(*loaded, config(*loaded), nullptr, users).users,
                 std::vector{fixture.path("configs/main.sim")});
    }

    /// Fixes of a shipped file are not offered, since they would be refused; those of the opened file are.
    void fixesOfShippedFilesAreLeftOut() {
        PlanFixture fixture;
        const std::string parts = "Material blue { ColourRGB=0,0,1 }\n";
        const std::map<std::string, std::string> files{{"main.sim", "#import parts/blue.sim\nTikc = 0.01\n"},
                                                       {"parts/blue.sim", parts}};
        const auto offered = [](const LoadedProject& loaded) {
            QStringList fixes;
            for (const Diagnostic& d : loaded.diagnostics.all())
                for (const Fix* fix : applicableFixes(loaded, d))
                    fixes << QString::fromStdString(fix->title) + u'@' + QString::number(fix->edits.front().range.file);
            fixes.sort();
            return fixes;
        };
        QCOMPARE(offered(*fixture.open(files)), (QStringList{QStringLiteral("ColorRGB@1"), QStringLiteral("Tick@0")}));
        fixture.options.shippedConfigs = fixture.path("parts");
        QCOMPARE(offered(*fixture.open(files)), QStringList{QStringLiteral("Tick@0")});
    }

    void shippedIsReadOnly() {
        PlanFixture fixture;
        fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
        const auto loaded = fixture.open("#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot }\n");
        ConfigUsers users;
        QVERIFY(targetOfStructure(*loaded, config(*loaded, "SimpleRobot"), nullptr, users).isShipped);
        QVERIFY(targetOfValue(*loaded, "RobotConfig.SimpleRobot.wheelRadius", users).isShipped);
        const EditTarget through = targetOfValue(*loaded, "r.wheelRadius", users);
        QVERIFY(through.isOverride);
        QVERIFY(!through.isShipped);
        QCOMPARE(through.file, FileId{0});
    }

    void configsThatAPlanChanges() {
        PlanFixture fixture;
        const auto loaded = fixture.open(
            {{"main.sim", "#import rover.sim\nRobot r { Config=Rover }\n"}, {"rover.sim", kRover}, {"common.sim", kCommon}});
        const auto changed = [&](const Result<EditPlan>& plan) {
            return plan.ok() ? configsChangedBy(*loaded, plan.value()) : std::vector<const Part*>{nullptr};
        };
        const std::vector<const Part*> rover{&config(*loaded)}, none;
        QCOMPARE(changed(planInsert(*loaded, "r", "Body arm { Sphere ball { Radius=0.1 Mass=1 } }")), rover);
        QCOMPARE(changed(planInsert(*loaded, "r.chassis", "Sphere ball { Radius=0.1 }")), rover);
        QCOMPARE(changed(planRemove(*loaded, {"r.chassis.hull"})), rover);
        QCOMPARE(changed(planRename(*loaded, "r.chassis", "base")), rover);
        QCOMPARE(changed(planDuplicate(*loaded, {"r"}, Vec3::Zero())), none);
        QCOMPARE(changed(planInsert(*loaded, "", "Light sun { Mode=sun }")).empty(), true);
        QCOMPARE(changed(planRemove(*loaded, {"r"})), none);
    }

    /// A rename changes what names the object too, which is nothing to decide about.
    void aRenameIsOfOneConfig() {
        PlanFixture fixture;
        const auto loaded = fixture.open(
            "Material red { }\nSurface floor { }\nPartConfig Wheel {\n  Param r = 1\n"
            "  Body wheel { Sphere s { Radius=$r Mass=1 Material=red Surface=floor } }\n  Hinge axle { Parent=$base Child=wheel "
            "}\n"
            "}\nRobotConfig Kit {\n  Body chassis { Sphere s { Radius=1 Mass=1 Material=red Surface=floor } }\n"
            "  Part left { Config=Wheel base=chassis r=2 }\n  Encoder count { Joint=left.axle CountsPerRevolution=512 }\n}\n"
            "RobotConfig More { Config=Kit left.axle.Axis=0,1,0 }\nRobot a { Config=Kit }\nRobot b { Config=More }\n");
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const auto changed = [&](const std::string& path) {
            const auto plan = planRename(*loaded, path, "other");
            return plan.ok() ? configsChangedBy(*loaded, plan.value()) : std::vector<const Part*>{nullptr};
        };
        const std::vector<const Part*> wheel{&config(*loaded, "Wheel")}, kit{&config(*loaded, "Kit")};
        QCOMPARE(changed("a.left.axle"), wheel);
        QCOMPARE(changed("PartConfig.Wheel.r"), wheel);
        QCOMPARE(changed("a.left"), kit);
        QCOMPARE(changed("b.left"), kit);
    }

    void copies() {
        PlanFixture fixture;
        const std::string main = "#import rover.sim\n\nTick = 0.02\n\n// The first.\nRobot r { Config=Rover width=0.4 } // here\n"
                                 "Robot s { Pos=1,0,0 Config = Rover }\n";
        const auto loaded = fixture.open({{"main.sim", main}, {"rover.sim", kRover}, {"common.sim", kCommon}});
        const auto plan = planCopyConfig(*loaded, config(*loaded), instancesOf(*loaded, config(*loaded)));
        QCOMPARE(QString::fromStdString(fixture.text(loaded, plan)), QString::fromUtf8(R"(#import rover.sim

Tick = 0.02

// A copy of Rover in rover.sim, for this file alone.
RobotConfig Rover2 {
  Param width = 0.3
  // The only body.
  Body chassis { Box hull { Size=$width,0.2,0.1 Mass=2 Material=red Surface=floor } }
}

// The first.
Robot r { Config=Rover2 width=0.4 } // here
Robot s { Pos=1,0,0 Config = Rover2 }
)"));
        QCOMPARE(plan.value().edits.size(), 1u);
        QCOMPARE(plan.value().selects, std::vector<std::string>{"RobotConfig.Rover2"});
        const auto after = fixture.apply(loaded, plan);
        QVERIFY2(!after->diagnostics.hasErrors(), sample::rendered(*after).c_str());
        QCOMPARE(after->experiment->robots[0].config->name, "Rover2");
    }

    /// Of robots in a Repeat or Ring of the world: the copy is above that, at the top level.
    void copiesAreAboveRepeats() {
        PlanFixture fixture;
        const std::string row = "#import rover.sim\n// The row.\nRepeat row { Count=2 Pos=0,$(9*index),0\n"
                                "  Ring circle { Count=2 Radius=3 Axis=0,0,1 Robot r { Config=Rover } }\n}\n";
        const auto loaded = fixture.open({{"main.sim", row}, {"rover.sim", kRover}, {"common.sim", kCommon}});
        const auto plan = planCopyConfig(*loaded, config(*loaded), instancesOf(*loaded, config(*loaded)));
        const std::string text = fixture.text(loaded, plan);
        QVERIFY2(text.find("\n}\n\n// The row.\nRepeat row {") != std::string::npos, text.c_str());
        const auto after = fixture.apply(loaded, plan);
        QVERIFY2(after && !after->diagnostics.hasErrors(), text.c_str());
        QCOMPARE(after->experiment->robots.size(), std::size_t(4));
        for (const RobotSpec& robot : after->experiment->robots) QCOMPARE(robot.config->name, "Rover2");
    }

    /// A robot in its own folder with a mesh beside it, and an experiment with Windows line ends.
    void copiesFindTheirFiles() {
        PlanFixture fixture;
        std::filesystem::create_directories(fixture.path("configs/robots/parts"));
        std::filesystem::copy_file(TRUNDLE_SOURCE_DIR "/resources/meshes/" + std::string(firstMesh()),
                                   fixture.path("configs/robots/parts/hull.obj"));
        const std::string robot = "RobotConfig Shell { Body b { Mesh m { File=parts/hull.obj Mass=1 } } }\n";
        const auto loaded =
            fixture.open({{"configs/experiments/main.sim", "#import robots/shell.sim\r\nRobot r { Config=Shell }\r\n"},
                          {"configs/robots/shell.sim", robot}},
                         "configs/experiments/main.sim");
        const auto plan = planCopyConfig(*loaded, config(*loaded, "Shell"), instancesOf(*loaded, config(*loaded, "Shell")));
        const std::string text = fixture.text(loaded, plan, "configs/experiments/main.sim");
        QVERIFY2(text.find("Mesh m { File=\"robots/parts/hull.obj\" Mass=1 }") != std::string::npos, text.c_str());
        QCOMPARE(QString::fromStdString(text).count('\n'), QString::fromStdString(text).count("\r\n"));
        const auto after = fixture.apply(loaded, plan);
        for (const auto& [use, file] : after->named) QCOMPARE(file.path, fixture.path("configs/robots/parts/hull.obj"));
        QCOMPARE(after->named.size(), 2u);
    }

    /// A config that imports a file inside its block: the copy contains the imported block that is edited.
    void copiesWriteOutWhatTheyImport() {
        PlanFixture fixture;
        const std::string robot =
            "#import paint.sim\nRobotConfig Cart {\n  #import parts/body.sim\n  #import parts/other.sim\n}\n";
        const std::string body = "// The body.\nBody b {\n  Box x { Size=1,1,1 Mass=1 Material=white }\n}\n";
        const auto loaded =
            fixture.open({{"configs/main.sim", "#import robots/cart.sim\nRobot r { Config=Cart }\n"},
                          {"configs/robots/cart.sim", robot},
                          {"configs/robots/paint.sim", "Material white { ColorRGB=1,1,1 }\n"},
                          {"configs/robots/parts/body.sim", body},
                          {"configs/robots/parts/other.sim", "Body o { Box x { Size=1,1,1 Pos=2,0,0 Mass=1 } }\n"}},
                         "configs/main.sim");
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::rendered(*loaded).c_str());
        const std::string inner = fixture.path("configs/robots/parts/body.sim");
        const auto plan =
            planCopyConfig(*loaded, config(*loaded, "Cart"), instancesOf(*loaded, config(*loaded, "Cart")), {inner});
        const std::string text = fixture.text(loaded, plan, "configs/main.sim");
        QVERIFY2(
            text.find(
                "RobotConfig Cart2 {\n  // From robots/parts/body.sim\n  // The body.\n  Body b {\n    Box x { Size=1,1,1 Mass=1 "
                "Material=white }\n  }\n") != std::string::npos,
            text.c_str());
        QVERIFY2(text.find("other.sim") != std::string::npos, text.c_str()); // imports of unchanged parts stay
        const auto after = fixture.apply(loaded, plan);
        QVERIFY2(!after->diagnostics.hasErrors(), sample::rendered(*after).c_str());
        QCOMPARE(after->experiment->robots[0].config->bodies.size(), std::size_t(2));
        const Part* copied = config(*after, "Cart2").find("b");
        QVERIFY(copied && after->paths[copied->file] == fixture.path("configs/main.sim"));
    }

    /// A shipped file with an error is not imported any longer once its config has a copy, unless more of it is used.
    void copiesOfFaultyConfigsReplaceTheImport_data() {
        QTest::addColumn<QString>("main");
        QTest::addColumn<QString>("expected");
        const QString copy = "// A copy of Rover in shipped/rover.sim, for this file alone.\n"
                             "RobotConfig Rover2 { Body b { Box x { Size=1,1,1 Mass=$load Material=red } } }\n\n";
        const QString robots = "Robot r { Config=Rover }\nGrid g { Config=Rover Count=2 Spacing=3 }\n",
                      copied = QString(robots).replace("Rover", "Rover2");
        QTest::newRow("nothing else is used")
            << "#import shipped/rover.sim // mine\n\nTick=0.02\n" + robots
            << "// mine\n#import shipped/load.sim\n#import shipped/common.sim\n\nTick=0.02\n" + copy + copied;
        QTest::newRow("a material through it")
            << "#import shipped/rover.sim\n#import shipped/load.sim\n" + robots + "Static s { Config=Hut }\n"
            << "#import shipped/load.sim\n#import shipped/common.sim\n#import shipped/hut.sim\n" + copy + copied +
                   "Static s { Config=Hut }\n";
        QTest::newRow("another config beside it") << "#import shipped/rover.sim\n" + robots + "Robot o { Config=Other }\n"
                                                  << "#import shipped/rover.sim\n" + copy + copied + "Robot o { Config=Other }\n";
        QTest::newRow("imported twice") << "#import shipped/rover.sim\n#import mine.sim\n" + robots
                                        << "#import shipped/rover.sim\n#import mine.sim\n" + copy + copied;
    }
    void copiesOfFaultyConfigsReplaceTheImport() {
        QFETCH(QString, main);
        QFETCH(QString, expected);
        PlanFixture fixture;
        const auto shipped = [&](const std::shared_ptr<const LoadedProject>& loaded) {
            auto other = std::make_shared<LoadedProject>(*loaded);
            other->shippedConfigs = fixture.path("shipped");
            return std::shared_ptr<const LoadedProject>(other);
        };
        const std::string rover = "#import common.sim\n#import load.sim\n#import hut.sim\n"
                                  "RobotConfig Rover { Body b { Box x { Size=1,1,1 Mass=$load Material=red } } }\n"
                                  "RobotConfig Other { Body b { Box x { Size=1,1,1 Mass=1 } } }\n";
        const auto open = [&](const std::string& shippedRover) {
            return shipped(fixture.open({{"main.sim", main.toStdString()},
                                         {"mine.sim", "#import shipped/rover.sim\n"},
                                         {"shipped/rover.sim", shippedRover},
                                         {"shipped/load.sim", "Param load = 2\n"},
                                         {"shipped/hut.sim", "StaticConfig Hut { Box b { Size=1,1,1 Pos=9,9,0 } }\n"},
                                         {"shipped/common.sim", kCommon}}));
        };
        const auto copyOf = [&](const LoadedProject& loaded) {
            return planCopyConfig(loaded, config(loaded), instancesOf(loaded, config(loaded)));
        };
        const auto sound = open(rover); // without an error the import stays
        QVERIFY(fixture.text(sound, copyOf(*sound)).starts_with("#import shipped/rover.sim"));
        std::string faulty = rover;
        faulty.replace(faulty.find("Mass="), 5, "Mas=");
        const auto loaded = open(faulty);
        QVERIFY(loaded->diagnostics.hasErrors());
        const auto plan = copyOf(*loaded);
        QCOMPARE(QString::fromStdString(fixture.text(loaded, plan)), QString(expected).replace("Mass=$", "Mas=$"));
        const auto found = std::ranges::find_if(
            loaded->diagnostics.all(), [](const Diagnostic& d) { return d.code == Code::UnknownKey && !d.fixes.empty(); });
        QVERIFY(found != loaded->diagnostics.all().end());
        const auto copied = shipped(fixture.apply(loaded, plan));
        const auto fixed = fixture.apply(copied, planFix(*loaded, found->fixes[0], *copied, [](const std::string& path) {
                                             return path == "RobotConfig.Rover" ? "RobotConfig.Rover2" : path;
                                         }));
        const bool isUsed = expected.contains("shipped/rover.sim\n");
        QVERIFY2(fixed->diagnostics.hasErrors() == isUsed, sample::rendered(*fixed).c_str());
        QVERIFY(expected.startsWith("#import shipped/rover.sim") == isUsed);
    }

    void rejectsEmptyCopy() {
        PlanFixture fixture;
        const auto loaded = fixture.open({{"main.sim", "#import rover.sim\n"}, {"rover.sim", kRover}, {"common.sim", kCommon}});
        const std::string text = fixture.text(loaded, planCopyConfig(*loaded, config(*loaded), {}));
        QVERIFY2(text.starts_with("#import rover.sim\n"), text.c_str());
        QVERIFY2(text.find("RobotConfig Rover2 {") != std::string::npos, text.c_str());
    }

private:
    static std::string firstMesh() {
        for (const auto& entry : std::filesystem::directory_iterator(TRUNDLE_SOURCE_DIR "/resources/meshes"))
            if (entry.is_regular_file()) return entry.path().filename().string();
        return {};
    }
};

QTEST_APPLESS_MAIN(EditTargetTest)
#include "edit_target_test.moc"
