// The flat signal block: offsets of signals, and copying between blocks of the same layout.
#include <QtTest>

#include <cstring>
#include <set>
#include <vector>

#include "signals/block.h"
#include "signals/layout.h"

using namespace trundle;

class SignalsTest : public QObject {
    Q_OBJECT

    static SignalLayout twoRobots() {
        SignalLayout l;
        l.beginRobot("a");
        l.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        l.add("motor/voltage", "V", SignalType::Real, SignalDirection::Command);
        l.beginRobot("b");
        l.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
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
        QCOMPARE(twoRobots().hash(), SignalLayout(twoRobots()).hash());
        SignalLayout other = twoRobots();
        other.add("b/extra", "", SignalType::Real, SignalDirection::Output);
        QVERIFY(other.hash() != twoRobots().hash());
        SignalLayout x, y;
        x.add("ab", "c", SignalType::Real, SignalDirection::Output);
        y.add("a", "bc", SignalType::Real, SignalDirection::Output);
        QVERIFY(x.hash() != y.hash());
    }
    /// The hash covers each field of an entry, the order of the entries and the robots that they belong to.
    void eachFieldIsHashed() {
        const auto hash = [](const char* robot, const char* path, const char* unit, SignalType type, SignalDirection direction,
                             std::uint32_t count, bool late = false) {
            SignalLayout l;
            if (!late) l.beginRobot(robot);
            l.add(path, unit, type, direction, count);
            if (late) l.beginRobot(robot);
            l.add("z", "", SignalType::Real, SignalDirection::Output);
            return l.hash();
        };
        constexpr auto real = SignalType::Real;
        constexpr auto out = SignalDirection::Output;
        const std::set<std::uint64_t> all{hash("a", "p", "m", real, out, 1),
                                          hash("b", "p", "m", real, out, 1),
                                          hash("a", "q", "m", real, out, 1),
                                          hash("a", "p", "s", real, out, 1),
                                          hash("a", "p", "m", SignalType::Integer, out, 1),
                                          hash("a", "p", "m", SignalType::Boolean, out, 1),
                                          hash("a", "p", "m", real, SignalDirection::Command, 1),
                                          hash("a", "p", "m", real, SignalDirection::Truth, 1),
                                          hash("a", "p", "m", real, out, 2),
                                          hash("a", "p", "m", real, out, 256),
                                          hash("a", "p", "m", real, out, 1, true)};
        QCOMPARE(all.size(), std::size_t{11});
    }
    /// The last signal has as many numbers as the hash says, in a world without robots too.
    void theLengthOfTheLastSignalIsHashed() {
        const auto hash = [](std::uint32_t count) {
            SignalLayout l;
            l.add("goal/count", "", SignalType::Integer, SignalDirection::Output, count);
            return l.hash();
        };
        QVERIFY(hash(1) != hash(2));
    }
    /// A robot that repeats another has the same signals in slots of its own, and a layout in which each was added has the same hash.
    void equalRobotsShareTheirNames() {
        SignalLayout repeated, added;
        for (SignalLayout* l : {&repeated, &added}) {
            l->beginRobot("a");
            l->add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
            l->add("motor/voltage", "V", SignalType::Integer, SignalDirection::Command, 2);
        }
        repeated.repeatRobot("b", 0);
        added.beginRobot("b");
        added.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
        added.add("motor/voltage", "V", SignalType::Integer, SignalDirection::Command, 2);
        QCOMPARE(repeated.hash(), added.hash());
        QCOMPARE(repeated.slotCount(), 18u);
        QCOMPARE(repeated.images()[0].group, repeated.images()[1].group);
        const auto voltage = repeated.find("b/motor/voltage");
        QVERIFY(voltage);
        QCOMPARE(voltage->path, std::string("b/motor/voltage"));
        QCOMPARE(voltage->unit, std::string("V"));
        QCOMPARE(voltage->type, SignalType::Integer);
        QCOMPARE(voltage->direction, SignalDirection::Command);
        QCOMPARE(voltage->offset, 16u);
        QCOMPARE(voltage->count, 2u);
        QVERIFY(!repeated.find("b") && !repeated.find("pose") && !repeated.find("c/pose") && !repeated.find("b/pos"));
    }
    /// What is added to a copy, or to the last of two equal robots, is not added to the other.
    void additionsStayWhereTheyAre() {
        SignalLayout l = twoRobots();
        SignalLayout copy = l;
        copy.add("extra", "", SignalType::Real, SignalDirection::Output);
        QVERIFY(copy.find("b/extra") && !l.find("b/extra"));
        l.repeatRobot("c", 0);
        l.add("extra", "", SignalType::Real, SignalDirection::Output);
        QCOMPARE(l.find("c/extra")->offset, 23u);
        QVERIFY(!l.find("a/extra"));
        QCOMPARE(l.find("a/motor/voltage")->offset, 7u);
    }
    void entriesInTheOrderOfTheirSlots() {
        SignalLayout l = twoRobots();
        l.beginRobot("empty");
        l.repeatRobot("d", 1);
        std::vector<std::string> all, ofB;
        for (const SignalEntry& entry : l.entries()) all.push_back(entry.path);
        for (const SignalEntry& entry : l.entriesOf("b")) ofB.push_back(entry.path);
        QCOMPARE(all, (std::vector<std::string>{"a/pose", "a/motor/voltage", "b/pose", "d/pose"}));
        QCOMPARE(ofB, std::vector<std::string>{"b/pose"});
        QCOMPARE(l.entries().size(), std::size_t{4});
        QCOMPARE(l.entriesOf("empty").size() + l.entriesOf("none").size(), std::size_t{0});
        QCOMPARE(l.imageOf("d")->offset, 15u);
        QVERIFY(!l.imageOf("none"));
    }
    /// Of two signals with one path the first is found; the second has slots of its own.
    void theFirstOfTwoEqualPaths() {
        SignalLayout l;
        l.beginRobot("a");
        QCOMPARE(l.add("x", "m", SignalType::Real, SignalDirection::Output, 3), 0u);
        QCOMPARE(l.add("x", "s", SignalType::Integer, SignalDirection::Command, 2), 3u);
        QCOMPARE(l.find("a/x")->offset, 0u);
        QCOMPARE(l.find("a/x")->unit, std::string("m"));
        QCOMPARE(l.slotCount(), 5u);
        QCOMPARE(l.entries().size(), std::size_t{2});
        QCOMPARE(l.images()[0].count, 5u);
        for (int i = 0; i < 100; ++i) { // while the index grows
            l.add(std::to_string(i), "", SignalType::Real, SignalDirection::Output);
            QCOMPARE(l.find("a/x")->offset, 0u);
        }
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
        for (const double v : block.slots()) QCOMPARE(v, 0.0); // whatever was there before
        QCOMPARE(block.header().tick, std::uint64_t{0});
        QCOMPARE(block.header().slotCount, l.slotCount());
        block.slots()[14] = 2.5;
        double last = 0;
        std::memcpy(&last, memory.data() + memory.size() - 1, sizeof last);
        QCOMPARE(last, 2.5);
        QCOMPARE(static_cast<void*>(&block.header()), static_cast<void*>(memory.data()));
    }
};

QTEST_APPLESS_MAIN(SignalsTest)
#include "signals_test.moc"
