// Stops of joints that are passed within a tick or lie close together: nothing leaves them faster than it came, and what is
// outside is put inside without a speed.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kDegree = kPi / 180;

/// A plate of 200 g in front of the y-z plane on a joint to the world, which a push along x turns or shifts to its high stop.
struct Gate {
    JointType type;
    Vec3 anchor, axis;
    double room; ///< m or rad up to the stop
};

JointSpec stopped(const Gate& gate) {
    JointSpec spec = joint("j", gate.type, kWorldBody, 0, gate.anchor, gate.axis);
    if (gate.type == JointType::Universal) spec.axis2 = Vec3::UnitZ();
    if (gate.type == JointType::Ball) spec.swingStop = gate.room;
    else spec.highStop = gate.room;
    return spec;
}

} // namespace

class StopsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void takesABlow_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("tick");
        for (const auto& [name, type] : {std::pair("slider", JointType::Slider), std::pair("hinge", JointType::Hinge),
                                         std::pair("universal joint", JointType::Universal), std::pair("ball", JointType::Ball)})
            for (const double tick : {0.001, 0.005, 0.01, 0.02, 0.03})
                QTest::addRow("%s, %g ms", name, 1e3 * tick) << static_cast<int>(type) << tick;
    }
    /// A ball without restitution ends at rest, wherever in a tick the plate reaches its stop.
    void takesABlow() {
        QFETCH(int, type);
        QFETCH(double, tick);
        for (const double room : {0.002, 0.003, 0.005, 0.008}) {
            Gate gate{static_cast<JointType>(type), {0, 0, 1.1}, -Vec3::UnitY(), room / 0.1};
            if (gate.type == JointType::Slider) gate = {JointType::Slider, {0, 0, 1}, Vec3::UnitX(), room};
            if (gate.type == JointType::Ball) gate.axis = Vec3::UnitZ();
            Scene scene(tick);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(body("plate", at(0, 0, 1), massOfBox(0.2, {0.1, 0.2, 0.2}), {box("g", {0.1, 0.2, 0.2})}));
            config->joints.push_back(stopped(gate));
            scene.robot("gate", {}, config);
            scene.ball("ball", {-0.2, 0, 1}, 0.5, 0.03);
            auto world = scene.build();
            QVERIFY(world);
            const int ticks = static_cast<int>(std::ceil(0.03 / tick - 1e-9)); // in which it gets to 2 m/s
            for (int i = 0; i < ticks; ++i) {
                QVERIFY(world->push("ball/body", {0.5 * 2 / (ticks * tick), 0, 0}, world->robotPose(1).position).ok());
                QVERIFY(world->tick().ok());
            }
            QVERIFY(std::abs(velocity(*world, "ball/body").x() - 2) < 0.01);
            QVERIFY(run(*world, 0.5));
            const double after = velocity(*world, "ball/body").x();
            QVERIFY2(std::abs(after) < 0.04, qPrintable(QString("%1 m/s with %2 m").arg(after).arg(room)));
        }
    }

    void closeStopsHold_data() {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("tick");
        for (const double stop : {0.02, 0.5, 2.0, 5.0})
            for (const double tick : {0.001, 0.005, 0.01, 0.02, 0.03})
                QTest::addRow("%g degrees, %g ms", stop, 1e3 * tick) << stop << tick;
    }
    /// Turned to and fro without a pause, it stays between them.
    void closeStopsHold() {
        QFETCH(double, degrees);
        QFETCH(double, tick);
        for (const JointType type : {JointType::Hinge, JointType::Universal, JointType::Ball}) {
            JointSpec spec = joint("j", type, kWorldBody, 0, {0, 0, 1}, type == JointType::Ball ? Vec3::UnitZ() : Vec3::UnitX());
            spec.axis2 = Vec3::UnitY();
            if (type == JointType::Ball) spec.swingStop = degrees * kDegree;
            else {
                spec.lowStop = spec.lowStop2 = -degrees * kDegree;
                spec.highStop = spec.highStop2 = degrees * kDegree;
            }
            Scene scene(tick);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(body("arm", at(0, 0, 1), massOfBox(0.1, {0.1, 0.02, 0.02}), {}));
            config->joints.push_back(spec);
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            double most = 0;
            for (int i = 0; i * tick < 0.6; ++i) {
                // A couple of 40 uN m on 6.7e-6 kg m^2 that changes its way every 30 ms.
                const double sign = static_cast<int>(i * tick / 0.03) % 2 ? -1 : 1;
                const Vec3 place = world->robotPose(0).position, force(0, 0, sign * 4e-4), lever(0, 0.1, 0);
                QVERIFY(world->push("r/arm", force, place + lever).ok() && world->push("r/arm", -force, place).ok());
                QVERIFY(world->tick().ok());
                const Quat q = world->robotPose(0).rotation;
                QVERIFY(std::isfinite(q.w()));
                most = std::max(most, 2 * std::abs(q.vec().norm()));
            }
            QVERIFY2(most < degrees * kDegree + 6 * 1.5 * tick * tick, qPrintable(QString("%1 rad").arg(most)));
        }
    }

    /// A push for one tick: it keeps its speed up to the stop, however far that is.
    void drawsNothingToIt() {
        for (const JointType type : {JointType::Slider, JointType::Hinge})
            for (const double tick : {0.001, 0.005, 0.01, 0.03})
                for (double room = 0.5; room < 4; room += 0.13) { // ticks of its way
                    Scene scene(tick);
                    scene.spec->settings.gravity = Vec3::Zero();
                    auto config = std::make_shared<RobotConfigSpec>();
                    config->bodies.push_back(body("arm", at(0, 0, 1), massOfBox(0.1, {0.1, 0.1, 0.1}), {}));
                    JointSpec spec = joint("j", type, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
                    const double speed =
                        type == JointType::Slider ? 1 : 60 / 0.1 / 10; // 0.1 N s; at an arm of 0.1 m on 1/6000 kg m^2
                    spec.highStop = room * speed * tick;
                    config->joints.push_back(spec);
                    scene.robot("r", {}, config);
                    auto world = scene.build();
                    QVERIFY(world);
                    const double force = type == JointType::Slider ? 0.1 / tick : speed / 6000 / 0.1 / tick;
                    const Vec3 lever(0, 0.1, 0), way = type == JointType::Slider ? Vec3::UnitX() : Vec3::UnitZ();
                    QVERIFY(world->push("r/arm", force * way, Vec3(0, 0, 1) + (type == JointType::Slider ? Vec3::Zero() : lever))
                                .ok());
                    double most = 0, farthest = 0;
                    for (int i = 0; i < 12; ++i) {
                        QVERIFY(world->tick().ok());
                        most = std::max(most, value(*world, "r/j/rate"));
                        farthest = std::max(farthest, value(*world, "r/j/position"));
                    }
                    QVERIFY2(
                        most < speed * (1 + 1e-6) && farthest < *spec.highStop * (1 + 1e-6) + 1e-9,
                        qPrintable(QString("%1 of %2, up to %3 of %4").arg(most).arg(speed).arg(farthest).arg(*spec.highStop)));
                    QVERIFY(std::abs(value(*world, "r/j/rate")) < 1e-6 * speed);
                }
    }

    /// Of two geared arms with different stops the first one that is reached holds both.
    void twoStopsOfOneMechanism() {
        for (const bool isFree : {false, true})
            for (const double tick : {0.002, 0.005, 0.01, 0.02})
                for (const double more : {0.0, 0.002, 0.02}) {
                    Scene scene(tick);
                    scene.spec->settings.gravity = Vec3::Zero();
                    auto config = std::make_shared<RobotConfigSpec>();
                    config->bodies.push_back(body("base", at(0, 0, 1), massOfBox(2, {0.2, 0.2, 0.1}), {}));
                    if (!isFree)
                        config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
                    for (const double y : {0.03, -0.03}) {
                        const int arm = static_cast<int>(config->bodies.size());
                        config->bodies.push_back(
                            body("arm" + std::to_string(arm), at(0.15, y, 1), massOfBox(0.05, {0.1, 0.02, 0.02}), {}));
                        JointSpec spec = joint("j" + std::to_string(arm), JointType::Hinge, 0, arm, {0.1, y, 1}, Vec3::UnitZ());
                        if (y > 0) spec.highStop = 0.5;
                        else spec.lowStop = -0.5 - more;
                        config->joints.push_back(spec);
                    }
                    GearSpec gear;
                    gear.name = "gear";
                    gear.joint = isFree ? 0 : 1;
                    gear.other = gear.joint + 1;
                    gear.ratio = -1;
                    config->gears.push_back(gear);
                    config->devices.push_back(row("motor", "j1"));
                    scene.robot("r", {}, config);
                    auto world = scene.build();
                    QVERIFY(world);
                    command(*world, "r/motor", 8, 0, 0.5);
                    QVERIFY(run(*world, 1));
                    QVERIFY(!world->fault());
                    const double first = value(*world, "r/j1/position"), second = value(*world, "r/j2/position");
                    QVERIFY2(std::abs(first - 0.5) < 1e-3 && std::abs(second + 0.5) < 1e-3,
                             qPrintable(QString("%1, %2 at %3 s").arg(first).arg(second).arg(tick)));
                }
    }

    void suspensionBottoms_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.002, 0.005, 0.01, 0.02, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    /// A cart that falls on springs with 10 mm of travel, which hold it at 8.2 mm: it is not thrown back from beyond that.
    void suspensionBottoms() {
        QFETCH(double, tick);
        Scene scene(tick);
        scene.scenery({plane("floor")});
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("hull", at(0, 0, 0.2), massOfBox(10, {0.5, 0.3, 0.1}), {}));
        for (const double x : {-0.2, 0.2})
            for (const double y : {-0.2, 0.2}) {
                const int wheel = static_cast<int>(config->bodies.size());
                const std::string name = "wheel" + std::to_string(wheel);
                config->bodies.push_back(body(name, at(x, y, 0.06), massOfSphere(0.4, 0.06), {sphere("g", 0.06)}));
                JointSpec spec = joint("s" + std::to_string(wheel), JointType::Suspension, 0, wheel, {x, y, 0.06}, Vec3::UnitZ());
                spec.axis2 = Vec3::UnitY();
                spec.stiffness = 3000;
                spec.travel = 0.01;
                config->joints.push_back(spec);
            }
        scene.robot("cart", at(0, 0, 0.3), config);
        auto world = scene.build();
        QVERIFY(world);
        double highest = 0;
        for (int i = 0; i * tick < 1.2; ++i) {
            QVERIFY(world->tick().ok());
            if (i * tick > 0.35) highest = std::max(highest, position(*world, "cart/hull").z()); // it lands at 0.247 s
        }
        // From the end of the travel up to as far above the rest at 8.2 mm: 6.4 mm below the start pose.
        QVERIFY2(highest > 0.1925 && highest < 0.1945, qPrintable(QString::number(highest)));
    }

    /// Damped, it comes to rest wherever the end of its travel is.
    void suspensionCalmsDown() {
        for (const double tick : {0.002, 0.005, 0.01})
            for (const double travel : {0.2, 0.03, 0.02, 0.01}) {
                Scene scene(tick);
                scene.spec->settings.gravity = Vec3::Zero();
                auto config = std::make_shared<RobotConfigSpec>();
                config->bodies.push_back(body("hull", at(0, 0, 1), massOfBox(10, {0.2, 0.2, 0.1}), {}));
                config->bodies.push_back(body("wheel", at(0, 0, 0.8), massOfSphere(0.4, 0.06), {}));
                config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
                JointSpec spec = joint("s", JointType::Suspension, 0, 1, {0, 0, 0.8}, Vec3::UnitZ());
                spec.axis2 = Vec3::UnitY();
                spec.stiffness = 8000;
                spec.damping = 30;
                spec.travel = travel;
                config->joints.push_back(spec);
                scene.robot("r", {}, config);
                auto world = scene.build();
                QVERIFY(world);
                QVERIFY(world->push("r/wheel", {0, 0, 0.4 * 6 / tick}, {0, 0, 0.8}).ok());
                QVERIFY(run(*world, 2));
                const double off = position(*world, "r/wheel").z() - 0.8;
                QVERIFY2(std::abs(off) < 1e-5, qPrintable(QString("%1 m at %2 s, travel %3").arg(off).arg(tick).arg(travel)));
            }
    }

    void startsOutside_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("tick");
        for (const auto type : {JointType::Hinge, JointType::Slider})
            for (const double tick : {0.001, 0.01, 0.03})
                QTest::addRow("%s, %g ms", type == JointType::Hinge ? "hinge" : "slider", 1e3 * tick)
                    << static_cast<int>(type) << tick;
    }
    /// It is put inside and stays there.
    void startsOutside() {
        QFETCH(int, type);
        QFETCH(double, tick);
        for (const double high : {0.21, 0.24, 3.0}) {
            JointSpec spec = joint("j", static_cast<JointType>(type), kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
            spec.lowStop = 0.2;
            spec.highStop = high;
            Scene scene(tick);
            scene.spec->settings.gravity = Vec3::Zero();
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(body("arm", at(0, 0, 1), massOfBox(0.1, {0.1, 0.02, 0.02}), {}));
            config->joints.push_back(spec);
            scene.robot("r", {}, config);
            auto world = scene.build();
            QVERIFY(world);
            QVERIFY(run(*world, 1));
            QVERIFY2(std::abs(value(*world, "r/j/position") - 0.2) < 1e-3 && std::abs(value(*world, "r/j/rate")) < 1e-2,
                     qPrintable(QString("%1, %2").arg(value(*world, "r/j/position")).arg(value(*world, "r/j/rate"))));
        }
    }
};

QTEST_APPLESS_MAIN(StopsTest)
#include "stops_test.moc"
