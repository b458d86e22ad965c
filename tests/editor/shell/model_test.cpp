// The model editor with mouse and keyboard: a robot alone, with the tree, the rows, the views and the undo of the window.

#include <numbers>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/outline/outline_model.h"
#include "editor/outline/outline_view.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

const QByteArray kTeam = R"(Tick = 0.01
#import arenas/open_floor.sim
RobotConfig Rover {
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 }
    Box mast { Size=0.05,0.05,0.3 Pos=0,0,0.29 Mass=0.1 }
  }
}
Static arena { Config=OpenFloor }
Robot first { Config=Rover }
Robot second { Config=Rover Pos=1,0,0 }
PoseLog path { Robot=first File=path.csv }
)";

/// What buildRobot() writes, without its layout.
const QByteArray kBuilt =
    "#import common/materials.sim #import common/surfaces.sim RobotConfig MyRobot { "
    "Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 Material=blue Surface=plastic } } "
    "Body leftWheel { Pos=0.05,0.12,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 Material=black "
    "Surface=rubber } } "
    "Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 } "
    "RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 } "
    "Encoder leftEncoder { Joint=leftAxle CountsPerRevolution=512 } "
    "Body rightWheel { Pos=0.05,-0.12,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 Material=black "
    "Surface=rubber } } "
    "Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 } "
    "RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 } "
    "Encoder rightEncoder { Joint=rightAxle CountsPerRevolution=512 } "
    "Body foot { Pos=-0.1,0,0.02 Sphere ball { Radius=0.02 Mass=0.05 Material=darkgrey Surface=slick } } "
    "Fixed footHold { Parent=chassis Child=foot } "
    "DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.05 WheelSeparation=0.24 } "
    "} Robot robot0 { Config=MyRobot }";

} // namespace

class ModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        m_window = m_fixture.window();
        m_window->disableSettings();
        m_window->resize(1400, 900);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get())); // shortcuts work in the active window alone
    }
    void cleanup() { m_window.reset(); }

    void showsModelOfSelectedRobotAlone() {
        open(kTeam);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("second"));
        const auto views = m_window->viewport().views().viewStates();
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(title(), QStringLiteral("Editing Rover"));
        QCOMPARE(detail(), QStringLiteral("Every edit changes all 2 instances"));
        QCOMPARE(shownDetail(), detail()); // in two lines, as there is little room
        QCOMPARE(topRows(), QStringList{QStringLiteral("Rover")});
        QCOMPARE(selected(), QStringLiteral("RobotConfig.Rover"));
        QCOMPARE(shown(), QStringList({QStringLiteral("RobotConfig.Rover"), QStringLiteral("StaticConfig.TrundlePreviewFloor")}));
        QVERIFY(hand.press("modelDone"));
        QVERIFY(title().isEmpty());
        QVERIFY(topRows().contains(QStringLiteral("Objects"))); // a rover without joints and devices
        QCOMPARE(shown(), QStringList({QStringLiteral("first"), QStringLiteral("second"), QStringLiteral("arena")}));
        QCOMPARE(m_window->viewport().views().viewStates().front().camera.eye, views.front().camera.eye);
        QCOMPARE(text(), kTeam);
    }

    void everyInstanceFollows() {
        open(kTeam);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("first"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        hand.look({1, -1.5, 1}, {0, 0, 0.1});
        hand.clickPoint({0.02, 0, 0.44}); // the top of the mast: first the body, then the geom
        QCOMPARE(selected(), QStringLiteral("RobotConfig.Rover.chassis"));
        hand.clickPoint({0.02, 0, 0.44});
        QCOMPARE(selected(), QStringLiteral("RobotConfig.Rover.chassis.mast"));
        hand.key(Qt::Key_Delete);
        QCOMPARE(text(), QByteArray(kTeam).replace("    Box mast { Size=0.05,0.05,0.3 Pos=0,0,0.29 Mass=0.1 }\n", ""));
        for (const RobotSpec& robot : m_window->document().loaded()->experiment->robots)
            QCOMPARE(robot.config->bodies[0].geoms.size(), std::size_t(1));
        QCOMPARE(title(), QStringLiteral("Editing Rover"));
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), kTeam);
        QVERIFY(shown().contains(QStringLiteral("RobotConfig.Rover")));
    }

    void insertsIntoModelWithoutSelection() {
        open(kTeam);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("first"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        hand.look({1, -1.5, 1}, {0, 0, 0.1});
        hand.clickPoint({0.8, 0.8, 0}); // the floor
        QCOMPARE(selected(), QString());
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Body")}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.Rover.body"));
        QVERIFY(title().startsWith(QStringLiteral("Editing")));
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), kTeam);
    }

    void newRobotModelIsOneEdit() {
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));
        QCOMPARE(title(), QStringLiteral("Editing MyRobot"));
        QCOMPARE(topRows(), QStringList{QStringLiteral("MyRobot")});
        QVERIFY2(isClean(), text().constData());
        QVERIFY2(text().contains("Robot robot0 { Config=MyRobot }"), text().constData());
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));
        QCOMPARE(title(), QStringLiteral("Editing MyRobot2"));
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
        QVERIFY(title().isEmpty()); // there is no model any more
    }

    void followsRenamedModel() {
        open(kTeam);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("first"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(hand.clickRow("RobotConfig.Rover"));
        hand.key(Qt::Key_F2);
        auto* line = m_window->findChild<QLineEdit*>(QStringLiteral("renameEditor"));
        QVERIFY(line);
        line->selectAll();
        QTest::keyClicks(line, QStringLiteral("Truck"));
        QTest::keyClick(line, Qt::Key_Return);
        EVENTUALLY(title() == QStringLiteral("Editing Truck"));
        QCOMPARE(topRows(), QStringList{QStringLiteral("Truck")});
        m_window->viewport().views().current().setFocus();
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(title(), QStringLiteral("Editing Rover"));
        QCOMPARE(text(), kTeam);
    }

    /// A model that came with the program is read-only: the edit makes a copy, which is shown from then on.
    void editOfShippedModelContinuesInItsCopy() {
        const QByteArray before = "#import robots/simple_robot.sim\nRobot robot0 { Config=SimpleRobot }\n";
        open(before);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("robot0"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(title(), QStringLiteral("Editing SimpleRobot"));
        QVERIFY2(detail().contains(QStringLiteral("makes a copy")), qPrintable(detail()));
        QVERIFY(hand.clickRow("RobotConfig.SimpleRobot.chassis.slider"));
        hand.key(Qt::Key_Delete);
        QVERIFY2(text() != before, text().constData());
        QVERIFY2(title() != QStringLiteral("Editing SimpleRobot") && title().startsWith(QStringLiteral("Editing SimpleRobot")),
                 qPrintable(title()));
        QCOMPARE(topRows().size(), 1);
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), before);
        QCOMPARE(title(), QStringLiteral("Editing SimpleRobot"));
    }

    void errorInTheTextKeepsTheModel() {
        open(kTeam);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("first"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        const std::string file = m_window->document().texts().files().front();
        QVERIFY(
            m_window->document().edits().replaceText({}, file, QByteArray(kTeam).replace("RobotConfig R", "R").toStdString()));
        QCOMPARE(title(), QStringLiteral("Editing Rover"));
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(topRows(), QStringList{QStringLiteral("Rover")});
        QVERIFY(shown().contains(QStringLiteral("RobotConfig.Rover")));
    }

    /// From nothing, without a word typed; the text is that of an expert.
    void differentialRobotFromEmptyFile() {
        const WindowHand hand(*m_window);
        buildRobot(hand);
        WindowFixture::savePicture(*m_window, "model_built");
        const QByteArray built = text();
        QCOMPARE(built.simplified(), kBuilt);
        QVERIFY2(isClean(), built.constData());
        const Diagnostics& problems = m_window->document().loaded()->diagnostics;
        QVERIFY2(problems.all().empty(), problems.all().empty() ? "" : problems.all().front().message.c_str());
        QStringList gestures;
        for (const auto& entry : m_window->document().edits().history().entries()) gestures += entry.name;
        QCOMPARE(gestures.join(u','),
                 QStringLiteral("New Robot Model,Insert Driven wheel,Insert Driven wheel,Insert Slider,Add DifferentialDrive"));
        for (int i = 0; i < 5; ++i) hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
        for (int i = 0; i < 5; ++i) hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(text(), built);
    }

    /// The keys drive it on a plain floor; nothing of that is in the document.
    void testDriveLeavesNoTrace() {
        const WindowHand hand(*m_window);
        buildRobot(hand);
        const auto* sensors = m_window->findChild<QWidget*>(QStringLiteral("sensors"));
        QVERIFY(sensors && !sensors->isVisible());
        const auto* problems = m_window->findChild<QWidget*>(QStringLiteral("dock.problems"));
        QVERIFY(problems && !problems->visibleRegion().isEmpty());
        QVERIFY(hand.press("modelDrive"));
        RunSession& session = m_window->session();
        EVENTUALLY(session.state() == RunState::Running);
        QCOMPARE(title(), QStringLiteral("Driving MyRobot"));
        const auto place = [&] { return session.robots().pose("RobotConfig.MyRobot").value_or(Pose()).position; };
        hand.keyDown(Qt::Key_W);
        EVENTUALLY(place().x() > 0.5);
        hand.keyUp(Qt::Key_W);
        QVERIFY2(std::abs(place().y()) < 0.005, QByteArray::number(place().y()));
        hand.keyDown(Qt::Key_Left);
        const auto turned = [&] { return hprFromRotation(session.robots().pose("RobotConfig.MyRobot")->rotation).x(); };
        EVENTUALLY(turned() > 0.5);
        hand.keyUp(Qt::Key_Left);
        WindowFixture::savePicture(*m_window, "test_drive");
        QVERIFY(m_window->actions().at("view.overlayBeams").isChecked());
        QVERIFY(sensors->isVisible());
        QVERIFY(hand.press("modelDrive"));
        QCOMPARE(session.state(), RunState::Start);
        QCOMPARE(title(), QStringLiteral("Editing MyRobot"));
        QVERIFY(!m_window->actions().at("sim.drive").isChecked());
        QVERIFY(!m_window->actions().at("view.overlayBeams").isChecked());
        QVERIFY(!sensors->isVisible());
        EVENTUALLY(!problems->visibleRegion().isEmpty());
        QCOMPARE(m_window->viewport().views().current().camera().free().kind(), ViewKind::Perspective); // not that of the drive
        QCOMPARE(text().simplified(), kBuilt);
        QCOMPARE(m_window->document().edits().history().entries().size(), std::size_t(5));
    }

    /// Ahead of it is a ramp of the chosen slope; the next drive, begun on the floor, has none.
    void testDriveOnARamp() {
        const WindowHand hand(*m_window);
        buildRobot(hand);
        const QByteArray built = text();
        const auto ground = [&](const char* name) {
            return hand.choose({QStringLiteral("Simulation"), QStringLiteral("Test Drive Ground"), QString::fromUtf8(name)});
        };
        QVERIFY(ground("Ramp of 10°"));
        QVERIFY(hand.press("modelDrive"));
        RunSession& session = m_window->session();
        EVENTUALLY(session.state() == RunState::Running);
        const auto pitch = [&] {
            return hprFromRotation(session.robots().pose("RobotConfig.MyRobot").value_or(Pose()).rotation).y();
        };
        hand.keyDown(Qt::Key_W);
        EVENTUALLY(std::abs(pitch() + std::numbers::pi / 18) < 0.01); // nose up
        WindowFixture::savePicture(*m_window, "test_drive_ramp");
        hand.keyUp(Qt::Key_W);
        QVERIFY(ground("Plain Floor")); // begins anew
        EVENTUALLY(session.state() == RunState::Running && session.results().experiment->statics.size() == 1);
        QCOMPARE(title(), QStringLiteral("Driving MyRobot"));
        QVERIFY(ground("Ramp of 30°"));
        EVENTUALLY(session.state() == RunState::Running && session.results().experiment->statics.size() == 2);
        QVERIFY(hand.press("modelDrive"));
        QCOMPARE(session.state(), RunState::Start);
        QCOMPARE(session.source().shown()->statics.size(), std::size_t(1));
        QCOMPARE(text(), built);
    }

    /// The same robot in an experiment: an arena and a controller from the Library, then Run.
    void builtRobotDrivesAMetre() {
        const WindowHand hand(*m_window);
        buildRobot(hand);
        QVERIFY(hand.press("modelDone"));
        QVERIFY(hand.dragToPoint(QStringLiteral("OpenFloor"), {0.6, 0.6, 0}));
        EVENTUALLY(text().contains("Config=OpenFloor"));
        QVERIFY(hand.press("librarySection.4")); // Controllers: opens the section
        QVERIFY(hand.dragToPoint(QStringLiteral("LinearMotion"), {0, 0, 0.14}));
        EVENTUALLY(text().contains("LinearMotion"));
        QVERIFY2(isClean(), text().constData());
        RunSession& session = m_window->session();
        for (int i = 0; i < 12; ++i) hand.key(Qt::Key_BracketRight, Qt::ControlModifier); // as fast as possible
        const Vec3 from = m_window->document().loaded()->experiment->robots[0].pose.position;
        hand.key(Qt::Key_F5);
        EVENTUALLY(session.results().time() > 20);
        hand.key(Qt::Key_F6);
        const double way = (session.robots().pose("robot0")->position - from).norm();
        QVERIFY2(std::abs(way - 1) < 0.01, QByteArray::number(way));
    }

    void sceneryHasAModelToo() {
        open("StaticConfig Yard {\n  Box wall { Size=0.4,0.4,0.4 Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard Pos=3,0,0 }\n");
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("yard"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(title(), QStringLiteral("Editing Yard"));
        QCOMPARE(shown(), QStringList{QStringLiteral("StaticConfig.Yard")});
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(title().isEmpty());
    }

    void asksForASelection() {
        open("Tick = 0.01\n");
        const WindowHand hand(*m_window);
        m_window->viewport().views().current().setFocus();
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(title().isEmpty());
        QVERIFY(!m_window->actions().at("model.edit").isChecked());
        QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("Select the robot")));
    }

    /// What joins robots is not in the model of one.
    void showsModelOfARobotThatIsJoinedToAnother() {
        open(QByteArray(kTeam) + "Spring rope { Parent=first.chassis Child=second.chassis Stiffness=10 }\n"
                                 "Ball hitch { Parent=first.chassis Child=second.chassis Anchor=0.5,0,0.1 }\n"
                                 "Region goal { Pos=1,0,0.2 Size=1,1,1 Robots=second }\nNoContact=first,second\n");
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("second"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(shown(), QStringList({QStringLiteral("RobotConfig.Rover"), QStringLiteral("StaticConfig.TrundlePreviewFloor")}));
        QVERIFY(!m_window->grab().isNull()); // paints springs, joints and regions
        m_window->session().setSpeed(0);
        m_window->session().step();
        EVENTUALLY(m_window->session().results().time() > 0);
        QVERIFY(!m_window->grab().isNull());
        m_window->session().reset();
    }

    /// Select All takes what is in the model, not what the experiment has beside it.
    void selectsAllOfTheModel() {
        open(QByteArray(kTeam).replace("RobotConfig Rover {\n",
                                       "RobotConfig Rover {\n  Body arm { Pos=0,0,0.5 Box beam { Size=0.1,0.1,0.1 Mass=1 } }\n"));
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("second"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(hand.clickRow("RobotConfig.Rover"));
        hand.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(m_window->selection().paths(), (std::vector<std::string>{"RobotConfig.Rover.arm", "RobotConfig.Rover.chassis"}));
        QVERIFY(hand.press("modelDone"));
        QVERIFY(hand.clickRow("second"));
        hand.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(m_window->selection().paths(), (std::vector<std::string>{"first", "second", "arena"}));
    }

private:
    /// Chassis, two driven wheels, a slider and a drive, by menu and mouse.
    void buildRobot(const WindowHand& hand) {
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
        EVENTUALLY(m_window->isSettled()); // the Library has read its folders
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));
        hand.look({0.4, 1, 0.7}, {0, 0, 0.08});
        QVERIFY(hand.dragToPoint(QStringLiteral("Driven wheel"), {0.052, 0.1, 0.07}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.MyRobot.leftWheel"));
        hand.look({0.4, -1, 0.7}, {0, 0, 0.08});
        QVERIFY(hand.dragToPoint(QStringLiteral("Driven wheel"), {0.06, -0.1, 0.09}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.MyRobot.rightWheel"));
        QVERIFY(hand.dragToPoint(QStringLiteral("Slider"), {-0.11, 0.01, 0.14}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.MyRobot.foot"));
        QVERIFY(hand.choose(
            {QStringLiteral("Insert"), QStringLiteral("Sensors and Actuators"), QStringLiteral("DifferentialDrive")}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.MyRobot.base"));
    }
    void open(const QByteArray& text) {
        QFile file(m_folder.filePath(QStringLiteral("team.sim")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        QVERIFY(m_window->document().opening().open(file.fileName().toStdString()).ok());
    }
    QByteArray text() const {
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().texts().files().front()));
    }
    /// Without errors, and as the formatter would write it.
    bool isClean() const {
        return !m_window->document().loaded()->diagnostics.hasErrors() &&
               format(*m_window->document().loaded()->trees[0]) == text().toStdString();
    }
    QString title() const {
        auto* bar = m_window->findChild<QWidget*>(QStringLiteral("modelBar"));
        return bar->isVisible() ? bar->findChildren<QLabel*>().at(0)->text() : QString();
    }
    const QLabel& detailLabel() const {
        return *m_window->findChild<QWidget*>(QStringLiteral("modelBar"))->findChildren<QLabel*>().at(1);
    }
    QString detail() const { return detailLabel().toolTip(); }
    QString shownDetail() const { return detailLabel().text(); }
    QString selected() const { return QString::fromStdString(m_window->selection().current()); }
    QStringList topRows() const {
        auto* model = m_window->findChild<OutlineView*>()->model();
        QStringList rows;
        for (int row = 0; row < model->rowCount(); ++row) rows += model->index(row, 0).data().toString();
        return rows;
    }
    QStringList shown() const {
        const ObjectIndex& objects = *m_window->viewport().world().objects();
        QStringList paths;
        for (const ObjectRef& object : objects.instances()) paths += QString::fromStdString(objects.pathOf(object));
        return paths;
    }

    WindowFixture m_fixture;
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(ModelTest)
#include "model_test.moc"
