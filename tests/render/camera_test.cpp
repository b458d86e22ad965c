// Images of robot cameras compared with closed-form projection.
#include <QtTest>

#include <limits>
#include <random>
#include <set>

#include "model/object_numbers.h"
#include "render/camera_experiment.h"
#include "render/sample_experiment.h"
#include "scene/queries/object_index.h"
#include "scene/queries/ray_cast.h"
#include "scene/shaders/scene_shading.h"

using namespace trundle;

namespace {

constexpr int kPoses = 50;

using Random = std::mt19937;

double between(Random& random, double low, double high) { return low + (high - low) * (double(random()) / 4294967295.0); }

Pose randomPose(Random& random) {
    return {{between(random, -3, 3), between(random, -3, 3), between(random, 0.2, 2)},
            rotationFromHpr({between(random, -3, 3), between(random, -1.2, 1.2), between(random, -3, 3)})};
}

CameraModel onlyCameraOf(const ExperimentSpec& experiment) { return camerasOf(experiment).at(0); }

/// Centroid of the red pixels within `reach` of a point; empty if there are none.
std::optional<ImagePoint> redMiddle(const CameraImage& frame, double x, double y, double reach) {
    double sumX = 0, sumY = 0, weights = 0;
    for (int row = int(y - reach); row <= int(y + reach); ++row) {
        for (int column = int(x - reach); column <= int(x + reach); ++column) {
            if (row < 0 || column < 0 || row >= int(frame.height) || column >= int(frame.width)) continue;
            const std::uint8_t* p = frame.pixels.data() + 3 * (std::size_t(row) * frame.width + std::size_t(column));
            if (p[0] < 250 || p[1] > 5) continue;
            sumX += column + 0.5, sumY += row + 0.5, weights += 1;
        }
    }
    if (weights == 0) return std::nullopt;
    return ImagePoint{sumX / weights, sumY / weights, 0};
}

CameraImage mustTake(const Result<CameraImage>& frame) {
    if (!frame) qFatal("%s", frame.error().message.c_str());
    return frame.value();
}

/// Lamps at random positions of a camera image, each alone in its cell of the image.
struct LampScene {
    std::shared_ptr<ExperimentSpec> experiment;
    std::vector<Vec3> lamps;
    double lampPixels = 8; // across
};

LampScene lampScene(Random& random, CameraValues values, double lampPixels) {
    const Pose pose = randomPose(random);
    values.try_emplace("FieldOfView", numbers({between(random, 0.35, 2.1)}));
    values.try_emplace("Resolution", numbers({std::floor(between(random, 320, 640)), std::floor(between(random, 240, 480))}));
    ExperimentSpec only;
    only.robots = {cameraRobot("robot0", pose, values)};
    const CameraModel camera = onlyCameraOf(only);
    const CameraView view = viewOf(camera, pose);
    LampScene scene;
    scene.lampPixels = lampPixels;
    for (int part = 0; part < 6; ++part) {
        const double x = camera.width * (part % 3 + between(random, 0.25, 0.75)) / 3;
        const double y = camera.height * (part / 3 + between(random, 0.25, 0.75)) / 2;
        const double distance = between(random, 1.5, 12);
        const ViewRay ray = rayThrough(view, camera.width, camera.height, x, y);
        scene.lamps.push_back(ray.origin + distance * ray.direction);
    }
    scene.experiment = lampExperiment({}, 0.01);
    // The same size in the image at any distance.
    std::vector<GeomSpec> geoms;
    const double focal = 0.5 * camera.width / std::tan(0.5 * camera.fieldOfView);
    for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
        GeomSpec lamp;
        lamp.name = "lamp" + std::to_string(i);
        lamp.shape = GeomShape::Sphere;
        lamp.pose.position = scene.lamps[i];
        lamp.radius = 0.5 * scene.lampPixels / focal * project(view, camera.width, camera.height, scene.lamps[i])->depth;
        geoms.push_back(lamp);
    }
    StaticSpec lamps;
    lamps.name = "lamps";
    lamps.geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
    scene.experiment->statics = {lamps};
    scene.experiment->robots = only.robots;
    return scene;
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void projectsPointsByPinholeModel() {
        Random random(11);
        for (int i = 0; i < kPoses; ++i) {
            const LampScene scene = lampScene(random, {}, 16);
            const CameraImage frame = mustTake(captureAtStart(scene.experiment, "robot0/eye"));
            const CameraModel camera = onlyCameraOf(*scene.experiment);
            QCOMPARE(frame.width, camera.width);
            QCOMPARE(frame.pixels.size(), std::size_t(camera.width) * camera.height * 3);
            const CameraView view = viewOf(camera, scene.experiment->robots[0].pose);
            for (const Vec3& lamp : scene.lamps) {
                const auto point = project(view, camera.width, camera.height, lamp);
                QVERIFY(point);
                // A ball projects to an ellipse whose centre is farther out than the ball's centre, by the factor z^2 / (z^2 - r^2).
                const double focal = 0.5 * camera.width / std::tan(0.5 * camera.fieldOfView), r = 0.5 * scene.lampPixels / focal;
                const double out = 1 / (1 - r * r);
                const double x = 0.5 * camera.width + (point->x - 0.5 * camera.width) * out;
                const double y = 0.5 * camera.height + (point->y - 0.5 * camera.height) * out;
                const auto seen = redMiddle(frame, x, y, 1.5 * scene.lampPixels);
                QVERIFY2(seen, qPrintable(QStringLiteral("pose %1: no lamp at %2, %3").arg(i).arg(x).arg(y)));
                const double off = std::hypot(seen->x - x, seen->y - y);
                QVERIFY2(off < 0.5, qPrintable(QStringLiteral("pose %1: %2 pixels off").arg(i).arg(off)));
            }
        }
    }

