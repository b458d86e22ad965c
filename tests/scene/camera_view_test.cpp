// Projection of points into a view and rays through its pixels.
#include <QtTest>

#include <random>

#include "scene/queries/camera_view.h"

using namespace trundle;

namespace {

std::mt19937 g_random(7);
double anyNumber(double low, double high) { return std::uniform_real_distribution<double>(low, high)(g_random); }
Vec3 anyPoint(double reach) { return {anyNumber(-reach, reach), anyNumber(-reach, reach), anyNumber(-reach, reach)}; }

CameraView anyView() {
    CameraView view;
    view.eye = anyPoint(10);
    do view.target = anyPoint(10);
    while ((view.target - view.eye).norm() < 0.5);
    view.up = anyPoint(1);
    view.fieldOfView = anyNumber(0.2, 2.6);
    return view;
}

} // namespace

class ViewTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void targetIsCentred() {
        for (int i = 0; i < 100; ++i) {
            const CameraView view = anyView();
            const auto at = project(view, 640, 480, view.target);
            QVERIFY(at);
            QVERIFY(std::abs(at->x - 320) < 1e-6 && std::abs(at->y - 240) < 1e-6);
            QVERIFY(std::abs(at->depth - (view.target - view.eye).norm()) < 1e-9);
        }
    }

    void theFieldOfViewIsHorizontal() {
        CameraView view;
        view.eye = {0, 0, 0};
        view.target = {1, 0, 0};
        view.fieldOfView = std::numbers::pi / 2;
        // 45 degrees to the left (+y) is the left edge, whatever the height of the picture.
        for (const std::uint32_t height : {100u, 480u, 2000u}) {
            const auto at = project(view, 640, height, {2, 2, 0});
            QVERIFY(at);
            QVERIFY(std::abs(at->x) < 1e-9);
            QVERIFY(std::abs(at->y - 0.5 * height) < 1e-9);
        }
        QVERIFY(project(view, 640, 480, {1, 0, 0.5})->y < 240); // up is up
        QVERIFY(!project(view, 640, 480, {-1, 0, 0}));          // behind
    }

    void rayHitsVisiblePoint() {
        for (int i = 0; i < 500; ++i) {
            CameraView view = anyView();
            if (i % 3 == 0) view.orthographicWidth = anyNumber(0.5, 20);
            const Vec3 point = anyPoint(20);
            const auto at = project(view, 800, 600, point);
            if (!at) continue;
            const ViewRay ray = rayThrough(view, 800, 600, at->x, at->y);
            const Vec3 to = point - ray.origin;
            QVERIFY((to - ray.direction * to.dot(ray.direction)).norm() < 1e-6 * (1 + to.norm()));
        }
    }

    void lookingStraightDownIsPossible() {
        CameraView view;
        view.eye = {1, 2, 5};
        view.target = {1, 2, 0};
        QVERIFY(isUsable(view));
        const Mat3 axes = cameraAxes(view);
        QVERIFY((axes.transpose() * axes - Mat3::Identity()).norm() < 1e-12);
        QVERIFY(std::abs(axes.determinant() - 1) < 1e-12);
    }

    void distinguishesInvalidViews() {
        QVERIFY(isUsable(CameraView{}));
        const auto broken = [](auto change) {
            CameraView v;
            change(v);
            return !isUsable(v);
        };
        QVERIFY(broken([](CameraView& v) { v.target = v.eye; }));
        QVERIFY(broken([](CameraView& v) { v.eye.x() = std::nan(""); }));
        QVERIFY(broken([](CameraView& v) { v.up.z() = INFINITY; }));
        QVERIFY(broken([](CameraView& v) { v.fieldOfView = 0; }));
        QVERIFY(broken([](CameraView& v) { v.fieldOfView = 3.2; }));
        QVERIFY(broken([](CameraView& v) {
            v.nearPlane = 2;
            v.farPlane = 1;
        }));
        QVERIFY(broken([](CameraView& v) { v.nearPlane = -1; }));
    }

    void defaultViewContainsAllObjects_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("arena") << 4.2 << 4.2 << 0.3 << 1280 << 720;
        QTest::newRow("robot") << 0.3 << 0.3 << 0.1 << 1280 << 720;
        QTest::newRow("corridor") << 50.0 << 1.0 << 2.0 << 640 << 480;
        QTest::newRow("tower") << 1.0 << 1.0 << 30.0 << 640 << 480;
        QTest::newRow("upright picture") << 4.0 << 4.0 << 0.3 << 300 << 900;
        QTest::newRow("square") << 1.0 << 2.0 << 3.0 << 64 << 64;
    }
    void defaultViewContainsAllObjects() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(int, width);
        QFETCH(int, height);
        Bounds box;
        box.add(Vec3(1, 2, 0));
        box.add(Vec3(1 + x, 2 + y, z));
        const CameraView view = viewOf(box, std::uint32_t(width), std::uint32_t(height));
        QVERIFY(isUsable(view));
        QVERIFY(view.eye.z() > z);
        double widest = 0;
        for (int i = 0; i < 8; ++i) {
            const auto at = project(view, std::uint32_t(width), std::uint32_t(height), box.corner(i));
            QVERIFY(at);
            QVERIFY(at->x > 0 && at->x < width && at->y > 0 && at->y < height);
            widest = std::max({widest, std::abs(at->x / width - 0.5) * 2, std::abs(at->y / height - 0.5) * 2});
        }
        QVERIFY2(widest > 0.8, "the scene is small in its own picture");
    }

    void nothingAtAllIsFramedWithRoomForARobot() {
        const CameraView view = viewOf(Bounds{}, 640, 480);
        QVERIFY(isUsable(view));
        for (const Vec3& p : {Vec3(0.7, 0, 0), Vec3(0, -0.7, 0.3)}) {
            const auto at = project(view, 640, 480, p);
            QVERIFY(at && at->x > 0 && at->x < 640 && at->y > 0 && at->y < 480);
        }
    }

    void lookingAlongItsOwnUp() {
        for (const Vec3& up : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}) {
            CameraView view;
            view.eye = 2 * up;
            view.target = Vec3::Zero();
            view.up = up;
            const Mat3 axes = cameraAxes(view);
            QVERIFY((axes * axes.transpose() - Mat3::Identity()).norm() < 1e-9 && axes.determinant() > 0);
        }
    }

    void aPointIsSeenFromSomeWay() {
        const CameraView view = viewOf({Vec3(1, 2, 3), Vec3(1, 2, 3)}, 400, 300);
        QVERIFY((view.target - Vec3(1, 2, 3)).norm() < 0.02 && (view.eye - view.target).norm() > 0.05);
    }

    void aSettledViewIsRoundInAll() {
        CameraView view;
        view.eye = {1 / 3., 0, 0};
        view.target = {0, 1 / 3., 0};
        view.up = {0.1, 1 / 3., 1};
        const CameraView once = settled(view), twice = settled(once);
        for (const auto& [a, b] : {std::pair(once.eye, twice.eye), {once.target, twice.target}, {once.up, twice.up}})
            QVERIFY(a == b);
        for (int k = 0; k < 3; ++k) QCOMPARE(once.up[k] * (1 << 20), std::round(once.up[k] * (1 << 20)));
    }
};

QTEST_APPLESS_MAIN(ViewTest)
#include "camera_view_test.moc"
