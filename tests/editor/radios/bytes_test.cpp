// The Radio dock changes no bit of a run, and exports the same bytes as the run's own logs.

#include "editor/radios/radio_window.h"
#include "eventually.h"

using namespace trundle;

class RadioBytesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theRunIsTheSameWithTheDockOpen_data() {
        QTest::addColumn<QByteArray>("medium");
        QTest::newRow("collisions") << QByteArray("Collisions=true");
        QTest::newRow("csma, walls and bit errors")
            << QByteArray("Collisions=true Mac=csma PacketErrors=true WallLoss=4 Model=log_distance Shadowing=3 Offsets=1");
    }
    void theRunIsTheSameWithTheDockOpen() {
        QFETCH(QByteArray, medium);
        RadioWindow window;
        QVERIFY(window.open(QByteArray(kMotes).replace("Collisions=true", medium)));
        window.selection.set({"target", "motes_3"});
        window.session.setSpeed(2); // slow enough that the dock fetches many times
        window.session.run();
        QTRY_COMPARE_WITH_TIMEOUT(window.session.state(), RunState::Ended, 60000);
        QVERIFY(window.settled());
        QVERIFY(!window.session.results().end->failure);
        const auto alone = window.headless(200, window.folder.filePath(QStringLiteral("alone")).toStdString());
        QVERIFY(alone.runner && alone.runner->finish().ok());
        QCOMPARE(*window.session.results().snapshot->hash, alone.runner->world().stateHash());
        QVERIFY(window.model().frameCount() > 500);
        QCOMPARE(window.model().frameCount(), alone.trace->records.size());

        // The export equals the logs of both runs.
        const QString csv = window.folder.filePath(QStringLiteral("mine.csv")),
                      pcap = window.folder.filePath(QStringLiteral("mine.pcap"));
        window.panel.packets().exportTo(csv);
        window.panel.packets().exportTo(pcap);
        QCOMPARE(window.reportOf.size(), std::size_t(2));
        QVERIFY2(window.reportOf.front().startsWith(QStringLiteral("Wrote")), qPrintable(window.reportOf.front()));
        const QByteArray expected = window.content(QStringLiteral("alone/frames.csv"));
        QVERIFY(expected.size() > 50000);
        QCOMPARE(window.content(QStringLiteral("logs/trial/frames.csv")), expected);
        QCOMPARE(window.content(QStringLiteral("mine.csv")), expected);
        const QByteArray frames = window.content(QStringLiteral("alone/frames.pcap"));
        QVERIFY(frames.size() > 2000);
        QCOMPARE(window.content(QStringLiteral("mine.pcap")), frames);
    }

    void readsPacketsDuringRun() {
        RadioWindow window;
        QVERIFY(window.open(kMotes));
        QVERIFY(window.runTo(70));
        const std::size_t early = window.model().frameCount();
        QVERIFY(early > 0);
        QCOMPARE(early, window.headless(70).trace->records.size());
        QVERIFY(window.runTo(140));
        QVERIFY(window.model().frameCount() > early);
        QCOMPARE(window.model().frameCount(), window.headless(140).trace->records.size());
        // A new run starts without frames.
        window.session.reset();
        QVERIFY(window.runTo(70));
        QCOMPARE(window.model().frameCount(), early);
    }

    void closedPanelStoresNoPackets() {
        RadioWindow window;
        QVERIFY(window.open(kMotes));
        window.panel.hide();
        window.session.setSpeed(0);
        window.session.runFor(0.7);
        QTRY_COMPARE_WITH_TIMEOUT(window.session.state(), RunState::Paused, 60000);
        window.panel.show();
        QVERIFY(window.settled());
        QCOMPARE(window.model().frameCount(), std::size_t(0));
        QVERIFY(window.find<QLabel>("radioHint")->isVisible());
        QVERIFY(window.find<QLabel>("radioHint")->text().contains(QStringLiteral("while this panel is open")));
        QVERIFY(window.runTo(140));
        const auto all = window.headless(140).trace->records;
        const auto late = std::ranges::count_if(all, [](const FrameRecord& r) { return r.time > 0.71; });
        QVERIFY(window.model().frameCount() >= std::size_t(late) && window.model().frameCount() < all.size());
        QVERIFY(!window.find<QLabel>("radioHint")->isVisible());
    }

    void behindAnotherTabItMissesNothing() {
        RadioWindow window;
        QVERIFY(window.open(kMotes));
        QWidget dock;
        dock.resize(1000, 300);
        window.panel.setParent(&dock);
        window.panel.show();
        dock.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dock, kTimeoutMs));
        window.panel.move(-2000, 0); // invisible, like a dock behind another one
        window.session.setSpeed(0);
        window.session.runFor(0.7);
        QTRY_COMPARE_WITH_TIMEOUT(window.session.state(), RunState::Paused, 60000);
        QVERIFY(window.panel.isVisible());
        QCOMPARE(window.model().frameCount(), std::size_t(0)); // invisible: nothing is fetched
        window.panel.move(0, 0);
        EVENTUALLY_EQUAL(window.model().frameCount(), window.headless(70).trace->records.size());
        window.panel.setParent(nullptr);
    }
};

QTEST_MAIN(RadioBytesTest)
#include "bytes_test.moc"
