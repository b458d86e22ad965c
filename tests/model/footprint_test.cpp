// What shapes cover of the ground, and the disc that a robot needs, against the extents of the shapes along each axis.
#include <QTest>

#include <cmath>
#include <numbers>

#include "model/resolve/footprint.h"

using namespace trundle;

namespace {

GeomSpec shapeOf(GeomShape shape, const Pose& pose = {}) {
    GeomSpec geom;
    geom.shape = shape;
    geom.pose = pose;
    geom.size = {0.6, 0.4, 0.2};
    geom.radius = 0.1;
    geom.length = 0.5;
    return geom;
}

Pose turned(double heading, double pitch, double roll, const Vec3& position = Vec3::Zero()) {
    return {position, rotationFromHpr(Vec3(heading, pitch, roll) * (std::numbers::pi / 180))};
}

/// How far a shape reaches along a direction from its centre (m); of a cylinder a little more, as its rim is a polygon around it.
double reach(const GeomSpec& geom, const Vec3& direction) {
    const Vec3 d = geom.pose.rotation.conjugate() * direction;
    switch (geom.shape) {
    case GeomShape::Box: return 0.5 * geom.size.dot(d.cwiseAbs());
    case GeomShape::Sphere: return geom.radius;
    case GeomShape::Capsule: return 0.5 * geom.length * std::abs(d.z()) + geom.radius;
    default: return 0.5 * geom.length * std::abs(d.z()) + geom.radius * std::hypot(d.x(), d.y());
    }
}

RobotDisc discOfOne(const GeomSpec& geom, const Pose& pose) {
    RobotConfigSpec config;
    BodySpec body;
    body.pose = pose;
    body.geoms = {geom};
    config.bodies = {body};
    return discOf(config);
}

} // namespace

class FootprintTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void heights_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("pitch");
        for (const GeomShape shape : {GeomShape::Box, GeomShape::Sphere, GeomShape::Capsule, GeomShape::Cylinder})
            for (const double pitch : {0., 35., 90., -120.}) QTest::addRow("%d %g", int(shape), pitch) << int(shape) << pitch;
    }
    /// Low and high are those of the shape, of a footprint and of a disc.
    void heights() {
        QFETCH(int, shape);
        QFETCH(double, pitch);
        const GeomSpec geom = shapeOf(GeomShape(shape), turned(20, pitch, 0));
        const Pose pose{Vec3(1, 2, 0.7), Quat::Identity()};
        const double up = reach(geom, Vec3::UnitZ()), slack = shape == int(GeomShape::Cylinder) ? 0.02 * geom.radius : 1e-12;
        const std::vector<Footprint> all = footprintsOf(geom, pose);
        QCOMPARE(all.size(), std::size_t{1});
        const RobotDisc disc = discOfOne(geom, pose);
        for (const auto& [low, high] : {std::pair(all[0].low, all[0].high), std::pair(disc.low, disc.high)}) {
            QVERIFY(low <= 0.7 - up + 1e-12 && low >= 0.7 - up - slack);
            QVERIFY(high >= 0.7 + up - 1e-12 && high <= 0.7 + up + slack);
        }
    }

    /// The disc contains the shape at any heading: its radius is the way to the farthest point.
    void radii() {
        const Pose aside{Vec3(0.3, 0, 0), Quat::Identity()};
        QVERIFY(std::abs(discOfOne(shapeOf(GeomShape::Sphere), aside).radius - 0.4) < 1e-12);
        QVERIFY(std::abs(discOfOne(shapeOf(GeomShape::Capsule), aside).radius - 0.4) < 1e-12);
        QVERIFY(std::abs(discOfOne(shapeOf(GeomShape::Capsule, turned(0, 90, 0)), aside).radius - 0.65) < 1e-12);
        QVERIFY(std::abs(discOfOne(shapeOf(GeomShape::Box), aside).radius - std::hypot(0.6, 0.2)) < 1e-12);
    }

    /// What touches a robot from above or below is no obstacle; what is a little inside is.
    void heightsThatMeet() {
        const Footprint wall = footprintsOf(shapeOf(GeomShape::Box), {Vec3(0, 0, 0.1), Quat::Identity()})[0]; // from 0 to 0.2
        QVERIFY(wall.meets({0, 0}, 0.1, 0, 1));
        QVERIFY(!wall.meets({0, 0}, 0.1, 0.2, 1));
        QVERIFY(!wall.meets({0, 0}, 0.1, 0.1995, 1));
        QVERIFY(wall.meets({0, 0}, 0.1, 0.19, 1));
        QVERIFY(!wall.meets({0, 0}, 0.1, -1, 0));
        QVERIFY(wall.meets({0, 0}, 0.1, -1, 0.01));
    }

    /// Beside it: the distance from its edges, less what it is grown by.
    void distancesThatMeet() {
        const Footprint wall =
            footprintsOf(shapeOf(GeomShape::Box), turned(90, 0, 0, {5, 0, 0.1}))[0]; // 0.4 along x, 0.6 along y
        QVERIFY(wall.meets({5.29, 0}, 0.1, 0, 1) && !wall.meets({5.31, 0}, 0.1, 0, 1));
        QVERIFY(wall.meets({5, -0.39}, 0.1, 0, 1) && !wall.meets({5, -0.41}, 0.1, 0, 1));
        QVERIFY(wall.meets({5.26, 0.36}, 0.1, 0, 1) && !wall.meets({5.28, 0.38}, 0.1, 0, 1)); // a corner
        const Footprint ball = footprintsOf(shapeOf(GeomShape::Sphere), {Vec3(0, 5, 0.1), Quat::Identity()})[0];
        QVERIFY(ball.meets({0.19, 5}, 0.1, 0, 1) && !ball.meets({0.21, 5}, 0.1, 0, 1));
        const Footprint lying =
            footprintsOf(shapeOf(GeomShape::Capsule, turned(0, 90, 0)), {Vec3(0, 0, 0.1), Quat::Identity()})[0];
        QVERIFY(lying.meets({0.44, 0}, 0.1, 0, 1) && !lying.meets({0.46, 0}, 0.1, 0, 1));
        QVERIFY(lying.meets({0, 0.19}, 0.1, 0, 1) && !lying.meets({0, 0.21}, 0.1, 0, 1));
    }

    void whatCoversNothing() {
        GeomSpec ghost = shapeOf(GeomShape::Box);
        ghost.collide = false;
        for (const GeomSpec& geom : {ghost, shapeOf(GeomShape::Plane), shapeOf(GeomShape::Heightfield)}) {
            QVERIFY(footprintsOf(geom, {}).empty());
            const RobotDisc disc = discOfOne(geom, {});
            QVERIFY(disc.radius == 0 && disc.low == 0 && disc.high == 0);
        }
    }
};

QTEST_APPLESS_MAIN(FootprintTest)
#include "footprint_test.moc"
