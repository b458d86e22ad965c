// IMU, compass and satellite receiver against closed forms, and their errors.
#include "sensor_world.h"

#include <numbers>

#include "devices/imu.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi, kGravity = 9.81;

/// A box that carries the sensor at `place` (m) and `hpr` (degrees).
std::string carried(const std::string& sensor, const std::string& robot, const std::string& settings,
                    const std::string& more = "") {
    return settings + "\n" + more + "\nRobotConfig Probe { Body base { Box hull { Size=0.2,0.3,0.4 Mass=2 } }\n" + sensor +
           " }\nRobot r { Config=Probe " + robot + " }\n";
}

bool isNear(const Vec3& a, const Vec3& b, double tolerance) { return (a - b).norm() <= tolerance; }

QByteArray shown(const Vec3& v) {
    return QString("%1, %2, %3").arg(v.x(), 0, 'g', 12).arg(v.y(), 0, 'g', 12).arg(v.z(), 0, 'g', 12).toUtf8();
}

/// A table of radius 0.5 that a motor turns about the axis of its hinge; the sensor is on it.
std::string turntable(double tick, const std::string& sensor, double height = 1) {
    return "Tick=" + std::to_string(tick) +
           " Seed=2\nRobotConfig Table {\n  Body stand { Box foot { Size=0.2,0.2,0.1 Pos=0,0,-0.2 Mass=5 } }\n" +
           "  Body disc { Cylinder plate { Radius=0.5 Length=0.02 Mass=1 } }\n  Fixed hold { Parent=world Child=stand }\n" +
           "  Hinge axle { Parent=stand Child=disc Axis=0,0,1 }\n" +
           "  RotaryMotor motor { Joint=axle TorqueConstant=0.05 BackEmfConstant=0.05 Resistance=0.5 GearRatio=20 MaxVoltage=24 "
           "}\n" +
           sensor + "\n}\nRobot r { Config=Table Pos=0,0," + std::to_string(height) + " }\n";
}

/// A robot of two wheels with its centre of mass ahead of the axle, on a floor.
std::string circling(const std::string& engine, double tick) {
    const std::string wheel = " Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.2 Surface=grip } }\n",
                      motor = " TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }\n";
    return "Engine=" + engine + " Tick=" + std::to_string(tick) +
           "\nSurface grip { Friction=1 Restitution=0 }\nSurface slick { Friction=0 Restitution=0 }\nRobotConfig Cart {\n"
           "  Body base { Box hull { Size=0.3,0.2,0.1 Pos=0.02,0,0.1 Mass=2 Surface=grip }\n"
           "    Sphere front { Radius=0.02 Pos=0.14,0,0.02 Mass=0.02 Surface=slick }\n"
           "    Sphere back { Radius=0.02 Pos=-0.1,0,0.02 Mass=0.02 Surface=slick } }\n"
           "  Body left { Pos=0,0.13,0.05" +
           wheel + "  Body right { Pos=0,-0.13,0.05" + wheel +
           "  Hinge leftAxle { Parent=base Child=left Axis=0,1,0 }\n  Hinge rightAxle { Parent=base Child=right Axis=0,1,0 }\n"
           "  RotaryMotor leftMotor { Joint=leftAxle" +
           motor + "  RotaryMotor rightMotor { Joint=rightAxle" + motor +
           "  Imu middle { Body=base }\n  Imu away { Body=base Pos=0.3,0.1,0 }\n  Imu rolling { Body=right }\n}\n"
           "StaticConfig F { Plane floor { Surface=grip } }\nStatic floor { Config=F }\nRobot r { Config=Cart }\n";
}

void ticks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.002, 0.01, 0.03}) QTest::addRow("%g s", tick) << tick;
}

} // namespace

class MotionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSensorAtRestFeelsGravity() {
        SensorWorld w(carried("Imu imu { Body=base Pos=0.05,0.02,0.1 HPR=30,20,-50 }", "Pos=0,0,0.2", "Tick=0.01",
                              "StaticConfig F { Plane floor { } }\nStatic floor { Config=F }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(200));
        const Quat turn = w.pose("r/base").rotation * rotationFromHpr(Vec3(30, 20, -50) * kPi / 180);
        const Vec3 expected = turn.conjugate() * Vec3(0, 0, kGravity);
        QVERIFY2(isNear(w.vector("r/imu/acceleration"), expected, 1e-6 * kGravity), shown(w.vector("r/imu/acceleration")));
        QVERIFY(w.vector("r/imu/angularVelocity").norm() < 1e-9);
    }

    void aSensorInFreeFallFeelsNothing_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<bool>("tumbles");
        for (const double tick : {0.001, 0.01, 0.02})
            for (const bool tumbles : {false, true})
                QTest::addRow("%g s%s", tick, tumbles ? ", tumbling" : "") << tick << tumbles;
    }
    /// In its centre of mass also while it turns.
    void aSensorInFreeFallFeelsNothing() {
        QFETCH(double, tick);
        QFETCH(bool, tumbles);
        SensorWorld w(carried("Imu imu { Body=base HPR=12,34,56 }", "Pos=0,0,50 HPR=20,30,40", "Tick=" + std::to_string(tick)));
        QVERIFY2(w.ok(), w.failure().c_str());
        if (tumbles) {
            QVERIFY(w.world().push("r/base", {40, 10, -20}, {0.05, 0.1, 50.15}).ok());
            QVERIFY(w.run());
            QVERIFY(w.vector("r/imu/angularVelocity").norm() > 1e-3);
        }
        for (int i = 0; i < 100; ++i) {
            QVERIFY(w.run());
            QVERIFY2(w.vector("r/imu/acceleration").norm() < 1e-6 * kGravity, shown(w.vector("r/imu/acceleration")));
        }
    }

