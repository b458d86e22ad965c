// Bodies that are smaller than their path in a tick: none passes through the scenery, only they pay for it, and whoever passes through
// another moving body is reported.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

GeomSpec capsule(std::string name, double radius, double length, std::uint32_t surface = 0) {
    GeomSpec geom = cylinder(std::move(name), radius, length, {}, surface);
    geom.shape = GeomShape::Capsule;
    return geom;
}

/// A wall of two triangles in the plane x = 0.
GeomSpec sheet(double width, double height) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, -width, -height}, {0, width, -height}, {0, width, height}, {0, -width, height}};
    mesh->triangles = {{0, 2, 1}, {0, 3, 2}}; // seen from where they come
    GeomSpec geom;
    geom.name = "sheet";
    geom.shape = GeomShape::Mesh;
    geom.mesh = mesh;
    return geom;
}

/// Ground of two triangles in the plane z = 0.
GeomSpec ground(double half) {
    GeomSpec geom = sheet(half, half);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    geom.mesh = mesh;
    return geom;
}

/// s, from `from` to `to` off the vertical, of a thin rod that turns about its end.
double fallTime(double length, double from, double to) {
    double time = 0;
    constexpr int steps = 100000;
    const double most = std::sqrt(to - from); // substituted: the speed is 0 at the start
    for (int i = 0; i < steps; ++i) {
        const double u = (i + 0.5) / steps * most;
        time += 2 * u * (most / steps) / std::sqrt(3 * g / length * (std::cos(from) - std::cos(from + u * u)));
    }
    return time;
}

} // namespace

class SweepTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void walls_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("size"); ///< least half extent
        QTest::addColumn<double>("wall"); ///< thickness, 0: a mesh without any
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("h");
        for (const double h : {0.005, 0.01, 0.03})
            for (const double speed : {1.0, 3.0, 7.0, 12.0, 20.0})
                for (const char* shape : {"ball", "box", "capsule", "cylinder"})
                    QTest::addRow("%s of 20 mm, 5 mm wall, %g m/s, %g ms", shape, speed, 1e3 * h)
                        << shape << 0.02 << 0.005 << speed << h;
        for (const double speed : {5.0, 20.0, 60.0}) {
            QTest::addRow("ball of 10 mm, 1 mm wall, %g m/s", speed) << "ball" << 0.01 << 0.001 << speed << 0.01;
            QTest::addRow("ball of 2 mm, 2 mm wall, %g m/s", speed) << "ball" << 0.002 << 0.002 << speed << 0.01;
            QTest::addRow("ball of 20 mm, sheet, %g m/s", speed) << "ball" << 0.02 << 0.0 << speed << 0.01;
        }
    }
    /// A thousand balls, 250 of the others, start at as many distances, with any orientation and spin.
    void walls() {
        QFETCH(QString, shape);
        QFETCH(double, size);
        QFETCH(double, wall);
        QFETCH(double, speed);
        QFETCH(double, h);
        const int phases = h == 0.01 && shape == "ball" ? 1000 : 250;
        Scene scene(h);
        scene.spec->settings.gravity = Vec3::Zero();
        const double apart = 10 * size, width = phases * apart;
        if (wall > 0) scene.scenery({box("wall", {wall, width + 1, 40 * size})});
        else scene.scenery({sheet(width / 2 + 1, 20 * size)});
        std::mt19937 random(20);
        const auto from = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
        };
        for (int i = 0; i < phases; ++i) {
            const double x = -4 * size - wall - 2 * speed * h * (1 + (i + 0.5) / phases);
            const Pose pose{{x, (i - phases / 2) * apart, 0},
                            rotationFromHpr(degrees(from(-180, 180), from(-90, 90), from(-180, 180)))};
            GeomSpec geom = sphere("b", size);
            if (shape == "box") geom = box("b", Vec3(2, 3, 4) * size);
            if (shape == "capsule") geom = capsule("b", size, 3 * size);
            if (shape == "cylinder") geom = cylinder("b", size, 3 * size);
            scene.loose("b" + std::to_string(i), pose, massOfBox(0.1, Vec3(2, 3, 4) * size), {geom});
        }
        auto world = scene.build();
        QVERIFY(world);
        for (int i = 0; i < phases; ++i) {
            const std::string path = "b" + std::to_string(i) + "/body";
            const Vec3 at = position(*world, path);
            QVERIFY(world->push(path, {0.1 * speed / h, 0, 0}, at).ok());
            if (shape == "ball") continue;
            const Vec3 turn = 1e-4 * size * Vec3(from(-1, 1), from(-1, 1), from(-1, 1)) / h; // some 10 rad/s
            const Vec3 arm = turn.unitOrthogonal();
            QVERIFY(world->push(path, turn.cross(arm), at + arm).ok());
            QVERIFY(world->push(path, -turn.cross(arm), at - arm).ok());
        }
        QVERIFY(run(*world, std::ceil(20 * size / (speed * h) + 8) * h));
        int passed = 0;
        for (int i = 0; i < phases; ++i) passed += position(*world, "b" + std::to_string(i) + "/body").x() > -wall / 2;
        qInfo("%d of %d passed", passed, phases);
        QCOMPARE(passed, 0);
    }

    /// Only what is fast is swept, in the ticks in which it is.
    void costsOnlyTheFast() {
        Scene scene = r0Scene();
        scene.spec->settings.gravity = Vec3::Zero();
        scene.ball("slow", {0, 5, 1}, 1, 0.02).ball("fast", {0, 7, 1}, 1, 0.02).robot("r", {}, r0());
        auto world = scene.build();
        command(*world, "r/leftMotor", 20, 0, 5);
        command(*world, "r/rightMotor", 20, 0, 5);
        QVERIFY(world->push("slow/body", {175, 0, 0}, {0, 5, 1}).ok()); // 1.75 m/s: 17.5 mm in a tick
        QVERIFY(run(*world, 0.5));
        QCOMPARE(world->sweeps().bodies, 0u);
        QVERIFY(world->push("fast/body", {210, 0, 0}, {0, 7, 1}).ok());
        QVERIFY(run(*world, 0.5));
        QCOMPARE(world->sweeps().bodies, 50u);
    }

    /// A driving robot is not swept at 1 m/s: its wheels roll within their own planes.
    void drivingIsNotSwept() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        command(*world, "r/leftMotor", 20, 0, 5);
        command(*world, "r/rightMotor", 18, 0, 5);
        QVERIFY(run(*world, 2));
        QVERIFY(velocity(*world, "r/chassis").norm() > 0.9);
        QCOMPARE(world->sweeps().bodies, 0u);
    }

    void bounces_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("e");
        for (const double h : {0.005, 0.01, 0.03})
            for (const double e : {0.3, 0.8, 1.0}) QTest::addRow("%g ms, e = %g", 1e3 * h, e) << h << e;
    }
    /// Dropped from 20 m: the speeds at the floor, after and before, are as from a rigid bounce.
    void bounces() {
        QFETCH(double, h);
        QFETCH(double, e);
        Scene scene(h);
        const auto s = scene.surface(0.5, e);
        scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, 20.02}, 0.1, 0.02, s);
        auto world = scene.build();
        double lowest = 0, after = 0;
        while (after <= 0 && world->time() < 4) {
            lowest = std::min(lowest, velocity(*world, "ball/body").z());
            QVERIFY(world->tick().ok());
            after = velocity(*world, "ball/body").z();
            QVERIFY(position(*world, "ball/body").z() > 0.0199);
        }
        const double expected = std::sqrt(2 * g * 20);
        qInfo("%.4f, %.4f m/s before, sqrt(2 g h) = %.4f", after, lowest, expected);
        QVERIFY(std::abs(-lowest - expected) < g * h);
        QVERIFY(std::abs(after / -lowest - e) < 0.01);
    }

    void slidesAlong_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<QString>("shape");
        for (const char* floor : {"plane", "box", "tiles"})
            for (const char* shape : {"ball", "box"}) QTest::addRow("%s on %s", shape, floor) << floor << shape;
    }
    /// What moves fast along a surface is not held up by it.
    void slidesAlong() {
        QFETCH(QString, floor);
        QFETCH(QString, shape);
        Scene scene;
        const auto slick = scene.surface(0);
        if (floor == "plane") scene.scenery({plane("floor", {}, slick)});
        if (floor == "box") scene.scenery({box("floor", {60, 2, 0.1}, at(20, 0, -0.05), slick)});
        std::vector<GeomSpec> tiles;
        for (int i = 0; i < 60; ++i) tiles.push_back(box("t" + std::to_string(i), {0.5, 2, 0.1}, at(0.5 * i, 0, -0.05), slick));
        if (floor == "tiles") scene.scenery(tiles);
        if (shape == "ball") scene.ball("b", {0, 0, 0.02 - 5e-6}, 0.1, 0.02, slick);
        else
            scene.loose("b", at(0, 0, 0.02 - 1e-6), massOfBox(0.1, {0.04, 0.04, 0.04}),
                        {box("b", {0.04, 0.04, 0.04}, {}, slick)});
        auto world = scene.build();
        QVERIFY(run(*world, 0.2));
        QVERIFY(world->push("b/body", {200, 0, 0}, position(*world, "b/body")).ok());
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(position(*world, "b/body").x() - 20) < 1e-3);
        QVERIFY(std::abs(position(*world, "b/body").z() - 0.02) < 1e-4);
        QCOMPARE(world->sweeps().bodies, 100u);
    }

    void rollsOverMesh_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("h");
        for (const double h : {0.005, 0.01, 0.03})
            for (const double r : {0.005, 0.02}) QTest::addRow("%g mm, %g ms", 1e3 * r, 1e3 * h) << r << h;
    }
    /// A ball that rolls by more than its radius in a tick moves as fast as its velocity says.
    void rollsOverMesh() {
        QFETCH(double, radius);
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(0.5);
        GeomSpec floor = ground(5);
        floor.surface = s;
        scene.scenery({floor}).ball("b", {-3, 0.3, radius}, 0.1, radius, s);
        auto world = scene.build();
        QVERIFY(run(*world, 0.3));
        const Vec3 at = position(*world, "b/body");
        QVERIFY(world->push("b/body", {0.1 * 4.5 / h, 0, 0}, at + Vec3(0, 0, 0.4 * radius)).ok()); // 4.5 m/s, rolling
        QVERIFY(run(*world, 0.9));
        QVERIFY(world->sweeps().bodies > 0);
        QVERIFY(std::abs(velocity(*world, "b/body").x() - 4.5) < 0.01);
        QVERIFY(std::abs(position(*world, "b/body").x() - at.x() - 4.5 * 0.9) < 0.01);
        QVERIFY(std::abs(position(*world, "b/body").z() - radius) < 1e-4);
    }

    void topples_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("h");
        for (const double h : {0.002, 0.005, 0.01, 0.02})
            for (const char* shape : {"capsule", "box", "cylinder"}) QTest::addRow("%s, %g ms", shape, 1e3 * h) << shape << h;
    }
    /// A pole of 1 m, 20 mm thick, of which the upper end moves farther than that in a tick, falls over about its foot.
    void topples() {
        QFETCH(QString, shape);
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(2);
        const double from = 10 * kPi / 180, to = 80 * kPi / 180;
        GeomSpec geom = shape == "box" ? box("b", {0.02, 0.02, 1}, {}, s) : cylinder("b", 0.01, 1, {}, s);
        if (shape == "capsule") geom = capsule("b", 0.01, 0.98, s);
        const double z = shape == "capsule" ? 0.01 + 0.49 * std::cos(from) : 0.5 * std::cos(from) + 0.01 * std::sin(from);
        scene.scenery({plane("floor", {}, s)}).loose("b", at(0, 0, z, degrees(0, 10, 0)), massOfBox(1, {0.02, 0.02, 1}), {geom});
        auto world = scene.build();
        const auto tilt = [&] {
            const double* p = slot(*world, "b/body/pose");
            return std::acos((Quat(p[3], p[4], p[5], p[6]) * Vec3::UnitZ()).z());
        };
        double lastTilt = tilt(), way = 0;
        const double start = position(*world, "b/body").z();
        while (tilt() < to && world->time() < 2) {
            lastTilt = tilt();
            QVERIFY(world->tick().ok());
            way += h * velocity(*world, "b/body").z();
        }
        const double share = (to - lastTilt) / (tilt() - lastTilt);
        const double foot = shape == "capsule" ? 0 : 0.02; // rad aside of the axis: an edge
        const double expected = fallTime(1, from - foot, to - foot);
        const double fallen = world->time() - (1 - share) * h;
        qInfo("%.4f s, %.4f s", fallen, expected);
        QVERIFY(world->sweeps().bodies > 0);
        QVERIFY(std::abs(fallen / expected - 1) < 0.03);
        QVERIFY(std::abs(way - (position(*world, "b/body").z() - start)) < 0.02);
    }

    /// A robot with one small fast part stops with all of it: its joints stay closed.
    void stopsTheWholeRobot() {
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("hull", {}, massOfBox(1, {0.1, 0.1, 0.1}), {}));
        config->bodies.push_back(body("nose", at(0.3, 0, 0), massOfBox(0.1, {0.02, 0.02, 0.02}), {sphere("nose", 0.01)}));
        config->joints.push_back(joint("j", JointType::Hinge, 0, 1, {0.15, 0, 0}, Vec3::UnitY()));
        scene.scenery({box("wall", {0.005, 2, 2}, at(1, 0, 0))}).robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world->push("r/hull", {1500, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(world->push("r/nose", {150, 0, 0}, {0.3, 0, 0}).ok());
        QVERIFY(run(*world, 0.5));
        QVERIFY(position(*world, "r/nose").x() < 0.99);
    }

    /// Two balls that meet at 40 m/s within a tick are named once.
    void reportsPassing() {
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        scene.ball("left", {-1.1, 0, 0}, 1, 0.02).ball("right", {1.1, 0, 0}, 1, 0.02).ball("far", {0, 0, 1}, 1, 0.02);
        auto world = scene.build();
        QVERIFY(world->push("left/body", {2000, 0, 0}, {-1.1, 0, 0}).ok());
        QVERIFY(world->push("right/body", {-2000, 0, 0}, {1.1, 0, 0}).ok());
        QVERIFY(run(*world, 0.04));
        QCOMPARE(world->sweeps().passed.size(), 0u);
        QVERIFY(run(*world, 0.1));
        const SweepReport report = world->sweeps();
        QCOMPARE(report.passed.size(), 1u);
        QCOMPARE(report.passed[0].first, std::string("left/body/ball"));
        QCOMPARE(report.passed[0].second, std::string("right/body/ball"));
        QVERIFY(position(*world, "left/body").x() > 0.5);
    }

    /// Two robots on a joint, of which one would pass through a thin wall, stop together: the joint stays closed.
    void joinedRobotsStopTogether() {
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        scene.scenery({box("wall", {0.001, 0.2, 0.2})});
        scene.ball("front", {-1.05, 0, 0}, 1, 0.02).ball("beside", {-1.05, 0.5, 0}, 1, 0.02);
        scene.spec->joints.push_back({joint("hitch", JointType::Ball, 0, 0, {-1.05, 0.25, 0}, Vec3::UnitZ()), 0, 1});
        auto world = scene.build();
        QVERIFY(world);
        const auto gap = [&] {
            const auto end = [&](const char* body, double y) -> Vec3 {
                const double* p = slot(*world, std::string(body) + "/body/pose");
                return Pose{Vec3(p), Quat(p[3], p[4], p[5], p[6])} * Vec3(0, y, 0);
            };
            return (end("front", 0.25) - end("beside", -0.25)).norm();
        };
        for (const char* body : {"front", "beside"}) // 20 m/s, 0.2 m in a tick
            QVERIFY(world->push(std::string(body) + "/body", {2000, 0, 0}, position(*world, std::string(body) + "/body")).ok());
        double moved = 0;
        for (int i = 0; i < 10 && (i == 0 || moved > 0.199); ++i) {
            const double before = position(*world, "front/body").x();
            QVERIFY(world->tick().ok());
            moved = position(*world, "front/body").x() - before;
            QVERIFY2(gap() < 1e-4, qPrintable(QString::number(gap())));
        }
        QVERIFY(moved < 0.199 && position(*world, "front/body").x() < 0); // the wall has stopped it
        QVERIFY(std::abs(position(*world, "beside/body").x() - position(*world, "front/body").x()) < 1e-4);
    }

    /// What meets another body in a tick and touches it at its end is a contact.
    void contactsAreNotReported() {
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        scene.ball("ball", {-1, 0, 0}, 0.01, 0.02).loose("block", {}, massOfBox(5, {0.4, 0.4, 0.4}), {box("b", {0.4, 0.4, 0.4})});
        auto world = scene.build();
        QVERIFY(world->push("ball/body", {8, 0, 0}, {-1, 0, 0}).ok());
        QVERIFY(run(*world, 0.3));
        QVERIFY(position(*world, "ball/body").x() < -0.2);
        QCOMPARE(world->sweeps().passed.size(), 0u);
    }
};

QTEST_APPLESS_MAIN(SweepTest)
#include "sweep_test.moc"
