// Batteries against closed forms: run time by the integral of their tables, sag, energy balance, what happens when they are empty.
#include "devices/discharge_curve.h"
#include "radio/medium.h"
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

/// A wheel on a stand, with a motor without gear and the devices of `more`.
std::string spinner(const std::string& battery, const std::string& more = "", const std::string& wheel = "Mass=0.2",
                    const std::string& motor = "", const std::string& tick = "0.002") {
    return "Tick=" + tick +
           " Gravity=0,0,0\nRobotConfig Spinner {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
           "  Body wheel { Cylinder disc { Radius=0.1 Length=0.02 HPR=0,0,90 " +
           wheel +
           " } }\n  Body fan { Pos=0,1,0 Cylinder disc { Radius=0.1 Length=0.02 HPR=0,0,90 Mass=0.2 } }\n"
           "  Fixed hold { Parent=world Child=stand }\n  Hinge axle { Parent=stand Child=wheel Axis=0,1,0 }\n"
           "  Hinge shaft { Parent=stand Child=fan Axis=0,1,0 }\n"
           "  RotaryMotor motor { Joint=axle TorqueConstant=0.05 SpeedConstant=20 Resistance=2 MaxVoltage=12 " +
           motor + " }\n  " + (battery.empty() ? "" : "Battery battery { " + battery + " }\n  ") + more + "\n}\n" +
           "Robot r { Config=Spinner Pos=0,0,3 }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

bool isNear(double value, double expected, double share) {
    if (std::abs(value - expected) <= share * std::abs(expected)) return true;
    qWarning("%.9g, not %.9g", value, expected);
    return false;
}

/// Time until a constant power has drawn the charge of a battery: the integral of dq / I(q) with (E(q) - R I) I = P.
double runTime(const char* chemistry, int cells, double coulombs, double ohms, double watts) {
    constexpr int kSteps = 200000;
    double time = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double open = cells * voltageAt(dischargeCurveOf(chemistry), (i + 0.5) / kSteps);
        const double root = std::sqrt(open * open - 4 * ohms * watts);
        const double amperes = ohms > 0 ? (open - root) / (2 * ohms) : watts / open;
        time += coulombs / kSteps / amperes;
    }
    return time;
}

} // namespace

class BatteryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void curvesAreTheirSources() {
        QCOMPARE(voltageAt(dischargeCurveOf("NiMH"), 0), 1.005);
        QCOMPARE(voltageAt(dischargeCurveOf("NiMH"), 0.55), 1.26);
        QCOMPARE(voltageAt(dischargeCurveOf("NiMH"), 1), 1.42);
        const std::span<const double> lithium = dischargeCurveOf("LiIon");
        for (std::size_t i = 0; i < lithium.size(); i += 2) { // Chen and Rincon-Mora, eq. 2
            const double s = lithium[i];
            const double open = -1.031 * std::exp(-35 * s) + 3.685 + 0.2156 * s - 0.1178 * s * s + 0.3201 * s * s * s;
            QVERIFY(std::abs(lithium[i + 1] - open) <= 0.00051);
        }
    }

    void runsAsLongAsItsTableSays_data() {
        QTest::addColumn<QString>("chemistry");
        QTest::addColumn<int>("cells");
        QTest::addColumn<double>("ohms");
        QTest::addColumn<double>("watts");
        QTest::newRow("NiMH") << "NiMH" << 6 << 0. << 8.;
        QTest::newRow("NiMH with a resistance") << "NiMH" << 6 << 0.5 << 8.;
        QTest::newRow("LiIon") << "LiIon" << 2 << 0. << 8.;
        QTest::newRow("LiIon with a resistance") << "LiIon" << 3 << 0.6 << 15.;
    }
    void runsAsLongAsItsTableSays() {
        QFETCH(QString, chemistry);
        QFETCH(int, cells);
        QFETCH(double, ohms);
        QFETCH(double, watts);
        const QString fields = QString("Capacity=0.01 Cells=%1 Chemistry=%2 InternalResistance=%3 BaseLoad=%4")
                                   .arg(cells)
                                   .arg(chemistry)
                                   .arg(ohms)
                                   .arg(watts);
        SensorWorld w(spinner(fields.toStdString(), "", "Mass=0.2", "", "0.01"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("r/battery/charge"), 36.);
        QCOMPARE(w.value("r/battery/level"), 1.);
        double drawn = 0;
        while (w.value("r/battery/charge") > 0 && w.time() < 200) {
            QVERIFY(w.run());
            drawn += 0.01 * w.value("r/battery/current") * w.value("r/battery/voltage");
        }
        const double expected = runTime(chemistry.toUtf8(), cells, 36, ohms, watts);
        qInfo("%.2f s, by the integral %.2f s", w.time(), expected);
        QVERIFY(isNear(w.time(), expected, 0.005));
        QVERIFY(isNear(drawn, watts * w.time(), 0.002));
        QVERIFY(w.run());
        QCOMPARE(w.value("r/battery/voltage"), 0.);
        QCOMPARE(w.value("r/battery/openVoltage"), 0.);
        QCOMPARE(w.value("r/battery/current"), 0.);
    }

    /// A motor that hardly turns is a resistance: V = E / (1 + R d^2 / Rm) with the driver's share d.
    void theVoltageSagsUnderAMotor_data() {
        QTest::addColumn<double>("volts"); // commanded
        QTest::addColumn<double>("ohms");
        for (const double ohms : {0., 0.2, 2., 20.})
            for (const double volts : {12., 6., -9.}) QTest::addRow("%g V, %g ohm", volts, ohms) << volts << ohms;
    }
    void theVoltageSagsUnderAMotor() {
        QFETCH(double, volts);
        QFETCH(double, ohms);
        SensorWorld w(spinner("Capacity=1 Voltage=12 InternalResistance=" + std::to_string(ohms), "", "Mass=1e6"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", volts);
        QVERIFY(w.run(10));
        const double share = volts / 12, expected = 12 / (1 + ohms * share * share / 2);
        QVERIFY(isNear(w.value("r/battery/voltage"), expected, 1e-4));
        QVERIFY(isNear(w.value("r/motor/terminalVoltage"), share * expected, 1e-4));
        QVERIFY(isNear(w.value("r/motor/current"), share * expected / 2, 1e-4));
        QVERIFY(isNear(w.value("r/battery/current"), share * share * expected / 2, 1e-4));
    }

    /// The battery's chemical energy goes into its resistance, the windings, the turning wheel and the fan that a servo turns.
    void energyIsBalanced() {
        SensorWorld w(spinner("Capacity=0.05 Cells=3 Chemistry=LiIon InternalResistance=0.3 BaseLoad=1",
                              "Servo servo { Joint=shaft Mode=speed MaxTorque=0.2 MaxSpeed=40 }", "Mass=2"));
        QVERIFY2(w.ok(), w.failure().c_str());
        double chemical = 0, heat = 0, base = 0, motor = 0, winding = 0, shaft = 0, servoHeat = 0, servoShaft = 0;
        const double h = 0.002;
        for (int i = 0; i < 6000; ++i) {
            command(w, "r/motor/voltage", i % 2000 < 1200 ? 11 : i % 2000 < 1500 ? 4 : -8); // also brakes
            command(w, "r/servo/target", i % 3000 < 1500 ? 25 : -10);
            QVERIFY(w.run());
            const double amperes = w.value("r/battery/current"), current = w.value("r/motor/current");
            const double torque = w.value("r/servo/torque");
            chemical += h * amperes * w.value("r/battery/openVoltage");
            heat += h * amperes * amperes * 0.3;
            base += h * 1;
            motor += h * current * w.value("r/motor/terminalVoltage");
            winding += h * current * current * 2;
            shaft += h * w.value("r/motor/torque") * w.value("r/motor/rate");
            servoHeat += h * torque * torque * 40 / 0.2;
            servoShaft += h * torque * w.value("r/servo/rate");
        }
        qInfo("%.2f J: battery %.2f, base %.2f, motor %.2f (winding %.2f, shaft %.2f), servo %.2f + %.2f", chemical, heat, base,
              motor, winding, shaft, servoHeat, servoShaft);
        QVERIFY(isNear(heat + base + motor + servoHeat + servoShaft, chemical, 0.01));
        QVERIFY(isNear(winding + shaft, motor, 0.01));
        QVERIFY(chemical > 100 && shaft > 10 && servoHeat > 0.1 && heat > 5);
        QVERIFY(isNear(180 - w.value("r/battery/charge"), 180 * (1 - w.value("r/battery/level")), 1e-9));
    }

    /// Voltage x current is the power of all of its devices, whatever their order in the text.
    void everythingDraws() {
        const std::string devices = "Servo servo { Joint=shaft MaxTorque=0.5 MaxSpeed=10 }\n"
                                    "Transceiver radio { Body=stand ReceiveCurrent=0.02 SupplyVoltage=3 }\n"
                                    "LightSensor eye { Body=stand Power=0.15 }\nCamera camera { Body=stand Power=1.1 }\n";
        SensorWorld w(spinner("Capacity=1 Voltage=12 InternalResistance=0.1 BaseLoad=2", devices));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 7);
        command(w, "r/servo/target", 1);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(w.run());
            const double torque = w.value("r/servo/torque");
            const double watts = 2 + 0.06 + 0.15 + 1.1 + w.value("r/motor/current") * w.value("r/motor/terminalVoltage") +
                                 torque * w.value("r/servo/rate") + torque * torque * 10 / 0.5;
            QVERIFY(isNear(w.value("r/battery/current") * w.value("r/battery/voltage"), watts, 1e-6));
        }
        const std::string text = spinner("Capacity=1 Voltage=12 InternalResistance=0.1 BaseLoad=2", devices);
        const std::size_t from = text.find("  Battery"), to = text.find('\n', from) + 1, first = text.find("  RotaryMotor");
        SensorWorld before(text.substr(0, first) + text.substr(from, to - from) + text.substr(first, from - first) +
                           text.substr(to));
        QVERIFY2(before.ok(), before.failure().c_str());
        command(before, "r/motor/voltage", 7);
        command(before, "r/servo/target", 1);
        QVERIFY(before.run(100));
        QCOMPARE(before.value("r/battery/charge"), w.value("r/battery/charge"));
        QCOMPARE(before.world().stateHash(), w.world().stateHash());
    }

    void withoutABatteryNothingChanges() {
        SensorWorld bare(spinner("")), ideal(spinner("Capacity=1 Voltage=12"));
        QVERIFY2(bare.ok() && ideal.ok(), (bare.failure() + ideal.failure()).c_str());
        for (SensorWorld* w : {&bare, &ideal}) {
            command(*w, "r/motor/voltage", 12);
            QVERIFY(w->run(500));
        }
        QCOMPARE(bare.value("r/motor/rate"), ideal.value("r/motor/rate")); // of one without a resistance, at its voltage
        SensorWorld held(spinner("", "", "Mass=0.2", "Efficiency=0.8")),
            fed(spinner("Capacity=1 Voltage=12", "", "Mass=0.2", "Efficiency=0.8"));
        for (SensorWorld* w : {&held, &fed}) {
            command(*w, "r/motor/servo", 1);
            command(*w, "r/motor/targetRate", 150);
            QVERIFY(w->run(100));
        }
        QCOMPARE(held.value("r/motor/rate"), fed.value("r/motor/rate"));
    }

    void aServoReachesWhatTheBatteryHas() {
        SensorWorld w(spinner("Capacity=1 Voltage=6"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/servo", 1);
        command(w, "r/motor/targetRate", 200); // 120 at 6 V
        QVERIFY(w.run(3000));
        QVERIFY(isNear(w.value("r/motor/rate"), 120, 1e-3));
        QCOMPARE(w.value("r/motor/saturated"), 1.);
    }

    void anEmptyRobotStops() {
        SensorWorld w(
            spinner("Capacity=0.002 Voltage=12 BaseLoad=40",
                    "LightSensor eye { Body=stand UpdatePeriod=0.1 }\nServo servo { Joint=shaft MaxTorque=1 MaxSpeed=10 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 12);
        QVERIFY(w.run(500));
        QVERIFY(w.value("r/motor/rate") > 50);
        QVERIFY(w.run(7000)); // 7.2 C of 12 V at 40 W and more: 2 s
        QCOMPARE(w.value("r/battery/level"), 0.);
        QVERIFY(std::abs(w.value("r/motor/rate")) < 0.01);
        QVERIFY(std::abs(w.value("r/motor/terminalVoltage")) < 1e-9);
        const double last = w.value("r/eye/time");
        command(w, "r/servo/target", 1);
        command(w, "r/motor/servo", 1);
        command(w, "r/motor/targetRate", 50);
        QVERIFY(w.run(500));
        QCOMPARE(w.value("r/eye/time"), last);
        QVERIFY(std::abs(w.value("r/servo/position")) < 1e-9);
        QVERIFY(std::abs(w.value("r/motor/rate")) < 0.01);
    }

    void itsRadioFallsSilent() {
        const std::string text =
            spinner("Capacity=0.001 Voltage=12 BaseLoad=43.2", "Transceiver radio { Body=stand ReceiveCurrent=0.02 }");
        SensorWorld w(
            text +
            "RobotConfig Other { Body body { Pos=0,0,2 Sphere ball { Radius=0.1 Mass=1 } } Transceiver radio { Body=body } }\n"
            "Robot other { Config=Other Pos=1,0,0 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        Medium& medium = *w.world().medium();
        const RadioId own = *medium.find("r/radio"), other = *medium.find("other/radio");
        const std::uint8_t bytes[] = {1, 2, 3};
        const auto exchange = [&](RadioId from, RadioId to) {
            RadioPacket packet;
            return medium.send(from, bytes, medium.radio(to).address, 0) && w.run(20) && medium.receive(to, packet);
        };
        QVERIFY(exchange(own, other) && exchange(other, own));
        QVERIFY(w.run(600)); // 3.6 C of 12 V at 43 W: 1 s
        QCOMPARE(w.value("r/battery/level"), 0.);
        const double energy = w.value("r/radio/energy");
        QVERIFY(!exchange(own, other));
        QVERIFY(!exchange(other, own));
        QVERIFY(energy > 0.04);
        QCOMPARE(w.value("r/radio/energy"), energy);
    }

    void brakingChargesIt() {
        SensorWorld w(spinner("Capacity=1 Voltage=12 StartLevel=0.5", "", "Mass=2"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/voltage", 12);
        QVERIFY(w.run(2000));
        const double before = w.value("r/battery/charge");
        command(w, "r/motor/voltage", 2); // it induces 4.7 V
        QVERIFY(w.run(20));
        QVERIFY(w.value("r/battery/current") < -0.1);
        QVERIFY(w.value("r/battery/charge") > before);
    }

    void aCurveOfOnesOwn() {
        SensorWorld w(spinner("Capacity=0.01 Cells=2 DischargeCurve=0,2,0.5,4,1,6 BaseLoad=10 StartLevel=0.75"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("r/battery/openVoltage"), 10.);
        QCOMPARE(w.value("r/battery/charge"), 27.);
    }

    void isRefused_data() {
        QTest::addColumn<QString>("battery");
        QTest::addColumn<QString>("more");
        QTest::addColumn<QString>("message");
        QTest::newRow("two") << "Capacity=1 Voltage=12"
                             << "Battery other { Capacity=1 Voltage=6 }"
                             << "the robot has another battery";
        QTest::newRow("curve") << "Capacity=1 Cells=2 DischargeCurve=0.5,1,0.4,2"
                               << ""
                               << "with increasing shares";
        QTest::newRow("curve without cells") << "Capacity=1 Voltage=2 DischargeCurve=0,1,1,2"
                                             << ""
                                             << "give Cells";
        QTest::newRow("odd curve") << "Capacity=1 Cells=2 DischargeCurve=0,1,0.4,2,1"
                                   << ""
                                   << "pairs of a share";
        QTest::newRow("neither") << "Capacity=1"
                                 << ""
                                 << "Voltage";
        QTest::newRow("both") << "Capacity=1 Voltage=2 Cells=2"
                              << ""
                              << "Voltage";
        QTest::newRow("no charge") << "Capacity=0 Voltage=2"
                                   << ""
                                   << "Capacity";
    }
    void isRefused() {
        QFETCH(QString, battery);
        QFETCH(QString, more);
        QFETCH(QString, message);
        SensorWorld w(spinner(battery.toStdString(), more.toStdString()));
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains(message), w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(BatteryTest)
#include "battery_test.moc"
