// The camera of a view in its experiment: what it follows and looks through, the View block of it, the point under a pixel.
#include <numbers>

#include <QPainter>
#include <QRegularExpression>
#include <QtTest>

#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/paint_record.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/view_window.h"
#include "scene/queries/camera_model.h"
#include "scene/queries/framing.h"

using namespace trundle;

namespace {

/// Two turned robots with two cameras each, and two Views.
const QByteArray kTwo = R"(Tick = 0.01
RobotConfig Seer {
  Body head { Box hull { Size=0.2,0.2,0.2 Mass=1 } }
  Camera left { Body=head Pos=0.1,0.05,0.1 Resolution=40,20 FieldOfView=50 }
  Camera right { Body=head Pos=0.1,-0.05,0.1 HPR=-40,0,0 Resolution=30,30 FieldOfView=70 }
}
StaticConfig Block { Box post { Size=0.4,0.4,1 Pos=0,0,0.5 } }
Static block { Config=Block Pos=0,2,0 }
Robot one { Config=Seer Pos=-0.6,0.2,0.1 HPR=20,0,0 }
Robot two { Config=Seer Pos=0.8,-0.3,0.1 HPR=-50,0,0 }
View whole { Eye=3,-4,3 Target=0,0,0.2 FieldOfView=40 }
View behind { Mode=chase Robot=two Eye=-2,0,1 Target=0,0,0.3 FieldOfView=50 }
)";

} // namespace

class CameraControlTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ViewWindow> m_window;

    CameraControl& camera() { return m_window->view().camera(); }
    ViewportScene& world() { return m_window->panel->world(); }
    /// The poses of the experiment with one robot moved.
    BodyPoses posesWith(std::size_t robot, const Pose& pose) {
        BodyPoses poses = *world().poses();
        poses[world().objects()->firstPose(robot)] = pose;
        return poses;
    }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<ViewWindow>(nullptr);
        QVERIFY(m_window->open(kTwo));
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        m_window->look({1.5, -3, 2}, {0.2, 0.1, 0.3});
    }
    void cleanup() { m_window.reset(); }

    void theViewBlockOfACamera_data() {
        QTest::addColumn<QByteArray>("action");
        for (const char* action : {"view.perspective", "view.parallel", "view.top", "view.front", "view.side"})
            QTest::newRow(action) << QByteArray(action);
    }
    /// In perspective it is the camera itself; for a parallel view it shows the same width in the middle, from the same side.
    void theViewBlockOfACamera() {
        QFETCH(QByteArray, action);
        m_window->trigger(action.constData());
        const CameraView shown = camera().view();
        const auto match =
            QRegularExpression(
                QStringLiteral("^View view \\{ Eye=(\\S+),(\\S+),(\\S+) Target=(\\S+),(\\S+),(\\S+) FieldOfView=(\\S+) \\}\n$"))
                .match(QString::fromStdString(camera().viewBlockText()));
        QVERIFY(match.hasMatch());
        const auto triple = [&](int at) {
            return Vec3(match.captured(at).toDouble(), match.captured(at + 1).toDouble(), match.captured(at + 2).toDouble());
        };
        const Vec3 eye = triple(1), target = triple(4), middle = camera().free().middle();
        QVERIFY(std::abs(match.captured(7).toDouble() - 45) < 0.06);
        QVERIFY((target - middle).norm() < 0.002);
        QVERIFY((target - eye).normalized().dot(camera().free().forward()) > 1 - 1e-5);
        const double wide = shown.orthographicWidth > 0 ? shown.orthographicWidth
                                                        : 2 * (shown.eye - middle).norm() * std::tan(std::numbers::pi / 8);
        QVERIFY(std::abs(2 * (eye - target).norm() * std::tan(std::numbers::pi / 8) - wide) < 0.005);
        if (shown.orthographicWidth == 0) QVERIFY((eye - shown.eye).norm() < 0.002);
    }

    /// On the nearest object, locked or not; else on the floor, and towards the horizon as far away as the middle of the view.
    void thePointUnderAPixel() {
        const auto top = pixel({0.1, 2, 1});
        QVERIFY((camera().pointUnder(top) - Vec3(0.1, 2, 1)).norm() < 0.01);
        world().setLocked({"block"});
        QVERIFY((camera().pointUnder(top) - Vec3(0.1, 2, 1)).norm() < 0.01);
        world().setHidden({"block"});
        QVERIFY(std::abs(camera().pointUnder(top).z()) < 1e-9);
        QVERIFY((camera().pointUnder(pixel({-1, 1.5, 0})) - Vec3(-1, 1.5, 0)).norm() < 1e-6);
        const double far = 40 * camera().free().distance(); // still on the floor
        const Vec3 there = camera().view().eye + Vec3(-0.4, 0.9, 0).normalized() * far;
        const QPointF horizon = pixel({there.x(), there.y(), 0});
        QVERIFY(std::abs(camera().pointUnder(horizon).z()) < 1e-6);
        for (const QPointF& sky : {QPointF(300, -200), QPointF(700, -500)}) {
            const ViewRay ray = camera().rayAt(sky);
            QVERIFY(ray.direction.z() > 0);
            const Vec3 way = camera().pointUnder(sky) - ray.origin;
            QVERIFY((way.normalized() - ray.direction).norm() < 1e-9);
            QVERIFY(std::abs(way.norm() - (camera().free().middle() - ray.origin).dot(ray.direction)) < 1e-9);
        }
    }

    /// A newly selected robot is followed from its own place; without a selection the first one is.
    void followsTheSelectedRobot() {
        m_window->trigger("view.follow");
        QVERIFY((camera().free().middle() - Vec3(-0.6, 0.2, 0.1)).norm() < 1e-9);
        m_window->selection.select("two.head.hull");
        QVERIFY((camera().free().middle() - Vec3(0.8, -0.3, 0.1)).norm() < 1e-9);
        const auto moving = camera().movingView(800, 600);
        const Vec3 before = moving(*world().poses()).eye, by(0.5, 0.25, 0);
        const CameraView after = moving(posesWith(1, {Vec3(0.8, -0.3, 0.1) + by, Quat::Identity()}));
        QVERIFY((after.eye - before - by).norm() < 1e-9);
        QVERIFY((moving(posesWith(0, {Vec3(5, 5, 5), Quat::Identity()})).eye - before).norm() < 1e-9);
        m_window->trigger("view.chase");
        const Vec3 behind = camera().free().forward();
        QVERIFY(std::abs(std::atan2(behind.y(), behind.x()) + 50 * std::numbers::pi / 180) < 1e-9);
        m_window->selection.select("one");
        QVERIFY((camera().free().middle() - Vec3(-0.6, 0.2, 0.1)).norm() < 1e-9);
        QVERIFY(std::abs(std::atan2(camera().free().forward().y(), camera().free().forward().x()) - 20 * std::numbers::pi / 180) <
                1e-9);
    }

    /// Through one camera and another one; then the view is as before the first.
    void looksThroughCamerasInTurn() {
        const CameraView before = camera().view();
        for (const char* path : {"one/left", "two/right", "two/left"}) {
            camera().lookThrough(path);
            const CameraModel& model = *world().camera(path);
            const CameraView own = viewOf(model, (*world().poses())[model.body]);
            QVERIFY((camera().view().eye - own.eye).norm() < 1e-9);
            QVERIFY((camera().free().view().eye - own.eye).norm() < 1e-9); // where the user would continue
            QVERIFY(std::abs(camera().free().distance() - 2) < 1e-9);
            const auto moving = camera().movingView(900, 300);
            const Pose moved{Vec3(1, 2, 3), rotationFromHpr({0.4, 0, 0})};
            const CameraView there = moving(posesWith(path[0] == 'o' ? 0 : 1, moved)), exact = viewOf(model, moved);
            QVERIFY((there.eye - exact.eye).norm() < 1e-9);
            const double wider = 3 / (double(model.width) / model.height); // an image of 900 x 300 shows more at the sides
            QVERIFY(std::abs(std::tan(there.fieldOfView / 2) - wider * std::tan(exact.fieldOfView / 2)) < 1e-9);
        }
        camera().lookThrough("two/none");
        QVERIFY(camera().isThrough());
        camera().lookThrough({});
        QVERIFY((camera().view().eye - before.eye).norm() < 1e-9 && (camera().view().target - before.target).norm() < 1e-9);
        camera().lookThrough("one/left");
        camera().setKind(ViewKind::Top);
        QVERIFY(!camera().isThrough());
        camera().showNamed("whole");
        QCOMPARE(camera().named(), std::string("whole"));
        camera().lookThrough("one/left"); // leaves that View
        QVERIFY(camera().isThrough() && camera().named().empty());
        camera().showNamed("whole");
        camera().setKind(ViewKind::Perspective);
        QVERIFY(camera().named().empty());
    }

    /// In images of other shapes nothing is lost: a wider one shows more at the sides, a higher one above and below.
    void imagesOfOtherShapes() {
        const double aspect = double(m_window->view().width()) / m_window->view().height();
        const auto expected = [&](double fieldOfView, double to) {
            return to > aspect ? 2 * std::atan(std::tan(fieldOfView / 2) * to / aspect) : fieldOfView;
        };
        const auto check = [&](const std::function<CameraView(std::uint32_t, std::uint32_t)>& view) {
            const CameraView shown = camera().view();
            for (const auto& [wide, high] : {std::pair(3000u, 500u), {300u, 900u}, {1000u, 1000u}}) {
                const CameraView other = view(wide, high);
                const double to = double(wide) / high;
                QVERIFY(std::abs(other.fieldOfView - expected(shown.fieldOfView, to)) < 1e-9);
                QVERIFY(std::abs(other.orthographicWidth - shown.orthographicWidth * std::max(1., to / aspect)) < 1e-9);
                QVERIFY((other.eye - shown.eye).norm() < 1e-9);
            }
        };
        const auto still = [&](std::uint32_t wide, std::uint32_t high) { return camera().viewFor(wide, high); };
        const auto moving = [&](std::uint32_t wide, std::uint32_t high) {
            return camera().movingView(wide, high)(*world().poses());
        };
        for (const char* action : {"view.perspective", "view.parallel", "view.follow"}) {
            m_window->trigger(action);
            check(still);
            if (QByteArray(action) != "view.parallel") check(moving);
        }
        for (const char* name : {"whole", "behind"}) {
            camera().showNamed(name);
            check(still);
            check(moving);
        }
    }

    /// However far the middle of a parallel view is from the scene, all of that is between its planes.
    void parallelViewsShowAllOfTheScene() {
        for (const char* action : {"view.top", "view.front", "view.side", "view.parallel"}) {
            m_window->trigger(action);
            for (const Vec3& by : {Vec3(0, 0, 0), Vec3(7, -9, 4), Vec3(-12, 8, 6)}) {
                camera().change([&](ViewCamera& free) { free.pan(by, Vec3::Zero()); });
                const CameraView view = camera().view();
                const Bounds bounds = world().bounds();
                for (int i = 0; i < 8; ++i) {
                    const double depth = (bounds.corner(i) - view.eye).dot((view.target - view.eye).normalized());
                    QVERIFY2(depth > view.nearPlane && depth < view.farPlane, action);
                }
            }
        }
    }

    /// What is under the mouse is found again when the camera or the object moves, until the mouse leaves the view.
    void hoveringFollowsWhatMoves() {
        const auto hovered = [this] { return m_window->view().hints().hovered(); };
        const QPointF mouse = pixel({-0.6, 0.2, 0.1});
        m_window->move(mouse);
        QCOMPARE(hovered(), std::string("one"));
        m_window->look({1.5, -3, 9}, {6, 6, 9});
        QCOMPARE(hovered(), std::string());
        m_window->look({1.5, -3, 2}, {0.2, 0.1, 0.3});
        QCOMPARE(hovered(), std::string("one"));
        m_window->session.step();
        QVERIFY(QTest::qWaitFor([&] { return m_window->session.state() == RunState::Paused && world().isRunning(); }, 60000));
        m_window->move(mouse);
        QCOMPARE(hovered(), std::string("one"));
        QVERIFY(m_window->session.robots().place("one", {Vec3(-3, 3, 0.1), Quat::Identity()}));
        QVERIFY(QTest::qWaitFor([&] { return hovered().empty(); }, 60000));
        m_window->move(pixel({-3, 3, 0.1}));
        QCOMPARE(hovered(), std::string("one"));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&m_window->view(), &leave);
        QCOMPARE(hovered(), std::string());
        m_window->look({1.5, -3, 2}, {0.3, 0.1, 0.3});
        QCOMPARE(hovered(), std::string()); // the mouse is elsewhere
    }

    /// A drag downwards looks from higher up, one to the right turns the camera to the left; a tremble is a click.
    void draggingOrbits() {
        const auto dragged = [&](const QPointF& by) {
            m_window->look({1.5, -3, 2}, {0.2, 0.1, 0.3});
            const Vec3 before = camera().free().forward();
            m_window->press(QPointF(450, 350), Qt::MiddleButton);
            m_window->move(QPointF(450, 350) + by, {}, Qt::MiddleButton);
            m_window->release(QPointF(450, 350) + by, Qt::MiddleButton);
            const Vec3 after = camera().free().forward();
            return std::array{
                std::remainder(std::atan2(after.y(), after.x()) - std::atan2(before.y(), before.x()), 2 * std::numbers::pi),
                std::asin(after.z()) - std::asin(before.z())};
        };
        const auto is = [](const std::array<double, 2>& turn, double heading, double pitch) {
            return std::abs(turn[0] - heading) < 1e-9 && std::abs(turn[1] - pitch) < 1e-9;
        };
        QVERIFY(is(dragged({0, 40}), 0, -0.26));
        QVERIFY(is(dragged({0, -40}), 0, 0.26));
        QVERIFY(is(dragged({40, 0}), -0.26, 0));
        QVERIFY(is(dragged({1, 1}), 0, 0));
    }

    /// From the first clicked point to the second one, also in height; another tool forgets them.
    void whatIsMeasured() {
        m_window->trigger("tool.measure");
        m_window->selection.select("one");
        m_window->key(Qt::Key_Escape); // without points it clears the selection
        QVERIFY(m_window->selection.empty());
        m_window->trigger("tool.measure");
        m_window->click(pixel({-1, 1.5, 0}));
        m_window->click(pixel({0.1, 2, 1}));
        const QString shown = m_window->view().hints().hint();
        const auto match =
            QRegularExpression(QStringLiteral("^Distance (\\S+) m · x (\\S+) m   y (\\S+) m   z (\\S+) m$")).match(shown);
        QVERIFY2(match.hasMatch(), qPrintable(shown));
        const double wanted[] = {std::sqrt(1.1 * 1.1 + 0.25 + 1), 1.1, 0.5, 1};
        for (int i = 0; i < 4; ++i) QVERIFY2(std::abs(match.captured(i + 1).toDouble() - wanted[i]) < 0.02, qPrintable(shown));
        PaintRecord record(m_window->view().size());
        QPainter painter(&record);
        m_window->view().tools().paint(painter);
        painter.end();
        QVERIFY2(record.texts().contains(match.captured(1) + QStringLiteral(" m")), qPrintable(record.texts().join(u'|')));
        m_window->trigger("tool.move");
        QVERIFY(m_window->view().context().measurement.points().empty());
        QVERIFY(m_window->view().hints().hint().isEmpty());
    }

private:
    QPointF pixel(const Vec3& point) { return *camera().pixelOf(point); }
};

QTEST_MAIN(CameraControlTest)
#include "camera_control_test.moc"
