// Paths of objects whose names begin like others.
#include <QtTest>

#include "render/sample_experiment.h"
#include "scene/queries/framing.h"
#include "scene/queries/object_index.h"

using namespace trundle;

class ObjectPathsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// "chassis2" and "chassis_rear" are other bodies than "chassis", which is before them.
    void aNameThatBeginsLikeAnother_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("body"); // -1: no body
        QTest::newRow("short") << "robot0.chassis" << 0;
        QTest::newRow("longer") << "robot0.chassis2" << 1;
        QTest::newRow("longest") << "robot0.chassis_rear" << 2;
        QTest::newRow("geom of the short one") << "robot0.chassis.bumper" << 0;
        QTest::newRow("geom of the longer one") << "robot0.chassis2.tyre" << 1;
        QTest::newRow("geom of the longest one, with slashes") << "robot0/chassis_rear/tyre" << 2;
        QTest::newRow("too short") << "robot0.chass" << -1;
        QTest::newRow("none so long") << "robot0.chassis22" << -1;
        QTest::newRow("no such geom") << "robot0.chassis.tyre" << -1;
        QTest::newRow("the other's geom") << "robot0.chassis2.hull" << -1;
    }
    void aNameThatBeginsLikeAnother() {
        QFETCH(QString, path);
        QFETCH(int, body);
        const auto experiment = sampleExperiment({1});
        auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[0].config);
        QCOMPARE(config->bodies.size(), std::size_t(3));
        config->bodies[1].name = "chassis2";
        config->bodies[2].name = "chassis_rear";
        experiment->robots[0].config = config;
        const ObjectIndex objects(experiment);
        const auto found = objects.find(path.toStdString());
        QCOMPARE(found.has_value(), body >= 0);
        if (!found) return;
        QCOMPARE(int(found->body), body);
        QCOMPARE(objects.pathOf(*found, '/'), QString(path).replace(u'.', u'/').toStdString());
    }

    /// Configs are instances too where they are shown alone; a longer name that begins like that is one word.
    void pathsOfConfigs() {
        auto experiment = std::make_shared<ExperimentSpec>();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.resize(1);
        config->bodies[0].name = "hull";
        for (const char* name : {"RobotConfig.Rover", "RobotConfigs", "StaticConfigX"})
            experiment->robots.push_back({name, {}, config, {}, {}});
        GeomSpec wall;
        wall.name = "wall";
        experiment->statics.push_back(
            {"StaticConfig.Arena", "S", {}, std::make_shared<const std::vector<GeomSpec>>(1, wall), {}, {}});
        const ObjectIndex objects(experiment);
        for (const char* path : {"RobotConfig.Rover.hull", "RobotConfigs.hull", "StaticConfigX.hull", "StaticConfig.Arena.wall"})
            QVERIFY2(objects.find(path) && objects.pathOf(*objects.find(path)) == path, path);
        for (const char* path : {"RobotConfig.hull", "StaticConfig.wall", "RobotConfig", "StaticConfigX.Arena.wall"})
            QVERIFY2(!objects.find(path), path);
    }

    /// What moves in a static has it for an owner; a robot that only has the same name does not.
    void whatMovesInAStatic() {
        const auto body = [](const char* name, double x) {
            BodySpec made;
            made.name = name;
            GeomSpec box;
            box.name = "box";
            box.size = {0.2, 0.2, 0.2};
            box.pose.position.x() = x;
            made.geoms = {box};
            return made;
        };
        auto door = std::make_shared<RobotConfigSpec>(), cart = std::make_shared<RobotConfigSpec>();
        door->bodies = {body("frame", 0), body("leaf", 2), body("knob", 4)};
        door->bodies[2].geoms[0].visible = false;
        cart->bodies = {body("frame", 6)};
        auto experiment = std::make_shared<ExperimentSpec>();
        experiment->robots = {{"cart", {}, cart, {}, {}}, {"door", {}, door, {}, {}}, {"twin", {}, door, {}, {}}};
        const auto none = std::make_shared<const std::vector<GeomSpec>>();
        experiment->robots[1].scenery = none;
        for (const char* name : {"wall", "door", "twin"}) experiment->statics.push_back({name, "S", {}, none, {}, {}});
        const ObjectIndex objects(experiment);
        QCOMPARE(objects.poseCount(), std::size_t(7));
        QCOMPARE(objects.firstPose(2), std::size_t(4));
        const BodyPoses poses = startPoses(*experiment);
        using Kind = ObjectKind;
        QCOMPARE(objects.ownerOf({Kind::Body, 1, 1}), std::optional(ObjectRef{Kind::Static, 1}));
        QCOMPARE(objects.ownerOf({Kind::Body, 2, 1}), std::optional(ObjectRef{Kind::Robot, 2}));
        QCOMPARE(objects.instances(),
                 (std::vector<ObjectRef>{
                     {Kind::Robot, 0}, {Kind::Robot, 2}, {Kind::Static, 0}, {Kind::Static, 1}, {Kind::Static, 2}}));
        const Bounds all = objects.boundsOf({Kind::Robot, 2}, poses), leaf = objects.boundsOf({Kind::Body, 2, 1}, poses);
        QVERIFY(all.low.isApprox(Vec3(-0.1, -0.1, -0.1)) && all.high.isApprox(Vec3(2.1, 0.1, 0.1))); // the knob is not seen
        QVERIFY(leaf.low.isApprox(Vec3(1.9, -0.1, -0.1)) && leaf.high.isApprox(Vec3(2.1, 0.1, 0.1)));
        QVERIFY(objects.boundsOf({Kind::Static, 1}, poses).high.isApprox(Vec3(2.1, 0.1, 0.1)));
    }

    /// Views of the text by name, robots with all their bodies, what is seen of them.
    void whatTheDefaultViewShows() {
        const auto experiment = sampleExperiment({1});
        const auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[0].config);
        experiment->robots[0].config = config;
        experiment->statics.clear();
        for (BodySpec& body : config->bodies) body.geoms.clear();
        GeomSpec box;
        box.size = {0.2, 0.2, 0.2};
        config->bodies[2].geoms = {box, box};
        config->bodies[2].geoms[1].visible = false;
        config->bodies[2].geoms[1].size = {90, 90, 90};
        BodyPoses poses = startPoses(*experiment);
        poses[2] = {Vec3(30, 0, 0), Quat::Identity()};
        const CameraView view = defaultView(*experiment, poses, 400, 300);
        QVERIFY((view.target - Vec3(30, 0, 0)).norm() < 0.1 && (view.eye - view.target).norm() < 2);
        for (const auto& [kind, name] : {std::pair("View", "top"), {"Background", "side"}, {"View", "side"}}) {
            ComponentSpec spec;
            spec.kind = kind;
            spec.name = name;
            if (spec.kind == "View") spec.values["Eye"] = {{PropertyType::Number, {1, 2, 3}, {}}, {}, Origin::Config};
            experiment->looks.push_back(spec);
        }
        QCOMPARE(viewNames(*experiment), std::string("top, side"));
        QVERIFY(namedView(*experiment, "side", poses)->eye == Vec3(1, 2, 3));
        ComponentSpec view2 = experiment->looks[0];
        view2.name = std::string(60, 'v');
        for (int i = 0; i < 9; ++i) experiment->looks.push_back(view2);
        QVERIFY(viewNames(*experiment).size() < 270);
    }
};

QTEST_APPLESS_MAIN(ObjectPathsTest)
#include "object_paths_test.moc"
