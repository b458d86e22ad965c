// How a new document is framed, and how the view is widened when the robots leave it.
#include <QtTest>

#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kLongDrive = R"(Tick = 0.01
#import robots/simple_robot.sim
#loadModule controllers/linear_motion
#import arenas/open_floor.sim
Static floor { Config=OpenFloor }
Robot robot0 { Config=SimpleRobot LinearMotion brain { Distance=30 Speed=0.5 } }
)";
const QByteArray kViews = "View side { Eye=0,-3,1 Target=0,0,0.2 }\nView top { Eye=0,0,4 Target=0,0,0 }\n";

} // namespace

class AutoFramingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<ViewWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    void widensWhenTheRobotLeaves() {
        openLongDrive();
        const double before = camera().free().distance();
        m_window->session.run();
        EVENTUALLY(x() > 6);
        EVENTUALLY(!camera().isMoving() && isShown());
        QVERIFY(camera().free().distance() > 2 * before);
        QVERIFY((camera().free().forward() - m_forward).norm() < 1e-12);
    }

    void leavesAViewThatTheUserHasMoved() {
        openLongDrive();
        m_window->drag({450, 350}, {470, 360}, Qt::MiddleButton);
        const CameraView moved = camera().view();
        m_window->session.run();
        EVENTUALLY(x() > 6);
        QVERIFY(!isShown() && !camera().isMoving());
        QVERIFY(camera().view().eye == moved.eye && camera().view().target == moved.target);
    }

    /// It is put there by hand, before a run.
    void leavesTheViewWhileNothingRuns() {
        openLongDrive();
        const CameraView before = camera().view();
        const QByteArray there = QByteArray(kLongDrive).replace("Config=SimpleRobot", "Config=SimpleRobot Pos=9,0,0");
        const auto text = std::make_shared<const std::string>(there.toStdString());
        QVERIFY(m_window->document.edits().replaceTexts(QStringLiteral("Typing"), {{m_window->document.path(), text}}).ok());
        EVENTUALLY(x() > 8);
        QVERIFY(!isShown() && !camera().isMoving() && camera().view().eye == before.eye);
    }

    void opensAtTheFirstViewOfTheText() {
        QVERIFY(m_window->open(kLongDrive + kViews));
        QCOMPARE(camera().named(), std::string("side"));
        QVERIFY((camera().view().eye - Vec3(0, -3, 1)).norm() < 1e-9);
        QVERIFY(m_window->open(kLongDrive));
        QVERIFY(camera().named().empty());
        EVENTUALLY(!camera().isMoving() && isShown());
    }

    void frameAllLeavesTheFirstView() {
        QVERIFY(m_window->open(kLongDrive + kViews));
        m_window->trigger("view.frameAll");
        QVERIFY(camera().named().empty());
    }

private:
    void openLongDrive() {
        QVERIFY(m_window->open(kLongDrive));
        EVENTUALLY(!camera().isMoving() && isShown());
        m_forward = camera().free().forward();
        m_window->session.setSpeed(0); // as fast as possible
    }
    [[nodiscard]] CameraControl& camera() { return m_window->view().camera(); }
    [[nodiscard]] Vec3 robot() const { return (*m_window->panel->world().poses())[0].position; }
    [[nodiscard]] double x() const { return robot().x(); }
    [[nodiscard]] bool isShown() {
        const auto pixel = camera().pixelOf(robot());
        return pixel && m_window->view().rect().contains(pixel->toPoint());
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
    Vec3 m_forward;
};

QTEST_MAIN(AutoFramingTest)
#include "auto_framing_test.moc"
