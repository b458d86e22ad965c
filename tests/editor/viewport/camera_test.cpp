// The camera of a 3D view: orbit, zoom, axis views, framing, following and navigation styles.
#include <QtTest>

#include <random>

#include "editor/viewport/context/view_camera.h"
#include "editor/viewport/tools/navigation_style.h"

using namespace trundle;

namespace {

constexpr double kWidth = 900, kHeight = 700;

ImagePoint seen(const ViewCamera& camera, const Vec3& p) {
    return project(camera.view(20), 900, 700, p).value_or(ImagePoint{-1, -1, 0});
}

bool near(const ImagePoint& a, const ImagePoint& b) { return std::hypot(a.x - b.x, a.y - b.y) < 1e-6; }

} // namespace

class CameraTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void turningLeavesItsPointWhereItIs() {
        std::mt19937 random(5);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic}) {
            ViewCamera camera;
            camera.setKind(kind);
            for (int i = 0; i < 200; ++i) {
                const Vec3 about(any(-1, 1), any(-1, 1), any(0, 1));
                const ImagePoint before = seen(camera, about);
                camera.orbit(any(-0.5, 0.5), any(-0.3, 0.3), about);
                if (before.depth <= 0) continue;
                QVERIFY(near(before, seen(camera, about)));
                QVERIFY(isUsable(camera.view()));
                // The camera is upright: a point above is higher in the image.
                QVERIFY(seen(camera, camera.middle() + Vec3(0, 0, 0.1)).y <= seen(camera, camera.middle()).y + 1e-6);
            }
        }
    }

    void zoomingLeavesItsPointWhereItIs() {
        for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Top, ViewKind::Orthographic}) {
            ViewCamera camera;
            camera.setKind(kind);
            const Vec3 about(0.4, 0.3, 0.1);
            const ImagePoint before = seen(camera, about);
            const double scale = camera.metresPerPixel(kWidth, about);
            for (int i = 0; i < 8; ++i) camera.zoom(0.8, about);
            QVERIFY(near(before, seen(camera, about)));
            QVERIFY(std::abs(camera.metresPerPixel(kWidth, about) / scale - std::pow(0.8, 8)) < 1e-9);
        }
    }

    void zoomEndsBeforeItCollapses() {
        ViewCamera camera;
        for (int i = 0; i < 2000; ++i) camera.zoom(0.5, Vec3::Zero());
        QVERIFY(isUsable(camera.view()));
        for (int i = 0; i < 2000; ++i) camera.zoom(2, Vec3(1, 1, 1));
        QVERIFY(isUsable(camera.view()));
    }

    void axisViewsAreSquare() {
        ViewCamera camera;
        camera.setKind(ViewKind::Top);
        const ImagePoint o = seen(camera, {0, 0, 0}), x = seen(camera, {1, 0, 0}), y = seen(camera, {0, 1, 0}),
                         z = seen(camera, {0, 0, 1});
        QVERIFY(x.x > o.x + 10 && std::abs(x.y - o.y) < 1e-6);
        QVERIFY(y.y < o.y - 10 && std::abs(y.x - o.x) < 1e-6);
        QVERIFY(near(o, z));
        camera.setKind(ViewKind::Front);
        QVERIFY(near(seen(camera, {0, 0, 0}), seen(camera, {0, 1, 0})));
        QVERIFY(seen(camera, {0, 0, 1}).y < seen(camera, {0, 0, 0}).y - 10);
        QVERIFY(seen(camera, {1, 0, 0}).x > seen(camera, {0, 0, 0}).x + 10);
        camera.setKind(ViewKind::Side);
        QVERIFY(near(seen(camera, {0, 0, 0}), seen(camera, {1, 0, 0})));
        QVERIFY(seen(camera, {0, 1, 0}).x > seen(camera, {0, 0, 0}).x + 10);
        camera.orbit(0.3, -0.3, Vec3::Zero());
        QCOMPARE(camera.kind(), ViewKind::Orthographic);
    }

    void framingShowsAllOfABoxAndFillsThePicture() {
        Bounds box;
        box.add(Vec3(-2, 1, 0));
        box.add(Vec3(3, 2, 0.7));
        for (const ViewKind kind :
             {ViewKind::Perspective, ViewKind::Top, ViewKind::Front, ViewKind::Side, ViewKind::Orthographic}) {
            ViewCamera camera;
            camera.setKind(kind);
            camera.frame(box, kWidth, kHeight);
            double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
            for (int i = 0; i < 8; ++i) {
                const ImagePoint p = seen(camera, box.corner(i));
                left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.y),
                bottom = std::max(bottom, p.y);
            }
            QVERIFY2(left >= 0 && right <= kWidth && top >= 0 && bottom <= kHeight, qPrintable(QString::number(int(kind))));
            QVERIFY(std::max((right - left) / kWidth, (bottom - top) / kHeight) > 0.75);
        }
    }

    void aNothingOrAPointCanBeFramed() {
        ViewCamera camera;
        camera.frame({}, kWidth, kHeight);
        QVERIFY(isUsable(camera.view()));
        Bounds point;
        point.add(Vec3(5, 5, 5));
        camera.frame(point, 1, 1);
        QVERIFY(isUsable(camera.view()));
    }

    void followKeepsRobotPositionInView() {
        ViewCamera camera;
        camera.setKind(ViewKind::Follow);
        camera.follow({Vec3(1, 2, 0), Quat::Identity()});
        const ImagePoint before = seen(camera, {1, 2, 0});
        camera.follow({Vec3(3, -2, 0), rotationFromHpr({1, 0, 0})});
        QVERIFY(near(before, seen(camera, {3, -2, 0})));
    }

    void chasingStaysBehind() {
        ViewCamera camera;
        camera.setKind(ViewKind::Chase);
        for (double heading = 0; heading < 7; heading += 0.1) {
            camera.follow({Vec3(std::sin(heading), 0, 0), rotationFromHpr({heading, 0, 0})});
            const Vec3 forward(std::cos(heading), std::sin(heading), 0);
            QVERIFY(camera.forward().dot(forward) > 0.9);
        }
    }

    /// Follow keeps distance and direction; Chase takes those behind the robot, at 0.8 to 4 m, and turns with it.
    void theFirstPoseOfFollowingCounts() {
        for (const auto& [before, chased] : {std::pair{0.1, 0.8}, {2., 2.}, {50., 4.}}) {
            ViewCamera follow, chase, still;
            for (ViewCamera* camera : {&follow, &chase, &still}) camera->zoom(before / camera->distance(), camera->middle());
            const Vec3 direction = follow.forward();
            follow.setKind(ViewKind::Follow);
            chase.setKind(ViewKind::Chase);
            const Pose robot{Vec3(1, -2, 0.5), rotationFromHpr({0.7, 0, 0})};
            for (ViewCamera* camera : {&follow, &chase, &still}) camera->follow(robot);
            QVERIFY(std::abs(follow.distance() - before) < 1e-9 && (follow.forward() - direction).norm() < 1e-12);
            QVERIFY((follow.middle() - robot.position).norm() < 1e-9);
            QVERIFY(std::abs(chase.distance() - chased) < 1e-9 && (chase.middle() - robot.position).norm() < 1e-9);
            const Vec3 behind(std::cos(0.7) * std::cos(-0.38), std::sin(0.7) * std::cos(-0.38), std::sin(-0.38));
            QVERIFY((chase.forward() - behind).norm() < 1e-9);
            QVERIFY((still.middle() - robot.position).norm() > 0.1); // no kind that follows
            follow.setKind(ViewKind::Follow);                        // again: the next pose is the first one
            follow.follow({Vec3(9, 9, 0), Quat::Identity()});
            QVERIFY((follow.middle() - Vec3(9, 9, 0)).norm() < 1e-9);
        }
    }

    void aKindKeepsTheMiddleOfTheView() {
        for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic, ViewKind::Top, ViewKind::Front, ViewKind::Side,
                                    ViewKind::Follow, ViewKind::Chase}) {
            ViewCamera camera;
            const Vec3 middle = camera.middle(), forward = camera.forward();
            camera.setKind(kind);
            QVERIFY((camera.middle() - middle).norm() < 1e-12 && camera.distance() == 5);
            const bool turns = kind == ViewKind::Top || kind == ViewKind::Front || kind == ViewKind::Side;
            QCOMPARE((camera.forward() - forward).norm() > 1e-9, turns);
            QCOMPARE(camera.isParallel(), turns || kind == ViewKind::Orthographic);
            // A perspective view is 2 d tan(45 deg / 2) wide in the distance d; a parallel one everywhere as in the middle.
            const double wide = 2 * 5 * std::tan(22.5 * M_PI / 180);
            QVERIFY(std::abs(camera.metresPerPixel(100, middle) - wide / 100) < 1e-12);
            const Vec3 behind = middle + 5 * camera.forward();
            QVERIFY(std::abs(camera.metresPerPixel(100, behind) - (camera.isParallel() ? 1 : 2) * wide / 100) < 1e-12);
            QVERIFY(std::abs(camera.metresPerPixel(0, middle) - wide) < 1e-12); // a view without a size yet
            const CameraView view = camera.view(30);
            QVERIFY((view.target - middle).norm() < 1e-9 && std::abs(view.fieldOfView - M_PI / 4) < 1e-12);
            QVERIFY(std::abs(view.orthographicWidth - (camera.isParallel() ? wide : 0)) < 1e-12);
            if (!camera.isParallel()) continue;
            QVERIFY(std::abs((view.eye - view.target).norm() - 37) < 1e-9); // beyond the scene of reach 30
            QVERIFY(view.nearPlane == 0.01 && std::abs(view.farPlane - (37 + 4 * 30 + 10)) < 1e-9);
            QVERIFY(std::abs((camera.view(1).eye - middle).norm() - 5) < 1e-9);
        }
    }

    void limitsOfDistances() {
        ViewCamera camera;
        for (const auto& [factor, distance] : {std::pair{1e-9, 0.02}, {1e9, 5000.}, {0.5, 2500.}, {2., 5000.}}) {
            camera.zoom(factor, camera.middle());
            QVERIFY2(std::abs(camera.distance() - distance) < 1e-6, qPrintable(QString::number(camera.distance())));
        }
        const Vec3 eye = camera.view().eye, right = camera.forward().cross(camera.view().up);
        camera.fly({1, 2, 3});
        QVERIFY((camera.view().eye - (eye + 1 * right + Vec3(0, 0, 2) + 3 * camera.forward())).norm() < 1e-9);
        camera.fly({0, 1e7, 0});
        QVERIFY(std::abs(camera.view().eye.norm() - 1e5) < 1e-6);
        camera.zoom(2, Vec3(-1e6, 0, 0));
        QVERIFY(camera.view().eye.norm() < 1e5 + 1e-6);
        camera.orbit(0, 10, camera.middle());
        QVERIFY((camera.forward() - Vec3::UnitZ()).norm() < 1e-12); // straight up, not over
        camera.orbit(0, -10, camera.middle());
        QVERIFY((camera.forward() + Vec3::UnitZ()).norm() < 1e-12);
        const Vec3 here = camera.view().eye;
        camera.rotate(0.3, 0.2);
        QVERIFY((camera.view().eye - here).norm() < 1e-6);
    }

    void framesOfNothingAndOfAPoint() {
        const auto framed = [](std::initializer_list<Vec3> points) {
            Bounds box;
            for (const Vec3& point : points) box.add(point);
            ViewCamera camera;
            camera.frame(box, kWidth, kHeight);
            return camera;
        };
        const ViewCamera nothing = framed({}), floor = framed({{-1, -1, 0}, {1, 1, 0.5}});
        QVERIFY((nothing.middle() - floor.middle()).norm() < 1e-12 && nothing.distance() == floor.distance());
        const ViewCamera point = framed({{5, 5, 5}}), box = framed({{4.95, 4.95, 4.95}, {5.05, 5.05, 5.05}});
        QVERIFY((point.middle() - box.middle()).norm() < 1e-9 && std::abs(point.distance() - box.distance()) < 1e-9);
        ViewCamera wide, high; // the same box in images of other shapes
        Bounds bounds;
        for (const Vec3& corner : {Vec3(-1, -1, 0), Vec3(1, 1, 2)}) bounds.add(corner);
        wide.frame(bounds, 2000, 500);
        high.frame(bounds, 500, 2000);
        QVERIFY(wide.distance() > 1.5 * high.distance());
    }

    void adoptsViews_data() {
        QTest::addColumn<double>("width"); // of a parallel view
        QTest::addColumn<double>("x");
        QTest::newRow("perspective") << 0. << 3.;
        QTest::newRow("parallel") << 2. << 3.;
        QTest::newRow("straight down") << 0. << 0.;
        QTest::newRow("parallel, straight down") << 4. << 0.;
    }
    void adoptsViews() {
        QFETCH(double, width);
        QFETCH(double, x);
        CameraView view;
        view.eye = {x, 0, 3};
        view.target = {0, 0, 1};
        view.orthographicWidth = width;
        ViewCamera camera;
        camera.setView(view);
        QVERIFY((camera.middle() - view.target).norm() < 1e-9);
        QVERIFY((camera.forward() - (view.target - view.eye).normalized()).norm() < 1e-9);
        QCOMPARE(camera.isParallel(), width > 0);
        QCOMPARE(camera.kind(), width > 0 ? ViewKind::Orthographic : ViewKind::Perspective);
        if (width > 0) QVERIFY(std::abs(camera.view().orthographicWidth - width) < 1e-9);
        else QVERIFY((camera.view().eye - view.eye).norm() < 1e-9);
        QVERIFY((cameraAxes(camera.view()) - cameraAxes(view)).norm() < 1e-9); // the picture does not turn
    }

    void navigationStyleMapsButtons_data() {
        QTest::addColumn<int>("style");
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("held");
        QTest::addColumn<int>("drag");
        const auto row = [](const char* name, NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers held,
                            CameraDrag drag) { QTest::newRow(name) << int(style) << int(button) << int(held) << int(drag); };
        const auto own = NavigationStyle::Trundle, blender = NavigationStyle::Blender, cad = NavigationStyle::Cad;
        row("middle", own, Qt::MiddleButton, {}, CameraDrag::Orbit);
        row("Shift middle", own, Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Pan);
        row("right", own, Qt::RightButton, {}, CameraDrag::Orbit);
        row("Alt left", own, Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit);
        row("left selects", own, Qt::LeftButton, {}, CameraDrag::None);
        row("Shift right", own, Qt::RightButton, Qt::ShiftModifier, CameraDrag::Pan);
        row("Alt Shift left", own, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Pan);
        row("Ctrl middle", own, Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Orbit);
        row("another button", own, Qt::BackButton, {}, CameraDrag::None);
        row("Blender Alt left", blender, Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit);
        row("Blender Alt Shift left", blender, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Pan);
        row("Blender Alt Ctrl left", blender, Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, CameraDrag::Zoom);
        row("CAD Ctrl middle", cad, Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Zoom);
        row("CAD Alt left", cad, Qt::LeftButton, Qt::AltModifier, CameraDrag::Pan);
        row("CAD Alt Shift left", cad, Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Orbit);
        row("Blender middle", blender, Qt::MiddleButton, {}, CameraDrag::Orbit);
        row("Blender Shift middle", blender, Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Pan);
        row("Blender Ctrl middle", blender, Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Zoom);
        row("Blender right", blender, Qt::RightButton, {}, CameraDrag::Fly);
        row("Blender Ctrl left pushes", blender, Qt::LeftButton, Qt::ControlModifier, CameraDrag::None);
        row("CAD middle", cad, Qt::MiddleButton, {}, CameraDrag::Pan);
        row("CAD Shift middle", cad, Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Orbit);
        row("CAD right", cad, Qt::RightButton, {}, CameraDrag::Orbit);
        row("CAD left selects", cad, Qt::LeftButton, Qt::ShiftModifier, CameraDrag::None);
    }
    void navigationStyleMapsButtons() {
        QFETCH(int, style);
        QFETCH(int, button);
        QFETCH(int, held);
        QFETCH(int, drag);
        QCOMPARE(int(cameraDrag(NavigationStyle(style), Qt::MouseButton(button), Qt::KeyboardModifiers(held))), drag);
    }

    /// Of a View or a robot's camera: sizes in the picture are measured with it, motions keep it, another kind of view ends it.
    void adoptedFieldOfViewIsKept() {
        CameraView view;
        view.eye = {0, 0, 3};
        view.target = Vec3::Zero();
        view.fieldOfView = 110 * M_PI / 180;
        ViewCamera camera;
        camera.setView(view);
        const double seen = 2 * 3 * std::tan(0.5 * view.fieldOfView); // m
        QVERIFY(std::abs(camera.metresPerPixel(kWidth, Vec3::Zero()) - seen / kWidth) < 1e-9);
        camera.orbit(0.3, 0.2, Vec3::Zero());
        camera.zoom(0.5, Vec3::Zero());
        camera.zoom(2, Vec3::Zero());
        QVERIFY(std::abs(camera.view().fieldOfView - view.fieldOfView) < 1e-9);
        camera.setKind(ViewKind::Top);
        QVERIFY(std::abs(camera.view().orthographicWidth - seen) < 1e-9);
        camera.setKind(ViewKind::Perspective);
        QVERIFY(std::abs(camera.view().fieldOfView - M_PI / 4) < 1e-9);
        QVERIFY(std::abs(camera.metresPerPixel(kWidth, camera.middle()) - seen / kWidth) < 1e-9);
    }

    void adoptedViewIsUnchanged() {
        CameraView view;
        view.eye = {3, -2, 1.5};
        view.target = {0.5, 0.5, 0.2};
        ViewCamera camera;
        camera.setView(view);
        const CameraView back = camera.view();
        QVERIFY((back.eye - view.eye).norm() < 1e-9 && (back.target - view.target).norm() < 1e-9);
    }
};

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
