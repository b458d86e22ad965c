// Motion of each kind of joint; positive is the child rotating right-handed about the axis relative to the parent.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

/// Two bodies, the first fixed to the world, connected by `spec` (parent 0, child 1); gravity off.
Scene pair(const JointSpec& spec, const Vec3& childAt = {0, 0, 1}) {
    Scene scene;
    scene.spec->settings.gravity = Vec3::Zero();
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("base", at(0, 0, 1), massOfBox(5, {0.1, 0.1, 0.1}), {}));
    config->bodies.push_back(body("arm", {childAt, Quat::Identity()}, massOfBox(1, {0.3, 0.2, 0.1}), {}));
    config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
    config->joints.push_back(spec);
    if (spec.type != JointType::Ball && spec.type != JointType::Fixed) config->devices.push_back(row("motor", spec.name));
    scene.robot("r", {}, config);
    return scene;
}

Vec3 armHpr(World& world) {
    const double* p = slot(world, "r/arm/pose");
    return hprFromRotation(Quat(p[3], p[4], p[5], p[6])) * (180 / kPi);
}

} // namespace

class JointsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void hingeTurnsRightHanded() {
        for (const bool toWorld : {false, true}) {
            JointSpec j = joint("j", JointType::Hinge, toWorld ? kWorldBody : 0, 1, {0, 0, 1}, Vec3::UnitZ());
            auto world = pair(j).build();
            QVERIFY(world);
            command(*world, "r/motor", 1, 0, 100);
            QVERIFY(run(*world, 0.5));
            QVERIFY(std::abs(value(*world, "r/j/rate") - 1) < 1e-6);
            QVERIFY(std::abs(value(*world, "r/j/position") - 0.5) < 0.011);
            QVERIFY(std::abs(spin(*world, "r/arm").z() - 1) < 1e-6);
            QVERIFY(std::abs(armHpr(*world).x() - value(*world, "r/j/position") * 180 / kPi) <
                    1e-4); // positive heading is to the left
        }
    }

    void hingeStops_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("stop");
        QTest::newRow("high") << 3.0 << 0.5;
        QTest::newRow("low") << -3.0 << -0.25;
        QTest::newRow("beyond a turn") << 30.0 << 9.0;
    }
    void hingeStops() {
        QFETCH(double, rate);
        QFETCH(double, stop);
        JointSpec j = joint("j", JointType::Hinge, 0, 1, {0, 0, 1}, Vec3::UnitX());
        (stop > 0 ? j.highStop : j.lowStop) = stop;
        auto world = pair(j).build();
        command(*world, "r/motor", rate, 0, 0.5);
        QVERIFY(run(*world, 3));
        QVERIFY(std::abs(value(*world, "r/j/position") - stop) < 0.005);
        QVERIFY(std::abs(value(*world, "r/j/rate")) < 1e-3);
    }

    void sliderMovesAlongItsAxis() {
        JointSpec j = joint("j", JointType::Slider, 0, 1, {0, 0, 1}, Vec3::UnitX());
        j.highStop = 0.3;
        auto world = pair(j).build();
        command(*world, "r/motor", 0.2, 0, 100);
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(value(*world, "r/j/position") - 0.2) < 0.003);
        QVERIFY(std::abs(position(*world, "r/arm").x() - value(*world, "r/j/position")) < 1e-6);
        QVERIFY(run(*world, 2));
        QVERIFY(std::abs(value(*world, "r/j/position") - 0.3) < 0.005);
    }

    void sliderFallsFreely() {
        JointSpec j = joint("j", JointType::Slider, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        Scene scene = pair(j);
        scene.spec->settings.gravity = {0, 0, -g};
        auto world = scene.build();
        QVERIFY(run(*world, 0.5));
        QVERIFY(std::abs(value(*world, "r/j/rate") + 0.5 * g) < 1e-6);
    }

    void fixedJointKeepsPose() {
        auto world = pair(joint("j", JointType::Fixed, 0, 1, {0, 0, 1}, Vec3::UnitZ()), {0.3, 0, 1}).build();
        QVERIFY(world->push("r/arm", {50, 0, 50}, {0.3, 0.1, 1}).ok());
        QVERIFY(run(*world, 1));
        QVERIFY((position(*world, "r/arm") - Vec3(0.3, 0, 1)).norm() < 1e-4);
        QVERIFY(!world->layout().find("r/j/position"));
    }

    void ballJointKeepsAnchor() {
        Scene scene = pair(joint("j", JointType::Ball, 0, 1, {0, 0, 1}, Vec3::UnitZ()), {0.3, 0, 1});
        scene.spec->settings.gravity = {0, 0, -g};
        auto world = scene.build();
        double lowest = 1;
        for (int i = 0; i < 200; ++i) {
            QVERIFY(world->tick().ok());
            lowest = std::min(lowest, position(*world, "r/arm").z());
            QVERIFY(std::abs((position(*world, "r/arm") - Vec3(0, 0, 1)).norm() - 0.3) < 2e-3);
        }
        QVERIFY(lowest < 0.71);
    }

    void universalBlocksTheTwist() {
        JointSpec j = joint("j", JointType::Universal, 0, 1, {0, 0, 1}, Vec3::UnitX());
        j.axis2 = Vec3::UnitY();
        auto world = pair(j).build();
        for (int i = 0; i < 50; ++i) { // a torque about z
            QVERIFY(world->push("r/arm", {0, 5, 0}, Vec3(0.15, 0, 1)).ok());
            QVERIFY(world->push("r/arm", {0, -5, 0}, Vec3(-0.15, 0, 1)).ok());
            QVERIFY(world->tick().ok());
        }
        QVERIFY(spin(*world, "r/arm").norm() < 1e-3);
        command(*world, "r/motor", 1, 0, 100);
        QVERIFY(run(*world, 0.3));
        QVERIFY(std::abs(value(*world, "r/j/rate") - 1) < 1e-3);
        QVERIFY(std::abs(value(*world, "r/j/position") - 0.3) < 0.011);
        QVERIFY(spin(*world, "r/arm").x() > 0.99);
    }

    /// A wheel on a spring: sags by m g / k, its axle turns, it does not steer.
    void suspensionSagsAndTurns() {
        JointSpec j = joint("j", JointType::Suspension, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.axis2 = Vec3::UnitY();
        j.stiffness = 1000;
        j.damping = 60;
        Scene scene = pair(j);
        scene.spec->settings.gravity = {0, 0, -g};
        auto world = scene.build();
        command(*world, "r/motor", 5, 0, 10);
        QVERIFY(run(*world, 2));
        QVERIFY(std::abs(position(*world, "r/arm").z() - (1 - g / 1000)) < 1e-4);
        QVERIFY(std::abs(value(*world, "r/j/rate") - 5) < 1e-3);
        QVERIFY(std::abs(spin(*world, "r/arm").y() - 5) < 1e-3);
        QVERIFY(std::abs(spin(*world, "r/arm").z()) < 1e-3);
    }

    void suspensionStopsAtItsTravel() {
        JointSpec j = joint("j", JointType::Suspension, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.axis2 = Vec3::UnitY();
        j.stiffness = 100;
        j.damping = 20;
        j.travel = 0.02; // without the stop the weight would compress it by 98 mm
        Scene scene = pair(j);
        scene.spec->settings.gravity = {0, 0, -g};
        auto world = scene.build();
        QVERIFY(run(*world, 2));
        QVERIFY(std::abs(position(*world, "r/arm").z() - 0.98) < 0.004);
    }

    void suspensionLeavesItsTravel_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("%g s", tick) << tick;
    }
    /// What was pressed to the end of the travel returns to where the spring balances the weight.
    void suspensionLeavesItsTravel() {
        QFETCH(double, tick);
        JointSpec j = joint("j", JointType::Suspension, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.axis2 = Vec3::UnitY();
        j.stiffness = 158;
        j.damping = 1;
        j.travel = 0.104; // let go at 0, it would reach 124 mm
        Scene scene = pair(j);
        scene.spec->settings.gravity = {0, 0, -g};
        scene.spec->settings.tick = tick;
        auto world = scene.build();
        double deepest = 0;
        for (double time = 0; time < 60; time += tick) {
            QVERIFY(world->tick().ok());
            deepest = std::min(deepest, position(*world, "r/arm").z() - 1);
        }
        QVERIFY2(deepest < -0.103 && deepest > -0.104 - 1.5 * tick, qPrintable(QString::number(deepest))); // at most 1.5 m/s there
        QVERIFY(std::abs(position(*world, "r/arm").z() - (1 - g / 158)) < 1e-4);
    }

    void stopsBeyondTheMotionDrawNothingToThem_data() { suspensionLeavesItsTravel_data(); }
    /// Undamped and let go at rest, a weight falls by 2 m g / k and returns to its start.
    void stopsBeyondTheMotionDrawNothingToThem() {
        QFETCH(double, tick);
        const auto range = [&](std::optional<double> stop) {
            JointSpec j = joint("j", JointType::Slider, 0, 1, {0, 0, 1}, Vec3::UnitZ());
            j.stiffness = 158;
            j.lowStop = stop;
            Scene scene = pair(j);
            scene.spec->settings.gravity = {0, 0, -g};
            scene.spec->settings.tick = tick;
            auto world = scene.build();
            std::pair lowHigh(0.0, 0.0);
            for (double time = 0; time < 6; time += tick) {
                (void)world->tick();
                const double at = value(*world, "r/j/position");
                lowHigh = {std::min(lowHigh.first, at), std::max(lowHigh.second, at)};
            }
            return lowHigh;
        };
        const auto free = range({}), limited = range(-0.129);
        QVERIFY(std::abs(free.first + 2 * g / 158) < 0.0015);
        QVERIFY2(std::abs(limited.first - free.first) < 1e-9 && std::abs(limited.second - free.second) < 1e-9,
                 qPrintable(QString("%1 %2").arg(limited.first).arg(limited.second)));
    }

    void motorOvercomesFriction() {
        JointSpec j = joint("j", JointType::Hinge, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.friction = 2;
        auto world = pair(j).build();
        command(*world, "r/motor", 10, 0, 1.9);
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(value(*world, "r/j/rate")) < 1e-4);
        command(*world, "r/motor", 10, 0, 3);
        QVERIFY(run(*world, 1));
        QVERIFY(std::abs(value(*world, "r/j/rate") - 10) < 1e-3);
        QVERIFY(std::abs(value(*world, "r/motor/effort") - 2) < 0.01); // at steady speed the motor only balances friction
    }

    void springFindsItsBalance() {
        JointSpec j = joint("j", JointType::Slider, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.stiffness = 500;
        j.damping = 40;
        Scene scene = pair(j);
        scene.spec->settings.gravity = {0, 0, -g};
        auto world = scene.build();
        QVERIFY(run(*world, 3));
        QVERIFY(std::abs(value(*world, "r/j/position") + g / 500) < 1e-5);
    }

    void dampingLimitsSpeed() {
        JointSpec j = joint("j", JointType::Hinge, 0, 1, {0, 0, 1}, Vec3::UnitZ());
        j.damping = 0.5;
        auto world = pair(j).build();
        command(*world, "r/motor", 1000, 0, 2); // a torque of 2 N m in effect
        QVERIFY(run(*world, 3));
        QVERIFY(std::abs(value(*world, "r/j/rate") - 4) < 1e-3);
        QVERIFY(std::abs(value(*world, "r/motor/effort") - 2) < 1e-3);
    }

    /// A body whose centre of mass is off its frame swings about it; its own pose is that of the frame, the object's that of the centre.
    void offsetCentreOfMass() {
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("stick", {}, massOfBox(1, {1, 0.1, 0.1}, {0.5, 0, 0}), {}));
        scene.robot("s", at(1, 2, 3, degrees(90, 0, 0)), config);
        auto world = scene.build();
        QVERIFY((position(*world, "s/stick") - Vec3(1, 2, 3)).norm() < 1e-12);
        QCOMPARE(value(*world, "s/pose", 1), 2.5);
        QVERIFY(world->push("s/stick", {100, 0, 0}, {1, 2.5, 3}).ok()); // through the centre of mass
        QVERIFY(run(*world, 0.5));
        QVERIFY(spin(*world, "s/stick").norm() < 1e-9);
        QVERIFY(std::abs(velocity(*world, "s/stick").x() - 1) < 1e-9);
        QVERIFY(std::abs(position(*world, "s/stick").x() - 1.5) < 1e-9);
    }

    void placeKeepsTheJointAngles() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        command(*world, "r/leftMotor", 5, 0, 5);
        command(*world, "r/rightMotor", 5, 0, 5);
        QVERIFY(run(*world, 1));
        const double angle = value(*world, "r/leftAxle/position");
        command(*world, "r/leftMotor", 0, 0, 5);
        command(*world, "r/rightMotor", 0, 0, 5);
        QVERIFY(world->place("r", at(3, 4, 0, degrees(90, 0, 0))).ok());
        QVERIFY(world->tick().ok());
        QVERIFY((world->robotPose(0).position - Vec3(3, 4, 0)).norm() < 1e-3);
        QVERIFY(std::abs(hprFromRotation(world->robotPose(0).rotation).x() - kPi / 2) < 1e-3);
        QVERIFY(std::abs(value(*world, "r/leftAxle/position") - angle) < 1e-3);
    }

    /// Robots with light whiskers on ball joints, driven into a slanted wall at 30 ms: at 20 to 40 rad/s such a whisker opens its joint by a
    /// tenth of its length in one tick. Few may tear.
    void whiskers() {
        std::mt19937 random(5);
        const auto from = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
        };
        int torn = 0;
        constexpr int kRobots = 80;
        for (int i = 0; i < kRobots; ++i) {
            Scene scene = r0Scene(0.03);
            scene.scenery({plane("floor", {}, 1)});
            const Vec3 slant = degrees(from(-30, 30), from(-40, 40), from(-20, 20));
            scene.scenery({box("slab", {0.05, 0.8, 0.5}, {{from(0.7, 1.2), 0, 0.15}, rotationFromHpr(slant)}, 3)});
            auto config = std::make_shared<RobotConfigSpec>(*r0());
            for (int k = 0; k < 2; ++k) {
                const std::string n = std::to_string(k);
                const double length = from(0.04, 0.13), radius = from(0.002, 0.006), yaw = from(-50, 50), pitch = from(-20, 20);
                const Quat along = rotationFromHpr(degrees(yaw, pitch, 0)) * rotationFromHpr(degrees(0, 90, 0));
                const Vec3 anchor(0.125, k ? from(0.02, 0.09) : from(-0.09, -0.02), from(0.06, 0.13));
                GeomSpec rod = cylinder("w", radius, length, {}, 3);
                rod.shape = GeomShape::Capsule;
                config->bodies.push_back(body("whisker" + n, {anchor + along * Vec3(0, 0, length / 2), along},
                                              massOfCylinder(std::pow(10, from(-3, -1.3)), radius, length), {rod}));
                config->joints.push_back(joint("root" + n, JointType::Ball, 0, 3 + k, anchor, Vec3::UnitX()));
            }
            scene.robot("r", at(-0.2, 0, 0, degrees(from(-30, 30), 0, 0)), config);
            auto world = scene.build();
            QVERIFY(world);
            const double rate = from(0.4, 1.2) / kR0Radius;
            command(*world, "r/leftMotor", rate, 0, 0.06);
            command(*world, "r/rightMotor", rate, 0, 0.06);
            torn += !run(*world, 3);
        }
        qInfo("%d of %d", torn, kRobots);
        QVERIFY(torn <= kRobots / 5);
    }
};

QTEST_APPLESS_MAIN(JointsTest)
#include "joints_test.moc"
