// References by name: what each property accepts, what is reported otherwise, and what is suggested.
#include <QTest>

#include "lang/tree_edit.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;

namespace {

/// A config with names that are prefixes of each other, geoms with equal names in two bodies, and this block at its end.
std::string config(const std::string& block) {
    return "Material grey { } Surface rubber { }\nRobotConfig Rig {\n"
           "  Body arm { Box tip { Size=1,1,1 Mass=1 Material=grey Surface=rubber } }\n"
           "  Body arm1 { Box tip { Size=1,1,1 Mass=1 Material=grey Surface=rubber } Sphere ball { Radius=1 Mass=1 Material=grey "
           "Surface=rubber } }\n"
           "  Body arm10 { Box tip { Size=1,1,1 Mass=1 Material=grey Surface=rubber } }\n"
           "  Hinge h1 { Parent=arm Child=arm1 }  Slider h10 { Parent=world Child=arm10 }\n"
           "  RotaryMotor m1 { Joint=h1 TorqueConstant=1 SpeedConstant=1 Resistance=1 }\n"
           "  RotaryMotor m10 { Joint=h10 TorqueConstant=1 SpeedConstant=1 Resistance=1 }\n  " +
           block + "\n}\n";
}

} // namespace

class ReferencesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A joint comes into a PartConfig from outside like a body: a motor with its encoder for an axle of the robot.
    void jointsComeFromOutside() {
        const std::string drive = "PartConfig Drive {\n  RotaryMotor motor { Joint=$axle TorqueConstant=1 SpeedConstant=1 Resistance=2 }\n"
                                  "  Encoder count { Joint=$axle } }\n";
        const auto with = [&](const char* part) { return sample::resolved(drive + config(part) + "Robot r { Config=Rig }\n"); };
        const Resolved r = with("Hinge h2 { Parent=arm Child=arm10 } Part d { Config=Drive axle=h2 }");
        QCOMPARE(QString::fromStdString(r.messages()), QString());
        std::string joints;
        for (const ComponentSpec& device : r.config().devices) joints += device.name + ":" + device.text("Joint") + " ";
        QCOMPARE(joints, std::string("m1:h1 m10:h10 d.motor:h2 d.count:h2 "));
        QCOMPARE(with("Part d { Config=Drive }").messages(), std::string("E209 Part d needs axle: what PartConfig Drive is joined to\n"));
        QCOMPARE(with("Part d { Config=Drive axle=arm }").messages().substr(0, 20), std::string("E208 Joint names arm"));
    }

    void inAConfig_data() {
        QTest::addColumn<QString>("block");
        QTest::addColumn<QString>("said");
        QTest::addColumn<QString>("suggested");
        const auto row = [](const char* block, const char* said = "", const char* suggested = "") {
            QTest::newRow(block) << block << said << suggested;
        };
        row("Hinge j { Parent=arm10 Child=arm }");
        row("Hinge j { Parent=world Child=arm }");
        row("Hinge j { Parent=arm Child=world }", "E208 Child cannot be the world, a Parent can: exchange the two");
        row("Hinge j { Parent=arm2 Child=arm10 }", "E208 Parent names arm2, but there is no such Body", "arm arm1");
        row("Hinge j { Parent=h1 Child=arm }", "E208 Parent names h1, a Hinge; it takes a Body");
        row("Hinge j { Parent=arm.tip Child=arm1 }", "E208 Parent names arm.tip, a Box; it takes a Body", "arm");
        row("Hinge j { Parent=arm1 Child=arm1 }", "E307 the child of Hinge j is its parent as well");
        row("RotaryMotor m { Joint=h1 TorqueConstant=1 SpeedConstant=1 Resistance=1 }");
        row("RotaryMotor m { Joint=h10 TorqueConstant=1 SpeedConstant=1 Resistance=1 }");
        row("RotaryMotor m { Joint=h TorqueConstant=1 SpeedConstant=1 Resistance=1 }",
            "E208 Joint names h, but there is no such Hinge or Slider");
        row("RotaryMotor m { Joint=m10 TorqueConstant=1 SpeedConstant=1 Resistance=1 }",
            "E208 Joint names m10, a RotaryMotor; it takes a Hinge or Slider");
        row("Encoder e { Joint=h10 }", "E208 Joint names h10, a Slider; it takes a Hinge", "h1");
        row("DifferentialDrive d { LeftMotor=m1 RightMotor=m10 WheelRadius=1 }");
        row("DifferentialDrive d { LeftMotor=m1 RightMotor=m100 WheelRadius=1 }",
            "E208 RightMotor names m100, but there is no such RotaryMotor", "m10 m1");
        row("DifferentialDrive d { LeftMotor=h1 RightMotor=m10 WheelRadius=1 }",
            "E208 LeftMotor names h1, a Hinge; it takes a RotaryMotor", "m1");
        row("TouchSensor t { Geom=arm.tip, arm10.tip, arm1.ball }");
        row("TouchSensor t { Geom=arm.tip, arm.ball }", "E208 Geom names arm.ball, but there is no such geom (body.geom)");
        row("TouchSensor t { Geom=ball }", "E208 Geom names ball, but there is no such geom (body.geom)", "arm1.ball");
        row("TouchSensor t { Geom=arm1 }", "E208 Geom names arm1, a Body; it takes a geom (body.geom)", "arm1.tip arm1.ball");
        row("TouchSensor t { Geom=arm1. }", "E208 Geom names arm1., but there is no such geom (body.geom)");
        row("Transceiver r { Antenna=dipole }");
        row("Transceiver r { Antenna=whip }", "E208 Antenna names whip, but there is no AntennaPattern here");
        row("Transceiver r { Antenna=arm }", "E208 Antenna names arm, but there is no AntennaPattern here");
    }
    void inAConfig() {
        QFETCH(QString, block);
        QFETCH(QString, said);
        QFETCH(QString, suggested);
        const Resolved r = sample::resolved(config(block.toStdString()));
        const std::string messages = r.messages();
        QVERIFY2(said.isEmpty() ? messages.empty() : messages.starts_with(said.toStdString()), messages.c_str());
        if (said.isEmpty()) return;
        QCOMPARE(r.diagnostics.all().size(), std::size_t{1});
        const Diagnostic& d = r.diagnostics.all()[0];
        std::string words;
        for (const std::string& word : d.suggestions) words += (words.empty() ? "" : " ") + word;
        QVERIFY2(suggested.isEmpty() || QString::fromStdString(words).startsWith(suggested), words.c_str());
        // Each fix leads to a valid text.
        for (const Fix& fix : d.fixes) {
            const std::string fixed = applyEdits(r.texts->trees[0]->source().bytes(), fix.edits).value();
            QVERIFY2(sample::resolved(fixed).diagnostics.all().empty() || d.code != Code::UnknownReference ||
                         sample::resolved(fixed).messages().find("names") == std::string::npos,
                     fixed.c_str());
        }
    }

    /// A part with errors of its own is no unknown name; a joint on it is left out without another message.
    void partsWithErrors() {
        const Resolved r = sample::resolved(sample::with(config("Hinge j { Parent=arm Child=arm10 } Encoder e { Joint=j }"),
                                                         "Body arm10 { Box tip { Size=1,1,1 Mass=1",
                                                         "Body arm10 { Box tip { Size=1,1,-1 Mass=1"));
        SAYS(r, "E203 the 3rd element of Size is -1, it must be above 0\n");
        const Resolved kind = sample::resolved(config("Hing j { Parent=arm Child=arm10 } Encoder e { Joint=j }"));
        QCOMPARE(kind.diagnostics.errorCount(), std::size_t{1}); // the unknown kind alone
        for (const char* block : {"Transceiver r { Antenna=beam }", "TouchSensor t { Geom=slab.tip }"}) {
            // a misspelt kind or a part inside one: not reported again where it is used
            const Resolved r = sample::resolved("AntenaPattern beam { }\n" +
                                                config(std::string("Bodi slab { Box tip { Size=1,1,1 } } ") + block));
            QCOMPARE(r.diagnostics.errorCount(), std::size_t{2});
            QVERIFY2(r.messages().find("E208") == std::string::npos, r.messages().c_str());
        }
        const Resolved twice = sample::resolved(config("Hinge m1 { Parent=arm Child=arm10 } Encoder e { Joint=m1 }"));
        QVERIFY2(twice.messages().find("m1") != std::string::npos && twice.diagnostics.errorCount() == 2,
                 twice.messages().c_str());
    }

    /// One name is reported three times, each of several names by itself.
    void limitsFollowUps() {
        std::string blocks;
        for (int i = 0; i < 5; ++i) blocks += "Hinge j" + std::to_string(i) + " { Parent=nobody Child=arm1 }\n";
        const Resolved r = sample::resolved(config(blocks + "Hinge k { Parent=none Child=arm10 }"));
        QCOMPARE(QString::fromStdString(r.messages()).count("names nobody"), 3);
        QCOMPARE(QString::fromStdString(r.messages()).count("names none"), 1);
    }

    /// Materials and surfaces: by index, also where defined later, with one hint.
    void materialsAndSurfaces() {
        const Resolved r =
            sample::resolved("Surface ice { Friction=0.1 }\nStaticConfig Land {\n  Plane a { Material=red Surface=rubber }\n"
                             "  Plane b { Material=blue Surface=ice }\n  Plane c { Material=default Surface=default }\n"
                             "  Plane d { Material=red Surface=rubber } }\n"
                             "Material blue { } Material red { } Surface rubber { }\nStatic land { Config=Land }\n");
        SAYS(r, "E315 Material red is defined after its first use\nE315 Surface rubber is defined after its first use\n"
                "E315 Material blue is defined after its first use\n");
        const std::vector<GeomSpec>& geoms = *r.experiment->statics.at(0).geoms;
        const auto names = [&](std::size_t i) {
            return r.experiment->materials.at(geoms[i].material).name + " " + r.experiment->surfaces.at(geoms[i].surface).name;
        };
        QCOMPARE(names(0), std::string("red rubber"));
        QCOMPARE(names(1), std::string("blue ice"));
        QCOMPARE(geoms[2].material + geoms[2].surface, 0u);
        const Resolved byParam = sample::resolved(
            "Material blue { } Material red { } Surface ice { } Surface rubber { }\nParam paint = red\nParam sole = rubber\n"
            "StaticConfig Land { Param inner = ice  Plane a { Material=$paint Surface=$sole } Plane b { Material=blue "
            "Surface=$inner } }\n"
            "Static land { Config=Land }\n");
        SAYS(byParam, "");
        const std::vector<GeomSpec>& painted = *byParam.experiment->statics.at(0).geoms;
        QCOMPARE(byParam.experiment->materials.at(painted[0].material).name, std::string("red"));
        QCOMPARE(byParam.experiment->surfaces.at(painted[0].surface).name, std::string("rubber"));
        QCOMPARE(byParam.experiment->materials.at(painted[1].material).name, std::string("blue"));
        QCOMPARE(byParam.experiment->surfaces.at(painted[1].surface).name, std::string("ice"));
        const Resolved wrong = sample::resolved(
            "Material grey { } Surface grip { }\nStaticConfig Land { Plane a { Material=grip Surface=grey } }\n");
        QVERIFY(wrong.messages().starts_with("E208 Material names grip, but there is no such Material"));
        QVERIFY(wrong.messages().find("E208 Surface names grey, but there is no such Surface") != std::string::npos);
    }

    void instances_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* line, const char* said = "") { QTest::newRow(line) << line << said; };
        row("Robot r { Config=Rover }");
        row("Param which = Rover\nRobot r { Config=$which }");
        row("Param Slab = Rover\nRobot r { Config=$Slab }");
        row("Robot r { Config=Slab }", "E208 Config names Slab, a StaticConfig; a Robot takes a RobotConfig\n");
        row("Static s { Config=Rover }", "E208 Config names Rover, a RobotConfig; a Static takes a StaticConfig\n");
        row("Static s { Config=Slab1 }", "E208 Config names Slab1, but there is no such StaticConfig\n");
        row("Robot r { Config=Rove }", "E208 Config names Rove, but there is no such RobotConfig\n");
        row("Robot r { Config=robot1 }", "E208 Config names robot1, but there is no such RobotConfig; there is Rover\n");
        row("PoseLog p { Robot=robot1, robot10, swarm }");
        row("PoseLog p { Robot=swarm_0, swarm_2 }");
        row("PoseLog p { Robot=swarm_3 }",
            "E208 Robot names swarm_3, but Grid swarm has no member swarm_3; the last one is swarm_2\n");
        row("PoseLog p { Robot=robot }", "E208 Robot names robot, but there is no such robot\n");
        row("PoseLog p { Robot=robot100 }", "E208 Robot names robot100, but there is no such robot\n");
        row("PoseLog p { Robot=slab }", "E208 Robot names slab, a Static; it takes a robot\n");
        row("PoseLog p { Robot=robot1, slab }", "E208 Robot names slab, a Static; it takes a robot\n");
        row("View v { Mode=follow Robot=robot10 Eye=1,2,3 }");
        row("View v { Mode=follow Robot=robot11 Eye=1,2,3 }", "E208 Robot names robot11, but there is no such robot\n");
    }
    void instances() {
        QFETCH(QString, line);
        QFETCH(QString, said);
        const Resolved r =
            sample::resolved(sample::rover("StaticConfig Slab { Box b { Size=1,1,1 Material=grey Surface=rubber } }\n"
                                           "Static slab { Config=Slab }\nRobot robot1 { Config=Rover }\n"
                                           "Robot robot10 { Config=Rover }\n"
                                           "Grid swarm { Config=Rover Count=3 Spacing=1 }\n" +
                                           line.toStdString() + "\n"));
        SAYS(r, said);
    }

    /// In a list, the name of a Grid is replaced by those of its members, in order.
    void layoutsInLists() {
        const Resolved r = sample::resolved(
            sample::rover("PoseLog p { Robot=robot1, swarm, swarm_1 }\nGrid swarm { Config=Rover Count=2 Spacing=1 }\n"
                          "Grid swarm_1x { Config=Rover Count=3 Spacing=1 }\nRobot robot1 { Config=Rover }\n"));
        SAYS(r, "");
        const std::vector<std::string> expected{"robot1", "swarm_0", "swarm_1", "swarm_1"};
        QCOMPARE(r.experiment->logs.at(0).texts("Robot"), expected);
    }
};

QTEST_APPLESS_MAIN(ReferencesTest)
#include "references_test.moc"
