#include "eventually.h"
#include "panel_desk.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QCompleter>
#include <QFileDialog>
#include <QToolButton>

#include "editor/properties/param_help.h"

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
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        const auto tip = [&desk](const char* id) { return desk.row(id)->findChild<QLabel*>(QStringLiteral("label"))->toolTip(); };
        for (const char* path : {"robot0", "RobotConfig.Rover"}) { // where it is set and where it is declared
            desk.selection.select(path);
            QVERIFY2(tip("param.wheelRadius").endsWith(QStringLiteral("\nof both")), qPrintable(tip("param.wheelRadius")));
            QCOMPARE(tip("param.track"), QStringLiteral("track"));
        }
        const auto loaded = desk.document.loaded();
        QCOMPARE(paramHelp(*loaded, "robot0.wheelRadius"), QStringLiteral("of both"));
        QCOMPARE(paramHelp(*loaded, "robot0.nothing"), QString());
        std::string rover = desk.rover();
        rover.replace(rover.find("  Param track"), 0, "  // Between the wheels,\n  // in metres.\n");
        QVERIFY(desk.document.replaceText(QStringLiteral("Type"), desk.document.files()[1], rover).ok());
        QCOMPARE(paramHelp(*desk.document.loaded(), "RobotConfig.Rover.track"), QStringLiteral("Between the wheels, in metres."));
    }

    void draggingALabelIsOneEntry() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        const std::string before = desk.text();
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
        drag(desk.row("Resistance")->findChild<QWidget*>(QStringLiteral("label")), 30);
        QCOMPARE(desk.text(), replaced(before, "Resistance=3", "Resistance=4"));
        QCOMPARE(desk.document.history().entries().size(), 1u);
        drag(desk.row("Resistance")->findChild<QWidget*>(QStringLiteral("label")), 30);
        QCOMPARE(desk.document.history().entries().size(), 2u);
        desk.document.undo();
        desk.document.undo();
        QCOMPARE(desk.text(), before);
        // one axis of a vector, the unit stays
        desk.type("Resistance", QStringLiteral("3"));
        desk.selection.select("robot0");
        desk.type("Pos", QStringLiteral("12 cm"), "field0");
        drag(desk.row("Pos")->findChild<QWidget*>(QStringLiteral("axis0")), 30);
        QVERIFY2(desk.text().find("Pos=22 cm, 0, 0.5") != std::string::npos, desk.text().c_str());
    }

    void numbersThatAreTooLongForTheirColumnsStandOneBelowTheOther() {
        PanelDesk desk;
        QVERIFY(desk.open(replaced(kRobots, "Pos=1,2,0", "Pos=0.473219,0.5,-0.000039")));
        const auto stacked = [&](const char* id) {
            return desk.field(id, "field0")->geometry().bottom() < desk.field(id, "field1")->geometry().top();
        };
        const auto whole = [&](const char* id) {
            return desk.field(id, "field0")->wholeWidth() <= desk.field(id, "field0")->width() &&
                   desk.field(id, "field2")->wholeWidth() <= desk.field(id, "field2")->width();
        };
        desk.selection.select("robot0");
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
        desk.selection.select("robot1");
        EVENTUALLY(stacked("Pos") && whole("Pos"));
        QVERIFY(!stacked("HPR"));
        desk.picture("long");
        desk.panel.resize(700, 900);
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
        desk.panel.resize(340, 900);
        EVENTUALLY(stacked("Pos") && whole("Pos"));
        desk.selection.select("robot0");
        EVENTUALLY(!stacked("Pos") && whole("Pos"));
    }

    void aListThatIsNotGivenYet() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("RobotConfig.Rover.leftAxle");
        desk.type("Anchor", QStringLiteral("5 cm"), "field1");
        QVERIFY2(desk.rover().find("Anchor=0,5 cm,0") != std::string::npos, desk.rover().c_str());
        desk.selection.select("RobotConfig.Rover.chassis");
        desk.type("Inertia", QStringLiteral("0.5"), "field0");
        QVERIFY2(desk.rover().find("Inertia=0.5,0.5,0.5") != std::string::npos, desk.rover().c_str());
        desk.type("Inertia", QStringLiteral("0.01"), "field3"); // of the products one brings the others
        desk.type("Inertia", QString(), "field5");
        QVERIFY(desk.field("Inertia", "field0"));
    }

    void arrowKeysStep() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        QTest::keyClick(desk.field("Resistance"), Qt::Key_Up);
        QVERIFY(desk.text().find("Resistance=3.1") != std::string::npos);
        QTest::keyClick(desk.field("Resistance"), Qt::Key_PageDown);
        QVERIFY(desk.text().find("Resistance=2.1") != std::string::npos);
        desk.selection.select("Surface.rubber");
        for (int i = 0; i < 30; ++i)
            QTest::keyClick(desk.field("Restitution"), Qt::Key_PageDown); // down to the limit and no further
        QCOMPARE(desk.shown("Restitution"), QStringLiteral("0"));
        QVERIFY(!desk.field("Restitution")->refused());
    }

    void choosingAColour() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("Material.red");
        const std::string before = desk.rover();
        auto* swatch = desk.field<QToolButton>("ColorRGB", "swatch");
        QTest::mouseClick(swatch, Qt::LeftButton);
        auto* dialog = desk.panel.findChild<QColorDialog*>();
        QVERIFY(dialog);
        dialog->setCurrentColor(QColor::fromRgbF(0.0f, 1.0f, 0.0f));
        QCOMPARE(desk.rover(), replaced(before, "0.9, 0.1, 0.1", "0,1,0"));
        dialog->setCurrentColor(QColor::fromRgbF(0.0f, 0.0f, 1.0f));
        dialog->accept();
        QCOMPARE(desk.rover(), replaced(before, "0.9, 0.1, 0.1", "0,0,1"));
        QCOMPARE(desk.document.history().entries().size(), 1u);
        desk.picture("colour");
        desk.document.undo();
        QCOMPARE(desk.rover(), before);
        QTest::mouseClick(swatch, Qt::LeftButton);
        EVENTUALLY(desk.panel.findChildren<QColorDialog*>().size() >= 1);
        dialog = desk.panel.findChildren<QColorDialog*>().back();
        dialog->setCurrentColor(Qt::black);
        dialog->reject();
        QCOMPARE(desk.rover(), before);
    }

    void choicesFlagsAndReferences() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        auto* solver = desk.field<QComboBox>("Solver");
        QVERIFY(solver);
        // A default is faint in its row; in the list one has to read the words, also on the accent colour.
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
        QVERIFY(desk.text().find("Solver = exact") != std::string::npos);
        desk.selection.select("RobotConfig.Rover.chassis.hull");
        QTest::mouseClick(desk.field<QCheckBox>("Collide"), Qt::LeftButton, {}, QPoint(6, 8));
        QVERIFY2(desk.rover().find("Collide=false") != std::string::npos, desk.rover().c_str());
        desk.picture("geom");
        auto* pick = desk.field<QToolButton>("Material", "pick");
        QVERIFY(pick);
        Q_EMIT pick->menu()->aboutToShow();
        QStringList names;
        for (const QAction* action : pick->menu()->actions()) names << action->text();
        QCOMPARE(names, QStringList({QStringLiteral("default"), QStringLiteral("grey"), QStringLiteral("red")}));
        pick->menu()->actions().at(2)->trigger();
        QVERIFY(desk.rover().find("Mass=2 Material=red") != std::string::npos);
        desk.selection.select("RobotConfig.Rover.touch");
        pick = desk.field<QToolButton>("Geom", "pick"); // a list: picking adds and takes out
        Q_EMIT pick->menu()->aboutToShow();
        pick->menu()->actions().at(1)->trigger();
        QVERIFY2(desk.rover().find("Geom=chassis.hull,leftWheel.tyre") != std::string::npos, desk.rover().c_str());
        Q_EMIT pick->menu()->aboutToShow();
        pick->menu()->actions().at(0)->trigger();
        QVERIFY(desk.rover().find("Geom=leftWheel.tyre") != std::string::npos);
        desk.type("Geom", QStringLiteral("nobody"));
        QVERIFY(desk.field("Geom")->refused());
        desk.selection.select("path");
        pick = desk.field<QToolButton>("Robot", "pick");
        Q_EMIT pick->menu()->aboutToShow();
        QCOMPARE(pick->menu()->actions().size(), 2);
    }

    void textsAreQuotedWhereTheyMust() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        for (const char* title :
             {"plain", "two words", "3 wheels", "say \"hi\"", "true", "a\\b c", "a//b", "10 %", "Köln {}", " lead"}) {
            desk.type("Title", QString::fromUtf8(title));
            QVERIFY2(!desk.field("Title")->refused(), title);
            QCOMPARE(desk.shown("Title"), QString::fromUtf8(title));
            QCOMPARE(QString::fromStdString(desk.document.loaded()->experiment->settings.title), QString::fromUtf8(title));
        }
        QVERIFY(desk.text().find("Title = \" lead\"") != std::string::npos);
    }

    void aFileIsNamedAsTheTextWantsIt() {
        PanelDesk desk;
        desk.write("textures/wood.png", "x");
        QVERIFY(desk.open(kRobots));
        desk.selection.select("Material.red");
        QTest::mouseClick(desk.field<QToolButton>("Texture", "browse"), Qt::LeftButton);
        auto* dialog = desk.panel.findChild<QFileDialog*>();
        QVERIFY(dialog);
        Q_EMIT dialog->fileSelected(QString::fromStdString(desk.write("textures/wood.png", "x")));
        dialog->reject();
        QVERIFY2(desk.rover().find("Texture = textures/wood.png") != std::string::npos ||
                     desk.rover().find("Texture=textures/wood.png") != std::string::npos,
                 desk.rover().c_str());
    }

    void aNameFromTheListOfWhatFits() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("RobotConfig.Rover.leftMotor");
        auto* field = desk.field("Joint");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("right"));
        auto* list = field->completer()->popup();
        EVENTUALLY(list->isVisible());
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        QVERIFY2(desk.rover().find("RotaryMotor leftMotor { Joint=rightAxle") != std::string::npos, desk.rover().c_str());
        QVERIFY(!list->isVisible());
    }

    void editingAsText() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        QVERIFY(desk.choose("Solver", "rowAsText"));
        desk.type("Solver", QStringLiteral("quick"));
        QVERIFY(desk.text().find("Solver = quick") != std::string::npos);
        QVERIFY(desk.choose("Solver", "rowAsText"));
        QVERIFY(desk.field<QComboBox>("Solver"));
    }

    void anOverrideSaysWhatItReplaces() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        desk.selection.select("robot0.leftMotor");
        desk.picture("override_row");
        const auto words = [&desk](const char* id) {
            const auto* label = desk.field<QLabel>(id, "override");
            return label && label->isVisible() ? label->text() : QString();
        };
        QVERIFY2(words("Resistance").contains(QStringLiteral("override here; Rover has 2 ohm")), qPrintable(words("Resistance")));
        QVERIFY(words("MaxVoltage").isEmpty()); // the config's own
        Q_EMIT desk.field<QLabel>("Resistance", "override")->linkActivated(QStringLiteral("push"));
        QVERIFY(desk.rover().find("leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=3") != std::string::npos);
        QVERIFY(desk.text().find("Resistance") == std::string::npos);
        QVERIFY(words("Resistance").isEmpty());
        desk.document.undo();
        Q_EMIT desk.field<QLabel>("Resistance", "override")->linkActivated(QStringLiteral("reset"));
        QVERIFY(desk.rover().find("Resistance=3") == std::string::npos);
        QVERIFY(desk.text().find("Resistance") == std::string::npos);
        desk.document.undo();
        desk.selection.set({"robot0.leftMotor", "robot1.leftMotor"});
        QVERIFY2(words("Resistance").contains(QStringLiteral("override in 1 of 2")), qPrintable(words("Resistance")));
        desk.selection.select("robot0");
        desk.type("param.track", QStringLiteral("0.3"));
        QVERIFY2(words("param.track").contains(QStringLiteral("Rover has 0.25")), qPrintable(words("param.track")));
    }

    /// Before anything is changed the header says where it goes.
    void theHeaderSaysWhereAChangeGoes() {
        PanelDesk desk;
        QVERIFY(desk.open(kRobots));
        const auto header = [&desk] {
            QString all;
            for (const QLabel* label : desk.panel.findChildren<QLabel*>())
                if (label->isVisible() && label->textFormat() == Qt::RichText) all += label->text() + QLatin1Char('\n');
            return all;
        };
        desk.selection.select("robot0.leftMotor");
        QVERIFY2(header().contains(QStringLiteral("become overrides of robot0 in main.sim")), qPrintable(header()));
        desk.selection.select("RobotConfig.Rover.leftMotor");
        QVERIFY2(header().contains(QStringLiteral("for all 2 instances of Rover")), qPrintable(header()));
        const std::string one = std::string(kRoverFile) + "Robot only { Config=Rover }\n";
        QVERIFY(desk.document.open(desk.write("one.sim", one)).ok());
        desk.selection.select("only.leftMotor");
        EVENTUALLY(header().contains(QStringLiteral("go into Rover in one.sim: only only is made from it")));
        desk.picture("header_config");
        desk.type("Resistance", QStringLiteral("7"));
        QCOMPARE(desk.text(), replaced(one, "Resistance=2", "Resistance=7"));
    }
};

QTEST_MAIN(PropertyEditorsTest)
#include "property_editors_test.moc"
