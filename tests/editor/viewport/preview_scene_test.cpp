// Files that only contain configs: their robots and arenas are shown, selected and edited, and a robot runs on a floor that is
// not in the text.
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"
#include "project/edits/plans.h"

using namespace trundle;

namespace {

const QByteArray kRover = R"(// A rover.
RobotConfig Rover {
  Param high = 0.2
  Body chassis { Box hull { Size=0.4,0.4,$high Pos=0,0,0.1 Mass=2 } Box mast { Size=0.05,0.05,0.4 Pos=0,0,0.4 Mass=1 } }
}
)";
const QByteArray kYard = "StaticConfig Yard {\n  Box wall { Size=0.4,0.4,0.4 Pos=0,0,0.2 }\n}\n";

} // namespace

class PreviewSceneTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<ViewWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    void clicksGoIntoTheConfig() {
        open(kRover);
        QCOMPARE(selectedAt({0, 0, 0.5}), std::string("RobotConfig.Rover"));
        QCOMPARE(selectedAt({0, 0, 0.5}), std::string("RobotConfig.Rover.chassis"));
        QCOMPARE(selectedAt({0, 0, 0.5}), std::string("RobotConfig.Rover.chassis.mast"));
        QCOMPARE(m_window->text(), kRover);
        QVERIFY(!m_window->document.texts().isModified());
    }

    void draggingEditsConfig() {
        open(kRover);
        m_window->selection.select("RobotConfig.Rover.chassis.mast");
        m_window->trigger("tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Axis, 0});
        m_window->press(from);
        m_window->type(QStringLiteral("0.1"));
        m_window->key(Qt::Key_Return);
        m_window->release(from);
        QCOMPARE(m_window->text(), QByteArray(kRover).replace("Pos=0,0,0.4", "Pos=0.1,0,0.4"));
        QCOMPARE(selectedAt({0.1, 0, 0.5}), std::string("RobotConfig.Rover")); // drawn at its current pose
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRover);
    }

    void errorHidesOnlyItsBlock() {
        open(kRover);
        const ViewportScene& world = m_window->view().context().world;
        QVERIFY(world.find("RobotConfig.Rover.chassis.hull"));
        const QByteArray wrong = QByteArray(kRover).replace("Box hull", "Bxo hull");
        QVERIFY(m_window->document.edits().replaceText({}, m_window->document.texts().files()[0], wrong.toStdString()).ok());
        QVERIFY(world.find("RobotConfig.Rover.chassis.mast") && !world.find("RobotConfig.Rover.chassis.hull"));
        m_window->document.edits().undo();
        QVERIFY(world.find("RobotConfig.Rover.chassis.hull"));
    }

    void arrangesConfigsSideBySide() {
        open(kRover + kYard);
        QCOMPARE(selectedAt({0, 0, 0.5}), std::string("RobotConfig.Rover"));
        const auto yard = m_window->view().context().world.find("StaticConfig.Yard");
        QVERIFY(yard);
        const Bounds bounds = m_window->view().context().world.boundsOf(*yard);
        QVERIFY2(bounds.high.y() < -0.2 && bounds.high.y() > -1, QByteArray::number(bounds.high.y()));
        QCOMPARE(selectedAt(bounds.centre()), std::string("StaticConfig.Yard"));
    }

    void showsOnlyPlacedObjects() {
        open(kRover);
        QVERIFY(m_window->document.edits()
                    .apply({}, planInsert(*m_window->document.loaded(), {}, "Robot one { Config=Rover Pos=0,1,0 }"))
                    .ok());
        const ViewportScene& world = m_window->view().context().world;
        QCOMPARE(world.objects()->instances().size(), std::size_t(1));
        QCOMPARE(world.objectsOf("RobotConfig.Rover.chassis").size(), std::size_t(1)); // of the instance; there is no preview
        QVERIFY(m_window->session.source().refusal().isEmpty());
        m_window->document.edits().undo();
        QVERIFY(world.find("RobotConfig.Rover.chassis"));
    }

    /// The robot falls and rests on the floor, which cannot be selected; the text is unchanged.
    void aRobotRunsOnAFloor() {
        const QByteArray high = QByteArray(kRover).replace("Pos=0,0,0.1", "Pos=0,0,0.3");
        open(high);
        const ViewportScene& world = m_window->view().context().world;
        QCOMPARE(world.objects()->instances().size(), std::size_t(2));
        QCOMPARE(selectedAt({2, 0, 0}), std::string());
        RunSession& session = m_window->session;
        QVERIFY(session.source().refusal().isEmpty());
        session.setSpeed(0);
        session.runFor(1);
        EVENTUALLY(session.state() == RunState::Paused && session.results().time() >= 1);
        const auto pose = session.robots().pose("RobotConfig.Rover");
        QVERIFY(pose && std::abs(pose->position.z() + 0.2) < 0.01); // the hull, which started 0.2 m above the floor
        QVERIFY(world.find("RobotConfig.Rover.chassis.mast"));
        QVERIFY(!session.robots().keepRefusal().isEmpty());
        QCOMPARE(m_window->text(), high);
        QVERIFY(!m_window->document.texts().isModified());
        QVERIFY(m_window->document.structure().setValues({}, {{"RobotConfig.Rover.chassis.mast.Mass", "2"}}).ok());
        QVERIFY(session.edits().waitsForReset("RobotConfig.Rover.chassis.mast.Mass"));
        session.reset();
    }

    /// A robot with geoms below its origin is raised to rest on the floor.
    void noRobotStartsInTheFloor() {
        open(QByteArray(kRover).replace("Pos=0,0,0.1", "Pos=0,0,0"));
        const ViewportScene& world = m_window->view().context().world;
        const auto rover = world.find("RobotConfig.Rover");
        QVERIFY(rover && std::abs(world.boundsOf(*rover).low.z()) < 1e-9);
    }

    void previewContainsRobotOnly() {
        QFile file(QStringLiteral(TRUNDLE_SOURCE_DIR "/resources/templates/robot.sim"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(m_window->document.opening().openNew("robot.sim", text.toStdString()).ok());
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        QVERIFY(m_window->document.loaded()->experiment->robots.empty());
        const ViewportScene& world = m_window->view().context().world;
        QVERIFY(world.find("RobotConfig.NewRobot"));
        RunSession& session = m_window->session;
        session.setSpeed(0);
        session.step();
        EVENTUALLY(session.state() == RunState::Paused && session.results().time() > 0);
        QVERIFY(session.robots().drive("RobotConfig.NewRobot", 0.2, 0));
        session.runFor(2);
        EVENTUALLY(session.results().time() >= 2);
        QVERIFY(session.robots().pose("RobotConfig.NewRobot")->position.x() > 0.2); // it drives
        session.reset();
    }

    void reportsWhyNothingRuns() {
        open(kYard);
        QSignalSpy refused(&m_window->session.messages(), &RunMessages::refused);
        m_window->session.run();
        QCOMPARE(refused.size(), 1);
        QVERIFY2(refused[0][0].toString().contains(QStringLiteral("describes Yard")), qPrintable(refused[0][0].toString()));
        QCOMPARE(m_window->session.state(), RunState::Start);
        open("Tick = 0.01\n"); // no configs: an empty world can run
        QVERIFY(m_window->session.source().refusal().isEmpty());
    }

    void showsNothingForImportsAlone() {
        open("#import robots/simple_robot.sim\n");
        QVERIFY(m_window->view().context().world.objects()->instances().empty());
    }

    /// Each shipped robot and arena is visible when it is opened.
    void everySampleRobotAndArenaIsSeen() {
        for (const char* folder : {"robots", "arenas"})
            for (const QFileInfo& file : QDir(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/") + QLatin1String(folder))
                                             .entryInfoList({QStringLiteral("*.sim")})) {
                QVERIFY(m_window->document.opening().open(file.filePath().toStdString()).ok());
                const ObjectIndex& objects = *m_window->view().context().world.objects();
                QVERIFY2(!objects.instances().empty(), qPrintable(file.fileName()));
            }
    }

private:
    void open(const QByteArray& text) {
        QVERIFY(m_window->open(text));
        m_window->look({0.5, -2.5, 2.5}, {0, 0, 0});
        m_window->view().setFocus();
    }
    std::string selectedAt(const Vec3& point) {
        m_window->trigger("tool.select");
        m_window->click(m_window->at(point));
        return m_window->selection.current();
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(PreviewSceneTest)
#include "preview_scene_test.moc"
