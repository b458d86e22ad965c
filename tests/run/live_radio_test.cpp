// Radio records of a live run: complete and in order while a listener is registered, limited in number.

#include <QtTest>

#include "radio/air.h"
#include "run/live/live_radio.h"

using namespace air;

class LiveRadioTest : public QObject {
    Q_OBJECT

    static void tick(RadioTraceQueue& tap, Medium& medium, int number) {
        tap.beforeTick(medium);
        (void)send(medium, 0, 4);
        medium.advance((number + 1) * 10000);
        tap.afterTick(medium);
    }

private Q_SLOTS:
    void keepsPacketsWhileEnabled() {
        Medium medium{MediumSettings()};
        open(medium, "a/radio", Vec3::Zero());
        open(medium, "b/radio", Vec3(1, 0, 0));
        RadioTraceQueue tap;
        QVERIFY(!tap.take().radios);
        tap.open(medium);
        QCOMPARE(tap.take().radios->at(1).path, std::string("b/radio"));
        tick(tap, medium, 0);
        LiveRadio taken = tap.take();
        QVERIFY(taken.records.empty() && taken.frames.empty());
        QCOMPARE(taken.expected, std::uint64_t(1)); // counted although not recorded
        tap.setEnabled(true);
        for (int i = 1; i < 4; ++i) tick(tap, medium, i);
        taken = tap.take();
        QCOMPARE(taken.records.size(), std::size_t(3));
        QCOMPARE(taken.frames.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) QCOMPARE(taken.records[i].time, 0.01 * double(i + 1));
        QCOMPARE(taken.expected, std::uint64_t(4));
        QCOMPARE(taken.outcomes[std::size_t(ReceptionOutcome::Delivered)], std::uint64_t(4));
        QVERIFY(tap.take().records.empty());
        tap.setEnabled(false);
        tick(tap, medium, 4);
        QVERIFY(tap.take().records.empty());
    }

    void dropsOldestFirst() {
        Medium medium{MediumSettings()};
        open(medium, "a/radio", Vec3::Zero());
        open(medium, "b/radio", Vec3(1, 0, 0));
        RadioTraceQueue tap;
        tap.open(medium);
        tap.setEnabled(true);
        const int ticks = int(RadioTraceQueue::kMost) + 5;
        for (int i = 0; i < ticks; ++i) tick(tap, medium, i);
        LiveRadio taken = tap.take();
        QCOMPARE(taken.records.size(), RadioTraceQueue::kMost);
        QCOMPARE(taken.frames.size(), RadioTraceQueue::kMost);
        QCOMPARE(taken.droppedRecords, std::uint64_t(5));
        QCOMPARE(taken.droppedFrames, std::uint64_t(5));
        QCOMPARE(taken.records.front().time, 0.05);
        QCOMPARE(tap.take().droppedRecords, std::uint64_t(0));
    }

    void dropsWeakPacketsFirst() {
        Medium medium{MediumSettings()};
        open(medium, "a/radio", Vec3::Zero());
        open(medium, "b/radio", Vec3(1, 0, 0));
        for (int i = 0; i < 9; ++i) {
            RadioDefinition deaf = radioNamed("deaf" + std::to_string(i));
            deaf.minReceivePower = 10;
            open(medium, deaf, Vec3(2, i, 0));
        }
        RadioTraceQueue tap;
        tap.open(medium);
        tap.setEnabled(true);
        constexpr int kTicks = 1000; // ten records each, nine of them too weak
        for (int i = 0; i < kTicks; ++i) tick(tap, medium, i);
        const LiveRadio taken = tap.take();
        const auto kept = std::ranges::count(taken.records, ReceptionOutcome::Delivered, &FrameRecord::outcome) +
                          std::ranges::count(taken.records, ReceptionOutcome::BufferFull, &FrameRecord::outcome);
        QCOMPARE(kept, kTicks);
        QCOMPARE(taken.records.size() + taken.droppedRecords, std::uint64_t(10 * kTicks));
        QVERIFY(taken.records.size() < RadioTraceQueue::kDropWeakAbove + kTicks);
        QCOMPARE(taken.outcomes[std::size_t(ReceptionOutcome::TooWeak)], std::uint64_t(9 * kTicks)); // counted, not recorded
    }
};

QTEST_GUILESS_MAIN(LiveRadioTest)
#include "live_radio_test.moc"
