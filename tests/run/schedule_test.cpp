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
    QCOMPARE(tickTime(7, 0.01), 0.07); // 7 * 0.01 is 0.07000000000000001
    QCOMPARE(tickTime(3, 0.1), 0.3);
    QCOMPARE(tickTime(0, 0.1), 0.0);
    QCOMPARE(tickTime(123456789, 0.001), 123456.789);
}

QTEST_APPLESS_MAIN(ScheduleTest)
#include "schedule_test.moc"
