// Loading a project: values, imports, modules, and the fixes of their diagnostics.
#include <QTest>

#include <sys/stat.h>

#include "lang/tree_edit.h"
#include "model/provenance.h"
#include "sample_project.h"

using namespace trundle;
using sample::ProjectFixture;

namespace {

/// Compares what is reported, message by message.
#define SAYS(loaded, expected) QCOMPARE(QString::fromStdString(sample::messages(*(loaded))), QString(expected))

std::string scene(const std::string& more) { return std::string(sample::kGoodRobot) + more; }

} // namespace

class ProjectTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aWholeRobot() {
        ProjectFixture fixture;
        const auto loaded = fixture.open(scene("Tick = 5 ms  Seed = 7\nRobot robot0 { Config=Rover Pos=1,2,0 HPR=90,0,0 Walker "
                                               "brain { Speed=20cm/s } }\n#loadModule walker\n"));
        SAYS(loaded, "");
        const ExperimentSpec& e = *loaded->experiment;
        QCOMPARE(e.settings.tick, 0.005);
        QCOMPARE(e.settings.seed, 7u);
        QCOMPARE(e.robots.size(), 1u);
        const RobotSpec& robot = e.robots[0];
        QCOMPARE(robot.name, "robot0");
        QVERIFY((robot.pose * Vec3(1, 0, 0) - Vec3(1, 3, 0)).norm() < 1e-12);
        const RobotConfigSpec& config = *robot.config;
        QCOMPARE(config.bodies.size(), 3u);
        QCOMPARE(config.bodies[0].mass.mass, 2.0);
        QVERIFY((config.bodies[0].mass.centre - Vec3(0, 0, 0.09)).norm() < 1e-12);
        QCOMPARE(config.bodies[1].geoms[0].radius, 0.05);
        QCOMPARE(config.bodies[1].geoms[0].material, 1u);
        QCOMPARE(config.joints[0].axis, Vec3(0, 1, 0));
        QCOMPARE(config.joints[0].anchor, Vec3(0, 0.1, 0.05));
        QCOMPARE(config.joints[0].parent, 0);
        QCOMPARE(config.joints[0].child, 1);
        QCOMPARE(config.devices.size(), 4u);
        QCOMPARE(config.devices[0].number("Resistance"), 2.0);
        QCOMPARE(config.devices[2].text("Control"), "servo");
        QCOMPARE(config.devices[3].texts("Geom").front(), "chassis.hull");
        QCOMPARE(robot.controllers.size(), 1u);
        QCOMPARE(robot.controllers[0].number("Speed"), 0.2);
        QCOMPARE(robot.controllers[0].number("UpdatePeriod"), 0.0);
        QCOMPARE(e.modules.at(0).library, "/modules/libwalker.so");
    }

    void paramsAndOverrides() {
        ProjectFixture fixture;
        const auto loaded = fixture.open(scene(R"(
Param big = 8 cm
Robot plain { Config=Rover }
Robot fat { Config=Rover wheelRadius=$big leftMotor.Resistance=$(big*100/4) chassis.hull.Mass=500 g }
Robot twin { Config=Rover wheelRadius=$big leftMotor.Resistance=2 chassis.hull.Mass=0.5 }
Robot plain2 { Config=Rover }
)"));
        // big*100/4 is 2 m: a length is not a resistance
        SAYS(loaded, "E206 Resistance is a resistance (ohm), m is a length\n");
        const auto& robots = loaded->experiment->robots;
        QCOMPARE(robots.size(), 4u);
        QVERIFY(robots[0].config == robots[3].config);
        QVERIFY(robots[0].config != robots[2].config);
        QCOMPARE(robots[2].config->bodies[1].geoms[0].radius, 0.08);
        QCOMPARE(robots[2].config->bodies[1].pose.position.z(), 0.08);
        QCOMPARE(robots[2].config->bodies[0].mass.mass, 0.5);
        QCOMPARE(robots[2].config->devices[0].find("Resistance")->origin, Origin::Instance);
        QCOMPARE(robots[0].config->devices[0].find("Resistance")->origin, Origin::Config);
        QCOMPARE(robots[0].config->devices[0].find("GearRatio")->origin, Origin::Default);
        QCOMPARE(robots[0].config->devices[2].find("WheelRadius")->origin, Origin::Param);
    }

    void expressions_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("order") << "$(1 + 2 * 3)" << 7.0;
        QTest::newRow("power") << "$(2 ^ 3 ^ 2)" << 512.0;
        QTest::newRow("minus") << "$(-2 ^ 2)" << -4.0;
        QTest::newRow("functions") << "$(max(1, min(5, 3), 2) + abs(-1) + sqrt(16))" << 8.0;
        QTest::newRow("degrees") << "$(sin(30) * 2 + cos(60) * 2 + tan(45))" << 3.0;
        QTest::newRow("pi") << "$(pi)" << std::numbers::pi;
        QTest::newRow("length") << "$(w * 2)" << 0.1;
        QTest::newRow("percent") << "$(half * 4)" << 2.0;
        QTest::newRow("ratio") << "$(w / 0.05)" << 1.0;
    }
    void expressions() {
        QFETCH(QString, text);
        QFETCH(double, value);
        ProjectFixture fixture;
        const auto loaded = fixture.open(
            scene("Param half = 50%\nParam w = 5 cm\nRobot robot0 { Config=Rover Pos=" + text.toStdString() + ",0,0 }\n"));
        SAYS(loaded, "");
        QVERIFY(std::abs(loaded->experiment->robots[0].pose.position.x() - value) < 1e-9);
    }

    void aGridInOrder() {
        ProjectFixture fixture;
        const auto loaded = fixture.open(scene("Grid swarm { Config=Rover Count=3,2 Spacing=2,1 Pos=10,0,0 HPR=90,0,0 }\nPoseLog "
                                               "all { Robot=swarm }\nPoseLog one { Robot=swarm_4 }\n"));
        SAYS(loaded, "");
        const auto& robots = loaded->experiment->robots;
        QCOMPARE(robots.size(), 6u);
        QCOMPARE(robots[5].name, "swarm_5");
        QVERIFY((robots[0].pose.position - Vec3(10.5, -2, 0)).norm() < 1e-12);
        QVERIFY((robots[2].pose.position - Vec3(10.5, 2, 0)).norm() < 1e-12);
        QVERIFY((robots[3].pose.position - Vec3(9.5, -2, 0)).norm() < 1e-12);
        QVERIFY(robots[0].config == robots[5].config);
        QCOMPARE(loaded->experiment->logs.at(0).texts("Robot").size(), 6u);
        QCOMPARE(loaded->experiment->logs.at(1).texts("Robot").at(0), "swarm_4");
    }

    void scatterAvoidsOverlaps() {
        ProjectFixture fixture;
        const std::string text = scene(R"(
StaticConfig Arena {
  Plane floor { Material=grey Surface=rubber }
  Box slab { Size=10,10,0.1 Pos=0,0,-0.05 Material=grey Surface=rubber }
  Box block { Size=2,2,1 Pos=0,0,0.5 Material=grey Surface=rubber }
}
Scatter swarm { Config=Rover Count=60 Area=-4,-4,4,4 MinDistance=0.5 }
Static arena { Config=Arena }
)");
        const auto loaded = fixture.open(text);
        SAYS(loaded, "");
        const auto& robots = loaded->experiment->robots;
        QCOMPARE(robots.size(), 60u);
        for (std::size_t i = 0; i < robots.size(); ++i) {
            const Vec3 p = robots[i].pose.position;
            QVERIFY(std::abs(p.x()) <= 4 && std::abs(p.y()) <= 4);
            QVERIFY2(std::max(std::abs(p.x()), std::abs(p.y())) > 1.15, "it stands in the block");
            for (std::size_t k = 0; k < i; ++k) QVERIFY((p - robots[k].pose.position).norm() >= 0.5);
        }
        const auto again = fixture.open(text);
        const auto other = fixture.open("Seed = 2\n" + text);
        QCOMPARE(again->experiment->robots[7].pose.position, robots[7].pose.position);
        QVERIFY(other->experiment->robots[7].pose.position != robots[7].pose.position);
    }

    void importerSettingsWin() {
        ProjectFixture fixture;
        fixture.write("a.sim", "Tick = 0.001\nDuration = 5\nParam here = 3\n");
        const auto loaded = fixture.open("Tick = 0.02\n#import a.sim\nIterations = $(here + 1)\n");
        SAYS(loaded, "");
        QCOMPARE(loaded->experiment->settings.tick, 0.02);
        QCOMPARE(loaded->experiment->settings.duration, 5.0);
        QCOMPARE(loaded->experiment->settings.iterations, 4);
    }

    /// A file imported inside a block may define materials: they belong to the top level.
    void importsInsideABlock() {
        ProjectFixture fixture;
        fixture.write("common/looks.sim", "Material grey { ColorRGB=0.5,0.5,0.5 }\nSurface rubber { Friction=1 }\n");
        fixture.write(
            "parts/wheel.sim",
            "#import ../common/looks.sim\nBody wheel { Sphere tyre { Radius=0.1 Mass=1 Material=grey Surface=rubber } }\n");
        const auto loaded = fixture.open(
            "RobotConfig Rover {\n  #import parts/wheel.sim\n  #import parts\\wheel.sim\n}\nRobot robot0 { Config=Rover }\n");
        QVERIFY(loaded);
        // `../common` from parts/ is outside parts/ but inside the project folder
        SAYS(loaded, "E331 parts\\wheel.sim is imported twice in one block; once is enough\n");
        QCOMPARE(loaded->experiment->robots.at(0).config->bodies.at(0).name, "wheel");
        QCOMPARE(loaded->experiment->robots[0].config->bodies[0].geoms[0].material, 1u);
        QCOMPARE(loaded->trees.size(), 3u);
    }

    /// Each of 30 files imports the next one twice: 2^30 import paths, 31 files.
    void eachFileIsOpenedOnce() {
        ProjectFixture fixture;
        for (int i = 1; i <= 30; ++i) {
            const std::string next = i < 30 ? "f" + std::to_string(i + 1) + ".sim" : std::string("end.sim");
            fixture.write("f" + std::to_string(i) + ".sim", "#import " + next + "\n#import " + next + "\n");
        }
        fixture.write("end.sim", "Tick = 0.02\n");
        const auto loaded = fixture.open("#import f1.sim\n#import f1.sim\n");
        QCOMPARE(loaded->diagnostics.all().size(), 31u); // one for each of the files that import twice
        for (const Diagnostic& d : loaded->diagnostics.all()) QCOMPARE(d.code, Code::ImportedTwice);
        QCOMPARE(loaded->trees.size(), 32u);
        QCOMPARE(loaded->experiment->settings.tick, 0.02);
    }

    /// The same inside blocks gives 2^20 blocks: they are counted, not built.
    void blocksAreCountedBeforeTheyAreBuilt() {
        ProjectFixture fixture;
        for (int i = 1; i <= 20; ++i) {
            const std::string next = "#import f" + std::to_string(i + 1) + ".sim\n";
            fixture.write("f" + std::to_string(i) + ".sim", "Body a {\n" + next + "}\nBody b {\n" + next + "}\n");
        }
        fixture.write("f21.sim", "Box { Size=1,1,1 }\n");
        const auto loaded = fixture.open("RobotConfig Big {\n#import f1.sim\n}\n");
        QVERIFY(sample::messages(*loaded).starts_with("E312 "));
    }

    void importsTooDeep() {
        ProjectFixture fixture;
        for (int i = 1; i <= 40; ++i)
            fixture.write("f" + std::to_string(i) + ".sim", "#import f" + std::to_string(i + 1) + ".sim\n");
        const auto loaded = fixture.open("#import f1.sim\n");
        SAYS(loaded, "E310 imports are nested more than 32 deep\n");
        QCOMPARE(loaded->trees.size(), 33u);
    }

    void tooManyFiles() {
        ProjectFixture fixture;
        std::string text;
        for (int i = 0; i < 1005; ++i) {
            fixture.write("f" + std::to_string(i) + ".sim", "");
            text += "#import f" + std::to_string(i) + ".sim\n";
        }
        SAYS(fixture.open(text), "E313 an experiment may hold 1000 files, this is one more\n");
    }

    void filesThatCannotBeRead() {
        ProjectFixture fixture;
        QCOMPARE(mkfifo((fixture.folder() + "/pipe.sim").c_str(), 0600), 0);
        fixture.write("folder/inner.sim", "");
        fixture.write("huge.sim", "");
        std::filesystem::resize_file(fixture.folder() + "/huge.sim", std::uintmax_t{200} << 20);
        const std::string said =
            sample::messages(*fixture.open("#import pipe.sim\n#import folder\n#import huge.sim\n#import \"\"\n"));
        QVERIFY2(said.find("E322 pipe.sim is not a plain file\nE308 folder is not found: ") == 0, said.c_str());
        QVERIFY2(said.find("/folder is a folder; looked in ") < said.find("\nE115 "), said.c_str());
        QVERIFY(!fixture.tryOpen(fixture.folder()).ok());
        QVERIFY(!fixture.tryOpen(fixture.folder() + "/pipe.sim").ok());
        QVERIFY(!fixture.tryOpen(fixture.folder() + "/missing.sim").ok());
        QVERIFY(fixture.tryOpen(fixture.folder() + "/huge.sim").error().code == Code::TooLarge);
    }

    /// The 64 MiB are for all texts of an experiment together.
    void allTextsTogetherAreLimited() {
        ProjectFixture fixture;
        for (const char* name : {"a.sim", "b.sim", "c.sim"}) fixture.write(name, std::string(std::size_t{25} << 20, ' '));
        const auto loaded = fixture.open("#import a.sim\n#import b.sim\n#import c.sim\nTick = 0.02\n");
        QVERIFY2(sample::messages(*loaded).find("/c.sim is too large") != std::string::npos, sample::messages(*loaded).c_str());
        QCOMPARE(loaded->diagnostics.errorCount(), std::size_t{1});
        QCOMPARE(loaded->experiment->settings.tick, 0.02);
    }

    /// A path may contain `..`, but must end inside the project; a symbolic link out of it is refused.
    void pathsStayInside() {
        ProjectFixture fixture, elsewhere;
        elsewhere.write("secret.sim", "Tick = 0.02\n");
        std::filesystem::create_symlink(elsewhere.folder() + "/secret.sim", fixture.folder() + "/link.sim");
        const std::string said = sample::messages(
            *fixture.open("#import link.sim\n#import " + elsewhere.folder() + "/secret.sim\n#import ../../../../etc/passwd\n"));
        QCOMPARE(QString::fromStdString(said).count("E311 "), 3);
        fixture.options.includeFolders = {elsewhere.folder()};
        const auto loaded = fixture.open("#import secret.sim\n");
        SAYS(loaded, "");
        QCOMPARE(loaded->experiment->settings.tick, 0.02);
    }

    void theProjectFolder() {
        ProjectFixture fixture;
        const std::string file = fixture.write("configs/experiments/a.sim", "#import robots/b.sim\n");
        fixture.write("configs/robots/b.sim", "Tick = 0.02\n");
        const auto loaded = fixture.openFile(file);
        SAYS(loaded, "");
        QVERIFY(loaded->projectFolder.ends_with("/configs"));
    }

    void picturesWithoutTheirEnding() {
        ProjectFixture fixture;
        fixture.write("RobotChassis.jpeg", "picture");
        const auto loaded = fixture.open("Material chassis { Texture=RobotChassis }\nMaterial gone { Texture=RobotChasis }\n");
        QVERIFY(loaded->experiment->materials[1].texturePath.ends_with("RobotChassis.jpeg"));
        QCOMPARE(loaded->experiment->materials[1].texture, "RobotChassis");
        QVERIFY(!loaded->diagnostics.hasErrors());
        QVERIFY(sample::messages(*loaded).starts_with("E318 the picture RobotChasis is not found"));
    }

    void theThesisModuleName() {
        ProjectFixture fixture;
        const auto loaded =
            fixture.open(scene("#loadModule Controllers/walker.dll\nRobot robot0 { Config=Rover Walker brain { Speed=1 } }\n"));
        SAYS(loaded, "");
    }

    /// A pasted robot names the kind of its controller without the `#loadModule` line.
    void aKindOfAModuleThatIsNotLoaded() {
        ProjectFixture fixture;
        fixture.write("crew.sim", scene("#loadModule walker\nRobot robot0 { Config=Rover Walker brain { Speed=1 } }\n"
                                        "Robot robot1 { Config=Rover Prowler brain { } }\n"));
        const auto loaded = fixture.open("#import crew.sim\nRobot robot2 { Config=Rover Prowler brain { } }\n");
        QCOMPARE(sample::messages(*loaded), "E301 Prowler is a kind of the module controllers/prowler, which is not loaded\n"
                                            "E301 Prowler is a kind of the module controllers/prowler, which is not loaded\n");
        // The fix edits the file that uses the kind, after its existing `#loadModule` lines.
        const auto& said = loaded->diagnostics.all();
        QCOMPARE(said[0].fixes.at(0).title, "#loadModule controllers/prowler");
        QCOMPARE(said[0].fixes[0].edits.at(0).range.file, said[0].range.file);
        fixture.write("crew.sim", applyEdits(loaded->trees[1]->source().bytes(), said[1].fixes.at(0).edits).value());
        const auto repaired = fixture.openFile(fixture.folder() + "/main.sim");
        SAYS(repaired, "");
    }

    /// The fix imports the file of the project or of the shipped configs with the definition, in the file that uses it.
    void aDefinitionThatIsNotImported() {
        ProjectFixture fixture;
        QTemporaryDir shipped;
        const auto ship = [&shipped](const std::string& name, const std::string& text) {
            const std::filesystem::path path = shipped.path().toStdString() + "/" + name;
            std::filesystem::create_directories(path.parent_path());
            std::ofstream(path, std::ios::binary) << text;
        };
        fixture.options.shippedConfigs = shipped.path().toStdString();
        ship("common/looks.sim", "Material shiny { }\nSurface smooth { }\n");
        ship("robots/scout.sim", "#import common/looks.sim\nRobotConfig Scout { Body b { Sphere s { Radius=0.1 Mass=1 "
                                 "Material=shiny Surface=smooth } } }\n");
        fixture.write("parts/hut.sim", "StaticConfig Hut { Box b { Size=1,1,1 Material=shiny Surface=smooth } }\n");
        const auto loaded = fixture.open("Tick = 0.01\nParam which = Scout\n#import parts/hut.sim\nStatic hut { Config=Hut }\n"
                                         "Robot robot0 { Config=Scout }\nRobot robot1 { Config=$which }\n");
        QCOMPARE(sample::messages(*loaded), "E208 Scout is defined in robots/scout.sim, which is not imported\n"
                                            "E208 Scout is defined in robots/scout.sim, which is not imported\n"
                                            "E208 shiny is defined in common/looks.sim, which is not imported\n"
                                            "E208 smooth is defined in common/looks.sim, which is not imported\n");
        const auto& said = loaded->diagnostics.all();
        for (const Diagnostic& d : said) QCOMPARE(d.fixes.size(), std::size_t{1});
        QCOMPARE(said[0].fixes[0].title, "#import robots/scout.sim");
        QCOMPARE(said[2].fixes[0].edits.at(0).range.file, said[2].range.file); // every file imports what it uses
        for (const FileId file : {FileId{0}, FileId{1}}) {
            const auto& fix =
                std::find_if(said.begin(), said.end(), [&](const auto& d) { return d.range.file == file; })->fixes[0];
            const std::string text = applyEdits(loaded->trees[file]->source().bytes(), fix.edits).value();
            std::ofstream(loaded->paths[file], std::ios::binary) << text;
        }
        const auto fixed = fixture.openFile(fixture.folder() + "/main.sim");
        SAYS(fixed, "");
        QVERIFY(fixed->trees[0]->source().bytes().starts_with("Tick = 0.01\nParam which = Scout\n#import parts/hut.sim\n"
                                                              "#import robots/scout.sim\n"));
    }

    /// The fix offers no import that would add robots, be circular or define something twice.
    void offersOnlyImportableFiles() {
        ProjectFixture fixture;
        const std::string scout = "RobotConfig Scout { Body b { Sphere s { Radius=0.1 Mass=1 } } }\n";
        fixture.write("experiment.sim", scout + "Robot other { Config=Scout }\n");
        fixture.write("timed.sim", "Tick = 0.02\n" + scout);
        fixture.write("circle.sim", "#import main.sim\n" + scout);
        fixture.write("twice.sim", scout + "Material grey { }\n");
        fixture.write("other_kind.sim", "StaticConfig Scout { }\n");
        const auto loaded = fixture.open("Material grey { }\nRobot robot0 { Config=Scout }\n");
        QCOMPARE(sample::messages(*loaded), "E208 Config names Scout, but there is no RobotConfig here\n");
        QVERIFY(loaded->diagnostics.all()[0].fixes.empty());
        fixture.write("good.sim", scout);
        const auto again = fixture.open("Material grey { }\nRobot robot0 { Config=Scout }\n");
        QCOMPARE(again->diagnostics.all()[0].fixes.at(0).title, "#import good.sim");
    }

    void everyGeomAndJoint() {
        ProjectFixture fixture;
        fixture.write("cube.obj", "");
        fixture.write("hills.png", "");
        const auto loaded = fixture.open(R"(
Material grey { } Surface rubber { }
RobotConfig Zoo {
  Body a { Mass=2 Capsule { Radius=0.1 Length=0.5 Material=grey Surface=rubber } }
  Body b { Convex { File=cube.obj Scale=0.1 Mass=1 Material=grey Surface=rubber } }
  Body c { Mesh { File=cube.obj Density=1000 Material=grey Surface=rubber } }
  Body d { Mass=1 CenterOfMass=0,0,1 Inertia=1,1,1,0.1,0,0 }
  Slider s { Parent=a Child=b Axis=1,0,0 LowStop=-5cm HighStop=5cm }
  Ball n { Parent=b Child=c }
  Universal u { Parent=world Child=a }
  Suspension w { Parent=c Child=d Travel=0.05 Stiffness=1000 }
  Fixed f { Parent=a Child=d }
}
StaticConfig Land { Heightfield { File=hills.png Size=10,10,1 Material=grey Surface=rubber } Mesh { File=cube.obj Material=grey Surface=rubber } }
Static land { Config=Land }
Robot zoo { Config=Zoo }
)");
        SAYS(loaded, "");
        const RobotConfigSpec& zoo = *loaded->experiment->robots.at(0).config;
        QVERIFY(zoo.bodies[1].geoms[0].collideAsHull && zoo.bodies[1].geoms[0].hull->points.size() == 8);
        QVERIFY(std::abs(zoo.bodies[2].mass.mass - 1000) < 1e-6);
        QVERIFY((zoo.bodies[2].mass.centre - Vec3(0.5, 0.5, 0.5)).norm() < 1e-9);
        QCOMPARE(zoo.bodies[3].mass.inertia(0, 1), 0.1);
        QCOMPARE(*zoo.joints[0].lowStop, -0.05);
        QCOMPARE(zoo.joints[3].axis2, Vec3(0, 1, 0));
        const auto& land = *loaded->experiment->statics.at(0).geoms;
        QCOMPARE(land[0].name, "heightfield");
        QVERIFY(land[0].heightMap);
        QVERIFY(!land[1].collideAsHull);
    }

    void numbersUnnamedObjects() {
        ProjectFixture fixture;
        const auto loaded = fixture.open(R"(
Material grey { } Surface rubber { }
StaticConfig Arena {
  Box { Size=1,1,1 Material=grey Surface=rubber }
  Box box2 { Size=1,1,1 Material=grey Surface=rubber }
  Box { Size=1,1,1 Material=grey Surface=rubber }
}
Static arena { Config=Arena }
)");
        SAYS(loaded, "");
        const auto& geoms = *loaded->experiment->statics.at(0).geoms;
        QCOMPARE(geoms[0].name + geoms[1].name + geoms[2].name, "boxbox2box3");
    }

    void reportsOriginOfValues() {
        ProjectFixture fixture;
        fixture.options.sets = {"robot0.rightMotor.Resistance=4"};
        const auto loaded =
            fixture.open(scene("#loadModule walker\nRobot robot0 { Config=Rover leftMotor.Resistance=3 Walker brain { Speed=1 } "
                               "}\nGrid swarm { Config=Rover Count=2 Spacing=3 Pos=0,9,0 }\nTick=0.02\n"));
        SAYS(loaded, "");
        const auto text = [&](const char* path, Origin origin) {
            const auto p = provenanceOf(*loaded->outline, path);
            if (!p) return std::string("nothing");
            return p->origin == origin ? std::string(loaded->outline->texts().slice(p->value)) : "another origin";
        };
        QCOMPARE(text("robot0.chassis.hull.Mass", Origin::Config), "2");
        QCOMPARE(text("robot0.leftMotor.Resistance", Origin::Instance), "3");
        QCOMPARE(text("robot0.rightMotor.Resistance", Origin::CommandLine), "4");
        QCOMPARE(text("robot0.rightMotor.GearRatio", Origin::Default), "");
        QCOMPARE(text("robot0.leftWheel.tyre.Radius", Origin::Param), "$wheelRadius");
        QCOMPARE(text("robot0.brain.Speed", Origin::Instance), "1");
        QCOMPARE(text("swarm_1.leftMotor.Resistance", Origin::Config), "2");
        QCOMPARE(text("Surface.rubber.Friction", Origin::Config), "1");
        QCOMPARE(text("Tick", Origin::Config), "0.02");
        QCOMPARE(text("Seed", Origin::Default), "");
        QCOMPARE(text("robot0.chassis.hull.Weight", Origin::Config), "nothing");
        QCOMPARE(text("robot9.chassis.hull.Mass", Origin::Config), "nothing");
    }

    /// Opening a text of a thousand robots is fast; tests/bench measures the time.
    void aThousandRobots() {
        ProjectFixture fixture;
        std::string text = scene("#loadModule walker\n");
        for (int i = 0; i < 1000; ++i) {
            text += "Robot r" + std::to_string(i) + " { Config=Rover Pos=" + std::to_string(i) +
                    ",0,0 Walker brain { Speed=0.3 } }\n";
        }
        const auto loaded = fixture.open(text);
        SAYS(loaded, "");
        QCOMPARE(loaded->experiment->robots.size(), 1000u);
        QVERIFY(loaded->experiment->robots[0].config == loaded->experiment->robots[999].config);
    }
};

QTEST_APPLESS_MAIN(ProjectTest)
#include "project_test.moc"