    void appliesLensDistortion_data() {
        QTest::addColumn<double>("k1");
        QTest::addColumn<double>("k2");
        QTest::newRow("barrel") << -0.2 << 0.02;
        QTest::newRow("cushion") << 0.3 << 0.;
    }
    void appliesLensDistortion() {
        QFETCH(double, k1);
        QFETCH(double, k2);
        Random random(5);
        int compared = 0;
        for (int i = 0; i < 8; ++i) {
            const LampScene scene = lampScene(
                random, {{"Distortion", numbers({k1, k2})}, {"FieldOfView", numbers({1.2})}, {"Resolution", numbers({400, 300})}},
                8);
            const CameraImage frame = mustTake(captureAtStart(scene.experiment, "robot0/eye"));
            const CameraModel camera = onlyCameraOf(*scene.experiment);
            const CameraView view = viewOf(camera, scene.experiment->robots[0].pose);
            const double focal = 200 / std::tan(0.6);
            for (const Vec3& lamp : scene.lamps) {
                const auto flat = project(view, 400, 300, lamp);
                const double right = (flat->x - 200) / focal, down = (flat->y - 150) / focal, r2 = right * right + down * down;
                const double bend = 1 + k1 * r2 + k2 * r2 * r2;
                const double x = 200 + focal * right * bend, y = 150 + focal * down * bend;
                if (x < 12 || y < 12 || x > 388 || y > 288) continue;
                const auto seen = redMiddle(frame, x, y, 2 * scene.lampPixels);
                QVERIFY(seen);
                QVERIFY2(std::hypot(seen->x - x, seen->y - y) < 0.75,
                         qPrintable(QString::number(std::hypot(seen->x - x, seen->y - y))));
                ++compared;
            }
        }
        QVERIFY(compared > 20);
    }

    void depthIsExactToATenthOfAPercent() {
        Random random(3);
        std::size_t compared = 0;
        for (int i = 0; i < kPoses; ++i) {
            auto experiment = sampleExperiment({4, 1.0, true, 8});
            Pose pose = randomPose(random);
            pose.rotation = rotationFromHpr({between(random, -3, 3), between(random, 0.05, 0.9), between(random, -0.5, 0.5)});
            experiment->robots.push_back(cameraRobot("watcher", pose,
                                                     {{"Mode", word("depth")},
                                                      {"FieldOfView", numbers({between(random, 0.4, 2)})},
                                                      {"Resolution", numbers({160, 120})}}));
            const CameraImage frame = mustTake(captureAtStart(experiment, "watcher/eye"));
            QCOMPARE(frame.depth.size(), std::size_t(160 * 120));
            const CameraView view = viewOf(onlyCameraOf(*experiment), pose);
            const ObjectIndex objects(experiment);
            const BodyPoses poses = startPoses(*experiment);
            const auto hitAt = [&](double x, double y) -> std::optional<RayHit> {
                const std::vector<RayHit> hits = castRay(objects, poses, rayThrough(view, 160, 120, x, y));
                return hits.empty() ? std::nullopt : std::optional<RayHit>(hits.front());
            };
            for (int sample = 0; sample < 60; ++sample) {
                const int x = 3 + int(random() % 154), y = 3 + int(random() % 114);
                const auto hit = hitAt(x + 0.5, y + 0.5);
                if (!hit) continue;
                // Only flat faces away from their edges, which are drawn rounded; a wheel is drawn as a polygon.
                bool flat = true;
                for (const auto& [dx, dy] : {std::pair{-2, -2}, {2, -2}, {-2, 2}, {2, 2}}) {
                    const auto near = hitAt(x + 0.5 + dx, y + 0.5 + dy);
                    flat = flat && near && near->geom == hit->geom && near->normal.dot(hit->normal) > 1 - 1e-12;
                }
                const double depth = (hit->point - view.eye).dot((view.target - view.eye).normalized());
                if (!flat || depth < 0.06 || depth > 90) continue;
                const double drawn = frame.depth[std::size_t(y) * 160 + std::size_t(x)];
                QVERIFY2(
                    std::abs(drawn - depth) <= 0.001 * depth,
                    qPrintable(QStringLiteral("pose %1, pixel %2 %3: %4 m for %5 m").arg(i).arg(x).arg(y).arg(drawn).arg(depth)));
                ++compared;
            }
        }
        QVERIFY2(compared > 500, qPrintable(QString::number(compared)));
    }