    void aSensorOnATurntableFeelsItsCentripetalAcceleration_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("voltage");
        for (const double tick : {0.002, 0.01, 0.03})
            for (const double voltage : {1.0, 6.0, -12.0}) QTest::addRow("%g s, %g V", tick, voltage) << tick << voltage;
    }
    void aSensorOnATurntableFeelsItsCentripetalAcceleration() {
        QFETCH(double, tick);
        QFETCH(double, voltage);
        const Vec3 place(0.3, -0.2, 0.05), hpr = Vec3(40, 15, -20) * kPi / 180;
        SensorWorld w(turntable(tick, "Imu imu { Body=disc Pos=0.3,-0.2,0.05 HPR=40,15,-20 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/motor/voltage")->offset] = voltage;
        QVERIFY(w.run(int(6 / tick)));
        const double rate = w.value("r/axle/rate");
        QVERIFY(std::abs(rate) > 0.5);
        const Quat inBody = rotationFromHpr(hpr);
        const Vec3 expected = inBody.conjugate() * Vec3(-rate * rate * place.x(), -rate * rate * place.y(), kGravity);
        QVERIFY2(isNear(w.vector("r/imu/acceleration"), expected, 1e-6 * expected.norm()),
                 shown(w.vector("r/imu/acceleration") - expected));
        QVERIFY(isNear(w.vector("r/imu/angularVelocity"), inBody.conjugate() * Vec3(0, 0, rate), 1e-9));
    }

    void aSensorOnAnArmFeelsItsCentripetalAcceleration_data() { ticks(); }
    /// The centre of mass is 0.3 m off the axis.
    void aSensorOnAnArmFeelsItsCentripetalAcceleration() {
        QFETCH(double, tick);
        SensorWorld w("Tick=" + std::to_string(tick) +
                      "\nRobotConfig Arm {\n  Body arm { Box beam { Size=0.4,0.05,0.05 Pos=0.3,0,0 Mass=1 } }\n"
                      "  Hinge axle { Parent=world Child=arm Axis=0,0,1 }\n"
                      "  Servo servo { Joint=axle MaxTorque=1e4 MaxSpeed=400 TimeConstant=0.1 Mode=speed }\n"
                      "  Imu imu { Body=arm Pos=0.5,0,0 }\n}\nRobot r { Config=Arm Pos=0,0,1 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/servo/target")->offset] = 10;
        QVERIFY(w.run(int(4 / tick)));
        const double rate = w.value("r/axle/rate");
        QVERIFY(std::abs(rate - 10) < 1e-3);
        const Vec3 read = w.vector("r/imu/acceleration");
        QVERIFY2(isNear(read, {-0.5 * rate * rate, 0, kGravity}, 1e-3), shown(read));
    }

    void aSensorOnACircleFeelsItsCentripetalAcceleration_data() {
        QTest::addColumn<QString>("engine");
        QTest::addColumn<double>("tick");
        for (const char* engine : {"general", "wheeled", "planar"})
            for (const double tick : {0.002, 0.01, 0.03}) QTest::addRow("%s, %g s", engine, tick) << engine << tick;
    }
    /// 0.5 m/s about a point beside the axle; in a wheel the weight stays upright.
    void aSensorOnACircleFeelsItsCentripetalAcceleration() {
        QFETCH(QString, engine);
        QFETCH(double, tick);
        SensorWorld w(circling(engine.toStdString(), tick));
        QVERIFY2(w.ok(), w.failure().c_str());
        for (const auto& [motor, speed] : {std::pair("left", 4.), std::pair("right", 16.)}) {
            const std::string path = std::string("r/") + motor + "Motor/";
            w.world().block().slots()[w.world().layout().find(path + "servo")->offset] = 1;
            w.world().block().slots()[w.world().layout().find(path + "targetRate")->offset] = speed;
        }
        QVERIFY(w.run(int(3 / tick)));
        const double rate = w.value("r/base/velocity", 5), speed = w.vector("r/base/velocity").norm();
        QVERIFY(std::abs(rate - 12 * 0.05 / 0.26) < 0.01 && std::abs(speed - 0.5) < 0.01);
        const double tolerance = 0.2 * rate * tick * speed * rate; // half a tick late is 0.5 of that product
        const Vec3 middle(0, speed * rate, kGravity), away = middle - rate * rate * Vec3(0.3, 0.1, 0);
        QVERIFY2(isNear(w.vector("r/middle/acceleration"), middle, tolerance), shown(w.vector("r/middle/acceleration") - middle));
        QVERIFY2(isNear(w.vector("r/away/acceleration"), away, tolerance), shown(w.vector("r/away/acceleration") - away));
        const Vec3 inWheel = w.pose("r/right").rotation * w.vector("r/rolling/acceleration");
        const Vec3 ofWheel = w.pose("r/base").rotation * Vec3(0, rate * (speed + 0.13 * rate), kGravity);
        QVERIFY2(isNear(inWheel, ofWheel, 0.05), shown(inWheel - ofWheel));
    }

    void aSensorOnASlopeFeelsTheSlope_data() {
        QTest::addColumn<double>("slope"); // degrees
        QTest::addColumn<double>("friction");
        QTest::newRow("sticks") << 10. << 0.5;
        QTest::newRow("slides without friction") << 25. << 0.;
        QTest::newRow("slides with friction") << 35. << 0.2;
    }
    /// Specific force: the normal reaction and the friction of a block, over its mass.
    void aSensorOnASlopeFeelsTheSlope() {
        QFETCH(double, slope);
        QFETCH(double, friction);
        const double angle = slope * kPi / 180;
        const std::string surface = "Surface s { Friction=" + std::to_string(friction) + " Restitution=0 }\n";
        SensorWorld w(
            "Tick=0.002\n" + surface + "StaticConfig F { Plane floor { Surface=s HPR=0," + std::to_string(slope) +
            ",0 } }\nStatic floor { Config=F }\nRobotConfig Block { Body base { Box hull { Size=0.4,0.3,0.1 Mass=2 Surface=s } } "
            "Imu imu { Body=base Pos=0.1,0.05,0.05 } }\nRobot r { Config=Block HPR=0," +
            std::to_string(slope) + ",0 Pos=" + std::to_string(0.05 * std::sin(angle)) + ",0," +
            std::to_string(0.05 * std::cos(angle)) + " }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(300));
        const double along = std::min(std::sin(angle), friction * std::cos(angle)); // of friction, in units of gravity
        // The block leans by some 1e-5 rad on its contacts.
        const Quat lean = w.pose("r/base").rotation.conjugate() * rotationFromHpr({0, angle, 0});
        QVERIFY(lean.angularDistance(Quat::Identity()) < 1e-4);
        const Vec3 expected = lean * (kGravity * Vec3(-along, 0, std::cos(angle))), read = w.vector("r/imu/acceleration");
        QVERIFY2(isNear(read, expected, 1e-6 * kGravity), shown(read - expected));
    }

    void theGyroscopeIntegratesToTheAngle() {
        SensorWorld w(turntable(0.01, "Imu imu { Body=disc Pos=0.3,0,0 HPR=0,0,90 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/motor/voltage")->offset] = 20;
        double angle = 0;
        while (w.value("r/axle/position") < 200 * kPi) {
            QVERIFY(w.run());
            angle += w.value("r/imu/angularVelocity", 1) * 0.01; // its y axis points up
        }
        qInfo("after %.1f turns: %.3g rad apart", angle / (2 * kPi), angle - w.value("r/axle/position"));
        QVERIFY(std::abs(angle / w.value("r/axle/position") - 1) < 1e-6);
    }

    /// The largest reading is the largest multiple of Resolution within Range.
    void anImuAtItsRangeReadsAMultipleOfItsResolution() {
        SensorWorld w(carried("Imu imu { Body=base GyroscopeBias=9,0.3,-9 AccelerometerBias=25,2,-25 Range=1.1,20 "
                              "Resolution=0.4,3 }",
                              "", "Tick=0.01 Gravity=0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(2));
        const Vec3 turning = w.vector("r/imu/angularVelocity"), acceleration = w.vector("r/imu/acceleration");
        QVERIFY2(isNear(turning, {0.8, 0.4, -0.8}, 1e-12), shown(turning));
        QVERIFY2(isNear(acceleration, {18, 3, -18}, 1e-12), shown(acceleration));
    }

    void anImuErrsAsItsFieldsSay() {
        const std::string text = carried(
            "Imu a { Body=base Noise=0.02,0.3 GyroscopeBias=0.1,0.2,0.3 AccelerometerBias=1,2,3 ScaleError=0,0.01 }\n"
            "Imu b { Body=base NoiseDensity=0.001,0.02 }\nImu c { Body=base RandomWalk=0.01,0.5 }\n"
            "Imu d { Body=base Noise=1 Range=0.5,0 Resolution=0.25,0.5 }",
            "", "Tick=0.01 Seed=7 Gravity=0,0,-10", "StaticConfig F { Plane floor { Pos=0,0,-0.2 } }\nStatic floor { Config=F }");
        SensorWorld w(text);
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> gyro, accel, dense, walk;
        double last = 0;
        const int ticks = 20000;
        QVERIFY(w.run(100));
        last = w.value("r/c/acceleration", 0);
        for (int i = 0; i < ticks; ++i) {
            QVERIFY(w.run());
            gyro.push_back(w.value("r/a/angularVelocity", 1));
            accel.push_back(w.value("r/a/acceleration", 2));
            dense.push_back(w.value("r/b/acceleration", 0));
            walk.push_back(w.value("r/c/acceleration", 0) - last);
            last = w.value("r/c/acceleration", 0);
            QVERIFY(std::abs(w.value("r/d/angularVelocity", 0)) <= 0.5);
            QCOMPARE(std::remainder(w.value("r/d/acceleration", 0), 0.5), 0.);
        }
        const double n = ticks;
        const auto check = [&](const std::vector<double>& samples, double mean, double deviation) {
            const Moments m = momentsOf(samples);
            qInfo("mean %.5f (%.5f), deviation %.5f (%.5f), correlation %.4f", m.mean, mean, m.deviation, deviation,
                  correlationOf(samples, 1));
            return std::abs(m.mean - mean) < 4 * deviation / std::sqrt(n) &&
                   std::abs(m.deviation / deviation - 1) < 4 / std::sqrt(2 * n) &&
                   std::abs(correlationOf(samples, 1)) < 4 / std::sqrt(n);
        };
        QVERIFY(check(gyro, 0.2, 0.02));
        QVERIFY(check(accel, 10 * 1.01 + 3, 0.3));
        QVERIFY(check(dense, 0, 0.02 / std::sqrt(0.01)));
        QVERIFY(check(walk, 0, 0.5 * std::sqrt(0.01)));
    }

    void anImuGivesItsOrientationOnRequest() {
        SensorWorld w(carried("Imu a { Body=base HPR=90,0,0 Orientation=true }\nImu b { Body=base }", "HPR=0,30,0",
                              "Tick=0.01 Gravity=0,0,0"));
        QVERIFY(w.run());
        const Quat turned = rotationFromHpr({0, kPi / 6, 0}) * rotationFromHpr({kPi / 2, 0, 0});
        const auto q = w.values("r/a/orientation");
        QVERIFY(Quat(q[0], q[1], q[2], q[3]).angularDistance(turned) < 1e-9);
        for (const double v : w.values("r/b/orientation")) QCOMPARE(v, 0.);
    }

    void aCompassGivesTheHeading_data() {
        QTest::addColumn<double>("body");
        QTest::addColumn<double>("mounting");
        QTest::addColumn<double>("heading");
        QTest::newRow("ahead") << 0. << 0. << 0.;
        QTest::newRow("left") << 90. << 0. << 90.;
        QTest::newRow("mounted backwards") << 30. << 180. << -150.;
        QTest::newRow("around") << 170. << 40. << -150.;
    }
    void aCompassGivesTheHeading() {
        QFETCH(double, body);
        QFETCH(double, mounting);
        QFETCH(double, heading);
        SensorWorld w(
            carried("Compass c { Body=base HPR=" + std::to_string(mounting) + ",0,0 }\nCompass up { Body=base HPR=0,-90,0 }",
                    "HPR=" + std::to_string(body) + ",0,0", "Tick=0.01 Gravity=0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        QVERIFY(std::abs(std::remainder(w.value("r/c/heading") * 180 / kPi - heading, 360)) < 1e-9);
        QVERIFY(std::isfinite(w.value("r/up/heading")));
    }

    void aReceiverGivesPositionAndVelocityOfItsAntenna() {
        SensorWorld w(turntable(0.01, "Gps gps { Body=disc Pos=0.4,0,0.1 }", 2));
        QVERIFY2(w.ok(), w.failure().c_str());
        w.world().block().slots()[w.world().layout().find("r/motor/voltage")->offset] = 5;
        QVERIFY(w.run(300));
        const Pose disc = w.pose("r/disc");
        const Vec3 antenna = disc * Vec3(0.4, 0, 0.1);
        QVERIFY(isNear(w.vector("r/gps/position"), antenna, 1e-12));
        const double rate = w.value("r/axle/rate");
        QVERIFY(isNear(w.vector("r/gps/velocity"), Vec3(0, 0, rate).cross(disc.rotation * Vec3(0.4, 0, 0)), 1e-9));
    }

    void theErrorOfAReceiverIsCorrelatedInTime() {
        SensorWorld w(
            carried("Gps a { Body=base UpdatePeriod=0.1 Noise=1.5,3 CorrelationTime=0.5 VelocityNoise=0.1 Dropouts=0.2 }", "",
                    "Tick=0.1 Seed=11 Gravity=0,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> east, north, up, speed, times;
        double n = 0, missed = 0, last = 0;
        for (int i = 0; i < 100000; ++i) {
            QVERIFY(w.run());
            ++n;
            missed += w.value("r/a/time") == last;
            last = w.value("r/a/time");
            east.push_back(w.value("r/a/position", 0));
            north.push_back(w.value("r/a/position", 1));
            up.push_back(w.value("r/a/position", 2));
            speed.push_back(w.value("r/a/velocity", 1));
        }
        const double step = std::exp(-0.1 / 0.5), effective = n * (1 - step) / (1 + step);
        // A reading that is missed repeats the last one: with probability q^k the value is k readings old.
        const double q = 0.2, lag1 = q + (1 - q) * (1 - q) * step / (1 - q * step);
        qInfo("missed %.4f; x: deviation %.4f, correlation %.4f (%.4f)", missed / n, momentsOf(east).deviation,
              correlationOf(east, 1), lag1);
        QVERIFY(std::abs(missed / n - 0.2) < 4 * std::sqrt(0.2 * 0.8 / n));
        QVERIFY(std::abs(momentsOf(east).deviation / 1.5 - 1) < 4 / std::sqrt(effective));
        QVERIFY(std::abs(momentsOf(north).deviation / 1.5 - 1) < 4 / std::sqrt(effective));
        QVERIFY(std::abs(momentsOf(up).deviation / 3 - 1) < 4 / std::sqrt(effective));
        QVERIFY(std::abs(momentsOf(speed).deviation / 0.1 - 1) < 4 / std::sqrt(n / 2));
        QVERIFY(std::abs(correlationOf(east, 1) - lag1) < 4 / std::sqrt(effective));
        SensorWorld exact(carried("Gps a { Body=base Noise=2 CorrelationTime=1 }", "", "Tick=0.1 Seed=11 Gravity=0,0,0"));
        std::vector<double> all;
        for (int i = 0; i < 20000; ++i) {
            QVERIFY(exact.run());
            all.push_back(exact.value("r/a/position", 1));
        }
        for (const std::size_t lag : {1u, 5u, 10u, 20u})
            QVERIFY2(std::abs(correlationOf(all, lag) - std::exp(-0.1 * double(lag))) < 4 * std::sqrt(2 / (0.1 * 20000)),
                     qPrintable(QString::number(lag)));
    }

    void specificForceIsExactForASteadyTurn_data() {
        QTest::addColumn<Vec3>("axis");
        QTest::addColumn<double>("gravity");
        QTest::addColumn<bool>("falls");
        QTest::addColumn<double>("radius"); // of the circle of the centre of mass
        QTest::newRow("a level circle") << Vec3(0, 0, 1) << kGravity << false << 0.7;
        QTest::newRow("a tilted circle without gravity") << Vec3(1, 2, 3) << 0. << false << 0.7;
        QTest::newRow("tumbling in free fall") << Vec3(1, 2, 3) << kGravity << true << 0.;
        QTest::newRow("rolling at a constant speed") << Vec3(0, 1, 0) << kGravity << false << 0.;
    }
    /// Of a body that an engine moves: its centre of mass by one velocity for each tick, to where it is at the end.
    void specificForceIsExactForASteadyTurn() {
        QFETCH(Vec3, axis);
        QFETCH(double, gravity);
        QFETCH(bool, falls);
        QFETCH(double, radius);
        axis.normalize();
        const double tick = 0.02;
        const Vec3 weight(0, 0, -gravity), lever = radius * axis.unitOrthogonal();
        const Quat mounting = rotationFromHpr({0.3, 0.4, 0.5});
        for (const double angle : {1e-6, 0.01, 0.4, 0.6, 2.5})
            for (const Vec3& arm : {Vec3(0, 0, 0), Vec3(0.4, -0.3, 0.1)}) {
                const Vec3 rate = axis * angle / tick;
                const auto turned = [&](int n) { return Quat(Eigen::AngleAxisd(n * angle, axis)); };
                Vec3 centre(1, 2, 3), place(0, 0, 0), velocity(0, 0, 0), read(0, 0, 0), expected(0, 0, 0);
                for (int n = 1; n < 10; ++n) {
                    const Quat now = turned(n), sensor = now * mounting;
                    const Vec3 chord = (now * lever - turned(n - 1) * lever) / tick;
                    const Vec3 moves = Vec3(0.5, 0.2, 0) + chord + (falls ? Vec3(n * tick * weight) : Vec3(0, 0, 0));
                    const Vec3 before = place, velocityBefore = velocity;
                    centre += tick * moves;
                    place = centre + now * arm;
                    velocity = moves + rate.cross(now * arm);
                    read = specificForce(velocity - velocityBefore, velocity - (place - before) / tick, weight, sensor,
                                         sensor.conjugate() * rate, tick);
                    const Vec3 fall = falls ? weight : Vec3(0, 0, 0);
                    expected = sensor.conjugate() * (rate.cross(rate.cross(now * (lever + arm))) + fall - weight);
                }
                QVERIFY2(isNear(read, expected, 1e-9 * std::max(1., expected.norm())), shown(read - expected));
            }
    }

    void aReceiverNeedsItsShareOfTheSky_data() {
        QTest::addColumn<QString>("scenery");
        QTest::addColumn<double>("least");
        QTest::addColumn<bool>("reads");
        QTest::newRow("open") << "" << 1. << true;
        QTest::newRow("under a roof") << "Box roof { Size=40,40,0.1 Pos=0,0,3 }" << 0.05 << false;
        QTest::newRow("under a small roof") << "Box roof { Size=2,2,0.1 Pos=0,0,3 }" << 0.5 << true;
        QTest::newRow("beside a high wall, half") << "Box wall { Size=0.1,2000,2000 Pos=1,0,0 }" << 0.6 << false;
        QTest::newRow("beside a high wall, a third") << "Box wall { Size=0.1,2000,2000 Pos=1,0,0 }" << 0.4 << true;
        QTest::newRow("what does not collide hides nothing") << "Box roof { Size=40,40,0.1 Pos=0,0,3 Collide=false }" << 1. << true;
    }
    void aReceiverNeedsItsShareOfTheSky() {
        QFETCH(QString, scenery);
        QFETCH(double, least);
        QFETCH(bool, reads);
        SensorWorld w(carried("Gps gps { Body=base Pos=0,0,0.3 MinSky=" + std::to_string(least) + " }", "", "Tick=0.01 Gravity=0,0,0",
                              "StaticConfig F { Box low { Size=1,1,0.1 Pos=0,0,-2 } " + scenery.toStdString() + " }\nStatic floor { Config=F }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(3));
        QCOMPARE(w.value("r/gps/time") > 0, reads);
    }
};

QTEST_GUILESS_MAIN(MotionTest)
#include "motion_test.moc"
