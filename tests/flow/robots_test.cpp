// Robots of many kinds, as a user writes them: each loads without a diagnostic and moves as the literature has it. The train, the rover and
// the arm are in links_test.cpp, cans, charger and soccer in tasks_test.cpp, a swarm in state_hashes_test.cpp.
#include <numbers>

#include "devices/sensor_world.h"
#include "flow/cli.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::string textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}
std::string sample(const char* name) { return textOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/robots/") + name); }

void command(SensorWorld& w, const std::string& path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}

double headingOf(SensorWorld& w, const std::string& drive) { return w.value(drive + "/pose", 2); }

/// Angle of a body about the world's y axis.
double pitchOf(SensorWorld& w, const std::string& body) {
    const Vec3 up = w.pose(body).rotation * Vec3::UnitZ();
    return std::atan2(up.x(), up.z());
}

bool isNear(const char* what, double is, double expected, double share) {
    qInfo("%s: %.5g, expected %.5g", what, is, expected);
    return std::abs(is - expected) <= share * std::abs(expected);
}

} // namespace

class RobotsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void loads_data() {
        QTest::addColumn<QString>("path");
        const QDir data(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/robots"));
        const QStringList files = data.entryList({"*.sim"});
        QVERIFY(files.size() >= 5);
        for (const QString& file : files) QTest::newRow(qPrintable(file)) << data.filePath(file);
    }
    void loads() {
        QFETCH(QString, path);
        const Outcome check = cli({"check", path, "--json"});
        QVERIFY2(check.code == 0, shown(check));
        QCOMPARE(QJsonDocument::fromJson(check.out).array(), QJsonArray());
        const Outcome format = cli({"format", path, "--check"});
        QVERIFY2(format.code == 0, shown(format));
    }

    /// The thesis' first experiment: 1 m ahead.
    void classroomRobotDrivesOneMetre() {
        SensorWorld w(textOf(configPath("experiments/linear_motion.sim")));
        QVERIFY2(w.ok(), w.failure().c_str());
        const Vec3 start = w.pose("robot0").position;
        QVERIFY(w.run(1000));
        const Vec3 way = w.pose("robot0").position - start;
        QVERIFY(isNear("metres", way.x(), 1, 0.002));
        QVERIFY(std::abs(way.y()) < 0.002);
    }

