// The transport bar (run, pause, step, reset, speed) and driving a robot with the arrow keys.
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QtTest>

#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/running/panels/keyboard_drive.h"
#include "editor/running/panels/run_status.h"
#include "editor/running/panels/speeds.h"
#include "editor/running/panels/transport_bar.h"
#include "editor/running/session_fixture.h"
#include "editor/widgets/actions.h"
#include "eventually.h"

using namespace trundle;

namespace {

constexpr ActionRow kRows[] = {
    {"sim.run", "", "Run", "run", "F5", "Run."},
    {"sim.pause", "", "Pause", "pause", "F6", "Pause."},
    {"sim.step", "", "Single Tick", "step", "F10", "Tick."},
    {"sim.reset", "", "Reset", "reset", "", "Reset."},
    {"sim.faster", "", "Faster", "", "", "Faster."},
    {"sim.slower", "", "Slower", "", "", "Slower."},
    {"sim.keepPoses", "", "Keep", "", "", "Keep."},
    {"sim.drive", "", "Drive", "drive", "", "Drive.", true},
    {"model.drive", "", "Test Drive", "drive", "", "Drive the model.", true},
};

} // namespace

class TransportTest : public QObject {
    Q_OBJECT

    static QString label(const QWidget& bar, const char* name) { return bar.findChild<QLabel*>(QLatin1String(name))->text(); }

private Q_SLOTS:
    /// An object is placed and kept by its config frame, while its signal `pose` is about the centre of mass.
    void placesAndKeepsAPausedBall() {
        SessionFixture o;
        QVERIFY(o.open("Tick=0.01 Duration=1\nRobotConfig Ball { Body body { Sphere s { Pos=0,0,0.1 Radius=0.1 Mass=1 } } }\n"
                       "StaticConfig Floor { Plane floor { } }\nStatic arena { Config=Floor }\nRobot ball { Config=Ball "
                       "Pos=0,0,0 HPR=0,0,0 }\n"));
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        const auto at = [&](const char* path) -> Vec3 {
            const auto& shot = *o.session.results().snapshot;
            return Vec3(shot.block->slots().data() + o.session.results().layout->find(path)->offset);
        };
        QVERIFY((at("ball/pose") - Vec3(0, 0, 0.1)).norm() < 1e-3);
        QVERIFY(o.session.robots().pose("ball")->position.norm() < 1e-3);
        QVERIFY(o.session.robots().place("ball", {{2, 3, 0}, rotationFromHpr({0, 0, M_PI / 2})})); // lies on its side
        QVERIFY((at("ball/pose") - Vec3(2, 2.9, 0)).norm() < 1e-3);
        QVERIFY((at("ball/body/pose") - Vec3(2, 3, 0)).norm() < 1e-3);
        o.session.robots().keepPoses();
        QVERIFY((o.document.loaded()->experiment->robots[0].pose.position - Vec3(2, 3, 0)).norm() < 1e-9);
    }

    /// What is joined is shown where the next tick has it, and what a joint holds to the world is refused at once.
    void placesAPausedTrain() {
        SessionFixture o;
        QVERIFY(o.open("Tick=0.01 Gravity=0,0,0\nRobotConfig Car { Body body { Sphere s { Radius=0.1 Mass=1 } } }\n"
                       "Robot a { Config=Car Pos=0,0,0 }\nRobot b { Config=Car Pos=1,0,0 }\n"
                       "Ball hitch { Parent=a.body Child=b.body }\nRobot c { Config=Car Pos=0,5,0 }\nFixed hold { Parent=world "
                       "Child=c.body }\n"));
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        const auto isAt = [&](const char* robot, double x) {
            const auto& shot = *o.session.results().snapshot;
            for (const char* signal : {"/pose", "/body/pose"}) {
                const auto entry = o.session.results().layout->find(std::string(robot) + signal);
                if (!entry || std::abs(shot.block->slots()[entry->offset] - x) > 1e-6) return false;
            }
            return std::abs(o.session.robots().pose(robot)->position.x() - x) < 1e-6;
        };
        QVERIFY(isAt("a", 0) && isAt("b", 1));
        QVERIFY(o.session.robots().place("a", {{2, 0, 0}, Quat::Identity()}));
        QVERIFY(isAt("a", 2) && isAt("b", 3));
        QVERIFY(o.session.robots().place("b", {{3, 0, 0}, Quat::Identity()}));
        QVERIFY(isAt("a", 2) && isAt("b", 3));
        QVERIFY(o.session.robots().place("a", {{4, 0, 0}, Quat::Identity()}));
        QVERIFY(isAt("a", 4) && isAt("b", 5));
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        QVERIFY(!o.session.robots().place("c", {{3, 0, 0}, Quat::Identity()}));
        QCOMPARE(refused[0][0].toString(), QStringLiteral("c cannot be placed: hold holds c to the world."));
        o.session.step();
        EVENTUALLY_EQUAL(o.tick(), 2u);
        QVERIFY(isAt("a", 4) && isAt("b", 5) && isAt("c", 0));
    }

