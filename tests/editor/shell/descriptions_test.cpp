// What the whole window shows and offers, as text: tests/data/window. After an intended change run this test with
// TRUNDLE_WRITE_WINDOW_TEXTS=1 and review the difference.

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QSettings>
#include <QTreeView>
#include <QtTest>

#include "app/application.h"
#include "editor/document/structure_edits.h"
#include "editor/outline/outline_view.h"
#include "editor/shell/fixed_machine.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/widget_text.h"
#include "eventually.h"
#include "render/service.h"

using namespace trundle;

namespace {

const QString kHome = qEnvironmentVariable("TRUNDLE_DESCRIPTIONS_HOME"); // made by main()

const QByteArray kRover = "// Drives until the bumper touches the wall, backs off and turns.\n"
                          "Tick = 0.01   Duration = 60\n"
                          "#import robots/simple_robot.sim\n"
                          "#import arenas/medium_arena.sim\n"
                          "#loadModule controllers/bump_and_turn\n"
                          "\n"
                          "Static arena { Config=MediumArena }\n"
                          "Robot rover {\n"
                          "  Config=SimpleRobot\n"
                          "  Pos=0,0,0  HPR=150,0,0   // faces the far wall\n"
                          "  BumpAndTurn brain { Speed=0.3 BackOff=0.2 }\n"
                          "}\n"
                          "Robot second { Config=SimpleRobot Pos=1,1,0 BumpAndTurn brain { Speed=0.25 } }\n"
                          "PoseLog path { Robot=rover Interval=0.1 }\n";

/// One object of each kind that the tree shows.
const QByteArray kKinds =
    "Tick = 0.01   Duration = 5   Solver = auto\n"
    "#import common/materials.sim\n#import common/surfaces.sim\n"
    "Param size = 0.2\n"
    "Material paint { ColorRGB=0.2,0.4,0.6 Shininess=0.5 }\n"
    "Surface ice { Friction=0.05 Restitution=0.5 }\n"
    "RobotConfig Arm {\n"
    "  Param reach = 0.5\n"
    "  Body base { Box hull { Size=$size,0.3,0.1 Pos=0,0,0.05 Mass=2 Material=paint Surface=ice } }\n"
    "  Body upper { Pos=0,0,0.2 Cylinder tube { Radius=0.02 Length=$reach Mass=0.3 } Sphere knob { Radius=0.03 Mass=0.1 "
    "Pos=0,0,0.3 } }\n"
    "  Body finger { Pos=0.2,0,0.2 Capsule tip { Radius=0.01 Length=0.1 Mass=0.05 } }\n"
    "  Hinge elbow { Parent=base Child=upper Axis=0,1,0 Anchor=0,0,0.1 MinAngle=-90 MaxAngle=90 }\n"
    "  Slider slide { Parent=upper Child=finger Axis=1,0,0 }\n"
    "  RotaryMotor motor { Joint=elbow TorqueConstant=0.03 BackEmfConstant=0.03 Resistance=2 MaxVoltage=12 }\n"
    "  Encoder counts { Joint=elbow CountsPerRevolution=512 }\n"
    "  TouchSensor feel { Geom=finger.tip }\n"
    "  Camera eye { Body=base Pos=0.1,0,0.1 Resolution=64,48 }\n"
    "  Transceiver radio { Body=base }\n"
    "}\n"
    "StaticConfig Floor { Plane ground { Surface=ice } Box step { Size=1,1,0.1 Pos=3,0,0.05 } }\n"
    "Static floor { Config=Floor }\n"
    "Robot one { Config=Arm Pos=1,0,0 motor.Resistance=3 }\n"
    "Robot two { Config=Arm Pos=-1,0,0.5 HPR=45,0,0 }\n"
    "Grid team { Config=Arm Count=2,2 Spacing=2,2 Pos=0,5,0 }\n"
    "Scatter few { Config=Arm Count=3 Area=-5,-5,5,-4 }\n"
    "RadioMedium air { }\n"
    "View corner { Eye=3,3,2 Target=0,0,0 }\n"
    "Light lamp { Direction=0,0,-1 }\n"
    "PoseLog path { Robot=one }\n"
    "SignalLog all { Signals=\"one/*\" }\n"
    "VideoLog film { }\n";

} // namespace

class DescriptionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        applyTheme(*qApp, ThemeKind::Light);
        m_application = makeApplication();
        m_render = RenderService::startInBackground();
    }
    void init() {
        QSettings().clear();
        QDir(kHome + QStringLiteral("/project")).removeRecursively();
        write(QStringLiteral("rover.sim"), kRover);
        write(QStringLiteral("broken.sim"), QByteArray(kRover)
                                                .replace("SimpleRobot", "SimpelRobot")
                                                .replace("Speed=0.3", "Speed=fast")
                                                .replace("Interval=0.1", "Intervall=0.1"));
        write(QStringLiteral("kinds.sim"), kKinds);
    }
    void cleanup() { m_window.reset(); }

    void welcome() {
        QSettings().setValue(
            QStringLiteral("recentFiles"),
            QStringList{path(QStringLiteral("rover.sim")), path(QStringLiteral("broken.sim")), path(QStringLiteral("gone.sim"))});
        start();
        compare(QStringLiteral("welcome"), *m_window);
    }

    void edited() {
        start(QStringLiteral("rover.sim"));
        m_window->selection().select("rover");
        act("tool.move");
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move rover"), {{"rover.Pos", "-1.2,0.5,0"}}).ok());
        compare(QStringLiteral("edited"), *m_window);
    }

    void broken() {
        start(QStringLiteral("broken.sim"));
        m_window->selection().select("rover");
        act("problems.next");
        compare(QStringLiteral("broken"), *m_window);
    }

    void running() {
        start(QStringLiteral("rover.sim"));
        m_window->selection().select("rover");
        act("view.layoutRun");
        for (const char* overlay : {"view.overlayNames", "view.overlayTrails", "view.overlayContacts"}) act(overlay);
        m_window->session().runFor(0.1);
        EVENTUALLY(m_window->session().state() == RunState::Paused);
        compare(QStringLiteral("running"), *m_window, Numbers::Hidden);
    }

    /// The docks of an experiment with radios and cameras.
    void radiosAndCameras() {
        write(QStringLiteral("devices.sim"),
              "Tick = 0.01\n#import robots/camera_robot.sim\n#import robots/tmote_sky.sim\n"
              "#import arenas/open_floor.sim\n#loadModule controllers/mote\n"
              "Static floor { Config=OpenFloor }\nRobot seeing { Config=CameraRobot Pos=1,1,0 }\n"
              "Robot target { Config=TmoteSky Mote brain { Target=true Period=0.05 } }\n"
              "Grid motes { Config=TmoteSky Count=2 Pos=3,0,0 Spacing=2 Mote brain { Period=0.05 } }\n");
        start(QStringLiteral("devices.sim"));
        m_window->selection().select("motes_1");
        QString all;
        for (const char* name : {"dock.radios", "dock.cameras"}) {
            auto* dock = m_window->findChild<QDockWidget*>(QLatin1String(name));
            dock->show();
            dock->raise();
            settle();
            all += describedWidget(*dock->widget());
        }
        keep(QStringLiteral("radios-and-cameras"), all, Numbers::Hidden);
    }

    /// The Sensors dock before and during a run.
    void sensors() {
        write(QStringLiteral("sensors.sim"), "Tick = 0.01\n#import robots/lidar_robot.sim\n#import arenas/medium_arena.sim\n"
                                             "Static arena { Config=MediumArena }\nRobot scanner { Config=LidarRobot }\n");
        start(QStringLiteral("sensors.sim"));
        m_window->selection().set({"scanner.scan", "scanner.imu", "scanner.leftMotor"});
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("dock.sensors"));
        dock->show();
        dock->raise();
        settle();
        QString all = describedWidget(*dock->widget());
        m_window->session().runFor(0.1);
        EVENTUALLY(m_window->session().state() == RunState::Paused);
        settle();
        all += QStringLiteral("== paused\n") + describedWidget(*dock->widget());
        keep(QStringLiteral("sensors"), all, Numbers::Hidden);
    }

    /// The properties of one object of each kind, selected in the tree.
    void propertiesOfEachKind() {
        start(QStringLiteral("kinds.sim"));
        auto* tree = m_window->findChild<OutlineView*>();
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties"));
        QVERIFY(tree && dock);
        tree->expandAll();
        QString all;
        QSet<QString> seen;
        for (QModelIndex row = tree->model()->index(0, 0); row.isValid(); row = tree->indexBelow(row)) {
            tree->setCurrentIndex(row);
            QApplication::processEvents();
            const auto* kind = dock->findChild<QLabel*>(QStringLiteral("objectKind"));
            const QString what = kind ? kind->toolTip() : QString();
            if (seen.contains(what)) continue;
            seen.insert(what);
            all += QStringLiteral("== %1\n%2\n").arg(row.data().toString(), describedWidget(*dock->widget()));
        }
        keep(QStringLiteral("properties"), all, Numbers::Shown);
        compare(QStringLiteral("kinds-tree"), *m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene")));
    }

    void propertiesOfTwoRobots() {
        start(QStringLiteral("rover.sim"));
        m_window->selection().set({"rover", "second"});
        compare(QStringLiteral("properties-of-two"), *m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties")));
        m_window->selection().set({"rover", "path"});
        compare(QStringLiteral("properties-of-unlike"), *m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties")));
    }

private:
    void start(const QString& file = {}) {
        m_window = std::make_unique<MainWindow>(*m_application, m_render.get(), m_application->locations());
        m_window->setAnimated(false);
        m_window->resize(1100, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        if (file.isEmpty()) return;
        QVERIFY(m_window->open(path(file)));
        EVENTUALLY(m_window->document().isOpen());
    }
    void act(const char* id) { m_window->actions().at(id).trigger(); }
    void settle() {
        if (QWidget* focus = m_window->focusWidget()) focus->clearFocus();
        int still = 0; // consecutive checks without a new image
        EVENTUALLY((still = m_window->isSettled() ? still + 1 : 0) > 5);
    }
    void compare(const QString& name, const QWidget& widget, Numbers numbers = Numbers::Shown) {
        settle();
        QString text = describedWidget(widget);
        for (const auto* dock : widget.findChildren<QDockWidget*>()) // those behind other tabs
            if (!dock->isVisible() && m_window->document().isOpen())
                text += QStringLiteral("== %1\n%2").arg(dock->objectName(), describedWidget(*dock->widget()));
        keep(name, text, numbers);
    }
    static void keep(const QString& name, const QString& text, Numbers numbers) {
        const QString difference = differenceFromKept(name, text, kHome, numbers);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
    static QString path(const QString& file) { return kHome + QStringLiteral("/project/") + file; }
    static void write(const QString& file, const QByteArray& text) {
        QVERIFY(QDir().mkpath(kHome + QStringLiteral("/project")));
        QFile written(path(file));
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(text) == text.size());
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<MainWindow> m_window;
};

int main(int argc, char** argv) {
    const QTemporaryDir home;
    if (!home.isValid()) return 1;
    if (!qEnvironmentVariableIsSet("TRUNDLE_DESCRIPTIONS_HOME")) { // Qt and fontconfig read the environment once
        leaveTheMachineOut(home.path());
        qputenv("TRUNDLE_DESCRIPTIONS_HOME", home.path().toUtf8());
        QStringList arguments;
        for (int i = 1; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
        return QProcess::execute(QString::fromLocal8Bit(argv[0]), arguments);
    }
    QApplication application(argc, argv);
    DescriptionsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "descriptions_test.moc"