    void turnsAsItsContactsSlide_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<double>("length"); // between the contacts, along and across
        QTest::addColumn<double>("width");
        QTest::newRow("four wheels") << "skid.sim" << 0.2 << 0.3;
        QTest::newRow("two tracks") << "tracks.sim" << 0.4 << 0.3;
    }
    /// Martinez, Mandow et al., "Approximating kinematics for tracked mobile robots", Int. J. Robotics Research 24 (2005): the instantaneous
    /// centres of both sides are farther apart than the sides. With four contacts under equal load that slide by Coulomb's law, and
    /// no force along, it is by the factor 1 + (length / width)^2.
    void turnsAsItsContactsSlide() {
        QFETCH(QString, robot);
        QFETCH(double, length);
        QFETCH(double, width);
        SensorWorld w(sample(qPrintable(robot)));
        QVERIFY2(w.ok(), w.failure().c_str());
        command(w, "r/drive/angularVelocity", 1);
        QVERIFY(w.run(400));
        const double before = headingOf(w, "r/drive");
        QVERIFY(w.run(200));
        const double turned = std::remainder(headingOf(w, "r/drive") - before, 2 * std::numbers::pi);
        QVERIFY(isNear("rad/s", turned, 1 / (1 + length * length / (width * width)), 0.03));
    }

    /// Muir and Neuman, "Kinematic modeling for feedback control of an omnidirectional wheeled mobile robot" (1987): the rates of mecanum
    /// wheels for a motion in all three directions.
    void mecanumWheelsTurnAsTheKinematicsHaveIt() {
        SensorWorld w(sample("mecanum.sim"));
        QVERIFY2(w.ok(), w.failure().c_str());
        const double forward = 0.25, left = -0.15, turn = 0.4, arm = 0.12 + 0.14, radius = 0.05;
        command(w, "r/drive/linearVelocity", forward);
        command(w, "r/drive/lateralVelocity", left);
        command(w, "r/drive/angularVelocity", turn);
        QVERIFY(w.run(400));
        QVERIFY(isNear("front left", w.value("r/left.front.axle/rate"), (forward - left - turn * arm) / radius, 0.01));
        QVERIFY(isNear("front right", w.value("r/right.front.axle/rate"), (forward + left + turn * arm) / radius, 0.01));
        QVERIFY(isNear("back left", w.value("r/left.back.axle/rate"), (forward + left - turn * arm) / radius, 0.01));
        QVERIFY(isNear("back right", w.value("r/right.back.axle/rate"), (forward - left + turn * arm) / radius, 0.01));
        const Pose at = w.pose("r");
        const Vec3 velocity = at.rotation.conjugate() * w.vector("r/hull/velocity");
        QVERIFY(isNear("forwards", velocity.x(), forward, 0.02));
        QVERIFY(isNear("to the left", velocity.y(), left, 0.02));
    }

    /// Rojas and Forster, "Holonomic control of a robot with an omnidirectional drive" (2006): the rim of a wheel at the angle a runs at
    /// -sin(a) forward + cos(a) left + R turn.
    void omniWheelsTurnAsTheKinematicsHaveIt() {
        SensorWorld w(
            "Tick=0.005\n#import robots/soccer_robot.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
            "Robot r { Config=SoccerRobot }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        const double forward = 0.4, left = 0.3, turn = -1;
        command(w, "r/base/linearVelocity", forward);
        command(w, "r/base/lateralVelocity", left);
        command(w, "r/base/angularVelocity", turn);
        QVERIFY(w.run(300));
        for (const auto& [wheel, angle] :
             {std::pair{"frontLeft", 57.}, {"backLeft", 135.}, {"backRight", 225.}, {"frontRight", 303.}}) {
            const double rim = -std::sin(angle * kDegree) * forward + std::cos(angle * kDegree) * left + 0.078 * turn;
            QVERIFY(isNear(wheel, w.value(std::string("r/") + wheel + ".axle/rate"), rim / 0.027, 0.01));
        }
    }

    void carDrivesCirclesAndRolls_data() {
        QTest::addColumn<double>("steering"); // degrees
        QTest::addColumn<double>("speed");
        QTest::newRow("as narrow as it can") << 24. << 0.5;
        QTest::newRow("wide and fast") << -12. << 1.5;
    }
    /// Ackermann's geometry has the middle of the back axle on a circle of the radius base / tan(steering). Gillespie, "Fundamentals of Vehicle
    /// Dynamics" (1992), chapter 6: in a turn the body rolls by M h a / (K - M g h); K = stiffness track^2 of four equal springs on struts.
    void carDrivesCirclesAndRolls() {
        QFETCH(double, steering);
        QFETCH(double, speed);
        SensorWorld w("Tick=0.005\n#import robots/car.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                      "Robot car { Config=Car }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(200));
        QVERIFY(std::abs(w.pose("car").position.z()) < 0.001); // the springs are preloaded
        command(w, "car/drive/steeringAngle", steering * kDegree);
        command(w, "car/drive/linearVelocity", speed);
        QVERIFY(w.run(1000));
        const double inner = w.value(steering > 0 ? "car/frontLeft.pivot/position" : "car/frontRight.pivot/position"),
                     outer = w.value(steering > 0 ? "car/frontRight.pivot/position" : "car/frontLeft.pivot/position");
        QVERIFY(
            isNear("cot outer - cot inner", 1 / std::tan(std::abs(outer)) - 1 / std::tan(std::abs(inner)), 0.25 / 0.3302, 0.01));
        double way = 0, turned = 0, roll = 0;
        const int ticks = 400;
        for (int i = 0; i < ticks; ++i) {
            const double x = w.value("car/drive/pose", 0), y = w.value("car/drive/pose", 1), heading = headingOf(w, "car/drive");
            QVERIFY(w.run(1));
            way += std::hypot(w.value("car/drive/pose", 0) - x, w.value("car/drive/pose", 1) - y);
            turned += std::remainder(headingOf(w, "car/drive") - heading, 2 * std::numbers::pi);
            roll += std::asin((w.pose("car").rotation * Vec3::UnitY()).z()) / ticks;
        }
        const double radius = 0.3302 / std::tan(std::abs(steering) * kDegree);
        QVERIFY(isNear("radius", way / std::abs(turned), radius, 0.02));
        const double acceleration = speed * speed / radius, weight = 3.74 * 0.074;
        const double expected = weight * acceleration / (400 * 0.25 * 0.25 - weight * 9.81);
        QVERIFY(isNear("roll in degrees", std::abs(roll) / kDegree, expected / kDegree, 0.08));
        QVERIFY(roll * steering > 0); // outwards
    }

    void carDrivesItsArcs() {
        QTemporaryDir logs;
        const Outcome run = cli({"run", configPath("experiments/car.sim"), "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2((run.out + run.err).contains("done: 3 arcs"), shown(run));
    }

    /// Grasser et al., "JOE: a mobile, inverted pendulum", IEEE Trans. Industrial Electronics 49 (2002): without control it falls as
    /// cosh(l t), l^2 = m g h / (J + m h^2 - (m h)^2 / M), where M has the wheels' inertia; a state feedback of the voltage keeps it upright.
    void balancerFallsAndIsKeptUpright() {
        std::string text = sample("balancer.sim");
        text += "Robot tipped { Config=Loose Pos=0,-1,0 HPR=0,0.2,0 }\n";
        SensorWorld w(text);
        QVERIFY2(w.ok(), w.failure().c_str());
        const double first = pitchOf(w, "tipped"), m = 2, h = 0.2, inertia = m / 12 * (0.06 * 0.06 + 0.4 * 0.4);
        const double moved = m + 0.4 + 0.4 / 2, rate = std::sqrt(m * 9.81 * h / (inertia + m * h * h - m * h * m * h / moved));
        QVERIFY(w.run(150));
        QVERIFY(isNear("rate of its fall, 1/s", std::acosh(pitchOf(w, "tipped") / first) / w.time(), rate, 0.02));
        double most = 0;
        for (int i = 0; i < 3000; ++i) {
            if (i < 50) QVERIFY(w.world().push("r/mast", {5, 0, 0}, Vec3(w.pose("r").position + Vec3(0, 0, 0.45))).ok());
            const double pitch = pitchOf(w, "r"), pitchRate = w.value("r/mast/velocity", 4);
            const double x = w.value("r/left.wheel/pose", 0), speed = w.value("r/left.wheel/velocity", 0);
            const double volts = 42.26 * pitch + 6.656 * pitchRate + 6.1 * x + 26.5 * speed;
            for (const char* motor : {"r/left.motor/voltage", "r/right.motor/voltage"})
                command(w, motor, std::clamp(volts, -12., 12.));
            QVERIFY(w.run(1));
            most = std::max(most, std::abs(pitch));
        }
        qInfo("pushed, it leans by up to %.2f degrees", most / kDegree);
        QVERIFY(most > 0.5 * kDegree && most < 20 * kDegree);
        QVERIFY(std::abs(pitchOf(w, "r")) < 0.1 * kDegree);
        QVERIFY(std::abs(w.value("r/left.wheel/pose", 0)) < 0.02);
        QVERIFY(std::abs(pitchOf(w, "tipped")) > 60 * kDegree);
    }

    /// A crate rides on three belts through doors that open by the signals of their motors.
    void crateRidesThroughTheDoors() {
        SensorWorld open(sample("hall.sim")), closed(sample("hall.sim"));
        QVERIFY2(open.ok(), open.failure().c_str());
        for (SensorWorld* w : {&open, &closed}) {
            for (int i = 0; i < 3; ++i) command(*w, "line_" + std::to_string(i) + ".conveyor/belt/speed", 0.4);
            for (const char* leaf : {"left", "right"})
                command(*w, std::string("door/") + leaf + ".opener/target", w == &open ? 0.35 : 0);
            QVERIFY(w->run(900));
        }
        QVERIFY(isNear("left leaf", open.value("door/left.rail/position"), 0.35, 0.01));
        QVERIFY(isNear("y of the right leaf", open.value("door/right.leaf/pose", 1), -0.55, 0.01));
        const double slipped = 0.4 * 0.4 / (2 * 0.2 * 9.81); // until friction has brought it to the speed of the belt
        QVERIFY(isNear("x of the crate", open.pose("crate").position.x(), -1.2 + 0.4 * 4.5 - slipped, 0.01));
        QCOMPARE(open.value("passed/count"), 1.);
        QVERIFY(closed.pose("crate").position.x() < 0); // at the closed door
        QCOMPARE(closed.value("passed/count"), 0.);
    }
};

QTEST_GUILESS_MAIN(RobotsTest)
#include "robots_test.moc"
