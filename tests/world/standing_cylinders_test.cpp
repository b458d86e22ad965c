// Cylinders that stand on an end: put down oblique they come to rest on planes, boxes, meshes and each other, and slide as boxes do.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kRadius = 0.05, kLength = 0.06;

GeomSpec mesh(std::uint32_t surface) {
    auto triangles = std::make_shared<TriangleMesh>();
    constexpr int kSteps = 7;
    for (int j = 0; j <= kSteps; ++j)
        for (int i = 0; i <= kSteps; ++i) triangles->points.push_back({3.0 * i / kSteps - 1.5, 3.0 * j / kSteps - 1.5, 0});
    for (std::uint32_t j = 0; j < kSteps; ++j)
        for (std::uint32_t i = 0; i < kSteps; ++i) {
            const std::uint32_t a = j * (kSteps + 1) + i, b = a + kSteps + 1;
            triangles->triangles.push_back({a, a + 1, b + 1});
            triangles->triangles.push_back({a, b + 1, b});
        }
    GeomSpec geom = plane("ground", {}, surface);
    geom.shape = GeomShape::Mesh;
    geom.mesh = triangles;
    return geom;
}

/// Its highest point is the origin.
GeomSpec ground(const std::string& shape, std::uint32_t surface) {
    const Pose below{{0, 0, -0.05}, Quat::Identity()};
    if (shape == "plane") return plane("ground", {}, surface);
    if (shape == "box") return box("ground", {3, 3, 0.1}, below, surface);
    if (shape == "post") return box("ground", {0.03, 0.04, 0.1}, below, surface);
    if (shape == "beam") return box("ground", {0.03, 2, 0.1}, below, surface);
    if (shape == "cylinder") return cylinder("ground", 0.045, 0.1, below, surface);
    if (shape == "mesh") return mesh(surface);
    return cylinder("ground", 1.5, 0.1, below, surface);
}

void addCan(Scene& scene, const std::string& name, const Pose& pose, std::uint32_t surface) {
    scene.loose(name, pose, massOfCylinder(0.3, kRadius, kLength), {cylinder("g", kRadius, kLength, {}, surface)});
}

/// rad, between the axis and up.
double tilt(const World& world, std::size_t robot) {
    const Vec3 axis = world.robotPose(robot).rotation * Vec3::UnitZ();
    return std::acos(std::min(1.0, std::abs(axis.z())));
}

double motion(World& world, const std::string& body) { return velocity(world, body).norm() + kRadius * spin(world, body).norm(); }

} // namespace

class StandingCylindersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void comesToRest_data() {
        QTest::addColumn<QString>("on");
        QTest::addColumn<double>("tick");
        for (const char* on : {"plane", "box", "post", "beam", "cylinder", "drum", "mesh"})
            for (const double tick : {0.005, 0.01, 0.02, 0.03}) QTest::addRow("on a %s, %g ms", on, 1e3 * tick) << on << tick;
    }
    void comesToRest() {
        QFETCH(QString, on);
        QFETCH(double, tick);
        Scene scene(tick);
        const auto s = scene.surface(0.6);
        scene.scenery({ground(on.toStdString(), s)});
        addCan(scene, "can", at(0, 0, kLength / 2 + 0.003, degrees(20, 1.5, 0)), s);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(run(*world, 6));
        const double z = world->robotPose(0).position.z();
        const QString where = QString("z %1, tilt %2, %3 m/s").arg(z).arg(tilt(*world, 0)).arg(motion(*world, "can/body"));
        QVERIFY2(std::abs(z - kLength / 2) < 1e-4 && tilt(*world, 0) < 1e-3 && motion(*world, "can/body") < 1e-6,
                 qPrintable(where));
    }

    /// What starts flush with a slope of 3 degrees stays there, or slides as theory has it.
    void slides_data() {
        QTest::addColumn<QString>("on");
        QTest::addColumn<double>("tick");
        for (const char* on : {"plane", "box", "mesh"})
            for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("on a %s, %g ms", on, 1e3 * tick) << on << tick;
    }
    void slides() {
        QFETCH(QString, on);
        QFETCH(double, tick);
        const double slope = 3 * kPi / 180;
        for (const double friction : {0.5, 0.03}) {
            Scene scene(tick);
            const auto s = scene.surface(friction);
            const Pose turned = at(0, 0, 0, degrees(0, 3, 0));
            scene.scenery({ground(on.toStdString(), s)}, turned);
            addCan(scene, "can", {turned.rotation * Vec3(-1, 0, kLength / 2), turned.rotation}, s);
            auto world = scene.build();
            QVERIFY(world);
            const double seconds = 1.5;
            QVERIFY(run(*world, seconds));
            const double speed = velocity(*world, "can/body").dot(turned.rotation * Vec3::UnitX());
            const double theory = std::max(0.0, seconds * g * (std::sin(slope) - friction * std::cos(slope)));
            QVERIFY2(std::abs(speed - theory) < 1e-3 * theory + (on == "mesh" ? 1e-4 : 1e-6),
                     qPrintable(QString("%1, not %2").arg(speed).arg(theory)));
            QVERIFY(spin(*world, "can/body").norm() < 1e-3);
        }
    }

    /// Cans on each other and a box between them, none of them put down straight.
    void stackComesToRest() {
        for (const double tick : {0.005, 0.01}) {
            Scene scene(tick);
            const auto s = scene.surface(0.5);
            scene.scenery({plane("floor", {}, s)});
            addCan(scene, "a", at(0, 0, 0.033, degrees(10, 1.5, 0)), s);
            addCan(scene, "b", at(0.01, 0, 0.097, degrees(10, -1.5, 0)), s);
            scene.loose("c", at(0, 0, 0.16, degrees(10, 1, 0)), massOfBox(0.3, {0.2, 0.12, 0.06}),
                        {box("g", {0.2, 0.12, 0.06}, {}, s)});
            addCan(scene, "d", at(0.06, 0, 0.223, degrees(0, -1, 0)), s);
            auto world = scene.build();
            QVERIFY(world);
            QVERIFY(run(*world, 5));
            for (std::size_t i = 0; i < 4; ++i) {
                const double z = world->robotPose(i).position.z();
                QVERIFY2(std::abs(z - 0.03 - 0.06 * static_cast<double>(i)) < 3e-4 && tilt(*world, i) < 2e-3,
                         qPrintable(QString("%1: z %2").arg(i).arg(z)));
                QVERIFY(motion(*world, std::string(1, static_cast<char>('a' + i)) + "/body") < 1e-5);
            }
        }
    }

    /// Discs that are let go oblique and turning whirl less and less.
    void discsLieDown() {
        for (const double tick : {0.005, 0.01, 0.02})
            for (const double radius : {0.05, 0.1})
                for (const double tilted : {30.0, 60.0}) {
                    Scene scene(tick);
                    const auto s = scene.surface(0.6);
                    scene.scenery({plane("floor", {}, s)});
                    const double length = 0.3 * radius, rise = tilted * kPi / 180;
                    const double z = radius * std::sin(rise) + length / 2 * std::cos(rise) + 1e-3;
                    scene.loose("disc", at(0, 0, z, degrees(20, tilted, 0)), massOfCylinder(1, radius, length),
                                {cylinder("g", radius, length, {}, s)});
                    auto world = scene.build();
                    QVERIFY(world);
                    const Vec3 aside(0.02 / tick, 0, 0), lever = world->robotPose(0).rotation * Vec3(0, radius, 0);
                    QVERIFY(world->push("disc/body", aside, world->robotPose(0).position + lever).ok());
                    QVERIFY(run(*world, 8));
                    QVERIFY2(motion(*world, "disc/body") < 1e-4 && std::abs(world->robotPose(0).position.z() - length / 2) < 2e-4,
                             qPrintable(
                                 QString("%1 m/s, z %2").arg(motion(*world, "disc/body")).arg(world->robotPose(0).position.z())));
                }
    }

    /// What meets the side of an upright cylinder is beside it, not on it, also where that is low.
    void sideIsNoEnd() {
        Scene scene;
        const auto s = scene.surface(0);
        scene.scenery({box("ground", {4, 4, 0.1}, at(0, 0, -0.05), s), box("kerb", {0.1, 1, 0.01}, at(0.5, 0, 0.005), s)});
        addCan(scene, "can", at(0, 0, kLength / 2), s);
        auto world = scene.build();
        for (int i = 0; i < 20; ++i) {
            QVERIFY(world->push("can/body", {1.5, 0, 0}, world->robotPose(0).position).ok());
            QVERIFY(world->tick().ok());
        }
        QVERIFY(run(*world, 3));
        const Vec3 place = world->robotPose(0).position;
        QVERIFY2(place.x() < 0.41 && std::abs(place.z() - kLength / 2) < 0.01, qPrintable(QString::number(place.x())));
    }
};

QTEST_APPLESS_MAIN(StandingCylindersTest)
#include "standing_cylinders_test.moc"
