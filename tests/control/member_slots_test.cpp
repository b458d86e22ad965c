// Where the signals of a controller are in the images that its host works on.
#include <QtTest>

#include "control/host/member_slots.h"

using namespace trundle;

namespace {

/// Two robots with a command each and a command of two numbers; the second one has a controller that publishes.
struct Pair {
    Pair() {
        for (const char* name : {"r0", "r1"}) {
            layout.beginRobot(name);
            const std::string robot = name;
            layout.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
            layout.add("base/speed", "m/s", SignalType::Real, SignalDirection::Command, 1);
            layout.add("arm/target", "rad", SignalType::Real, SignalDirection::Command, 2);
            layout.add("brain/best", "", SignalType::Real, SignalDirection::Output, 1);
            RobotSpec spec;
            spec.name = name;
            spec.controllers.push_back({{"Kind", "brain", {}, {}, {}}, {}});
            robots.push_back(spec);
        }
        for (std::uint32_t i = 0; i < layout.slotCount(); ++i) block.push_back(100 + i);
    }
    [[nodiscard]] SignalEntry entry(const char* path) const { return *layout.find(path); }

    SignalLayout layout;
    std::vector<RobotSpec> robots;
    std::vector<double> block;
};

} // namespace

class MemberSlotsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aClaimedCommandHasTheValueOfNow() {
        Pair pair;
        MemberSlots slots;
        const std::size_t before = 3, count = slots.place(pair.robots[1], pair.robots[1].controllers[0], pair.layout, before);
        QCOMPARE(count, before + 11);
        std::vector<double> commands(count, -1);
        const auto inImage = [&](const char* path) {
            return slots.inImage() + pair.entry(path).offset - pair.entry("r1/pose").offset;
        };
        slots.claim(pair.entry("r1/arm/target"), pair.block, commands);
        const std::size_t at = inImage("r1/arm/target");
        QCOMPARE(commands[at], pair.block[pair.entry("r1/arm/target").offset]);
        QCOMPARE(commands[at + 1], pair.block[pair.entry("r1/arm/target").offset + 1]);
        QCOMPARE(std::ranges::count(commands, -1.0), std::ptrdiff_t(count) - 2); // nothing else
        commands[at] = 7;
        slots.claim(pair.entry("r1/arm/target"), pair.block, commands); // it has it already
        QCOMPARE(commands[at], 7.0);
    }

    void onlyWhatIsClaimedOrPublishedGoesBack() {
        Pair pair;
        MemberSlots slots;
        const std::size_t count = slots.place(pair.robots[1], pair.robots[1].controllers[0], pair.layout, 0);
        std::vector<double> sensors(count, -1), commands(count, -1), block = pair.block;
        slots.claim(pair.entry("r1/base/speed"), pair.block, commands);
        slots.copyIn(pair.block, sensors, commands);
        for (std::size_t i = 0; i < count; ++i) QCOMPARE(sensors[i], pair.block[pair.entry("r1/pose").offset + i]);
        for (double& command : commands) command = 5;
        slots.copyOut(commands, block);
        for (std::size_t i = 0; i < block.size(); ++i) {
            const bool isOwn = i == pair.entry("r1/base/speed").offset || i == pair.entry("r1/brain/best").offset;
            QCOMPARE(block[i], isOwn ? 5.0 : pair.block[i]);
        }
        slots.forgetClaims();
        block = pair.block;
        slots.copyOut(commands, block);
        QCOMPARE(block[pair.entry("r1/base/speed").offset], pair.block[pair.entry("r1/base/speed").offset]);
        QCOMPARE(block[pair.entry("r1/brain/best").offset], 5.0);
    }
    /// What is published may lie apart, and another controller's name may begin alike.
    void publishedSignalsThatLieApart() {
        SignalLayout layout;
        layout.beginRobot("r");
        layout.add("brain/a", "", SignalType::Real, SignalDirection::Output, 2);
        layout.add("brain/b", "", SignalType::Real, SignalDirection::Output, 1);
        layout.add("brain2/a", "", SignalType::Real, SignalDirection::Output, 1);
        layout.add("brain/c", "", SignalType::Real, SignalDirection::Output, 1);
        RobotSpec robot;
        robot.name = "r";
        robot.controllers.push_back({{"Kind", "brain", {}, {}, {}}, {}});
        MemberSlots slots;
        const std::size_t count = slots.place(robot, robot.controllers[0], layout, 2);
        std::vector<double> commands(count, 7), block(layout.slotCount(), 0);
        slots.copyOut(commands, block);
        QCOMPARE(block, (std::vector<double>{7, 7, 7, 0, 7}));
    }
};

QTEST_APPLESS_MAIN(MemberSlotsTest)
#include "member_slots_test.moc"
