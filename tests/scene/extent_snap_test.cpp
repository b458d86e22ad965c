// What is moved beside other geoms comes to lie flush with them, centred on them, at its mirror image, or in steps.
#include <QtTest>

#include <random>

#include "scene/queries/extent_snap.h"

using namespace trundle;

namespace {

constexpr double kNear = 0.01, kFavour = 0.003;

GeomSpec box(const char* name, const Vec3& size, const Vec3& at = Vec3::Zero()) {
    GeomSpec geom;
    geom.name = name;
    geom.shape = GeomShape::Box;
    geom.size = size;
    geom.pose.position = at;
    return geom;
}

GeomSpec wheel() {
    GeomSpec geom;
    geom.name = "tyre";
    geom.shape = GeomShape::Cylinder;
    geom.radius = 0.05;
    geom.length = 0.03;
    geom.pose.rotation = rotationFromHpr({0, 0, M_PI / 2}); // its axis along y
    return geom;
}

BodySpec body(const char* name, const Vec3& at, std::vector<GeomSpec> geoms) {
    BodySpec made;
    made.name = name;
    made.pose.position = at;
    made.geoms = std::move(geoms);
    return made;
}

/// A hull of 0.4 m x 0.2 m x 0.08 m around (0.013, 0, 0.09), a left wheel at (0.0623, 0.122, 0.05), and a right one elsewhere.
ObjectIndex kit(const Pose& at = {}, std::vector<GeomSpec> more = {}) {
    std::vector<GeomSpec> hull{box("hull", {0.4, 0.2, 0.08}, {0.013, 0, 0.09})};
    hull.insert(hull.end(), more.begin(), more.end());
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies = {body("chassis", {0, 0, 0}, hull), body("left", {0.0623, 0.122, 0.05}, {wheel()}),
                      body("right", {-0.11, -0.2, 0.05}, {wheel()}), body("lid", {0.3, 0.3, 0.3}, {box("b", {0.1, 0.06, 0.02})})};
    RobotSpec robot;
    robot.name = "kit";
    robot.pose = at;
    robot.config = config;
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->robots = {robot};
    return ObjectIndex(experiment);
}

SnapExtents extentsOf(
    const ObjectIndex& objects, const char* moved, const Mat3& axes = Mat3::Identity(),
    const std::function<bool(const ObjectRef&)>& counts = [](const ObjectRef&) { return true; }) {
    return SnapExtents::of(objects, startPoses(objects.experiment()), {*objects.find(moved)}, counts, axes);
}

/// A motion along one axis, in steps of 5 cm.
ExtentSnap along(const SnapExtents& extents, int axis, double by, double favour = kFavour) {
    ExtentSnapOptions options;
    options.by[axis] = by;
    options.stepped[axis] = 0.05 * std::round(by / 0.05);
    options.near[axis] = kNear;
    options.favour[axis] = favour;
    return snapExtents(extents, options);
}

bool isClose(double a, double b) { return std::abs(a - b) < 1e-9; }

} // namespace

class ExtentSnapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void facesAndCentres_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<double>("by");
        QTest::addColumn<double>("snapped");
        QTest::addColumn<bool>("isCaught");
        // Of the lid: x 0.25 to 0.35, y 0.27 to 0.33, z 0.29 to 0.31. Of the hull: -0.187 to 0.213, -0.1 to 0.1, 0.05 to 0.13.
        QTest::newRow("on the top") << 2 << -0.154 << -0.16 << true;
        QTest::newRow("flush with the top") << 2 << -0.176 << -0.18 << true;
        QTest::newRow("its middle at the front") << 0 << -0.0865 << -0.087 << true;
        QTest::newRow("rather an end at an end") << 2 << -0.1695 << -0.16 << true;
        QTest::newRow("below the bottom") << 2 << -0.263 << -0.26 << true;
        QTest::newRow("beside the right face") << 1 << -0.434 << -0.43 << true;
        QTest::newRow("flush with the right face") << 1 << -0.372 << -0.37 << true;
        QTest::newRow("centred on the hull") << 0 << -0.2832 << -0.287 << true;
        QTest::newRow("on the axis of the model") << 0 << -0.301 << -0.3 << true;
        QTest::newRow("too far away") << 1 << 0.16 << 0.15 << false;
        QTest::newRow("nothing there") << 2 << 0.312 << 0.3 << false;
    }
    void facesAndCentres() {
        QFETCH(int, axis);
        QFETCH(double, by);
        QFETCH(double, snapped);
        QFETCH(bool, isCaught);
        const ExtentSnap snap = along(extentsOf(kit(), "kit.lid"), axis, by);
        QVERIFY2(isClose(snap.by[axis], snapped), qPrintable(QString::number(snap.by[axis])));
        QCOMPARE(snap.guides.empty(), !isCaught);
        QVERIFY(snap.by[(axis + 1) % 3] == 0 && snap.by[(axis + 2) % 3] == 0);
    }

    /// A rectangle around both, in the plane of the face.
    void guidesAreInThePlane() {
        const ExtentSnap snap = along(extentsOf(kit(), "kit.lid"), 2, -0.154);
        QCOMPARE(snap.guides.size(), std::size_t(4));
        Bounds all;
        for (const auto& line : snap.guides)
            for (const Vec3& end : line) all.add(end);
        QVERIFY(all.low.isApprox(Vec3(-0.187, -0.1, 0.13)) && all.high.isApprox(Vec3(0.35, 0.33, 0.13)));
    }

    void aNearerStepWins() {
        const SnapExtents extents = extentsOf(kit(), "kit.lid");
        // The top is reached at -0.16, the step is at -0.15.
        QVERIFY(isClose(along(extents, 2, -0.152, 0).by.z(), -0.15));
        QVERIFY(isClose(along(extents, 2, -0.1538, 0).by.z(), -0.15));
        QVERIFY(isClose(along(extents, 2, -0.1538).by.z(), -0.16)); // favoured
        QVERIFY(isClose(along(extents, 2, -0.15).by.z(), -0.15));
    }

    void oppositeOfALikeWheel() {
        const SnapExtents extents = extentsOf(kit(), "kit.right");
        const ExtentSnap snap = along(extents, 1, 0.0745);
        QVERIFY2(isClose(snap.by.y(), 0.078), qPrintable(QString::number(snap.by.y()))); // at -0.122
        QCOMPARE(snap.guides.size(), std::size_t(1));                                    // from the one to the other
        QVERIFY(snap.guides[0][0].isApprox(Vec3(0.0623, 0.122, 0.05)) && snap.guides[0][1].isApprox(Vec3(-0.11, -0.122, 0.05)));
        QVERIFY(isClose(along(extents, 0, 0.1705).by.x(), 0.1723)); // beside the left one
        for (const SnapExtents::Target& target : extentsOf(kit(), "kit.lid").targets) QVERIFY(!target.source); // of another size
    }

    void twoAxesAtOnce() {
        ExtentSnapOptions options;
        options.by = {-0.2832, -0.434, 0.2};
        options.stepped = {-0.3, -0.45, 0};
        options.near = {kNear, kNear, 0};
        const ExtentSnap snap = snapExtents(extentsOf(kit(), "kit.lid"), options);
        QVERIFY(snap.by.isApprox(Vec3(-0.287, -0.43, 0)));
        QCOMPARE(snap.guides.size(), std::size_t(8));
    }

    void ballsAreTargetsToo() {
        GeomSpec ball;
        ball.name = "ball";
        ball.shape = GeomShape::Sphere;
        ball.radius = 0.04;
        ball.pose.position = {0, 0, 0.53};
        QVERIFY(isClose(along(extentsOf(kit({}, {ball}), "kit.lid"), 2, 0.263).by.z(), 0.26)); // on its top
    }

    void whatDoesNotCountIsNoTarget() {
        const ObjectIndex objects = kit();
        const auto counts = [&](const ObjectRef& geom) { return objects.pathOf(geom) != "kit.chassis.hull"; };
        QVERIFY(isClose(along(extentsOf(objects, "kit.lid", Mat3::Identity(), counts), 2, -0.154).by.z(), -0.15));
        GeomSpec unseen = box("unseen", {0.1, 0.1, 0.1}, {0, 0, 0.5});
        unseen.visible = false;
        QVERIFY(isClose(along(extentsOf(kit({}, {unseen}), "kit.lid"), 2, 0.136).by.z(), 0.15));
    }

    /// A geom beside the others of its own body, and of another static none.
    void geomsOfAStatic() {
        auto experiment = std::make_shared<ExperimentSpec>();
        for (const char* name : {"yard", "other"}) {
            StaticSpec fixed;
            fixed.name = name;
            fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(
                std::vector{box("a", {0.2, 0.2, 0.2}), box("b", {0.1, 0.1, 0.1}, {1, 1, 1})});
            fixed.pose.position.x() = experiment->statics.empty() ? 0.013 : 3.377;
            experiment->statics.push_back(fixed);
        }
        const ObjectIndex objects(experiment);
        const SnapExtents extents = extentsOf(objects, "yard.b");
        QCOMPARE(extents.targets.size(), std::size_t(2)); // the other geom and the origin
        QVERIFY(isClose(along(extents, 0, -0.853).by.x(), -0.85));
        QVERIFY(isClose(along(extents, 0, -1.003).by.x(), -1));
    }

    /// Of a turned model along its own axes: as if it were not turned.
    void aTurnedModel() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> some(-1, 1);
        const SnapExtents straight = extentsOf(kit(), "kit.right");
        for (int i = 0; i < 200; ++i) {
            const Pose at{{some(random), some(random), some(random)},
                          rotationFromHpr({3 * some(random), some(random), 3 * some(random)})};
            const SnapExtents turned = extentsOf(kit(at), "kit.right", at.rotation.toRotationMatrix());
            QCOMPARE(turned.targets.size(), straight.targets.size());
            for (const int axis : {0, 1, 2}) {
                const double by = 0.3 * some(random);
                const ExtentSnap expected = along(straight, axis, by), snap = along(turned, axis, by);
                QVERIFY(snap.by.isApprox(expected.by, 1e-9) || (snap.by - expected.by).norm() < 1e-9);
                QCOMPARE(snap.guides.size(), expected.guides.size());
                // Never farther away than the step, or what is near.
                QVERIFY(std::abs(snap.by[axis] - by) < 0.025 + kFavour + 1e-9);
            }
        }
    }

    /// The rectangle has its four corners, in their order.
    void guidesGoAround() {
        const ExtentSnap snap = along(extentsOf(kit(), "kit.lid"), 2, -0.154);
        QCOMPARE(snap.guides.size(), std::size_t(4));
        double length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(snap.guides[i][1].isApprox(snap.guides[(i + 1) % 4][0]));
            const Vec3 side = snap.guides[i][1] - snap.guides[i][0];
            QVERIFY(side.cwiseAbs().minCoeff() < 1e-12 && (std::abs(side.x()) < 1e-12 || std::abs(side.y()) < 1e-12));
            length += side.norm();
        }
        QVERIFY(isClose(length, 2 * (0.537 + 0.43)));
    }

    /// Neither what is not seen of it, nor of the others.
    void whatIsNotSeenDoesNotCount() {
        GeomSpec hidden = box("hidden", {2, 2, 2});
        hidden.visible = false;
        const SnapExtents whole = extentsOf(kit({}, {hidden}), "kit.chassis");
        QVERIFY(whole.thing.low.isApprox(Vec3(-0.187, -0.1, 0.05)) && whole.thing.high.isApprox(Vec3(0.213, 0.1, 0.13)));
        QCOMPARE(extentsOf(kit({}, {hidden}), "kit.lid").targets.size(), extentsOf(kit(), "kit.lid").targets.size());
    }
};

QTEST_APPLESS_MAIN(ExtentSnapTest)
#include "extent_snap_test.moc"
