// Hashes and random numbers against published values.
#include <QTest>
#include <cmath>
#include <set>

#include "base/rng.h"

using namespace trundle;

class RngTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void knownHashes() {
        // Published test vectors of FNV-1a 64.
        QCOMPARE(fnv1a64(""), 0xcbf29ce484222325ull);
        QCOMPARE(fnv1a64("a"), 0xaf63dc4c8601ec8cull);
        QCOMPARE(fnv1a64("foobar"), 0x85944171f73967e8ull);
        QCOMPARE(fnv1a64("bar", fnv1a64("foo")), fnv1a64("foobar"));
    }

    void aFunctionOfAllFour() {
        std::set<std::uint64_t> seen;
        for (std::uint64_t seed = 0; seed < 8; ++seed)
            for (std::uint64_t path = 0; path < 8; ++path)
                for (std::uint64_t tick = 0; tick < 8; ++tick)
                    for (std::uint64_t index = 0; index < 8; ++index) seen.insert(randomBits(seed, path, tick, index));
        QCOMPARE(seen.size(), std::size_t(8 * 8 * 8 * 8));
        QCOMPARE(randomBits(1, 2, 3, 4), randomBits(1, 2, 3, 4));
    }

    void unitIsUniform() {
        double sum = 0, squares = 0;
        constexpr int kCount = 100000;
        for (int i = 0; i < kCount; ++i) {
            const double u = toUnit(randomBits(7, 8, 9, static_cast<std::uint64_t>(i)));
            QVERIFY(u >= 0 && u < 1);
            sum += u;
            squares += u * u;
        }
        QVERIFY(std::abs(sum / kCount - 0.5) < 0.005);
        QVERIFY(std::abs(squares / kCount - 1.0 / 3) < 0.005);
        QVERIFY(toUnit(~0ull) < 1);
        QCOMPARE(toUnit(0), 0.0);
    }

    void normalIsNormal() {
        double sum = 0, squares = 0, fourths = 0;
        constexpr std::uint64_t kCount = 100000;
        for (std::uint64_t i = 0; i < kCount; ++i) {
            const double x = toNormal(randomBits(1, 2, i, 0), randomBits(1, 2, i, 1));
            QVERIFY(std::isfinite(x));
            sum += x;
            squares += x * x;
            fourths += x * x * x * x;
        }
        QVERIFY(std::abs(sum / kCount) < 0.015);
        QVERIFY(std::abs(squares / kCount - 1) < 0.02);
        QVERIFY(std::abs(fourths / kCount - 3) < 0.15);
        QVERIFY(std::isfinite(toNormal(0, 0)) && std::isfinite(toNormal(~0ull, ~0ull)));
    }
};

QTEST_APPLESS_MAIN(RngTest)
#include "rng_test.moc"
