// Engine = planar, where it is unlike the wheeled engine: vehicles keep their height, do not lean, and put on each wheel what it carries
// at rest. What both have in common is in wheeled_test.cpp.
#include <QtTest>

#include <map>

#include "world/fixtures.h"
#include "world/wheeled/planar_shape.h"

using namespace fixture;

namespace {

constexpr double kStrong = 50; // N m: more than any friction here
constexpr double kMass = 4.4, kAhead = 0.03 * 4 / 4.4,
                 kSlider = 0.13; // of R0: kg; the axle before the centre of mass and the slider, m

Scene planarScene(double friction = 1, double tick = 0.01) {
    Scene scene = r0Scene(tick, friction);
    scene.spec->settings.engine = EngineChoice::Planar;
    scene.scenery({plane("floor", {}, 1)});
    return scene;
}

void drive(World& world, double left, double right, double limit = kStrong) {
    command(world, "r/leftMotor", left / kR0Radius, 0, limit);
    command(world, "r/rightMotor", right / kR0Radius, 0, limit);
}

bool isLevel(World& world, double height) {
    const Pose pose = world.robotPose(0);
    return pose.position.z() == height && pose.rotation.x() == 0 && pose.rotation.y() == 0;
}

} // namespace

class PlanarTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// By the lever, whatever the robot does.
    void loads() {
        Scene scene = planarScene();
        scene.robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world);
        for (const double speed : {0., 2., -2.}) {
            drive(*world, speed, speed);
            QVERIFY(world->tick().ok());
            double slider = 0, wheels = 0;
            for (const WorldContact& c : world->contacts()) (c.first == "r/chassis/slider" ? slider : wheels) += c.force;
            QVERIFY2(std::abs(slider - kMass * g * kAhead / kSlider) < 1e-9, qPrintable(QString::number(slider)));
            QVERIFY(std::abs(wheels + slider - kMass * g) < 1e-9);
        }
    }

    void gripsWithThatLoad_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.01, 0.03}) QTest::newRow(qPrintable(QString::number(tick))) << tick;
    }
    /// Wheels that spin give mu times their load at rest; the general engine's loads shift by m a z / base more.
    void gripsWithThatLoad() {
        QFETCH(double, tick);
        Scene scene = planarScene(0.4, tick);
        scene.robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world && run(*world, 30 * tick));
        const double grip = 0.4 * g * (1 - kAhead / kSlider);
        for (const double way : {1., -1.}) {
            drive(*world, way * 100, way * 100);
            QVERIFY(run(*world, 0.06)); // until the wheels spin that way
            const double before = velocity(*world, "r/chassis").x(), since = world->time();
            QVERIFY(run(*world, 0.3));
            const double gained = velocity(*world, "r/chassis").x() - before, seconds = world->time() - since;
            qInfo("%.6f m/s^2, closed form %.6f", way * gained / seconds, grip);
            QVERIFY(std::abs(way * gained / seconds / grip - 1) < 1e-6);
        }
    }

    void staysLevel() {
        Scene scene = planarScene();
        scene.scenery({box("wall", {0.1, 4, 0.3}, at(1, 0, 0.15), 3)}, {}, "room");
        scene.robot("r", {}, r0())
            .loose("crate", at(0.5, 0.02, 0.02), massOfBox(1, {0.1, 0.1, 0.04}), {box("b", {0.1, 0.1, 0.04}, {}, 3)});
        auto world = scene.build();
        QVERIFY(world);
        const double height = world->robotPose(0).position.z();
        for (int i = 0; i < 300; ++i) {
            drive(*world, i < 250 ? 1 : -1, i < 250 ? 1 : -1);
            if (i % 10 == 0) QVERIFY(world->push("r/chassis", {5, i % 20 == 0 ? 20 : -20, 30}, {0.1, 0, 0.5}).ok());
            QVERIFY(world->tick().ok());
            QVERIFY(isLevel(*world, height));
        }
        QVERIFY(world->robotFaults().ends.empty());
        QVERIFY(position(*world, "crate/body").x() > 0.8); // it was pushed to the wall
    }

    /// Wherever it starts or is placed, it is on the ground.
    void isSetDown() {
        Scene scene = planarScene();
        scene.robot("r", at(0, 0, 0.004), r0());
        auto world = scene.build();
        QVERIFY(world && world->tick().ok());
        QVERIFY(std::abs(world->robotPose(0).position.z()) < 1e-9);
        QVERIFY(world->place("r", at(1, 0, 0.3)).ok() && world->tick().ok());
        QVERIFY((world->robotPose(0).position - Vec3(1, 0, 0)).norm() < 1e-9);
        for (const WorldContact& c : world->contacts()) QVERIFY(std::abs(c.position.z()) < 1e-9);
    }

    /// All supports in one line, and one that would have to pull.
    void carriesOnAnySupports() {
        for (const double third : {-0.0001, -0.3}) {
            Scene scene = planarScene();
            auto config = std::make_shared<RobotConfigSpec>(*r0());
            config->bodies[0].mass.centre.x() = 0;
            config->bodies[0].geoms[1].pose.position.x() = third;
            config->bodies[0].geoms.push_back(sphere("bow", 0.015, at(0.1, 0, 0.015), 2));
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world && run(*world, 0.05));
            double total = 0;
            for (const WorldContact& c : world->contacts()) {
                QVERIFY(c.force >= 0);
                total += c.force;
            }
            QVERIFY(std::abs(total - kMass * g) < 1e-9);
        }
    }

    /// Lying or upright, its caps are part of it.
    void aCapsuleReachesItsTips() {
        GeomSpec pill = cylinder("pill", 0.1, 0.6);
        pill.shape = GeomShape::Capsule;
        const Vec3 centre(0.3, -0.2, 0.5);
        const Quat turns[3] = {Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitY())), Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX())),
                               Quat::Identity()};
        for (int axis = 0; axis < 3; ++axis) { // along x, y and z
            const Result<PlanarShape> made = planarShapeOf(pill, Pose{centre, turns[axis]});
            QVERIFY(made.ok());
            const PlanarShape& shape = made.value();
            Vec3 least(1e9, 1e9, shape.low), most(-1e9, -1e9, shape.high);
            for (const Vec2& corner : shape.corners)
                for (int k = 0; k < 2; ++k) {
                    least[k] = std::min(least[k], corner[k]);
                    most[k] = std::max(most[k], corner[k]);
                }
            for (int k = 0; k < 3; ++k) {
                const double reach = k == axis ? 0.4 : 0.1;
                QVERIFY2(std::abs(most[k] - centre[k] - reach) < 1e-9, qPrintable(QString::number(most[k])));
                QVERIFY2(std::abs(centre[k] - least[k] - reach) < 1e-9, qPrintable(QString::number(least[k])));
            }
            QVERIFY(std::abs(shape.bound - (axis == 2 ? 0.1 : 0.4)) < 1e-9);
        }
    }

    /// A slope is given by the direction of gravity: a robot that holds its wheels holds up to mu times their load, which leans on what is
    /// downhill: tan = mu (1 - (a + z tan) / b), a and b: from the axle to the centre of mass and to the slider.
    void holdsOnASlope() {
        for (const double angle : {13.8, 14.2}) { // the limit for mu = 0.4 is 14.02 degrees
            Scene scene = planarScene(0.4);
            scene.spec->settings.gravity = g * Vec3(-std::sin(angle * kPi / 180), 0, -std::cos(angle * kPi / 180));
            scene.robot("r", {}, r0());
            auto world = scene.build();
            QVERIFY(world);
            drive(*world, 0, 0);
            QVERIFY(run(*world, 1));
            QCOMPARE(velocity(*world, "r/chassis").norm() < 1e-6, angle < 14);
        }
    }

    /// What slides down leans by what its friction holds, and what rolls down does not lean.
    void leansByWhatItHolds() {
        for (const bool locked : {true, false})
            for (const double along : {4., -4.}) {
                double gained[2] = {};
                for (const int general : {0, 1}) {
                    Scene scene = planarScene(0.3);
                    if (general) scene.spec->settings.engine = EngineChoice::General;
                    scene.spec->settings.gravity = {along, 0, -9};
                    scene.robot("r", {}, r0());
                    auto world = scene.build();
                    QVERIFY(world);
                    drive(*world, 0, 0, locked ? kStrong : 0);
                    QVERIFY(run(*world, 0.5));
                    gained[general] = velocity(*world, "r/chassis").x();
                }
                qInfo("%.4f m/s, in general %.4f", gained[0], gained[1]);
                QVERIFY(std::abs(gained[0] / gained[1] - 1) < 0.01);
            }
    }

    void leansDownhill_data() {
        QTest::addColumn<double>("along");   // of gravity, m/s^2
        QTest::addColumn<double>("across");  // m/s^2
        QTest::addColumn<double>("heading"); // degrees
        for (const double heading : {0., 130.})
            for (const auto& [along, across] : {std::pair{1.5, 0.}, {-2., 0.}, {0., 2.}, {1., -1.}})
                QTest::addRow("%g, %g at %g", along, across, heading) << along << across << heading;
    }
    /// In gravity that is tilted its supports carry what they do in the general engine, however it is turned.
    void leansDownhill() {
        QFETCH(double, along);
        QFETCH(double, across);
        QFETCH(double, heading);
        std::map<std::string, double> loads[2];
        for (const int general : {0, 1}) {
            Scene scene = planarScene();
            if (general) scene.spec->settings.engine = EngineChoice::General;
            scene.spec->settings.gravity = {along, across, -9};
            auto config = std::make_shared<RobotConfigSpec>(*r0());
            config->bodies[0].geoms[1].surface = 1; // the slider holds too
            scene.robot("r", at(0, 0, 0, degrees(heading, 0, 0)), config);
            auto world = scene.build();
            QVERIFY(world);
            drive(*world, 0, 0);
            QVERIFY(run(*world, 0.5));
            for (const WorldContact& c : world->contacts()) loads[general][std::string(c.first)] += c.force;
        }
        QCOMPARE(loads[0].size(), std::size_t{3});
        for (const auto& [geom, load] : loads[1])
            QVERIFY2(std::abs(loads[0][geom] - load) < 2e-3 * kMass * g,
                     qPrintable(QString("%1: %2 of %3 N").arg(QString::fromStdString(geom)).arg(loads[0][geom]).arg(load)));
    }
};

QTEST_APPLESS_MAIN(PlanarTest)
#include "planar_test.moc"
