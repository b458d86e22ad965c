// Stacks of many blocks, and floors that are laid of many boxes.
#include <QtTest>

#include "world/fixtures.h"
#include "world/ode/collision/contact_choice.h"

using namespace fixture;

namespace {

struct Brick {
    Vec3 centre, size; ///< m
};

std::vector<Brick> stacks(int count, int high, double a) {
    std::vector<Brick> bricks{{{0, 0, a / 4}, {2. * count * a, 2 * a, a / 2}}}; // a plank below
    for (int s = 0; s < count; ++s)
        for (int i = 0; i < high; ++i) bricks.push_back({{(2 * s - count + 1) * a, 0, a / 2 + (i + 0.5) * a}, {a, a, a}});
    return bricks;
}

/// In running bond, with half bricks at the ends.
std::vector<Brick> wall(int along, int high, const Vec3& size) {
    std::vector<Brick> bricks;
    const double step = size.x() + 0.001;
    for (int r = 0; r < high; ++r) {
        const double z = (r + 0.5) * size.z();
        for (int c = 0; c < along - r % 2; ++c) bricks.push_back({{(c + 0.5 * (r % 2)) * step, 0, z}, size});
        for (const double x : {-0.25, along - 0.75})
            if (r % 2) bricks.push_back({{x * step, 0, z}, {size.x() / 2 - 0.0005, size.y(), size.z()}});
    }
    return bricks;
}

std::vector<Brick> pyramid(int high, const Vec3& size, double gap = 0.02) {
    std::vector<Brick> bricks;
    for (int r = 0; r < high; ++r)
        for (int c = 0; c < high - r; ++c) bricks.push_back({{(c + 0.5 * r) * (size.x() + gap), 0, (r + 0.5) * size.z()}, size});
    return bricks;
}

Scene sceneOf(const std::vector<Brick>& bricks, double h) {
    Scene scene(h);
    const auto s = scene.surface(0.6);
    scene.scenery({plane("floor", {}, s)});
    for (std::size_t i = 0; i < bricks.size(); ++i)
        scene.loose("b" + std::to_string(i), {bricks[i].centre, Quat::Identity()},
                    massOfBox(600 * bricks[i].size.prod(), bricks[i].size), {box("b", bricks[i].size, {}, s)});
    return scene;
}

} // namespace

Q_DECLARE_METATYPE(std::vector<Brick>)

class MasonryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsPiledUpStays_data() {
        QTest::addColumn<std::vector<Brick>>("bricks");
        QTest::addColumn<double>("h");
        const auto add = [](const char* name, const std::vector<Brick>& bricks) {
            for (const double h : {0.002, 0.01}) QTest::addRow("%s, %g ms", name, 1e3 * h) << bricks << h;
        };
        add("two stacks of ten small cubes", stacks(2, 10, 0.03));
        add("three stacks of ten crates", stacks(3, 10, 0.3));
        add("seven stacks of ten cubes", stacks(7, 10, 0.05));
    }
    /// All of them are more than 60 contacts, which the exact solver takes where no robot is among them and they are no tangle.
    void whatIsPiledUpStays() {
        QFETCH(std::vector<Brick>, bricks);
        QFETCH(double, h);
        auto world = sceneOf(bricks, h).build();
        QVERIFY(run(*world, 2));
        QCOMPARE(world->solves().quickTicks, std::uint64_t(0));
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            const std::string body = "b" + std::to_string(i) + "/body";
            const Vec3 moved = position(*world, body) - bricks[i].centre;
            QVERIFY2(std::hypot(moved.x(), moved.y()) < 0.002 * bricks[i].size.z(), body.c_str());
            QVERIFY2(moved.z() > -0.004, body.c_str());
            QVERIFY2(velocity(*world, body).norm() < 0.02, qPrintable(QString::number(velocity(*world, body).norm())));
        }
    }

    void wallsStayUp_data() {
        QTest::addColumn<std::vector<Brick>>("bricks");
        QTest::addColumn<double>("h");
        const Vec3 small(0.08, 0.04, 0.04);
        QTest::newRow("wall of small bricks, 10 ms") << wall(6, 8, small) << 0.01;
        QTest::newRow("pyramid of small bricks, 10 ms") << pyramid(6, small) << 0.01;
        QTest::newRow("pyramid of small bricks, 20 ms") << pyramid(6, small) << 0.02;
        QTest::newRow("pyramid of bricks, 30 ms") << pyramid(6, {0.2, 0.1, 0.1}) << 0.03;
        QTest::newRow("wall of small bricks, 20 ms") << wall(6, 8, small) << 0.02;
        QTest::newRow("larger than what is tried exactly") << pyramid(8, small) << 0.01;
    }
    /// They hang together in too many ways for the exact solver. Iterated in short steps the small ones shook themselves down.
    void wallsStayUp() {
        QFETCH(std::vector<Brick>, bricks);
        QFETCH(double, h);
        auto world = sceneOf(bricks, h).build();
        QVERIFY(run(*world, 1.5));
        QVERIFY(world->solves().quickTicks > 0);
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            const double moved = (position(*world, "b" + std::to_string(i) + "/body") - bricks[i].centre).norm();
            QVERIFY2(moved < 0.03 * bricks[i].size.z(), qPrintable(QString("brick %1: %2 m").arg(i).arg(moved)));
        }
    }

    void robotCarriesThem_data() {
        QTest::addColumn<double>("h");
        for (const double h : {0.005, 0.01, 0.02, 0.03}) QTest::addRow("%g ms", 1e3 * h) << h;
    }
    /// A pyramid on a robot that drives off: with its wheels and the floor one cluster of more than a hundred contacts.
    void robotCarriesThem() {
        QFETCH(double, h);
        Scene scene = r0Scene(h);
        scene.scenery({plane("floor", {}, 0)});
        scene.robot("robot", {}, r0());
        const Vec3 size(0.05, 0.06, 0.03);
        std::vector<Brick> bricks = pyramid(5, size, 0.005);
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            bricks[i].centre += Vec3(-0.14, 0, 0.14); // on the middle of its hull
            scene.loose("b" + std::to_string(i), {bricks[i].centre, Quat::Identity()}, massOfBox(0.06, size),
                        {box("b", size, {}, 0)});
        }
        auto world = scene.build();
        for (int i = 0; i * h < 2; ++i) {
            const double rate = 3 * std::min(1.0, i * h);
            for (const char* motor : {"robot/leftMotor", "robot/rightMotor"}) command(*world, motor, rate, 0, 5);
            QVERIFY(world->tick());
        }
        const Vec3 way = position(*world, "robot/chassis");
        QVERIFY(way.x() > 0.1);
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            const double moved = (position(*world, "b" + std::to_string(i) + "/body") - bricks[i].centre - way).norm();
            QVERIFY2(moved < 0.001, qPrintable(QString("brick %1: %2 m").arg(i).arg(moved)));
        }
    }

    void movesOnceAsItMeetsAPile_data() {
        QTest::addColumn<double>("x");
        QTest::newRow("far") << 0.3;
        QTest::newRow("farther") << 0.37;
    }
    /// In the tick in which a chain that whips about meets a pile it moves once, not by itself and then with the pile.
    void movesOnceAsItMeetsAPile() {
        QFETCH(double, x);
        const double h = 0.02;
        Scene scene = sceneOf(stacks(2, 10, 0.05), h);
        auto config = std::make_shared<RobotConfigSpec>();
        const Vec3 size(0.08, 0.01, 0.01);
        for (int i = 0; i < 5; ++i) {
            const std::string name = "l" + std::to_string(i);
            config->bodies.push_back(body(name, at(0.1 * i + 0.05, 0, 0), massOfBox(0.05, size), {box(name, size)}));
            config->joints.push_back(
                joint("j" + name, JointType::Hinge, i == 0 ? kWorldBody : i - 1, i, {0.1 * i, 0, 0}, Vec3::UnitY()));
        }
        scene.robot("chain", at(x, 0, 0.6), config);
        auto world = scene.build();
        double before = 0; // m/s
        for (int i = 0; i < 25; ++i) {
            const Vec3 from = position(*world, "chain/l4");
            QVERIFY(world->tick());
            const double moved = (position(*world, "chain/l4") - from).norm(), speed = velocity(*world, "chain/l4").norm();
            QVERIFY2(moved < 1.3 * h * std::max(before, speed) + 1e-4, qPrintable(QString("tick %1: %2 m").arg(i).arg(moved)));
            before = speed;
        }
    }

    void rollsOverSeams_data() {
        QTest::addColumn<bool>("capsule");
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("h");
        for (const bool capsule : {false, true})
            for (const auto& [radius, speed] : {std::pair(0.0215, 0.15), {0.05, 0.3}, {0.11, 0.5}})
                for (const double h : {0.001, 0.005, 0.01, 0.02, 0.03})
                    QTest::addRow("%s of %g mm, %g ms", capsule ? "capsule" : "ball", 1e3 * radius, 1e3 * h)
                        << capsule << radius << speed << h;
    }
    /// A floor of boxes that are flush is level: what rolls keeps its speed, its height and its direction.
    void rollsOverSeams() {
        QFETCH(bool, capsule);
        QFETCH(double, radius);
        QFETCH(double, speed);
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(0.5);
        std::vector<GeomSpec> tiles;
        for (int i = 0; i < 20; ++i)
            tiles.push_back(box("t" + std::to_string(i), {0.1, 1, 0.02}, at(0.1 * i - 0.95, 0, -0.01), s));
        scene.scenery(tiles);
        GeomSpec shape = sphere("q", radius, {}, s);
        MassProperties mass = massOfSphere(1, radius);
        if (capsule) {
            shape.shape = GeomShape::Capsule;
            shape.length = 0.2;
            shape.pose.rotation = Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()));
        }
        scene.loose("r", at(-0.9, 0, radius), mass, {shape});
        auto world = scene.build();
        QVERIFY(run(*world, 5 * h));
        QVERIFY(world->push("r/body", Vec3(1.4 * speed / h, 0, 0), position(*world, "r/body")).ok());
        QVERIFY(run(*world, 0.1));
        const double before = velocity(*world, "r/body").x();
        QVERIFY(std::abs(before - speed) < 0.1 * speed);
        while (position(*world, "r/body").x() < 0.85) {
            QVERIFY(run(*world, h) && world->time() < 20);
            QVERIFY(std::abs(position(*world, "r/body").z() - radius) < 1.5e-4);
        }
        QVERIFY2(std::abs(velocity(*world, "r/body").x() / before - 1) < 2e-3,
                 qPrintable(QString::number(velocity(*world, "r/body").x() / before)));
        QVERIFY(std::abs(position(*world, "r/body").y()) < 1e-4);
    }

    void drivesOverSeams_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("heading"); // degrees, of the tiles under the robot
        for (const double h : {0.005, 0.01, 0.02, 0.03})
            for (const double heading : {0., 17.}) QTest::addRow("%g ms, %g deg", 1e3 * h, heading) << h << heading;
    }
    /// A robot on two wheels and a slider drives over tiles as over one box.
    void drivesOverSeams() {
        QFETCH(double, h);
        QFETCH(double, heading);
        std::vector<Vec3> ends;
        for (const bool tiled : {false, true}) {
            Scene scene = r0Scene(h);
            std::vector<GeomSpec> floor;
            const Quat turned(Eigen::AngleAxisd(heading * kPi / 180, Vec3::UnitZ()));
            if (!tiled) floor.push_back(box("floor", {4, 4, 0.02}, {Vec3(0, 0, -0.01), turned}, 0));
            for (int i = 0; tiled && i < 40; ++i)
                for (int k = 0; k < 12; ++k)
                    floor.push_back(box("t" + std::to_string(12 * i + k), {0.1, 0.1, 0.02},
                                        {turned * Vec3(0.1 * i - 1.937, 0.1 * k - 0.55, -0.01), turned}, 0));
            scene.scenery(floor);
            scene.robot("r", {Vec3(-1, 0.02, 0), Quat::Identity()}, r0());
            auto world = scene.build();
            for (const char* motor : {"r/leftMotor", "r/rightMotor"}) command(*world, motor, 6, 0.02, 1);
            QVERIFY(run(*world, 4.5));
            ends.push_back(position(*world, "r/chassis"));
        }
        QVERIFY(ends[0].x() > 0);
        QVERIFY2((ends[1] - ends[0]).norm() < 2e-4, qPrintable(QString::number((ends[1] - ends[0]).norm())));
    }

    /// Of a long narrow patch its corners are kept, not what is in one line with two of them.
    void cornersOfANarrowPatchAreKept() {
        const double points[][3] = {
            {-0.6675, 0.15, 5e-4}, {-0.681, -0.15, 0}, {-0.682, -0.102, 0}, {-0.685, 0.15, 0}, {-0.667, -0.15, 4.9e-4}};
        dContactGeom found[kMaxFound] = {};
        PointGroup group{};
        for (int i = 0; i < 5; ++i) {
            for (int k = 0; k < 2; ++k) found[i].pos[k] = points[i][k];
            found[i].depth = points[i][2];
            group[std::size_t(i)] = i;
        }
        QCOMPARE(spreadWidely(found, group, 5, 4), 4);
        std::vector<int> kept(group.begin(), group.begin() + 4);
        std::ranges::sort(kept);
        QCOMPARE(kept, (std::vector<int>{0, 1, 3, 4}));
        for (int i = 0; i < 4; ++i) found[i].pos[0] = -0.6675; // all in one line
        group = {0, 1, 2, 3};
        QCOMPARE(spreadWidely(found, group, 4, 4), 2);
    }
};

QTEST_APPLESS_MAIN(MasonryTest)
#include "masonry_test.moc"
