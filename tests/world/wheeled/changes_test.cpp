// What changes during a run of the wheeled engine, and which of two bodies is named first: nothing of before stays, and no order matters.
// What a robot touches that leans. Edges of the ground, and what is refused before a run.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kWheel = 0.04, kStrong = 2; // m, N m

/// Of the test that runs.
EngineChoice testedEngine() {
    QFETCH_GLOBAL(QString, engine);
    return engine == "planar" ? EngineChoice::Planar : EngineChoice::Wheeled;
}

/// Surfaces: 1 of tyres and floor, 2 slick, 3 of hulls.
Scene wheeledScene(double friction = 1) {
    Scene scene = r0Scene(0.01, friction);
    scene.spec->settings.engine = testedEngine();
    scene.scenery({plane("floor", {}, 1)});
    return scene;
}

/// A robot of 0.2 m x 0.15 m on two wheels and two sliders; `scale` makes it smaller.
std::shared_ptr<RobotConfigSpec> small(std::uint32_t hullSurface = 3, double scale = 1) {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 hull = scale * Vec3(0.2, 0.15, 0.06), centre = scale * Vec3(0, 0, 0.05);
    const double ball = scale * 0.02, radius = scale * kWheel, width = scale * 0.02;
    config->bodies.push_back(
        body("chassis", {}, massOfBox(1.5, hull, centre),
             {box("hull", hull, {centre, Quat::Identity()}, hullSurface), sphere("front", ball, at(scale * 0.08, 0, ball), 2),
              sphere("rear", ball, at(scale * -0.08, 0, ball), 2)}));
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    for (const int side : {1, -1}) {
        const std::string name = side > 0 ? "left" : "right";
        const Vec3 hub(0, scale * side * 0.065, radius);
        config->bodies.push_back(body(name + "Wheel", {hub, Quat::Identity()}, massOfCylinder(0.1, radius, width, sideways),
                                      {cylinder("tyre", radius, width, {Vec3::Zero(), sideways}, 1)}));
        config->joints.push_back(joint(name + "Axle", JointType::Hinge, 0, side > 0 ? 1 : 2, hub, Vec3::UnitY()));
        config->devices.push_back(row(name + "Motor", name + "Axle"));
    }
    return config;
}

/// With 3 kg on a mast: its centre of mass is 0.78 m high.
std::shared_ptr<RobotConfigSpec> tall() {
    auto config = small();
    const Vec3 size(0.1, 0.1, 0.1);
    config->bodies.push_back(body("mast", at(0, 0, 1.2), massOfBox(3, size), {box("top", size, {}, 3)}));
    config->joints.push_back(joint("mount", JointType::Fixed, 0, 3, {0, 0, 1}, Vec3::UnitZ()));
    return config;
}

/// Of 1 m along y, with this outline over x and z.
GeomSpec convex(const std::vector<std::pair<double, double>>& outline) {
    auto mesh = std::make_shared<TriangleMesh>();
    for (const auto& [x, z] : outline)
        for (const double y : {-0.5, 0.5}) mesh->points.push_back({x, y, z});
    const auto count = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % count);
        mesh->triangles.push_back({a, b, a + 1});
        mesh->triangles.push_back({b, b + 1, a + 1});
        if (k == 0 || k + 1 == count) continue;
        mesh->triangles.push_back({0, a, b});
        mesh->triangles.push_back({1, b + 1, a + 1});
    }
    GeomSpec geom = box("block", {}, at(3, 0, 0));
    geom.shape = GeomShape::Convex;
    geom.mesh = geom.hull = mesh;
    geom.collideAsHull = true;
    return geom;
}

/// A box of 0.1 m that is fixed to the world.
std::shared_ptr<RobotConfigSpec> post() {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 size(0.1, 0.1, 0.1);
    config->bodies.push_back(body("post", at(0, 0, 0.05), massOfBox(1, size), {box("b", size)}));
    config->joints.push_back(joint("mount", JointType::Fixed, kWorldBody, 0, {}, Vec3::UnitZ()));
    return config;
}

/// Why it cannot be built; empty where it can.
std::string refusalOf(Scene& scene) {
    Diagnostics diagnostics;
    if (scene.build(rowOnly, diagnostics)) return {};
    std::string text;
    for (const Diagnostic& each : diagnostics.all()) text += each.message + "\n";
    return text;
}

bool has(const std::string& text, const QString& part) { return QString::fromStdString(text).contains(part); }

