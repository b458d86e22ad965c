// Views through a robot's camera, and camera frusta.

#include <numbers>

#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/picture_request.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kEye = R"(Tick = 0.01
#import robots/camera_robot.sim
#import arenas/medium_arena.sim
Static arena { Config=MediumArena }
Robot robot0 { Config=CameraRobot Pos=-0.5,0,0 }
Grid other { Config=CameraRobot Count=2 Spacing=0.6 Pos=0.5,0.5,0 eye.SeesSelf=false }
)";

} // namespace

class ThroughTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kEye));
        m_window->look({-0.2, -2.6, 2.2}, {-0.2, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    void viewMovesToCamera() {
        View& view = m_window->view();
        view.camera().lookThrough("robot0/eye");
        QVERIFY(view.camera().through());
        const Vec3 lens(-0.5 + 0.03, 0, 0.275);
        QVERIFY((view.camera().view().eye - lens).norm() < 1e-9);
        // The whole camera image is visible: its corners fill the height or the width of the view.
        const CameraModel camera = *view.camera().through();
        const CameraView own = viewOf(camera, (*m_window->panel->world().poses())[camera.body]);
        const ViewRay corner = rayThrough(own, camera.width, camera.height, 0, 0);
        const QPointF at = view.camera().pixelOf(corner.origin + corner.direction).value_or(QPointF(-1, -1));
        const double high = std::min<double>(view.height(), view.width() * 0.75);
        QVERIFY(std::abs(at.y() - 0.5 * (view.height() - high)) < 0.5);
        QVERIFY(std::abs(at.x() - 0.5 * (view.width() - high / 0.75)) < 0.5);
    }

    /// The view is drawn without distortion, and reports it.
    void aBentLensIsNamed() {
        View& view = m_window->view();
        const auto seen = [&](const QByteArray& text) {
            if (!m_window->open(text)) return QImage();
            view.camera().lookThrough("robot0/eye");
            return QTest::qWaitFor([&] { return view.camera().through() && view.image().isSettled(); }, 20000)
                       ? view.grab().toImage()
                       : QImage();
        };
        const QImage straight = seen(kEye);
        const QImage bent = seen(QByteArray(kEye).replace("Pos=-0.5,0,0", "Pos=-0.5,0,0 eye.Distortion=-0.2,0.02"));
        QVERIFY(view.camera().through()->k1 != 0);
        const int words = 48; // height of the label at the top, in pixels
        QVERIFY(!straight.isNull() && straight.copy(0, 0, view.width(), words) != bent.copy(0, 0, view.width(), words));
        const QRect below(0, words, view.width(), view.height() - words);
        QCOMPARE(bent.copy(below), straight.copy(below));
    }

    void viewsOfTheExperimentAreChosenAndMade() {
        View& view = m_window->view();
        QVERIFY(m_window->open(kEye + "View ahead { Mode=chase Robot=robot0 Eye=-1,0,0.5 Target=0,0,0.2 FieldOfView=40 }\n"));
        auto* button = view.findChild<QToolButton*>(QStringLiteral("viewKind"));
        QMenu* menu = button->menu();
        Q_EMIT menu->aboutToShow();
        const auto* views = menu->findChild<QMenu*>(QStringLiteral("namedViews"));
        QCOMPARE(views->actions().size(), 1);
        QCOMPARE(views->actions()[0]->text(), QStringLiteral("ahead"));
        views->actions()[0]->trigger();
        QCOMPARE(button->text(), QStringLiteral("ahead"));
        QVERIFY((view.camera().view().eye - Vec3(-1.5, 0, 0.5)).norm() < 1e-6);
        QCOMPARE(view.camera().view().fieldOfView, 40 * std::numbers::pi / 180);
        // The view follows the robot until the user navigates.
        m_window->session.step();
        EVENTUALLY_EQUAL(m_window->session.state(), RunState::Paused);
        QVERIFY(m_window->session.robots().place("robot0", {{0.5, 0.5, 0}, Quat::Identity()}));
        EVENTUALLY((view.camera().view().eye - Vec3(-0.5, 0.5, 0.5)).norm() < 1e-6);
        m_window->session.reset();
        m_window->look({-0.2, -2.6, 2.2}, {-0.2, 0, 0});
        QCOMPARE(button->text(), QStringLiteral("Perspective"));
        // Makes a camera from the current view.
        const CameraView before = view.camera().view();
        const QByteArray text = m_window->text();
        menu->findChild<QAction*>(QStringLiteral("makeView"))->trigger();
        QVERIFY2(m_window->text().contains("View view {"), m_window->text());
        Q_EMIT menu->aboutToShow();
        QCOMPARE(views->actions().size(), 2);
        views->actions()[1]->trigger();
        QVERIFY((view.camera().view().eye - before.eye).norm() < 0.002 &&
                (view.camera().view().target - before.target).norm() < 0.002);
        QVERIFY(std::abs(view.camera().view().fieldOfView - before.fieldOfView) < 0.002);
        view.camera().setKind(ViewKind::Top); // for a parallel view the distance is chosen so that the camera shows as much
        menu->findChild<QAction*>(QStringLiteral("makeView"))->trigger();
        QVERIFY2(m_window->text().contains("View view2 {"), m_window->text());
        m_window->document.edits().undo();
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
        // A camera made during a run can be chosen in it, and moves with the robots of the run.
        m_window->session.step();
        EVENTUALLY_EQUAL(m_window->session.state(), RunState::Paused);
        QVERIFY(m_window->session.robots().place("robot0", {{0.5, 0.5, 0}, Quat::Identity()}));
        (void)m_window->document.edits().replaceText(
            u"Type"_qs, m_window->document.path(),
            (m_window->text() + "View late { Mode=chase Robot=robot0 Eye=-1,0,0.5 }\n").toStdString());
        Q_EMIT menu->aboutToShow();
        QCOMPARE(views->actions().size(), 2);
        views->actions()[1]->trigger();
        QCOMPARE(button->text(), QStringLiteral("late"));
        EVENTUALLY((view.camera().view().eye - Vec3(-0.5, 0.5, 0.5)).norm() < 1e-6);
    }

    void viewFollowsRobot() {
        View& view = m_window->view();
        view.camera().lookThrough("robot0/eye");
        m_window->session.step();
        EVENTUALLY_EQUAL(m_window->session.state(), RunState::Paused);
        QVERIFY(m_window->session.robots().place("robot0", {Vec3(0.4, -0.4, 0), rotationFromHpr({std::numbers::pi / 2, 0, 0})}));
        EVENTUALLY((view.camera().view().eye - Vec3(0.4, -0.4 + 0.03, 0.275)).norm() < 1e-6);
        m_window->session.reset();
        EVENTUALLY((view.camera().view().eye - Vec3(-0.47, 0, 0.275)).norm() < 1e-6);
    }

    void escapeRestoresView() {
        View& view = m_window->view();
        const CameraView before = view.camera().view();
        view.camera().lookThrough("robot0/eye");
        view.camera().lookThrough("other_1/eye");
        m_window->key(Qt::Key_Escape);
        QVERIFY(!view.camera().through());
        QVERIFY((view.camera().view().eye - before.eye).norm() < 1e-9 &&
                (view.camera().view().target - before.target).norm() < 1e-9);
    }

    void orbitContinuesFromCamera() {
        View& view = m_window->view();
        view.camera().lookThrough("robot0/eye");
        EVENTUALLY(view.image().isUpToDate());
        m_window->drag({400, 400}, {410, 400}, Qt::MiddleButton);
        QVERIFY(!view.camera().through());
        QVERIFY((view.camera().view().eye - Vec3(-0.47, 0, 0.275)).norm() < 1.5);
    }

    void removedCameraReleasesView() {
        View& view = m_window->view();
        const Vec3 before = view.camera().view().eye;
        view.camera().lookThrough("other_0/eye");
        QVERIFY(view.camera().through());
        QVERIFY(m_window->open(kRoom));
        EVENTUALLY(!view.camera().through());
        QVERIFY(std::isfinite(view.camera().view().eye.norm()));
        view.camera().lookThrough("robot0/eye"); // the camera is missing in this document
        QVERIFY(!view.camera().through());
        Q_UNUSED(before);
    }

    void commandCyclesThroughCameras() {
        m_window->selection.select("other");
        m_window->trigger("view.through");
        QCOMPARE(m_window->view().camera().through()->path, std::string("other_0/eye"));
        m_window->trigger("view.through");
        QCOMPARE(m_window->view().camera().through()->path, std::string("other_1/eye"));
        m_window->selection.clear();
        m_window->trigger("view.through");
        QCOMPARE(m_window->view().camera().through()->path, std::string("robot0/eye")); // each camera is selected in turn
        m_window->view().camera().lookThrough({});
        QVERIFY(m_window->open(kRoom));
        m_window->refusals.clear();
        m_window->trigger("view.through");
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
    }

    void pathsMeanTheirCameras_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("cameras");
        QTest::newRow("robot") << "robot0" << 1;
        QTest::newRow("camera") << "robot0.eye" << 1;
        QTest::newRow("its body") << "robot0.chassis" << 1;
        QTest::newRow("another body") << "robot0.leftWheel" << 0;
        QTest::newRow("grid") << "other" << 2;
        QTest::newRow("in a grid") << "other.eye" << 2;
        QTest::newRow("member") << "other_1.eye" << 1;
        QTest::newRow("config") << "RobotConfig.CameraRobot" << 3;
        QTest::newRow("in a config") << "RobotConfig.CameraRobot.eye" << 3;
        QTest::newRow("all configs") << "RobotConfig" << 0;
        QTest::newRow("static") << "arena" << 0;
        QTest::newRow("nothing") << "" << 0;
    }
    void pathsMeanTheirCameras() {
        QFETCH(QString, path);
        QFETCH(int, cameras);
        QCOMPARE(int(m_window->panel->world().camerasOf(path.toStdString()).size()), cameras);
    }

    void frustaAreDrawnWhereTheyAre() {
        View& view = m_window->view();
        EVENTUALLY(view.image().isSettled());
        // On the ray through the upper left corner of the image of robot0's camera.
        const CameraModel camera = *m_window->panel->world().camera("robot0/eye");
        const CameraView own = viewOf(camera, (*m_window->panel->world().poses())[camera.body]);
        const ViewRay corner = rayThrough(own, camera.width, camera.height, 0, 0);
        const QPoint at = m_window->at(corner.origin + 0.5 * corner.direction);
        const QImage bare = view.grab().toImage();
        QVERIFY(view.rect().contains(at));
        m_window->trigger("view.overlayFrusta");
        EVENTUALLY(view.image().isSettled());
        QVERIFY(near(view.grab().toImage(), at) && !near(bare, at));
        m_window->trigger("view.overlayFrusta");
        EVENTUALLY(view.image().isSettled());
        QVERIFY(!near(view.grab().toImage(), at));
        m_window->selection.select("robot0.eye"); // the frustum of a selected camera is always shown
        EVENTUALLY(view.image().isSettled());
        QVERIFY(view.grab().toImage().pixelColor(at) != bare.pixelColor(at));
    }

    void aStillShowsAllThatTheViewShows_data() {
        QTest::addColumn<QByteArray>("action");
        for (const char* action : {"view.perspective", "view.parallel", "view.top", "view.front"})
            QTest::newRow(action) << QByteArray(action);
    }
    void aStillShowsAllThatTheViewShows() {
        QFETCH(QByteArray, action);
        View& view = m_window->view();
        m_window->trigger(action.constData());
        const PictureRequest wide = stillRequest(view, 3840, 1000), high = stillRequest(view, 500, 2000);
        QCOMPARE(wide.width, 3840u);
        const CameraView shown = view.camera().view();
        for (const QPointF& corner : {QPointF(0, 0), QPointF(view.width(), view.height())}) {
            const ViewRay ray = view.camera().rayAt(corner);
            for (const PictureRequest* still : {&wide, &high}) {
                const auto at = project(*still->view, still->width, still->height, ray.origin + 3 * ray.direction);
                QVERIFY(at && at->x > -0.5 && at->x < still->width + 0.5 && at->y > -0.5 && at->y < still->height + 0.5);
            }
        }
        QVERIFY((wide.view->eye - shown.eye).norm() < 1e-12);
    }

private:
    /// True if the colour of frusta is on a pixel or next to it.
    static bool near(const QImage& image, const QPoint& at) {
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x) {
                const QColor c = image.pixelColor(at + QPoint(x, y));
                if (std::abs(c.red() - 70) + std::abs(c.green() - 196) + std::abs(c.blue() - 222) < 60) return true;
            }
        return false;
    }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(ThroughTest)
#include "through_test.moc"