    void depthOfABallIsAsExact() {
        auto experiment = lampExperiment({{3, 0, 0}}, 0.5);
        experiment->robots = {cameraRobot("robot0", {}, {{"Mode", word("depth")}, {"Resolution", numbers({320, 240})}})};
        const CameraImage frame = mustTake(captureAtStart(experiment, "robot0/eye"));
        const CameraView view = viewOf(onlyCameraOf(*experiment), {});
        int compared = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 320; ++x) {
                const ViewRay ray = rayThrough(view, 320, 240, x + 0.5, y + 0.5);
                const Vec3 middle = Vec3(3, 0, 0) - ray.origin;
                const double along = middle.dot(ray.direction), off = middle.squaredNorm() - along * along;
                if (off > 0.23) continue; // grazing view: one pixel covers a large depth range
                const Vec3 hit = ray.origin + (along - std::sqrt(0.25 - off)) * ray.direction;
                const double depth = hit.x(), drawn = frame.depth[std::size_t(y) * 320 + std::size_t(x)];
                QVERIFY2(std::abs(drawn - depth) <= 0.001 * depth,
                         qPrintable(QStringLiteral("%1 %2: %3 for %4").arg(x).arg(y).arg(drawn).arg(depth)));
                ++compared;
            }
        }
        QVERIFY(compared > 2000);
    }

    void omitsInvisibleObjects() {
        for (const char* mode : {"color", "depth", "segmentation"}) {
            CameraImage frames[2];
            for (const bool there : {false, true}) {
                auto experiment = lampExperiment({{3, 0, 0}}, 0.5);
                if (there) experiment->materials[0].opacity = 0;
                else experiment->statics.clear();
                experiment->robots = {cameraRobot("robot0", {}, {{"Mode", word(mode)}, {"Resolution", numbers({64, 48})}})};
                frames[there] = mustTake(captureAtStart(experiment, "robot0/eye"));
            }
            QCOMPARE(frames[1].pixels, frames[0].pixels);
            QCOMPARE(frames[1].depth, frames[0].depth);
        }
    }

    void unlitColoursAreExact() {
        for (const auto& glow : {std::array{1.0, 0.0, 0.0}, {0.2, 0.5, 0.4}, {0.6, 0.6, 0.6}, {0.0, 0.8, 0.8}, {1.0, 1.0, 1.0}}) {
            auto experiment = lampExperiment({{3, 0, 0}}, 1.0);
            experiment->materials[0].emission = glow;
            experiment->robots = {cameraRobot("robot0", {}, {{"Resolution", numbers({64, 48})}})};
            const CameraImage frame = mustTake(captureAtStart(experiment, "robot0/eye"));
            const std::uint8_t* p = frame.pixels.data() + 3 * (24 * 64 + 32);
            for (int k = 0; k < 3; ++k)
                QVERIFY2(std::abs(p[k] - 255 * glow[std::size_t(k)]) <= 0.5 + 1e-9, qPrintable(QString::number(p[k])));
        }
    }

    void everyOrderGivesTheSameBytes() {
        auto experiment = sampleExperiment({4, 0.8, true, 4});
        Random random(8);
        std::vector<std::string> cameras;
        for (const char* mode : {"color", "grey", "depth", "segmentation", "color"}) {
            const std::string name = "watcher" + std::to_string(cameras.size());
            experiment->robots.push_back(cameraRobot(name,
                                                     {{-1.5, 0.2 * double(cameras.size()), 0.5}, rotationFromHpr({0, 0.3, 0})},
                                                     {{"Mode", word(mode)},
                                                      {"Noise", numbers({cameras.size() == 4 ? 0.05 : 0.0})},
                                                      {"Resolution", numbers({160, 120})}}));
            cameras.push_back(name + "/eye");
        }
        const SignalLayout layout;
        const SignalBlock block(layout);
        std::map<std::string, std::vector<std::uint8_t>> first;
        CameraImageRenderer one(experiment, layout);
        for (const std::string& camera : cameras) first[camera] = mustTake(one.capture(camera, block)).pixels;
        QVERIFY(first[cameras[0]] != first[cameras[4]]);
        for (int round = 0; round < 3; ++round) {
            std::shuffle(cameras.begin(), cameras.end(), random);
            CameraImageRenderer other(experiment, layout);
            for (const std::string& camera : cameras)
                QVERIFY2(mustTake(other.capture(camera, block)).pixels == first[camera], camera.c_str());
            QVERIFY(mustTake(one.capture(cameras[0], block)).pixels == first[cameras[0]]);
        }
    }

    void noiseDependsOnSeedAndTick() {
        auto experiment = sampleExperiment({1, 1, true, 4});
        experiment->robots.push_back(cameraRobot("watcher", {{-1.5, 0, 0.5}, rotationFromHpr({0, 0.3, 0})},
                                                 {{"Noise", numbers({0.1})}, {"Resolution", numbers({160, 120})}}));
        const SignalLayout layout;
        SignalBlock block(layout);
        const auto taken = [&](std::uint64_t seed, std::uint64_t tick) {
            experiment->settings.seed = seed;
            block.header().tick = tick;
            return mustTake(CameraImageRenderer(experiment, layout).capture("watcher/eye", block)).pixels;
        };
        const auto once = taken(1, 5);
        QVERIFY(once == taken(1, 5));
        QVERIFY(once != taken(1, 6));
        QVERIFY(once != taken(2, 5));
        experiment->robots.back() = cameraRobot("watcher", experiment->robots.back().pose, {{"Resolution", numbers({160, 120})}});
        const auto clean = taken(1, 5);
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < clean.size(); ++i) {
            if (clean[i] < 90 || clean[i] > 165) continue; // no value is clipped
            sum += std::pow(double(once[i]) - clean[i], 2), count += 1;
        }
        QVERIFY(count > 1000);
        QVERIFY(std::abs(std::sqrt(sum / count) / 25.5 - 1) < 0.05);
    }

    void motionChangesOnlyItsPixels() {
        auto experiment = sampleExperiment({2, 1.4, true, 6});
        const Pose watch{{-2.2, -1.6, 1.3}, rotationFromHpr({0.6, 0.5, 0})};
        experiment->robots.push_back(cameraRobot("watcher", watch, {{"Resolution", numbers({320, 240})}}));
        const CameraImage before = mustTake(captureAtStart(experiment, "watcher/eye"));
        const CameraModel camera = onlyCameraOf(*experiment);
        const CameraView view = viewOf(camera, watch);

        double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
        const Vec3 sun(sunDirection().x(), sunDirection().y(), sunDirection().z());
        const auto cover = [&] { // the robot and its shadow
            auto now = std::make_shared<const ExperimentSpec>(*experiment);
            const ObjectIndex objects(now);
            const Bounds box = objects.boundsOf(*objects.find("robot0"), startPoses(*now));
            for (int i = 0; i < 8; ++i) {
                const Vec3 corner = box.corner(i);
                for (const Vec3& point : {corner, Vec3(corner - sun * (corner.z() / sun.z()))}) {
                    const auto p = project(view, 320, 240, point);
                    left = std::min(left, p->x), right = std::max(right, p->x);
                    top = std::min(top, p->y), bottom = std::max(bottom, p->y);
                }
            }
        };
        cover();
        experiment->robots[0].pose.position += Vec3(0.1, 0.05, 0);
        cover();
        const CameraImage after = mustTake(captureAtStart(experiment, "watcher/eye"));
        int inside = 0, outside = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 0; x < 320; ++x) {
                const std::size_t i = 3 * (std::size_t(y) * 320 + std::size_t(x));
                if (std::equal(before.pixels.begin() + long(i), before.pixels.begin() + long(i) + 3,
                               after.pixels.begin() + long(i)))
                    continue;
                const bool in = x + 1 > left && x < right && y + 1 > top && y < bottom;
                ++(in ? inside : outside);
            }
        }
        QVERIFY(inside > 100);
        QCOMPARE(outside, 0);
    }

    void objectsHaveNames() {
        auto experiment = sampleExperiment({1, 1, true, 4});
        experiment->robots.push_back(
            cameraRobot("watcher", {{-1.5, 0, 0.6}, rotationFromHpr({0, 0.35, 0})}, {{"Mode", word("segmentation")}}));
        const SignalLayout layout;
        const SignalBlock block(layout);
        CameraImageRenderer drawer(experiment, layout);
        const CameraImage frame = mustTake(drawer.capture("watcher/eye", block));
        const CameraView view = viewOf(onlyCameraOf(*experiment), experiment->robots[1].pose);
        const ObjectIndex objects(experiment);
        int compared = 0;
        std::set<std::string> met;
        for (int y = 4; y < 236; y += 9) {
            for (int x = 4; x < 316; x += 9) {
                const auto hits = castRay(objects, startPoses(*experiment), rayThrough(view, 320, 240, x + 0.5, y + 0.5));
                const std::string drawn = objectNames(*experiment).at(frame.objects[std::size_t(y) * 320 + std::size_t(x)]);
                bool rim = false; // a neighbouring pixel shows another object
                for (const int step : {-1, 1, -320, 320})
                    rim = rim || frame.objects[std::size_t(y * 320 + x + step)] != frame.objects[std::size_t(y * 320 + x)];
                if (rim) continue;
                QCOMPARE(drawn, hits.empty() ? std::string() : objects.pathOf(hits.front().geom, '/'));
                met.insert(drawn);
                ++compared;
            }
        }
        QVERIFY(compared > 500);
        for (const char* name : {"arena/floor", "arena/east", "robot0/chassis/hull"}) QVERIFY2(met.contains(name), name);
    }

    void nearAndFarCutThePicture() {
        for (const auto& [nearest, farthest, seen] : {std::tuple{0.1, 10.0, true}, {0.1, 1.5, false}, {4.5, 10.0, false}}) {
            auto experiment = lampExperiment({{3, 0, 0}}, 1.0);
            experiment->robots = {
                cameraRobot("robot0", {}, {{"Near", numbers({nearest})}, {"Far", numbers({farthest})}, {"Mode", word("depth")}})};
            const CameraImage frame = mustTake(captureAtStart(experiment, "robot0/eye"));
            QCOMPARE(std::isfinite(frame.depth[120 * 320 + 160]), seen);
        }
    }

    void exposureAndGreyAreOfTheColours() {
        const auto taken = [](CameraValues values) {
            auto experiment = lampExperiment({{3, 0, 0}}, 1.0);
            experiment->materials[0].emission = {0.4, 0.4, 0.2};
            values["Resolution"] = numbers({64, 48});
            experiment->robots = {cameraRobot("robot0", {}, values)};
            const CameraImage frame = mustTake(captureAtStart(experiment, "robot0/eye"));
            const std::uint8_t* p = frame.pixels.data() + 3 * (24 * 64 + 32);
            return std::array<int, 3>{p[0], p[1], p[2]};
        };
        QCOMPARE(taken({}), (std::array{102, 102, 51}));
        QCOMPARE(taken({{"Exposure", numbers({4})}}), (std::array{204, 204, 102}));
        QCOMPARE(taken({{"Mode", word("grey")}}), (std::array{96, 96, 96}));
    }

    void unknownCameraListsExisting() {
        auto experiment = lampExperiment({}, 1.0);
        experiment->robots = {cameraRobot("robot0", {}, {})};
        const Result<CameraImage> frame = captureAtStart(experiment, "robot0/ear");
        QVERIFY(!frame);
        QCOMPARE(frame.error().message, std::string("there is no camera robot0/ear; there is robot0/eye"));
    }

    void imageFileHasMetadata() {
        auto experiment = lampExperiment({{3, 0, 0}}, 1.0);
        experiment->robots = {cameraRobot("robot0", {}, {{"Resolution", numbers({64, 48})}})};
        const SignalLayout layout;
        SignalBlock block(layout);
        block.header().tick = 7;
        block.header().time = 0.07;
        CameraImageRenderer drawer(experiment, layout);
        const CameraImage frame = mustTake(drawer.capture("robot0/eye", block));
        for (const char* name : {"a.png", "a.jpg"}) {
            const Result<std::string> bytes = drawer.encode(frame, "robot0/eye", name);
            QVERIFY(bytes.ok());
            QVERIFY(bytes.value().find("time = 0.07 s; tick = 7; seed = 1; size = 64 x 48; camera = robot0/eye; mode = color") !=
                    std::string::npos);
            QVERIFY(bytes.value().starts_with(name[2] == 'p' ? "\x89PNG" : "\xff\xd8\xff\xfe"));
        }
        QVERIFY(!drawer.encode(frame, "robot0/eye", "a.gif").ok());
    }
};

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
