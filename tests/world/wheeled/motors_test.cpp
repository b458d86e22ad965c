// Motors with losses and limits on wheels that grip, in the wheeled engine and with planar vehicles: as in the general engine.
#include <QtTest>

#include <array>

#include "devices/builtin.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

struct MotorCase {
    double tick;
    bool servo, friction, limit, viscous, inductance;

    [[nodiscard]] QString name() const {
        QString text = QString("%1 ms, %2").arg(1e3 * tick).arg(servo ? "servo" : "voltage");
        if (friction) text += ", dry friction";
        if (limit) text += ", current limit";
        if (viscous) text += ", viscous friction";
        if (inductance) text += ", inductance";
        return text;
    }
};

/// R0 with real motors.
std::shared_ptr<RobotConfigSpec> withMotors(const MotorCase& c) {
    auto config = std::make_shared<RobotConfigSpec>(*r0());
    for (ComponentSpec& motor : config->devices) {
        motor.kind = "RotaryMotor";
        const auto set = [&motor](const char* property, double value) { motor.values[property] = numberValue(value); };
        set("TorqueConstant", 0.02);
        set("SpeedConstant", 50);
        set("Resistance", 2);
        set("MaxVoltage", 12);
        set("GearRatio", 40);
        if (c.friction) set("FrictionTorque", 0.004);
        if (c.limit) set("CurrentLimit", 0.5);
        if (c.viscous) set("ViscousFriction", 2e-5);
        if (c.inductance) set("Inductance", 2e-3);
    }
    return config;
}

/// How far it drives backwards in half a second, and how far its wheels turn, m.
std::optional<std::array<double, 2>> driven(EngineChoice engine, const MotorCase& c) {
    Scene scene = r0Scene(c.tick);
    scene.spec->settings.engine = engine;
    scene.scenery({plane("floor", {}, 1)}).robot("r", {}, withMotors(c));
    auto world = scene.build(findBuiltInDevice);
    if (!world) return {};
    for (const std::string motor : {"r/leftMotor", "r/rightMotor"}) {
        *slot(*world, motor + "/servo") = c.servo;
        *slot(*world, motor + (c.servo ? "/targetRate" : "/voltage")) = -1.6;
    }
    if (!run(*world, 0.48)) return {};
    return std::array{-world->robotPose(0).position.x(), -kR0Radius * value(*world, "r/leftAxle/position")};
}

} // namespace

class WheeledMotorsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// From rest, with each combination.
    void driveAsInGeneral_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.002, 0.004, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    void driveAsInGeneral() {
        QFETCH(double, tick);
        for (unsigned bits = 0; bits < 32; ++bits) {
            const MotorCase c{tick, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
            const auto expected = driven(EngineChoice::General, c);
            QVERIFY(expected && (*expected)[0] > 0.02);
            for (const EngineChoice engine : {EngineChoice::Wheeled, EngineChoice::Planar}) {
                const auto found = driven(engine, c);
                QVERIFY(found);
                for (std::size_t k = 0; k < 2; ++k)
                    QVERIFY2(std::abs((*found)[k] / (*expected)[k] - 1) < 0.02,
                             qPrintable(QString("%1: %2 of %3 m").arg(c.name()).arg((*found)[k]).arg((*expected)[k])));
            }
        }
    }
};

QTEST_APPLESS_MAIN(WheeledMotorsTest)
#include "motors_test.moc"
