// The wheeled engine, and the same with planar vehicles, against closed forms: pushing, trains, jams, what is loose, contacts, rays; and
// against the general engine.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kStall = 2, kSoftness = 25; // N m, rad/s per N m

/// Of the test that runs.
EngineChoice testedEngine() {
    QFETCH_GLOBAL(QString, engine);
    return engine == "planar" ? EngineChoice::Planar : EngineChoice::Wheeled;
}

Scene wheeledScene(double tick = 0.01) {
    Scene scene = r0Scene(tick);
    scene.spec->settings.engine = testedEngine();
    scene.scenery({plane("floor", {}, 1)});
    return scene;
}

/// As the general engine sees it.
Scene inGeneral(const Scene& scene) {
    Scene copy;
    copy.spec = std::make_shared<ExperimentSpec>(*scene.spec);
    copy.spec->settings.engine = EngineChoice::General;
    return copy;
}

/// A robot of 0.2 m x 0.15 m on two wheels and two sliders, 1.7 kg, symmetrical.
std::shared_ptr<RobotConfigSpec> small() {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 hull(0.2, 0.15, 0.06), centre(0, 0, 0.05);
    config->bodies.push_back(body("chassis", {}, massOfBox(1.5, hull, centre),
                                  {box("hull", hull, {centre, Quat::Identity()}, 3), sphere("front", 0.02, at(0.08, 0, 0.02), 2),
                                   sphere("rear", 0.02, at(-0.08, 0, 0.02), 2)}));
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    for (const int side : {1, -1}) {
        const std::string name = side > 0 ? "left" : "right";
        const Vec3 hub(0, side * 0.065, 0.04);
        config->bodies.push_back(body(name + "Wheel", {hub, Quat::Identity()}, massOfCylinder(0.1, 0.04, 0.02, sideways),
                                      {cylinder("tyre", 0.04, 0.02, {Vec3::Zero(), sideways}, 1)}));
        config->joints.push_back(joint(name + "Axle", JointType::Hinge, 0, side > 0 ? 1 : 2, hub, Vec3::UnitY()));
        config->devices.push_back(row(name + "Motor", name + "Axle"));
    }
    return config;
}
constexpr double kWheel = 0.04, kMass = 1.7;

/// Both wheels at a speed of the rim, by a motor with a line.
void drive(World& world, const std::string& robot, double speed, double softness = kSoftness) {
    command(world, robot + "/leftMotor", speed / kWheel, softness, kStall);
    command(world, robot + "/rightMotor", speed / kWheel, softness, kStall);
}

std::vector<GeomSpec> sevenCorners(double radius, double height, std::uint32_t surface) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (int k = 0; k < 7; ++k)
        for (const double z : {-height / 2, height / 2})
            mesh->points.push_back(
                {radius * std::cos(2 * kPi * k / 7), radius * std::sin(2 * kPi * k / 7), z}); // a side towards -x
    for (std::uint32_t k = 0; k < 7; ++k) {
        const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % 7);
        mesh->triangles.push_back({a, a + 1, b});
        mesh->triangles.push_back({b, a + 1, b + 1});
    }
    GeomSpec geom = box("prism", {}, {}, surface);
    geom.shape = GeomShape::Convex;
    geom.mesh = geom.hull = mesh;
    geom.collideAsHull = true;
    return {geom};
}

} // namespace

class WheeledTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data() {
        QTest::addColumn<QString>("engine");
        for (const char* engine : {"wheeled", "planar"}) QTest::newRow(engine) << engine;
    }
    void pushes_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.003, 0.01, 0.03})
            for (const char* shape : {"box", "cylinder", "seven corners", "ball"})
                QTest::addRow("%s, %g ms", shape, 1e3 * tick) << shape << tick;
    }
    /// At a steady speed v the motors give what friction takes: 2 (u - v) / (r^2 s) = mu m g, s the softness.
    void pushes() {
        QFETCH(QString, shape);
        QFETCH(double, tick);
        Scene scene = wheeledScene(tick);
        const auto slow = scene.surface(0.5);
        const bool rolls = shape == "ball";
        if (shape == "box")
            scene.loose("thing", at(0.3, 0, 0.05), massOfBox(1, {0.2, 0.2, 0.1}), {box("b", {0.2, 0.2, 0.1}, {}, slow)});
        if (shape == "cylinder")
            scene.loose("thing", at(0.3, 0, 0.05), massOfCylinder(1, 0.1, 0.1), {cylinder("c", 0.1, 0.1, {}, slow)});
        if (shape == "seven corners")
            scene.loose("thing", at(0.3, 0, 0.05), massOfCylinder(1, 0.1, 0.1), sevenCorners(0.1, 0.1, slow));
        if (rolls) scene.ball("thing", {0.3, 0, 0.05}, 1, 0.05, slow);
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3);
        QVERIFY(run(*world, 4));
        const double force = rolls ? 0 : 0.5 * g, speed = 0.3 - force * kWheel * kWheel * kSoftness / 2;
        const Vec3 thing = position(*world, "thing/body"), robot = world->robotPose(1).position;
        qInfo("%.5f m/s, closed form %.5f; %.5f m aside, %.5f m ahead", velocity(*world, "thing/body").x(), speed, thing.y(),
              thing.x() - robot.x());
        QVERIFY(std::abs(velocity(*world, "thing/body").x() - speed) < 2e-4);
        QVERIFY(std::abs(thing.y()) < 1e-3);
        QVERIFY(std::abs(thing.x() - robot.x() - 0.1 -
                         (rolls                      ? 0.05
                          : shape == "seven corners" ? 0.1 * std::cos(kPi / 7)
                                                     : 0.1)) < 1e-3);
    }

    /// The last of five robots pushes four whose wheels are braked by their motors' lines.
    void trains() {
        Scene scene = wheeledScene();
        for (int i = 0; i < 5; ++i) scene.robot("r" + std::to_string(i), at(-0.21 * i, 0, 0), small());
        auto world = scene.build();
        QVERIFY(world);
        for (int i = 0; i < 5; ++i) drive(*world, "r" + std::to_string(i), i == 4 ? 0.4 : 0, 4 * kSoftness);
        QVERIFY(run(*world, 8));
        for (int i = 0; i < 5; ++i) {
            const std::string chassis = "r" + std::to_string(i) + "/chassis";
            QVERIFY(std::abs(velocity(*world, chassis).x() - 0.08) < 2e-4); // a fifth, as five equal lines share it
            QVERIFY(std::abs(position(*world, chassis).y()) < 1e-3);
        }
    }

    void meetsHeadOn() {
        Scene scene = wheeledScene();
        scene.robot("a", at(-0.25, 0, 0), small()).robot("b", at(0.25, 0, 0, degrees(180, 0, 0)), small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "a", 0.3);
        drive(*world, "b", 0.3);
        QVERIFY(run(*world, 4));
        QVERIFY(std::abs(position(*world, "a/chassis").x() + 0.1) < 2e-4);
        QVERIFY(std::abs(position(*world, "b/chassis").x() - 0.1) < 2e-4);
        qInfo("%.3g m/s", velocity(*world, "a/chassis").norm());
        QVERIFY(velocity(*world, "a/chassis").norm() < 1e-4);
    }

    void jams_data() {
        QTest::addColumn<int>("robots");
        QTest::newRow("10") << 10;
        QTest::newRow("50") << 50;
    }
    /// All drive into one corner: nobody climbs, leans or sinks in.
    void jams() {
        QFETCH(int, robots);
        Scene scene = wheeledScene();
        scene.scenery({box("west", {0.1, 12, 0.3}, at(-5.05, 0, 0.15), 3), box("south", {12, 0.1, 0.3}, at(0, -5.05, 0.15), 3)},
                      {}, "walls");
        const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
        for (int i = 0; i < robots; ++i) {
            const double x = -4.8 + 0.32 * (i % side), y = -4.8 + 0.32 * (i / side);
            scene.robot("r" + std::to_string(i), {{x, y, 0}, rotationFromHpr({std::atan2(-5 - y, -5 - x), 0, 0})}, small());
        }
        auto world = scene.build();
        QVERIFY(world);
        for (int i = 0; i < robots; ++i) drive(*world, "r" + std::to_string(i), 0.3);
        double deepest = 0;
        for (int k = 0; k < 800; ++k) {
            QVERIFY(world->tick().ok());
            for (const WorldContact& c : world->contacts())
                if (k > 500 && std::abs(c.normal.z()) < 0.5) deepest = std::max(deepest, c.depth);
        }
        qInfo("deepest %.3f mm", 1e3 * deepest);
        QVERIFY(deepest < 1e-3);
        QVERIFY(world->robotFaults().ends.empty());
        for (int i = 0; i < robots; ++i) {
            const Pose pose = world->robotPose(static_cast<std::size_t>(i));
            QVERIFY(std::abs(pose.position.z()) < 1e-3);
            QVERIFY(pose.rotation.toRotationMatrix()(2, 2) > std::cos(0.5 * kPi / 180));
        }
    }

    /// More robots than one thread takes, that meet each other and a wall.
    void isTheSameOnAnyThreads() {
        std::vector<std::uint64_t> hashes;
        for (const int threads : {1, 2, 3}) {
            Scene scene = wheeledScene();
            scene.spec->settings.threads = threads;
            scene.scenery({box("wall", {0.1, 12, 0.3}, at(1.7, 0, 0.15), 3)}, {}, "room");
            for (int i = 0; i < 64; ++i) scene.robot("r" + std::to_string(i), at(0.3 * (i % 8) - 0.9, 0.3 * (i / 8), 0), small());
            auto world = scene.build();
            QVERIFY(world);
            for (int i = 0; i < 64; ++i) drive(*world, "r" + std::to_string(i), i % 3 == 0 ? 0.4 : i % 3 == 1 ? -0.2 : 0.1);
            QVERIFY(run(*world, 2));
            hashes.push_back(world->stateHash());
        }
        QCOMPARE(hashes[1], hashes[0]);
        QCOMPARE(hashes[2], hashes[0]);
    }

    /// Sliding and turning on the ground: v^2 / (2 mu g), w^2 I / (2 mu m g a), a: half the diagonal.
    void looseStops() {
        Scene scene = wheeledScene();
        const auto slow = scene.surface(0.5);
        const auto add = [&](const char* name, double y) {
            scene.loose(name, at(0, y, 0.05), massOfBox(1, {0.2, 0.2, 0.1}), {box("b", {0.2, 0.2, 0.1}, {}, slow)});
        };
        add("slides", 0);
        add("turns", 2);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("slides/body", {100, 0, 0}, {0, 0, 0.05}).ok()); // 1 m/s in one tick, less friction
        for (const double side : {1., -1.})                                  // a couple: 10 rad/s
            QVERIFY(world->push("turns/body", {0, side * 1000 / 3, 0}, {side * 0.01, 2, 0.05}).ok());
        QVERIFY(world->tick().ok());
        const double v = velocity(*world, "slides/body").x(), w = spin(*world, "turns/body").z();
        const double slowing = 0.5 * g * 0.1 * std::sqrt(2.) / (0.08 / 12); // of the turning, rad/s^2
        QVERIFY(std::abs(v - 1) < 0.06 && std::abs(w - (10 - slowing * 0.01)) < 0.7);
        const Vec3 from = position(*world, "slides/body");
        QVERIFY(run(*world, 0.5));
        const double slid = position(*world, "slides/body").x() - from.x(),
                     turned = hprFromRotation(world->robotPose(1).rotation).x();
        qInfo("slid %.4f m, closed form %.4f; turned %.4f rad, closed form %.4f", slid, v * v / g, turned, w * w / 2 / slowing);
        QVERIFY(std::abs(slid - (v * v / g - v * 0.005)) < 1e-3); // semi-implicit: half a tick short
        QVERIFY(std::abs(turned - w * 0.01 - w * w / 2 / slowing + w * 0.005) < 0.02);
        QVERIFY(velocity(*world, "slides/body").norm() < 1e-9 && spin(*world, "turns/body").norm() < 1e-9);
    }

    /// Without friction two things keep their momentum; with restitution 0.5 half of the closing speed is left.
    void collides() {
        Scene scene = wheeledScene();
        const auto slick = scene.surface(0, 0.5);
        scene.loose("a", at(0, 0, 0.05), massOfCylinder(1, 0.1, 0.1), {cylinder("c", 0.1, 0.1, {}, slick)});
        scene.loose("b", at(0.5, 0, 0.05), massOfCylinder(3, 0.1, 0.1), {cylinder("c", 0.1, 0.1, {}, slick)});
        auto world = scene.build();
        QVERIFY(world && world->push("a/body", {100, 0, 0}, {0, 0, 0.05}).ok());
        QVERIFY(run(*world, 1));
        const double a = velocity(*world, "a/body").x(), b = velocity(*world, "b/body").x();
        QVERIFY(std::abs(a + 3 * b - 1) < 1e-9);
        QVERIFY(std::abs(b - a - 0.5) < 1e-9);
    }

    /// What drives a robot against an elastic wall is no blow: it bounces once and then presses evenly, with all that its tyres hold.
    void pressesEvenly() {
        Scene scene = wheeledScene();
        const auto elastic = scene.surface(0.5, 0.6);
        scene.scenery({box("wall", {0.1, 2, 0.3}, at(0.2, 0, 0.15), elastic)}, {}, "room");
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 5, 0.01); // 0.98 g of both tyres' load: up to 0.05 m/s in a tick
        double fastestBack = 0;
        for (int k = 0; k < 300; ++k) {
            QVERIFY(world->tick().ok());
            fastestBack = std::min(fastestBack, velocity(*world, "r/chassis").x());
        }
        QVERIFY(fastestBack < -0.1); // it did bounce
        double least = 1e300, most = 0;
        for (int k = 0; k < 50; ++k) {
            QVERIFY(world->tick().ok());
            double back = 0;
            for (const WorldContact& c : world->contacts()) back -= c.force * c.normal.x();
            least = std::min(least, back);
            most = std::max(most, back);
            QVERIFY(velocity(*world, "r/chassis").norm() < 1e-6);
        }
        qInfo("back at up to %.3f m/s, then %.6f to %.6f N", -fastestBack, least, most);
        QVERIFY(least > 5 && most - least < 1e-3 * most);
    }

    void ballRolls() {
        Scene scene = wheeledScene();
        const auto rolling = scene.surface(0.8, 0, 0.001);
        scene.ball("ball", {0, 0, 0.05}, 0.4, 0.05, rolling);
        auto world = scene.build();
        QVERIFY(world && world->push("ball/body", {0.4 * 1.4 * 100, 0, 0}, {0, 0, 0.05}).ok());
        QVERIFY(run(*world, 0.5));
        const Vec3 v = velocity(*world, "ball/body"), w = spin(*world, "ball/body");
        QVERIFY(std::abs(w.y() * 0.05 - v.x()) < 1e-12); // it rolls
        QVERIFY(std::abs(v.x() - (1 - 0.5 * 0.001 / 0.05 * g / 1.4)) < 1e-9);
    }

    /// Contacts with the ground carry the weight; what a wall carries is what the wheels give.
    void contactsCarry() {
        Scene scene = wheeledScene();
        scene.scenery({box("wall", {0.1, 2, 0.3}, at(0.5, 0, 0.15), 3)}, {}, "room");
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.1);
        QVERIFY(run(*world, 8));
        double up = 0, back = 0;
        for (const WorldContact& c : world->contacts()) {
            if (c.normal.z() > 0.5) up += c.force;
            else back -= c.force * c.normal.x();
            QVERIFY(c.first.starts_with("r/"));
        }
        QVERIFY(std::abs(up - kMass * g) < 1e-3 * kMass * g);
        qInfo("%.4f N up, %.4f N back", up, back);
        QVERIFY(std::abs(back - 2 * 0.1 / (kWheel * kWheel * kSoftness)) < 0.01 * back);
        QVERIFY(std::abs(value(*world, "r/leftMotor/effort") - 0.1 / kWheel / kSoftness) < 1e-6);
    }

    /// On the first of a contact friction acts against its motion along the second: scenery, or another thing.
    void frictionActsAgainstTheMotion() {
        for (const char* beside : {"wall", "later", "earlier"})
            for (const double way : {1., -1.}) {
                Scene scene = wheeledScene();
                const bool isWall = beside == std::string("wall"), isEarlier = beside == std::string("earlier");
                const Vec3 size(0.2, 0.2, 0.1), block(4, 0.2, 0.3);
                const Pose place = at(0, 0.2, 0.15);
                const auto addBlock = [&] { scene.loose("block", place, massOfBox(40, block), {box("b", block, {}, 3)}); };
                if (isWall) scene.scenery({box("wall", block, place, 3)}, {}, "room");
                if (isEarlier) addBlock();
                scene.loose("thing", at(0, 0, 0.05), massOfBox(1, size), {box("b", size, {}, 3)});
                if (!isWall && !isEarlier) addBlock();
                auto world = scene.build();
                QVERIFY(world);
                QVERIFY(world->push("thing/body", {way * 100, 0, 0}, {0, 0, 0.05}).ok()); // 1 m/s, less friction
                int found = 0;
                for (int k = 0; k < 6; ++k) {
                    QVERIFY(world->push("thing/body", {0, 20, 0}, position(*world, "thing/body")).ok() && world->tick().ok());
                    QVERIFY(way * velocity(*world, "thing/body").x() > 0.1);
                    for (const WorldContact& c : world->contacts()) {
                        if (c.normal.z() > 0.5 || c.force < 0.1) continue;
                        ++found;
                        const double sense = c.first.starts_with("thing/") ? -way : way;
                        QVERIFY2(sense * c.friction.x() > 0.1 * c.force, qPrintable(QString::number(c.friction.x())));
                    }
                }
                QVERIFY(found >= 4);
            }
    }

    /// A wheel's body turns with its joint, and where it touches the ground it stands still.
    void wheelsTurn() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3, 0);
        QVERIFY(run(*world, 1));
        const double angle = value(*world, "r/leftAxle/position");
        QVERIFY(angle > 5);
        QCOMPARE(value(*world, "r/leftMotor/position"), angle);
        QVERIFY(std::abs(value(*world, "r/leftAxle/rate") * kWheel - 0.3) < 1e-5);
        const double* pose = slot(*world, "r/leftWheel/pose");
        const Quat turned(pose[3], pose[4], pose[5], pose[6]);
        QVERIFY(turned.angularDistance(world->robotPose(0).rotation * Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))) < 1e-9);
        const Vec3 touch = velocity(*world, "r/leftWheel") + spin(*world, "r/leftWheel").cross(Vec3(0, 0, -kWheel));
        QVERIFY(touch.norm() < 1e-5);
        QVERIFY(std::abs(velocity(*world, "r/chassis").x() - 0.3) < 1e-5);
    }

    void leaving() {
        Scene scene = r0Scene();
        scene.spec->settings.engine = testedEngine();
        scene.scenery({box("table", {1, 1, 0.1}, at(0, 0, -0.05), 1)});
        scene.robot("r", {}, small()).robot("other", at(-0.3, 0.3, 0), small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3, 0);
        QVERIFY(run(*world, 3));
        QCOMPARE(world->robotFaults().ends.size(), std::size_t(1));
        QVERIFY(world->robotFaults().ends[0].fault.reason.find("leaves the ground") != std::string::npos);
        QVERIFY(std::abs(position(*world, "r/chassis").x() - 0.42) < 0.01); // its front slider is at the edge
        QVERIFY(value(*world, "r/leftAxle/position") > 5);
        QCOMPARE(value(*world, "r/leftAxle/rate"), 0.);
    }

    void placed() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3, 0);
        QVERIFY(run(*world, 1));
        QVERIFY(world->place("r", at(2, -1, 0, degrees(90, 0, 0))).ok());
        drive(*world, "r", 0, 0);
        QVERIFY(run(*world, 0.1));
        QVERIFY((world->robotPose(0).position - Vec3(2, -1, 0)).norm() < 1e-4);
        drive(*world, "r", 0.3, 0);
        QVERIFY(run(*world, 1));
        QVERIFY(world->robotPose(0).position.y() > -0.75);
    }

    /// Neither the order of the robots in the text nor anything far away changes a bit of it.
    void sameBits() {
        const auto crowd = [](bool backwards, bool more) {
            Scene scene = wheeledScene();
            for (int i = 0; i < 12; ++i) {
                const int k = backwards ? 11 - i : i;
                scene.robot("r" + std::string(1, char('a' + k)), at(0.3 * (k % 4), 0.3 * (k / 4), 0, degrees(37.0 * k, 0, 0)),
                            small());
            }
            if (more) scene.robot("z", at(40, 40, 0), small());
            return scene.build();
        };
        const auto one = crowd(false, false), two = crowd(true, false), three = crowd(false, true);
        QVERIFY(one && two && three);
        for (int k = 0; k < 600; ++k) {
            for (World* world : {one.get(), two.get(), three.get()}) {
                for (int i = 0; i < 12; ++i) drive(*world, "r" + std::string(1, char('a' + i)), 0.3);
                QVERIFY(world->tick().ok());
            }
        }
        QCOMPARE(one->stateHash(), two->stateHash());
        QVERIFY(one->contacts().size() > 40);
        for (int i = 0; i < 12; ++i) {
            const std::string chassis = "r" + std::string(1, char('a' + i)) + "/chassis";
            QVERIFY(position(*one, chassis) == position(*three, chassis));
        }
    }

    /// 60 s in a room: each robot ends where the general engine has it, as long as nothing is hit.
    void asGeneral() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        Scene other = inGeneral(scene);
        auto mine = scene.build(), theirs = other.build();
        QVERIFY(mine && theirs);
        for (int k = 0; k < 2000; ++k)
            for (World* world : {mine.get(), theirs.get()}) {
                const double t = 0.01 * k, left = 0.3 * std::sin(t) + 0.1, right = 0.25 * std::cos(0.7 * t) + 0.1;
                command(*world, "r/leftMotor", left / kWheel, kSoftness, kStall);
                command(*world, "r/rightMotor", right / kWheel, kSoftness, kStall);
                QVERIFY(world->tick().ok());
            }
        const Pose a = mine->robotPose(0), b = theirs->robotPose(0);
        const double off = (a.position - b.position).norm(), turned = a.rotation.angularDistance(b.rotation);
        qInfo("%.3f mm and %.4f degrees apart", 1e3 * off, turned * 180 / kPi);
        QVERIFY(off < 2e-3 && turned < 0.2 * kPi / 180);
    }
};

QTEST_APPLESS_MAIN(WheeledTest)
#include "wheeled_test.moc"
