// Servos and linear motors against closed forms.
#include "sensor_world.h"

#include "devices/builtin.h"
#include "run/logs/signal_columns.h"
#include "world/signal_plan.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kGravity = 9.81;

/// An arm of 1 kg, 0.4 m from its level hinge, that points along x.
std::string arm(const std::string& servo, double tick = 0.005, const std::string& gravity = "0,0,-9.81") {
    return "Tick=" + std::to_string(tick) + " Gravity=" + gravity +
           "\nRobotConfig Arm {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
           "  Body arm { Sphere load { Radius=0.05 Pos=0.4,0,0 Mass=1 } }\n  Fixed hold { Parent=world Child=stand }\n"
           "  Hinge axle { Parent=stand Child=arm Axis=0,-1,0 }\n  Servo servo { Joint=axle " +
           servo + " }\n}\nRobot r { Config=Arm Pos=0,0,3 }\n";
}

/// A load of 2 kg on an upright slider.
std::string lift(const std::string& motor, double tick = 0.005) {
    return "Tick=" + std::to_string(tick) +
           "\nRobotConfig Lift {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
           "  Body load { Box b { Size=0.1,0.1,0.1 Mass=2 } }\n  Fixed hold { Parent=world Child=stand }\n"
           "  Slider rail { Parent=stand Child=load Axis=0,0,1 }\n  LinearMotor motor { Joint=rail " +
           motor + " }\n}\nRobot r { Config=Lift Pos=0,0,3 }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

} // namespace

class ServoTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// It needs m g L at level: with more torque it holds, with less it falls.
    void holdsWhatItsTorqueCarries_data() {
        QTest::addColumn<double>("share"); // of m g L
        QTest::newRow("1.5 times") << 1.5;
        QTest::newRow("1.02 times") << 1.02;
        QTest::newRow("0.98 times") << 0.98;
        QTest::newRow("half") << 0.5;
    }
    void holdsWhatItsTorqueCarries() {
        QFETCH(double, share);
        const double needed = 1 * kGravity * 0.4;
        SensorWorld w(arm("MaxSpeed=5 MaxTorque=" + std::to_string(share * needed)));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(400));
        const double at = w.value("r/servo/position");
        if (share > 1) {
            QVERIFY2(std::abs(at) < 1e-3, qPrintable(QString::number(at)));
            QVERIFY(std::abs(w.value("r/servo/torque") - needed) < 1e-3 * needed);
            QCOMPARE(w.value("r/servo/saturated"), 0.);
        } else {
            QVERIFY2(at < -0.05, qPrintable(QString::number(at)));
        }
    }

    void unitsAreThoseOfJointAndMode_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("signal");
        QTest::addColumn<std::string>("unit");
        QTest::addColumn<std::string>("column");
        const auto row = [](const char* name, const std::string& text, std::string signal, std::string unit, std::string column) {
            QTest::newRow(name) << text << std::move(signal) << std::move(unit) << std::move(column);
        };
        const std::string slides = "MaxForce=60 MaxSpeed=1", turns = "MaxTorque=5 MaxSpeed=5";
        const std::string counted = lift(slides + " }\n  Encoder e { Joint=rail Pitch=1mm CountsPerRevolution=1");
        row("a position of a slider", lift(slides), "r/motor/target", "m", "m");
        row("a speed of a slider", lift(slides + " Mode=speed"), "r/motor/target", "m/s", "m/s");
        row("an angle", arm(turns), "r/servo/target", "rad", "deg");
        row("a rate", arm(turns + " Mode=speed"), "r/servo/target", "rad/s", "rad/s");
        row("the way of an encoder", counted, "r/e/angle", "m", "m");
        row("the speed of an encoder", counted, "r/e/rate", "m/s", "m/s");
        row("a signal without a unit", counted, "r/e/count", "", "");
    }
    /// In the world, in its logs, and in the plan that is made of a text without a world.
    void unitsAreThoseOfJointAndMode() {
        QFETCH(std::string, text);
        QFETCH(std::string, signal);
        QFETCH(std::string, unit);
        QFETCH(std::string, column);
        SensorWorld w(text);
        QVERIFY2(w.ok(), w.failure().c_str());
        const SignalLayout& layout = w.world().layout();
        const auto entry = layout.find(signal);
        QVERIFY(entry);
        QCOMPARE(entry->unit, unit);
        QCOMPARE(SignalColumns(*entry).names(), std::vector<std::string>{signal + (column.empty() ? "" : " [" + column + "]")});
        Registry registry;
        QVERIFY(addDeviceKinds(registry).ok());
        QCOMPARE(plannedLayout(w.world().experiment(), registry).hash(), layout.hash());
    }

    void goesToItsTarget_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("target"); // rad
        QTest::addColumn<double>("timeConstant");
        for (const double tick : {0.001, 0.01})
            for (const double target : {0.7, -2.0, 9.0})
                for (const double constant : {0., 0.05, 0.3})
                    QTest::addRow("%g s, %g rad, %g s", tick, target, constant) << tick << target << constant;
    }
    /// Strong enough, it moves at MaxSpeed, and then as an exponential of its TimeConstant, never beyond.
    void goesToItsTarget() {
        QFETCH(double, tick);
        QFETCH(double, target);
        QFETCH(double, timeConstant);
        SensorWorld w(arm("MaxSpeed=4 MaxTorque=2000 TimeConstant=" + std::to_string(timeConstant), tick, "0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/servo/target", target);
        double expected = 0; // the same law, tick by tick
        for (int i = 0; i < int(5 / tick); ++i) {
            expected += tick * std::clamp((target - expected) / std::max(timeConstant, tick), -4., 4.);
            QVERIFY(w.run());
            QVERIFY2(std::abs(w.value("r/servo/position") - expected) < 0.02 * std::abs(target),
                     qPrintable(QString("%1: %2, not %3").arg(i).arg(w.value("r/servo/position")).arg(expected)));
            QVERIFY(w.value("r/servo/position") / target < 1 + 1e-3);
        }
        QVERIFY(std::abs(w.value("r/servo/position") - target) < 1e-3);
    }

    /// Its torque falls along a line from MaxTorque at rest to nothing at MaxSpeed: a load of half of MaxForce leaves half the speed.
    void aLoadSlowsItDown_data() {
        QTest::addColumn<double>("share"); // of MaxForce
        QTest::addColumn<double>("sense");
        for (const double share : {0.1, 0.5, 0.9}) QTest::addRow("%g", share) << share << 1.;
    }
    void aLoadSlowsItDown() {
        QFETCH(double, share);
        const double weight = 2 * kGravity;
        SensorWorld w(lift("Mode=speed MaxSpeed=0.5 MaxForce=" + std::to_string(weight / share), 0.002));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/target", 1);
        QVERIFY(w.run(2500));
        const double rate = w.value("r/motor/rate"), expected = 0.5 * (1 - share);
        QVERIFY2(std::abs(rate - expected) < 0.005 * expected, qPrintable(QString("%1, not %2").arg(rate).arg(expected)));
        QVERIFY(std::abs(w.value("r/motor/force") - weight) < 0.005 * weight);
        QCOMPARE(w.value("r/motor/saturated"), 1.);
    }

    void aLinearMotorHoldsAndLifts() {
        SensorWorld w(lift("MaxSpeed=0.5 MaxForce=40"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/motor/target", 0.3);
        QVERIFY(w.run(600));
        QVERIFY2(std::abs(w.value("r/motor/position") - 0.3) < 1e-3, qPrintable(QString::number(w.value("r/motor/position"))));
        QVERIFY(std::abs(w.value("r/motor/force") - 2 * kGravity) < 1e-2);
        SensorWorld weak(lift("MaxSpeed=0.5 MaxForce=19"));
        QVERIFY(weak.ok() && weak.run(400));
        QVERIFY(weak.value("r/motor/position") < -0.01); // 19.6 N are needed
    }

    void aServoKeepsARate() {
        SensorWorld w(arm("Mode=speed MaxSpeed=4 MaxTorque=50", 0.005, "0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/servo/target", -1.5);
        QVERIFY(w.run(400));
        QVERIFY(std::abs(w.value("r/servo/rate") + 1.5) < 1e-6);
        QVERIFY(std::abs(w.value("r/axle/rate") + 1.5) < 1e-6);
        QVERIFY2(std::abs(w.value("r/servo/position") + 3) < 0.05, qPrintable(QString::number(w.value("r/servo/position"))));
        QCOMPARE(w.value("r/servo/saturated"), 0.);
    }

    void whatIsNoNumberCountsAsZero() {
        SensorWorld w(arm("MaxSpeed=4 MaxTorque=50", 0.005, "0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/servo/target", std::nan(""));
        QVERIFY(w.run(50));
        QVERIFY(std::abs(w.value("r/servo/position")) < 1e-9);
    }

    /// A load that is too heavy turns it faster than it runs by itself: it brakes with all of its torque.
    void brakesWhatOverrunsIt() {
        SensorWorld w(
            "Tick=0.002\nRobotConfig Arm { Body base { Box b { Size=0.1,0.1,0.1 Mass=5 } } Body arm { Pos=0.5,0,0 Box b { "
            "Size=0.1,0.1,0.1 Mass=1 Collide=false } }\n  Fixed f { Parent=world Child=base } Hinge h { Parent=base Child=arm "
            "Axis=0,1,0 Anchor=0,0,0 }\n  Servo s { Joint=h MaxTorque=1 MaxSpeed=2 } }\nRobot r { Config=Arm Pos=0,0,2 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        int faster = 0;
        for (int i = 0; i < 200; ++i) {
            QVERIFY(w.run());
            const double rate = w.value("r/h/rate"), torque = w.value("r/s/torque");
            if (rate < 2.2) continue;
            ++faster;
            QVERIFY2(std::abs(torque + 1) < 0.05, qPrintable(QStringLiteral("%1 rad/s, %2 Nm").arg(rate).arg(torque)));
        }
        QVERIFY(faster > 20);
    }
};

QTEST_GUILESS_MAIN(ServoTest)
#include "servo_test.moc"
