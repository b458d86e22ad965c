// Due times of periodic work in ticks.
#include <QtTest>

#include "run/runner.h"
#include "run/schedule.h"

using namespace trundle;

class ScheduleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ticksOfADuration_data();
    void ticksOfADuration();
    void rowsFallOnTheFirstTickNotBefore_data();
    void rowsFallOnTheFirstTickNotBefore();
    void periodsNearTheTick_data();
    void periodsNearTheTick();
    void longTimes_data();
    void longTimes();
    void aPeriodBelowTheTickIsEveryTick();
    void leftOutTicksAreNotMadeUpFor();
    void timesReadAsPeopleWriteThem();
};

void ScheduleTest::ticksOfADuration_data() {
    QTest::addColumn<double>("duration");
    QTest::addColumn<double>("tick");
    QTest::addColumn<quint64>("ticks");
    QTest::newRow("12 s of 10 ms") << 12.0 << 0.01 << quint64(1200);
    QTest::newRow("0.3 s of 0.1 s is 3, not 4") << 0.3 << 0.1 << quint64(3);
    QTest::newRow("1 s of 30 ms is rounded up") << 1.0 << 0.03 << quint64(34);
    QTest::newRow("nothing") << 0.0 << 0.01 << quint64(0);
    QTest::newRow("less than a tick") << 0.001 << 0.01 << quint64(1);
    QTest::newRow("a thousand hours") << 3.6e6 << 0.001 << quint64(3600000000ull);
    QTest::newRow("beyond all counting") << 1e300 << 1e-3 << quint64(9000000000000000000ull);
}

void ScheduleTest::ticksOfADuration() {
    QFETCH(double, duration);
    QFETCH(double, tick);
    QTEST(static_cast<quint64>(ticksFor(duration, tick)), "ticks");
}

void ScheduleTest::rowsFallOnTheFirstTickNotBefore_data() {
    QTest::addColumn<double>("period");
    QTest::addColumn<double>("tick");
    QTest::addColumn<QList<quint64>>("first");
    QTest::newRow("0.1 s at 10 ms") << 0.1 << 0.01 << QList<quint64>{0, 10, 20, 30, 40, 50, 60, 70};
    QTest::newRow("0.1 s at 30 ms") << 0.1 << 0.03 << QList<quint64>{0, 4, 7, 10, 14, 17, 20};
    QTest::newRow("0.07 s at 10 ms") << 0.07 << 0.01 << QList<quint64>{0, 7, 14, 21, 28, 35, 42, 49};
    QTest::newRow("1 s at 1/3 s") << 1.0 << 1.0 / 3 << QList<quint64>{0, 3, 6, 9};
}

void ScheduleTest::rowsFallOnTheFirstTickNotBefore() {
    QFETCH(double, period);
    QFETCH(double, tick);
    QFETCH(QList<quint64>, first);
    Schedule schedule(period, tick);
    QList<quint64> due;
    for (quint64 n = 0; n <= first.last(); ++n)
        if (schedule.due(n)) due << n;
    QCOMPARE(due, first);
}

/// Period and tick as whole numbers of the same unit, so that the expected ticks are exact.
void ScheduleTest::periodsNearTheTick_data() {
    QTest::addColumn<int>("period");
    QTest::addColumn<int>("tick");
    QTest::addColumn<int>("unit"); // in 1 s
    for (const int period : {10, 11, 15, 19, 20, 21, 25, 30, 33, 99})
        for (const auto& [tick, unit] : {std::pair{10, 1000}, {10, 100}, {7, 1000}, {3, 100}, {10, 333}})
            if (period >= tick) QTest::addRow("%d/%d at %d", period, unit, tick) << period << tick << unit;
}

void ScheduleTest::periodsNearTheTick() {
    QFETCH(int, period);
    QFETCH(int, tick);
    QFETCH(int, unit);
    Schedule schedule(double(period) / unit, double(tick) / unit);
    std::uint64_t count = 0; // of due times so far
    for (std::uint64_t n = 0; n < 300000; ++n) {
        const std::uint64_t next = (count * period + tick - 1) / tick; // the first tick at or after it
        if (schedule.due(n) != (n == next)) QFAIL(qPrintable(QString("tick %1, expected %2").arg(n).arg(next)));
        count += n == next;
    }
}

void ScheduleTest::longTimes_data() {
    QTest::addColumn<quint64>("tick");
    QTest::addColumn<quint64>("unit");
    for (const auto& [tick, unit] : {std::pair{1, 100}, {1, 1000}, {3, 100}, {7, 1000}, {1, 30}, {25, 10000}})
        QTest::addRow("%d/%d s", tick, unit) << quint64(tick) << quint64(unit);
}

/// After days: a time of whole ticks is that tick, a little more is the next one.
void ScheduleTest::longTimes() {
    QFETCH(quint64, tick);
    QFETCH(quint64, unit);
    const double h = double(tick) / double(unit);
    for (std::uint64_t scale = 1; scale <= 10'000'000'000ull; scale *= 10)
        for (const std::uint64_t some : {2000003ull, 2097153ull, 4999999ull, 7654321ull, 9999999ull}) {
            const std::uint64_t ticks = some * scale / 1000;
            if (ticks * tick > 1ull << 52) continue;
            const double time = double(ticks * tick) / double(unit); // as it is read from its decimal digits
            QCOMPARE(ticksFor(time, h), ticks);
            QCOMPARE(firstTickAt(time, h), ticks);
            QCOMPARE(firstTickAt(double(ticks) * h, h), ticks);
            if (ticks > 1'000'000'000'000ull) continue; // a thousandth of a tick is no more than rounding there
            QCOMPARE(ticksFor(time + h / 1000, h), ticks + 1);
            QCOMPARE(firstTickAt(time + h / 1000, h), ticks + 1);
        }
}

void ScheduleTest::aPeriodBelowTheTickIsEveryTick() {
    for (const double period : {0.0, 1e-300, 0.005, 0.01}) {
        Schedule schedule(period, 0.01);
        for (std::uint64_t n = 0; n < 5; ++n) QVERIFY(schedule.due(n));
    }
}

void ScheduleTest::leftOutTicksAreNotMadeUpFor() {
    Schedule schedule(0.1, 0.01);
    QVERIFY(schedule.due(0));
    QVERIFY(schedule.due(35)); // late for 10, 20 and 30: once
    QVERIFY(!schedule.due(36));
    QVERIFY(schedule.due(40));
}

void ScheduleTest::timesReadAsPeopleWriteThem() {
    QVERIFY(57 * 0.01 != 0.57 && tickTime(57, 0.01) == 0.57); // QCOMPARE would take a rounding error for equal
    QVERIFY(3 * 0.1 != 0.3 && tickTime(3, 0.1) == 0.3);
    QVERIFY(tickTime(0, 0.1) == 0.0);
    QVERIFY(tickTime(123456789, 0.001) == 123456.789);
    QVERIFY(1020 * 0.02 != 20.4 && nearestTickTime(1020 * 0.02, 0.02) == 20.4); // a time that was computed so
}

QTEST_APPLESS_MAIN(ScheduleTest)
#include "schedule_test.moc"
