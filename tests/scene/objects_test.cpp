// Objects of an experiment: poses, bounds, ray hits.
#include <QtTest>

#include <random>

#include "render/sample_experiment.h"
#include "scene/queries/camera_model.h"
#include "scene/queries/framing.h"
#include "scene/queries/ghosts.h"
#include "scene/queries/radio_model.h"
#include "scene/queries/ray_cast.h"
#include "scene/scene.h"

using namespace trundle;

namespace {

/// Boxes of 2 x 0.1 x 0.1 m, of one static each.
std::shared_ptr<const ExperimentSpec> beams(const std::vector<Vec3>& places) {
    auto experiment = std::make_shared<ExperimentSpec>();
    GeomSpec beam;
    beam.name = "beam";
    beam.size = {2, 0.1, 0.1};
    for (const Vec3& place : places) {
        StaticSpec fixed;
        fixed.name = "s" + std::to_string(experiment->statics.size());
        fixed.pose.position = place;
        fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::vector{beam});
        experiment->statics.push_back(fixed);
    }
    return experiment;
}

} // namespace

class ObjectsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void pathsAreFoundAndGivenBack() {
        const ObjectIndex objects(shapesExperiment());
        for (const char* path : {"robot0", "robot1.chassis", "robot0.leftWheel.tyre", "arena", "arena.north", "things.pill"}) {
            const auto object = objects.find(path);
            QVERIFY2(object, path);
            QCOMPARE(objects.pathOf(*object), std::string(path));
        }
        QCOMPARE(objects.pathOf(*objects.find("robot0/chassis/hull"), '/'), std::string("robot0/chassis/hull"));
        for (const char* path :
             {"", ".", "robot", "robot0.", "robot0.wheel", "robot0.chassis.hull.x", "arena.north.x", "arena..north", "robot9"})
            QVERIFY2(!objects.find(path), path);
    }

    void partIsRelativeToOwner() {
        const auto experiment = sampleExperiment({2});
        const ObjectIndex objects(experiment);
        const BodyPoses poses = startPoses(*experiment);
        const ObjectRef wheel = *objects.find("robot1.leftWheel");
        const Pose& robot = experiment->robots[1].pose;
        QVERIFY((objects.poseOf(wheel, poses).position - robot * Vec3(0.06, 0.125, 0.05)).norm() < 1e-12);
        QVERIFY((objects.frameOf(wheel, poses).position - robot.position).norm() < 1e-12);
        QCOMPARE(objects.pathOf(*objects.ownerOf(*objects.find("robot1.leftWheel.tyre"))), std::string("robot1.leftWheel"));
        QVERIFY(!objects.ownerOf(*objects.find("robot1")));
        QVERIFY(objects.boundsOf(*objects.find("arena.floor"), poses).empty());
        // A robot's pose follows its first body.
        BodyPoses moved = poses;
        for (Pose& pose : moved) pose.position += Vec3(1, 0, 0);
        QVERIFY((objects.poseOf(*objects.find("robot1"), moved).position - robot.position - Vec3(1, 0, 0)).norm() < 1e-12);
        // Poses of another experiment are ignored.
        QVERIFY((objects.poseOf(*objects.find("robot1"), {}).position - robot.position).norm() < 1e-12);
    }

    /// Whatever the pose of the first body in its config: a robot moved as a whole has moved by as much in all its parts.
    void aMovedRobotMovesInAllItsParts() {
        auto experiment = std::make_shared<ExperimentSpec>(*sampleExperiment({2}));
        auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[1].config);
        for (std::size_t b = 0; b < config->bodies.size(); ++b)
            config->bodies[b].pose = {Vec3(0.4, -0.1 * double(b), 0.2), rotationFromHpr({0.5, 0.3 * double(b), -0.9})};
        experiment->robots[1].config = config;
        experiment->robots[1].pose = {Vec3(3, 1, 0), rotationFromHpr({2, 0.1, 0.4})};
        const ObjectIndex objects(experiment);
        const BodyPoses start = startPoses(*experiment);
        const Pose way{Vec3(-1, 7, 2), rotationFromHpr({-1, 0.6, 0.2})};
        BodyPoses moved = start;
        for (Pose& pose : moved) pose = way * pose;
        for (const char* path : {"robot1", "robot1.chassis", "robot1.leftWheel", "robot1.leftWheel.tyre", "robot0"}) {
            const ObjectRef object = *objects.find(path);
            for (const auto& [is, was] : {std::pair(objects.poseOf(object, moved), objects.poseOf(object, start)),
                                          {objects.frameOf(object, moved), objects.frameOf(object, start)}}) {
                if (!objects.ownerOf(object) && is.position == Vec3::Zero()) continue; // its frame is the world
                QVERIFY2((is.position - (way * was).position).norm() < 1e-9, path);
                QVERIFY2(is.rotation.angularDistance((way * was).rotation) < 1e-9, path);
            }
        }
        QVERIFY((objects.poseOf(*objects.find("robot1"), start).position - Vec3(3, 1, 0)).norm() < 1e-9);
        QVERIFY(objects.poseOf(*objects.find("robot1"), start).rotation.angularDistance(experiment->robots[1].pose.rotation) <
                1e-9);
    }

    void boundsOfTurnedShapesAreTight() {
        GeomSpec cylinder;
        cylinder.shape = GeomShape::Cylinder;
        cylinder.radius = 0.05;
        cylinder.length = 0.4;
        cylinder.pose.rotation = rotationFromHpr({0, M_PI / 2, 0});
        const Bounds lying = boundsOf(cylinder, {Vec3(1, 2, 3), Quat::Identity()});
        QVERIFY((lying.size() - Vec3(0.4, 0.1, 0.1)).norm() < 1e-9);
        QVERIFY((lying.centre() - Vec3(1, 2, 3)).norm() < 1e-9);
        GeomSpec broken = cylinder;
        broken.radius = std::nan("");
        QVERIFY(boundsOf(broken, {}).empty());
        QVERIFY(ballAround(broken).radius < 0);
    }

    void boundsOfATurnedCapsuleAreTight() {
        GeomSpec capsule;
        capsule.shape = GeomShape::Capsule;
        capsule.radius = 0.1;
        capsule.length = 0.4;
        capsule.pose = {Vec3(0.5, 0, 0), rotationFromHpr({0, M_PI / 3, 0})}; // 60 degrees from upright
        const Bounds bounds = boundsOf(capsule, {Vec3(1, 2, 3), Quat::Identity()});
        QVERIFY((bounds.size() - Vec3(0.2 + 0.4 * std::sin(M_PI / 3), 0.2, 0.2 + 0.2)).norm() < 1e-9);
        QVERIFY((bounds.centre() - Vec3(1.5, 2, 3)).norm() < 1e-9);
    }

    /// A ray that starts beside a long shape, behind its middle, and runs away from that.
    void aRayFromBesideTheMiddle() {
        const auto experiment = beams({{0, 0, 0}});
        const ObjectIndex objects(experiment);
        const Vec3 from(0.5, 0.2, 0), along = Vec3(2, -1, 0).normalized();
        const auto hits = castRay(objects, {}, {from, along});
        QCOMPARE(hits.size(), std::size_t(1));
        QVERIFY((hits[0].point - Vec3(0.8, 0.05, 0)).norm() < 1e-9 && (hits[0].normal - Vec3::UnitY()).norm() < 1e-9);
        QVERIFY(castRay(objects, {}, {Vec3(0.9, 0.2, 0), along}).empty());
    }

    /// Only what lies between two points counts: not what is behind either, nor the two robots themselves.
    void solidsBetweenTwoPoints() {
        const auto experiment = beams({{0, -2, 0}, {0, 1, 0}, {0, 2, 0}, {0, 5, 0}});
        const ObjectIndex objects(experiment);
        const std::size_t none = 99;
        QCOMPARE(solidsBetween(objects, {}, {0, 0, 0}, {0, 3, 0}, none, none), 2);
        QCOMPARE(solidsBetween(objects, {}, {0, 3, 0}, {0, 0, 0}, none, none), 2);
        QCOMPARE(solidsBetween(objects, {}, {0, 1.5, 0}, {0, 1.7, 0}, none, none), 0);
        QCOMPARE(solidsBetween(objects, {}, {0, -3, 0}, {0, 6, 0}, none, none), 4);
        QCOMPARE(solidsBetween(objects, {}, {0, 1, 0.2}, {0, 1, 0.2}, none, none), 0);
    }

    /// Radios in the middle of their robots' hulls: neither of the two hulls is a wall for their link, that of a third robot is.
    void wallsBetweenRadios() {
        auto config = std::make_shared<RobotConfigSpec>();
        BodySpec body;
        body.name = "hull";
        GeomSpec box;
        box.name = "box";
        box.size = {0.4, 0.4, 0.4};
        body.geoms = {box};
        config->bodies = {body};
        ComponentSpec radio{"Transceiver", "radio", {}, {}, {}};
        const auto given = [&](const char* key, std::vector<double> numbers) {
            radio.values[key] = {{PropertyType::Number, std::move(numbers), {}}, {}, Origin::Config};
        };
        given("Channel", {13});
        given("MaxOutputPower", {-3});
        given("MinReceivePower", {-81});
        given("MaxReceivePower", {-7});
        given("RssiStep", {0.25});
        given("BitRate", {123456});
        given("Pos", {0.01, 0.02, 0.03});
        given("PowerLevels", {-20, -3});
        config->devices = {radio};
        auto experiment = std::make_shared<ExperimentSpec>();
        for (const double x : {0., 1., 2., 3.}) {
            RobotSpec robot;
            robot.name = "r" + std::to_string(int(x));
            robot.config = config;
            robot.pose.position = {x, 0, 0};
            experiment->robots.push_back(robot);
        }
        const std::vector<RadioNode> nodes = radioNodesOf(*experiment);
        QCOMPARE(nodes.size(), std::size_t{4});
        QCOMPARE(nodes[2].robot, std::string("r2"));
        QCOMPARE(nodes[2].body, std::size_t{2});
        QCOMPARE(nodes[2].mounting.position, Vec3(0.01, 0.02, 0.03));
        const RadioDefinition& r = nodes[2].radio;
        QCOMPARE(r.path, std::string("r2/radio"));
        QVERIFY(r.channel == 13 && r.maxOutputPower == -3 && r.minReceivePower == -81 && r.maxReceivePower == -7);
        QVERIFY(r.rssiStep == 0.25 && r.bitRate == 123456 && r.powerLevels == (std::vector<double>{-20, -3}));
        const auto walls = wallsBetween(std::make_shared<const ObjectIndex>(experiment),
                                        std::make_shared<const BodyPoses>(startPoses(*experiment)), nodes);
        for (RadioId a = 0; a < 4; ++a)
            for (RadioId b = 0; b < 4; ++b)
                if (a != b) QCOMPARE(walls(a, {double(a), 0, 0}, b, {double(b), 0, 0}), std::abs(int(a) - int(b)) - 1);
        QCOMPARE(walls(9, {-1, 0, 0}, 1, {1, 0, 0}), 1); // a radio of no robot
        const auto fixed =
            std::make_shared<const std::vector<GeomSpec>>(); // the last one is of a static, the third of the statics
        experiment->robots[3].scenery = fixed;
        for (const char* name : {"floor", "wall", "r3"}) experiment->statics.push_back({name, "S", {}, fixed, {}, {}});
        const auto more = wallsBetween(std::make_shared<const ObjectIndex>(experiment),
                                       std::make_shared<const BodyPoses>(startPoses(*experiment)), radioNodesOf(*experiment));
        QCOMPARE(more(3, {3, 0, 0}, 0, {0, 0, 0}), 2);
    }

    /// A View in the world, beside a robot, and one that turns with it: its Eye and Target from the robot's origin, which is not that of
    /// its first body.
    void namedViewsFollowTheirRobot() {
        auto experiment = std::make_shared<ExperimentSpec>();
        auto config = std::make_shared<RobotConfigSpec>();
        BodySpec first, second;
        first.name = "first";
        first.pose = {Vec3(0.1, -0.2, 0.3), rotationFromHpr({0.4, 0.2, 0})};
        second.name = "second";
        config->bodies = {first, second};
        for (const char* name : {"one", "two"}) {
            RobotSpec robot;
            robot.name = name;
            robot.config = config;
            experiment->robots.push_back(robot);
        }
        const Vec3 eye(-1, 0.5, 2), target(3, 0, 0.5);
        for (const char* mode : {"fixed", "follow", "chase"}) {
            ComponentSpec view;
            view.kind = "View";
            view.name = mode;
            view.values["Mode"] = {{PropertyType::Choice, {}, {mode}}, {}, Origin::Config};
            view.values["Robot"] = {{PropertyType::Reference, {}, {"two"}}, {}, Origin::Config};
            view.values["Eye"] = {{PropertyType::Number, {eye.x(), eye.y(), eye.z()}, {}}, {}, Origin::Config};
            view.values["Target"] = {{PropertyType::Number, {target.x(), target.y(), target.z()}, {}}, {}, Origin::Config};
            experiment->looks.push_back(view);
        }
        const Pose origin{Vec3(4, 5, 6), rotationFromHpr({0.7, -0.3, 0.2})};
        BodyPoses poses(4);
        poses[2] = origin * first.pose;
        const auto check = [&](const char* mode, const Vec3& at, double heading) {
            const auto view = namedView(*experiment, mode, poses);
            QVERIFY(view);
            const Quat turn = rotationFromHpr({heading, 0, 0});
            QVERIFY2((view->eye - (at + turn * eye)).norm() < 1e-9 && (view->target - (at + turn * target)).norm() < 1e-9, mode);
        };
        check("fixed", Vec3::Zero(), 0);
        check("follow", origin.position, 0);
        check("chase", origin.position, 0.7);
        QVERIFY(!namedView(*experiment, "other", poses));
    }

    /// Bodies are counted through all robots, also those without a camera.
    void camerasAreOnTheBodiesOfTheirRobots() {
        auto experiment = std::make_shared<ExperimentSpec>();
        for (const char* name : {"one", "two", "three"}) {
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.resize(2);
            config->bodies[0].name = "base";
            config->bodies[1].name = "mast";
            for (const char* body : {"mast", "base"}) {
                ComponentSpec camera;
                camera.kind = "Camera";
                camera.name = std::string("on_") + body;
                camera.values["Body"] = {{PropertyType::Reference, {}, {body}}, {}, Origin::Config};
                if (std::string(name) != "two") config->devices.push_back(camera);
            }
            RobotSpec robot;
            robot.name = name;
            robot.config = config;
            experiment->robots.push_back(robot);
        }
        std::map<std::string, std::size_t> bodies;
        for (const CameraModel& camera : camerasOf(*experiment)) bodies[camera.path] = camera.body;
        const std::map<std::string, std::size_t> expected{
            {"one/on_base", 0}, {"one/on_mast", 1}, {"three/on_base", 4}, {"three/on_mast", 5}};
        QVERIFY(bodies == expected);
    }

    /// A room around a robot is in the picture as a whole, of a landscape only what is near the robot.
    void defaultViewShowsTheRoom() {
        for (const auto& [side, isWhole] : {std::pair{4.0, true}, {400.0, false}}) {
            const auto experiment = sampleExperiment({1, 0.7, true, side});
            const CameraView view = defaultView(*experiment, startPoses(*experiment), 400, 300);
            bool isShown = true;
            for (const Vec3& corner : {Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(1, -1, 0), Vec3(-1, -1, 0)}) {
                const auto at = project(view, 400, 300, 0.49 * side * corner);
                isShown = isShown && at && at->x > 0 && at->x < 400 && at->y > 0 && at->y < 300;
            }
            QCOMPARE(isShown, isWhole);
            QVERIFY(view.eye.norm() < 15);
        }
    }

    /// Random rays: hits on exact shapes agree with hits on the drawn triangles.
    void aRayMeetsWhatIsDrawn() {
        const auto experiment = shapesExperiment();
        const ObjectIndex objects(experiment);
        Scene scene(*experiment);
        std::mt19937 random(3);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int met = 0, differing = 0;
        std::set<std::string> names;
        for (int i = 0; i < 3000; ++i) {
            const Vec3 from(any(-4, 4), any(-4, 4), any(1, 3)), to(any(-2.2, 2.2), any(-2.2, 2.2), any(0, 0.5));
            const ViewRay ray{from, (to - from).normalized()};
            const auto drawn = scene.pick(ray);
            std::vector<RayHit> hits = castRay(objects, startPoses(*experiment), ray);
            std::erase_if(hits, [&](const RayHit& hit) { return objects.geomOf(hit.geom)->shape == GeomShape::Plane; });
            for (std::size_t k = 1; k < hits.size(); ++k) QVERIFY(hits[k - 1].distance <= hits[k].distance);
            if (hits.empty() && !drawn) continue;
            ++met;
            const bool same = !hits.empty() && drawn && objects.pathOf(hits.front().geom, '/') == drawn->path &&
                              (hits.front().point - drawn->point).norm() < 0.03;
            if (same) names.insert(drawn->path);
            differing += !same; // round shapes are drawn with corners
            if (same) QVERIFY(hits.front().normal.dot(ray.direction) < 1e-6);
        }
        QVERIFY(met > 1000);
        QVERIFY2(differing < met / 40, qPrintable(QString("%1 of %2").arg(differing).arg(met)));
        QVERIFY(names.size() > 12);
    }

    /// A ray that starts inside a shape does not meet it: only what it enters counts. From outside it meets both sides of all.
    void raysFromInside() {
        auto experiment = std::make_shared<ExperimentSpec>();
        experiment->materials.emplace_back();
        experiment->surfaces.emplace_back();
        auto geoms = std::make_shared<std::vector<GeomSpec>>();
        for (const GeomShape shape : {GeomShape::Box, GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule}) {
            GeomSpec g;
            g.name = "g" + std::to_string(geoms->size());
            g.shape = shape;
            g.size = {0.6, 0.8, 1.2};
            g.radius = 0.4;
            g.length = 1;
            g.pose = {Vec3(3. * static_cast<double>(geoms->size()), 1, -2), rotationFromHpr({0.5, -0.3, 0.8})};
            geoms->push_back(g);
        }
        experiment->statics.push_back({"s", "S", {Vec3(0.1, 0.2, 0.3), rotationFromHpr({0.4, 0, 0})}, geoms, {}, {}});
        const ObjectIndex objects(experiment);
        const Pose& frame = experiment->statics[0].pose;
        for (const GeomSpec& g : *geoms) // along the axis, just beside the shape
            for (int degrees = 0; degrees < 360; degrees += 15) {
                const double a = degrees * M_PI / 180,
                             beside = g.shape == GeomShape::Box ? 0.51 : 0.41; // the box: half a diagonal
                const Vec3 from = frame * (g.pose * Vec3(beside * std::cos(a), beside * std::sin(a), 2));
                const Vec3 down = frame.rotation * (g.pose.rotation * Vec3(0, 0, -1));
                QVERIFY2(castRay(objects, startPoses(*experiment), {from, down}).empty(), g.name.c_str());
            }
        for (const GeomSpec& g : *geoms)
            for (const Vec3& off : {Vec3(0, 0, 0), Vec3(0.1, -0.2, 0.25), Vec3(-0.15, 0.1, -0.3)}) {
                const Vec3 inside = frame * (g.pose * off);
                for (int i = 0; i < 3; ++i)
                    for (const double way : {1., -1.}) {
                        const Vec3 along = frame.rotation * (g.pose.rotation * Vec3(way * Vec3::Unit(i)));
                        const auto of = [&](const Vec3& from) {
                            std::vector<RayHit> hits = castRay(objects, startPoses(*experiment), {from, along});
                            std::erase_if(hits, [&](const RayHit& hit) { return objects.geomOf(hit.geom)->name != g.name; });
                            return hits;
                        };
                        QVERIFY2(of(inside).empty(), g.name.c_str());
                        const auto hits = of(inside - 2 * along);
                        QCOMPARE(hits.size(), std::size_t{1});
                        QVERIFY(hits[0].distance > 0.5 && hits[0].distance < 2 && hits[0].normal.dot(along) < 0);
                        QVERIFY((hits[0].point - (inside - 2 * along + hits[0].distance * along)).norm() < 1e-9);
                    }
            }
    }

    /// A height map without symmetry: rays from above meet the height of its sample, the first row of the picture at +y.
    void raysOnAHeightMap() {
        auto map = std::make_shared<HeightMap>(
            HeightMap{4, 3, {0.1f, 0.9f, 0.3f, 0.2f, 0.5f, 0.0f, 0.8f, 1.0f, 0.7f, 0.4f, 0.6f, 0.05f}});
        GeomSpec land;
        land.name = "land";
        land.shape = GeomShape::Heightfield;
        land.heightMap = map;
        land.size = {6, 4, 1.5};
        auto experiment = std::make_shared<ExperimentSpec>();
        experiment->materials.emplace_back();
        experiment->surfaces.emplace_back();
        const Pose pose{Vec3(1, -2, 0.5), rotationFromHpr({0.6, 0, 0})};
        experiment->statics.push_back({"s", "S", pose, std::make_shared<const std::vector<GeomSpec>>(1, land), {}, {}});
        const ObjectIndex objects(experiment);
        for (std::uint32_t row = 0; row < 3; ++row)
            for (std::uint32_t column = 0; column < 4; ++column) {
                const double shrink = 0.999; // not beside the edge
                const Vec3 at(shrink * (column / 3. - 0.5) * 6, shrink * (0.5 - row / 2.) * 4, 5);
                const auto hits = castRay(objects, startPoses(*experiment), {pose * at, Vec3(0, 0, -1)});
                QCOMPARE(hits.size(), std::size_t{1});
                const double height = 1.5 * map->heights[row * 4 + column];
                QVERIFY2(std::abs(hits[0].point.z() - 0.5 - height) < 0.01, qPrintable(QString("%1 %2").arg(row).arg(column)));
                QVERIFY(hits[0].normal.z() > 0);
            }
    }

    void brokenShapesAreMissed() {
        auto experiment = std::make_shared<ExperimentSpec>();
        std::vector<GeomSpec> geoms(9);
        for (int i = 0; i < 8; ++i) {
            geoms[std::size_t(i)].shape = GeomShape(i);
            geoms[std::size_t(i)].radius = i % 2 ? std::nan("") : -1;
            geoms[std::size_t(i)].length = INFINITY;
            geoms[std::size_t(i)].size = Vec3::Constant(i % 2 ? std::nan("") : 0);
            geoms[std::size_t(i)].name = std::to_string(i);
        }
        geoms[8].visible = false;
        geoms[8].size = Vec3::Constant(1);
        StaticSpec fixed;
        fixed.name = "bad";
        fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
        experiment->statics = {fixed};
        experiment->robots.resize(2);
        const ObjectIndex objects(experiment);
        for (int i = 0; i < 50; ++i) (void)castRay(objects, {}, {{0.01 * i, 0, 5}, {0, 0, -1}});
        (void)castRay(objects, {}, {{std::nan(""), 0, 5}, {0, 0, 0}});
        QVERIFY(objects.find("bad.3"));
    }

    void ghostsAreBrokenObjects() {
        const auto before = sampleExperiment({3});
        auto now = std::make_shared<ExperimentSpec>(*before);
        now->robots.erase(now->robots.begin() + 1);
        const auto written = [](const std::string&) { return true; };
        const auto ghosts = ghostsOf(*now, *before, written);
        QVERIFY(ghosts);
        QCOMPARE(ghosts->robots.size(), std::size_t(1));
        QCOMPARE(ghosts->robots[0].name, std::string("robot1"));
        QVERIFY(!ghostsOf(*now, *before, [](const std::string& path) { return !path.starts_with("robot1"); })); // it was deleted
        QVERIFY(!ghostsOf(*before, *before, written));
        // One geom of a body is missing in every robot of the config.
        auto config = std::make_shared<RobotConfigSpec>(*before->robots[0].config);
        config->bodies[0].geoms.erase(config->bodies[0].geoms.begin());
        auto less = std::make_shared<ExperimentSpec>(*before);
        for (RobotSpec& robot : less->robots) robot.config = config;
        const auto hulls = ghostsOf(*less, *before, written);
        QVERIFY(hulls && hulls->robots.size() == 3 && hulls->robots[0].config->bodies.size() == 1);
        QCOMPARE(hulls->robots[2].config->bodies[0].geoms[0].name, std::string("hull"));
        // If an arena's config is misspelt, the paths of its walls no longer exist.
        auto open = std::make_shared<ExperimentSpec>(*before);
        QVERIFY(!open->statics.empty());
        const std::string arena = open->statics[0].name;
        open->statics.clear();
        const auto walls = ghostsOf(*open, *before, [&](const std::string& path) { return path == arena; });
        QVERIFY(walls && walls->statics.size() == 1 && !walls->statics[0].geoms->empty());
    }
};

QTEST_APPLESS_MAIN(ObjectsTest)
#include "objects_test.moc"
