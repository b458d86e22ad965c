// The shipped motor against its closed forms: spin-up with loads, rotors and gears, the line of its torque, stops.
#include <QtTest>

#include "devices/builtin.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

struct Motor {
    double torqueConstant = 0.02, speedConstant = 50, resistance = 2, maxVoltage = 12, gearRatio = 30, rotorInertia = 0;

    [[nodiscard]] double damping() const { return torqueConstant * gearRatio * gearRatio / (resistance * speedConstant); }
    [[nodiscard]] double noLoad(double voltage) const { return voltage * speedConstant / gearRatio; }
    [[nodiscard]] double stall() const { return torqueConstant * gearRatio * maxVoltage / resistance; }
    /// RotaryMotor motor { Joint=axle TorqueConstant=... }
    [[nodiscard]] ComponentSpec spec(const std::string& name = "motor", const std::string& axle = "axle") const {
        ComponentSpec spec;
        spec.kind = "RotaryMotor";
        spec.name = name;
        spec.values["Joint"] = textValue(axle);
        spec.values["TorqueConstant"] = numberValue(torqueConstant);
        spec.values["SpeedConstant"] = numberValue(speedConstant);
        spec.values["Resistance"] = numberValue(resistance);
        spec.values["MaxVoltage"] = numberValue(maxVoltage);
        spec.values["GearRatio"] = numberValue(gearRatio);
        spec.values["RotorInertia"] = numberValue(rotorInertia);
        return spec;
    }
};

/// A body with this inertia about `axis` and twice as much across it.
BodySpec wheel(const std::string& name, const Vec3& position, double inertia, const Vec3& axis, double mass = 1) {
    const Mat3 tensor = 2 * inertia * Mat3::Identity() - inertia * axis * axis.transpose();
    return body(name, {position, Quat::Identity()}, {mass, Vec3::Zero(), tensor}, {});
}

/// A flywheel on an axle fixed to the world.
Scene flywheel(double tick, double inertia, const Vec3& axis, const ComponentSpec& device, double damping = 0,
               JointType type = JointType::Hinge) {
    Scene scene(tick);
    scene.spec->settings.gravity = Vec3::Zero();
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(wheel("wheel", {0, 0, 1}, inertia, axis));
    config->joints.push_back(joint("axle", type, kWorldBody, 0, {0, 0, 1}, axis));
    config->joints[0].damping = damping;
    if (!device.kind.empty()) config->devices.push_back(device);
    scene.robot("r", {}, config);
    return scene;
}

/// The time constant of an exponential approach from `from` at time 0 to `end`, by its value after `time`.
double timeConstant(double from, double end, double value, double time) { return -time / std::log((end - value) / (end - from)); }

void addTicks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.001, 0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
}

ComponentSpec drive(const std::string& control) {
    ComponentSpec spec;
    spec.kind = "DifferentialDrive";
    spec.name = "base";
    spec.values["LeftMotor"] = textValue("leftMotor");
    spec.values["RightMotor"] = textValue("rightMotor");
    spec.values["WheelRadius"] = numberValue(kR0Radius);
    spec.values["WheelSeparation"] = numberValue(kR0Track);
    spec.values["Control"] = textValue(control);
    spec.values["MaxAcceleration"] = numberValue(0);
    return spec;
}

} // namespace

class MotorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void spinsUpInItsTimeConstant_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("gear");
        QTest::addColumn<double>("rotor");
        QTest::addColumn<double>("voltage");
        QTest::addColumn<double>("inertia");
        QTest::addColumn<double>("lean"); // of the axle, rad
        struct Row {
            const char* name;
            double gear, rotor, voltage, inertia, lean;
        };
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const Row& r :
                 {Row{"no rotor", 30, 0, 6, 0.01, 0}, Row{"rotor", 30, 1e-5, 6, 0.01, 0},
                  Row{"heavy rotor, no gear", 1, 0.03, 12, 0.01, 0}, Row{"rotor on a leaning axle", 30, 1e-5, 3, 0.01, 0.7},
                  Row{"slow", 10, 0, -9, 0.2, 0}, Row{"fast", 60, 0, 12, 0.002, 0.3}, Row{"light", 30, 2e-7, 1, 1e-5, 0}})
                QTest::addRow("%s, %g ms", r.name, 1e3 * tick) << tick << r.gear << r.rotor << r.voltage << r.inertia << r.lean;
    }
    /// w(t) = V kv / G (1 - e^(-t / tau)), tau = (I + G^2 J) / b, b = kt G^2 / (R kv), at every tick length.
    void spinsUpInItsTimeConstant() {
        QFETCH(double, tick);
        QFETCH(double, gear);
        QFETCH(double, rotor);
        QFETCH(double, voltage);
        QFETCH(double, inertia);
        QFETCH(double, lean);
        Motor motor;
        motor.gearRatio = gear;
        motor.rotorInertia = rotor;
        auto world = flywheel(tick, inertia, Vec3(std::sin(lean), 0, std::cos(lean)), motor.spec()).build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = voltage;
        const double tau = (inertia + gear * gear * rotor) / motor.damping(), end = motor.noLoad(voltage);
        const auto ticks = std::max<long long>(1, std::llround(tau / tick));
        QVERIFY(run(*world, static_cast<double>(ticks) * tick));
        const double rate = value(*world, "r/axle/rate"), expected = end * -std::expm1(-world->time() / tau);
        qInfo("tau %.5g s: %.8g rad/s, expected %.8g", tau, rate, expected);
        QVERIFY(std::abs(rate / expected - 1) < 1e-5);
    }

    void spinsUpWhatItCarries_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<QString>("what");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const char* what : {"free base", "fixed disc", "offset arm", "elbow", "bearing"})
                QTest::addRow("%s, %g ms", what, 1e3 * tick) << tick << what;
    }
    /// The inertia is that of all that moves with the joint, on both sides; a bearing's damping adds to the motor's.
    void spinsUpWhatItCarries() {
        QFETCH(double, tick);
        QFETCH(QString, what);
        const Vec3 z = Vec3::UnitZ();
        Motor motor;
        motor.gearRatio = 10; // b = .02
        Scene scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        const double first = 2e-3;
        double inertia = first, bearing = 0;
        config->bodies.push_back(wheel("wheel", {0, 0, 1}, first, z));
        config->joints.push_back(joint("axle", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, z));
        if (what == "free base") { // two bodies turn against each other
            config->bodies.push_back(wheel("base", {0, 0, 0.9}, 5e-3, z, 3));
            config->joints[0].parent = 1;
            inertia = first * 5e-3 / (first + 5e-3);
        } else if (what == "fixed disc") {
            config->bodies.push_back(wheel("disc", {0, 0, 1.2}, 4e-3, z, 2));
            config->joints.push_back(joint("hold", JointType::Fixed, 0, 1, {0, 0, 1.1}, z));
            inertia = first + 4e-3;
        } else if (what == "offset arm") {
            config->bodies[0].mass.centre = {0.1, 0, 0};
            inertia = first + 0.01;
        } else if (what == "elbow") { // a second body that swings freely does not turn with the first; only its mass is moved
            config->bodies.push_back(wheel("hand", {0.1, 0, 1}, 1, z, 0.5));
            config->joints.push_back(joint("elbow", JointType::Hinge, 0, 1, {0.1, 0, 1}, z));
            inertia = first + 0.5 * 0.01;
        } else {
            config->joints[0].damping = bearing = 0.01;
        }
        config->devices.push_back(motor.spec());
        scene.robot("r", {}, config);
        auto world = scene.build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = 0.2; // slow enough for what is off the axle
        const double b = motor.damping(), tau = inertia / (b + bearing), end = motor.noLoad(0.2) * b / (b + bearing);
        const auto ticks = std::llround(tau / tick);
        QVERIFY(run(*world, static_cast<double>(ticks) * tick));
        const double off = timeConstant(0, end, value(*world, "r/axle/rate"), world->time()) / tau - 1;
        qInfo("tau %.5g s: %+.4f %%", tau, 100 * off);
        QVERIFY(std::abs(off) < 2e-3);
        QVERIFY(run(*world, 30 * tau));
        QVERIFY(std::abs(value(*world, "r/axle/rate") / end - 1) < 1e-4); // and ends there
    }

    void dampsInItsTimeConstant_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("inertia");
        QTest::addColumn<double>("tau");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const double tau : {0.02, 0.1, 1.0})
                for (const double inertia : {1e-4, 0.02, 3.0}) {
                    QTest::addRow("hinge, I %g, tau %g s, %g ms", inertia, tau, 1e3 * tick)
                        << tick << int(JointType::Hinge) << inertia << tau;
                    if (tau > 0.05)
                        QTest::addRow("slider, tau %g s, I %g, %g ms", tau, inertia, 1e3 * tick)
                            << tick << int(JointType::Slider) << inertia << tau;
                }
    }
    /// Damping c: the rate decays in I / c, the speed of a slider of 1 kg in m / c.
    void dampsInItsTimeConstant() {
        QFETCH(double, tick);
        QFETCH(int, type);
        QFETCH(double, inertia);
        QFETCH(double, tau);
        const bool slides = JointType(type) == JointType::Slider;
        auto world = flywheel(tick, inertia, Vec3::UnitY(), {}, (slides ? 1 : inertia) / tau, JointType(type)).build();
        QVERIFY(world);
        const double push = (slides ? 1 : inertia) / tick; // to about 1 m/s or rad/s
        QVERIFY(world->push("r/wheel", slides ? Vec3(0, push, 0) : Vec3(push / 2, 0, 0), {0, 0, slides ? 1.0 : 2.0}).ok());
        if (!slides) QVERIFY(world->push("r/wheel", {-push / 2, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(run(*world, tick));
        const double from = value(*world, "r/axle/rate"), start = world->time();
        QVERIFY(run(*world, std::max(tau, tick)));
        const double off = timeConstant(from, 0, value(*world, "r/axle/rate"), world->time() - start) / tau - 1;
        qInfo("%+.5f %%", 100 * off);
        QVERIFY(from > 0.1 && std::abs(off) < 2e-3);
    }

    void carriesItsLoad_data() { addTicks(); }
    /// Against a torque T the rate is w0 - T / b, at every tick length.
    void carriesItsLoad() {
        QFETCH(double, tick);
        const Motor motor;
        Scene scene = flywheel(tick, 0.01, Vec3::UnitY(), motor.spec());
        auto world = scene.build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = 12;
        const double load = 0.7;
        for (int i = 0; i < 2 / tick; ++i) {
            QVERIFY(world->push("r/wheel", {-load / 2, 0, 0}, {0, 0, 2}).ok());
            QVERIFY(world->push("r/wheel", {load / 2, 0, 0}, {0, 0, 0}).ok());
            QVERIFY(world->tick().ok());
        }
        QVERIFY(std::abs(value(*world, "r/motor/rate") / (motor.noLoad(12) - load / motor.damping()) - 1) < 1e-6);
        QVERIFY(std::abs(value(*world, "r/motor/torque") / load - 1) < 1e-6);
        QCOMPARE(value(*world, "r/motor/saturated"), 0.0);
    }

    /// Turned much faster than its no-load rate, a servo brakes with its limit, and says so.
    void brakesWithItsLimit_data() { addTicks(); }
    void brakesWithItsLimit() {
        QFETCH(double, tick);
        const Motor m;
        const double inertia = 0.2, limit = m.stall(), fast = 5 * m.noLoad(m.maxVoltage), arm = 0.1;
        Scene scene = flywheel(tick, inertia, Vec3::UnitZ(), m.spec());
        auto world = scene.build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/servo") = 1;
        QVERIFY(world->push("r/wheel", Vec3(0, inertia * fast / (arm * tick), 0), Vec3(arm, 0, 1)).ok());
        QVERIFY(world->tick().ok());
        const double before = value(*world, "r/axle/rate");
        QVERIFY(before > 4 * m.noLoad(m.maxVoltage));
        QVERIFY(run(*world, 0.3));
        const double torque = inertia * (value(*world, "r/axle/rate") - before) / 0.3;
        QVERIFY2(std::abs(torque / -limit - 1) < 0.002, qPrintable(QString("%1 of %2").arg(torque).arg(-limit)));
        QVERIFY(std::abs(value(*world, "r/motor/torque") / -limit - 1) < 0.002);
    }

    void servoFollowsItsLine_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("share"); // of the no-load rate
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const double share : {0.5, 0.9, -0.95, 1.0, 1.7})
                QTest::addRow("%g of no load, %g ms", share, 1e3 * tick) << tick << share;
    }
    /// A servo whose rate is far off spins up as with its highest voltage, and then keeps its rate; beyond the no-load rate it stays there.
    void servoFollowsItsLine() {
        QFETCH(double, tick);
        QFETCH(double, share);
        Motor motor;
        motor.gearRatio = 10;
        const double inertia = 5e-3, tau = inertia / motor.damping(), end = motor.noLoad(12);
        auto world = flywheel(tick, inertia, Vec3::UnitY(), motor.spec()).build(findBuiltInDevice);
        QVERIFY(world);
        std::vector<std::string> warnings;
        world->setDeviceText([&](const std::string&, int severity, const std::string& text) {
            if (severity == TRUNDLE_WARNING) warnings.push_back(text);
        });
        *slot(*world, "r/motor/servo") = 1;
        *slot(*world, "r/motor/targetRate") = share * end;
        const double reached = std::min(std::abs(share), 1.0) * end;
        double worst = 0;
        while (world->time() < 4 * tau) {
            QVERIFY(world->tick().ok());
            const double rate = std::abs(value(*world, "r/motor/rate")), free = end * -std::expm1(-world->time() / tau);
            if (free < reached - 1e-3 * end) {
                worst = std::max(worst, std::abs(rate - free) / end);
                QCOMPARE(value(*world, "r/motor/saturated"), 1.0);
            } else if (std::abs(share) < 1) QVERIFY(std::abs(rate - reached) < 2e-3 * end);
            QVERIFY(rate < reached * (1 + 1e-6));
            QVERIFY(std::abs(value(*world, "r/motor/torque")) <= motor.damping() * (end - rate) + 1e-6 * motor.stall());
        }
        qInfo("off by at most %.5f of the no-load rate", worst);
        QVERIFY(worst < 1e-4);
        QCOMPARE(value(*world, "r/motor/saturated"), share > 1 ? 1.0 : value(*world, "r/motor/saturated"));
        QCOMPARE(warnings.size(), std::size_t(share > 1 ? 1 : 0));
    }

    void outrunsNoVoltage_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<QString>("control");
        QTest::addColumn<double>("voltage");
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const char* control : {"servo", "pi", "voltage"})
                for (const double voltage : {1.0, 12.0})
                    QTest::addRow("%s, %g V, %g ms", control, voltage, 1e3 * tick) << tick << control << voltage;
    }
    /// A base that is to drive at 3 m/s with motors that reach less: never more than the motors' line at its rate and MaxVoltage.
    void outrunsNoVoltage() {
        QFETCH(double, tick);
        QFETCH(QString, control);
        QFETCH(double, voltage);
        Motor motor;
        motor.maxVoltage = voltage;
        Scene scene = r0Scene(tick);
        auto config = r0();
        config->devices = {drive(control.toStdString()), motor.spec("leftMotor", "leftAxle"),
                           motor.spec("rightMotor", "rightAxle")};
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, config);
        auto world = scene.build(findBuiltInDevice);
        QVERIFY(world);
        int warnings = 0;
        world->setDeviceText(
            [&](const std::string&, int severity, const std::string&) { warnings += severity == TRUNDLE_WARNING; });
        *slot(*world, "r/base/linearVelocity") = 3;
        double most = 0;
        const double end = motor.noLoad(voltage);
        while (world->time() < 2) {
            QVERIFY(world->tick().ok());
            for (const char* side : {"left", "right"}) {
                const double rate = value(*world, std::string("r/") + side + "Motor/rate"),
                             torque = value(*world, std::string("r/") + side + "Motor/torque");
                QVERIFY(torque <= motor.damping() * (end - rate) + 1e-6 * motor.stall());
            }
            most = std::max(most, velocity(*world, "r/chassis").x());
        }
        qInfo("%.4f m/s of %.4f", most, end * kR0Radius);
        QVERIFY(most < end * kR0Radius * 1.001);
        QVERIFY(value(*world, "r/leftMotor/rate") > 0.99 * end);
        QCOMPARE(value(*world, "r/leftMotor/saturated"), 1.0);
        QCOMPARE(warnings, control == "servo" ? 2 : 1); // each motor, or the drive
    }

    void stopsHold_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("limit");
        for (const double tick : {0.001, 0.005, 0.01, 0.03})
            for (const int type : {int(JointType::Slider), int(JointType::Hinge)})
                for (const double rate : {0.1, -1.0, 5.0})
                    for (const double limit : {5.0, 1e3, 1e6})
                        QTest::addRow("%s, %g at %g, %g ms", type == int(JointType::Slider) ? "slider" : "hinge", rate, limit,
                                      1e3 * tick)
                            << tick << type << rate << limit;
    }
    /// A motor that runs its child against a stop: it lands there and stays, and leaves when it is driven away.
    void stopsHold() {
        QFETCH(double, tick);
        QFETCH(int, type);
        QFETCH(double, rate);
        QFETCH(double, limit);
        Scene scene = flywheel(tick, 0.3, Vec3::UnitX(), row("motor", "axle"), 0, JointType(type));
        auto config = std::make_shared<RobotConfigSpec>(*scene.spec->robots[0].config);
        config->joints[0].highStop = 0.21;
        config->joints[0].lowStop = -0.13;
        scene.spec->robots[0].config = config;
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/motor", rate, 0, limit);
        const double stop = rate > 0 ? 0.21 : -0.13;
        bool there = false;
        while (world->time() < 4) {
            QVERIFY(world->tick().ok());
            const double position = value(*world, "r/axle/position"), away = -value(*world, "r/axle/rate") * (rate > 0 ? 1 : -1);
            there = there || std::abs(position - stop) < 1e-4;
            QVERIFY2(away < 1e-3 && (!there || std::abs(position - stop) < 1e-4), qPrintable(QString::number(position - stop)));
        }
        QVERIFY(there);
        command(*world, "r/motor", -rate, 0, limit);
        QVERIFY(run(*world, tick));
        QVERIFY(std::abs(value(*world, "r/axle/rate")) <= std::abs(rate) * (1 + 1e-6));
        QVERIFY(run(*world, 2 * tick));
        QVERIFY(value(*world, "r/axle/rate") * rate < 0);
    }

    /// A rotor inertia needs a rotating joint.
    void rejectsRotorOnSlider() {
        Diagnostics diagnostics;
        Motor motor;
        motor.rotorInertia = 1e-5;
        QVERIFY(!flywheel(0.01, 0.01, Vec3::UnitZ(), motor.spec(), 0, JointType::Slider).build(findBuiltInDevice, diagnostics));
        QVERIFY(QString::fromStdString(diagnostics.all().at(0).message).contains("inertia"));
    }
};

QTEST_APPLESS_MAIN(MotorTest)
#include "motor_test.moc"
