// A fault of one robot ends that robot, and joints that a tick tore open are closed again.
#include <QtTest>

#include <random>

#include "world/fixtures.h"

using namespace fixture;

namespace {

/// R0 at another scale; its motors as strong for their load.
std::shared_ptr<RobotConfigSpec> small(double scale, bool bumper) {
    auto config = std::make_shared<RobotConfigSpec>(*r0());
    if (bumper) config->bodies[0].geoms.push_back(box("bumper", {0.02, 0.3, 0.04}, at(0.13, 0, 0.07), 3));
    for (BodySpec& b : config->bodies) {
        b.pose.position *= scale;
        b.mass.mass *= std::pow(scale, 3);
        b.mass.centre *= scale;
        b.mass.inertia *= std::pow(scale, 5);
        for (GeomSpec& geom : b.geoms) {
            geom.pose.position *= scale;
            geom.size *= scale;
            geom.radius *= scale;
            geom.length *= scale;
        }
    }
    for (JointSpec& j : config->joints) j.anchor *= scale;
    return config;
}

/// 64 of them in a walled room, R0 scaled, each with other commands every 0.3 s.
struct Swarm {
    Swarm(double tick, double scale, double speed, bool bumper = false) : scale(scale), speed(speed) {
        Scene scene = r0Scene(tick);
        const double side = 8 * scale;
        std::vector<GeomSpec> room{plane("floor", {}, 1)};
        for (const int k : {-1, 1}) {
            room.push_back(box("x" + std::to_string(k), {0.1, side + 0.2, 0.3}, at(k * (side / 2 + 0.05), 0, 0.15), 3));
            room.push_back(box("y" + std::to_string(k), {side + 0.2, 0.1, 0.3}, at(0, k * (side / 2 + 0.05), 0.15), 3));
        }
        scene.scenery(room);
        const auto config = small(scale, bumper);
        for (int i = 0; i < 64; ++i)
            scene.robot("r" + std::to_string(i), at(scale * (i % 8 - 3.5), scale * (i / 8 - 3.5), 0), config);
        world = scene.build();
    }
    [[nodiscard]] bool run(double seconds) {
        const double until = world->time() + seconds;
        while (world->time() < until) {
            if (std::fmod(world->time() + 1e-9, 0.3) < world->experiment().settings.tick)
                for (int i = 0; i < 64; ++i) {
                    const double turn = 4 * (double(random()) / 4294967295.0) - 2; // rad/s
                    for (const int side : {1, -1}) {
                        const double rate = (speed - side * turn * scale * kR0Track / 2) / (kR0Radius * scale);
                        command(*world, "r" + std::to_string(i) + (side > 0 ? "/leftMotor" : "/rightMotor"), rate, 0, 3);
                    }
                }
            if (!world->tick()) return false;
        }
        return true;
    }
    /// How far the wheels of the robots that have not ended are from their axles, in wheel radii.
    [[nodiscard]] double widest() const {
        double most = 0;
        for (std::size_t i = 0; i < 64; ++i) {
            const std::string r = "r" + std::to_string(i);
            if (hasEnded(*world, i)) continue;
            const double* p = slot(*world, r + "/chassis/pose");
            const Pose chassis{Vec3(p), Quat(p[3], p[4], p[5], p[6])};
            for (const int side : {1, -1}) {
                const Vec3 hub = chassis * Vec3(0, side * scale * kR0Track / 2, scale * kR0Radius);
                const Vec3 wheel = position(*world, r + (side > 0 ? "/leftWheel" : "/rightWheel"));
                most = std::max(most, (wheel - hub).norm() / (scale * kR0Radius));
            }
        }
        return most;
    }
    double scale, speed;
    std::unique_ptr<World> world;
    std::mt19937 random{7};
};

std::vector<double> stateOf(World& world, const std::string& body) {
    const double *p = slot(world, body + "/pose"), *v = slot(world, body + "/velocity");
    std::vector<double> all(p, p + 7);
    all.insert(all.end(), v, v + 6);
    return all;
}

} // namespace

