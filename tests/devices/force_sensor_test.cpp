// Forces and torques across joints, as sensors read them: against closed forms.
#include "sensor_world.h"

#include <numbers>

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kGravity = 9.81;

/// A load of 1.5 kg on a pan of 0.2 kg, which is on a fixed stand by this joint.
std::string scale(const std::string& joint, const std::string& sensor, const std::string& more = "") {
    return "Tick=0.005 Seed=3\nRobotConfig Scale {\n  Body stand { Box foot { Size=0.1,0.1,0.1 Pos=0,0,-1 Mass=5 } }\n"
           "  Body pan { Box plate { Size=0.1,0.1,0.02 Mass=0.2 } Box load { Size=0.05,0.05,0.05 Pos=0.3,0.1,0.2 Mass=1.5 } }\n"
           "  Fixed hold { Parent=world Child=stand }\n  " +
           joint + "\n  ForceSensor cell { " + sensor + " }\n" + more + "}\nRobot r { Config=Scale Pos=0,0,3 }\n";
}

const Vec3 kWeight(0, 0, 1.7 * kGravity), kMoment =
                                              Vec3(0.3, 0.1, 0.2).cross(Vec3(0, 0, 1.5 * kGravity)); // of the parent on the child

bool isNear(const Vec3& value, const Vec3& expected, double within) {
    if ((value - expected).norm() <= within) return true;
    qWarning("%.6g %.6g %.6g, not %.6g %.6g %.6g", value.x(), value.y(), value.z(), expected.x(), expected.y(), expected.z());
    return false;
}

} // namespace

class ForceSensorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void carriesAWeightInItsOwnFrame_data() {
        QTest::addColumn<QString>("body");
        QTest::addColumn<Vec3>("place");
        QTest::addColumn<Vec3>("hpr"); // degrees
        QTest::newRow("at the joint") << "stand" << Vec3(0, 0, 0) << Vec3(0, 0, 0);
        QTest::newRow("another place") << "pan" << Vec3(0.1, 0.2, -0.1) << Vec3(0, 0, 0);
        QTest::newRow("turned") << "pan" << Vec3(0.3, 0, 0.1) << Vec3(30, 50, -70);
    }
    void carriesAWeightInItsOwnFrame() {
        QFETCH(QString, body);
        QFETCH(Vec3, place);
        QFETCH(Vec3, hpr);
        char pose[200];
        std::snprintf(pose, sizeof pose, " Pos=%g,%g,%g HPR=%g,%g,%g", place.x(), place.y(), place.z(), hpr.x(), hpr.y(),
                      hpr.z());
        SensorWorld w(scale("Fixed wrist { Parent=stand Child=pan }", "Joint=wrist Body=" + body.toStdString() + pose));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("r/cell/time"), -1.);
        QVERIFY(w.run(200));
        const Quat turned = rotationFromHpr(hpr * std::numbers::pi / 180).conjugate();
        QVERIFY(isNear(w.vector("r/cell/force"), turned * kWeight, 1e-3 * kWeight.norm()));
        QVERIFY(isNear(w.vector("r/cell/torque"), turned * Vec3(kMoment - place.cross(kWeight)), 1e-3 * kMoment.norm()));
        QVERIFY(isNear(w.vector("r/cell/trueTorque"), w.vector("r/cell/torque"), 0));
        QVERIFY(std::abs(w.value("r/cell/time") - 1) < 1e-9);
    }

    /// Raised at constant speed, it carries its weight by the motor along the slider, and by the rail across it; the moment is about the
    /// sensor on the stand, to which the pan has moved.
    void includesTheMotorOfItsJoint() {
        SensorWorld w(scale("Slider rail { Parent=stand Child=pan Axis=0.6,0,0.8 }", "Joint=rail Body=stand",
                            "  LinearMotor lift { Joint=rail MaxForce=100 MaxSpeed=1 Mode=speed }\n"));
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/lift/target")->offset] = 0.2;
        QVERIFY(w.run(400));
        const double way = w.value("r/rail/position") - 0.005 * 0.2; // before the tick
        QVERIFY(way > 0.3);
        QVERIFY(isNear(w.vector("r/cell/force"), kWeight, 1e-3 * kWeight.norm()));
        QVERIFY(isNear(w.vector("r/cell/torque"), kMoment + (way * Vec3(0.6, 0, 0.8)).cross(kWeight), 2e-3 * kMoment.norm()));
    }

    /// A hinge carries no moment about its axis; the rest is as of a rigid joint, wherever its anchor is.
    void aHingeCarriesAllButItsOwnAxis() {
        SensorWorld w(scale("Hinge wrist { Parent=stand Child=pan Axis=0,0,1 Anchor=0.2,-0.1,0.05 }",
                            "Joint=wrist Body=stand Pos=0.1,0.2,-0.3"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(200));
        QVERIFY(isNear(w.vector("r/cell/force"), kWeight, 1e-3 * kWeight.norm()));
        QVERIFY(isNear(w.vector("r/cell/torque"), kMoment - Vec3(0.1, 0.2, -0.3).cross(kWeight), 1e-3 * kMoment.norm()));
    }

    void turnsWithItsBody_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.01, 0.03})
            for (const double rate : {3., -9.}) QTest::addRow("%g rad/s, %g ms", rate, 1e3 * tick) << rate << tick;
    }
    /// An arm that turns steadily is pulled inwards alone, and nothing turns it about the vertical.
    void turnsWithItsBody() {
        QFETCH(double, rate);
        QFETCH(double, tick);
        SensorWorld w(
            "Tick=" + std::to_string(tick) +
            "\nRobotConfig C { Body hub { Cylinder c { Radius=0.1 Length=0.1 Mass=1 } } Body arm { Pos=0.3,0,0 Box c { "
            "Size=0.5,0.04,0.04 Mass=0.6 } }\n  Hinge ax { Parent=world Child=hub Axis=0,0,1 } Fixed f { Parent=hub Child=arm }\n"
            "  ForceSensor s { Joint=f Body=hub } Servo m { Joint=ax Mode=speed MaxTorque=100 MaxSpeed=100 } }\n"
            "Robot r { Config=C Pos=0,0,2 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/m/target")->offset] = rate;
        QVERIFY(w.run(static_cast<int>(std::lround(2 / tick))));
        const double half = 0.5 * tick * rate, weight = 0.6 * kGravity;
        const double inwards = 0.6 * 0.3 * rate * rate * std::pow(std::sin(half) / half, 2); // from chord to chord
        QVERIFY(isNear(w.vector("r/s/trueForce"), {-inwards, 0, weight}, 0.001 * inwards));
        QVERIFY(isNear(w.vector("r/s/trueTorque"), {0, -0.3 * weight, 0}, 0.002 * inwards));
    }

    void aPendulumPullsAtItsPin_data() {
        QTest::addColumn<QString>("joint");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.005, 0.02})
            for (const char* joint : {"Hinge p { Parent=world Child=bob Axis=0,1,0 }", "Ball p { Parent=world Child=bob }"})
                QTest::addRow("%.5s, %g ms", joint, 1e3 * tick) << joint << tick;
    }
    /// Released level, a ball on a rod without mass. In the bob's axes, x outwards along the rod; the mean of a tick, against its start.
    void aPendulumPullsAtItsPin() {
        QFETCH(QString, joint);
        QFETCH(double, tick);
        const auto text = [&](const std::string& pin) {
            return "Tick=" + std::to_string(tick) +
                   "\nRobotConfig P { Body bob { Sphere b { Radius=0.06 Pos=0.35,0,0 Mass=1.7 } } " + pin +
                   " ForceSensor cell { Joint=p Body=bob } }\nRobot r { Config=P Pos=0,0,3 }\n";
        };
        SensorWorld w(text(joint.toStdString())), other(text("Hinge p { Parent=world Child=bob Axis=0,1,0 }"));
        QVERIFY2(w.ok() && other.ok(), w.failure().c_str());
        const double m = 1.7, length = 0.35, inertia = m * (length * length + 0.4 * 0.06 * 0.06);
        double angle = 0;
        for (int i = 0; i < static_cast<int>(1.3 / tick); ++i) {
            QVERIFY(w.run() && other.run());
            const double rate2 = std::max(0.0, 2 * m * kGravity * length * std::sin(angle) / inertia);
            const Vec3 expected(-m * rate2 * length - m * kGravity * std::sin(angle), 0,
                                m * kGravity * std::cos(angle) * (1 - m * length * length / inertia));
            if (i > 1)
                QVERIFY(isNear(w.vector("r/cell/trueForce"), expected,
                               (0.001 + 1.6 * tick * std::sqrt(rate2) + 0.5 * tick * tick * kGravity / length) * m * kGravity));
            if (i > 1) QVERIFY(isNear(w.vector("r/cell/trueTorque"), Vec3::Zero(), 1e-3));
            angle = other.value("r/p/position");
        }
    }

    /// The moment of a tool whose middle is off the joint, which carries it round: that of its weight alone.
    void aTurningToolHasAMomentOfItsWeightAlone() {
        for (const double tick : {0.005, 0.01, 0.03}) {
            SensorWorld w(
                "Tick=" + std::to_string(tick) +
                "\nRobotConfig C { Body base { Box b { Size=0.05,0.05,0.05 Mass=50 } } Fixed f { Parent=world Child=base }\n"
                "  Body arm { Box b { Size=0.3,0.04,0.06 Pos=0.15,0,0 Mass=1.3 } } Hinge h { Parent=base Child=arm Axis=0,0,1 }\n"
                "  Body tool { Pos=0.3,0,0 Box b { Size=0.13,0.13,0.05 Pos=0.04,0,0 Mass=0.77 } } Fixed wrist { Parent=arm "
                "Child=tool }\n"
                "  Servo m { Joint=h Mode=speed MaxTorque=500 MaxSpeed=60 } ForceSensor s { Joint=wrist Body=tool } }\n"
                "Robot r { Config=C Pos=0,0,2 }\n");
            QVERIFY2(w.ok(), w.failure().c_str());
            w.world().block().slots()[w.world().layout().find("r/m/target")->offset] = 6.3;
            QVERIFY(w.run(static_cast<int>(std::lround(2 / tick))));
            const double inwards = 0.77 * 0.34 * 6.3 * 6.3, weight = 0.77 * kGravity;
            QVERIFY(isNear(w.vector("r/s/trueForce"), {-inwards, 0, weight}, 0.006 * inwards));
            QVERIFY(isNear(w.vector("r/s/trueTorque"), {0, -0.04 * weight, 0}, 1e-4));
        }
    }

    /// The damper's force is part of it, as is the spring's: together they are what accelerates the load, and holds it.
    void ofADampedSuspension() {
        for (const double tick : {0.001, 0.01})
            for (const double damping : {0., 20., 80.}) {
                const double m = 2, k = 800;
                SensorWorld w(
                    "Tick=" + std::to_string(tick) +
                    "\nRobotConfig C { Body base { Box b { Size=0.1,0.1,0.1 Mass=3 Collide=false } } Fixed f { Parent=world "
                    "Child=base }\n Body b { Pos=0.3,0,0 Sphere q { Radius=0.05 Mass=2 Collide=false } }\n"
                    " Suspension j { Parent=base Child=b Axis=0,0,1 Axis2=0,1,0 Stiffness=" +
                    std::to_string(k) + " Damping=" + std::to_string(damping) +
                    " }\n ForceSensor s { Joint=j Body=b } }\nRobot r { Config=C Pos=0,0,2 }\n");
                QVERIFY2(w.ok(), w.failure().c_str());
                double before = 0, off = 0, most = 0;
                for (double t = 0; t < 0.5; t += tick) {
                    QVERIFY(w.run());
                    const double now = w.vector("r/b/velocity").z(), force = m * ((now - before) / tick + kGravity);
                    if (t > 0) off = std::max(off, std::abs(w.vector("r/s/trueForce").z() - force));
                    most = std::max(most, std::abs(force));
                    before = now;
                }
                QVERIFY2(off < 1e-6 * most, qPrintable(QStringLiteral("%1 of %2 N").arg(off).arg(most)));
            }
    }

    void errsAsItsFieldsSay() {
        SensorWorld w(scale("Fixed wrist { Parent=stand Child=pan }",
                            "Joint=wrist Body=stand Noise=0.5,0.02 ForceBias=1,-2,3 TorqueBias=0.1,0.2,0.3 Resolution=0.01,0 "
                            "Range=0,1"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(100));
        std::vector<double> up, across;
        for (int i = 0; i < 20000; ++i) {
            QVERIFY(w.run());
            up.push_back(w.value("r/cell/force", 2) - w.value("r/cell/trueForce", 2));
            across.push_back(w.value("r/cell/torque", 2) - w.value("r/cell/trueTorque", 2));
            QVERIFY(std::abs(w.value("r/cell/torque", 1)) <= 1); // about -4.4 without its range
            QVERIFY(std::abs(std::remainder(w.value("r/cell/force", 0), 0.01)) < 1e-12);
        }
        const double n = 20000;
        for (const auto& [samples, mean, deviation] : {std::tuple(up, 3.0, 0.5), std::tuple(across, 0.3, 0.02)}) {
            const Moments m = momentsOf(samples);
            QVERIFY(std::abs(m.mean - mean) < 4 * deviation / std::sqrt(n));
            QVERIFY(std::abs(m.deviation / deviation - 1) < 4 / std::sqrt(2 * n));
            QVERIFY(std::abs(correlationOf(samples, 1)) < 4 / std::sqrt(n));
        }
    }

    /// The largest reading is the largest multiple of Resolution within Range. The torque is 1.47, -4.41, 0 Nm.
    void atItsRangeItReadsAMultipleOfItsResolution() {
        SensorWorld w(scale("Fixed wrist { Parent=stand Child=pan }",
                            "Joint=wrist Body=stand ForceBias=60,0,-100 Resolution=7,1.5 Range=50,4"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(200));
        QVERIFY(isNear(w.vector("r/cell/force"), {49, 0, -49}, 1e-12));
        QVERIFY(isNear(w.vector("r/cell/torque"), {1.5, -3, 0}, 1e-12));
    }

    void aJointThatIsNotThereIsAnErrorOfTheText() {
        SensorWorld w(scale("Fixed wrist { Parent=stand Child=pan }", "Joint=wirst Body=stand"));
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains("Joint names wirst"), w.failure().c_str());
    }
};

QTEST_APPLESS_MAIN(ForceSensorTest)
#include "force_sensor_test.moc"
