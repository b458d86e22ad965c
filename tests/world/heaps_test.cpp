// Many robots in one heap and large piles: no solver of a whole cluster could afford them.
#include <QtTest>

#include <algorithm>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kNoLoad = 20.0 / 12, kSoft = 50 * 2 / (30 * 30 * 0.02); // rad/s per V, rad/s per N m: of the motors

std::string nameOf(const char* kind, int i) { return kind + std::to_string(i); }

void drive(World& world, const std::string& robot, double volts) {
    for (const char* motor : {"/leftMotor", "/rightMotor"}) command(world, robot + motor, kNoLoad * volts, kSoft, 3.6);
}

/// The shipped SimpleRobot.
std::shared_ptr<RobotConfigSpec> simple() {
    auto config = std::make_shared<RobotConfigSpec>(*r0());
    BodySpec& chassis = config->bodies[0];
    chassis.mass = massOfBox(2.1, {0.3, 0.2, 0.1}, {0, 0, 0.09});
    chassis.geoms = {box("hull", {0.3, 0.2, 0.1}, at(0, 0, 0.09), 3), sphere("slider", 0.02, at(-0.12, 0, 0.02), 2),
                     box("bumper", {0.02, 0.3, 0.04}, at(0.16, 0, 0.07), 3)};
    for (int i = 1; i < 3; ++i) {
        config->bodies[std::size_t(i)].pose.position.x() = 0.06;
        config->bodies[std::size_t(i)].geoms[0].length = 0.03;
        config->bodies[std::size_t(i)].mass = massOfCylinder(0.15, 0.05, 0.03, rotationFromHpr(degrees(0, 0, 90)));
        config->joints[std::size_t(i - 1)].anchor.x() = 0.06;
    }
    return config;
}

struct Worst {
    double pitch = 0, depth = 0, rise = 0; ///< degrees, m, m
};

void look(World& world, int robots, Worst& worst) {
    for (int i = 0; i < robots; ++i) {
        const Pose pose = world.robotPose(static_cast<std::size_t>(i));
        worst.pitch = std::max(worst.pitch, std::acos(std::min(1.0, (pose.rotation * Vec3::UnitZ()).z())) * 180 / kPi);
        worst.rise = std::max(worst.rise, std::abs(pose.position.z()));
    }
    for (const WorldContact& c : world.contacts()) { worst.depth = std::max(worst.depth, c.depth); }
}

} // namespace

class HeapsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// All drive into a corner: nobody climbs, nobody stands in another.
    void corner_data() {
        QTest::addColumn<int>("robots");
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("moved"); // m, at the start
        QTest::newRow("5") << 5 << 0.01 << 0.0;
        QTest::newRow("12") << 12 << 0.01 << 0.0;
        QTest::newRow("50") << 50 << 0.01 << 0.0;
        QTest::newRow("50, another start") << 50 << 0.01 << 0.001; // tyres meet bumpers of which the lower edge is at their axles
        QTest::newRow("50, 5 ms") << 50 << 0.005 << 0.0;
        QTest::newRow("50, 30 ms") << 50 << 0.03 << 0.0;
        QTest::newRow("200") << 200 << 0.01 << 0.0;
    }
    void corner() {
        QFETCH(int, robots);
        QFETCH(double, tick);
        QFETCH(double, moved);
        Scene scene = r0Scene(tick);
        scene.scenery({plane("floor", {}, 1), box("west", {0.1, 40, 1}, at(-0.05, 0, 0.5), 3),
                       box("south", {40, 0.1, 1}, at(0, -0.05, 0.5), 3)});
        const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
        for (int i = 0; i < robots; ++i) {
            const double x = 0.4 + 0.45 * (i % side) + moved * std::sin(7 * i),
                         y = 0.4 + 0.45 * (i / side) + moved * std::cos(5 * i);
            scene.robot(nameOf("r", i), at(x, y, 0, Vec3(std::atan2(-y, -x), 0, 0)), simple());
        }
        auto world = scene.build();
        Worst worst;
        for (int i = 0; i < std::lround(10 / tick); ++i) {
            for (int r = 0; r < robots; ++r) drive(*world, nameOf("r", r), 4.8);
            const Status status = world->tick();
            QVERIFY2(status.ok(), status.ok() ? "" : status.error().message.c_str());
            look(*world, robots, worst);
        }
        qInfo("%d robots: pitch %.2f degrees, depth %.1f mm, rise %.1f mm", robots, worst.pitch, 1e3 * worst.depth,
              1e3 * worst.rise);
        QVERIFY(worst.pitch < 1);
        QVERIFY(worst.depth < (tick > 0.02 ? 0.03 : 0.012)); // at 30 ms 12 mm go by in a tick before anything touches
    }

    /// As many from the left as from the right: nobody gets anywhere.
    void stall_data() {
        QTest::addColumn<int>("each");
        QTest::addColumn<double>("volts");
        QTest::addColumn<double>("bound"); // mm
        for (const int each : {1, 2, 3, 8}) QTest::addRow("%d, below the grip of their wheels", each) << each << 0.8 << 1.0;
        // 12 N for each, which is what its wheels can hold: the last digits decide which way all of them move. Starts that differ by
        // some nanometres move up to 3 by 0.8 mm and 8 by 1.9
        for (const int each : {1, 2, 3, 8}) QTest::newRow(std::to_string(each).c_str()) << each << 1.0 << (each == 8 ? 3.0 : 1.0);
    }
    void stall() {
        QFETCH(int, each);
        QFETCH(double, volts);
        QFETCH(double, bound);
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)});
        for (int i = 0; i < 2 * each; ++i) {
            const double x = (i % 2 ? 1 : -1) * (0.25 + 0.32 * (i / 2));
            scene.robot(nameOf("r", i), at(x, 0, 0, degrees(i % 2 ? 180 : 0, 0, 0)), simple());
        }
        auto world = scene.build();
        std::vector<double> settled;
        double most = 0;
        for (int i = 0; i < 1000; ++i) {
            for (int r = 0; r < 2 * each; ++r) drive(*world, nameOf("r", r), volts);
            QVERIFY(world->tick().ok());
            if (i == 500)
                for (int r = 0; r < 2 * each; ++r) settled.push_back(world->robotPose(std::size_t(r)).position.x());
            for (int r = 0; i > 500 && r < 2 * each; ++r)
                most = std::max(most, std::abs(world->robotPose(std::size_t(r)).position.x() - settled[std::size_t(r)]));
        }
        qInfo("%d against %d: at %.4f, at most %.3f mm in 5 s", each, each, settled[0], 1e3 * most);
        QVERIFY(1e3 * most < bound);
    }

    /// A train is pushed as far as the exact solver of all pushes it.
    void train_data() {
        QTest::addColumn<int>("pushed");
        QTest::addColumn<bool>("braked");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const int pushed : {1, 2, 3, 5, 8}) {
                if (tick < 0.02) // one blow at 30 ms costs the exact solver itself 10 % and more
                    QTest::addRow("%d that roll, %g ms", pushed, 1e3 * tick) << pushed << false << tick;
                QTest::addRow("%d braked, %g ms", pushed, 1e3 * tick) << pushed << true << tick;
            }
    }
    void train() {
        QFETCH(int, pushed);
        QFETCH(bool, braked);
        QFETCH(double, tick);
        double ends[2];
        for (const bool exact : {false, true}) {
            Scene scene = r0Scene(tick);
            scene.spec->settings.solver = exact ? SolverChoice::Exact : SolverChoice::Auto;
            scene.scenery({plane("floor", {}, 1)});
            for (int i = 0; i <= pushed; ++i) scene.robot(nameOf("r", i), at(0.33 * i, 0, 0), simple());
            auto world = scene.build();
            for (int i = 0; i < std::lround((braked ? 10 : 4) / tick); ++i) {
                drive(*world, "r0", braked ? 1 : 3);
                for (int r = 1; r <= pushed && braked; ++r) drive(*world, nameOf("r", r), 0);
                QVERIFY(world->tick().ok());
            }
            ends[exact] = world->robotPose(std::size_t(pushed)).position.x() - 0.33 * pushed;
        }
        qInfo("the last of %d: %.4f m, exactly %.4f m", pushed, ends[0], ends[1]);
        QVERIFY(std::abs(ends[0] - ends[1]) < 0.01 * std::abs(ends[1]) + 0.001);
    }

    /// A robot whose wheels slip pushes with mu times the load that the push leaves on them: F = mu N / (1 + mu h / l) at height h above
    /// the floor, l from the slider to the axle. Braked ones give way as their motors' line says. Robots that rub along each other's faces
    /// also carry part of their weights, up or down, by how they met.
    void slip_data() {
        QTest::addColumn<int>("pushed");
        QTest::addColumn<double>("volts");
        QTest::addColumn<double>("rub");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const int pushed : {1, 3, 5})
                for (const double volts : {3.0, 6.0})
                    for (const double rub : {0.0, 0.3})
                        QTest::addRow("%d, %g V, mu %g, %g ms", pushed, volts, rub, 1e3 * tick) << pushed << volts << rub << tick;
    }
    void slip() {
        QFETCH(int, pushed);
        QFETCH(double, volts);
        QFETCH(double, rub);
        QFETCH(double, tick);
        Scene scene = r0Scene(tick);
        scene.spec->surfaces[3].friction = rub;
        scene.scenery({plane("floor", {}, 1)});
        for (int i = 0; i <= pushed; ++i) scene.robot(nameOf("r", i), at(0.33 * i, 0, 0), simple());
        auto world = scene.build();
        const int ticks = static_cast<int>(std::lround(6 / tick));
        double middle = 0;
        const auto last = [&] { return world->robotPose(std::size_t(pushed)).position.x(); };
        for (int i = 0; i < ticks; ++i) {
            drive(*world, "r0", volts);
            for (int r = 1; r <= pushed; ++r) drive(*world, nameOf("r", r), 0);
            QVERIFY(world->tick().ok());
            if (i == ticks / 2 - 1) middle = last();
        }
        const double length = 0.18, height = 0.07, centre = 0.3 * 0.06 / 2.4; // of mass, before the middle of the chassis
        const double push = 2.4 * g * (0.12 + centre) / length / (1 + height / length), brake = 2 / (kSoft * 0.05 * 0.05);
        const double speed = (last() - middle) / ((ticks - ticks / 2) * tick), theory = push / (brake * pushed);
        qInfo("%.5f m/s, by Coulomb %.5f: %+.2f %%", speed, theory, 100 * (speed / theory - 1));
        QVERIFY(std::abs(speed / theory - 1) < (rub > 0 ? 0.02 : 0.005));
    }

    /// Boxes in a row before a robot.
    void boxes() {
        double ends[2];
        for (const bool exact : {false, true}) {
            Scene scene = r0Scene();
            scene.spec->settings.solver = exact ? SolverChoice::Exact : SolverChoice::Auto;
            scene.scenery({plane("floor", {}, 1)}).robot("r", at(0, 0, 0), simple());
            for (int i = 0; i < 9; ++i)
                scene.loose(nameOf("b", i), at(0.3 + 0.15 * i, 0, 0.05), massOfBox(0.2, {0.1, 0.1, 0.1}),
                            {box("b", {0.1, 0.1, 0.1}, {}, 3)});
            auto world = scene.build();
            for (int i = 0; i < 600; ++i) {
                drive(*world, "r", 3);
                QVERIFY(world->tick().ok());
            }
            ends[exact] = position(*world, "b8/body").x();
        }
        qInfo("the last of 9 boxes: %.4f m, exactly %.4f m", ends[0], ends[1]);
        QVERIFY(std::abs(ends[0] - ends[1]) < 0.01 * (ends[1] - 1.5) + 0.001);
    }

    /// Ten boxes on each other in a pile of more than 60 contacts.
    void stackStands() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)});
        for (int s = 0; s < 2; ++s)
            for (int i = 0; i < 10; ++i)
                scene.loose("s" + std::to_string(s) + nameOf("b", i), at(0.003 * (i % 3), 0.15 * s, 0.05 + 0.1 * i),
                            massOfBox(0.5, {0.1, 0.1, 0.1}), {box("b", {0.1, 0.1, 0.1})});
        scene.loose("plank", at(0, 0.075, 1.01), massOfBox(0.5, {0.1, 0.3, 0.02}), {box("b", {0.1, 0.3, 0.02})});
        auto world = scene.build();
        QVERIFY(run(*world, 60));
        const Vec3 plank = position(*world, "plank/body");
        qInfo("the plank at %.4f %.4f %.4f, %d ticks iterated", plank.x(), plank.y(), plank.z(), int(world->solves().quickTicks));
        QCOMPARE(world->solves().quickTicks, std::uint64_t(0));
        QVERIFY((plank - Vec3(0, 0.075, 1.01)).norm() < 0.001);
    }
};

QTEST_APPLESS_MAIN(HeapsTest)
#include "heaps_test.moc"
