// A motor with friction, a gear with losses, a driver with limits, a winding that heats up: against closed forms, in whole worlds.
#include "sensor_world.h"

#include "devices/motor_losses.h"
#include "devices/winding_heat.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kKt = 0.02, kKv = 50, kOhms = 2, kGear = 30, kVolts = 12;
constexpr double kDry = 2e-3, kViscous = 4e-6; // of the rotor

std::string spinner(double tick, const std::string& losses, const std::string& more = "", const char* wheel = "Mass=2") {
    char text[1000];
    std::snprintf(
        text, sizeof text,
        "Tick=%g Gravity=0,0,0\nRobotConfig Spinner {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
        "  Body wheel { Cylinder disc { Radius=0.1 Length=0.02 %s } }\n  Fixed hold { Parent=world Child=stand }\n"
        "  Hinge axle { Parent=stand Child=wheel Axis=0,0,1 }\n  RotaryMotor motor { Joint=axle TorqueConstant=%g "
        "SpeedConstant=%g "
        "Resistance=%g GearRatio=%g MaxVoltage=%g ",
        tick, wheel, kKt, kKv, kOhms, kGear, kVolts);
    return text + losses + " }\n" + more + "}\nRobot r { Config=Spinner Pos=0,0,3 }\n";
}

std::string friction(double efficiency, double back) {
    char text[200];
    std::snprintf(text, sizeof text, "FrictionTorque=%g ViscousFriction=%g Efficiency=%g BackdrivingEfficiency=%g", kDry,
                  kViscous, efficiency, back);
    return text;
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

/// One tick with a torque (N m) about the axle from outside.
bool turnBy(SensorWorld& w, double torque) {
    return w.world().push("r/wheel", {-torque / 2, 0, 0}, {0, 1, 3}).ok() &&
           w.world().push("r/wheel", {torque / 2, 0, 0}, {0, -1, 3}).ok() && w.run();
}

bool isNear(double value, double expected, double share) {
    if (std::abs(value - expected) <= share * std::abs(expected)) return true;
    qWarning("%.9g, not %.9g", value, expected);
    return false;
}

void addTicks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
}

} // namespace

class MotorLossesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void speedsFollowTheCurve_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("efficiency");
        QTest::addColumn<double>("back");
        QTest::addColumn<double>("load");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const double efficiency : {1.0, 0.7})
                for (const double load : {0.0, 0.5, 1.5, -1.0}) // the last one drives the motor
                    QTest::addRow("%g N m, efficiency %g, %g ms", load, efficiency, 1e3 * tick)
                        << tick << efficiency << 0.6 << load;
    }
    /// G (kt i - Tf - b G w) = T / efficiency where the motor drives, T * back where it is driven, i = (V - G w / kv) / R.
    void speedsFollowTheCurve() {
        QFETCH(double, tick);
        QFETCH(double, efficiency);
        QFETCH(double, back);
        QFETCH(double, load);
        SensorWorld w(spinner(tick, friction(efficiency, back)));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", kVolts);
        while (w.time() < 8) QVERIFY(turnBy(w, -load));
        const double before = load >= 0 ? load / efficiency : load * back;
        const double rate = (kGear * (kKt * kVolts / kOhms - kDry) - before) / (kGear * kGear * (kKt / (kKv * kOhms) + kViscous));
        const double amperes = (kVolts - kGear * rate / kKv) / kOhms;
        QVERIFY(isNear(w.value("r/motor/rate"), rate, 1e-4));
        QVERIFY(isNear(w.value("r/motor/current"), amperes, 1e-3));
        QVERIFY(std::abs(w.value("r/motor/torque") - load) < 1e-4 * kGear * kKt * kVolts / kOhms);
        if (load == 0) QVERIFY(isNear(w.value("r/motor/current"), (kDry + kViscous * kGear * rate) / kKt, 1e-3)); // without load
    }

    void stalls_data() { addTicks(); }
    /// Between the torques at which it starts forwards and backwards it stays where it is.
    void stalls() {
        QFETCH(double, tick);
        for (const double load : {0.99, 0.5, 0.0}) {
            SensorWorld w(spinner(tick, friction(0.7, 0.6)));
            QVERIFY2(w.ok(), w.failure().c_str());
            const double volts = 6, inner = kGear * kKt * volts / kOhms, forwards = 0.7 * (inner - kGear * kDry),
                         backwards = (inner + kGear * kDry) / 0.6;
            command(w, "r/motor/voltage", volts);
            const double torque = forwards + 0.005 * backwards + load * 0.99 * (backwards - forwards);
            const double start = w.value("r/axle/position");
            while (w.time() < 3) QVERIFY(turnBy(w, -torque));
            QVERIFY2(std::abs(w.value("r/axle/position") - start) < 1e-5,
                     qPrintable(QString::number(w.value("r/axle/position"))));
            QVERIFY(isNear(w.value("r/motor/current"), volts / kOhms, 1e-3));
            QVERIFY(isNear(w.value("r/motor/torque"), torque, 1e-3));
            while (w.time() < 4) QVERIFY(turnBy(w, -0.99 * forwards));
            QVERIFY(w.value("r/motor/rate") > 1e-3);
            const double up = w.value("r/axle/position");
            while (w.time() < 8) QVERIFY(turnBy(w, -1.02 * backwards));
            QVERIFY(w.value("r/axle/position") < up);
            QVERIFY(w.value("r/motor/rate") < -1e-3);
        }
    }

    void holdsBelowItsFriction_data() { addTicks(); }
    void holdsBelowItsFriction() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, "FrictionTorque=0.002"));
        QVERIFY2(w.ok(), w.failure().c_str());
        while (w.time() < 60) QVERIFY(turnBy(w, 0.95 * kGear * kDry));
        QVERIFY2(std::abs(w.value("r/axle/position")) < 1e-6, qPrintable(QString::number(w.value("r/axle/position"))));
        command(w, "r/motor/voltage", 0.95 * kDry * kOhms / kKt);
        QVERIFY(w.run(2000));
        QVERIFY(std::abs(w.value("r/axle/position")) < 1e-6);
        QVERIFY(isNear(w.value("r/motor/current"), 0.95 * kDry / kKt, 1e-3));
        command(w, "r/motor/voltage", 1.2 * kDry * kOhms / kKt);
        QVERIFY(w.run(2000));
        QVERIFY(w.value("r/axle/position") > 0.01);
    }

    void energyIsBalanced_data() { addTicks(); }
    /// Electric = mechanical + copper + friction + gear, of a motor that speeds up, is loaded, driven and brakes, from a battery.
    void energyIsBalanced() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, friction(0.7, 0.6), "Battery battery { Capacity=1Ah Voltage=12 InternalResistance=0.05 }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        double drawn = 0, electric = 0, mechanical = 0, copper = 0, rubbed = 0, gear = 0;
        while (w.time() < 12) {
            const double t = w.time(), load = t < 4 ? 0.8 : t < 8 ? -1.2 : 0;
            command(w, "r/motor/voltage", t < 8 ? 10 : t < 10 ? -6 : 0);
            QVERIFY(turnBy(w, -load));
            const double i = w.value("r/motor/current"), rate = w.value("r/motor/rate"), torque = w.value("r/motor/torque");
            const double net = kGear * kKt * i - std::copysign(kGear * kDry, rate) - kGear * kGear * kViscous * rate;
            drawn += tick * w.value("r/battery/voltage") * w.value("r/battery/current");
            electric += tick * i * w.value("r/motor/terminalVoltage");
            mechanical += tick * torque * rate;
            copper += tick * kOhms * i * i;
            rubbed += tick * (kGear * kDry * std::abs(rate) + kGear * kGear * kViscous * rate * rate);
            gear += tick * (net * rate > 0 ? 0.3 : 1 - 1 / 0.6) * net * rate;
        }
        qInfo("%.3f J drawn, electric %.3f: mechanical %.3f, copper %.3f, friction %.3f, gear %.3f", drawn, electric, mechanical,
              copper, rubbed, gear);
        QVERIFY(isNear(drawn, electric, 1e-3));
        QVERIFY(isNear(mechanical + copper + rubbed + gear, electric, 0.01));
        QVERIFY(rubbed > 1 && gear > 1 && copper > 1);
    }

    /// The wheeled engine has the same friction: a base at its speed, and one whose voltage is too low to start.
    void bothEnginesAgree_data() {
        QTest::addColumn<QString>("engine");
        for (const char* engine : {"general", "wheeled"}) QTest::newRow(engine) << engine;
    }
    void bothEnginesAgree() {
        QFETCH(QString, engine);
        const std::string motor =
            " TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 FrictionTorque=0.002 "
            "ViscousFriction=4e-6 Efficiency=0.8 }\n";
        SensorWorld w(
            "Tick=0.01 Engine=" + engine.toStdString() +
            "\nSurface rubber { Friction=0.9 }\nSurface slick { Friction=0 }\nStaticConfig Floor { Plane floor { "
            "Surface=rubber } }\nStatic floor { Config=Floor }\nRobotConfig Base {\n  Body hull { Box box { Size=0.2,0.1,0.05 "
            "Pos=0,0,0.08 Mass=2 } Sphere back { Radius=0.02 Pos=-0.1,0,0.02 Mass=0.1 Surface=slick } }\n"
            "  Body left { Pos=0,0.1,0.04 Cylinder tyre { Radius=0.04 Length=0.02 HPR=0,0,90 Mass=0.1 Surface=rubber } }\n"
            "  Body right { Pos=0,-0.1,0.04 Cylinder tyre { Radius=0.04 Length=0.02 HPR=0,0,90 Mass=0.1 Surface=rubber } }\n"
            "  Hinge leftAxle { Parent=hull Child=left Axis=0,1,0 }\n  Hinge rightAxle { Parent=hull Child=right Axis=0,1,0 }\n"
            "  RotaryMotor leftMotor { Joint=leftAxle" +
            motor + "  RotaryMotor rightMotor { Joint=rightAxle" + motor +
            "  DifferentialDrive base { LeftMotor=leftMotor RightMotor=rightMotor WheelRadius=0.04 WheelSeparation=0.2 "
            "Control=voltage MaxAcceleration=0 }\n}\nRobot r { Config=Base }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        const double still = 0.9 * kDry * kOhms / kKt * kKv / kGear * 0.04; // m/s that this voltage would give without friction
        command(w, "r/base/linearVelocity", still);
        QVERIFY(w.run(500));
        QVERIFY(std::abs(w.value("r/leftAxle/position")) < 1e-4);
        QVERIFY(isNear(w.value("r/leftMotor/current"), 0.9 * kDry / kKt, 1e-3));
        command(w, "r/base/linearVelocity", 0.4);
        QVERIFY(w.run(800));
        const double volts = 0.4 / 0.04 * kGear / kKv;
        const double rate = (kKt * volts / kOhms - kDry) / (kGear * (kKt / (kKv * kOhms) + kViscous));
        QVERIFY(isNear(w.value("r/leftMotor/rate"), rate, 2e-3));
        QVERIFY(isNear(w.value("r/leftMotor/current"), (kDry + kViscous * kGear * rate) / kKt, 5e-3));
        QVERIFY(std::abs(w.value("r/base/slip", 0)) < 2e-3 && std::abs(w.value("r/base/slip", 1)) < 2e-3);
    }

    void aDriverLimitsItsCurrent_data() { addTicks(); }
    /// The highest current of voltage commands, of a servo that speeds up and that brakes, and of a motor that is driven.
    void aDriverLimitsItsCurrent() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, "CurrentLimit=1.5"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 12);
        double most = 0, seconds = 0;
        const auto watch = [&](double until, double torque = 0) {
            for (most = seconds = 0; w.time() < until;) {
                if (!turnBy(w, torque)) return false;
                most = std::max(most, std::abs(w.value("r/motor/current")));
                if (w.value("r/motor/saturated") != 0) seconds += tick;
            }
            return most <= 1.5 * (1 + 1e-9);
        };
        const double inertia = 0.5 * 2 * 0.01, torque = 1.5 * kKt * kGear;
        QVERIFY(watch(0.09));
        QVERIFY(isNear(w.value("r/motor/rate"), 0.09 * torque / inertia, 1e-6));
        QVERIFY(isNear(seconds, 0.09, 1e-6));
        QVERIFY(watch(2));
        command(w, "r/motor/voltage", -12);
        QVERIFY(watch(4));
        QVERIFY(isNear(most, 1.5, 1e-9));
        QVERIFY(isNear(w.value("r/motor/rate"), -20, 1e-3));
        command(w, "r/motor/servo", 1);
        command(w, "r/motor/targetRate", 15);
        QVERIFY(watch(6));
        QVERIFY(isNear(most, 1.5, 1e-9) && isNear(w.value("r/motor/rate"), 15, 1e-6));
        QVERIFY(watch(7, 2 * torque)); // driven faster than it can hold
        QVERIFY(isNear(most, 1.5, 1e-9));
        command(w, "r/motor/targetRate", -15);
        QVERIFY(watch(12));
        QVERIFY(isNear(w.value("r/motor/rate"), -15, 1e-6));
    }

    void aDriverHasADeadBandAndSteps() {
        SensorWorld w(spinner(0.01, "DeadBand=0.5 PwmSteps=100"));
        QVERIFY2(w.ok(), w.failure().c_str());
        const auto voltageAt = [&](double command_) {
            command(w, "r/motor/voltage", command_);
            return w.run(2) ? w.value("r/motor/terminalVoltage") : std::nan("");
        };
        QVERIFY(std::abs(voltageAt(0.49)) < 1e-9 && std::abs(voltageAt(-0.49)) < 1e-9);
        QVERIFY(isNear(voltageAt(0.5), 0.48, 1e-9)); // 4 of 100 steps of 0.12 V
        QVERIFY(isNear(voltageAt(6.1), 6.12, 1e-9) && isNear(voltageAt(-6.05), -6, 1e-9));
        QVERIFY(isNear(voltageAt(20), 12, 1e-9));
    }

    void itsWindingHeatsUp_data() { addTicks(); }
    /// Held at a constant current: T = Ta + (R1 + R2) I^2 R (1 + a (T - 25)), reached as winding and housing take their time.
    void itsWindingHeatsUp() {
        QFETCH(double, tick);
        SensorWorld w(spinner(tick, "CurrentLimit=2 FrictionTorque=1 ThermalResistanceWinding=2 ThermalResistanceHousing=6 "
                                    "ThermalTimeConstantWinding=4 ThermalTimeConstantHousing=30 AmbientTemperature=20"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 12);
        QVERIFY(w.run());
        QVERIFY(isNear(w.value("r/motor/temperature"), 20, 0.01));
        double winding = 20, housing = 20;
        for (int i = 0; i < 200000; ++i) { // 20 s by the two equations, in small steps
            const double watts = 4 * kOhms * (1 + 0.0039 * (winding - 25)), flow = (winding - housing) / 2;
            winding += 1e-4 * (watts - flow) / (4 / 2.);
            housing += 1e-4 * (flow - (housing - 20) / 6) / (30 / 6.);
        }
        QVERIFY(w.run(int(std::lround(20 / tick)) - 1));
        QVERIFY(isNear(w.value("r/motor/temperature"), winding, 5e-3));
        QVERIFY(w.run(int(std::lround(600 / tick))));
        const double heat = 8 * 4 * kOhms, end = (20 + heat * (1 - 0.0039 * 25)) / (1 - heat * 0.0039);
        QVERIFY(isNear(w.value("r/motor/temperature"), end, 1e-4));
        QVERIFY(isNear(w.value("r/motor/current"), 2, 1e-6));
    }

    void itsDriverProtectsIt() {
        SensorWorld w(
            spinner(0.01, "FrictionTorque=1 ThermalResistanceWinding=2 ThermalResistanceHousing=6 ThermalTimeConstantWinding=1 "
                          "ThermalTimeConstantHousing=10 MaxTemperature=80"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 12);
        for (int i = 0; i < 20000; ++i) {
            QVERIFY(w.run());
            QVERIFY(w.value("r/motor/temperature") < 80);
        }
        QVERIFY(w.value("r/motor/temperature") > 70);
        QVERIFY(w.value("r/motor/current") < 6 && w.value("r/motor/current") > 1);
        QCOMPARE(w.value("r/motor/saturated"), 1.);
    }

    /// In each unit and as an expression: the same motor.
    void constantsAreInTheUnitsOfDataSheets() {
        const auto rateWith = [](const std::string& from, const std::string& to) {
            std::string text = spinner(0.01, "");
            text.replace(text.find(from), from.size(), to);
            SensorWorld w(text);
            if (!w.ok()) qWarning("%s", w.failure().c_str());
            if (w.ok()) command(w, "r/motor/voltage", 6);
            return w.ok() && w.run(5) ? w.value("r/axle/rate") : -1;
        };
        const double expected = rateWith("Mass=2", "Mass=2");
        QVERIFY(expected > 0);
        for (const char* constant : {"22 mNm/A", "0.022 Nm/A", "$(22 mNm/A)", "$(2.2 Nm / 100 A)"})
            QVERIFY2(isNear(rateWith("TorqueConstant=0.02 ", std::string("TorqueConstant=") + constant + " "),
                            rateWith("TorqueConstant=0.02 ", "TorqueConstant=0.022 "), 1e-9),
                     constant);
        for (const char* constant : {"0.02 Vs/rad", "0.0020943951023932 V/rpm", "$(20 mV * 1 s / 1 rad)"})
            QVERIFY2(isNear(rateWith("SpeedConstant=50 ", std::string("BackEmfConstant=") + constant + " "), expected, 1e-9),
                     constant);
    }

    void refusesHalfOfAThermalModel() {
        SensorWorld w(spinner(0.01, "ThermalResistanceWinding=2"));
        QVERIFY(!w.ok() && w.failure().find("together") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(MotorLossesTest)
#include "motor_losses_test.moc"
