// Objects as cameras see them: their numbers in segmentation images, wherever planes are among the geoms of a static, and what has the
// camera.
#include <QtTest>

#include <set>

#include "model/object_numbers.h"
#include "render/camera_experiment.h"
#include "render/sample_experiment.h"
#include "scene/queries/object_index.h"
#include "scene/queries/ray_cast.h"

using namespace trundle;

namespace {

GeomSpec box(const char* name, const Vec3& position) {
    GeomSpec geom;
    geom.name = name;
    geom.size = {0.3, 0.3, 0.3};
    geom.pose.position = position;
    return geom;
}

GeomSpec plane(const char* name, const Pose& pose = {}) {
    GeomSpec geom;
    geom.name = name;
    geom.shape = GeomShape::Plane;
    geom.pose = pose;
    return geom;
}

StaticSpec fixed(const char* name, std::vector<GeomSpec> geoms) {
    StaticSpec all;
    all.name = name;
    all.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(geoms));
    return all;
}

/// Looks at two boxes on a floor with a wall behind them.
RobotSpec watcher() {
    return cameraRobot("watcher", {{-2, 0, 0.9}, rotationFromHpr({0, 0.3, 0})},
                       {{"Mode", word("segmentation")}, {"Resolution", numbers({160, 120})}});
}

const Pose kWall{{2, 0, 0}, rotationFromHpr({0, -1.5707963267948966, 0})}; // its front is towards -x

} // namespace

class ObjectNumbersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyPixelHasTheObjectThatIsThere_data() {
        QTest::addColumn<int>("order");
        QTest::newRow("planes first") << 0;
        QTest::newRow("planes between") << 1;
        QTest::newRow("planes last") << 2;
        QTest::newRow("in two statics") << 3;
    }
    void everyPixelHasTheObjectThatIsThere() {
        QFETCH(int, order);
        const GeomSpec left = box("left", {0.3, 0.5, 0.15}), right = box("right", {0.3, -0.5, 0.15}), floor = plane("floor"),
                       wall = plane("wall", kWall);
        auto experiment = sampleExperiment({0, 1, false, 4});
        experiment->robots = {watcher()};
        if (order == 0) experiment->statics = {fixed("yard", {floor, wall, left, right})};
        if (order == 1) experiment->statics = {fixed("yard", {left, floor, right, wall})};
        if (order == 2) experiment->statics = {fixed("yard", {left, right, floor, wall})};
        if (order == 3) experiment->statics = {fixed("things", {left, wall}), fixed("yard", {right, floor})};
        const auto frame = captureAtStart(experiment, "watcher/eye");
        QVERIFY2(frame.ok(), frame.ok() ? "" : frame.error().message.c_str());
        const CameraView view = viewOf(camerasOf(*experiment).at(0), experiment->robots[0].pose);
        const ObjectIndex objects(experiment);
        std::set<std::string> met;
        for (int y = 3; y < 117; y += 5) {
            for (int x = 3; x < 157; x += 5) {
                const auto at = [&](int step) { return frame.value().objects[std::size_t(y * 160 + x + step)]; };
                if (at(-1) != at(0) || at(1) != at(0) || at(-160) != at(0) || at(160) != at(0)) continue; // a rim
                const auto hits = castRay(objects, startPoses(*experiment), rayThrough(view, 160, 120, x + 0.5, y + 0.5));
                const std::string drawn = objectNames(*experiment).at(at(0));
                QCOMPARE(drawn, hits.empty() ? std::string() : objects.pathOf(hits.front().geom, '/'));
                met.insert(drawn.substr(drawn.find('/') + 1));
            }
        }
        for (const char* name : {"left", "right", "floor", "wall"}) QVERIFY2(met.contains(name), name);
    }

    void aCameraMaySeeItsOwnRobotOrNot() {
        GeomSpec label; // in front of the lens
        label.name = "plate";
        label.size = {0.02, 1, 1};
        label.pose.position = {0.5, 0, 0};
        for (const auto& [sees, isStatic] : {std::pair{true, false}, {false, false}, {true, true}, {false, true}}) {
            auto experiment = lampExperiment({{3, 0, 0}}, 1.0);
            CameraValues values{{"SeesSelf", numbers({sees ? 1.0 : 0.0})}, {"Resolution", numbers({64, 48})}};
            experiment->robots = {cameraRobot("robot0", {}, values, {label})};
            if (isStatic) { // a part that moves in it has the camera
                experiment->robots[0].scenery = std::make_shared<const std::vector<GeomSpec>>();
                experiment->statics.push_back({"robot0", "Crane", {}, experiment->robots[0].scenery, {}, {}});
            }
            experiment->materials.push_back({});
            auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[0].config);
            config->bodies[0].geoms[0].material = 1;
            experiment->robots[0].config = config;
            const auto frame = captureAtStart(experiment, "robot0/eye");
            QVERIFY(frame.ok());
            const std::uint8_t* p = frame.value().pixels.data() + 3 * (24 * 64 + 32);
            QCOMPARE(p[0] == 255 && p[1] == 0, !sees);
        }
    }
};

QTEST_APPLESS_MAIN(ObjectNumbersTest)
#include "object_numbers_test.moc"