class EndedRobotsTest : public QObject {
    Q_OBJECT

    static Scene three() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("a", {}, r0()).robot("b", at(2, 0, 0), r0());
        scene.loose("crate", at(0, 2, 0.3, degrees(10, 20, 30)), massOfBox(1, {0.2, 0.2, 0.2}), {box("c", {0.2, 0.2, 0.2})});
        return scene;
    }

private Q_SLOTS:
    /// All others move to the bit as if nothing had happened to it.
    void othersContinue() {
        std::vector<double> ends[2];
        for (const bool faulty : {false, true}) {
            auto world = three().build();
            for (const char* robot : {"a", "b"}) {
                command(*world, std::string(robot) + "/leftMotor", 4, 0, 5.4);
                command(*world, std::string(robot) + "/rightMotor", 5, 0, 5.4);
            }
            QVERIFY(run(*world, 0.1));
            const auto before = stateOf(*world, "a/chassis");
            if (faulty) QVERIFY(world->push("a/chassis", {0, 0, 1e7}, {0, 0, 0.1}).ok());
            QVERIFY(run(*world, 1));
            QVERIFY(!world->fault());
            for (const char* body : {"b/chassis", "b/leftWheel", "crate/body"}) {
                const auto state = stateOf(*world, body);
                ends[faulty].insert(ends[faulty].end(), state.begin(), state.end());
            }
            QCOMPARE(world->robotFaults().ends.size(), std::size_t(faulty));
            if (!faulty) continue;
            const RobotEnd& end = world->robotFaults().ends[0];
            QCOMPARE(world->experiment().robots[end.robot].name, std::string("a"));
            QCOMPARE(QString::fromStdString(end.fault.body).left(2), QStringLiteral("a/"));
            QVERIFY(std::abs(end.fault.time - 0.11) < 1e-9);
            QVERIFY2(end.fault.reason.find("Tick") != std::string::npos, end.fault.reason.c_str());
            QVERIFY(hasEnded(*world, end.robot));
            const auto after = stateOf(*world, "a/chassis");
            for (int k = 0; k < 7; ++k) QVERIFY(std::abs(after[k] - before[k]) < 1e-12); // where it was, and at rest
            for (int k = 7; k < 13; ++k) QCOMPARE(after[k], 0.);
            for (const WorldContact& c : world->contacts()) QVERIFY(!c.first.starts_with("a/") && !c.second.starts_with("a/"));
            QVERIFY(!world->place("a", at(5, 5, 0)).ok());
        }
        QVERIFY(ends[0] == ends[1]);
    }

    /// A ball lies beside a beam, within the bounds of it, which is first in the text or second: when the beam has ended, a crate
    /// is still held by the one below it.
    void othersMeetBesideOneThatEnded() {
        for (const bool isFirst : {true, false}) {
            Scene scene;
            const Vec3 cube(0.2, 0.2, 0.2), beam(1, 0.1, 0.1);
            scene.scenery({plane()});
            if (!isFirst) scene.ball("ball", {0.25, -0.25, 0.1}, 1, 0.1);
            scene.loose("beam", at(0, 0, 0.05, degrees(45, 0, 0)), massOfBox(1, beam), {box("b", beam)});
            if (isFirst) scene.ball("ball", {0.25, -0.25, 0.1}, 1, 0.1);
            scene.loose("lower", at(3, 0, 0.1), massOfBox(1, cube), {box("c", cube)});
            scene.loose("upper", at(3, 0, 0.3), massOfBox(1, cube), {box("c", cube)});
            auto world = scene.build();
            QVERIFY(world && run(*world, 0.2));
            QVERIFY(world->push("beam/body", {0, 0, 1e7}, {0, 0, 0.05}).ok());
            QVERIFY(run(*world, 1));
            QCOMPARE(world->robotFaults().ends.size(), std::size_t(1));
            QVERIFY(std::abs(position(*world, "ball/body").z() - 0.1) < 0.01);
            QVERIFY(std::abs(position(*world, "lower/body").z() - 0.1) < 0.01);
            QVERIFY(std::abs(position(*world, "upper/body").z() - 0.3) < 0.01);
        }
    }

    /// The run ends with the last robot, although the crate could continue.
    void theLastRobotEndsTheRun() {
        auto world = three().build();
        QVERIFY(world->push("a/chassis", {0, 0, 1e7}, {0, 0, 0.1}).ok());
        QVERIFY(world->tick().ok());
        QVERIFY(world->push("b/chassis", {0, 0, 1e7}, {2, 0, 0.1}).ok());
        const Status status = world->tick();
        QVERIFY(!status.ok() && status.error().code == Code::BlowUp);
        QVERIFY(world->fault() && world->fault()->body.starts_with("b/"));
        QCOMPARE(world->robotFaults().ends.size(), std::size_t(2));
    }

    void objectsEndByThemselves() {
        Scene scene;
        scene.ball("a", {0, 0, 5}, 1, 0.1).ball("b", {1, 0, 5}, 1, 0.1);
        auto world = scene.build();
        QVERIFY(world->push("a/body", {0, 0, 1e7}, {0, 0, 5}).ok());
        QVERIFY(run(*world, 0.2));
        QCOMPARE(world->robotFaults().ends.size(), std::size_t(1));
        QVERIFY(std::abs(velocity(*world, "b/body").z() + 0.2 * g) < 1e-9);
        QVERIFY(world->push("b/body", {0, 0, 1e7}, {1, 0, 5}).ok());
        QVERIFY(!world->tick().ok() && world->fault());
    }

    /// Bumpers of 6 mm that move 4 mm in a tick brush others and touch them from behind, but pass through none.
    void slowBumpersPassThroughNothing() {
        Swarm swarm(0.01, 0.3, 0.4, true);
        QVERIFY(swarm.world && swarm.run(6));
        QVERIFY(swarm.world->sweeps().bodies > 100); // else this shows nothing
        QCOMPARE(swarm.world->sweeps().passed.size(), std::size_t(0));
    }

    void smallRobotsAtLongTicks_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("scale");
        QTest::addColumn<int>("most");
        QTest::newRow("20 ms, wheels of 10 mm") << 0.02 << 0.2 << 4;
        QTest::newRow("30 ms, wheels of 15 mm") << 0.03 << 0.3 << 8;
        QTest::newRow("30 ms, wheels of 10 mm") << 0.03 << 0.2 << 32; // they turn by 69 degrees in a tick
    }
    /// Joints are torn by a millimetre or two in collisions: they are closed again, or that robot ends. The run does not.
    void smallRobotsAtLongTicks() {
        QFETCH(double, tick);
        QFETCH(double, scale);
        QFETCH(int, most);
        Swarm swarm(tick, scale, 0.4);
        QVERIFY(swarm.world);
        for (int i = 0; i < 10; ++i) {
            QVERIFY2(swarm.run(0.5), swarm.world->fault() ? swarm.world->fault()->reason.c_str() : "");
            QVERIFY(swarm.widest() < 0.11);
        }
        const World& world = *swarm.world;
        qInfo("%zu robots with closed joints, %zu ended", world.robotFaults().closedJoints.size(),
              world.robotFaults().ends.size());
        QVERIFY(!world.robotFaults().closedJoints.empty()); // else this shows nothing
        QVERIFY(int(world.robotFaults().ends.size()) <= most);
        for (const RobotEnd& end : world.robotFaults().ends)
            QVERIFY2(end.fault.reason.find("smaller Tick") != std::string::npos, end.fault.reason.c_str());
    }
};

QTEST_APPLESS_MAIN(EndedRobotsTest)
#include "ended_robots_test.moc"
