// Which device a geom takes power from, and what each that takes some has of it.
#include <QtTest>

#include <cmath>
#include <numeric>

#include "world/world_chargers.h"

using namespace trundle;

class ChargersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Whichever of them was first of all.
    void aGeomBelongsToTheLastThatOffered() {
        for (const bool reversed : {false, true}) {
            const std::uint32_t first = reversed ? 8 : 3, second = reversed ? 3 : 8;
            WorldChargers chargers;
            chargers.offer(first, 10, 6, 1);
            chargers.offer(first, 11, 6, 1);
            chargers.offer(second, 12, 12, 2);
            QCOMPARE(chargers.offered(10).volts, 6.);
            chargers.offer(second, 10, 12, 2);
            QCOMPARE(chargers.offered(10).volts, 12.);
            QCOMPARE(chargers.offered(11).volts, 6.); // the others stay
            QCOMPARE(chargers.offered(12).volts, 12.);
            chargers.beginTick();
            chargers.take(10, 12, 0.5);
            chargers.beginTick();
            QCOMPARE(chargers.taken(second).watts, 6.);
            QCOMPARE(chargers.taken(first).watts, 0.);
            chargers.offer(first, 10, 6, 1); // and back
            QCOMPARE(chargers.offered(10).volts, 6.);
        }
    }

    /// What each of three batteries takes in each of four ticks, where one of them comes later.
    void theyShareIt_data() {
        QTest::addColumn<double>("most");
        QTest::addColumn<QList<double>>("wanted");
        QTest::addColumn<QList<double>>("first");
        QTest::addColumn<QList<double>>("then");
        QTest::newRow("equally") << 3. << QList<double>{9, 9, 9} << QList<double>{3, 0, 0} << QList<double>{1, 1, 1};
        QTest::newRow("one wants little") << 3. << QList<double>{9, .5, 9} << QList<double>{3, 0, 0}
                                          << QList<double>{1.2475, .5, 1.2475};
        QTest::newRow("two want little") << 3. << QList<double>{.25, 9, .5} << QList<double>{.25, 2.75, 0}
                                         << QList<double>{.25, 2.2425, .5};
        QTest::newRow("all are satisfied") << 3. << QList<double>{1, .5, 1.25} << QList<double>{1, .5, 1.25}
                                           << QList<double>{1, .5, 1.25};
        QTest::newRow("nothing is offered") << 0. << QList<double>{1, .5, 1.25} << QList<double>{0, 0, 0}
                                            << QList<double>{0, 0, 0};
    }
    void theyShareIt() {
        QFETCH(double, most);
        QFETCH(QList<double>, wanted);
        QFETCH(QList<double>, first);
        QFETCH(QList<double>, then);
        WorldChargers chargers;
        const auto tick = [&] {
            chargers.offer(1, 10, 6, most);
            chargers.offer(1, 11, 6, most); // another geom of the same device
            chargers.beginTick();
            QList<double> took;
            for (qsizetype i = 0; i < wanted.size(); ++i) {
                const std::uint32_t geom = i == 1 ? 11 : 10;
                const double amperes = std::min(wanted[i], chargers.offered(geom).amperes);
                chargers.take(geom, 5, amperes);
                took.push_back(amperes);
            }
            return took;
        };
        QCOMPARE(tick(), first);
        for (int i = 0; i < 3; ++i) {
            QList<double> took = tick();
            for (qsizetype k = 0; i > 0 && k < took.size(); ++k) QVERIFY(std::abs(took[k] - then[k]) < 1e-12);
            QVERIFY(std::accumulate(took.begin(), took.end(), 0.) <= most * (1 + 1e-12));
        }
        const double all = std::accumulate(then.begin(), then.end(), 0.);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).takers, all > 0 ? 3u : 0u);
        QVERIFY(std::abs(chargers.taken(1).amperes - all) < 1e-12);
        QVERIFY(std::abs(chargers.taken(1).watts - 5 * all) < 1e-12);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).takers, 0u);
        QCOMPARE(chargers.offered(10).amperes, most); // the others are there no more
    }

    /// A battery takes no more than it was offered, and one that joins has its share in the next tick.
    void noMoreThanThereIs() {
        WorldChargers chargers;
        chargers.offer(1, 10, 6, 3);
        chargers.beginTick();
        for (int i = 0; i < 3; ++i) chargers.take(10, 6, 9);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).amperes, 3.);
        QCOMPARE(chargers.taken(1).watts, 18.);
    }

    void whatIsNoPowerIsNotOfferedOrTaken() {
        WorldChargers chargers;
        chargers.offer(1, 10, 6, 2);
        chargers.offer(1, 10, std::nan(""), 1);
        chargers.offer(1, 10, 7, HUGE_VAL);
        chargers.beginTick();
        QCOMPARE(chargers.offered(10).volts, 6.);
        chargers.take(10, std::nan(""), 1);
        chargers.take(10, 6, 0);
        chargers.take(10, 6, -1);
        chargers.take(99, 6, 1); // of no robot
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).takers, 0u);
        QCOMPARE(chargers.taken(7).takers, 0u);
        QCOMPARE(chargers.offered(99).volts, 0.);
        chargers.offer(1, 10, 6, -2);
        QCOMPARE(chargers.offered(10).amperes, 0.);
    }
};

QTEST_APPLESS_MAIN(ChargersTest)
#include "chargers_test.moc"
