// Highlights, hidden objects, lines, ghosts and picking in views of the render service.
#include <QtTest>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "render/sample_experiment.h"
#include "render/started_service.h"

using namespace trundle;

namespace {

PictureRequest requestFor(SceneId scene) {
    PictureRequest request;
    request.scene = scene;
    CameraView view;
    view.eye = {1.6, -2.2, 1.8};
    view.target = {0, 0, 0.05};
    request.view = view;
    request.width = 400;
    request.height = 300;
    request.mask = kMaskSensor;
    request.samples = 1;
    return request;
}

int changed(const Image& a, const Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3)
        count += a.pixels[i] != b.pixels[i] || a.pixels[i + 1] != b.pixels[i + 1] || a.pixels[i + 2] != b.pixels[i + 2];
    return count;
}

} // namespace

class MarksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { startService(m_service); }

    void marksAreOutlinesInTheirColour_data() {
        QTest::addColumn<QString>("path");
        for (const char* path : {"robot0", "robot0/chassis", "robot0/chassis/bumper", "arena", "arena/north"})
            QTest::newRow(path) << path;
    }
    void marksAreOutlinesInTheirColour() {
        QFETCH(const QString, path);
        const SceneId scene = m_service->addScene(sampleExperiment({2, 1.0}));
        PictureRequest request = requestFor(scene);
        const Image plain = m_service->draw(request).get().value();
        request.marks.selected = {path.toStdString()};
        request.outline.selected = {255, 0, 255};
        const Image marked = m_service->draw(request).get().value();
        int pure = 0;
        for (std::size_t i = 0; i < marked.pixels.size(); i += 3)
            pure += marked.pixels[i] > 240 && marked.pixels[i + 1] < 60 && marked.pixels[i + 2] > 240;
        QVERIFY(pure > 30);
        QVERIFY(changed(plain, marked) < 6 * pure + 400); // lines, no areas
        request.marks = {};
        QVERIFY(m_service->draw(request).get().value() == plain);
        m_service->removeScene(scene);
    }

    /// An object or geom that was marked before it moved is outlined where it is now, selected or hovered.
    void marksFollowWhatMoves_data() { marksAreOutlinesInTheirColour_data(); }
    void marksFollowWhatMoves() {
        QFETCH(const QString, path);
        const auto experiment = sampleExperiment({2, 1.0});
        auto moved = std::make_shared<BodyPoses>(startPoses(*experiment));
        const Pose motion{{0.4, -0.3, 0.1}, rotationFromHpr({0.6, 0, 0})};
        for (std::size_t b = 0; b < 3; ++b) (*moved)[b] = motion * (*moved)[b]; // all bodies of robot0
        for (const bool hovers : {false, true}) {
            const SceneId scene = m_service->addScene(experiment), fresh = m_service->addScene(experiment);
            PictureRequest request = requestFor(scene);
            const Image plain = m_service->draw(request).get().value();
            (hovers ? request.marks.hovered : request.marks.selected) = {path.toStdString()};
            const Image before = m_service->draw(request).get().value();
            QVERIFY(changed(plain, before) > 30);
            request.poses = moved;
            const Image after = m_service->draw(request).get().value();
            request.scene = fresh;
            QVERIFY(m_service->draw(request).get().value() == after); // marked where it is
            request.scene = scene;
            request.poses = nullptr;
            QVERIFY(m_service->draw(request).get().value() == before);
            m_service->removeScene(scene);
            m_service->removeScene(fresh);
        }
    }

    void marksOfNothingChangeNothing() {
        const SceneId scene = m_service->addScene(sampleExperiment({1}));
        PictureRequest request = requestFor(scene);
        const Image plain = m_service->draw(request).get().value();
        request.marks.selected = {"", "/", "robot9", "robot0/", "robot0/chassis/nothing", "arena/floor"};
        request.marks.hovered = {"robot0//hull"};
        QVERIFY(m_service->draw(request).get().value() == plain);
    }

    void hidesAndShowsObjects_data() {
        QTest::addColumn<QString>("path");
        for (const char* path : {"robot0", "robot0/chassis", "robot0/chassis/hull", "arena", "arena/north", "arena/floor"})
            QTest::newRow(path) << path;
    }
    void hidesAndShowsObjects() {
        QFETCH(const QString, path);
        const SceneId scene = m_service->addScene(sampleExperiment({2, 1.0}));
        PictureRequest request = requestFor(scene);
        const Image plain = m_service->draw(request).get().value();
        request.hidden = {path.toStdString()};
        QVERIFY(changed(plain, m_service->draw(request).get().value()) > 100);
        request.hidden.clear();
        QVERIFY(m_service->draw(request).get().value() == plain);
        m_service->removeScene(scene);
    }

    void linesAndCollisionShapesAreDrawn() {
        const SceneId scene = m_service->addScene(shapesExperiment());
        PictureRequest request = requestFor(scene);
        const Image plain = m_service->draw(request).get().value();
        request.mask |= kMaskCollision;
        QVERIFY(changed(plain, m_service->draw(request).get().value()) > 300);
        request.mask = kMaskSensor;
        request.wireframe = true;
        QVERIFY(changed(plain, m_service->draw(request).get().value()) > 1000);
        request.wireframe = false;
        QVERIFY(m_service->draw(request).get().value() == plain);
    }

    void drawsGhostsInRequestedViews() {
        auto ghost = std::make_shared<ExperimentSpec>(*sampleExperiment({1}));
        ghost->robots[0].pose.position = {0.6, -0.4, 0};
        ghost->statics.clear();
        const auto experiment = sampleExperiment({1});
        const SceneId scene = m_service->addScene(experiment, ghost), without = m_service->addScene(experiment);
        const Image plain = m_service->draw(requestFor(without)).get().value();
        QVERIFY(m_service->draw(requestFor(scene)).get().value() == plain); // sensor images show no marks
        PictureRequest request = requestFor(scene);
        request.mask |= kMaskGhosts;
        QVERIFY(changed(plain, m_service->draw(request).get().value()) > 300);
        PickRequest pick{scene, *request.view, 400, 300};
        const auto at = project(*request.view, 400, 300, {0.6, -0.4, 0.1});
        pick.x = at->x, pick.y = at->y;
        QVERIFY(m_service->pick(pick).get().value().path.find("robot") == std::string::npos);
    }

    void everythingBelowAPixelIsPickedInOrder() {
        const SceneId scene = m_service->addScene(sampleExperiment({1}));
        CameraView down;
        down.eye = {0.06, 0.125, 3};
        down.target = {0.06, 0.125, 0};
        PickRequest request{scene, down, 200, 200, 100, 100};
        request.mask |= kMaskFloor;
        std::promise<std::vector<std::string>> promise;
        m_service->pickAll(request, [&](Result<std::vector<PickResult>> all) {
            std::vector<std::string> paths;
            for (const PickResult& picked : all.value()) paths.push_back(picked.path);
            promise.set_value(paths);
        });
        QCOMPARE(promise.get_future().get(), (std::vector<std::string>{"robot0/leftWheel/tyre", "arena/floor"}));
    }

    void drawsCaptureBeforeViews() {
        const SceneId scene = m_service->addScene(sampleExperiment({4}));
        std::mutex mutex;
        std::condition_variable changed;
        std::vector<int> order;
        bool go = false;
        const auto note = [&](int which) {
            return [&, which](Result<Image>) {
                std::unique_lock lock(mutex);
                if (which == 0) changed.wait(lock, [&] { return go; }); // blocks the render thread until all requests are posted
                order.push_back(which);
                changed.notify_all();
            };
        };
        PictureRequest view = requestFor(scene), capture = view;
        capture.capture = true;
        m_service->draw(view, note(0));
        for (const int i : {1, 2}) m_service->draw(view, note(i));
        const SceneId late = m_service->addScene(sampleExperiment({1}));
        m_service->draw(requestFor(late), note(3));
        capture.scene = late;
        m_service->draw(capture, note(10)); // needs the scene that was added last
        capture.scene = scene;
        m_service->draw(capture, note(11));
        std::unique_lock lock(mutex);
        go = true;
        changed.notify_all();
        changed.wait(lock, [&] { return order.size() == 6; });
        QCOMPARE(order, (std::vector<int>{0, 1, 2, 10, 11, 3}));
    }

    void aServiceStartedInTheBackgroundAnswers() {
        auto service = RenderService::startInBackground();
        const SceneId scene = service->addScene(sampleExperiment({1}));
        std::promise<bool> promise;
        service->draw(requestFor(scene), [&](Result<Image> image) { promise.set_value(image.ok()); });
        QVERIFY(promise.get_future().get());
        QVERIFY(!service->renderer().empty());
    }

private:
    std::unique_ptr<RenderService> m_service;
};

QTEST_APPLESS_MAIN(MarksTest)
#include "marks_test.moc"
