#include "panel_desk.h"

#include <QAction>
#include <QClipboard>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>

using namespace trundle;

namespace {

const std::string kRobots = R"(
Tick = 0.01
Robot robot0 { Config=Rover  Pos=0, 0, 0.5  leftMotor.Resistance=3 }
Robot robot1 { Config=Rover  Pos=1,2,0 }
PoseLog path { Robot=robot0 Interval=0.1 File=path.csv }
)";

} // namespace

class PropertiesPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void nothingIsOpen() {
        PanelDesk desk;
        QVERIFY(desk.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QVERIFY(desk.open(kRobots));
        QVERIFY(!desk.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        desk.document.close();
        QVERIFY(desk.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QVERIFY(!desk.row("Tick"));
    }

    void theExperimentWhenNothingIsSelected() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        QCOMPARE(desk.shown("Tick"), QStringLiteral("0.01"));
        const std::string before = desk.text();
        desk.type("Duration", QStringLiteral("2 min"));
        const std::string longer = replaced(before, "Tick = 0.01", "Tick = 0.01\nDuration = 2 min");
        QCOMPARE(desk.text(), longer);
        desk.type("Tick", QStringLiteral("5 ms"));
        QCOMPARE(desk.text(), replaced(longer, "Tick = 0.01", "Tick = 5 ms"));
        QCOMPARE(desk.document.history().entries().back().name, QStringLiteral("Set Tick to 5 ms"));
        desk.picture("experiment");
        desk.document.undo();
        desk.document.undo();
        QCOMPARE(desk.text(), before);
        QCOMPARE(desk.shown("Tick"), QStringLiteral("0.01"));
    }

    void theExperimentWhenAnUndoTookTheObjectAway() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        QVERIFY(desk.document
                    .carryOut(QStringLiteral("Add"), planInsert(*desk.document.loaded(), {}, "Robot robot2 { Config=Rover }"))
                    .ok());
        QCOMPARE(desk.selection.current(), std::string("robot2"));
        QVERIFY(desk.row("Pos"));
        desk.document.undo();
        QTRY_COMPARE(desk.shown("Tick"), QStringLiteral("0.01"));
        QVERIFY(!desk.row("Pos"));
        QVERIFY(!desk.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QCOMPARE(desk.panel.findChild<QLineEdit*>(QStringLiteral("objectName"))->text(), QStringLiteral("Experiment"));
        desk.document.redo(); // it is selected still
        QTRY_VERIFY(desk.row("Pos"));
    }

    void oneNumberOfAVectorChangesAlone() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0");
        QCOMPARE(desk.shown("Pos", "field2"), QStringLiteral("0.5"));
        const std::string before = desk.text();
        desk.type("Pos", QStringLiteral("12 cm"), "field1");
        QCOMPARE(desk.text(), replaced(before, "Pos=0, 0, 0.5", "Pos=0, 12 cm, 0.5"));
        desk.picture("robot");
        desk.type("HPR", QStringLiteral("90"), "field0"); // a default becomes a value, written as the file writes lists
        QVERIFY2(desk.text().find("HPR=90, 0, 0") != std::string::npos, desk.text().c_str());
        desk.document.undo();
        desk.document.undo();
        QCOMPARE(desk.text(), before);
    }

