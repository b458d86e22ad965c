// The flat signal block: offsets of signals, and copying between blocks of the same layout.
#include <QtTest>

#include <cstring>
#include <vector>

#include "signals/block.h"
#include "signals/layout.h"

using namespace trundle;

class SignalsTest : public QObject {
    Q_OBJECT

    static SignalLayout twoRobots() {
        SignalLayout l;
        l.beginRobot("a");
        l.add("a/pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        l.add("a/motor/voltage", "V", SignalType::Real, SignalDirection::Command);
        l.beginRobot("b");
        l.add("b/pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        return l;
    }

private Q_SLOTS:
    void pathsLeadToSlots() {
        const SignalLayout l = twoRobots();
        QCOMPARE(l.slotCount(), 15u);
        QVERIFY(l.find("a/motor/voltage"));
        QCOMPARE(l.find("a/motor/voltage")->offset, 7u);
        QCOMPARE(l.find("b/pose")->offset, 8u);
        QVERIFY(!l.find("b/motor/voltage"));
    }
    void robotSlotsAreContiguous() {
        const SignalLayout l = twoRobots();
        QCOMPARE(l.images().size(), std::size_t{2});
        QCOMPARE(l.images()[0].count, 8u);
        QCOMPARE(l.images()[1].offset, 8u);
        QCOMPARE(l.images()[1].count, 7u);
    }
    void shapeDecidesTheHash() {
        QCOMPARE(twoRobots().hash(), twoRobots().hash());
        SignalLayout other = twoRobots();
        other.add("b/extra", "", SignalType::Real, SignalDirection::Output);
        QVERIFY(other.hash() != twoRobots().hash());
        SignalLayout x, y;
        x.add("ab", "c", SignalType::Real, SignalDirection::Output);
        y.add("a", "bc", SignalType::Real, SignalDirection::Output);
        QVERIFY(x.hash() != y.hash());
    }
    void aBlockStartsAtZeroAndCopies() {
        const SignalLayout l = twoRobots();
        SignalBlock a(l), b(l);
        for (const double v : a.slots()) QCOMPARE(v, 0.0);
        a.slots()[7] = 6.5;
        a.header().tick = 3;
        b.copyFrom(a);
        QCOMPARE(b.slots()[7], 6.5);
        QCOMPARE(b.header().tick, std::uint64_t{3});
        QCOMPARE(b.header().layoutHash, l.hash());
    }
    void aBlockLivesInForeignMemory() {
        const SignalLayout l = twoRobots();
        std::vector<std::uint64_t> memory(SignalBlock::bytesNeeded(l) / 8, 0xffffffffffffffffull);
        SignalBlock block(l, memory.data());
        block.slots()[14] = 2.5;
        double last = 0;
        std::memcpy(&last, memory.data() + memory.size() - 1, sizeof last);
        QCOMPARE(last, 2.5);
        QCOMPARE(static_cast<void*>(&block.header()), static_cast<void*>(memory.data()));
    }
};

QTEST_APPLESS_MAIN(SignalsTest)
#include "signals_test.moc"