    void buttonsRunPauseStepAndReset() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        Actions actions(kRows);
        TransportBar bar(o.session, actions);
        bar.show();
        const auto click = [&](const char* name) {
            QTest::mouseClick(bar.findChild<QToolButton*>(QLatin1String(name)), Qt::LeftButton);
        };
        o.session.setSpeed(0);
        QCOMPARE(label(bar, "transportState"), QStringLiteral("At start"));
        QVERIFY(!actions.at("sim.reset").isEnabled());
        click("transportRun");
        EVENTUALLY_EQUAL(label(bar, "transportState"), QStringLiteral("Running"));
        EVENTUALLY(o.session.results().time() > 0.1);
        EVENTUALLY(label(bar, "transportFactor").endsWith(u'×'));
        click("transportRun"); // the button pauses now
        EVENTUALLY_EQUAL(label(bar, "transportState"), QStringLiteral("Paused"));
        const double there = o.session.results().time();
        click("transportStep");
        EVENTUALLY_EQUAL(label(bar, "transportTime"), timeText(there + 0.01));
        click("transportReset");
        QCOMPARE(label(bar, "transportState"), QStringLiteral("At start"));
        QCOMPARE(label(bar, "transportTime"), QStringLiteral("t = 0.00 s"));
    }

    void reportsWhyItCannotRun() {
        SessionFixture o;
        Actions actions(kRows);
        TransportBar bar(o.session, actions);
        QVERIFY(!actions.at("sim.run").isEnabled()); // no document is open
        QVERIFY(o.open("Robot robot0 { Config=Nobody }\n"));
        QVERIFY(actions.at("sim.run").isEnabled());
        QCOMPARE(label(bar, "transportState"), QStringLiteral("Cannot run"));
        QVERIFY(bar.findChild<QToolButton*>(QStringLiteral("transportRun"))->toolTip().contains(QStringLiteral("Nobody")));
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        actions.at("sim.run").trigger();
        QCOMPARE(refused.size(), 1);
        QVERIFY(o.document.edits().replaceText(QStringLiteral("Fix"), o.document.path(), kStandingRobot.toStdString()).ok());
        QCOMPARE(label(bar, "transportState"), QStringLiteral("At start"));
    }

    void aTextThatOnlyDescribesIsNoMistake() {
        SessionFixture o;
        Actions actions(kRows);
        TransportBar bar(o.session, actions);
        QVERIFY(o.open("Surface rubber { Friction=1 }\nMaterial grey { }\n"
                       "StaticConfig Yard { Box { Size=1,1,1 Material=grey Surface=rubber } }\n"));
        QCOMPARE(label(bar, "transportState"), QStringLiteral("Nothing to run"));
        o.session.run();
        QVERIFY(o.session.state() == RunState::Start);
    }

    void changesSpeedInSteps() {
        SessionFixture o;
        Actions actions(kRows);
        TransportBar bar(o.session, actions);
        auto* speed = bar.findChild<QComboBox*>(QStringLiteral("transportSpeed"));
        QCOMPARE(speed->currentText(), QStringLiteral("1×"));
        QCOMPARE(speed->count(), 8);
        actions.at("sim.faster").trigger();
        QCOMPARE(o.session.speed(), 2.0);
        QCOMPARE(speed->currentText(), QStringLiteral("2×"));
        for (int i = 0; i < 5; ++i) actions.at("sim.faster").trigger();
        QCOMPARE(o.session.speed(), 0.0);
        QCOMPARE(speed->currentText(), QStringLiteral("max"));
        QVERIFY(!actions.at("sim.faster").isEnabled());
        for (int i = 0; i < 9; ++i) actions.at("sim.slower").trigger();
        QCOMPARE(o.session.speed(), 0.1);
        QVERIFY(!actions.at("sim.slower").isEnabled());
    }

    void formatsTimesAndFactors() {
        QCOMPARE(timeText(12.3456), QStringLiteral("t = 12.35 s"));
        QCOMPARE(timeText(3725.5), QStringLiteral("t = 1:02:05.5"));
        QCOMPARE(factorText(0.5), QStringLiteral("0.50×"));
        QCOMPARE(factorText(1), QStringLiteral("1.0×"));
        QCOMPARE(factorText(41.4), QStringLiteral("41×"));
    }

    void theStatusNamesRobotsAndContacts() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        RunStatus status(o.session);
        QVERIFY(status.text().isEmpty());
        o.session.step();
        o.session.step();
        EVENTUALLY_EQUAL(o.tick(), 2u);
        QVERIFY2(status.text().contains(QStringLiteral("1 robot  •  3 contacts")), qPrintable(status.text()));
        QVERIFY(o.document.structure().setValues(QStringLiteral("Tick"), {{"Tick", "0.02"}}).ok());
        QVERIFY(status.text().contains(QStringLiteral("wait for Reset")));
        o.session.reset();
        QVERIFY(status.text().isEmpty());
    }

    /// A key that is held during a reset counts no more: the next one alone says where to.
    void aResetForgetsTheKeysThatAreHeld() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        Actions actions(kRows);
        Selection selection;
        QWidget window;
        auto* view = new QWidget(&window);
        view->setFocusPolicy(Qt::StrongFocus);
        KeyboardDrive drive(o.session, selection, actions, window);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window, kTimeoutMs));
        view->setFocus();
        actions.at("sim.drive").setChecked(true);
        o.session.setSpeed(2);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        QTest::keyPress(view, Qt::Key_Up);
        EVENTUALLY(o.session.robots().pose("robot0")->position.x() > 0.1);
        o.session.reset();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Start);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        QTest::keyPress(view, Qt::Key_Left);
        EVENTUALLY(o.session.robots().pose("robot0")->rotation.z() > 0.3); // it turns
        QVERIFY2(o.session.robots().pose("robot0")->position.head<2>().norm() < 0.05, "and stays where it is");
        QTest::keyRelease(view, Qt::Key_Left);
        QCOMPARE(o.session.robots().driven(), std::string());
    }

    void arrowKeysDriveTheSelectedRobot() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        Actions actions(kRows);
        Selection selection;
        QWidget window;
        auto* field = new QLineEdit(&window);
        auto* view = new QWidget(&window);
        view->setFocusPolicy(Qt::StrongFocus);
        KeyboardDrive drive(o.session, selection, actions, window);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window, kTimeoutMs));
        view->setFocus();
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);

        QTest::keyPress(view, Qt::Key_Up); // driving is switched off
        QTest::keyRelease(view, Qt::Key_Up);
        QCOMPARE(refused.size(), 0);
        actions.at("sim.drive").setChecked(true);
        QTest::keyPress(view, Qt::Key_Up); // there is no run
        QTest::keyRelease(view, Qt::Key_Up);
        QCOMPARE(refused.size(), 1);

        selection.select("robot0.chassis");
        o.session.setSpeed(2); // as fast as possible it would hit a wall before the next key
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        QTest::keyPress(view, Qt::Key_Up);
        QCOMPARE(o.session.robots().driven(), std::string("robot0"));
        EVENTUALLY(o.session.robots().pose("robot0")->position.x() > 0.2);
        QTest::keyPress(view, Qt::Key_Left);
        EVENTUALLY(o.session.robots().pose("robot0")->position.y() > 0.05); // the left of a robot that faces +x
        QTest::keyRelease(view, Qt::Key_Left);
        QCOMPARE(o.session.robots().driven(), std::string("robot0"));
        QTest::keyRelease(view, Qt::Key_Up);
        QCOMPARE(o.session.robots().driven(), std::string());

        // With a single robot, that robot is driven without being selected.
        selection.select("arena");
        QTest::keyPress(view, Qt::Key_Down);
        QCOMPARE(o.session.robots().driven(), std::string("robot0"));
        QTest::keyRelease(view, Qt::Key_Down);

        // A text field keeps its arrow keys, and focusing it stops the driving.
        QTest::keyPress(view, Qt::Key_Up);
        field->setFocus();
        QCOMPARE(o.session.robots().driven(), std::string());
        QTest::keyPress(field, Qt::Key_Left);
        QCOMPARE(o.session.robots().driven(), std::string());
    }
};

QTEST_MAIN(TransportTest)
#include "transport_test.moc"
