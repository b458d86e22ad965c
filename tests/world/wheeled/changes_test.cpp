// What changes during a run of the wheeled engine, and which of two bodies is named first: nothing of before stays, and no order matters.
// What a robot touches that leans.
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

/// A robot of 0.2 m x 0.15 m on two wheels and two sliders.
std::shared_ptr<RobotConfigSpec> small(std::uint32_t hullSurface = 3) {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 hull(0.2, 0.15, 0.06), centre(0, 0, 0.05);
    config->bodies.push_back(body("chassis", {}, massOfBox(1.5, hull, centre),
                                  {box("hull", hull, {centre, Quat::Identity()}, hullSurface),
                                   sphere("front", 0.02, at(0.08, 0, 0.02), 2), sphere("rear", 0.02, at(-0.08, 0, 0.02), 2)}));
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    for (const int side : {1, -1}) {
        const std::string name = side > 0 ? "left" : "right";
        const Vec3 hub(0, side * 0.065, kWheel);
        config->bodies.push_back(body(name + "Wheel", {hub, Quat::Identity()}, massOfCylinder(0.1, kWheel, 0.02, sideways),
                                      {cylinder("tyre", kWheel, 0.02, {Vec3::Zero(), sideways}, 1)}));
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
                .loose("thing", at(1, 0, 0.05), massOfBox(1, {0.1, 0.1, 0.1}), {box("b", {0.1, 0.1, 0.1}, {}, 1)});
            worlds.push_back(each->build());
            QVERIFY(worlds.back());
        }
        SurfaceSpec changed = scene.spec->surfaces[1];
        changed.friction = friction;
        QVERIFY(worlds[0]->setSurface(changed).ok());
        double gone[2] = {};
        for (std::size_t i = 0; i < 2; ++i) {
            drive(*worlds[i], "r", 2);
            QVERIFY(worlds[i]->push("thing/body", {0, 60, 0}, {1, 0, 0.05}).ok());
            QVERIFY(run(*worlds[i], 0.4));
            gone[i] = worlds[i]->robotPose(0).position.x();
        }
        QVERIFY2(gone[0] == gone[1], qPrintable(QString::number(gone[0] - gone[1])));
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
};

QTEST_APPLESS_MAIN(WheeledChangesTest)
#include "changes_test.moc"
