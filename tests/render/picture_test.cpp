// Images of the render service: geometry, colours, shadows, requests.
#include <QtTest>

#include <numbers>
#include <random>

#include "render/sample_experiment.h"
#include "render/started_service.h"
#include "scene/queries/framing.h"
#include "scene/shaders/scene_shading.h"

using namespace trundle;

namespace {

struct Spot {
    double x = 0, y = 0;
    int pixels = 0;
};

/// Centroid of all pure red pixels.
Spot redSpot(const Image& image) {
    Spot spot;
    double weight = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::uint8_t* p = image.at(x, y);
            if (p[0] < 200 || p[1] > 60 || p[2] > 60) continue;
            spot.x += x + 0.5, spot.y += y + 0.5, weight += 1, ++spot.pixels;
        }
    }
    spot.x /= weight, spot.y /= weight;
    return spot;
}

PictureRequest requestFor(SceneId scene, const CameraView& view, std::uint32_t width = 320, std::uint32_t height = 240) {
    PictureRequest request;
    request.scene = scene;
    request.view = view;
    request.width = width;
    request.height = height;
    request.mask = kMaskSensor;
    request.samples = 1;
    return request;
}

CameraView lookingAt(const Vec3& eye, const Vec3& target) {
    CameraView view;
    view.eye = eye;
    view.target = target;
    return view;
}

} // namespace

class PictureTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { startService(m_service); }

    void projectsKnownPointsByPinholeModel() {
        std::mt19937 random(11);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int seen = 0;
        for (int i = 0; i < 60; ++i) {
            CameraView view = lookingAt({any(-5, 5), any(-5, 5), any(-5, 5)}, {any(-5, 5), any(-5, 5), any(-5, 5)});
            if (!isUsable(view)) continue;
            view.up = {any(-1, 1), any(-1, 1), any(-1, 1)};
            view.fieldOfView = any(20, 110) * std::numbers::pi / 180;
            if (i % 4 == 0) view.orthographicWidth = any(1, 10);
            const std::uint32_t width = 200 + random() % 300, height = 150 + random() % 300;
            // A visible position, three to eight metres away and not near the border of the image.
            const ViewRay ray = rayThrough(view, width, height, any(0.15, 0.85) * width, any(0.15, 0.85) * height);
            const Vec3 lamp = ray.origin + ray.direction * any(3, 8);
            const auto expected = project(view, width, height, lamp);
            QVERIFY(expected);
            // A radius of a few pixels, so that the silhouette is nearly a circle about the projected centre.
            const double pixel = view.orthographicWidth > 0 ? view.orthographicWidth / width
                                                            : 2 * expected->depth * std::tan(0.5 * view.fieldOfView) / width;
            const SceneId scene = m_service->addScene(lampExperiment({lamp}, 4 * pixel));
            const auto image = m_service->draw(requestFor(scene, view, width, height)).get();
            m_service->removeScene(scene);
            QVERIFY2(image.ok(), image.ok() ? "" : image.error().message.c_str());
            const Spot spot = redSpot(image.value());
            QVERIFY2(spot.pixels > 20, qPrintable(QString("lamp %1 is not to be seen").arg(i)));
            QVERIFY2(std::hypot(spot.x - expected->x, spot.y - expected->y) < 0.5,
                     qPrintable(QString("picture %1: seen at %2 %3, expected %4 %5")
                                    .arg(i)
                                    .arg(spot.x)
                                    .arg(spot.y)
                                    .arg(expected->x)
                                    .arg(expected->y)));
            ++seen;
        }
        QVERIFY(seen >= 50);
    }

    void anUnlitColourIsExact() {
        const auto experiment = lampExperiment({{0, 0, 0}}, 1);
        experiment->materials[0].emission = {40 / 255.0, 200 / 255.0, 120 / 255.0};
        const SceneId scene = m_service->addScene(experiment);
        PictureRequest request = requestFor(scene, lookingAt({0, -3, 1}, Vec3::Zero()));
        const auto image = m_service->draw(request).get();
        QVERIFY(image.ok());
        const std::uint8_t* middle = image.value().at(160, 120);
        // Black diffuse colour, and emission so strong that highlights do not show.
        QVERIFY(std::abs(middle[0] - 40) <= 1 && std::abs(middle[1] - 200) <= 1 && std::abs(middle[2] - 120) <= 1);
    }

    void theSamePictureHasTheSameBytes() {
        const auto experiment = sampleExperiment({9});
        const SceneId scene = m_service->addScene(experiment);
        std::vector<PictureRequest> requests;
        requests.push_back(requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 400, 300));
        requests.push_back(requestFor(scene, lookingAt({-3, 1, 0.5}, Vec3::Zero()), 640, 480));
        requests.push_back(requests[0]);
        requests.back().mask = kMaskStill;
        requests.back().samples = 4;
        std::vector<Image> first;
        for (const PictureRequest& r : requests) {
            const auto image = m_service->draw(r).get();
            QVERIFY(image.ok());
            first.push_back(image.value());
        }
        QVERIFY(!(first[0] == first[2]));
        // In another order, and from another service with its own scene.
        auto other = RenderService::start();
        QVERIFY(other.ok());
        const SceneId otherScene = other.value()->addScene(experiment);
        for (const std::size_t i : {2u, 0u, 1u, 0u}) {
            QVERIFY(m_service->draw(requests[i]).get().value() == first[i]);
            PictureRequest request = requests[i];
            request.scene = otherScene;
            QVERIFY(other.value()->draw(request).get().value() == first[i]);
        }
        QCOMPARE(pngBytes(first[0]).value(), pngBytes(first[0]).value());
    }

    void aMovedRobotChangesThePictureWhereItIsAndWasAndNowhereElse() {
        const auto experiment = sampleExperiment({4, 1.2});
        const SceneId scene = m_service->addScene(experiment);
        CameraView view = lookingAt({3, -4, 3}, Vec3::Zero());
        view.nearPlane = 0.05;
        PictureRequest request = requestFor(scene, view, 640, 480);
        const Image before = m_service->draw(request).get().value();
        auto poses = std::make_shared<BodyPoses>(startPoses(*experiment));
        for (int body = 0; body < 3; ++body) (*poses)[std::size_t(body)].position += Vec3(0.4, 0.1, 0);
        request.poses = poses;
        const Image after = m_service->draw(request).get().value();

        // All that belongs to the robot lies in a ball of 25 cm; its shadow is that ball's, flattened along the sun.
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        const osg::Vec3 s = sunDirection();
        for (const Vec3& middle : {Vec3(-0.6, -0.6, 0.05), Vec3(-0.2, -0.5, 0.05)}) {
            for (int i = 0; i < 8; ++i) {
                const Vec3 corner = middle + 0.25 * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -0.2);
                const Vec3 shadow = corner - Vec3(s.x(), s.y(), s.z()) * (corner.z() / s.z());
                for (const Vec3& p : {corner, shadow}) {
                    const auto at = project(view, 640, 480, p);
                    left = std::min(left, at->x), right = std::max(right, at->x), top = std::min(top, at->y),
                    bottom = std::max(bottom, at->y);
                }
            }
        }
        int changed = 0;
        for (std::uint32_t y = 0; y < 480; ++y) {
            for (std::uint32_t x = 0; x < 640; ++x) {
                if (std::equal(before.at(x, y), before.at(x, y) + 3, after.at(x, y))) continue;
                ++changed;
                QVERIFY2(x + 1 >= left && x <= right && y + 1 >= top && y <= bottom,
                         qPrintable(QString("%1 %2 changed").arg(x).arg(y)));
            }
        }
        QVERIFY(changed > 1000);
        QVERIFY((right - left) * (bottom - top) < 0.25 * 640 * 480); // the region is smaller than the image
    }

    void maskOmitsObjects() {
        const SceneId scene = m_service->addScene(sampleExperiment({1}));
        PictureRequest request = requestFor(scene, lookingAt({1, -1.5, 1}, Vec3::Zero()));
        const Image all = m_service->draw(request).get().value();
        for (const std::uint32_t without : {kMaskRobots, kMaskStatics, kMaskFloor, kMaskShadows}) {
            request.mask = kMaskSensor & ~without;
            QVERIFY2(!(m_service->draw(request).get().value() == all), qPrintable(QString::number(without)));
        }
        // A shadow alone is darker than the floor and nothing else.
        request.mask = kMaskSensor & ~kMaskShadows;
        const Image bare = m_service->draw(request).get().value();
        for (std::size_t i = 0; i < all.pixels.size(); ++i) QVERIFY(all.pixels[i] <= bare.pixels[i]);
    }

    void aShadowTouchesWhatCastsIt() {
        // Seen from straight above: one step away from the sun at the foot of a wall the floor is dark, towards the sun it is light.
        const SceneId scene = m_service->addScene(sampleExperiment({1}));
        CameraView view = lookingAt({0, 0, 3}, Vec3::Zero());
        view.up = Vec3::UnitY();
        PictureRequest request = requestFor(scene, view, 800, 800);
        const Image image = m_service->draw(request).get().value();
        const auto brightness = [&](const Vec3& p) {
            const auto at = project(view, 800, 800, p);
            const std::uint8_t* rgb = image.at(std::uint32_t(at->x), std::uint32_t(at->y));
            return rgb[0] + rgb[1] + rgb[2];
        };
        // Close behind the bumper's right end, 5 cm above the floor at its lower edge.
        const osg::Vec3 s = sunDirection();
        const Vec3 edge(0.171, -0.1, 0.07);
        const Vec3 foot = edge - Vec3(s.x(), s.y(), s.z()) * (edge.z() / s.z());
        QVERIFY(brightness(foot + Vec3(0.005, 0, 0)) < 0.8 * brightness({0.5, -0.5, 0}));
        QVERIFY(brightness(foot + Vec3(0.06, 0, 0)) > 0.9 * brightness({0.5, -0.5, 0}));
    }

    /// The edge of a soft shadow is wider at its tip than in its middle; that of a plain one is sharp in both.
    void softShadowsSoftenWithTheDistance() {
        const double height = 0.8;
        const auto experiment = boxOnFloor({0.2, 0.2, height}, {0, 0, height / 2});
        const osg::Vec3 s = sunDirection();
        const Vec3 along = Vec3(-s.x(), -s.y(), 0).normalized(), aside(-along.y(), along.x(), 0);
        const double length = height * std::hypot(s.x(), s.y()) / s.z();
        CameraView view = lookingAt({0, 0, 3}, Vec3::Zero());
        view.up = Vec3::UnitY();
        PictureRequest request = requestFor(m_service->addScene(experiment), view, 1600, 1600);
        request.view->fieldOfView = 0.6;
        // Pixels of the shadow's edge that are neither dark nor light, at a share of its length.
        const auto edge = [&](std::uint32_t shadows, double share) {
            request.mask = kMaskWorld | shadows;
            const Image image = m_service->draw(request).get().value();
            const auto brightness = [&](double off) {
                const auto at = project(*request.view, 1600, 1600, share * length * along + off * aside);
                return int(image.at(std::uint32_t(at->x), std::uint32_t(at->y))[1]);
            };
            const int dark = brightness(0), light = brightness(0.4);
            if (light - dark < 30) return -1;
            int between = 0;
            for (double off = 0; off < 0.4; off += 0.0005) between += brightness(off) > dark + 6 && brightness(off) < light - 6;
            return between;
        };
        const int middle = edge(kMaskSoftShadows, 0.5), tip = edge(kMaskSoftShadows, 0.95);
        const int sharpMiddle = edge(kMaskShadows, 0.5), sharpTip = edge(kMaskShadows, 0.95);
        const QByteArray all =
            QStringLiteral("%1 %2, sharp %3 %4").arg(middle).arg(tip).arg(sharpMiddle).arg(sharpTip).toLatin1();
        QVERIFY2(sharpMiddle >= 0 && sharpMiddle < 20 && sharpTip >= 0 && sharpTip < 20, all);
        QVERIFY2(middle > 30 && 4 * tip > 5 * middle, all);
    }

    /// The eye is close above the floor, and the only object is far away.
    void floorNearTheEyeIsNotCut() {
        const SceneId scene = m_service->addScene(boxOnFloor({1, 1, 1}, {20, 0, 0.5}));
        for (const double height : {0.1, 0.5}) {
            const Vec3 eye(0, 0, height);
            PictureRequest request = requestFor(scene, lookingAt(eye, {height, 0, 0}));
            request.mask = kMaskWorld;
            const Image chosen = m_service->draw(request).get().value();
            request.view->nearPlane = 0.01;
            const Image whole = m_service->draw(request).get().value();
            int differing = 0;
            for (std::size_t i = 0; i < whole.pixels.size(); ++i) differing += std::abs(whole.pixels[i] - chosen.pixels[i]) > 2;
            QVERIFY2(differing < int(whole.pixels.size()) / 200, qPrintable(QString::number(differing)));
        }
    }

    void everyShapeIsDrawn() {
        const auto experiment = shapesExperiment();
        const SceneId scene = m_service->addScene(experiment);
        const CameraView view = defaultView(*experiment, startPoses(*experiment), 640, 360);
        for (const auto& [path, place] : std::vector<std::pair<std::string, Vec3>>{{"things/pyramid", {1.4, 1.25, 0.3}},
                                                                                   {"things/hill", {-1.4, 1.4, 0.4}},
                                                                                   {"things/missing", {0, 1.8, 0.1}},
                                                                                   {"things/pill", {0.9, -1.2, 0.5}},
                                                                                   {"things/ball", {0, 0.6, 0.3}},
                                                                                   {"things/column", {-1.8, -1.2, 0.7}},
                                                                                   {"things/glass", {1.8, -0.4, 0.4}},
                                                                                   {"things/crate", {-1.2, -0.4, 0.4}}}) {
            const auto at = project(view, 640, 360, place);
            const auto picked = m_service->pick({scene, view, 640, 360, at->x, at->y}).get();
            QVERIFY(picked.ok());
            QCOMPARE(picked.value().path, path);
        }
        PictureRequest request = requestFor(scene, view, 640, 360);
        const Image all = m_service->draw(request).get().value();
        request.mask &= ~kMaskStatics;
        const Image without = m_service->draw(request).get().value();
        std::size_t differing = 0;
        for (std::size_t i = 0; i < all.pixels.size(); ++i) differing += all.pixels[i] != without.pixels[i];
        QVERIFY(differing > 20000);
    }

    void aRequestThatCannotBeServedIsAnError() {
        const SceneId scene = m_service->addScene(sampleExperiment({1}));
        const auto failure = [&](auto change) {
            PictureRequest request = requestFor(scene, lookingAt({1, -1.5, 1}, Vec3::Zero()), 64, 48);
            change(request);
            const auto image = m_service->draw(request).get();
            return image.ok() ? std::string("drawn") : codeName(image.error().code) + " " + image.error().message;
        };
        QCOMPARE(failure([](PictureRequest&) {}), std::string("drawn"));
        QCOMPARE(failure([](PictureRequest& r) { r.width = 0; }),
                 std::string("E511 a picture has 1 to 4096 pixels along each side, not 0 x 48"));
        QCOMPARE(failure([](PictureRequest& r) { r.height = 4097; }),
                 std::string("E511 a picture has 1 to 4096 pixels along each side, not 64 x 4097"));
        QCOMPARE(failure([](PictureRequest& r) { r.view->eye = r.view->target; }),
                 std::string("E511 no picture can be taken from this view"));
        QCOMPARE(failure([](PictureRequest& r) { r.scene = SceneId(12345); }), std::string("E511 there is no such scene"));
        QCOMPARE(failure([](PictureRequest& r) { r.poses = std::make_shared<BodyPoses>(7); }),
                 std::string("E511 poses of 7 bodies for a scene of 3"));
        QCOMPARE(failure([](PictureRequest& r) { r.width = r.height = 1; }), std::string("drawn"));
        QCOMPARE(failure([](PictureRequest& r) { r.samples = 1000; }), std::string("drawn"));
        QCOMPARE(failure([](PictureRequest& r) { r.mask = 0; }), std::string("drawn"));
        m_service->removeScene(scene);
        QCOMPARE(failure([](PictureRequest&) {}), std::string("E511 there is no such scene"));
    }

    void everySizeIsReadRowByRow() {
        // Widths that are not a multiple of four: row alignment must not shift pixels.
        const SceneId scene = m_service->addScene(lampExperiment({{0, 0, 0}}, 0.2));
        for (const std::uint32_t width : {63u, 64u, 65u, 66u, 4096u}) {
            const auto image = m_service->draw(requestFor(scene, lookingAt({0, -3, 0}, Vec3::Zero()), width, 41)).get();
            QVERIFY(image.ok());
            QCOMPARE(image.value().pixels.size(), std::size_t(width) * 41 * 3);
            const Spot spot = redSpot(image.value());
            QVERIFY(std::abs(spot.x - 0.5 * width) < 0.6 && std::abs(spot.y - 20.5) < 0.6);
        }
    }

    void rendersManySizesAndScenes() {
        for (int i = 0; i < 30; ++i) {
            const SceneId scene = m_service->addScene(sampleExperiment({1 + i % 3}));
            QVERIFY(
                m_service->draw(requestFor(scene, lookingAt({1, -1.5, 1}, Vec3::Zero()), 40 + std::uint32_t(i), 30)).get().ok());
            m_service->removeScene(scene);
        }
    }

    void newerPictureReplacesOlder() {
        const SceneId scene = m_service->addScene(sampleExperiment({30}));
        PictureRequest request = requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 800, 600);
        request.stream = 5;
        std::vector<std::future<Result<Image>>> pictures;
        for (int i = 0; i < 20; ++i) pictures.push_back(m_service->draw(request));
        int drawn = 0;
        for (auto& picture : pictures) drawn += picture.get().ok();
        QVERIFY(drawn >= 1 && drawn < 20);
    }

    void refinementYieldsToOtherRequests() {
        const SceneId scene = m_service->addScene(sampleExperiment({100}));
        PictureRequest fine = requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 2048, 2048);
        fine.mask = kMaskStill;
        fine.samples = 4;
        fine.yields = true;
        const PictureRequest quick = requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 64, 48);
        const Image expected = m_service->draw(quick).get().value();
        for (int i = 0; i < 5; ++i) { // while it waits, or while it is drawn
            auto first = m_service->draw(fine), second = m_service->draw(quick);
            const auto ended = first.get(), drawn = second.get();
            QVERIFY(!ended.ok());
            QCOMPARE(ended.error().message, std::string());
            QVERIFY(drawn.ok() && drawn.value() == expected);
        }
        // A fine request does not cancel another fine one, and cancelled requests leave no state.
        fine.width = fine.height = 200;
        auto one = m_service->draw(fine), other = m_service->draw(fine);
        const auto a = one.get(), b = other.get();
        QVERIFY(a.ok() && b.ok());
        fine.yields = false;
        QVERIFY(a.value() == b.value() && a.value() == m_service->draw(fine).get().value());
    }

    void acceptsRequestsOfManyThreads() {
        const SceneId scene = m_service->addScene(sampleExperiment({4}));
        const PictureRequest request = requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 80, 60);
        const Image expected = m_service->draw(request).get().value();
        std::vector<std::future<bool>> results;
        for (int i = 0; i < 4; ++i) {
            results.push_back(std::async(std::launch::async, [&] {
                bool same = true;
                for (int k = 0; k < 10; ++k) same = m_service->draw(request).get().value() == expected && same;
                return same;
            }));
        }
        for (auto& result : results) QVERIFY(result.get());
    }

    void aServiceThatEndsAnswersEverything() {
        auto started = RenderService::start();
        QVERIFY(started.ok());
        auto service = std::move(started).value();
        const SceneId scene = service->addScene(sampleExperiment({30}));
        std::vector<std::future<Result<Image>>> pictures;
        for (int i = 0; i < 10; ++i)
            pictures.push_back(service->draw(requestFor(scene, lookingAt({2, -3, 2}, Vec3::Zero()), 800, 600)));
        service.reset();
        for (auto& picture : pictures) (void)picture.get(); // an image or an error, but never an endless wait
    }

private:
    std::unique_ptr<RenderService> m_service;
};

QTEST_APPLESS_MAIN(PictureTest)
#include "picture_test.moc"
