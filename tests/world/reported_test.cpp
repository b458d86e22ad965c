// What a world reports of itself: the forces of contacts as vectors, and where passive objects are.
#include <QtTest>

#include "world/fixtures.h"

using namespace trundle;
using namespace fixture;

namespace {

/// Sum of what the contacts of a robot do to it, N in the world.
struct Load {
    Vec3 normal = Vec3::Zero(), friction = Vec3::Zero();
};

Load loadOn(const World& world, const std::string& robot) {
    Load load;
    for (const WorldContact& c : world.contacts()) {
        const double sign = c.first.starts_with(robot + "/") ? 1 : c.second.starts_with(robot + "/") ? -1 : 0;
        load.normal += sign * c.force * c.normal;
        load.friction += sign * c.friction;
    }
    return load;
}

bool isNear(const Vec3& found, const Vec3& expected, double share) {
    const bool near = (found - expected).norm() <= share * expected.norm();
    if (!near)
        qWarning("found %.6g %.6g %.6g, expected %.6g %.6g %.6g", found.x(), found.y(), found.z(), expected.x(), expected.y(),
                 expected.z());
    return near;
}

} // namespace

class ReportedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void frictionOnASlope_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("slope");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("mu");
        int row = 0;
        for (const double tick : {0.005, 0.01, 0.03})
            for (const auto& [slope, heading, mass, mu] : {std::array{12., 0., 1., 0.5}, std::array{25., 40., 7., 0.6},
                                                           std::array{20., 115., 0.3, 0.2}, std::array{33., 70., 2., 0.25}})
                QTest::addRow("%d: %g s, %g deg", row++, tick, slope) << tick << slope << heading << mass << mu;
    }
    /// A crate that rests feels m g sin up the slope, one that slides mu m g cos against its way.
    void frictionOnASlope() {
        QFETCH(double, tick);
        QFETCH(double, slope);
        QFETCH(double, heading);
        QFETCH(double, mass);
        QFETCH(double, mu);
        Scene scene(tick);
        const auto surface = scene.surface(mu);
        const Pose floor = at(0, 0, 0, degrees(heading, slope, 0));
        const Vec3 size(0.3, 0.2, 0.1);
        scene.scenery({plane("floor", {}, surface)}, floor)
            .loose("crate", floor * at(0, 0, 0.05), massOfBox(mass, size), {box("crate", size, {}, surface)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.6));
        const Vec3 normal = floor.rotation * Vec3::UnitZ(), gravity(0, 0, -g), pull = gravity - gravity.dot(normal) * normal;
        const double a = slope * kPi / 180;
        const bool slides = std::tan(a) > mu;
        const Load load = loadOn(*world, "crate");
        QVERIFY(isNear(load.normal, mass * g * std::cos(a) * normal, 1e-3));
        QVERIFY(isNear(load.friction, -mass * pull * (slides ? mu / std::tan(a) : 1), tick > 0.02 ? 1e-2 : 2e-3));
        for (const WorldContact& c : world->contacts()) QVERIFY(std::abs(c.friction.dot(c.normal)) < 1e-12 * mass * g);
        QCOMPARE(slides, velocity(*world, "crate/body").norm() > 0.1);
    }

    void frictionOfARollingBall_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("%g s", tick) << tick;
    }
    /// 2/7 m g sin turns it; on the floor's side of the pair the force is the opposite.
    void frictionOfARollingBall() {
        QFETCH(double, tick);
        Scene scene(tick);
        const double a = 15 * kPi / 180;
        scene.scenery({plane()}, at(0, 0, 0, {0, a, 0})).ball("b", rotationFromHpr({0, a, 0}) * Vec3(0, 0, 0.06), 1.7, 0.06);
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.9));
        const Vec3 downhill = rotationFromHpr({0, a, 0}) * Vec3::UnitX();
        QVERIFY(velocity(*world, "b/body").dot(downhill) > 1);
        QVERIFY(isNear(loadOn(*world, "b").friction, -2. / 7 * 1.7 * g * std::sin(a) * downhill, 1e-2));
    }

    /// What two things do to each other is equal and opposite: a crate on a crate that is pulled away below it.
    void frictionBetweenTwo() {
        Scene scene(0.005);
        const auto slick = scene.surface(0), rough = scene.surface(0.3);
        const Vec3 size(0.4, 0.4, 0.1), small(0.2, 0.2, 0.1);
        scene.scenery({plane("floor", {}, slick)})
            .loose("lower", at(0, 0, 0.05), massOfBox(5, size), {box("crate", size, {}, rough)})
            .loose("upper", at(0, 0, 0.15), massOfBox(1, small), {box("crate", small, {}, rough)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.2));
        for (int i = 0; i < 40; ++i) {
            QVERIFY(world->push("lower/body", {40, 0, 0}, position(*world, "lower/body")).ok());
            QVERIFY(world->tick().ok());
        }
        QVERIFY(isNear(loadOn(*world, "upper").friction, {0.3 * g, 0, 0}, 2e-3));
        QVERIFY(isNear(loadOn(*world, "lower").friction, {-0.3 * g, 0, 0}, 2e-3));
    }

    void rollingBallsPose_data() { frictionOfARollingBall_data(); }
    /// Its config frame is on the floor, as the shipped ball's: it circles around the ball, but what is reported does not.
    void rollingBallsPose() {
        QFETCH(double, tick);
        constexpr double radius = 0.08;
        Scene scene(tick);
        const Pose start = at(1, 2, 0, degrees(30, 0, 0));
        scene.scenery({plane()}).loose("b", start, massOfSphere(0.2, radius, {0, 0, radius}),
                                       {sphere("ball", radius, at(0, 0, radius))});
        auto world = scene.build();
        QVERIFY(world);
        QCOMPARE(world->robotPose(0).position, start.position);
        QCOMPARE(world->reportedPose(0).position, Vec3(1, 2, radius));
        for (int i = 0; i < 3; ++i) QVERIFY(world->push("b/body", {0, 0.5 / tick / 3, 0}, {1, 2, radius}).ok());
        QVERIFY(run(*world, 0.5)); // it rolls without slip by then
        const Vec3 from = world->reportedPose(0).position, speed = velocity(*world, "b");
        QVERIFY(speed.y() > 1 && std::abs(speed.x()) < 1e-9);
        double turned = 0;
        for (const double t0 = world->time(); world->time() < t0 + 1;) {
            QVERIFY(world->tick().ok());
            turned += spin(*world, "b").norm() * tick;
            const Vec3 now = world->reportedPose(0).position;
            QCOMPARE(position(*world, "b"), now);
            QVERIFY(isNear(now - from, (world->time() - t0) * speed, 1e-3) || (now - from).norm() < 1e-3);
            QVERIFY(std::abs(now.z() - radius) < 1e-4);
            QVERIFY((velocity(*world, "b") - speed).norm() < 1e-3 * speed.norm());
        }
        QVERIFY(turned > 2 * kPi);
        QVERIFY(world->robotPose(0).rotation.isApprox(world->reportedPose(0).rotation));
    }

    /// What has joints, devices or a controller reports its config frame, wherever its centre of mass is.
    void robotsReportTheirConfigFrame() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.5));
        QCOMPARE(world->reportedPose(0).position, world->robotPose(0).position);
        QCOMPARE(position(*world, "r"), world->robotPose(0).position);
    }

    /// A pose given for a passive object is that of its config frame, as in the text.
    void placingAnObject() {
        Scene scene;
        scene.scenery({plane()}).loose("b", {}, massOfSphere(0.2, 0.08, {0, 0, 0.08}), {sphere("ball", 0.08, at(0, 0, 0.08))});
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.1));
        QVERIFY(world->place("b", at(3, 4, 0)).ok());
        QVERIFY(world->tick().ok());
        QVERIFY((world->robotPose(0).position - Vec3(3, 4, 0)).norm() < 1e-4);
        QVERIFY((position(*world, "b") - Vec3(3, 4, 0.08)).norm() < 1e-4);
    }
};

QTEST_APPLESS_MAIN(ReportedTest)
#include "reported_test.moc"