void drive(World& world, const std::string& robot, double speed, double limit = kStrong) {
    for (const char* motor : {"/leftMotor", "/rightMotor"}) command(world, robot + motor, speed / kWheel, 0, limit);
}

} // namespace

class WheeledChangesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase_data() {
        QTest::addColumn<QString>("engine");
        for (const char* engine : {"wheeled", "planar"}) QTest::newRow(engine) << engine;
    }

    /// A robot that is placed while it drives is as one that starts there: its wheels and all that moves are at rest.
    void placedAtRest() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.5);
        QVERIFY(run(*world, 1));
        QVERIFY(value(*world, "r/leftAxle/rate") > 10);
        QVERIFY(world->place("r", at(2, -1, 0, degrees(90, 0, 0))).ok());
        drive(*world, "r", 0, 0); // its motors are off
        QVERIFY(run(*world, 0.01));
        for (const char* axle : {"r/leftAxle/rate", "r/rightAxle/rate"}) QVERIFY(std::abs(value(*world, axle)) < 1e-3);
        QVERIFY(run(*world, 1));
        QVERIFY((world->robotPose(0).position - Vec3(2, -1, 0)).norm() < 1e-4);
        for (const char* body : {"r/chassis", "r/leftWheel"}) QVERIFY(velocity(*world, body).norm() < 1e-4);
    }

    void surfacesThatChange_data() {
        QTest::addColumn<double>("friction");
        for (const double friction : {0., 0.1, 0.4, 2.}) QTest::addRow("%g", friction) << friction;
    }
    /// Friction that changes before the robot starts is as if it had always been that.
    void surfacesThatChange() {
        QFETCH(double, friction);
        Scene scene = wheeledScene(), always = wheeledScene(friction);
        std::vector<std::unique_ptr<World>> worlds;
        for (Scene* each : {&scene, &always}) {
            each->robot("r", {}, small())
                .robot("of another config", at(0, 3, 0), std::make_shared<RobotConfigSpec>(*small()))
                .loose("thing", at(1, 0, 0.05), massOfBox(1, {0.1, 0.1, 0.1}), {box("b", {0.1, 0.1, 0.1}, {}, 1)});
            worlds.push_back(each->build());
            QVERIFY(worlds.back());
        }
        SurfaceSpec changed = scene.spec->surfaces[1];
        changed.friction = friction;
        QVERIFY(worlds[0]->setSurface(changed).ok());
        double gone[2] = {}, other[2] = {};
        for (std::size_t i = 0; i < 2; ++i) {
            drive(*worlds[i], "r", 2);
            drive(*worlds[i], "of another config", 2);
            QVERIFY(worlds[i]->push("thing/body", {0, 60, 0}, {1, 0, 0.05}).ok());
            QVERIFY(run(*worlds[i], 0.4));
            gone[i] = worlds[i]->robotPose(0).position.x();
            other[i] = worlds[i]->robotPose(1).position.x();
        }
        QVERIFY2(gone[0] == gone[1], qPrintable(QString::number(gone[0] - gone[1])));
        QVERIFY2(other[0] == other[1], qPrintable(QString::number(other[0] - other[1])));
        QVERIFY(position(*worlds[0], "thing/body") == position(*worlds[1], "thing/body"));
        QVERIFY((friction == 0) == (gone[0] < 0.01));
    }

    void bothSurfacesCount_data() {
        QTest::addColumn<bool>("isRobot"); // what the robot runs into
        QTest::newRow("wall") << false;
        QTest::newRow("robot") << true;
    }
    /// The lower friction of the two holds, whichever of them has it and whichever is named first.
    void bothSurfacesCount() {
        QFETCH(bool, isRobot);
        const auto along = [&](std::uint32_t own, std::uint32_t other, bool isLast) {
            Scene scene = wheeledScene();
            const auto addOther = [&] {
                const GeomSpec foot = box("foot", {0.05, 3, 0.01}, at(0, 0, -0.095), 1),
                               rail = box("rail", {0.1, 3, 0.18}, at(0, 0, 0.01), other);
                if (isRobot) scene.loose("thing", at(0.2, 0, 0.1), massOfBox(60, {0.1, 3, 0.2}), {foot, rail});
                else scene.scenery({box("wall", {0.1, 3, 0.2}, at(0.2, 0, 0.1), other)}, {}, "room");
            };
            if (isLast) addOther();
            scene.robot("r", at(0, 0, 0, degrees(60, 0, 0)), small(own));
            if (!isLast) addOther();
            auto world = scene.build();
            if (!world) return 0.;
            drive(*world, "r", 0.5, 0.2);
            (void)run(*world, 2);
            return position(*world, "r/chassis").y();
        };
        const double slick = along(2, 2, false), rough = along(1, 1, false);
        QVERIFY2(slick > rough + 0.02, qPrintable(QString::number(slick) + ' ' + QString::number(rough)));
        for (const bool isLast : {false, true}) {
            QVERIFY(std::abs(along(1, 2, isLast) - slick) < 1e-3);
            QVERIFY(std::abs(along(2, 1, isLast) - slick) < 1e-3);
        }
    }

    /// A robot that has ended stands still, in all that is measured of it.
    void endedAtRest() {
        Scene scene = r0Scene();
        scene.spec->settings.engine = testedEngine();
        scene.scenery({box("table", {1, 1, 0.1}, at(0, 0, -0.05), 1)});
        scene.robot("r", {}, small()).robot("other", at(-0.3, 0.3, 0), small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3);
        QVERIFY(run(*world, 1));
        QVERIFY(velocity(*world, "r/chassis").norm() > 0.2);
        QVERIFY(run(*world, 2));
        QCOMPARE(world->robotFaults().ends.size(), std::size_t(1));
        for (const char* body : {"r/chassis", "r/leftWheel", "r/rightWheel"})
            QVERIFY(velocity(*world, body).isZero(0) && spin(*world, body).isZero(0));
        QCOMPARE(value(*world, "r/leftAxle/rate"), 0.0);
        QVERIFY(velocity(*world, "other/chassis").norm() < 1e-6);
    }

    void touchesWhereItLeans_data() {
        QTest::addColumn<bool>("isHeld"); // by a wall that its top is at
        QTest::newRow("wall at its top") << true;
        QTest::newRow("nothing at its top") << false;
    }
    /// Its hull ends at x = 0.11 and its top at x = 0.456; what is below its centre of mass, around x = 0.26, touches nothing.
    void touchesWhereItLeans() {
        QFETCH(bool, isHeld);
        if (testedEngine() == EngineChoice::Planar) return; // its robots do not lean
        Scene scene = wheeledScene();
        if (isHeld) scene.scenery({box("wall", {0.1, 2, 2}, at(0.5, 0, 1), 3)}, {}, "room");
        scene.robot("r", {}, tall()).robot("other", at(-1, 1, 0), small());
        scene.loose("thing", at(0.25, 0, 0.05), massOfBox(1, {0.1, 0.2, 0.1}), {box("b", {0.1, 0.2, 0.1}, {}, 1)});
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->place("r", at(0, 0, 0.03, degrees(0, 19, 0))).ok());
        QVERIFY(world->tick().ok());
        bool touchesWall = false;
        for (const WorldContact& c : world->contacts()) {
            QVERIFY(!c.first.starts_with("thing/") || !c.second.starts_with("r/"));
            QVERIFY(!c.first.starts_with("r/") || !c.second.starts_with("thing/"));
            if (c.second != "room/wall") continue;
            touchesWall = true;
            QVERIFY(c.first == "r/mast/top" && c.position.z() > 1.1 && c.depth < 0.015);
        }
        QCOMPARE(touchesWall, isHeld);
        if (isHeld) return;
        QVERIFY(run(*world, 1));
        QVERIFY(position(*world, "thing/body") == Vec3(0.25, 0, 0.05));
        QCOMPARE(world->robotFaults().ends.size(), std::size_t(1));
        const std::string& reason = world->robotFaults().ends[0].fault.reason;
        QVERIFY2(reason.find("leans") != std::string::npos && reason.find("deep") == std::string::npos, reason.c_str());
    }

    /// A wheel has one axle, and nothing else that holds it or hangs on it.
    void aWheelHasOneAxle() {
        for (const JointType type : {JointType::Hinge, JointType::Ball, JointType::Slider, JointType::Fixed})
            for (const bool isWithWorld : {false, true}) {
                const auto config = std::make_shared<RobotConfigSpec>(*small());
                JointSpec more = config->joints.front();
                more.name = "more";
                more.type = type;
                if (isWithWorld) more.parent = kWorldBody;
                config->joints.push_back(more);
                Scene scene = wheeledScene();
                scene.robot("r", {}, config);
                QVERIFY(!scene.build());
            }
    }

    /// Robots of one config are read each at its own height: one that is in the air is refused, first or last.
    void robotsOfOneConfigAtTheirHeights() {
        for (const bool isFirst : {false, true}) {
            Scene scene = wheeledScene();
            const auto config = small();
            scene.robot("a", at(0, 0, isFirst ? 0.05 : 0), config).robot("b", at(1, 0, isFirst ? 0 : 0.05), config);
            QVERIFY(!scene.build());
        }
        Scene scene = wheeledScene();
        const auto config = small();
        scene.robot("a", {}, config).robot("b", at(1, 0, 0), config);
        QVERIFY(scene.build());
    }

    void edgesBeforeARun_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<QString>("said");
        QTest::newRow("inside") << 0.41 << 0.43 << "";
        QTest::newRow("a slider beyond") << 0.45 << 0.0 << "r: geom front is beyond the edge of the ground";
        QTest::newRow("a wheel beyond") << 0.0 << 0.45 << "r: wheel leftWheel is beyond the edge of the ground";
        QTest::newRow("all of it beyond") << 2.0 << 0.0 << "r: there is no level ground below it";
    }
    /// On a table of 1 m x 1 m.
    void edgesBeforeARun() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(QString, said);
        Scene scene = r0Scene();
        scene.spec->settings.engine = testedEngine();
        scene.scenery({box("table", {1, 1, 0.1}, at(0, 0, -0.05), 1)});
        scene.robot("r", at(x, y, 0), small()).robot("other", at(-0.3, -0.3, 0), small());
        const std::string refusal = refusalOf(scene);
        QVERIFY2(said.isEmpty() ? refusal.empty() : has(refusal, said), refusal.c_str());
    }

    void gapsInTheGround_data() {
        QTest::addColumn<double>("gap"); // m
        QTest::addColumn<bool>("isCrossed");
        QTest::newRow("wide") << 0.1 << false;
        QTest::newRow("narrow") << 0.0015 << true;
    }
    /// It leaves the ground as soon as its front slider does.
    void gapsInTheGround() {
        QFETCH(double, gap);
        QFETCH(bool, isCrossed);
        Scene scene = r0Scene();
        scene.spec->settings.engine = testedEngine();
        for (const double side : {-1., 1.})
            scene.scenery({box("table", {1, 1, 0.1}, at(side * (0.5 + gap / 2), 0, -0.05), 1)}, {}, side < 0 ? "west" : "east");
        scene.robot("r", at(-0.5, 0, 0), small()).robot("other", at(-0.3, 0.3, 0), small());
        auto world = scene.build();
        QVERIFY(world);
        drive(*world, "r", 0.3);
        QVERIFY(run(*world, 3));
        const double x = position(*world, "r/chassis").x();
        QCOMPARE(world->robotFaults().ends.empty(), isCrossed);
        QVERIFY2(isCrossed ? x > 0.3 : std::abs(x + gap / 2 + 0.08) < 0.01, qPrintable(QString::number(x)));
    }

    /// Neither the names of robots nor something fixed elsewhere decide which ground it is; Auto is general where one has none.
    void groundWhateverTheNames() {
        for (const char* name : {"a", "z"}) {
            Scene scene = r0Scene();
            scene.spec->settings.engine = testedEngine();
            scene.scenery({box("table", {1, 1, 0.1}, at(0, 0, -0.05), 1)});
            scene.robot("m", at(5, 0, 0), small()).robot(name, {}, small());
            QVERIFY(has(refusalOf(scene), "m: there is no level ground below it"));
            scene.spec->settings.engine = EngineChoice::Auto;
            const auto world = scene.build();
            QVERIFY(world);
            QVERIFY(world->experiment().settings.engine == EngineChoice::General);
            QVERIFY(world->experiment().settings.whyGeneral == "m: there is no level ground below it");
        }
        for (const char* name : {"a", "z"}) {
            Scene scene = r0Scene();
            scene.spec->settings.engine = testedEngine();
            scene.scenery({box("table", {1, 1, 0.1}, at(0, 0, -0.05), 1), plane("floor", at(0, 0, -1), 1)});
            scene.robot(name, at(3, 0, -1), post()).robot("m", {}, small());
            const auto world = scene.build();
            QVERIFY(world && run(*world, 0.1));
            QVERIFY(std::abs(position(*world, "m/chassis").z()) < 1e-3);
        }
    }

    void sceneryThatRobotsMeet_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<QString>("said");
        int shape = 0;
        for (const char* name : {"wedge", "funnel", "leaning box"}) QTest::newRow(name) << shape++ << "slopes or overhangs";
        QTest::newRow("dome") << shape++ << "has its middle below the ground";
        for (const char* name : {"house", "box on its side", "ball", "roof above all"}) QTest::newRow(name) << shape++ << "";
    }
    void sceneryThatRobotsMeet() {
        QFETCH(int, shape);
        QFETCH(QString, said);
        const GeomSpec shapes[] = {convex({{0, 0}, {1, 0}, {1, 0.2}}),
                                   convex({{-0.05, 0}, {0.05, 0}, {0.5, 0.3}, {-0.5, 0.3}}),
                                   box("block", {0.5, 0.5, 0.1}, at(3, 0, 0.2, degrees(0, 30, 0))),
                                   sphere("block", 1, at(3, 0, -0.95)),
                                   convex({{-0.1, 0}, {0.1, 0}, {0.1, 1}, {0, 1.2}, {-0.1, 1}}),
                                   box("block", {0.5, 0.5, 0.1}, at(3, 0, 0.25, degrees(0, 90, 0))),
                                   sphere("block", 0.3, at(3, 0, 0.3)),
                                   box("block", {0.5, 0.5, 0.1}, at(3, 0, 1, degrees(0, 30, 0)))};
        Scene scene = wheeledScene();
        scene.scenery({shapes[shape]}, {}, "thing");
        scene.robot("r", {}, small());
        const std::string refusal = refusalOf(scene);
        QVERIFY2(said.isEmpty() ? refusal.empty() : has(refusal, "thing: geom block " + said), refusal.c_str());
    }

    void aPlaneThatPointsDownIsNoGround() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        scene.scenery({plane("ceiling", at(0, 0, 3, degrees(0, 0, 180)), 1)}, {}, "thing");
        QVERIFY(has(refusalOf(scene), "thing: geom ceiling is a plane that points down"));
        scene.spec->statics.clear();
        scene.scenery({plane("floor", at(0, 0, 0, degrees(0, 0, 180)), 1)});
        QVERIFY(has(refusalOf(scene), "there is no level ground"));
    }

    /// A step is a wall where it is higher than the axle of the largest wheel of all.
    void stepsByTheLargestWheel() {
        const auto refusal = [](double step, double scale, bool withLarger) {
            Scene scene = wheeledScene();
            scene.scenery({box("step", {0.5, 0.5, step}, at(3, 0, step / 2), 3)}, {}, "kerb");
            scene.robot("r", {}, small(3, scale));
            if (withLarger) scene.robot("s", at(0, 1, 0), small());
            return refusalOf(scene);
        };
        const QString said = "kerb: geom step is so low that wheels climb it";
        QVERIFY(has(refusal(0.03, 1, false), said)); // its wheels have 40 mm
        QVERIFY(refusal(0.045, 1, false).empty());
        QVERIFY(has(refusal(0.012, 0.4, false), said)); // 16 mm
        QVERIFY(refusal(0.018, 0.4, false).empty());
        QVERIFY(has(refusal(0.018, 0.4, true), said));
    }

    void fixedRobotsHaveNoWheels() {
        const auto config = std::make_shared<RobotConfigSpec>(*small());
        config->joints.push_back(joint("bench", JointType::Fixed, kWorldBody, 0, {}, Vec3::UnitZ()));
        Scene scene = wheeledScene();
        scene.robot("r", {}, config);
        QVERIFY(has(refusalOf(scene), "r: wheel leftWheel is on a robot that is Fixed to the world"));
    }

    /// Not on an edge, and not beside their centre of mass.
    void looseThingsRestOnASide() {
        const Vec3 size(0.1, 0.1, 0.1);
        const auto refusal = [&](const Pose& pose, const Vec3& centre) {
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(body("body", pose, massOfBox(1, size, centre), {box("b", size)}));
            Scene scene = wheeledScene();
            scene.robot("thing", {}, config);
            return refusalOf(scene);
        };
        QVERIFY(refusal(at(0, 0, 0.05), Vec3::Zero()).empty());
        QVERIFY(refusal(at(0, 0, 0.05, degrees(30, 90, 0)), {0.04, 0, 0}).empty());
        const QString said = "thing: body body does not rest on a side below its centre of mass";
        QVERIFY(has(refusal(at(0, 0, 0.05 * std::sqrt(2.), degrees(0, 45, 0)), Vec3::Zero()), said));
        QVERIFY(has(refusal(at(0, 0, 0.05), {0.06, 0, 0}), said));
    }

    void nothingTouchesBeforeTheFirstTick() {
        Scene scene = wheeledScene();
        scene.robot("r", {}, small());
        auto world = scene.build();
        QVERIFY(world && world->contacts().empty());
        QVERIFY(world->tick().ok());
        QVERIFY(world->contacts().size() == 4);
    }
};

QTEST_APPLESS_MAIN(WheeledChangesTest)
#include "changes_test.moc"
