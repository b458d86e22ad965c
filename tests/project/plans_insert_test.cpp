// Inserts blocks given as text, and the text that templateOf returns for every kind.
#include <QTest>

#include "plan_fixture.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const char* const kCart = R"(RobotConfig Cart {
  Body chassis {
    Box hull { Size=1,1,1 Mass=1 }
  }
  Body wheel { Sphere tyre { Radius=0.1 Mass=1 } }
  Hinge axle { Parent=chassis Child=wheel }
}
)";

std::string scene(const std::string& more) { return kCart + more; }

std::vector<std::string> newErrors(const LoadedProject& before, const LoadedProject& after) {
    std::vector<std::string> fresh;
    for (const Diagnostic& d : after.diagnostics.all())
        if (d.severity == Severity::Error) fresh.push_back(d.message);
    for (const Diagnostic& d : before.diagnostics.all()) {
        const auto it = std::find(fresh.begin(), fresh.end(), d.message);
        if (it != fresh.end()) fresh.erase(it);
    }
    return fresh;
}

/// A kind of a foreign module with every type of property.
struct Odd {
    std::string motor, joint, geom, body, any, mode, word, picture, config;
    std::vector<std::string> geoms;
    double above = 0, below = 0, between = 0, far = 0;
    std::array<double, 3> triple{};
    int whole = 0;
    bool yes = false;
    static void describe(Describe<Odd>& d) {
        d.field("Motor", &Odd::motor, reference("RotaryMotor").required(), "A motor.");
        d.field("Joint", &Odd::joint, reference("Slider").required(), "A slider.");
        d.field("Geom", &Odd::geom, reference("Geom").required(), "A geom.");
        d.field("Body", &Odd::body, reference("Body").required(), "A body.");
        d.field("Mode", &Odd::mode, oneOf("slow|fast").required(), "How.");
        d.field("Word", &Odd::word, text().required(), "A word.");
        d.field("Picture", &Odd::picture, trundle::file("png").required(), "A picture.");
        d.field("Geoms", &Odd::geoms, reference("Geom").required().counted(2, 5), "Two geoms.");
        d.field("Above", &Odd::above, number().above(7).required(), "Above 7.");
        d.field("Below", &Odd::below, number().below(-2).required(), "Below -2.");
        d.field("Between", &Odd::between, metres().above(3).atMost(3.5).required(), "Between.");
        d.field("Far", &Odd::far, number().within(1e6, 1e7).required(), "Far.");
        d.field("Triple", &Odd::triple, number().within(-1, 0).required(), "Three.");
        Quantity whole = number().within(3, 5).required();
        whole.type = TRUNDLE_INTEGER;
        d.field("Whole", &Odd::whole, whole, "Whole.");
        d.field("Yes", &Odd::yes, flag().required(), "Yes or no.");
    }
};
struct OddBrain {
    std::string drive;
    double gain = 0;
    static void describe(Describe<OddBrain>& d) {
        d.field("Drive", &OddBrain::drive, reference("DifferentialDrive").required(), "The drive.");
        d.field("Gain", &OddBrain::gain, number().above(0).required(), "Gain.");
    }
};

} // namespace

class PlansInsertTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void inserts_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("selects");
        const auto row = [](const char* what, const std::string& before, const char* parent, const char* text,
                            const std::string& after, const char* selects) {
            QTest::newRow(what) << QString::fromStdString(before) << parent << text << QString::fromStdString(after) << selects;
        };
        row("into nothing", "", "", "Material red { }", "Material red { }\n", "Material.red");
        row("only a comment", "// mine", "", "Material red { }\n", "// mine\nMaterial red { }\n", "Material.red");
        row("taken", "Material red { }\n", "", "Material red { }", "Material red { }\nMaterial red2 { }\n", "Material.red2");
        row("robot", scene("Robot robot0 { Config=Cart }\n"), "", "Robot robot0 { Config=Cart }",
            scene("Robot robot0 { Config=Cart }\nRobot robot1 { Config=Cart }\n"), "robot1");
        row("no name given", scene(""), "", "Robot { Config=Cart }", scene("Robot robot { Config=Cart }\n"), "robot");
        row("one line", "StaticConfig A { Box a { Size=1,1,1 } }", "StaticConfig.A", "Box a { Size=2,2,2 }",
            "StaticConfig A { Box a { Size=1,1,1 } Box a2 { Size=2,2,2 } }", "StaticConfig.A.a2");
        row("an empty block", "StaticConfig A {}\n", "StaticConfig.A", "Box { Size=2,2,2 }\nSphere s { Radius=1 }",
            "StaticConfig A { Box { Size=2,2,2 } Sphere s { Radius=1 } }\n", "StaticConfig.A.box");
        row("many lines into one", "StaticConfig A { }\n", "StaticConfig.A", "Box b {\n    Size=2,2,2\n}",
            "StaticConfig A {\n  Box b {\n    Size=2,2,2\n  }\n}\n", "StaticConfig.A.b");
        row("CRLF", "StaticConfig A {\r\n\tBox a { Size=1,1,1 }\r\n}\r\n", "StaticConfig.A", "Box b {\n  Size=2,2,2\n}\n",
            "StaticConfig A {\r\n\tBox a { Size=1,1,1 }\r\n\tBox b {\r\n\t\tSize=2,2,2\r\n\t}\r\n}\r\n", "StaticConfig.A.b");
        row("a robot means its config", scene("Robot r { Config=Cart }\n"), "r", "Body b { Mass=1 Box x { Size=1,1,1 } }",
            std::string(kCart).insert(std::string(kCart).rfind('}'), "  Body b { Mass=1 Box x { Size=1,1,1 } }\n") +
                "Robot r { Config=Cart }\n",
            "r.b");
        row("beside what is selected", scene("Robot r { Config=Cart }\n"), "r.chassis.hull", "Box hull { Size=1,1,1 }",
            std::string(kCart).insert(std::string(kCart).find("  }\n  Body wheel"), "    Box hull2 { Size=1,1,1 }\n") +
                "Robot r { Config=Cart }\n",
            "r.chassis.hull2");
        row("things that name each other", scene(""), "RobotConfig.Cart",
            "Body wheel { Mass=1 Box x { Size=1,1,1 } }\nHinge axle { Parent=chassis Child=wheel }\nEncoder e { Joint=axle }",
            std::string(kCart).insert(std::string(kCart).rfind('}'),
                                      "  Body wheel2 { Mass=1 Box x { Size=1,1,1 } }\n  Hinge axle2 { Parent=chassis "
                                      "Child=wheel2 }\n  Encoder e { Joint=axle2 }\n"),
            "RobotConfig.Cart.wheel2");
        row("config and robot", scene(""), "",
            "RobotConfig Cart { Body b { Mass=1 Box x { Size=1,1,1 } } }\nRobot r { Config=Cart }\nPoseLog l { Robot=r }",
            scene("RobotConfig Cart2 { Body b { Mass=1 Box x { Size=1,1,1 } } }\nRobot r { Config=Cart2 }\nPoseLog l { Robot=r "
                  "}\n"),
            "RobotConfig.Cart2");
        row("top level from anywhere", scene("Robot r { Config=Cart }\n"), "r.chassis", "Surface ice { Friction=0 }",
            scene("Robot r { Config=Cart }\nSurface ice { Friction=0 }\n"), "Surface.ice");
        row("directives come along", "// head\nTick = 0.01\n", "", "#loadModule walker\nSurface ice { Friction=0 }",
            "// head\n#loadModule walker\nTick = 0.01\nSurface ice { Friction=0 }\n", "Surface.ice");
        row("controller", "#loadModule walker\n" + scene("Robot r { Config=Cart }\n"), "r.chassis", "Walker brain { }",
            "#loadModule walker\n" + scene("Robot r { Config=Cart Walker brain { } }\n"), "r.brain");
        row("of a module to be loaded", scene("Robot r { Config=Cart }\n"), "r", "#loadModule walker\nWalker brain { }",
            "#loadModule walker\n" + scene("Robot r { Config=Cart Walker brain { } }\n"), "r.brain");
    }
    void inserts() {
        QFETCH(QString, before);
        QFETCH(QString, parent);
        QFETCH(QString, text);
        QFETCH(QString, after);
        QFETCH(QString, selects);
        const auto loaded = m_fixture.open(before.toStdString());
        const auto plan = planInsert(*loaded, parent.toStdString(), text.toStdString());
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, plan)), after);
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(newErrors(*loaded, *again).empty(), sample::messages(*again).c_str());
        QCOMPARE(QString::fromStdString(plan.value().selects.at(0)), selects);
        for (const std::string& path : plan.value().selects) QVERIFY2(placeOf(*again, path), path.c_str());
    }

    void refused_data() {
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("why");
        QTest::newRow("geom at the top") << ""
                                         << "Box b { Size=1,1,1 }"
                                         << "a Box is allowed in a Body, a StaticConfig or a PartConfig, not at the top level";
        QTest::newRow("geom in a robot") << "r"
                                         << "Box b { Size=1,1,1 }"
                                         << "a Box is allowed in a Body, a StaticConfig or a PartConfig, not in Robot r";
        QTest::newRow("member") << "g_1"
                                << "Walker w { }"
                                << "a member of a Grid or Scatter has no text of its own; replace that by single robots first";
        QTest::newRow("nowhere") << "blob"
                                 << "Material m { }"
                                 << "there is no blob";
        QTest::newRow("empty") << ""
                               << " \n"
                               << "the text holds no block";
        QTest::newRow("not a block") << ""
                                     << "Tick = 0.1"
                                     << "only blocks can be added, not `Tick = 0.1`";
        QTest::newRow("Param") << "r.chassis"
                               << "Box b { Size=1,$(2*side),1 Mass=1 }"
                               << "Box b uses $side, which Body chassis does not have";
        QTest::newRow("material") << "r.chassis"
                                  << "Box b { Size=1,1,1 Material=red }"
                                  << "Box b uses Material red, which Body chassis does not have";
        QTest::newRow("body") << "r"
                              << "Hinge h { Parent=world Child=arm }"
                              << "Hinge h uses Child arm, which RobotConfig Cart does not have";
        QTest::newRow("config") << ""
                                << "Robot t { Config=Truck }"
                                << "Robot t uses Config Truck, which is not here";
        QTest::newRow("broken") << ""
                                << "Material m {\n ColorRGB= }"
                                << "line 2 of the text to be added: `ColorRGB` has no value";
    }
    void refused() {
        QFETCH(QString, parent);
        QFETCH(QString, text);
        QFETCH(QString, why);
        const auto loaded = m_fixture.open(
            "#loadModule walker\n" +
            scene(
                "Robot r { Config=Cart Walker brain { } }\nRobot s { Config=Cart }\nGrid g { Config=Cart Count=2 Spacing=1 }\n"));
        const auto plan = planInsert(*loaded, parent.toStdString(), text.toStdString());
        QVERIFY(!plan.ok());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }

    void imports_data() {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QStringList>("imports");
        QTest::addColumn<QString>("after");
        const QString cube = "Static a { Config=A }\n";
        QTest::newRow("into nothing") << "" << QStringList{"a.sim"} << "#import a.sim\n" + cube;
        QTest::newRow("behind the others") << "Tick=0.1\n#import b.sim // b\n\nMaterial m { }\n"
                                           << QStringList{"a.sim", "a.sim"}
                                           << "Tick=0.1\n#import b.sim // b\n#import a.sim\n\nMaterial m { }\n" + cube;
        QTest::newRow("there already") << "#import a.sim\n" << QStringList{"a.sim"} << "#import a.sim\n" + cube;
        QTest::newRow("itself") << "#import a.sim\n" << QStringList{"main.sim", "./main.sim"} << "#import a.sim\n" + cube;
        QTest::newRow("a name that only ends alike") << "#import aa.sim\n"
                                                     << QStringList{"a.sim"} << "#import aa.sim\n#import a.sim\n" + cube;
        QTest::newRow("there by another") << "#import via.sim\n" << QStringList{"a.sim"} << "#import via.sim\n" + cube;
        QTest::newRow("written otherwise") << "#import .\\a.sim\n" << QStringList{"a.sim"} << "#import .\\a.sim\n" + cube;
        QTest::newRow("the last line") << "#import b.sim" << QStringList{"a.sim"} << "#import b.sim\n#import a.sim\n" + cube;
        QTest::newRow("before the modules") << "// head\n#loadModule walker\r\n"
                                            << QStringList{"a.sim"} << "// head\n#import a.sim\n#loadModule walker\r\n" + cube;
        QTest::newRow("module and file") << "#import b.sim\n"
                                         << QStringList{"#loadModule walker", "a.sim"}
                                         << "#import b.sim\n#import a.sim\n#loadModule walker\n" + cube;
        QTest::newRow("below a comment of lines") << "/* a\n b */ Material m { }\n"
                                                  << QStringList{"a.sim"} << "#import a.sim\n/* a\n b */ Material m { }\n" + cube;
        QTest::newRow("after the mark of the bytes")
            << QString("\uFEFFTick=0.1\n") << QStringList{"a.sim"} << QString("\uFEFF#import a.sim\nTick=0.1\n") + cube;
    }
    void imports() {
        QFETCH(QString, before);
        QFETCH(QStringList, imports);
        QFETCH(QString, after);
        const auto loaded =
            m_fixture.open(std::map<std::string, std::string>{{"main.sim", before.toStdString()},
                                                              {"a.sim", "StaticConfig A { Box b { Size=1,1,1 } }\n"},
                                                              {"aa.sim", "\n"},
                                                              {"b.sim", "\n"},
                                                              {"via.sim", "#import a.sim\n"}});
        std::vector<std::string> names;
        for (const QString& name : imports) names.push_back(name.toStdString());
        const auto plan = planInsert(*loaded, "", "Static a { Config=A }", names);
        QCOMPARE(QString::fromStdString(m_fixture.text(loaded, plan)), after);
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
    }

    void aFileOfTheProjectIsNeverNamedByItsWholePath() {
        // A file of the same name beside the importing file would be found first.
        for (const char* name : {"configs/trials/robots/a.sim", "configs/robots/a.sim"}) {
            std::filesystem::create_directories(std::filesystem::path(m_fixture.path(name)).parent_path());
            std::ofstream(m_fixture.path(name)) << "StaticConfig A { Box b { Size=1,1,1 } }\n";
        }
        const auto loaded =
            m_fixture.open(std::map<std::string, std::string>{{"configs/trials/main.sim", ""}}, "configs/trials/main.sim");
        const auto plan = planInsert(*loaded, "", "Static a { Config=A }", {m_fixture.path("configs/robots/a.sim")});
        QCOMPARE(m_fixture.text(loaded, plan, "configs/trials/main.sim"), "#import ../robots/a.sim\nStatic a { Config=A }\n");
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(!again->diagnostics.hasErrors(), sample::messages(*again).c_str());
    }

    void noPathForALine() {
        const auto loaded = m_fixture.open("");
        for (const char* path : {"a\nb", "", "  ", "a\"b"}) QVERIFY(!planInsert(*loaded, "", "Material m { }", {path}).ok());
        QCOMPARE(m_fixture.text(loaded, planInsert(*loaded, "", "Material m { }", {"my files/a//b.sim"})),
                 "#import \"my files/a//b.sim\"\nMaterial m { }\n");
    }

    void everyKindHasATemplate_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("fixture");
        m_fixture.catalog.plugin = {kindOf<Odd>("Odd", Role::Device, {"RobotConfig"}),
                                    kindOf<OddBrain>("OddBrain", Role::Controller, {"Robot", "Grid", "Scatter"})};
        const auto loaded = m_fixture.open("#loadModule plugin\n#loadModule walker\n");
        for (const Kind* kind : loaded->registry->all()) {
            if (kind->role == Role::Settings) continue;
            const bool top = kind->role == Role::Log || std::count(kind->parents.begin(), kind->parents.end(), "") > 0;
            for (const char* fixture : {"empty", "bare", "sample"})
                if (top || fixture != std::string("empty"))
                    QTest::newRow((kind->name + " " + fixture).c_str()) << QString::fromStdString(kind->name) << fixture;
        }
    }
    void everyKindHasATemplate() {
        QFETCH(QString, kind);
        QFETCH(QString, fixture);
        const std::string modules = "#loadModule plugin\n#loadModule walker\n";
        const std::string bare =
            modules + "RobotConfig C { Body b { Mass=1 Box x { Size=1,1,1 } } }\nStaticConfig S { }\nRobot r { Config=C }\nGrid "
                      "g { Config=C Count=2 Spacing=9 Pos=50,0,0 }\nStatic s { Config=S }\n";
        const std::string text = fixture == "empty"  ? modules
                                 : fixture == "bare" ? bare
                                                     : modules + "#import experiments/linear_motion.sim\n";
        m_fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs";
        const auto loaded = m_fixture.open(text);
        const Kind* described = loaded->registry->find(kind.toStdString());
        QVERIFY(described);
        const auto allowedPlaces = [&](const char* place) {
            return std::count(described->parents.begin(), described->parents.end(), place) > 0;
        };
        const std::string robot = fixture == "sample" ? "robot0" : "r";
        std::string parent;
        const bool controller = described->role == Role::Controller;
        if (described->role == Role::Device || described->role == Role::Joint || described->role == Role::Body ||
            described->role == Role::Repeat || kind == "Part")
            parent = fixture == "empty" ? std::string() : robot; // a joint at the top level
        if (controller) parent = robot;
        if (described->role == Role::Geom)
            parent = allowedPlaces("Body") ? robot + (fixture == "sample" ? ".chassis" : ".b")
                     : fixture == "sample" ? "arena"
                                           : "s";
        const std::string block = templateOf(*loaded, *described, parent);
        auto before = loaded;
        if (controller && fixture == "sample") before = m_fixture.apply(loaded, planRemove(*loaded, {"robot0.brain"}));
        const auto plan = planInsert(*before, parent, block);
        QVERIFY2(plan.ok(), (block + (plan.ok() ? "" : plan.error().message)).c_str());
        const auto again = m_fixture.apply(before, plan);
        QVERIFY2(newErrors(*before, *again).empty(), (block + "\n" + sample::messages(*again)).c_str());
        const auto place = placeOf(*again, plan.value().selects.back());
        QVERIFY2(place && place->part && place->part->kind->name == kind.toStdString(), block.c_str());
        // A second one beside the first.
        if (described->role == Role::Medium) {
            QVERIFY(!planInsert(*again, parent, templateOf(*again, *described, parent)).ok());
            return;
        }
        const auto second = planInsert(*again, parent, templateOf(*again, *described, parent));
        QVERIFY2(second.ok(), second.ok() ? "" : second.error().message.c_str());
        const auto twice = m_fixture.apply(again, second);
        QVERIFY2(newErrors(*before, *twice).empty(), sample::messages(*twice).c_str());
    }

    void templatesOfTheSample() {
        const auto loaded = m_fixture.open("Material red { }\nStaticConfig A { }\n" + scene("Robot r { Config=Cart }\n"));
        const auto text = [&](const char* kind, const char* parent) {
            return templateOf(*loaded, *loaded->registry->find(kind), parent);
        };
        QCOMPARE(text("Sphere", "r.chassis"), "Sphere sphere { Radius=0.1 Pos=0,0,0.6 Material=red Mass=0.1 }");
        QCOMPARE(text("Box", "StaticConfig.A"), "Box box { Size=0.1,0.1,0.1 Pos=0,0,0.05 Material=red }");
        QCOMPARE(text("Robot", ""), "Robot robot0 { Config=Cart Pos=0,0,0 }");
        QCOMPARE(text("Static", ""), "Static static { Config=A Pos=0,0,0 }");
        QCOMPARE(text("Encoder", "r"), "Encoder encoder { Joint=axle }");
        QCOMPARE(text("RotaryMotor", "r"),
                 "RotaryMotor rotaryMotor { Joint=axle TorqueConstant=0.05 Resistance=1 MaxVoltage=12 BackEmfConstant=0.05 }");
        QCOMPARE(text("settings", ""), "");
    }

    /// What is in Parts, members of Repeats and the base of a variant can be named as what is in the config itself.
    void templatesFindWhatPartsHold_data() {
        QTest::addColumn<QString>("config");
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("text");
        const std::string wheel =
            "PartConfig LeftWheel {\n  Body body { HPR=10,0,0 Cylinder tyre { Radius=0.07 Length=0.02 HPR=0,0,90 Mass=1 } }\n"
            "  Hinge axle { Parent=$carrier Child=body Axis=0,1,0 }\n"
            "  RotaryMotor leftMotor { Joint=axle TorqueConstant=1 Resistance=1 MaxVoltage=12 BackEmfConstant=1 }\n}\n";
        const std::string chassis = "  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=1 } }\n";
        const std::string parts = "  Part leftWheel { Config=LeftWheel carrier=chassis Pos=0,0.14,0.07 }\n"
                                  "  Part rightWheel { Config=LeftWheel carrier=chassis Pos=0,-0.16,0.07 Mirror=y }\n";
        const std::string kit = "RobotConfig Kit {\n" + parts + chassis + "}\n";
        const auto row = [](const char* what, const std::string& config, const char* kind, const char* parent, const char* text) {
            QTest::newRow(what) << QString::fromStdString(config) << kind << parent << text;
        };
        const char* const base =
            "DifferentialDrive base { LeftMotor=leftWheel.leftMotor RightMotor=rightWheel.leftMotor WheelRadius=0.07 "
            "WheelSeparation=0.3 }";
        row("Parts", wheel + kit + "Robot r { Config=Kit }\n", "DifferentialDrive", "r", base);
        row("no instance", wheel + kit, "DifferentialDrive", "RobotConfig.Kit", base);
        row("selected Part", wheel + kit, "DifferentialDrive", "RobotConfig.Kit.leftWheel", base);
        row("wheels set by the robot's config",
            wheel + "RobotConfig Kit {\n" + chassis + parts +
                "}\nRobotConfig Big { Config=Kit leftWheel.body.tyre.Radius=0.09 }\n",
            "DifferentialDrive", "RobotConfig.Big",
            "DifferentialDrive base { LeftMotor=leftWheel.leftMotor RightMotor=rightWheel.leftMotor WheelRadius=0.09 "
            "WheelSeparation=0.3 }");
        const std::string nested =
            wheel +
            "PartConfig Axle {\n  Part a { Config=LeftWheel carrier=$to Pos=0,-0.1,0 }\n  Part b { Config=LeftWheel "
            "carrier=$to Pos=0,0.1,0 Mirror=y }\n}\nRobotConfig Kit {\n" +
            chassis + "  Part axle { Config=Axle to=chassis HPR=180,0,0 Pos=0,1,0 }\n}\n";
        row("nested, by the side of the wheel", nested, "DifferentialDrive", "RobotConfig.Kit",
            "DifferentialDrive base { LeftMotor=axle.a.leftMotor RightMotor=axle.b.leftMotor WheelRadius=0.07 "
            "WheelSeparation=0.2 "
            "}");
        const std::string repeat =
            "RobotConfig Kit {\n" + chassis +
            "  Repeat wheel { Count=2 Pos=0,$(0.1 - 0.25*index),0\n    Body b { Sphere s { Radius=0.05 Mass=1 } }\n    Hinge h { "
            "Parent=chassis Child=b Axis=0,1,0 }\n    RotaryMotor m { Joint=h TorqueConstant=1 Resistance=1 MaxVoltage=12 "
            "BackEmfConstant=1 }\n  }\n}\n";
        row("members", repeat, "DifferentialDrive", "RobotConfig.Kit",
            "DifferentialDrive base { LeftMotor=wheel_0.m RightMotor=wheel_1.m WheelRadius=0.05 WheelSeparation=0.25 }");
        row("several motors of a side", repeat, "SkidDrive", "RobotConfig.Kit",
            "SkidDrive skidDrive { LeftMotors=wheel_0.m RightMotors=wheel_1.m WheelRadius=0.05 WheelSeparation=0.25 }");
        row("in a member", repeat, "Encoder", "RobotConfig.Kit.wheel", "Encoder encoder { Joint=h }");
        row("around a member", repeat, "Transceiver", "RobotConfig.Kit.wheel", "Transceiver transceiver { Body=b }");
        row("joint of a member", repeat, "Encoder", "RobotConfig.Kit", "Encoder encoder { Joint=wheel_0.h }");
        const std::string counted =
            repeat.substr(0, repeat.size() - 2) + "  Encoder one { Joint=wheel_0.h }\n}\nRobotConfig More { Config=Kit }\n";
        row("the next free joint, of a variant's base", counted, "Encoder", "RobotConfig.More",
            "Encoder encoder { Joint=wheel_1.h }");
        const std::string touch = wheel + "RobotConfig Kit {\n" + chassis + parts + "  TouchSensor t { Geom=chassis.hull }\n}\n";
        row("touch sensor", touch, "TouchSensor", "RobotConfig.Kit", "TouchSensor touchSensor { Geom=leftWheel.body.tyre }");
        row("body of the config first", wheel + kit, "Transceiver", "RobotConfig.Kit",
            "Transceiver transceiver { Body=chassis }");
        row("a free body of a Part",
            "PartConfig Arm { Body link { Box b { Size=1,1,1 Mass=1 } } }\nRobotConfig Kit {\n" + chassis +
                "  Part arm { Config=Arm }\n}\n",
            "Hinge", "RobotConfig.Kit", "Hinge hinge { Parent=chassis Child=arm.link }");
    }
    void templatesFindWhatPartsHold() {
        QFETCH(QString, config);
        QFETCH(QString, kind);
        QFETCH(QString, parent);
        QFETCH(QString, text);
        const auto loaded = m_fixture.open(config.toStdString());
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        const std::string block = templateOf(*loaded, *loaded->registry->find(kind.toStdString()), parent.toStdString());
        QCOMPARE(QString::fromStdString(block), text);
        const auto plan = planInsert(*loaded, parent.toStdString(), block);
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        const auto again = m_fixture.apply(loaded, plan);
        QVERIFY2(newErrors(*loaded, *again).empty(), sample::messages(*again).c_str());
    }

    /// Motors that a robot lacks come with wheels of their own.
    void drivesDoNotPinTheRobot() {
        const std::string motor =
            "  RotaryMotor m { Joint=axle TorqueConstant=1 Resistance=1 MaxVoltage=12 BackEmfConstant=1 }\n}\n";
        const std::string driven = std::string(kCart, std::string(kCart).rfind('}')) + motor;
        const std::string one = "RobotConfig Cart {\n  Body chassis { Box hull { Size=1,1,1 Mass=1 } }\n}\n";
        const std::string loose = "RobotConfig Cart { Body b { Mass=1 Box x { Size=1,1,1 } } }\n";
        for (const std::string& config : {driven, one, loose}) {
            const auto loaded = m_fixture.open(config + "Robot r { Config=Cart }\n");
            const std::string block = templateOf(*loaded, *loaded->registry->find("DifferentialDrive"), "r");
            QVERIFY2(block.find("world") == std::string::npos, block.c_str());
            const auto again = m_fixture.apply(loaded, planInsert(*loaded, "r", block));
            QVERIFY2(again && newErrors(*loaded, *again).empty(), block.c_str());
            const auto& joints = again->experiment->robots.at(0).config->joints;
            QCOMPARE(joints.size(), std::size_t{2});
            for (const JointSpec& joint : joints) QVERIFY2(joint.parent >= 0, block.c_str());
            QVERIFY2(joints[0].child != joints[1].child, block.c_str());
        }
    }

    void copiesComments() {
        sample::PlanFixture fixture;
        const auto loaded = fixture.open("Tick = 0.01\n");
        const std::string pasted = "// mine\r\nMaterial red { } // hot\n\n/* cold */ Material blue { }\n// the end\n";
        QCOMPARE(fixture.text(loaded, planInsert(*loaded, "", pasted)),
                 "Tick = 0.01\n// mine\nMaterial red { } // hot\n/* cold */ Material blue { }\n// the end\n");
        const auto cut = fixture.open("Material red { } // hot\nMaterial blue { } // cold\n");
        QCOMPARE(fixture.text(cut, planRemove(*cut, {"Material.red"})), "Material blue { } // cold\n");
        QCOMPARE(textOf(*cut, {"Material.red"}), "Material red { } // hot\n");
    }

private:
    PlanFixture m_fixture;
};

QTEST_APPLESS_MAIN(PlansInsertTest)
#include "plans_insert_test.moc"
