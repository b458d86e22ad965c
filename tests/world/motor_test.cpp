// Spin-up time of the shipped motor on a flywheel, including the rotor inertia behind the gear.
#include <QtTest>

#include "devices/builtin.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kTorqueConstant = 0.02, kSpeedConstant = 50, kResistance = 2, kFlywheel = 0.01;

/// RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 GearRatio=... RotorInertia=... }
ComponentSpec motor(double gearRatio, double rotorInertia) {
    ComponentSpec spec;
    spec.kind = "RotaryMotor";
    spec.name = "motor";
    spec.values["Joint"] = textValue("axle");
    spec.values["TorqueConstant"] = numberValue(kTorqueConstant);
    spec.values["SpeedConstant"] = numberValue(kSpeedConstant);
    spec.values["Resistance"] = numberValue(kResistance);
    spec.values["MaxVoltage"] = numberValue(12);
    spec.values["GearRatio"] = numberValue(gearRatio);
    spec.values["RotorInertia"] = numberValue(rotorInertia);
    return spec;
}

/// A flywheel of 0.01 kg m^2 about `axis`, 0.02 across it, on an axle fixed to the world.
Scene flywheel(double tick, JointType type, const Vec3& axis, const ComponentSpec& device) {
    Scene scene(tick);
    const Mat3 inertia = 2 * kFlywheel * Mat3::Identity() - kFlywheel * axis * axis.transpose();
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("wheel", at(0, 0, 1), {1, Vec3::Zero(), inertia}, {}));
    config->joints.push_back(joint("axle", type, kWorldBody, 0, {0, 0, 1}, axis));
    config->devices.push_back(device);
    scene.robot("r", {}, config);
    return scene;
}

} // namespace

class MotorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void spinsUpInItsTimeConstant_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("gearRatio");
        QTest::addColumn<double>("rotorInertia");
        QTest::addColumn<double>("lean"); // of the axle, rad
        QTest::newRow("no rotor") << 1e-3 << 30.0 << 0.0 << 0.0;
        QTest::newRow("rotor") << 1e-3 << 30.0 << 1e-5 << 0.0;
        QTest::newRow("heavy rotor, no gear") << 1e-3 << 1.0 << 0.03 << 0.0;
        QTest::newRow("rotor on a leaning axle") << 1e-3 << 30.0 << 1e-5 << 0.7;
        QTest::newRow("rotor, 10 ms") << 0.01 << 30.0 << 1e-5 << 0.0;
    }
    /// w(t) = V kv / G (1 - e^(-t / tau)), tau = (I + G^2 J) / b, b = kt G^2 / (R kv). In ticks, implicit Euler: (1 + h / tau)^-n for the power.
    void spinsUpInItsTimeConstant() {
        QFETCH(double, tick);
        QFETCH(double, gearRatio);
        QFETCH(double, rotorInertia);
        QFETCH(double, lean);
        auto world = flywheel(tick, JointType::Hinge, Vec3(std::sin(lean), 0, std::cos(lean)), motor(gearRatio, rotorInertia))
                         .build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = 6;
        const double gear2 = gearRatio * gearRatio, b = kTorqueConstant * gear2 / (kResistance * kSpeedConstant);
        const double tau = (kFlywheel + gear2 * rotorInertia) / b, last = 6 * kSpeedConstant / gearRatio;
        const auto ticks = static_cast<int>(std::llround(tau / tick));
        QVERIFY(run(*world, ticks * tick));
        const double rate = value(*world, "r/axle/rate"), expected = last * (1 - std::pow(1 + tick / tau, -ticks));
        qInfo("tau %.4f s: %.6f rad/s, expected %.6f, in the limit of small ticks %.6f", tau, rate, expected,
              last * (1 - std::exp(-ticks * tick / tau)));
        QVERIFY(std::abs(rate / expected - 1) < 1e-5);
    }

    /// A rotor inertia needs a rotating joint.
    void rejectsRotorOnSlider() {
        Diagnostics diagnostics;
        QVERIFY(!flywheel(0.01, JointType::Slider, Vec3::UnitZ(), motor(30, 1e-5)).build(findBuiltInDevice, diagnostics));
        QVERIFY(QString::fromStdString(diagnostics.all().at(0).message).contains("inertia"));
    }
};

QTEST_APPLESS_MAIN(MotorTest)
#include "motor_test.moc"
