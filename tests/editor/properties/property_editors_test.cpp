// The editors of property rows: vectors, choices, colours, references and overrides.
#include "eventually.h"
#include "properties_fixture.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QCompleter>
#include <QFileDialog>
#include <QToolButton>

#include "editor/properties/param_help.h"
#include "editor/properties/property_row.h"
#include "editor/properties/rows.h"

using namespace trundle;

namespace {

const std::string kRobots = R"(
Tick = 0.01
Robot robot0 { Config=Rover  Pos=0, 0, 0.5  leftMotor.Resistance=3 }
Robot robot1 { Config=Rover  Pos=1,2,0 }
PoseLog path { Robot=robot0 Interval=0.1 File=path.csv }
)";

} // namespace

class PropertyEditorsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void aParamIsExplainedByItsComment() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        const auto tip = [&fixture](const char* id) {
            return fixture.row(id)->findChild<QLabel*>(QStringLiteral("label"))->toolTip();
        };
        for (const char* path : {"robot0", "RobotConfig.Rover"}) { // at the instance and at the config
            fixture.selection.select(path);
            QVERIFY2(tip("param.wheelRadius").endsWith(QStringLiteral("\nof both")), qPrintable(tip("param.wheelRadius")));
            QCOMPARE(tip("param.track"), QStringLiteral("track"));
        }
        const auto loaded = fixture.document.loaded();
        QCOMPARE(paramHelp(*loaded, "robot0.wheelRadius"), QStringLiteral("of both"));
        QCOMPARE(paramHelp(*loaded, "robot0.nothing"), QString());
        std::string rover = fixture.rover();
        rover.replace(rover.find("  Param track"), 0, "  // Between the wheels,\n  // in metres.\n");
        QVERIFY(fixture.document.edits().replaceText(QStringLiteral("Type"), fixture.document.texts().files()[1], rover).ok());
        QCOMPARE(paramHelp(*fixture.document.loaded(), "RobotConfig.Rover.track"),
                 QStringLiteral("Between the wheels, in metres."));
    }

    /// Reached through a robot, also one with a Part in a Part.
    void aParamOfAPartHasTheHelpOfItsConfig() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(
            "PartConfig Wheel { Param r = 0.1 { Help=\"of the tyre\" } Body wheel { Sphere s { Radius=$r Mass=1 } } }\n"
            "PartConfig Side {\n  Param len = 0.3 { Help=\"distance of the axles\" }\n"
            "  Body rail { Box b { Size=$len,0.1,0.1 Mass=1 } }\n  Part front { Config=Wheel }\n}\n"
            "RobotConfig Kit { Part left { Config=Side } }\nRobot rover { Config=Kit Pos=0,0,1 }\n"));
        const auto loaded = fixture.document.loaded();
        QCOMPARE(paramHelp(*loaded, "rover.left.len"), QStringLiteral("distance of the axles"));
        QCOMPARE(paramHelp(*loaded, "rover.left.front.r"), QStringLiteral("of the tyre"));
        QCOMPARE(paramHelp(*loaded, "RobotConfig.Kit.left.len"), QStringLiteral("distance of the axles"));
        QCOMPARE(paramHelp(*loaded, "RobotConfig.Kit.left.front.r"), QStringLiteral("of the tyre"));
        QCOMPARE(paramHelp(*loaded, "rover.left.rail.len"), QString());
    }

    void aDescribedParamHasItsHelpLimitsAndChoices() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("RobotConfig Kit {\n  Param r = 5 cm { Min=2 cm Max=20 cm Help=\"of the ball\" }\n"
                             "  Param mass = 1 { Choices=1,2,4 }  // kg\n"
                             "  Body b { Sphere s { Radius=$r Mass=$mass Material=red Surface=rubber } }\n}\n"
                             "Robot kit { Config=Kit Pos=0,0,1 }\nRobot other { Config=Kit Pos=1,0,1 }\n"));
        fixture.selection.select("kit");
        QCOMPARE(fixture.row("param.r")->findChild<QLabel*>(QStringLiteral("label"))->toolTip(),
                 QStringLiteral("r – from 2 to 20 cm\nof the ball"));
        fixture.type("param.r", QStringLiteral("0.1"));
        QVERIFY2(fixture.text().find("Robot kit { Config=Kit Pos=0,0,1 r=0.1 }") != std::string::npos, fixture.text().c_str());
        fixture.type("param.r", QStringLiteral("50 cm"));
        QVERIFY(fixture.field("param.r")->refused());
        auto* mass = fixture.field<QComboBox>("param.mass");
        QVERIFY(mass);
        QCOMPARE(mass->count(), 3);
        mass->setFocus();
        QTest::keyClick(mass, Qt::Key_Down);
        QVERIFY2(fixture.text().find("r=0.1 mass=2 }") != std::string::npos, fixture.text().c_str());
        fixture.selection.select("RobotConfig.Kit");
        QVERIFY(fixture.field<QComboBox>("param.mass"));
    }

    /// A row holds its value several times, so a long one is left out: it can be reset, and is edited in the text.
    void aLongValueIsLeftOutOfItsRow() {
        for (const std::size_t bytes : {std::size_t(kMaxShownValue), std::size_t(kMaxShownValue) + 1}) {
            const bool isLong = bytes > kMaxShownValue;
            PropertiesFixture fixture;
            QVERIFY(fixture.open("Param a = $(1" + std::string(bytes - 7, ' ') + "+ 1)\nRobot robot0 { Config=Rover }\n"));
            fixture.selection.select("");
            auto* field = fixture.row("param.a")->findChild<ValueField*>(QStringLiteral("field"));
            QVERIFY(field);
            QCOMPARE(field->isReadOnly(), isLong);
            QCOMPARE(field->text().isEmpty(), isLong);
            QCOMPARE(field->placeholderText().contains(QStringLiteral("edit it in the text")), isLong);
            const Row row = dynamic_cast<PropertyRow&>(*fixture.row("param.a")).row();
            QCOMPARE(row.first().text.size(), isLong ? 0u : bytes);
            const std::string before = fixture.text();
            QCOMPARE(row.set([](const FieldValue&) { return std::string("3"); }, {}).ok(), !isLong);
            QCOMPARE(fixture.text() == before, isLong);
        }
    }

    /// Objects of different configs share a row; its heading names none of the two.
    void sharedRowsHaveACommonHeading() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(
            "RobotConfig Cart {\n  Param track = 0.3\n  Body b { Box hull { Size=0.1,0.1,$track Mass=1 } }\n}\n"
            "Robot robot0 { Config=Rover }\nRobot robot1 { Config=Rover Pos=1,0,0 }\nRobot cart { Config=Cart Pos=2,0,0 }\n"));
        const auto heading = [&fixture](const std::vector<std::string>& selected) {
            const Objects objects = objectsAt(fixture.document.loaded(), selected);
            for (const Row& row : rowsOf(objects, fixture.document, nullptr))
                if (row.id == "param.track") return row.section;
            return QString();
        };
        QCOMPARE(heading({"robot0"}), QStringLiteral("Params of Rover"));
        QCOMPARE(heading({"robot0", "robot1"}), QStringLiteral("Params of Rover"));
        QCOMPARE(heading({"robot0", "cart"}), QStringLiteral("Params"));
        QCOMPARE(heading({"cart", "robot0", "robot1"}), QStringLiteral("Params"));
    }

    /// The Friction of a hinge is a torque, that of a slider a force: no row has both.
    void rowsOfUnlikeUnitsAreNotJoined() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("RobotConfig Arm {\n  Body a { Mass=1 }\n  Body b { Mass=1 }\n  Body c { Mass=1 }\n"
                             "  Hinge one { Parent=a Child=b Axis=0,1,0 }\n  Slider two { Parent=b Child=c Axis=1,0,0 }\n}\n"));
        const std::string hinge = "RobotConfig.Arm.one", slider = "RobotConfig.Arm.two";
        for (const std::string& one : {hinge, slider}) {
            fixture.selection.select(one);
            QVERIFY2(fixture.row("Friction"), one.c_str());
        }
        fixture.selection.set({hinge, slider});
        QVERIFY(fixture.row("Axis") && !fixture.row("Friction"));
    }

    void emptyingAMixedFieldChangesNothing() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        const std::string before = fixture.text(), rover = fixture.rover();
        fixture.selection.set({"RobotConfig.Rover.chassis.hull", "RobotConfig.Rover.leftWheel.tyre"});
        QCOMPARE(fixture.field("Mass")->placeholderText(), QStringLiteral("mixed"));
        QTest::keyClicks(fixture.field("Mass"), QStringLiteral("3"));
        QTest::keyClick(fixture.field("Mass"), Qt::Key_Backspace);
        QTest::keyClick(fixture.field("Mass"), Qt::Key_Return);
        QVERIFY(!fixture.field("Mass")->refused());
        QCOMPARE(fixture.rover(), rover);
        QCOMPARE(fixture.text(), before);
        QVERIFY(fixture.document.edits().history().entries().empty());
    }

    void draggingALabelIsOneEntry() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        const std::string before = fixture.text();
        const auto drag = [&](QWidget* label, int way) {
            const QPoint from(4, 6);
            QTest::mousePress(label, Qt::LeftButton, {}, from);
            for (int x = 3; x <= way; x += 3) {
                QMouseEvent move(QEvent::MouseMove, QPointF(from + QPoint(x, 0)),
                                 label->mapToGlobal(QPointF(from + QPoint(x, 0))), Qt::NoButton, Qt::LeftButton, {});
                QApplication::sendEvent(label, &move);
            }
            QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(way, 0));
        };
        drag(fixture.row("Resistance")->findChild<QWidget*>(QStringLiteral("label")), 30);
        QCOMPARE(fixture.text(), replaced(before, "Resistance=3", "Resistance=4"));
        QCOMPARE(fixture.document.edits().history().entries().size(), 1u);
        drag(fixture.row("Resistance")->findChild<QWidget*>(QStringLiteral("label")), 30);
        QCOMPARE(fixture.document.edits().history().entries().size(), 2u);
        fixture.document.edits().undo();
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
        // One axis of a vector is edited; the unit is kept.
        fixture.type("Resistance", QStringLiteral("3"));
        fixture.selection.select("robot0");
        fixture.type("Pos", QStringLiteral("12 cm"), "field0");
        drag(fixture.row("Pos")->findChild<QWidget*>(QStringLiteral("axis0")), 30);
        QVERIFY2(fixture.text().find("Pos=22 cm, 0, 0.5") != std::string::npos, fixture.text().c_str());
    }

    void stacksLongNumbers() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(replaced(kRobots, "Pos=1,2,0", "Pos=0.473219,0.5,-0.000039")));
        const auto stacked = [&](const char* id) {
            return fixture.field(id, "field0")->geometry().bottom() < fixture.field(id, "field1")->geometry().top();
        };
        const auto whole = [&](const char* id) {
            return fixture.field(id, "field0")->wholeWidth() <= fixture.field(id, "field0")->width() &&
                   fixture.field(id, "field2")->wholeWidth() <= fixture.field(id, "field2")->width();
        };
        fixture.selection.select("robot0");
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
        fixture.selection.select("robot1");
        EVENTUALLY(stacked("Pos") && whole("Pos"));
        QVERIFY(!stacked("HPR"));
        fixture.picture("long");
        fixture.panel.resize(700, 900);
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
        fixture.panel.resize(340, 900);
        EVENTUALLY(stacked("Pos") && whole("Pos"));
        fixture.selection.select("robot0");
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
    }

    void aListThatIsNotGivenYet() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("RobotConfig.Rover.leftAxle");
        fixture.type("Anchor", QStringLiteral("5 cm"), "field1");
        QVERIFY2(fixture.rover().find("Anchor=0,5 cm,0") != std::string::npos, fixture.rover().c_str());
        fixture.selection.select("RobotConfig.Rover.chassis");
        fixture.type("Inertia", QStringLiteral("0.5"), "field0");
        QVERIFY2(fixture.rover().find("Inertia=0.5,0.5,0.5") != std::string::npos, fixture.rover().c_str());
        for (const auto& [field, products] : {std::pair("field3", "0.01,0,0"), {"field4", "0,0.01,0"}, {"field5", "0,0,0.01"}}) {
            fixture.type("Inertia", QStringLiteral("0.01"), field); // one product of inertia adds the other two
            const std::string whole = std::string("Inertia=0.5,0.5,0.5,") + products;
            QVERIFY2(fixture.rover().find(whole) != std::string::npos, fixture.rover().c_str());
            fixture.document.edits().undo();
        }
    }

    void onlyTheLastNumbersCanBeLeftOut() {
        PropertiesFixture fixture;
        const std::string text = "RobotConfig Arm {\n  Body a { Mass=1 Inertia=2,2,2,0.1,0.2,0.3 }\n}\n";
        QVERIFY(fixture.open(text));
        fixture.selection.select("RobotConfig.Arm.a");
        const std::string before = fixture.text();
        for (const char* field : {"field1", "field3", "field4"}) {
            fixture.type("Inertia", QString(), field);
            QVERIFY2(fixture.field("Inertia", field)->refused(), field);
            QCOMPARE(fixture.text(), before);
            QTest::keyClick(fixture.field("Inertia", field), Qt::Key_Escape);
        }
    }

    void arrowKeysStep() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_Up);
        QVERIFY(fixture.text().find("Resistance=3.1") != std::string::npos);
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_PageDown);
        QVERIFY(fixture.text().find("Resistance=2.1") != std::string::npos);
        fixture.selection.select("Surface.rubber");
        for (int i = 0; i < 30; ++i) QTest::keyClick(fixture.field("Restitution"), Qt::Key_PageDown); // stops at the limit
        QCOMPARE(fixture.shown("Restitution"), QStringLiteral("0"));
        QVERIFY(!fixture.field("Restitution")->refused());
    }

    void choosingAColour() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("Material.red");
        const std::string before = fixture.rover();
        auto* swatch = fixture.field<QToolButton>("ColorRGB", "swatch");
        QTest::mouseClick(swatch, Qt::LeftButton);
        auto* dialog = fixture.panel.findChild<QColorDialog*>();
        QVERIFY(dialog);
        dialog->setCurrentColor(QColor::fromRgbF(0.0f, 1.0f, 0.0f));
        QCOMPARE(fixture.rover(), replaced(before, "0.9, 0.1, 0.1", "0,1,0"));
        dialog->setCurrentColor(QColor::fromRgbF(0.0f, 0.0f, 1.0f));
        dialog->accept();
        QCOMPARE(fixture.rover(), replaced(before, "0.9, 0.1, 0.1", "0,0,1"));
        QCOMPARE(fixture.document.edits().history().entries().size(), 1u);
        fixture.picture("colour");
        fixture.document.edits().undo();
        QCOMPARE(fixture.rover(), before);
        QTest::mouseClick(swatch, Qt::LeftButton);
        EVENTUALLY(fixture.panel.findChildren<QColorDialog*>().size() >= 1);
        dialog = fixture.panel.findChildren<QColorDialog*>().back();
        dialog->setCurrentColor(Qt::black);
        dialog->reject();
        QCOMPARE(fixture.rover(), before);
    }

    void choicesFlagsAndReferences() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        auto* solver = fixture.field<QComboBox>("Solver");
        QVERIFY(solver);
        // A default is faint in its row; in the popup list its text must be readable, also on the accent colour.
        solver->showPopup();
        EVENTUALLY(solver->view()->isVisible());
        const QAbstractItemView& list = *solver->view();
        const QImage chosen = list.viewport()->grab(list.visualRect(list.currentIndex())).toImage();
        int white = 0;
        for (int y = 0; y < chosen.height(); ++y)
            for (int x = 0; x < chosen.width(); ++x) white += qGray(chosen.pixel(x, y)) > 235;
        QVERIFY2(white > 5, "the chosen word cannot be read");
        solver->hidePopup();
        solver->setFocus();
        QTest::keyClick(solver, Qt::Key_Down);
        QVERIFY(fixture.text().find("Solver = exact") != std::string::npos);
        fixture.selection.select("RobotConfig.Rover.chassis.hull");
        QTest::mouseClick(fixture.field<QCheckBox>("Collide"), Qt::LeftButton, {}, QPoint(6, 8));
        QVERIFY2(fixture.rover().find("Collide=false") != std::string::npos, fixture.rover().c_str());
        fixture.picture("geom");
        auto* pick = fixture.field<QToolButton>("Material", "pick");
        QVERIFY(pick);
        Q_EMIT pick->menu()->aboutToShow();
        QStringList names;
        for (const QAction* action : pick->menu()->actions()) names << action->text();
        QCOMPARE(names, QStringList({QStringLiteral("default"), QStringLiteral("grey"), QStringLiteral("red")}));
        pick->menu()->actions().at(2)->trigger();
        QVERIFY(fixture.rover().find("Mass=2 Material=red") != std::string::npos);
        fixture.selection.select("RobotConfig.Rover.touch");
        pick = fixture.field<QToolButton>("Geom", "pick"); // a list property: picking toggles an entry
        Q_EMIT pick->menu()->aboutToShow();
        pick->menu()->actions().at(1)->trigger();
        QVERIFY2(fixture.rover().find("Geom=chassis.hull,leftWheel.tyre") != std::string::npos, fixture.rover().c_str());
        Q_EMIT pick->menu()->aboutToShow();
        pick->menu()->actions().at(0)->trigger();
        QVERIFY(fixture.rover().find("Geom=leftWheel.tyre") != std::string::npos);
        fixture.type("Geom", QStringLiteral("nobody"));
        QVERIFY(fixture.field("Geom")->refused());
        fixture.selection.select("path");
        pick = fixture.field<QToolButton>("Robot", "pick");
        Q_EMIT pick->menu()->aboutToShow();
        QCOMPARE(pick->menu()->actions().size(), 2);
    }

    void textsAreQuotedWhereTheyMust() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        for (const char* title :
             {"plain", "two words", "3 wheels", "say \"hi\"", "true", "a\\b c", "a//b", "10 %", "Köln {}", " lead"}) {
            fixture.type("Title", QString::fromUtf8(title));
            QVERIFY2(!fixture.field("Title")->refused(), title);
            QCOMPARE(fixture.shown("Title"), QString::fromUtf8(title));
            QCOMPARE(QString::fromStdString(fixture.document.loaded()->experiment->settings.title), QString::fromUtf8(title));
        }
        QVERIFY(fixture.text().find("Title = \" lead\"") != std::string::npos);
    }

    void writesFilePathAsInText() {
        PropertiesFixture fixture;
        fixture.write("textures/wood.png", "x");
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("Material.red");
        QTest::mouseClick(fixture.field<QToolButton>("Texture", "browse"), Qt::LeftButton);
        auto* dialog = fixture.panel.findChild<QFileDialog*>();
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(QString::fromStdString(fixture.write("textures/wood.png", "x")));
        dialog->reject();
        QVERIFY2(fixture.rover().find("Texture = textures/wood.png") != std::string::npos ||
                     fixture.rover().find("Texture=textures/wood.png") != std::string::npos,
                 fixture.rover().c_str());
    }

    void aNameFromTheListOfWhatFits() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("RobotConfig.Rover.leftMotor");
        auto* field = fixture.field("Joint");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("right"));
        auto* list = field->completer()->popup();
        EVENTUALLY(list->isVisible());
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        QVERIFY2(fixture.rover().find("RotaryMotor leftMotor { Joint=rightAxle") != std::string::npos, fixture.rover().c_str());
        QVERIFY(!list->isVisible());
    }

    void editingAsText() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        QVERIFY(fixture.choose("Solver", "rowAsText"));
        fixture.type("Solver", QStringLiteral("quick"));
        QVERIFY(fixture.text().find("Solver = quick") != std::string::npos);
        QVERIFY(fixture.choose("Solver", "rowAsText"));
        QVERIFY(fixture.field<QComboBox>("Solver"));
    }

    void overrideShowsInheritedValue() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        fixture.picture("override_row");
        const auto words = [&fixture](const char* id) {
            const auto* label = fixture.field<QLabel>(id, "override");
            return label && label->isVisible() ? label->text() : QString();
        };
        QVERIFY2(words("Resistance").contains(QStringLiteral("override here; Rover has 2 ohm")), qPrintable(words("Resistance")));
        QVERIFY(words("MaxVoltage").isEmpty()); // the config's own value
        Q_EMIT fixture.field<QLabel>("Resistance", "override")->linkActivated(QStringLiteral("push"));
        QVERIFY(fixture.rover().find("leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=3") != std::string::npos);
        QVERIFY(fixture.text().find("Resistance") == std::string::npos);
        QVERIFY(words("Resistance").isEmpty());
        fixture.document.edits().undo();
        Q_EMIT fixture.field<QLabel>("Resistance", "override")->linkActivated(QStringLiteral("reset"));
        QVERIFY(fixture.rover().find("Resistance=3") == std::string::npos);
        QVERIFY(fixture.text().find("Resistance") == std::string::npos);
        fixture.document.edits().undo();
        fixture.selection.set({"robot0.leftMotor", "robot1.leftMotor"});
        QVERIFY2(words("Resistance").contains(QStringLiteral("override in 1 of 2")), qPrintable(words("Resistance")));
        fixture.selection.select("robot0");
        fixture.type("param.track", QStringLiteral("0.3"));
        QVERIFY2(words("param.track").contains(QStringLiteral("Rover has 0.25")), qPrintable(words("param.track")));
    }

    /// Before a change the header shows where it will be written.
    void headerShowsTargetOfChange() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        const auto header = [&fixture] {
            QString all;
            for (const QLabel* label : fixture.panel.findChildren<QLabel*>())
                if (label->isVisible() && label->textFormat() == Qt::RichText) all += label->text() + QLatin1Char('\n');
            return all;
        };
        fixture.selection.select("robot0.leftMotor");
        QVERIFY2(header().contains(QStringLiteral("become overrides of robot0 in main.sim")), qPrintable(header()));
        fixture.selection.select("RobotConfig.Rover.leftMotor");
        QVERIFY2(header().contains(QStringLiteral("for all 2 instances of Rover")), qPrintable(header()));
        const std::string one = std::string(kRoverFile) + "Robot only { Config=Rover }\n";
        QVERIFY(fixture.document.opening().open(fixture.write("one.sim", one)).ok());
        fixture.selection.select("only.leftMotor");
        EVENTUALLY(header().contains(QStringLiteral("go into Rover in one.sim: only only is created from it")));
        fixture.picture("header_config");
        fixture.type("Resistance", QStringLiteral("7"));
        QCOMPARE(fixture.text(), replaced(one, "Resistance=2", "Resistance=7"));
    }
};

QTEST_MAIN(PropertyEditorsTest)
#include "property_editors_test.moc"
