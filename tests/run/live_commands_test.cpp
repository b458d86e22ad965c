// What the commands that a live run was given before a tick set in its world.
#include <QtTest>

#include "eventually.h"
#include "run/experiment_runner.h"
#include "run/live/live_run.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

std::unique_ptr<Runner> runnerOfR0(RunOptions options, Diagnostics& problems) {
    Scene scene = r0Scene();
    scene.scenery({plane("floor", {}, 1)});
    scene.robot("r", {}, r0());
    return std::make_unique<ExperimentRunner>(scene.build(rowOnly, problems), std::move(options));
}

} // namespace

class LiveCommandsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Of those for the same element of a signal the last one counts; other elements and other signals have their own.
    void eachElementOfASignalIsSet() {
        LiveRun::Options options;
        options.speed = 0;
        LiveRun live(runnerOfR0, options);
        EVENTUALLY_EQUAL(live.phase(), LivePhase::Paused);
        live.command(SignalCommand{"r/leftMotor/command", 3, 0});
        live.command(SignalCommand{"r/leftMotor/command", 0.25, 1});
        live.command(SignalCommand{"r/leftMotor/command", 7, 2});
        live.command(SignalCommand{"r/rightMotor/command", 5, 1});
        live.command(SignalCommand{"r/leftMotor/command", -2, 0});
        live.step();
        EVENTUALLY(live.snapshot() && live.snapshot()->tick == 1);
        QCOMPARE(live.commands().size(), std::size_t(4));
        const auto shot = live.snapshot();
        const auto layout = live.layout();
        const auto left = layout->find("r/leftMotor/command"), right = layout->find("r/rightMotor/command");
        QVERIFY(left && right);
        const auto slots = shot->block->slots();
        QCOMPARE(slots[left->offset], -2.);
        QCOMPARE(slots[left->offset + 1], 0.25);
        QCOMPARE(slots[left->offset + 2], 7.);
        QCOMPARE(slots[right->offset], 0.);
        QCOMPARE(slots[right->offset + 1], 5.);
    }
};

QTEST_GUILESS_MAIN(LiveCommandsTest)
#include "live_commands_test.moc"
