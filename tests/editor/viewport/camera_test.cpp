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
