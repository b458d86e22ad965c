// What symmetric scenes hide: centres of mass off the origin, six different moments, the second geom, surface and robot of a pair.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

double rad(double degrees) { return degrees * kPi / 180; }

/// A body without any symmetry: six different moments about a centre off its origin.
MassProperties lopsided() {
    const Mat3 r = rotationFromHpr(degrees(20, -35, 50)).toRotationMatrix();
    return {1.7, Vec3(0.21, -0.13, 0.34), Mat3(r * Vec3(0.02, 0.05, 0.06).asDiagonal() * r.transpose())};
}

/// Two bodies of one robot, its config frame apart from the first body's; thrown and turning.
Scene thrown(double tick, const Vec3& gravity) {
    Scene scene = r0Scene(tick);
    scene.spec->settings.gravity = gravity;
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("first", at(0.4, 0.3, -0.2, degrees(10, 20, 30)), lopsided(), {}));
    scene.robot("r", at(1, 2, 30, degrees(-40, 15, 70)), config);
    scene.loose("alone", at(-3, 1, 20, degrees(5, 50, -20)), lopsided(), {});
    return scene;
}

void throwAll(World& world) {
    const double h = world.experiment().settings.tick;
    QVERIFY(world.push("r/first", Vec3(1, -2, 1.5) / h, position(world, "r/first") + Vec3(0.3, 0.2, -0.4)).ok());
    QVERIFY(world.push("alone/body", Vec3(-1, 1, 2) / h, position(world, "alone/body") + Vec3(-0.2, 0.5, 0.1)).ok());
}

Pose poseOf(World& world, const std::string& path) {
    const double* p = slot(world, path + "/pose");
    return {Vec3(p), Quat(p[3], p[4], p[5], p[6])};
}

/// FNV-1a 64 over little-endian doubles, as world.h states it.
std::uint64_t fnv(const std::vector<double>& values) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const double value : values) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        for (int i = 0; i < 8; ++i) hash = (hash ^ (bits >> (8 * i) & 0xff)) * 0x100000001b3ull;
    }
    return hash;
}

/// A shape to collide, 0.2 m wide along x, at the origin of its body, turned so that nothing lines up with y and z.
GeomSpec shape(const std::string& name) {
    const Pose tilt{Vec3::Zero(), rotationFromHpr(degrees(0, 0, 37))}; // about x
    if (name == "sphere") return sphere("g", 0.1);
    if (name == "cylinder") return cylinder("g", 0.07, 0.2, {Vec3::Zero(), rotationFromHpr(degrees(0, 90, 0))});
    if (name == "capsule") {
        GeomSpec c = cylinder("g", 0.05, 0.1, {Vec3::Zero(), rotationFromHpr(degrees(0, 90, 0))});
        c.shape = GeomShape::Capsule;
        return c;
    }
    if (name == "hull") {
        auto mesh = std::make_shared<TriangleMesh>();
        for (int i = 0; i < 8; ++i) mesh->points.push_back({i & 1 ? 0.1 : -0.1, i & 2 ? 0.06 : -0.06, i & 4 ? 0.08 : -0.08});
        GeomSpec geom = box("g", {}, tilt);
        geom.shape = GeomShape::Convex;
        geom.mesh = mesh;
        geom.hull = mesh;
        geom.collideAsHull = true;
        return geom;
    }
    return box("g", {0.2, 0.12, 0.16}, tilt);
}

/// A robot with that shape centred at its origin: one body, or a wheel of radius 0.1 m on a hinge.
std::shared_ptr<RobotConfigSpec> robotOf(const std::string& name) {
    auto config = std::make_shared<RobotConfigSpec>();
    if (name != "wheel") {
        config->bodies.push_back(body("b", {}, massOfSphere(1, 0.1), {shape(name)}));
        return config;
    }
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    config->bodies.push_back(body("frame", at(0, 0.3, 0), massOfSphere(1, 0.1), {}));
    config->bodies.push_back(
        body("b", {}, massOfCylinder(1, 0.1, 0.04, sideways), {cylinder("g", 0.1, 0.04, {Vec3::Zero(), sideways})}));
    config->joints.push_back(joint("axle", JointType::Hinge, 0, 1, Vec3::Zero(), Vec3::UnitY()));
    return config;
}

} // namespace

class AsymmetryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// The hash is that of all published numbers, bodies in path order, so that no bit of any can change without it.
    void hashIsThatOfThePublishedStates() {
        Scene scene = thrown(0.01, {0.1, -0.2, -g});
        for (const char* name : {"r10", "r2", "q"}) scene.robot(name, at(5, double(name[1]), 5), r0());
        auto world = scene.build();
        throwAll(*world);
        for (const int ticks : {0, 1, 7}) {
            for (int i = 0; i < ticks; ++i) QVERIFY(world->tick().ok());
            std::map<std::string, std::vector<double>> bodies;
            for (const RobotSpec& robot : scene.spec->robots)
                for (const BodySpec& b : robot.config->bodies) {
                    const std::string path = robot.name + "/" + b.name;
                    std::vector<double>& numbers = bodies[path];
                    numbers.assign(slot(*world, path + "/pose"), slot(*world, path + "/pose") + 7);
                    numbers.insert(numbers.end(), slot(*world, path + "/velocity"), slot(*world, path + "/velocity") + 6);
                }
            std::vector<double> all;
            for (const auto& [path, numbers] : bodies) all.insert(all.end(), numbers.begin(), numbers.end());
            QCOMPARE(all.size(), std::size_t{13 * 11});
            QCOMPARE(world->stateHash(), fnv(all));
        }
    }

    /// The published velocity of each frame is the change of its published position, and its spin the change of its rotation.
    void velocityIsTheChangeOfPosition() {
        const double h = 1e-4;
        auto world = thrown(h, {0.5, 0.3, -g}).build();
        throwAll(*world);
        QVERIFY(run(*world, 0.05));
        for (int i = 0; i < 20; ++i) {
            std::map<std::string, Pose> before;
            for (const char* path : {"r", "r/first", "alone", "alone/body"}) before[path] = poseOf(*world, path);
            QVERIFY(run(*world, 10 * h));
            std::map<std::string, std::pair<Vec3, Vec3>> rates;
            for (const auto& [path, pose] : before) rates[path] = {velocity(*world, path), spin(*world, path)};
            QVERIFY(run(*world, 10 * h));
            for (const auto& [path, from] : before) {
                const Pose to = poseOf(*world, path);
                const Vec3 v = (to.position - from.position) / (20 * h);
                QVERIFY2((v - rates[path].first).norm() < 2e-3 * v.norm(), path.c_str());
                const Eigen::AngleAxisd turned(to.rotation * from.rotation.conjugate());
                const Vec3 w = turned.angle() / (20 * h) * turned.axis();
                QVERIFY2((w - rates[path].second).norm() < 2e-3 * w.norm(), path.c_str());
            }
        }
    }

    /// Without gravity a thrown body keeps the velocity of its centre of mass, its angular momentum and its energy.
    void keepsMomentumAndEnergy() {
        auto world = thrown(1e-4, Vec3::Zero()).build();
        throwAll(*world);
        QVERIFY(world->tick().ok());
        const MassProperties m = lopsided();
        const auto centreSpeed = [&](const std::string& path) {
            return Vec3(velocity(*world, path) + spin(*world, path).cross(poseOf(*world, path).rotation * m.centre));
        };
        const auto momentum = [&](const std::string& path) {
            const Mat3 r = poseOf(*world, path).rotation.toRotationMatrix();
            return Vec3(r * m.inertia * r.transpose() * spin(*world, path));
        };
        const char* const paths[] = {"r/first", "alone/body"};
        std::map<std::string, std::pair<Vec3, Vec3>> start;
        double energy[2];
        for (const char* path : paths) start[path] = {centreSpeed(path), momentum(path)};
        for (std::size_t i = 0; i < 2; ++i) energy[i] = world->robotEnergy(i).kinetic;
        QVERIFY((start["r/first"].first - Vec3(1, -2, 1.5) / m.mass).norm() < 1e-9); // what the push gives
        QVERIFY(run(*world, 0.5));
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& [speed, turning] = start[paths[i]];
            QVERIFY((centreSpeed(paths[i]) - speed).norm() < 1e-9);
            QVERIFY2((momentum(paths[i]) - turning).norm() < 2e-2 * turning.norm(),
                     paths[i]); // ODE's integrator is of first order
            const RobotEnergy now = world->robotEnergy(i);
            QVERIFY(std::abs(now.kinetic / energy[i] - 1) < 2e-2);
            const double spinning = spin(*world, paths[i]).dot(momentum(paths[i]));
            QVERIFY(std::abs(now.kinetic - 0.5 * (m.mass * speed.squaredNorm() + spinning)) < 1e-9);
        }
    }

    /// What a push does about the centre: a change of angular momentum of lever x force, and the potential energy is that of the centre.
    void pushesAboutTheCentre() {
        const double h = 1e-5;
        auto world = thrown(h, {3, -2, -g}).build();
        const Pose pose = poseOf(*world, "alone/body");
        const MassProperties m = lopsided();
        const Vec3 centre = pose * m.centre, force(1000, 2000, -500), point = centre + Vec3(0.1, -0.3, 0.2);
        QVERIFY(std::abs(world->robotEnergy(1).potential + m.mass * Vec3(3, -2, -g).dot(centre)) < 1e-9);
        QVERIFY(world->push("alone/body", force, point).ok());
        QVERIFY(world->tick().ok());
        const Mat3 r = pose.rotation.toRotationMatrix();
        const Vec3 w = r * m.inertia.inverse() * r.transpose() * (h * (point - centre).cross(force));
        QVERIFY((spin(*world, "alone/body") - w).norm() < 1e-3 * w.norm());
    }

    void normals_data() {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        const QStringList shapes{"box", "sphere", "cylinder", "capsule", "hull", "wheel"};
        for (const QString& one : shapes)
            for (const QString& other : shapes) QTest::addRow("%s and %s", qPrintable(one), qPrintable(other)) << one << other;
    }
    /// Two shapes that overlap by 2 mm along x and are pressed together: every normal points towards the first geom, and both move apart,
    /// whichever is listed first.
    void normals() {
        QFETCH(QString, one);
        QFETCH(QString, other);
        Scene scene(0.002);
        scene.spec->settings.gravity = Vec3::Zero();
        scene.robot("left", at(1, 2, 3), robotOf(one.toStdString()))
            .robot("right", at(1.198, 2.003, 3.004), robotOf(other.toStdString()));
        auto world = scene.build();
        QVERIFY(world->push("left/b", {50, 0, 0}, {1, 2, 3}).ok());
        QVERIFY(world->push("right/b", {-50, 0, 0}, {1.198, 2.003, 3.004}).ok());
        QVERIFY(world->tick().ok());
        QVERIFY(!world->contacts().empty());
        for (const WorldContact& c : world->contacts()) {
            const double side = c.first.starts_with("left") ? -1 : 1;
            QVERIFY2(side * c.normal.x() > 0.9, qPrintable(QString::number(c.normal.x())));
            QVERIFY(std::abs(c.position.x() - 1.099) < 0.01 && c.depth > 1e-3 && c.force > 0);
        }
        QVERIFY(position(*world, "left/b").x() < 1 - 1e-5 && position(*world, "right/b").x() > 1.198 + 1e-5);
    }

    /// The same against scenery: the floor, a wall, a block.
    void normalsOfScenery() {
        for (const std::string name : {"box", "sphere", "cylinder", "capsule", "hull", "wheel"}) {
            Scene scene(0.002);
            scene.spec->settings.gravity = Vec3::Zero();
            scene.scenery({box("block", {0.2, 1, 1}, at(0.2, 0, 0))}, at(1.098, 2, 3))
                .robot("left", at(1.1, 2, 3), robotOf(name));
            auto world = scene.build();
            QVERIFY(world->tick().ok());
            QVERIFY(!world->contacts().empty());
            for (const WorldContact& c : world->contacts())
                QVERIFY2(c.normal.x() < -0.9 && c.second == "arena/block", name.c_str());
            QVERIFY2(position(*world, "left/b").x() < 1.1 - 1e-5, name.c_str());
        }
    }

    void surfaces_data() {
        QTest::addColumn<QString>("property");
        QTest::addColumn<bool>("live");
        for (const char* property : {"friction", "restitution", "rolling", "softness"})
            for (const bool live : {false, true}) QTest::addRow("%s%s", property, live ? ", set live" : "") << property << live;
    }
    /// A property on the ball alone, on what it meets alone, and on a movable body below: each counts the same, and counts at all.
    void surfaces() {
        QFETCH(QString, property);
        QFETCH(bool, live);
        const auto values =
            [&](bool has) { // friction: the smaller holds; restitution and rolling friction: the larger; softness: the sum
                SurfaceSpec s{"", 0.9, 0, 0, 0, {}};
                if (property == "friction") s.friction = has ? 0.1 : 0.9;
                if (property == "restitution") s.restitution = has ? 0.7 : 0.2;
                if (property == "rolling") s.rollingFriction = has ? 0.01 : 0;
                if (property == "softness") s.softness = has ? 1e-3 : 0;
                return s;
            };
        const auto endOf = [&](bool ballHas, bool groundHas, bool movable) {
            Scene scene(0.005);
            for (const bool has : {ballHas, groundHas}) {
                SurfaceSpec s = live ? SurfaceSpec{} : values(has);
                s.name = "s" + std::to_string(scene.spec->surfaces.size());
                scene.spec->surfaces.push_back(s);
            }
            const Vec3 size(4, 4, 0.2);
            if (movable) { // a body, held by a joint
                auto config = std::make_shared<RobotConfigSpec>();
                config->bodies.push_back(body("slab", {}, massOfBox(200, size), {box("top", size, {}, 2)}));
                config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, Vec3::Zero(), Vec3::UnitZ()));
                scene.robot("ground", at(0, 0, 0.1), config);
            } else scene.scenery({box("top", size, at(0, 0, 0.1), 2)}, {}, "ground");
            scene.ball("ball", {0, 0, 0.3 + (property == "restitution" ? 0.3 : -1e-5)}, 1, 0.1, 1);
            auto world = scene.build();
            if (live)
                for (std::size_t i : {1, 2}) {
                    SurfaceSpec s = values(i == 1 ? ballHas : groundHas);
                    s.name = "s" + std::to_string(i);
                    if (!world->setSurface(s).ok()) return Vec3(Vec3::Constant(1e9));
                }
            if (!world->push("ball/body", Vec3(0.6, 0.8, 0) / 0.005, position(*world, "ball/body")).ok() || !run(*world, 0.5))
                return Vec3(Vec3::Constant(1e9));
            return Vec3(position(*world, "ball/body") + velocity(*world, "ball/body") + 0.1 * spin(*world, "ball/body"));
        };
        const Vec3 neither = endOf(false, false, false), ball = endOf(true, false, false), ground = endOf(false, true, false);
        QVERIFY(neither.allFinite() && (ball - neither).norm() > 1e-3);
        QVERIFY((ball - ground).norm() < 1e-9);
        const Vec3 movable = endOf(true, false, true), below = endOf(false, true, true);
        QVERIFY((movable - below).norm() < 1e-9 && (movable - endOf(false, false, true)).norm() > 1e-5);
        // Both together: only softness adds up.
        QCOMPARE((endOf(true, true, false) - ball).norm() > 1e-6, property == "softness");
    }

    /// Two different robots that meet: the same motion whichever is listed first.
    void orderOfRobots() {
        const auto meeting = [](bool swapped) {
            Scene scene = r0Scene(0.005);
            scene.scenery({plane("floor", {}, 1)});
            const auto wheels = [&] { scene.robot("wheels", at(0, 0, 0), r0()); };
            const auto crate = [&] {
                scene.loose("crate", at(0.23, 0.02, 0.04, degrees(7, 0, 0)), massOfBox(0.4, {0.1, 0.2, 0.08}),
                            {box("crate", {0.1, 0.2, 0.08}, {}, 3)});
            };
            if (swapped) {
                crate();
                wheels();
            } else {
                wheels();
                crate();
            }
            auto world = scene.build();
            for (int i = 0; i < 120; ++i) {
                command(*world, "wheels/leftMotor", 4, 0, 5.4);
                command(*world, "wheels/rightMotor", 4, 0, 5.4);
                if (!world->tick()) return std::vector<double>{};
            }
            std::vector<double> end;
            for (const char* path : {"wheels/chassis", "crate/body"})
                end.insert(end.end(), slot(*world, std::string(path) + "/pose"), slot(*world, std::string(path) + "/pose") + 7);
            return end;
        };
        const std::vector<double> a = meeting(false), b = meeting(true);
        QVERIFY(a.size() == 14 && b.size() == 14);
        QVERIFY2(a[7] > 0.27, "the crate was to be pushed");
        for (std::size_t i = 0; i < a.size(); ++i)
            QVERIFY2(std::abs(a[i] - b[i]) < 1e-4, qPrintable(QString::number(a[i] - b[i])));
    }

    /// A wheel where a floor of triangles bends by 20 degrees touches both faces.
    void wheelInABendOfAMesh() {
        const double bend = rad(20), radius = 0.1, deep = 1e-3;
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->points = {{-1, -1, 0}, {0, -1, 0}, {1, -1, std::tan(bend)}, {-1, 1, 0}, {0, 1, 0}, {1, 1, std::tan(bend)}};
        mesh->triangles = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}};
        GeomSpec floor = plane("mesh", {}, 0);
        floor.shape = GeomShape::Mesh;
        floor.mesh = mesh;
        for (const double inRamp : {0.4e-3, 1.6e-3}) {
            const double x = -(radius - inRamp - (radius - deep) * std::cos(bend)) / std::sin(bend);
            Scene scene(0.002);
            scene.spec->settings.gravity = Vec3::Zero();
            scene.scenery({floor}).robot("r", at(x, 0.1, radius - deep), robotOf("wheel"));
            auto world = scene.build();
            QVERIFY(world->tick().ok());
            QCOMPARE(world->contacts().size(), std::size_t(2));
            for (const auto& c : world->contacts()) {
                const double leans = std::atan2(-c.normal.x(), c.normal.z());
                QVERIFY2(std::abs(c.depth - (leans < rad(10) ? deep : inRamp)) < 1e-5, qPrintable(QString::number(c.depth)));
                QVERIFY2(std::min(std::abs(leans), std::abs(leans - bend)) < 1e-6, qPrintable(QString::number(leans)));
            }
        }
    }

    /// What lies on a slope too steep for it starts down it in its first tick, whatever way the slope falls.
    void startsDownTheSlopeAtOnce() {
        const double h = 0.005, friction = 0.5, angle = std::atan(friction) + rad(5);
        for (const double heading : {0.0, 30.0, 45.0, 160.0, 250.0}) {
            Scene scene(h);
            const Vec3 down(std::cos(rad(heading)), std::sin(rad(heading)), 0);
            scene.spec->settings.gravity = g * (std::sin(angle) * down - std::cos(angle) * Vec3::UnitZ());
            const auto surface = scene.surface(friction);
            scene.scenery({plane("floor", {}, surface)});
            scene.loose("crate", at(0.3, -0.2, 0.025 - 1e-9), massOfBox(2, {0.3, 0.2, 0.05}),
                        {box("b", {0.3, 0.2, 0.05}, {}, surface)});
            auto world = scene.build();
            QVERIFY(world->tick().ok());
            const double a = velocity(*world, "crate/body").dot(down) / h,
                         expected = g * (std::sin(angle) - friction * std::cos(angle));
            const double aside = (velocity(*world, "crate/body") / h - a * down).head<2>().norm();
            // Within 3 % of its weight: it settles into the floor while it starts.
            QVERIFY2(std::abs(a - expected) < 0.03 * g && aside < 0.01 * g,
                     qPrintable(QStringLiteral("%1: %2 for %3, aside %4").arg(heading).arg(a).arg(expected).arg(aside)));
        }
    }

    /// A servo that holds an arm: the torque of its weight about the axis, wherever anchor, frame and centre of mass are.
    /// More columns than rows and the reverse: each quarter is level and has a height of its own.
    void ballsRestOnAHeightfieldThatIsNotSquare() {
        for (const bool isWide : {true, false}) {
            const std::uint32_t columns = isWide ? 6 : 4, rows = isWide ? 4 : 6; // 1 m apart
            const auto heightOf = [](bool isEast, bool isSouth) { return (isEast ? 0.2 : 0) + (isSouth ? 0.4 : 0) + 0.2; };
            auto map = std::make_shared<HeightMap>();
            map->columns = columns;
            map->rows = rows;
            for (std::uint32_t row = 0; row < rows; ++row)
                for (std::uint32_t column = 0; column < columns; ++column)
                    map->heights.push_back(static_cast<float>(heightOf(2 * column >= columns, 2 * row >= rows)));
            GeomSpec hills = plane("hills");
            hills.shape = GeomShape::Heightfield;
            hills.size = {columns - 1., rows - 1., 1};
            hills.heightMap = map;
            Scene scene;
            scene.scenery({hills});
            const double x = isWide ? 1.7 : 1.1, y = isWide ? 1.1 : 1.7; // the first row is at +y
            for (const bool isEast : {false, true})
                for (const bool isSouth : {false, true}) {
                    const std::string name = std::string("b") + (isSouth ? "South" : "North") + (isEast ? "East" : "West");
                    scene.ball(name, {isEast ? x : -x, isSouth ? -y : y, heightOf(isEast, isSouth) + 0.12}, 1, 0.1);
                }
            auto world = scene.build();
            QVERIFY(world && run(*world, 1));
            for (const bool isEast : {false, true})
                for (const bool isSouth : {false, true}) {
                    const std::string name = std::string("b") + (isSouth ? "South" : "North") + (isEast ? "East" : "West");
                    const Vec3 found = position(*world, name + "/body");
                    const Vec3 expected(isEast ? x : -x, isSouth ? -y : y, heightOf(isEast, isSouth) + 0.1);
                    QVERIFY2((found - expected).norm() < 0.01, (name + " is at " + std::to_string(found.z())).c_str());
                }
        }
    }

    void effortOfAHeldArm_data() {
        QTest::addColumn<double>("softness");
        QTest::addColumn<double>("tilt");
        for (const double softness : {0.0, 1e-4})
            for (const double tilt : {0.0, 25.0}) QTest::addRow("softness %g, %g deg", softness, tilt) << softness << tilt;
    }
    void effortOfAHeldArm() {
        QFETCH(double, softness);
        QFETCH(double, tilt);
        const Vec3 axis = Vec3(0.2, 1, 0.1).normalized(), anchor(0.3, -0.2, 1.1);
        const Pose armPose = at(0.5, 0.1, 1.3, degrees(30, tilt, -20));
        const MassProperties m = lopsided();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("base", at(0, 0, 1), massOfBox(5, {0.1, 0.1, 0.1}), {}));
        config->bodies.push_back(body("arm", armPose, m, {}));
        config->joints.push_back(joint("hold", JointType::Fixed, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()));
        config->joints.push_back(joint("j", JointType::Hinge, 0, 1, anchor, axis));
        config->devices.push_back(row("motor", "j"));
        Scene scene(0.001);
        scene.robot("r", {}, config);
        auto world = scene.build();
        command(*world, "r/motor", 0, softness, 1000);
        QVERIFY(run(*world, 0.02));
        const Vec3 weight = m.mass * Vec3(0, 0, -g);
        const double expected = -axis.dot((poseOf(*world, "r/arm") * m.centre - anchor).cross(weight));
        QVERIFY(std::abs(expected) > 1);
        QVERIFY2(std::abs(value(*world, "r/motor/effort") / expected - 1) < 5e-3,
                 qPrintable(QString::number(value(*world, "r/motor/effort") / expected)));
    }
};

QTEST_APPLESS_MAIN(AsymmetryTest)
#include "asymmetry_test.moc"
