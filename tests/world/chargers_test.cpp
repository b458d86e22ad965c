// Which device a geom takes power from, and what each that takes some has of it.
#include <QtTest>

#include <cmath>

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
            chargers.take(10, 12, 0.5);
            chargers.beginTick();
            QCOMPARE(chargers.taken(second).watts, 6.);
            QCOMPARE(chargers.taken(first).watts, 0.);
            chargers.offer(first, 10, 6, 1); // and back
            QCOMPARE(chargers.offered(10).volts, 6.);
        }
    }

    void thoseOfTheTickBeforeShareIt() {
        WorldChargers chargers;
        chargers.offer(1, 10, 6, 3);
        chargers.offer(1, 11, 6, 3); // another geom of the same device
        QCOMPARE(chargers.offered(11).amperes, 3.);
        for (const std::uint32_t geom : {10, 10, 11}) chargers.take(geom, 6, 9); // more than there is
        QCOMPARE(chargers.taken(1).takers, 0u);                                  // not before the next tick
        QCOMPARE(chargers.offered(10).amperes, 3.);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).takers, 3u);
        QCOMPARE(chargers.taken(1).amperes, 9.);
        QCOMPARE(chargers.taken(1).watts, 54.);
        QCOMPARE(chargers.offered(10).amperes, 1.);
        chargers.take(11, 5, 0.25);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).amperes, 0.25);
        QCOMPARE(chargers.taken(1).watts, 1.25);
        chargers.beginTick();
        QCOMPARE(chargers.taken(1).takers, 0u);
        QCOMPARE(chargers.offered(10).amperes, 3.);
    }

    void whatIsNoPowerIsNotOfferedOrTaken() {
        WorldChargers chargers;
        chargers.offer(1, 10, 6, 2);
        chargers.offer(1, 10, std::nan(""), 1);
        chargers.offer(1, 10, 7, HUGE_VAL);
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
