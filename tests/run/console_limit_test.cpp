// How many lines of the console a robot has in a tick, with its controller and all of its devices.
#include <QTest>

#include <algorithm>

#include "run/console_limit.h"

using namespace trundle;

namespace {

using Dropped = std::vector<std::pair<std::string, std::uint64_t>>;

constexpr std::uint64_t kMost = ConsoleLimit::kLinesPerTick;

std::string lines(std::uint64_t count) {
    std::string text;
    for (std::uint64_t i = 0; i < count; ++i) text += std::to_string(i) + "\n";
    return text;
}

std::uint64_t passed(ConsoleLimit& limit, const char* who, std::uint64_t tick, std::uint64_t count) {
    const std::string text = lines(count);
    return std::uint64_t(std::ranges::count(limit.pass(who, tick, text), '\n'));
}

} // namespace

class ConsoleLimitTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void allOfARobotCountsTogether() {
        ConsoleLimit limit;
        QCOMPARE(passed(limit, "robot1", 5, kMost - 10), kMost - 10);
        QCOMPARE(passed(limit, "robot1/leftMotor", 5, 6), std::uint64_t{6});
        QCOMPARE(passed(limit, "robot1/rightMotor", 5, 6), std::uint64_t{4});
        QCOMPARE(passed(limit, "robot1", 5, 1), std::uint64_t{0});
        QCOMPARE(limit.takeDropped(), (Dropped{{"robot1", 3}}));
    }

    /// Names that begin alike are of different robots, and each has lines of its own.
    void eachRobotHasItsOwn() {
        ConsoleLimit limit;
        for (const char* who : {"robot1", "robot10/motor", "robot", "robot2"}) QCOMPARE(passed(limit, who, 1, kMost), kMost);
        QCOMPARE(passed(limit, "robot10", 1, 2), std::uint64_t{0});
        QCOMPARE(passed(limit, "robot/motor", 1, 1), std::uint64_t{0});
        QCOMPARE(limit.takeDropped(), (Dropped{{"robot", 1}, {"robot10", 2}}));
        QVERIFY(limit.takeDropped().empty()); // they are reported once
    }

    void eachTickHasItsOwn() {
        ConsoleLimit limit;
        for (const std::uint64_t tick : {0, 1, 2, 7}) QCOMPARE(passed(limit, "r", tick, kMost + 1), kMost);
        QCOMPARE(limit.takeDropped(), (Dropped{{"r", 4}}));
    }

    /// Whole lines, with or without an end of the last one; a line without an end counts as one.
    void linesWithoutAnEnd() {
        ConsoleLimit limit;
        QCOMPARE(limit.pass("r", 0, "one"), std::string_view("one"));
        QCOMPARE(passed(limit, "r", 0, kMost - 2), kMost - 2);
        QCOMPARE(limit.pass("r", 0, "last\nbeyond\nmore"), std::string_view("last\n"));
        QCOMPARE(limit.takeDropped(), (Dropped{{"r", 2}}));
        QCOMPARE(limit.pass("r", 0, ""), std::string_view());
        QVERIFY(limit.takeDropped().empty());
    }
};

QTEST_APPLESS_MAIN(ConsoleLimitTest)
#include "console_limit_test.moc"
