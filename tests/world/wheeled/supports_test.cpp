// What a robot has under it in the wheeled engine: balls that turn in sockets, wheels that all slip, its weight in strong gravity;
// and parts that are refused.
#include <QtTest>

#include <functional>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kStrong = 50; // N m: more than any friction here

Scene onGround(EngineChoice engine, double tick = 0.01) {
    Scene scene = r0Scene(tick);
    scene.spec->settings.engine = engine;
    scene.scenery({plane("floor", {}, 1)});
    return scene;
}

/// R0 with a ball of that radius in a socket for its slider.
std::shared_ptr<RobotConfigSpec> onBall(double mass, double radius) {
    auto config = std::make_shared<RobotConfigSpec>(*r0());
    config->bodies[0].geoms.pop_back();
    const Vec3 centre(-0.13, 0, radius);
    config->bodies.push_back(
        body("ball", {centre, Quat::Identity()}, massOfSphere(mass, radius), {sphere("roller", radius, {}, 1)}));
    config->joints.push_back(joint("socket", JointType::Ball, 0, 3, centre, Vec3::UnitX()));
    return config;
}

/// Four driven wheels of 0.2 kg, a hull of 2 kg, and 3 kg to the left at the rear.
std::shared_ptr<RobotConfigSpec> skid() {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 hull(0.3, 0.2, 0.1), centre(0, 0, 0.11), load(-0.08, 0.06, 0.2);
    config->bodies.push_back(body("chassis", {}, massOfBox(2, hull, centre), {box("hull", hull, {centre, Quat::Identity()}, 3)}));
    config->bodies.push_back(body("load", {load, Quat::Identity()}, massOfBox(3, {0.05, 0.05, 0.05}), {}));
    config->joints.push_back(joint("mount", JointType::Fixed, 0, 1, load, Vec3::UnitZ()));
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    int child = 2;
    for (const double x : {0.1, -0.1})
        for (const double y : {0.15, -0.15}) {
            const std::string name = (x > 0 ? std::string("front") : std::string("rear")) + (y > 0 ? "Left" : "Right");
            const Vec3 hub(x, y, 0.05);
            config->bodies.push_back(body(name + "Wheel", {hub, Quat::Identity()}, massOfCylinder(0.2, 0.05, 0.03, sideways),
                                          {cylinder("tyre", 0.05, 0.03, {Vec3::Zero(), sideways}, 1)}));
            config->joints.push_back(joint(name + "Axle", JointType::Hinge, 0, child++, hub, Vec3::UnitY()));
            config->devices.push_back(row(name, name + "Axle"));
        }
    return config;
}

/// Why R0 cannot be built with this change; empty where it can.
QString refusal(const std::function<void(RobotConfigSpec&)>& change, const std::shared_ptr<RobotConfigSpec>& config) {
    auto changed = std::make_shared<RobotConfigSpec>(*config);
    change(*changed);
    Scene scene = onGround(EngineChoice::Wheeled);
    scene.surface(1, 0, 0.01); // 4: it resists rolling
    scene.robot("r", {}, changed);
    Diagnostics diagnostics;
    return scene.build(rowOnly, diagnostics) ? QString() : QString::fromStdString(diagnostics.all().at(0).message);
}

} // namespace

Q_DECLARE_METATYPE(std::function<void(trundle::RobotConfigSpec&)>)

class SupportsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void speedsUpOnABall_data() {
        QTest::addColumn<double>("mass");   // kg
        QTest::addColumn<double>("radius"); // m
        QTest::newRow("small") << 0.05 << 0.015;
        QTest::newRow("big") << 2.0 << 0.04;
    }
    /// It rolls: motors with a line bring it to its speed with the time constant M r^2 s / 2, M: all masses, half those of the wheels
    /// and 2/5 of the ball's once more, s: the softness.
    void speedsUpOnABall() {
        QFETCH(double, mass);
        QFETCH(double, radius);
        const double softness = 25, moved = 4.4 + mass + 0.2 + 0.4 * mass, delay = moved * kR0Radius * kR0Radius * softness / 2;
        for (const EngineChoice engine : {EngineChoice::Wheeled, EngineChoice::Planar, EngineChoice::General}) {
            Scene scene = onGround(engine);
            scene.robot("r", {}, onBall(mass, radius));
            auto world = scene.build();
            QVERIFY(world && run(*world, 0.1));
            for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, 0.5 / kR0Radius, softness, kStrong);
            QVERIFY(run(*world, 0.2));
            const double speed = velocity(*world, "r/chassis").x(), expected = 0.5 * (1 - std::pow(1 + 0.01 / delay, -20));
            qInfo("%.5f m/s, closed form %.5f", speed, expected);
            QVERIFY(std::abs(speed / expected - 1) < 0.01);
        }
    }

    void turnsOnABall_data() {
        QTest::addColumn<double>("mass"); // kg
        for (const double mass : {0.05, 2.}) QTest::addRow("%g kg", mass) << mass;
    }
    /// 2 s through a bend, slowing down and backwards.
    void turnsOnABall() {
        QFETCH(double, mass);
        std::vector<Pose> ends;
        for (const EngineChoice engine : {EngineChoice::General, EngineChoice::Wheeled, EngineChoice::Planar}) {
            Scene scene = onGround(engine);
            scene.robot("r", {}, onBall(mass, 0.03));
            auto world = scene.build();
            QVERIFY(world);
            for (int k = 0; k < 200; ++k) {
                const double speed = k < 120 ? 0.3 : -0.2;
                command(*world, "r/leftMotor", speed / kR0Radius, 40, kStrong);
                command(*world, "r/rightMotor", 1.6 * speed / kR0Radius, 40, kStrong);
                QVERIFY(world->tick().ok());
            }
            ends.push_back(world->robotPose(0));
            const double off = (ends.back().position - ends[0].position).head<2>().norm(),
                         turned = ends.back().rotation.angularDistance(ends[0].rotation) * 180 / kPi;
            qInfo("%.3f mm and %.4f degrees from the general engine", 1e3 * off, turned);
            QVERIFY(off < 1e-3 && turned < 0.05);
        }
    }

    /// A ball that is fixed to the hull slides.
    void slidesOnAFixedBall() {
        Scene scene = onGround(EngineChoice::Wheeled);
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        config->bodies[0].geoms.back().surface = 1;
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, 1, 0, 0.1); // 4 N; friction is up to 9 N
        QVERIFY(run(*world, 1));
        QVERIFY(velocity(*world, "r/chassis").norm() < 1e-3);
    }

    /// All four wheels slip: it turns as in the general engine, which solves the same friction in another way.
    void skidsAsGeneral() {
        double rates[2] = {}, speeds[2] = {};
        for (const int general : {0, 1}) {
            Scene scene = onGround(general ? EngineChoice::General : EngineChoice::Wheeled);
            scene.spec->surfaces[1].friction = 0.9;
            scene.robot("r", {}, skid());
            auto world = scene.build();
            QVERIFY(world);
            for (const char* motor : {"r/frontLeft", "r/rearLeft"}) command(*world, motor, 3 / 0.6, 1 / 0.18, kStrong);
            for (const char* motor : {"r/frontRight", "r/rearRight"}) command(*world, motor, 7 / 0.6, 1 / 0.18, kStrong);
            QVERIFY(run(*world, 2));
            rates[general] = spin(*world, "r/chassis").z();
            speeds[general] = velocity(*world, "r/chassis").norm();
        }
        qInfo("%.5f rad/s and %.5f m/s, in general %.5f and %.5f", rates[0], speeds[0], rates[1], speeds[1]);
        QVERIFY(rates[1] > 0.1);
        QVERIFY(std::abs(rates[0] / rates[1] - 1) < 0.01);
        QVERIFY(std::abs(speeds[0] / speeds[1] - 1) < 0.01);
    }

    /// Loads that follow friction and friction that follows them come to rest within a tick: left and right stay alike.
    void startsStraightWhereItIsTall() {
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        config->bodies[0].mass.centre.z() = 0.5;
        config->bodies[0].geoms.push_back(sphere("bow", 0.015, at(0.1, 0, 0.015), 2));
        Scene scene = onGround(EngineChoice::Wheeled);
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        for (int k = 0; k < 150; ++k) {
            const double speed = std::min(0.9, 100 * 0.01 * (k + 1)) / kR0Radius;
            for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, speed, 0, 1.5);
            QVERIFY(world->tick().ok());
        }
        QVERIFY(world->robotFaults().ends.empty());
        const Pose pose = world->robotPose(0);
        const double heading = hprFromRotation(pose.rotation).x() * 180 / kPi;
        qInfo("%.3g m aside, %.3g degrees", pose.position.y(), heading);
        QVERIFY(pose.position.x() > 0.3);
        QVERIFY(std::abs(pose.position.y()) < 1e-4 && std::abs(heading) < 0.01);
    }

    void wheelsThatSpinUpLeanOnTheRear_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.002, 0.01, 0.02}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    /// Four heavy wheels, the front ones driven: these carry M g / 2 - (M a z + 4 I a / r) / L.
    void wheelsThatSpinUpLeanOnTheRear() {
        QFETCH(double, tick);
        auto config = std::make_shared<RobotConfigSpec>(*skid());
        config->bodies[0].mass = massOfBox(2, {0.3, 0.2, 0.1}, {0, 0, 0.05});
        config->bodies[1].mass = massOfBox(0.001, {0.05, 0.05, 0.05});
        const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
        for (std::size_t i = 2; i < 6; ++i) config->bodies[i].mass = massOfCylinder(2, 0.05, 0.03, sideways);
        Scene scene = onGround(EngineChoice::Wheeled, tick);
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        const double acceleration = 2, mass = 10.001, spin = 4 * 2 * 0.05 * 0.05 / 2 * acceleration / 0.05;
        for (int k = 1; k * tick < 0.4; ++k) {
            for (const char* motor : {"r/frontLeft", "r/frontRight"})
                command(*world, motor, acceleration * k * tick / 0.05, 0, kStrong);
            QVERIFY(world->tick().ok());
        }
        double front = 0;
        for (const WorldContact& c : world->contacts())
            if (c.first.starts_with("r/front")) front += c.force;
        const double expected = mass * g / 2 - (mass * acceleration * 0.05 + spin) / 0.2;
        qInfo("%.4f N, closed form %.4f", front, expected);
        QVERIFY(std::abs(front / expected - 1) < 2e-3);
    }

    void strongGravity_data() {
        QTest::addColumn<double>("gravity"); // m/s^2
        QTest::addColumn<double>("mass");    // kg
        for (const double gravity : {9.81, 50., 200.})
            for (const double mass : {4., 40.}) QTest::addRow("%g kg at %g m/s^2", mass, gravity) << gravity << mass;
    }
    /// It sags by no more than 0.2 mm, and stays level.
    void strongGravity() {
        QFETCH(double, gravity);
        QFETCH(double, mass);
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        config->bodies[0].mass = massOfBox(mass, {0.3, 0.2, 0.1}, {-0.03, 0, 0.09});
        Scene scene = onGround(EngineChoice::Wheeled);
        scene.spec->settings.gravity = {0, 0, -gravity};
        scene.robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, 4, 0.1, kStrong);
        QVERIFY(run(*world, 1));
        const Pose pose = world->robotPose(0);
        qInfo("%.4f mm", 1e3 * pose.position.z());
        QVERIFY(pose.position.z() > -2e-4 && pose.position.x() > 0.15);
        QVERIFY(pose.rotation.toRotationMatrix()(2, 2) > std::cos(0.1 * kPi / 180));
    }

    void refusesPartsThatItCannotHold() {
        const auto ball = onBall(0.05, 0.015);
        QCOMPARE(refusal([](RobotConfigSpec&) {}, ball), QString());
        const auto isRefused = [&](const char* reason, const std::function<void(RobotConfigSpec&)>& change) {
            const QString said = refusal(change, ball);
            return said.contains(reason) ? true : (qWarning("%s", qPrintable(said)), false);
        };
        QVERIFY(isRefused("the Ball socket has a Damping", [](RobotConfigSpec& c) { c.joints[2].damping = 0.02; }));
        QVERIFY(isRefused("caster ball has rolling friction", [](RobotConfigSpec& c) { c.bodies[3].geoms[0].surface = 4; }));
        QVERIFY(isRefused("caster ball has a centre of mass that is not its middle",
                          [](RobotConfigSpec& c) { c.bodies[3].mass.centre.x() = 0.004; }));
        QVERIFY(isRefused("wheel leftWheel has its centre of mass beside its axle", [](RobotConfigSpec& c) {
            c.bodies[1].mass.centre = {0, 0.01, 0.02};
        }));
        QCOMPARE(refusal([](RobotConfigSpec& c) { c.bodies[1].mass.centre.y() = 0.01; }, ball), QString());
    }

    void saysWhyAWheelIsNone_data() {
        using Change = std::function<void(RobotConfigSpec&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* reason, Change change) { QTest::newRow(reason) << std::move(change) << QString(reason); };
        row("the Hinge leftAxle has Friction; a wheel turns", [](RobotConfigSpec& c) { c.joints[0].friction = 0.01; });
        row("the Hinge leftAxle has stops", [](RobotConfigSpec& c) { c.joints[0].highStop = 1; });
        row("the Hinge leftAxle has a spring", [](RobotConfigSpec& c) { c.joints[0].stiffness = 1; });
        row("the Hinge leftAxle has its wheel as its Parent",
            [](RobotConfigSpec& c) { std::swap(c.joints[0].parent, c.joints[0].child); });
        row("wheel leftWheel has more than one geom that collides", [](RobotConfigSpec& c) {
            c.bodies[1].geoms.push_back(c.bodies[1].geoms[0]);
            c.bodies[1].geoms[1].radius = 0.03;
        });
        row("wheel leftWheel has its middle 5.0 mm beside",
            [](RobotConfigSpec& c) { c.bodies[1].geoms[0].pose.position.x() = 0.005; });
        row("wheel leftWheel has its middle 2.0 mm beside", [](RobotConfigSpec& c) { c.joints[0].anchor.z() += 0.002; });
        row("wheel leftWheel is a Capsule", [](RobotConfigSpec& c) { c.bodies[1].geoms[0].shape = GeomShape::Capsule; });
        row("wheel leftWheel is 30.0 mm above the ground", [](RobotConfigSpec& c) { c.bodies[1].geoms[0].radius = 0.02; });
        row("the Hinge leftAxle is not the axle of a wheel on the ground", [](RobotConfigSpec& c) { // an arm
            c.bodies[1].geoms = {box("arm", {0.2, 0.02, 0.02})};
        });
        row("geom slider is a Sphere on the ground, which is a caster only", [](RobotConfigSpec& c) {
            c.joints.clear();
            c.devices.clear();
            c.bodies.resize(1);
            for (const double y : {0.1, -0.1}) c.bodies[0].geoms.push_back(sphere("bow", 0.02, at(0.1, y, 0.02), 2));
        });
    }
    void saysWhyAWheelIsNone() {
        QFETCH(std::function<void(RobotConfigSpec&)>, change);
        QFETCH(QString, reason);
        const QString said = refusal(change, r0());
        QVERIFY2(said.contains(reason), qPrintable(said));
    }

    void saysWhereItStarts() {
        const auto refused = [](const Scene& scene) {
            Diagnostics diagnostics;
            return World::build(scene.spec, rowOnly, diagnostics) ? QString()
                                                                  : QString::fromStdString(diagnostics.all().at(0).message);
        };
        Scene deep = onGround(EngineChoice::Wheeled);
        deep.robot("r", at(0, 0, -0.01), r0());
        QVERIFY2(refused(deep).contains("r: wheel leftWheel is 10.0 mm in the ground"), qPrintable(refused(deep)));
        Scene two = onGround(EngineChoice::Wheeled);
        two.scenery({box("table", {1, 1, 0.2}, at(5, 0, 0.1), 1)}).robot("a", {}, r0()).robot("b", at(5, 0, 0.2), r0());
        QVERIFY2(refused(two).contains("a: it starts on level ground 200.0 mm below"), qPrintable(refused(two)));
        two.robot("c", at(0, 2, 0), r0());
        QVERIFY2(refused(two).contains("b: it starts on level ground 200.0 mm above"), qPrintable(refused(two)));
    }
};

QTEST_APPLESS_MAIN(SupportsTest)
#include "supports_test.moc"
