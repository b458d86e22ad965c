// Charging against closed forms: constant current, then constant voltage; contact, sharing, energy balance.
#include "devices/discharge_curve.h"
#include "sensor_world.h"

#include <numbers>

using namespace trundle;
using namespace trundle::test;

namespace {

/// A station whose pad the robots `r`, `s` ... touch, and robots with these batteries, each 0.5 m to the side of the last.
std::string docked(const std::vector<std::string>& batteries, const std::string& charger, const std::string& more = "") {
    std::string text = "Tick=0.01\nStaticConfig Floor { Plane floor {} }\nStatic floor { Config=Floor }\n"
                       "RobotConfig Station { Body dock { Box pad { Size=4,4,0.1 Pos=0,0,0.05 Mass=9 } }\n"
                       "  Fixed hold { Parent=world Child=dock }\n  Charger charger { Geom=dock.pad " +
                       charger + " } }\nRobot station { Config=Station }\n";
    for (std::size_t i = 0; i < batteries.size(); ++i) {
        const std::string name(1, char('r' + i)), place = std::to_string(0.5 * double(i));
        text += "RobotConfig Of" + name +
                " { Body base { Box hull { Size=0.2,0.2,0.1 Mass=1 } }\n  Battery battery { Contact=base.hull " + batteries[i] +
                " }\n" + more + "}\nRobot " + name + " { Config=Of" + name + " Pos=" + place + ",0,0.15 }\n";
    }
    return text;
}

bool isNear(double value, double expected, double share) {
    if (std::abs(value - expected) <= share * std::abs(expected)) return true;
    qWarning("%.9g, not %.9g", value, expected);
    return false;
}

} // namespace

class ChargerTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// While the current is constant the charge grows by it; then V = open + R I is the charger's voltage, and the current falls as
    /// exp(-t / (R C)) with the slope of the battery's voltage, as a capacitor of C = Capacity / (V(1) - V(0)) charges.
    void constantCurrentThenConstantVoltage() {
        SensorWorld w(docked({"Capacity=0.01 Cells=1 DischargeCurve=0,3,1,4 InternalResistance=0.5 StartLevel=0.2"},
                             "Voltage=4 MaxCurrent=0.6"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(20)); // it comes to rest on the pad
        const double first = w.value("r/battery/charge");
        QVERIFY(isNear(w.value("r/battery/chargeCurrent"), 0.6, 1e-9));
        QVERIFY(w.run(1000));
        QVERIFY(isNear(w.value("r/battery/charge") - first, 6, 1e-9));
        QVERIFY(isNear(w.value("r/battery/current"), -0.6, 1e-9));
        const double level = w.value("r/battery/level");
        QVERIFY(isNear(w.value("r/battery/voltage"), 3 + level + 0.5 * 0.6, 1e-3));
        QVERIFY(isNear(w.value("station/charger/current"), 0.6, 1e-9));
        QVERIFY(isNear(w.value("station/charger/voltage"), w.value("r/battery/voltage"), 1e-3));
        while (w.value("r/battery/level") < 0.7 && w.time() < 100) QVERIFY(w.run()); // 3.7 V + 0.3 V
        QVERIFY(w.run(10));
        const double start = w.time(), current = w.value("r/battery/chargeCurrent"), seconds = 0.5 * 36 / 1;
        for (int i = 0; i < 8; ++i) {
            QVERIFY(w.run(500));
            QVERIFY(isNear(w.value("r/battery/chargeCurrent"), current * std::exp(-(w.time() - start) / seconds), 2e-3));
            QVERIFY(isNear(w.value("r/battery/voltage"), 4, 1e-3));
        }
        QVERIFY(w.run(30000));
        QVERIFY(w.value("r/battery/level") > 0.9999 && w.value("r/battery/level") <= 1);
    }

    /// What the charger gives is what the devices draw, the resistance heats, and the cells store.
    void energyIsBalanced() {
        SensorWorld w(docked({"Capacity=0.02 Cells=2 Chemistry=LiIon InternalResistance=0.2 StartLevel=0.05 BaseLoad=1.5"},
                             "Voltage=8.2 MaxCurrent=1"));
        QVERIFY2(w.ok(), w.failure().c_str());
        double given = 0, used = 0, heat = 0, stored = 0;
        for (int i = 0; i < 15000; ++i) {
            QVERIFY(w.run());
            const double amperes = w.value("r/battery/current");
            used += 0.01 * 1.5;
            heat += 0.01 * amperes * amperes * 0.2;
            stored -= 0.01 * amperes * w.value("r/battery/openVoltage");
        }
        given = w.value("station/charger/energy");
        qInfo("%.2f J given: %.2f used, %.2f heat, %.2f stored; level %.3f", given, used, heat, stored,
              w.value("r/battery/level"));
        QVERIFY(isNear(used + heat + stored, given, 0.01));
        QVERIFY(stored > 200 && used > 200 && heat > 3 && w.value("r/battery/level") > 0.9);
    }

    /// A full battery stays full, and the charger carries the devices.
    void aFullBatteryTakesWhatDevicesDraw() {
        SensorWorld w(docked({"Capacity=0.01 Voltage=6 BaseLoad=3"}, "Voltage=6.2 MaxCurrent=2"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(500));
        QVERIFY(isNear(w.value("r/battery/level"), 1, 1e-6));
        QVERIFY(isNear(w.value("station/charger/current"), 0.5, 1e-6));
        QVERIFY(std::abs(w.value("r/battery/current")) < 1e-9);
    }

    void anEmptyRobotWorksAgain() {
        SensorWorld w(docked({"Capacity=0.001 Voltage=6 BaseLoad=3 StartLevel=0"}, "Voltage=7 MaxCurrent=1",
                             "  LightSensor eye { Body=base }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.value("r/battery/voltage") == 0 && w.value("r/eye/time") < 0);
        QVERIFY(w.run(200));
        QVERIFY(w.value("r/battery/voltage") > 5 && w.value("r/eye/time") > 1);
        QVERIFY(w.value("r/battery/level") > 0);
    }

    /// It slides on while it has no power. Its first readings then have nothing of the time before.
    void theFirstReadingsOfARobotThatWasEmpty() {
        SensorWorld w(docked({"Capacity=0.001 Voltage=6 BaseLoad=3 StartLevel=0.02"}, "Voltage=7 MaxCurrent=0",
                             "  Imu imu { Body=base }\n  Lidar scan { Body=base Beams=10 FieldOfView=60 MaxRange=20 MinRange=0 "
                             "UpdatePeriod=0.1 SweepTime=0.1 }\n") +
                      "StaticConfig Wall { Plane wall { HPR=0,-90,0 Pos=3,0,0 } }\nStatic wall { Config=Wall }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(10));
        QVERIFY(w.world().push("r/base", {200, 0, 0}, w.pose("r/base").position).ok());
        while (w.value("r/battery/charge") > 0 && w.time() < 1) QVERIFY(w.run());
        QVERIFY(std::abs(w.time() - 0.15) < 1e-9 && w.value("r/base/velocity") > 1); // in the middle of a sweep
        const double last = w.value("r/imu/time"), x = w.pose("r/base").position.x();
        QVERIFY(w.run(200));
        QVERIFY(w.value("r/imu/time") == last && std::abs(w.value("r/base/velocity")) < 1e-6);
        QVERIFY(w.world().setProperty("station/charger", "MaxCurrent", {PropertyType::Number, {1}, {}}).ok());
        while (w.value("r/imu/time") == last && w.time() < 3) QVERIFY(w.run());
        QVERIFY(w.value("r/imu/time") > 2);
        QVERIFY((w.vector("r/imu/acceleration") - Vec3(0, 0, 9.81)).norm() < 1e-3);
        QCOMPARE(w.value("r/scan/time"), w.value("r/imu/time"));
        const Pose eye = w.pose("r/base");
        QVERIFY(eye.position.x() > x + 0.05);
        for (std::size_t i = 0; i < 10; ++i) {
            const double bearing = (-30 + 60 * double(i) / 9) * std::numbers::pi / 180;
            const Vec3 along = eye.rotation * Vec3(std::cos(bearing), std::sin(bearing), 0);
            QVERIFY(isNear(w.value("r/scan/ranges", i), (3 - eye.position.x()) / along.x(), 1e-6));
        }
    }

    void allThatTouchItShareItsCurrent() {
        const std::string cell = "Capacity=0.1 Voltage=6 InternalResistance=0.1 StartLevel=0.1";
        SensorWorld w(docked({cell, cell, cell}, "Voltage=9 MaxCurrent=1.5"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(100));
        for (const char* each : {"r/battery/chargeCurrent", "s/battery/chargeCurrent", "t/battery/chargeCurrent"})
            QVERIFY(isNear(w.value(each), 0.5, 1e-9));
        QVERIFY(isNear(w.value("station/charger/current"), 1.5, 1e-9));
        QCOMPARE(w.value("station/charger/connected"), 1.);
    }

    /// Only where its Contact touches the charger's Geom.
    void withoutContactNothingFlows() {
        for (const char* wrong : {"", "Contact=base.top"}) {
            std::string text = docked({"Capacity=0.01 Voltage=6 StartLevel=0.5"}, "Voltage=7 MaxCurrent=1");
            text.replace(text.find("Contact=base.hull"), 17, wrong);
            text.replace(text.find("Body base { "), 12, "Body base { Box top { Size=0.1,0.1,0.1 Pos=0,0,0.2 Mass=0.1 } ");
            SensorWorld w(text);
            QVERIFY2(w.ok(), w.failure().c_str());
            QVERIFY(w.run(100));
            QVERIFY(w.value("r/battery/charge") == 18 && w.value("station/charger/connected") == 0);
            QVERIFY(w.value("station/charger/energy") == 0);
        }
        SensorWorld low(docked({"Capacity=0.01 Voltage=6 InternalResistance=1 StartLevel=0.5"}, "Voltage=5 MaxCurrent=1"));
        QVERIFY2(low.ok(), low.failure().c_str());
        QVERIFY(low.run(100));
        QVERIFY(low.value("r/battery/charge") == 18); // its voltage is too low
    }

    /// With an InternalResistance or without: current does not flow into a higher voltage.
    void aChargerBelowTheBatteryGivesNothing() {
        for (const char* more : {"", " InternalResistance=0.5"}) {
            const std::string battery = std::string("Capacity=0.01 Voltage=12 StartLevel=0.5") + more;
            for (const char* volts : {"5", "11.9"}) {
                SensorWorld w(docked({battery}, std::string("Voltage=") + volts + " MaxCurrent=1"));
                QVERIFY2(w.ok(), w.failure().c_str());
                QVERIFY(w.run(100));
                QCOMPARE(w.value("r/battery/charge"), 18.);
                QVERIFY(w.value("r/battery/chargeCurrent") == 0 && w.value("station/charger/energy") == 0);
                QCOMPARE(w.value("station/charger/connected"), 0.);
            }
        }
        SensorWorld equal(docked({"Capacity=0.01 Voltage=12 StartLevel=0.5"}, "Voltage=12 MaxCurrent=1"));
        QVERIFY2(equal.ok(), equal.failure().c_str());
        QVERIFY(equal.run(100));
        QVERIFY(isNear(equal.value("r/battery/chargeCurrent"), 1, 1e-9));
    }

    /// The station is there before or after the robot in the text: the same numbers.
    void theOrderInTheTextDoesNotMatter() {
        const std::string text = docked({"Capacity=0.01 Cells=2 Chemistry=NiMH InternalResistance=0.2 StartLevel=0.3 BaseLoad=1"},
                                        "Voltage=3 MaxCurrent=1");
        const std::size_t from = text.find("RobotConfig Station"), to = text.find("RobotConfig Ofr");
        SensorWorld first(text), last(text.substr(0, from) + text.substr(to) + text.substr(from, to - from));
        QVERIFY2(first.ok() && last.ok(), (first.failure() + last.failure()).c_str());
        QVERIFY(first.run(1000) && last.run(1000));
        QCOMPARE(first.value("r/battery/charge"), last.value("r/battery/charge"));
        QCOMPARE(first.value("station/charger/energy"), last.value("station/charger/energy"));
        QCOMPARE(first.world().stateHash(), last.world().stateHash());
    }
};

QTEST_GUILESS_MAIN(ChargerTest)
#include "charger_test.moc"
