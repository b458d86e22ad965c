// Make Part, Mirror and Repeat with what is around the blocks: Params that are words, comments, what stands at the other side already.
#include <QTest>

#include "lang/formatter.h"
#include "plan_fixture.h"
#include "project/edits/mirrored_text.h"
#include "project/edits/plan_wrap.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kHead = R"(Material red { ColorRGB=1,0,0 }
Material black { ColorRGB=0,0,0 }
Surface floor { Friction=1 }

)";
const std::string kWheelPart = R"(PartConfig Wheel {
  Param r = 0.05
  Param colour = black { Choices=black,red }
  Body wheel {
    Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 Material=$colour Surface=floor }
    Box lug { Size=0.02,0.02,0.02 Pos=0.03,0,0 Mass=0.01 Material=red Surface=floor }
  }
  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
}

)";
const std::string kParts = R"(RobotConfig Kit {
  Body chassis { Pos=0,0,0.09 Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }
  Body camera { In=chassis Pos=0.1,0,0.1 Box b { Size=0.02,0.02,0.02 Mass=0.1 Material=red Surface=floor } }
  Body arm { Box b { Size=0.1,0.02,0.02 Pos=0,0.1,0.2 Mass=0.1 Material=red Surface=floor } }
  Body hook { Box b { Size=0.1,0.02,0.02 Pos=0,0,0.4 Mass=0.1 Material=red Surface=floor } Box tip { Size=0.02,0.1,0.02 Pos=0,0.06,0.4 Mass=0.1 Material=red Surface=floor } }
  Body ear { Pos=0,0.05,0.2 Box b { Size=0.1,0.02,0.02 Mass=0.1 Material=red Surface=floor } }
  Body otherEar { Pos=0,-0.05,0.2 Box b { Size=0.1,0.02,0.02 Mass=0.1 Material=red Surface=floor } }
  Fixed foot { Parent=chassis Child=camera }
  Part left { Config=Wheel Pos=0.06,0.125,0.05 carrier=chassis }
  Part right { Config=Wheel Pos=0.06,-0.125,0.05 Mirror=y carrier=chassis }
  Part rear { Config=Wheel Pos=-0.1,0.125,0.05 carrier=chassis }
  Repeat mast {
    Count=3 Pos=$(0.05*index - 0.1),0,0.15
    Part pole { Config=Wheel Pos=0,0.2,0 carrier=chassis }
  }
  Repeat row { Count=2 Pos=$(0.05*index),0,0.3 Body b { Box b { Size=0.01,0.01,0.1 Mass=0.02 Material=red Surface=floor } } }
  DifferentialDrive base { LeftMotor=left.motor RightMotor=right.motor WheelRadius=0.05 WheelSeparation=0.25 }
}
Robot rover { Config=Kit }
)";

} // namespace

class PlansMirrorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The word of a side is exchanged where it begins a word, not inside of another one.
    void namesOfTheOtherSide_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("mirrored");
        const auto row = [](const char* name, const char* mirrored) { QTest::newRow(name) << name << mirrored; };
        row("left", "right");
        row("rightMotor", "leftMotor");
        row("wheelLeft", "wheelRight");
        row("front_left", "front_right");
        row("wheel2left", "wheel2right");
        row("rear", "front");
        row("upperArm", "lowerArm");
        for (const char* none : {"brightLamp", "upright", "flower", "cleft", "storefront", "wheel", ""}) row(none, none);
    }
    void namesOfTheOtherSide() {
        QFETCH(QString, name);
        QFETCH(QString, mirrored);
        QCOMPARE(QString::fromStdString(mirroredName(name.toStdString())), mirrored);
        QCOMPARE(QString::fromStdString(mirroredName(mirrored.toStdString())), name);
    }

    /// A Param that is a word goes along as one that is a number; one that names a body outside is given by the Part alone.
    void takesWordParams() {
        open("RobotConfig Kit {\n  Param colour = black { Choices=black,red }\n  Param grip = floor\n  Param frame = chassis\n"
             "  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } }\n"
             "  Body leftWheel { Pos=0,0.1,0 Sphere tyre { Radius=0.05 Mass=0.15 Material=$colour Surface=$grip } }\n"
             "  Hinge leftAxle { Parent=$frame Child=leftWheel Axis=0,1,0 }\n}\nRobot a { Config=Kit }\n");
        const std::vector<std::string> paths{"RobotConfig.Kit.leftWheel", "RobotConfig.Kit.leftAxle"};
        for (const auto& plan : {planMakePart(*m_loaded, paths), planMirror(*m_loaded, paths, 'y')}) {
            checkClean(plan);
            const QString text = QString::fromStdString(m_fixture.text(m_loaded, plan));
            for (const char* line :
                 {"PartConfig Left {\n  Param colour = black { Choices=black,red }\n  Param grip = floor\n  Body ",
                  "  Part left { Config=Left Pos=0,0.1,0 colour=$colour grip=$grip frame=$frame }\n"})
                QVERIFY2(text.contains(QLatin1String(line)), qPrintable(text));
        }
    }

    /// In a PartConfig too: of a Part of a robot the wheel alone becomes a part.
    void takesWordParamsOfAPart() {
        open(kWheelPart + kParts);
        const auto plan = planMakePart(*m_loaded, {"rover.left.wheel"});
        checkClean(plan);
        const QString text = QString::fromStdString(m_fixture.text(m_loaded, plan));
        QVERIFY2(text.contains("  Part wheel { Config=Wheel2 r=$r colour=$colour }\n"), qPrintable(text));
    }

    /// What the names of Params would be taken for misspelt ones of each other is declared.
    void takesNamesThatAreAlike() {
        open(kWheelPart + kParts);
        checkClean(planMakePart(*m_loaded, {"RobotConfig.Kit.base"}));
    }

    void movesComments_data() {
        QTest::addColumn<QString>("kind");
        QTest::newRow("part") << "PartConfig Left {\n";
        QTest::newRow("repeat") << "  Repeat left {\n    Count=2 Pos=$(0.1*index),0,0\n";
    }
    /// A comment above a block or behind it goes along; one with a blank line between stays.
    void movesComments() {
        QFETCH(QString, kind);
        const std::string blocks = R"(  // The left wheel
  //   that is driven
  Body leftWheel { Pos=0.06,0.125,0.05 // where it stands
    Sphere tyre { Radius=0.05 Mass=0.15 Material=black Surface=floor }
  }
  // its axle
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 } // turns
  /* its motor:
     12 V */
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
)";
        open("RobotConfig Kit { // of a kit\n"
             "  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=floor } } // stays\n" +
             blocks + "  // also stays\n\n  Imu imu { Body=chassis } // and this\n}\nRobot a { Config=Kit }\n");
        const std::vector<std::string> paths{"RobotConfig.Kit.leftWheel", "RobotConfig.Kit.leftAxle",
                                             "RobotConfig.Kit.leftMotor"};
        const bool isPart = kind.startsWith("Part");
        const auto plan = isPart ? planMakePart(*m_loaded, paths) : planRepeat(*m_loaded, paths, 2, {0.1, 0, 0});
        checkClean(plan);
        const std::string text = m_fixture.text(m_loaded, plan);
        std::string wanted = blocks;
        if (isPart) {
            wanted.replace(wanted.find(" Pos=0.06,0.125,0.05"), 20, "");
            wanted.replace(wanted.find("Parent=chassis"), 14, "Parent=$chassis");
            for (const auto& [name, inPart] : {std::pair("leftWheel", "wheel"), {"leftAxle", "axle"}, {"leftMotor", "motor"}})
                for (std::size_t at; (at = wanted.find(name)) != std::string::npos;)
                    wanted.replace(at, std::string_view(name).size(), inPart);
        } else {
            wanted = "  ";
            for (const char c : blocks.substr(0, blocks.size() - 1)) wanted += c == '\n' ? "\n  " : std::string(1, c);
            wanted += "\n";
        }
        QVERIFY2(text.find(kind.toStdString() + wanted) != std::string::npos, text.c_str());
        const std::string rest = isPart ? "  Part left { Config=Left Pos=0.06,0.125,0.05 chassis=chassis }\n" : "  }\n";
        const std::string after = rest + "  // also stays\n\n  Imu imu { Body=chassis } // and this\n}\n";
        QVERIFY2(text.find(after) != std::string::npos, text.c_str());
        QVERIFY2(text.find("Kit { // of a kit\n  Body chassis") != std::string::npos, text.c_str());
    }

    void refusesWhatIsThere_data() {
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QString>("why"); // empty: it is mirrored
        const auto row = [](const char* what, const QStringList& paths, const char* why) { QTest::newRow(what) << paths << why; };
        const char* const right = "left's mirror image is there already: right";
        row("Part with its mirror image", {"RobotConfig.Kit.left"}, right);
        row("through a robot", {"rover.left"}, right);
        row("the image", {"RobotConfig.Kit.right"}, "right's mirror image is there already: left");
        row("both", {"RobotConfig.Kit.left", "RobotConfig.Kit.right"}, right);
        row("Part without one", {"RobotConfig.Kit.rear"}, "");
        row("body with its mirror image", {"RobotConfig.Kit.ear"}, "ear's mirror image is there already: otherEar");
        row("body with all its shapes at one side", {"RobotConfig.Kit.arm"}, "");
        row("body with a shape on the plane and one beside it", {"RobotConfig.Kit.hook"}, "");
        row("chassis", {"RobotConfig.Kit.chassis"}, "chassis lies on the mirror plane and would be its own mirror image");
        row("body on the centre line of another", {"RobotConfig.Kit.camera", "RobotConfig.Kit.foot"},
            "camera lies on the mirror plane and would be its own mirror image");
        row("body in a Part", {"rover.left.wheel"}, "wheel lies on the mirror plane and would be its own mirror image");
        row("body in a Part in a Repeat", {"rover.mast_1.pole.wheel"},
            "wheel lies on the mirror plane and would be its own mirror image");
        row("a Repeat on the centre line", {"RobotConfig.Kit.row"},
            "row lies on the mirror plane and would be its own mirror image");
        row("a Repeat beside it", {"RobotConfig.Kit.mast"}, "");
        row("a drive alone", {"RobotConfig.Kit.base"},
            "DifferentialDrive base has no pose, so its mirror image would be the same; select what it belongs to along with it");
        row("a motor alone", {"rover.left.motor"},
            "RotaryMotor motor has no pose, so its mirror image would be the same; select what it belongs to along with it");
    }
    void refusesWhatIsThere() {
        QFETCH(QStringList, paths);
        QFETCH(QString, why);
        open(kWheelPart + kParts);
        std::vector<std::string> all;
        for (const QString& path : paths) all.push_back(path.toStdString());
        const auto plan = planMirror(*m_loaded, all, 'y');
        if (why.isEmpty()) return checkClean(plan);
        QVERIFY2(!plan.ok(), m_fixture.text(m_loaded, plan).c_str());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }
    void refusesWhatIsThereInAPart_data() {
        QTest::addColumn<QString>("users");
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("why");
        const QString left = QStringLiteral("left's mirror image is there already: right");
        const QString robot = "RobotConfig Kit {\n  Body chassis { Pos=0,0,0.09 Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red "
                              "Surface=floor } }\n  Part front { Config=Axle Pos=0.2,0.1,0 HPR=20,0,0 frame=chassis }\n}\n"
                              "Robot rover { Config=Kit }\n";
        const QString repeat = QString(robot)
                                   .replace("  Part front { Config=Axle", "  Repeat row { Count=2 Part front { Config=Axle")
                                   .replace("frame=chassis }", "frame=chassis } }");
        QTest::newRow("through a robot") << robot << "rover.front.left" << left;
        QTest::newRow("in the PartConfig") << robot << "PartConfig.Axle.left" << left;
        QTest::newRow("in the PartConfig, without its image") << robot << "PartConfig.Axle.rear"
                                                              << "";
        QTest::newRow("of a Repeat") << repeat << "PartConfig.Axle.left" << left;
        QTest::newRow("without a robot") << ""
                                         << "PartConfig.Axle.left" << left;
        QTest::newRow("without a robot, the image") << ""
                                                    << "PartConfig.Axle.right"
                                                    << "right's mirror image is there already: left";
        QTest::newRow("without a robot and image") << ""
                                                   << "PartConfig.Axle.rear"
                                                   << "";
        QTest::newRow("the same at the other side, not mirrored") << ""
                                                                  << "PartConfig.Axle.post"
                                                                  << "";
        QTest::newRow("in a Part of a PartConfig") << "PartConfig Pair { Part axle { Config=Axle frame=$frame } }\n"
                                                   << "PartConfig.Pair.axle.left" << left;
    }
    void refusesWhatIsThereInAPart() {
        QFETCH(QString, users);
        QFETCH(QString, path);
        QFETCH(QString, why);
        open(kWheelPart +
             "PartConfig Axle {\n  Part left { Config=Wheel Pos=0.06,0.125,0.05 HPR=10,0,20 carrier=$frame }\n"
             "  Part right { Config=Wheel Pos=0.06,-0.125,0.05 HPR=-10,0,-20 Mirror=y carrier=$frame }\n"
             "  Part rear { Config=Wheel Pos=-0.1,0.125,0.05 carrier=$frame }\n"
             "  Part post { Config=Wheel Pos=-0.3,0.125,0.05 HPR=30,0,0 carrier=$frame }\n"
             "  Part otherPost { Config=Wheel Pos=-0.3,-0.125,0.05 HPR=30,0,0 Mirror=y carrier=$frame }\n}\n" +
             users.toStdString());
        const auto plan = planMirror(*m_loaded, {path.toStdString()}, 'y');
        if (why.isEmpty()) return checkClean(plan);
        QVERIFY2(!plan.ok(), m_fixture.text(m_loaded, plan).c_str());
        QCOMPARE(QString::fromStdString(plan.error().message), why);
    }
    /// Along another axis there is nothing yet.
    void mirrorsAlongAnotherAxis() {
        open(kWheelPart + kParts);
        checkClean(planMirror(*m_loaded, {"RobotConfig.Kit.left"}, 'x'));
    }

private:
    void open(const std::string& text) {
        m_loaded = m_fixture.open(kHead + text);
        QVERIFY2(!m_loaded->diagnostics.hasErrors(), sample::messages(*m_loaded).c_str());
    }
    /// The text after a plan has no errors, and formatting it changes nothing.
    void checkClean(const Result<EditPlan>& plan) {
        QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().message.c_str());
        const auto after = m_fixture.apply(m_loaded, plan);
        QVERIFY2(!after->diagnostics.hasErrors(), sample::rendered(*after).c_str());
        const Tree& tree = *after->trees[0];
        QCOMPARE(format(tree), std::string(tree.source().bytes()));
    }

    PlanFixture m_fixture;
    std::shared_ptr<const LoadedProject> m_loaded;
};

QTEST_APPLESS_MAIN(PlansMirrorTest)
#include "plans_mirror_test.moc"
