// Grippers: what friction holds, by its closed form; jaws in step; refusals.
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kGravity = 9.81;

/// A gripper on a hoist above a box of 0.5 kg on a table; its jaws press with 10 N.
std::string crane(double friction, const std::string& box = "0,0,0.03", const std::string& more = "",
                  const std::string& tick = "0.005") {
    return "Tick=" + tick + "\nSurface pad { Friction=" + std::to_string(friction) +
           " }\nStaticConfig Table { Box top { Size=1,1,0.1 Pos=0,0,-0.05 Surface=pad } }\nStatic table { Config=Table }\n"
           "RobotConfig Crane {\n  Body palm { Pos=0,0,0.2 Box block { Size=0.2,0.3,0.02 Mass=2 } }\n"
           "  Body left { Pos=0,0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=pad } }\n"
           "  Body right { Pos=0,-0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=pad } }\n"
           "  Slider rail { Parent=world Child=palm Axis=0,0,1 }\n  Slider openLeft { Parent=palm Child=left Axis=0,1,0 }\n"
           "  Slider openRight { Parent=palm Child=right Axis=0,-1,0 }\n"
           "  LinearMotor hoist { Joint=rail MaxForce=400 MaxSpeed=0.05 TimeConstant=0.5 }\n"
           "  Gripper hand { Left=openLeft Right=openRight Force=10 }\n" +
           more + "}\nRobotConfig Load { Body body { Box box { Size=0.04,0.04,0.06 Mass=0.5 Surface=pad } } }\n" +
           "Robot crane { Config=Crane }\nRobot load { Config=Load Pos=" + box + " }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

} // namespace

class GripperTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Two pads that press with F carry m g as long as 2 mu F >= m g.
    void holdsAboveTheBoundAndDropsBelow_data() {
        QTest::addColumn<double>("share"); // of m g / (2 F)
        QTest::addColumn<QString>("tick");
        for (const char* tick : {"0.002", "0.01"})
            for (const double share : {0.5, 0.9, 1.1, 2.}) QTest::addRow("%g, %s s", share, tick) << share << QString(tick);
    }
    void holdsAboveTheBoundAndDropsBelow() {
        QFETCH(double, share);
        QFETCH(QString, tick);
        SensorWorld w(crane(share * 0.5 * kGravity / 20, "0,0,0.03", "", tick.toStdString()));
        QVERIFY2(w.ok(), w.failure().c_str());
        const int second = int(std::lround(1 / tick.toDouble()));
        command(w, "crane/hand/opening", -0.1);
        QVERIFY(w.run(3 * second));
        QVERIFY2(std::abs(w.value("crane/hand/position") + 0.06) < 1e-3,
                 qPrintable(QString::number(w.value("crane/hand/position"))));
        QVERIFY2(std::abs(w.value("crane/hand/force") - 10) < 0.1, qPrintable(QString::number(w.value("crane/hand/force"))));
        QCOMPARE(w.value("crane/hand/holding"), 1.);
        command(w, "crane/hoist/target", 0.1);
        QVERIFY(w.run(5 * second));
        const double lifted = w.value("load/body/pose", 2) - 0.03, hoisted = w.value("crane/hoist/position");
        qInfo("lifted by %.4f of %.4f m", lifted, hoisted);
        if (share < 1) {
            QVERIFY(lifted < 0.05);
            return;
        }
        QVERIFY(hoisted > 0.09 && std::abs(lifted - hoisted) < 2e-3);
        const double before = lifted - hoisted;
        QVERIFY(w.run(10 * second));
        const double after = w.value("load/body/pose", 2) - 0.03 - w.value("crane/hoist/position");
        QVERIFY2(std::abs(after - before) < 1e-3, qPrintable(QString::number(after - before))); // it does not creep
        command(w, "crane/hand/opening", 0.02);
        QVERIFY(w.run(2 * second));
        QVERIFY(w.value("load/body/pose", 2) < 0.05); // nothing is glued
        QCOMPARE(w.value("crane/hand/holding"), 0.);
    }

    void theJawsMoveInStep_data() {
        QTest::addColumn<QString>("box");
        QTest::newRow("nearer to the left jaw") << "0,0.012,0.03";
        QTest::newRow("nearer to the right jaw") << "0,-0.012,0.03";
    }
    /// What one jaw presses more, the other one presses less: together never more than they may.
    void theJawsMoveInStep() {
        QFETCH(QString, box);
        SensorWorld w(crane(0.4, box.toStdString()));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "crane/hand/opening", -0.1);
        double most = 0;
        for (int i = 0; i < 1000; ++i) {
            QVERIFY(w.run(1));
            most = std::max(most, w.value("crane/hand/force"));
        }
        QVERIFY2(most < 10.2, qPrintable(QString::number(most)));
        const double lead = w.value("crane/openLeft/position") - w.value("crane/openRight/position");
        QVERIFY2(std::abs(lead) < 6e-3, qPrintable(QString::number(lead)));
        QCOMPARE(w.value("crane/hand/holding"), 1.);
        QVERIFY(std::abs(w.value("load/body/pose", 1)) < 4e-3); // it has moved the box to its middle
    }

    void opensAndClosesToItsTarget() {
        SensorWorld w(crane(0.4, "0.4,0,0.03"));
        QVERIFY2(w.ok(), w.failure().c_str());
        for (const double opening : {0.03, -0.05, 0.}) {
            command(w, "crane/hand/opening", opening);
            QVERIFY(w.run(600));
            QVERIFY2(std::abs(w.value("crane/hand/position") - opening) < 1e-4,
                     qPrintable(QString::number(w.value("crane/hand/position"))));
            QCOMPARE(w.value("crane/hand/holding"), 0.);
        }
    }

    void drawsFromTheBattery() {
        SensorWorld w(crane(0.4, "0,0,0.03", "Battery battery { Capacity=1 Voltage=6 }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "crane/hand/opening", -0.1);
        QVERIFY(w.run(1000));
        const double hoist = w.value("crane/hoist/force");
        const double watts = 2 * 10 * 0.05 + hoist * hoist * 0.05 / 400; // at rest each jaw takes Force x MaxSpeed
        const double drawn = w.value("crane/battery/voltage") * w.value("crane/battery/current");
        QVERIFY2(std::abs(drawn - watts) < 0.01 * watts, qPrintable(QString("%1, not %2").arg(drawn).arg(watts)));
    }

    void twoSlidersAreNeeded() {
        std::string text = crane(0.4);
        text.replace(text.find("Right=openRight"), 15, "Right=openLeft");
        SensorWorld w(text);
        QVERIFY(!w.ok());
        QVERIFY2(w.failure().find("the same slider") != std::string::npos, w.failure().c_str());
    }
};

QTEST_GUILESS_MAIN(GripperTest)
#include "gripper_test.moc"
