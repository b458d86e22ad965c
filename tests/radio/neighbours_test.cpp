// Which radios are near a place, while they move, against a comparison of all of them.
#include <QTest>

#include <algorithm>
#include <random>

#include "radio/neighbours.h"

using namespace trundle;

class NeighboursTest : public QObject {
    Q_OBJECT

    /// All within the range are found once, in the order of their ids, and nobody who is farther than the two cells beyond it.
    static void compare(const Neighbours& neighbours, const std::vector<Vec3>& places, const Vec3& from, double range) {
        std::vector<RadioId> near;
        neighbours.near(from, range, near);
        QVERIFY(std::ranges::is_sorted(near));
        QVERIFY2(std::ranges::adjacent_find(near) == near.end(), "a radio is found twice");
        for (RadioId id = 0; id < places.size(); ++id) {
            const Vec3 way = places[id] - from;
            const double far = std::max(std::abs(way.x()), std::abs(way.y()));
            const bool isFound = std::ranges::binary_search(near, id);
            if (far <= range) QVERIFY(isFound);
            if (far > range + 101) QVERIFY(!isFound);
        }
    }

private Q_SLOTS:
    void findsThoseThatMove() {
        std::mt19937 random(3);
        const auto anywhere = [&] {
            const auto number = [&] { return 2000. * double(random() % 100000) / 100000 - 1000; };
            return Vec3(number(), number(), number());
        };
        Neighbours neighbours;
        std::vector<Vec3> places;
        for (RadioId id = 0; id < 200; ++id) {
            places.push_back(anywhere());
            neighbours.put(id, places[id]);
        }
        for (int round = 0; round < 50; ++round) {
            for (int moves = 0; moves < 40; ++moves) {
                const RadioId id = random() % 200;
                places[id] = random() % 2 ? anywhere() : Vec3(places[id] + Vec3(30, -20, 5));
                neighbours.put(id, places[id]);
            }
            compare(neighbours, places, anywhere(), 80);
            if (QTest::currentTestFailed()) return;
        }
    }

    /// It is once where it is.
    void movesThereAndBack() {
        Neighbours neighbours;
        std::vector<Vec3> places;
        for (RadioId id = 0; id < 30; ++id) {
            places.push_back({200. * id, 0, 0});
            neighbours.put(id, places[id]);
        }
        for (const double x : {5000., 0., 49., 51., 0.}) {
            places[0].x() = x;
            neighbours.put(0, places[0]);
            for (const double from : {0., 5000.}) compare(neighbours, places, {from, 0, 0}, 40);
            if (QTest::currentTestFailed()) return;
        }
    }

    /// A range that has more cells than there are radios: all of them.
    void farRanges() {
        Neighbours neighbours;
        for (RadioId id = 0; id < 3; ++id) neighbours.put(id, {1e6 * id, 0, 0});
        std::vector<RadioId> near;
        neighbours.near(Vec3::Zero(), 1e5, near);
        QCOMPARE(near, (std::vector<RadioId>{0, 1, 2}));
    }
};

QTEST_APPLESS_MAIN(NeighboursTest)
#include "neighbours_test.moc"
