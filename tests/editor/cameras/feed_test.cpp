// Which images the tiles have: while a run goes on its recent ones, and of a paused one exactly that of its state. The list of cameras.
#include <QtTest>

#include "editor/cameras/camera_feed.h"
#include "editor/cameras/camera_list.h"
#include "editor/cameras/camera_window.h"
#include "scene/queries/object_index.h"

using namespace trundle;

class FeedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }

    void aPausedRunIsShownAsItIs_data() {
        QTest::addColumn<quint64>("made"); // tick of the run's image; it pauses at 5
        QTest::addColumn<int>("drawn");
        QTest::newRow("older") << quint64(3) << 1;
        QTest::newRow("of this tick") << quint64(5) << 0;
    }
    void aPausedRunIsShownAsItIs() {
        QFETCH(quint64, made);
        QFETCH(int, drawn);
        ViewWindow window(m_render.get());
        QVERIFY(window.open(kTwoEyes));
        auto image = std::make_shared<CameraImage>();
        image->width = 160, image->height = 120, image->tick = made;
        image->pixels.assign(160 * 120 * 3, 99);
        CameraState state;
        state.experiment = window.document.loaded()->experiment;
        state.moment.poses = std::make_shared<BodyPoses>(startPoses(*state.experiment));
        state.moment.tick = 5;
        state.images["robot0/eye"] = {image, 10};
        state.running = true;
        CameraTiles tiles;
        tiles.resize(320, 240);
        tiles.show();
        QVERIFY(QTest::qWaitForWindowExposed(&tiles, kTimeoutMs));
        tiles.setCameras({{"robot0/eye", 4.0 / 3}});
        CameraFeed feed(m_render.get(), tiles);
        QVERIFY(feed.canDraw());
        const auto shown = [&] { return tiles.tiles().front().picture.frame; };
        feed.show(state);
        EVENTUALLY(feed.isSettled() && shown());
        QVERIFY(shown() == image && feed.drawnCount() == 0);
        state.running = false; // at the same state
        feed.show(state);
        QCOMPARE(feed.isSettled(), drawn == 0);
        EVENTUALLY(feed.isSettled());
        QCOMPARE(feed.drawnCount(), drawn);
        QCOMPARE(shown()->tick, std::uint64_t(5));
    }

    void firstCamerasAreChosenUntilTheUserChooses() {
        CameraList list;
        using Names = std::vector<std::string>;
        list.setCameras({"a", "b"});
        QCOMPARE(list.chosen(), (Names{"a", "b"}));
        list.setCameras({"a", "b", "c"});
        QCOMPARE(list.chosen(), (Names{"a", "b", "c"}));
        list.setCameras({"z", "a", "b", "c", "d", "e"});
        QCOMPARE(list.chosen(), (Names{"z", "a", "b", "c"}));
        list.setChosen({"b", "none"});
        QCOMPARE(list.chosen(), Names{"b"});
        list.setCameras({"a", "b", "c"});
        QCOMPARE(list.chosen(), Names{"b"});
        list.setCameras({"a", "c"});
        list.setCameras({"a", "b", "c"}); // it has been away
        QCOMPARE(list.chosen(), Names());
        list.reset();
        list.setCameras({"a", "b", "c"});
        QCOMPARE(list.chosen(), (Names{"a", "b", "c"}));
    }

private:
    std::unique_ptr<RenderService> m_render;
};

QTEST_MAIN(FeedTest)
#include "feed_test.moc"
