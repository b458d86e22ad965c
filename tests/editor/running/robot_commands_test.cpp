// Driving and placing robots of a run: the commands that they get, and what a reset forgets.
#include <numbers>

#include <QtTest>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

template <class Kind> std::vector<Kind> commandsOf(const RunSession& session) {
    std::vector<Kind> found;
    for (const Command& command : session.robots().all())
        if (const auto* one = std::get_if<Kind>(&command.what)) found.push_back(*one);
    return found;
}

} // namespace

class RobotCommandsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The wheels of a car point to where it is to turn, ahead and back, as far as a car with this wheel base needs for it.
    void aCarIsSteered_data() {
        QTest::addColumn<double>("linear");
        QTest::addColumn<double>("angular");
        for (const double linear : {0.6, -0.6})
            for (const double angular : {0.4, -0.4, 0., 9., -9.})
                QTest::addRow("%g m/s, %g rad/s", linear, angular) << linear << angular;
        QTest::newRow("at rest") << 0. << 0.4;
        QTest::newRow("at rest, to the right") << 0. << -0.4;
    }
    void aCarIsSteered() {
        QFETCH(double, linear);
        QFETCH(double, angular);
        SessionFixture o;
        QVERIFY(o.open("Tick = 0.01\n#import robots/car.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                       "Robot other { Config=Car Pos=0,3,0 }\nRobot car { Config=Car }\n"));
        RunSession& s = o.session;
        s.step();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        QVERIFY(s.robots().drive("car", linear, angular));
        s.step();
        EVENTUALLY_EQUAL(o.tick(), 2u);
        std::map<std::string, double> last;
        for (const SignalCommand& command : commandsOf<SignalCommand>(s)) last[command.path] = command.value;
        QVERIFY(last.contains("car/drive/steeringAngle") && !last.contains("other/drive/steeringAngle"));
        QCOMPARE(last["car/drive/linearVelocity"], linear);
        constexpr double kWheelBase = 0.3302, kMost = 24 * std::numbers::pi / 180; // of car.sim
        const double needed = linear == 0 ? std::numbers::pi / 2 : std::atan(kWheelBase * std::abs(angular / linear));
        const double expected = std::copysign(angular == 0 ? 0 : std::min(needed, kMost), angular);
        QVERIFY2(std::abs(last["car/drive/steeringAngle"] - expected) < 1e-9,
                 qPrintable(QString::number(last["car/drive/steeringAngle"])));
    }

    /// The robot that was driven or placed before it is at its start, and its controller waits again when it is driven again.
    void aResetForgetsWhatWasDrivenAndPlaced() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        RunSession& s = o.session;
        s.step();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        for (int run = 0; run < 2; ++run) {
            QVERIFY(s.robots().pose("robot0")->position.head<2>().norm() < 0.01);
            QVERIFY(commandsOf<HoldCommand>(s).empty());
            QVERIFY(s.robots().drive("robot0", 0.2, 0));
            QCOMPARE(s.robots().driven(), std::string("robot0"));
            s.step();
            EVENTUALLY_EQUAL(o.tick(), 2u);
            QVERIFY(s.robots().place("robot0", {{1.25, -0.5, 0}, Quat::Identity()})); // with the next tick, which does not come
            QVERIFY((s.robots().pose("robot0")->position - Vec3(1.25, -0.5, 0)).norm() < 1e-9);
            const std::vector<HoldCommand> holds = commandsOf<HoldCommand>(s);
            QCOMPARE(holds.size(), std::size_t(1));
            QVERIFY(holds[0].held && holds[0].robot == "robot0");
            s.reset();
            EVENTUALLY_EQUAL(s.state(), RunState::Start);
            QCOMPARE(s.robots().driven(), std::string());
            QVERIFY(!s.robots().pose("robot0"));
            s.step();
            EVENTUALLY_EQUAL(s.state(), RunState::Paused);
            QCOMPARE(o.tick(), 1u);
        }
    }
};

QTEST_GUILESS_MAIN(RobotCommandsTest)
#include "robot_commands_test.moc"