    void aFormulaShowsTextAndValue() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftWheel");
        QCOMPARE(desk.shown("Pos", "field1"), QStringLiteral("$(track/2)"));
        desk.picture("formula");
        desk.type("Pos", QStringLiteral("$(track/4)"), "field1"); // through the instance: its own value from now on
        QVERIFY2(desk.text().find("leftWheel.Pos") != std::string::npos || desk.help().contains(QStringLiteral("Param")),
                 desk.text().c_str());
        desk.selection.select("RobotConfig.Rover.leftWheel.tyre");
        QCOMPARE(desk.shown("Radius"), QStringLiteral("$wheelRadius"));
        const std::string before = desk.rover();
        desk.type("Radius", QStringLiteral("$(wheelRadius*2)"));
        QCOMPARE(desk.rover(), replaced(before, "Radius=$wheelRadius", "Radius=$(wheelRadius*2)"));
        desk.type("Radius", QStringLiteral(" wheelRadius/2 ")); // nobody types the brackets
        QCOMPARE(desk.rover(), replaced(before, "Radius=$wheelRadius", "Radius=$(wheelRadius/2)"));
        desk.selection.select("robot1");
        desk.type("param.wheelRadius", QStringLiteral("0.04+0.02")); // of a Param too
        QVERIFY2(desk.text().find("wheelRadius=$(0.04+0.02)") != std::string::npos, desk.text().c_str());
    }

    void aRefusedValueStaysRedAndTheTextStays() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        const std::string before = desk.text(), rover = desk.rover();
        const std::size_t entries = desk.document.history().entries().size();
        for (const char* bad : {"-3", "12 cm", "abc", "3 } Robot x {", "$nothing", "1,2", "\"", "3 // c", "nan", "1e999"}) {
            desk.type("Resistance", QString::fromLatin1(bad));
            QVERIFY2(desk.field("Resistance")->refused(), bad);
            QCOMPARE(desk.shown("Resistance"), QString::fromLatin1(bad));
            QVERIFY2(!desk.help().isEmpty(), bad);
            QCOMPARE(desk.text(), before);
            QCOMPARE(desk.rover(), rover);
        }
        desk.type("Resistance", QStringLiteral("-3"));
        QVERIFY2(desk.help().contains(QStringLiteral("it must be from")), qPrintable(desk.help()));
        desk.picture("refused");
        QTest::keyClick(desk.field("Resistance"), Qt::Key_Escape);
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("3"));
        QVERIFY(!desk.field("Resistance")->refused());
        QVERIFY(!desk.help().contains(QStringLiteral("it must be from")));
        QCOMPARE(desk.document.history().entries().size(), entries);
    }

    void aWrongValueOfTheTextIsSaidAtItsRow() {
        PanelDesk desk;
        QVERIFY(desk.open(
            "Robot robot0 { Config=Rover Pos=0,0,0 HPR=fast }\nRobot robot1 { Config=Rover leftMotor.Resistance=-4 }\n"));
        desk.selection.select("robot0");
        const auto note = [&desk](const char* id) {
            const auto* label = desk.row(id)->findChild<QLabel*>(QStringLiteral("note"));
            return label->isVisible() ? label->text() : QString();
        };
        QVERIFY2(note("HPR").contains(QStringLiteral("three numbers")), qPrintable(note("HPR")));
        QCOMPARE(note("Pos"), QString());
        desk.picture("wrong");
        QTest::mouseClick(desk.field("HPR"), Qt::LeftButton);
        QVERIFY2(desk.help().contains(note("HPR").toHtmlEscaped()), qPrintable(desk.help()));
        desk.type("HPR", QStringLiteral("0,0,90"));
        QCOMPARE(note("HPR"), QString());
        desk.document.undo();
        QVERIFY(note("HPR").contains(QStringLiteral("three numbers")));
        desk.selection.select("robot1");
        const QString override = note("override.leftMotor.Resistance");
        QVERIFY2(override.contains(QStringLiteral("-4")), qPrintable(override));
    }

    void leavingAFieldEntersWhatWasTyped() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        auto* field = desk.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("4"));
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(desk.text().find("leftMotor.Resistance=4") != std::string::npos);
        QVERIFY(!desk.field("Resistance")->hasFocus());
        QVERIFY(desk.panel.isAncestorOf(QApplication::focusWidget()));
    }

    void whereAValueComesFrom_data() {
        QTest::addColumn<QString>("object");
        QTest::addColumn<QString>("row");
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("place");
        QTest::newRow("default") << "robot0.leftMotor"
                                 << "GearRatio"
                                 << "the default"
                                 << "";
        QTest::newRow("config") << "robot0.leftMotor"
                                << "MaxVoltage"
                                << "set in the config"
                                << "rover.sim:14";
        QTest::newRow("override") << "robot0.leftMotor"
                                  << "Resistance"
                                  << "override here; Rover has 2 ohm"
                                  << "main.sim:4";
        QTest::newRow("own") << "RobotConfig.Rover.leftMotor"
                             << "Resistance"
                             << "set here"
                             << "rover.sim:14";
        QTest::newRow("param") << "robot0"
                               << "param.track"
                               << "set in the config"
                               << "rover.sim:6";
        QTest::newRow("setting") << ""
                                 << "Tick"
                                 << "set here"
                                 << "main.sim:3";
        QTest::newRow("not given") << "robot0.chassis"
                                   << "Mass"
                                   << "not set"
                                   << "";
    }

    void whereAValueComesFrom() {
        QFETCH(QString, object);
        QFETCH(QString, row);
        QFETCH(QString, words);
        QFETCH(QString, place);
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select(object.toStdString());
        QWidget* shown = desk.row(qPrintable(row));
        QVERIFY(shown);
        const QString tip = shown->findChild<QWidget*>(QStringLiteral("mark"))->toolTip();
        QCOMPARE(tip, place.isEmpty() ? words : words + QLatin1Char('\n') + place);
        if (place.isEmpty()) return;
        QSignalSpy jumps(&desk.panel, &PropertiesPanel::jumpTo);
        QVERIFY(desk.choose(qPrintable(row), "rowJump"));
        QCOMPARE(jumps.size(), 1);
    }

    void resetPushAndPull() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        const std::string before = desk.text(), rover = desk.rover();
        desk.selection.select("robot0.leftMotor");
        QVERIFY(!desk.choose("GearRatio", "rowReset")); // nothing to take back
        QVERIFY(!desk.choose("MaxVoltage", "rowReset"));
        QVERIFY(desk.choose("Resistance", "rowReset"));
        QCOMPARE(desk.text(), replaced(before, "  leftMotor.Resistance=3", ""));
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("2"));
        desk.document.undo();
        QVERIFY(desk.choose("Resistance", "rowPush"));
        QVERIFY(desk.text().find("leftMotor") == std::string::npos);
        QVERIFY(desk.rover().find("SpeedConstant=50 Resistance=3") != std::string::npos);
        desk.document.undo();
        QCOMPARE(desk.rover(), rover);
        QVERIFY(desk.choose("MaxVoltage", "rowPull"));
        QVERIFY(desk.text().find("leftMotor.MaxVoltage=12") != std::string::npos);
        desk.document.undo();
        QCOMPARE(desk.text(), before);
        QVERIFY(desk.choose("MaxVoltage", "rowCopyPath"));
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("robot0.leftMotor.MaxVoltage"));
    }

    void anEmptyFieldResets() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        desk.type("Resistance", QString());
        QVERIFY(desk.text().find("Resistance") == std::string::npos);
        desk.selection.select("robot1");
        desk.type("Pos", QString(), "field1");
        QVERIFY(desk.field("Pos", "field1")->refused());
    }

    void severalObjectsAreOneEdit() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        const std::string before = desk.text();
        desk.selection.set({"robot0", "robot1"});
        QCOMPARE(desk.shown("Pos", "field2"), QString());
        QCOMPARE(desk.field("Pos", "field2")->placeholderText(), QStringLiteral("mixed"));
        desk.picture("several");
        desk.type("Pos", QStringLiteral("1.5"), "field2");
        QCOMPARE(desk.text(), replaced(replaced(before, "0, 0, 0.5", "0, 0, 1.5"), "1,2,0", "1,2,1.5"));
        QCOMPARE(desk.document.history().entries().size(), 1u);
        desk.document.undo();
        QCOMPARE(desk.text(), before);
        // kinds that differ show what they share
        desk.selection.set({"robot0.leftMotor", "robot0.chassis.hull"});
        QVERIFY(!desk.row("Resistance"));
        desk.selection.set({"robot0.chassis.hull", "robot0.leftWheel.tyre"});
        QVERIFY(desk.row("Mass") && desk.row("Material") && !desk.row("Size") && !desk.row("Radius"));
    }

    void paramsOfAnInstance() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot1");
        QCOMPARE(desk.shown("param.wheelRadius"), QStringLiteral("5 cm"));
        desk.type("param.wheelRadius", QStringLiteral("6 cm"));
        QVERIFY2(desk.text().find("wheelRadius=6 cm") != std::string::npos, desk.text().c_str());
        QVERIFY(desk.choose("param.wheelRadius", "rowReset"));
        QVERIFY(desk.text().find("wheelRadius") == std::string::npos);
        desk.selection.select("RobotConfig.Rover");
        const std::string before = desk.rover();
        desk.type("param.track", QStringLiteral("0.3"));
        QCOMPARE(desk.rover(), replaced(before, "track = 0.25", "track = 0.3"));
        desk.type("param.track", QStringLiteral("wheelRadius/2")); // no word with a slash where a number stands
        QCOMPARE(desk.rover(), replaced(before, "track = 0.25", "track = $(wheelRadius/2)"));
        desk.type("param.track", QStringLiteral("wheelRadius/10")); // nor where it was a formula
        QCOMPARE(desk.rover(), replaced(before, "track = 0.25", "track = $(wheelRadius/10)"));
        desk.type("param.track", QStringLiteral("0.3"));
        desk.picture("config");
    }

    /// Each row is some widgets: ten thousand of them would take a gigabyte.
    void ofManyParamsTheFirstAreShown() {
        PanelDesk desk;
        std::string text;
        for (int i = 0; i < 1000; ++i) text += "Param p" + std::to_string(i) + " = 1\n";
        QVERIFY(desk.open(text));
        QCOMPARE(desk.panel.findChildren<QWidget*>(QRegularExpression(QStringLiteral("^row\\.param\\."))).size(), 200);
    }

    void overridesAreListedAtTheInstance() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0");
        QCOMPARE(desk.shown("override.leftMotor.Resistance"), QStringLiteral("3"));
        QVERIFY(desk.choose("override.leftMotor.Resistance", "rowReset"));
        QVERIFY(!desk.row("override.leftMotor.Resistance") || !desk.row("override.leftMotor.Resistance")->isVisible());
    }

    void aControllersRowsStandAtItsRobot() {
        PanelDesk desk;
        QVERIFY(desk.open("\nRobot robot0 { Config=Rover LinearMotion brain { Distance=1 } }\n"));
        desk.selection.select("robot0");
        desk.type("controller.LinearMotion.Distance", QStringLiteral("2"));
        QVERIFY(desk.text().find("Distance=2") != std::string::npos);
    }

    void whatIsTypedIsEnteredWhenAnotherIsSelected() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        auto* field = desk.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("7"));
        desk.selection.select("robot1"); // by a shortcut: the field never lost the focus before
        QVERIFY2(desk.text().find("leftMotor.Resistance=7") != std::string::npos, desk.text().c_str());
        QCOMPARE(desk.shown("Pos", "field0"), QStringLiteral("1"));
        QCOMPARE(desk.panel.findChildren<QWidget*>(QStringLiteral("row.Pos")).size(), 1);
        // one that is refused is given up with its row
        desk.selection.select("robot0.leftMotor");
        desk.type("Resistance", QStringLiteral("nonsense"));
        desk.selection.select("robot1");
        desk.selection.select("robot0.leftMotor");
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("7"));
    }

    void undoBelongsToTheDocumentUnlessSomebodyTypes() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        QAction undo(&desk.panel);
        undo.setShortcut(QKeySequence::Undo);
        desk.panel.addAction(&undo);
        connect(&undo, &QAction::triggered, &desk.document, &Document::undo);
        const std::string before = desk.text();
        desk.type("Resistance", QStringLiteral("7"));
        QTest::keyClick(desk.field("Resistance"), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.text(), before);
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("3"));
    }

    void aChangeFromElsewhereLeavesWhatIsTyped() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        auto* field = desk.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("7"));
        QVERIFY(desk.document.setValues(QStringLiteral("Elsewhere"), {{"robot1.Pos", "5,5,5"}}).ok());
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("7"));
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("3"));
    }

    void renaming() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0");
        auto* name = desk.panel.findChild<ValueField*>(QStringLiteral("objectName"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("scout"));
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(desk.text().find("Robot scout {") != std::string::npos);
        QVERIFY(desk.text().find("PoseLog path { Robot=scout") != std::string::npos);
        QCOMPARE(desk.selection.current(), std::string("scout"));
        QCOMPARE(name->text(), QStringLiteral("scout"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("robot1"));
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(name->refused());
        QTest::keyClick(name, Qt::Key_Escape);
        QCOMPARE(name->text(), QStringLiteral("scout"));
    }

    void aKindThatIsNotKnown() {
        PanelDesk desk;
        QVERIFY(desk.open("#loadModule nowhere\nRobot robot0 { Config=Rover Mystery brain { Speed=3 } }\n"));
        desk.selection.select("robot0.brain"); // nothing is known of it: nothing to edit but its text
        QVERIFY(!desk.row("Tick"));
        QVERIFY(desk.help().contains(QStringLiteral("not known")));
        desk.selection.select("robot0");
        QVERIFY(desk.row("Pos"));
    }

    void aBrokenTextStillHasRows() {
        PanelDesk desk;
        QVERIFY(desk.open("Robot robot0 { Config=Rover Pos=1,2 HPR=1,,3 leftMotor.Resistance=-4 }\nRobot r { Config=Nobody }\n"));
        desk.selection.select("robot0");
        QCOMPARE(desk.shown("Pos"), QStringLiteral("1,2"));
        desk.type("Pos", QStringLiteral("1,2,3"));
        QVERIFY2(desk.text().find("Pos=1,2,3") != std::string::npos, desk.text().c_str());
        QCOMPARE(desk.shown("Pos", "field2"), QStringLiteral("3"));
        QCOMPARE(desk.shown("override.leftMotor.Resistance"), QStringLiteral("-4"));
        desk.selection.select("r");
        QVERIFY(desk.row("Config"));
        desk.selection.select("robot0.nobody.at.all");
        QVERIFY(desk.row("Tick")); // as where nothing is selected, and says so
        QCOMPARE(desk.panel.findChild<QLineEdit*>(QStringLiteral("objectName"))->text(), QStringLiteral("Experiment"));
    }

    void membersOfAGridAreEditedTogether() {
        PanelDesk desk;
        QVERIFY(desk.open("Grid swarm { Config=Rover Count=2,2 Spacing=1 }\n"));
        desk.selection.set({"swarm_1", "swarm_2"});
        QVERIFY(desk.panel.findChild<QLabel*>(QStringLiteral("objectConfig"))->text().contains(QStringLiteral("One of swarm")));
        desk.type("Spacing", QStringLiteral("2"), "field1");
        QVERIFY2(desk.text().find("Spacing=1,2") != std::string::npos, desk.text().c_str());
        QTest::mouseClick(desk.panel.findChild<QPushButton*>(QStringLiteral("replaceBySingles")), Qt::LeftButton);
        QVERIFY(desk.text().find("Robot swarm_3") != std::string::npos);
    }

    void theSameInDarkness() {
        PanelDesk desk;
        applyTheme(*qApp, ThemeKind::Dark);
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        desk.field("Resistance")->setFocus();
        desk.picture("dark");
        applyTheme(*qApp, ThemeKind::Light);
        QCOMPARE(desk.shown("Resistance"), QStringLiteral("3"));
    }
};

QTEST_MAIN(PropertiesPanelTest)
#include "properties_panel_test.moc"
