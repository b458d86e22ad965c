// The property panel: its rows, editing values, and errors.
#include "properties_fixture.h"

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
        PropertiesFixture fixture;
        QVERIFY(fixture.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QVERIFY(fixture.open(kRobots));
        QVERIFY(!fixture.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        fixture.document.opening().close();
        QVERIFY(fixture.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QVERIFY(!fixture.row("Tick"));
    }

    void theExperimentWhenNothingIsSelected() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        QCOMPARE(fixture.shown("Tick"), QStringLiteral("0.01"));
        const std::string before = fixture.text();
        fixture.type("Duration", QStringLiteral("2 min"));
        const std::string longer = replaced(before, "Tick = 0.01", "Tick = 0.01\nDuration = 2 min");
        QCOMPARE(fixture.text(), longer);
        fixture.type("Tick", QStringLiteral("5 ms"));
        QCOMPARE(fixture.text(), replaced(longer, "Tick = 0.01", "Tick = 5 ms"));
        QCOMPARE(fixture.document.edits().history().entries().back().name, QStringLiteral("Set Tick to 5 ms"));
        fixture.picture("experiment");
        fixture.document.edits().undo();
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
        QCOMPARE(fixture.shown("Tick"), QStringLiteral("0.01"));
    }

    void showsExperimentAfterUndoRemovesObject() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        QVERIFY(fixture.document.edits()
                    .apply(QStringLiteral("Add"), planInsert(*fixture.document.loaded(), {}, "Robot robot2 { Config=Rover }"))
                    .ok());
        QCOMPARE(fixture.selection.current(), std::string("robot2"));
        QVERIFY(fixture.row("Pos"));
        fixture.document.edits().undo();
        EVENTUALLY_EQUAL(fixture.shown("Tick"), QStringLiteral("0.01"));
        QVERIFY(!fixture.row("Pos"));
        QVERIFY(!fixture.panel.findChild<QLabel*>(QStringLiteral("nothing"))->isVisible());
        QCOMPARE(fixture.panel.findChild<QLineEdit*>(QStringLiteral("objectName"))->text(), QStringLiteral("Experiment"));
        fixture.document.edits().redo(); // it is still selected
        EVENTUALLY(fixture.row("Pos"));
    }

    void changesOneNumberOfVector() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0");
        QCOMPARE(fixture.shown("Pos", "field2"), QStringLiteral("0.5"));
        const std::string before = fixture.text();
        fixture.type("Pos", QStringLiteral("12 cm"), "field1");
        QCOMPARE(fixture.text(), replaced(before, "Pos=0, 0, 0.5", "Pos=0, 12 cm, 0.5"));
        fixture.picture("robot");
        fixture.type("HPR", QStringLiteral("90"), "field0"); // the default becomes a value, written in the list style of the file
        QVERIFY2(fixture.text().find("HPR=90, 0, 0") != std::string::npos, fixture.text().c_str());
        fixture.document.edits().undo();
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
    }

    void aFormulaShowsTextAndValue() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftWheel");
        QCOMPARE(fixture.shown("Pos", "field1"), QStringLiteral("$(track/2)"));
        fixture.picture("formula");
        fixture.type("Pos", QStringLiteral("$(track/4)"), "field1"); // through the instance: it has its own value from now on
        QVERIFY2(fixture.text().find("leftWheel.Pos") != std::string::npos || fixture.help().contains(QStringLiteral("Param")),
                 fixture.text().c_str());
        fixture.selection.select("RobotConfig.Rover.leftWheel.tyre");
        QCOMPARE(fixture.shown("Radius"), QStringLiteral("$wheelRadius"));
        const std::string before = fixture.rover();
        fixture.type("Radius", QStringLiteral("$(wheelRadius*2)"));
        QCOMPARE(fixture.rover(), replaced(before, "Radius=$wheelRadius", "Radius=$(wheelRadius*2)"));
        fixture.type("Radius", QStringLiteral(" wheelRadius/2 ")); // the formula brackets are added
        QCOMPARE(fixture.rover(), replaced(before, "Radius=$wheelRadius", "Radius=$(wheelRadius/2)"));
        fixture.selection.select("robot1");
        fixture.type("param.wheelRadius", QStringLiteral("0.04+0.02")); // a Param accepts a formula too
        QVERIFY2(fixture.text().find("wheelRadius=$(0.04+0.02)") != std::string::npos, fixture.text().c_str());
    }

    void aRefusedValueStaysRedAndTheTextStays() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        const std::string before = fixture.text(), rover = fixture.rover();
        const std::size_t entries = fixture.document.edits().history().entries().size();
        for (const char* bad : {"-3", "12 cm", "abc", "3 } Robot x {", "$nothing", "1,2", "\"", "3 // c", "nan", "1e999"}) {
            fixture.type("Resistance", QString::fromLatin1(bad));
            QVERIFY2(fixture.field("Resistance")->refused(), bad);
            QCOMPARE(fixture.shown("Resistance"), QString::fromLatin1(bad));
            QVERIFY2(!fixture.help().isEmpty(), bad);
            QCOMPARE(fixture.text(), before);
            QCOMPARE(fixture.rover(), rover);
        }
        fixture.type("Resistance", QStringLiteral("-3"));
        QVERIFY2(fixture.help().contains(QStringLiteral("it must be from")), qPrintable(fixture.help()));
        fixture.picture("refused");
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_5); // the next key changes what the error is about
        QVERIFY(!fixture.field("Resistance")->refused() && !fixture.help().contains(QStringLiteral("it must be from")));
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_Escape);
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("3"));
        QCOMPARE(fixture.document.edits().history().entries().size(), entries);
    }

    void showsTextErrorAtItsRow() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(
            "Robot robot0 { Config=Rover Pos=0,0,0 HPR=fast }\nRobot robot1 { Config=Rover leftMotor.Resistance=-4 }\n"));
        fixture.selection.select("robot0");
        const auto note = [&fixture](const char* id) {
            const auto* label = fixture.row(id)->findChild<QLabel*>(QStringLiteral("note"));
            return label->isVisible() ? label->text() : QString();
        };
        QVERIFY2(note("HPR").contains(QStringLiteral("three numbers")), qPrintable(note("HPR")));
        QCOMPARE(note("Pos"), QString());
        fixture.picture("wrong");
        QTest::mouseClick(fixture.field("HPR"), Qt::LeftButton);
        QVERIFY2(fixture.help().contains(note("HPR").toHtmlEscaped()), qPrintable(fixture.help()));
        fixture.type("HPR", QStringLiteral("0,0,90"));
        QCOMPARE(note("HPR"), QString());
        fixture.document.edits().undo();
        QVERIFY(note("HPR").contains(QStringLiteral("three numbers")));
        fixture.selection.select("robot1");
        const QString override = note("override.leftMotor.Resistance");
        QVERIFY2(override.contains(QStringLiteral("-4")), qPrintable(override));
    }

    void leavingAFieldEntersWhatWasTyped() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        auto* field = fixture.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("4"));
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(fixture.text().find("leftMotor.Resistance=4") != std::string::npos);
        QVERIFY(!fixture.field("Resistance")->hasFocus());
        QVERIFY(fixture.panel.isAncestorOf(QApplication::focusWidget()));
    }

    void showsOriginOfValues_data() {
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

    void showsOriginOfValues() {
        QFETCH(QString, object);
        QFETCH(QString, row);
        QFETCH(QString, words);
        QFETCH(QString, place);
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select(object.toStdString());
        QWidget* shown = fixture.row(qPrintable(row));
        QVERIFY(shown);
        const QString tip = shown->findChild<QWidget*>(QStringLiteral("mark"))->toolTip();
        QCOMPARE(tip, place.isEmpty() ? words : words + QLatin1Char('\n') + place);
        if (place.isEmpty()) return;
        QSignalSpy jumps(&fixture.panel, &PropertiesPanel::jumpTo);
        QVERIFY(fixture.choose(qPrintable(row), "rowJump"));
        QCOMPARE(jumps.size(), 1);
    }

    void resetPushAndPull() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        const std::string before = fixture.text(), rover = fixture.rover();
        fixture.selection.select("robot0.leftMotor");
        QVERIFY(!fixture.choose("GearRatio", "rowReset")); // nothing to reset
        QVERIFY(!fixture.choose("MaxVoltage", "rowReset"));
        QVERIFY(fixture.choose("Resistance", "rowReset"));
        QCOMPARE(fixture.text(), replaced(before, "  leftMotor.Resistance=3", ""));
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("2"));
        fixture.document.edits().undo();
        QVERIFY(fixture.choose("Resistance", "rowPush"));
        QVERIFY(fixture.text().find("leftMotor") == std::string::npos);
        QVERIFY(fixture.rover().find("SpeedConstant=50 Resistance=3") != std::string::npos);
        fixture.document.edits().undo();
        QCOMPARE(fixture.rover(), rover);
        QVERIFY(fixture.choose("MaxVoltage", "rowPull"));
        QVERIFY(fixture.text().find("leftMotor.MaxVoltage=12") != std::string::npos);
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
        QVERIFY(fixture.choose("MaxVoltage", "rowCopyPath"));
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("robot0.leftMotor.MaxVoltage"));
    }

    void anEmptyFieldResets() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        fixture.type("Resistance", QString());
        QVERIFY(fixture.text().find("Resistance") == std::string::npos);
        fixture.selection.select("robot1");
        fixture.type("Pos", QString(), "field1");
        QVERIFY(fixture.field("Pos", "field1")->refused());
    }

    void severalObjectsAreOneEdit() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        const std::string before = fixture.text();
        fixture.selection.set({"robot0", "robot1"});
        QCOMPARE(fixture.shown("Pos", "field2"), QString());
        QCOMPARE(fixture.field("Pos", "field2")->placeholderText(), QStringLiteral("mixed"));
        fixture.picture("several");
        fixture.type("Pos", QStringLiteral("1.5"), "field2");
        QCOMPARE(fixture.text(), replaced(replaced(before, "0, 0, 0.5", "0, 0, 1.5"), "1,2,0", "1,2,1.5"));
        QCOMPARE(fixture.document.edits().history().entries().size(), 1u);
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
        // Objects of different kinds show their common properties.
        fixture.selection.set({"robot0.leftMotor", "robot0.chassis.hull"});
        QVERIFY(!fixture.row("Resistance"));
        fixture.selection.set({"robot0.chassis.hull", "robot0.leftWheel.tyre"});
        QVERIFY(fixture.row("Mass") && fixture.row("Material") && !fixture.row("Size") && !fixture.row("Radius"));
    }

    void paramsOfAnInstance() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot1");
        QCOMPARE(fixture.shown("param.wheelRadius"), QStringLiteral("5 cm"));
        fixture.type("param.wheelRadius", QStringLiteral("6 cm"));
        QVERIFY2(fixture.text().find("wheelRadius=6 cm") != std::string::npos, fixture.text().c_str());
        QVERIFY(fixture.choose("param.wheelRadius", "rowReset"));
        QVERIFY(fixture.text().find("wheelRadius") == std::string::npos);
        fixture.selection.select("RobotConfig.Rover");
        const std::string before = fixture.rover();
        fixture.type("param.track", QStringLiteral("0.3"));
        QCOMPARE(fixture.rover(), replaced(before, "track = 0.25", "track = 0.3"));
        fixture.type("param.track", QStringLiteral("wheelRadius/2")); // written as a formula, although the value was a number
        QCOMPARE(fixture.rover(), replaced(before, "track = 0.25", "track = $(wheelRadius/2)"));
        fixture.type("param.track", QStringLiteral("wheelRadius/10")); // also if it was a formula
        QCOMPARE(fixture.rover(), replaced(before, "track = 0.25", "track = $(wheelRadius/10)"));
        fixture.type("param.track", QStringLiteral("0.3"));
        fixture.picture("config");
    }

    /// Each row has several widgets: ten thousand rows would take a gigabyte.
    void ofManyParamsTheFirstAreShown() {
        PropertiesFixture fixture;
        std::string text;
        for (int i = 0; i < 1000; ++i) text += "Param p" + std::to_string(i) + " = 1\n";
        QVERIFY(fixture.open(text));
        QCOMPARE(fixture.panel.findChildren<QWidget*>(QRegularExpression(QStringLiteral("^row\\.param\\."))).size(), 200);
    }

    void overridesAreListedAtTheInstance() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0");
        QCOMPARE(fixture.shown("override.leftMotor.Resistance"), QStringLiteral("3"));
        QVERIFY(fixture.choose("override.leftMotor.Resistance", "rowReset"));
        QVERIFY(!fixture.row("override.leftMotor.Resistance") || !fixture.row("override.leftMotor.Resistance")->isVisible());
    }

    void showsControllerRowsAtRobot() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("\nRobot robot0 { Config=Rover LinearMotion brain { Distance=1 } }\n"));
        fixture.selection.select("robot0");
        fixture.type("controller.LinearMotion.Distance", QStringLiteral("2"));
        QVERIFY(fixture.text().find("Distance=2") != std::string::npos);
    }

    void selectingAnotherCommitsTypedText() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        auto* field = fixture.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("7"));
        fixture.selection.select("robot1"); // by a shortcut: the field still has the focus
        QVERIFY2(fixture.text().find("leftMotor.Resistance=7") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.shown("Pos", "field0"), QStringLiteral("1"));
        QCOMPARE(fixture.panel.findChildren<QWidget*>(QStringLiteral("row.Pos")).size(), 1);
        // An invalid entry is discarded with its row.
        fixture.selection.select("robot0.leftMotor");
        fixture.type("Resistance", QStringLiteral("nonsense"));
        fixture.selection.select("robot1");
        fixture.selection.select("robot0.leftMotor");
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("7"));
    }

    void undoBelongsToDocumentUnlessTyping() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        QAction undo(&fixture.panel);
        undo.setShortcut(QKeySequence::Undo);
        fixture.panel.addAction(&undo);
        connect(&undo, &QAction::triggered, &fixture.document.edits(), &DocumentEdits::undo);
        const std::string before = fixture.text();
        fixture.type("Resistance", QStringLiteral("7"));
        QTest::keyClick(fixture.field("Resistance"), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(fixture.text(), before);
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("3"));
    }

    void aChangeFromElsewhereLeavesWhatIsTyped() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        auto* field = fixture.field("Resistance");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("7"));
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("Elsewhere"), {{"robot1.Pos", "5,5,5"}}).ok());
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("7"));
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("3"));
    }

    void renaming() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0");
        auto* name = fixture.panel.findChild<ValueField*>(QStringLiteral("objectName"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("scout"));
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(fixture.text().find("Robot scout {") != std::string::npos);
        QVERIFY(fixture.text().find("PoseLog path { Robot=scout") != std::string::npos);
        QCOMPARE(fixture.selection.current(), std::string("scout"));
        QCOMPARE(name->text(), QStringLiteral("scout"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, QStringLiteral("robot1"));
        QTest::keyClick(name, Qt::Key_Return);
        QVERIFY(name->refused());
        QTest::keyClick(name, Qt::Key_Escape);
        QCOMPARE(name->text(), QStringLiteral("scout"));
    }

    void showsUnknownKind() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("#loadModule nowhere\nRobot robot0 { Config=Rover Mystery brain { Speed=3 } }\n"));
        fixture.selection.select("robot0.brain"); // its kind is unknown: only the text can be edited
        QVERIFY(!fixture.row("Tick"));
        QVERIFY(fixture.help().contains(QStringLiteral("Unknown kind")));
        fixture.selection.select("robot0");
        QVERIFY(fixture.row("Pos"));
    }

    void showsRowsOfBrokenText() {
        PropertiesFixture fixture;
        QVERIFY(
            fixture.open("Robot robot0 { Config=Rover Pos=1,2 HPR=1,,3 leftMotor.Resistance=-4 }\nRobot r { Config=Nobody }\n"));
        fixture.selection.select("robot0");
        QCOMPARE(fixture.shown("Pos"), QStringLiteral("1,2"));
        fixture.type("Pos", QStringLiteral("1,2,3"));
        QVERIFY2(fixture.text().find("Pos=1,2,3") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.shown("Pos", "field2"), QStringLiteral("3"));
        QCOMPARE(fixture.shown("override.leftMotor.Resistance"), QStringLiteral("-4"));
        fixture.selection.select("r");
        QVERIFY(fixture.row("Config"));
        fixture.selection.select("robot0.nobody.at.all");
        QVERIFY(fixture.row("Tick")); // the panel shows the experiment, as without a selection, and reports it
        QCOMPARE(fixture.panel.findChild<QLineEdit*>(QStringLiteral("objectName"))->text(), QStringLiteral("Experiment"));
    }

    void membersOfAGridAreEditedTogether() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("Grid swarm { Config=Rover Count=2,2 Spacing=1 }\n"));
        fixture.selection.set({"swarm_1", "swarm_2"});
        QVERIFY(
            fixture.panel.findChild<QLabel*>(QStringLiteral("objectConfig"))->text().contains(QStringLiteral("One of swarm")));
        fixture.type("Spacing", QStringLiteral("2"), "field1");
        QVERIFY2(fixture.text().find("Spacing=1,2") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.panel.findChild<QPushButton*>(u"replaceBySingles"_qs)->text(), u"Replace by single instances"_qs);
        QTest::mouseClick(fixture.panel.findChild<QPushButton*>(QStringLiteral("replaceBySingles")), Qt::LeftButton);
        QVERIFY(fixture.text().find("Robot swarm_3") != std::string::npos);
    }

    void theSameInDarkness() {
        PropertiesFixture fixture;
        applyTheme(*qApp, ThemeKind::Dark);
        QVERIFY(fixture.open(kRobots));
        fixture.selection.select("robot0.leftMotor");
        fixture.field("Resistance")->setFocus();
        fixture.picture("dark");
        applyTheme(*qApp, ThemeKind::Light);
        QCOMPARE(fixture.shown("Resistance"), QStringLiteral("3"));
    }
};

QTEST_MAIN(PropertiesPanelTest)
#include "properties_panel_test.moc"
