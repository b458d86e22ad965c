// A live run in its own thread.
#include <QtTest>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "eventually.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"
#include "run/live/live_run.h"

using namespace trundle;
using namespace std::chrono_literals;

namespace {

/// Blocks a controller, as one that does not return.
struct Door {
    std::mutex lock;
    std::condition_variable opens;
    bool open = true;
    std::atomic<int> waiting = 0;

    void pass() {
        std::unique_lock guard(lock);
        ++waiting;
        opens.wait(guard, [&] { return open; });
        if (--waiting == 0) opens.notify_all();
    }
    void set(bool isOpen) { // returns when whoever waited for it has passed
        std::unique_lock guard(lock);
        open = isOpen;
        opens.notify_all();
        opens.wait(guard, [&] { return !open || waiting == 0; });
    }
};

class TalkingBackend final : public ControllerBackend {
public:
    TalkingBackend(Door& door, int linesPerTick) : m_door(door), m_lines(linesPerTick) {}
    std::uint64_t failAt = ~0ull, finishAt = ~0ull;
    Status start(const SignalLayout&, SignalBlock&, ControllerOutputs outputs) override {
        m_outputs = std::move(outputs);
        return {};
    }
    Status tick(std::uint64_t tick, double, double) override {
        m_door.pass();
        if (tick == finishAt) m_outputs.finish("reached");
        if (tick == failAt) return Error{Code::ControllerFailed, "the controller Talker of robot0 failed: no"};
        for (int i = 0; i < m_lines; ++i) m_outputs.print(TRUNDLE_INFO, "tick " + std::to_string(tick));
        return {};
    }
    Status set(const std::string& property, const PropertyValue& value) override {
        m_outputs.print(TRUNDLE_INFO, property + " = " + std::to_string(value.numbers.at(0)));
        return {};
    }
    void stop() override {}
    std::string describe() const override { return "talking"; }

private:
    Door& m_door;
    int m_lines;
    ControllerOutputs m_outputs;
};

int threadCount() { return static_cast<int>(QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot).size()); }
int descriptorCount() {
    return static_cast<int>(QDir("/proc/self/fd").entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size());
}

} // namespace

/// Communication between a live run's thread and its owner, with a world without physics.
class LiveRunTest : public QObject {
    Q_OBJECT

    static inline Door& m_door = *new Door; // abandoned threads may still pass it when this ends
    int m_lines = 0;
    double m_duration = 0;
    std::uint64_t m_faultAt = ~0ull, m_failAt = ~0ull, m_finishAt = ~0ull;
    QTemporaryDir m_folder;

    RunnerMaker maker() {
        return [this](RunOptions options, Diagnostics& problems) -> std::unique_ptr<Runner> {
            const std::shared_ptr<ExperimentSpec> experiment = experimentOf({"robot0", "robot1"});
            experiment->settings.duration = m_duration;
            experiment->robots[0].controllers = {{{"Talker", "brain", {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}}};
            experiment->logs.push_back(logSpec("PoseLog", "path", {{"Robot", textValue({"robot0"})}}));
            auto world = std::make_unique<FakeWorld>(experiment);
            world->faultAt = m_faultAt;
            world->touching = {{"robot0/chassis/bumper", "arena/north", {1, 0, 0}, {-1, 0, 0}, 0.001, 5}};
            auto runner = std::make_unique<ExperimentRunner>(std::move(world), std::move(options));
            runner->startControllers(
                [this](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                    auto backend = std::make_unique<TalkingBackend>(m_door, m_lines);
                    backend->failAt = m_failAt;
                    backend->finishAt = m_finishAt;
                    return std::unique_ptr<ControllerBackend>(std::move(backend));
                },
                problems);
            runner->openLogs(problems);
            return runner;
        };
    }
    LiveRun::Options fast() const {
        LiveRun::Options options;
        options.speed = 0;
        return options;
    }
    static std::uint64_t tickOf(const LiveRun& run) {
        const auto shot = run.snapshot();
        return shot ? shot->tick : 0;
    }

private Q_SLOTS:
    void init() {
        m_door.set(true);
        m_lines = 0;
        m_duration = 0;
        m_faultAt = m_failAt = m_finishAt = ~0ull;
    }

    void isBuiltAtStart() {
        LiveRun run(maker(), fast());
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Paused);
        QCOMPARE(tickOf(run), 0u);
        QVERIFY(run.layout()->find("robot0/pose"));
        QVERIFY(!run.end());
        QCOMPARE(run.busyS(), 0.0);
    }

    void runsToItsDurationAndClosesTheLogs() {
        m_duration = 2;
        LiveRun::Options options = fast();
        options.startsRunning = true;
        options.logFolder = m_folder.filePath("ends").toStdString();
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QVERIFY(!run.end()->failure);
        QCOMPARE(run.end()->time, 2.0);
        QCOMPARE(tickOf(run), 200u);
        QCOMPARE(*run.snapshot()->hash, 200u); // of the world without physics
        QFile log(m_folder.filePath("ends/path.csv"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QCOMPARE(log.readAll().count('\n'), 202); // header, start, 200 ticks
        QVERIFY(run.waitUntilGone(10s));
    }

    void resumesPastDuration() {
        m_duration = 2;
        LiveRun::Options options = fast();
        options.startsRunning = options.canContinue = true;
        options.logFolder = m_folder.filePath("goes_on").toStdString();
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QVERIFY(run.end()->canContinue && !run.end()->failure && !run.gone());
        QCOMPARE(tickOf(run), 200u);
        const auto rows = [this] {
            QFile log(m_folder.filePath("goes_on/path.csv"));
            return log.open(QIODevice::ReadOnly) ? log.readAll().count('\n') : -1;
        };
        QCOMPARE(rows(), 202);        // all rows so far are on the disk
        run.setContactsEnabled(true); // the current state is published again; the run is still at its end
        EVENTUALLY(run.snapshot()->contacts != nullptr);
        QCOMPARE(run.phase(), LivePhase::Ended);
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 201u);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Paused);
        QVERIFY(!run.end());
        run.run();
        EVENTUALLY(tickOf(run) > 400); // without limit
        run.stop();
        QVERIFY(run.waitUntilGone(10s));
        QVERIFY(run.end() && !run.end()->canContinue);
        QCOMPARE(rows(), int(tickOf(run)) + 2); // one log for the whole run
    }

    void takesSingleTicks() {
        LiveRun run(maker(), fast());
        run.step(); // requested while the world is still being built
        EVENTUALLY_EQUAL(tickOf(run), 1u);
        run.step(3);
        EVENTUALLY_EQUAL(tickOf(run), 4u);
        QCOMPARE(run.phase(), LivePhase::Paused);
    }

    void pausesAndResumes() {
        LiveRun run(maker(), fast());
        run.run();
        EVENTUALLY(tickOf(run) > 10);
        run.pause();
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Paused);
        EVENTUALLY(run.snapshot()->hash.has_value()); // the last tick is published when the run pauses
        const std::uint64_t there = tickOf(run);
        QCOMPARE(run.snapshot()->realTimeFactor, 0.0);
        run.run();
        EVENTUALLY(tickOf(run) > there);
    }

    void aSlowRunCanBeHurriedAndStopped() {
        LiveRun::Options slow = fast();
        slow.speed = 0.001; // a tick takes ten seconds
        slow.startsRunning = true;
        LiveRun run(maker(), slow);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Running);
        run.setSpeed(0);
        EVENTUALLY(tickOf(run) > 100);
        run.setSpeed(0.001);
        run.stop(); // and does not wait for the next tick
        QVERIFY(run.waitUntilGone(5s));
        QCOMPARE(run.phase(), LivePhase::Ended);
    }

    void commandsAreStampedWithTheTickTheyCameBefore() {
        LiveRun run(maker(), fast());
        run.step(2);
        EVENTUALLY_EQUAL(tickOf(run), 2u);
        run.command(PlaceCommand{"robot0", {{1, 0, 0}, Quat::Identity()}});
        run.command(PlaceCommand{"robot1", {{5, 0, 0}, Quat::Identity()}});
        run.command(PlaceCommand{"robot0", {{2, 0, 0}, Quat::Identity()}}); // during a drag only the last pose counts
        run.command(SignalCommand{"robot0/base/linearVelocity", 0.5});
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 3u);
        const std::vector<Command> commands = run.commands();
        QCOMPARE(commands.size(), 3u);
        for (const Command& command : commands) QCOMPARE(command.tick, 2u);
        QCOMPARE(std::get<PlaceCommand>(commands[0].what).robot, std::string("robot1"));
        QCOMPARE(std::get<PlaceCommand>(commands[1].what).pose.position.x(), 2.0); // in the order in which they were given last
        const auto entry = run.layout()->find("robot0/base/linearVelocity");
        QCOMPARE(run.snapshot()->block->slots()[entry->offset], 0.5);
    }

    void aHeldPushIsACommandOfEachTick() {
        LiveRun run(maker(), fast());
        run.keepPushing(PushCommand{"robot0/chassis", {1, 0, 0}, {0, 0, 0}});
        run.step(3);
        EVENTUALLY_EQUAL(tickOf(run), 3u);
        run.keepPushing(std::nullopt);
        run.step(2);
        EVENTUALLY_EQUAL(tickOf(run), 5u);
        const std::vector<Command> commands = run.commands();
        QCOMPARE(commands.size(), 3u);
        QCOMPARE(commands[2].tick, 2u);
    }

    void heldControllerIsSkipped() {
        m_lines = 1;
        LiveRun run(maker(), fast());
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 1u);
        run.command(HoldCommand{"robot0", true});
        run.step(2);
        EVENTUALLY_EQUAL(tickOf(run), 3u);
        run.command(HoldCommand{"robot0", false});
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 4u);
        const LiveLines lines = run.takeLines();
        QCOMPARE(lines.lines.size(), 2u);
        QCOMPARE(lines.lines[0].text, std::string("tick 0"));
        QCOMPARE(lines.lines[1].text, std::string("tick 3"));
    }

    void liveValuesReachControllerDeviceAndSurface() {
        LiveRun run(maker(), fast());
        run.command(PropertyCommand{"robot0/brain", "Speed", {PropertyType::Number, {0.5}, {}}});
        run.command(PropertyCommand{"nobody/motor", "Resistance", {PropertyType::Number, {3}, {}}});
        run.command(SurfaceCommand{{"rubber", 0.8, 0, 0, 0, {}, {}}});
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 1u);
        const LiveLines lines = run.takeLines();
        QCOMPARE(lines.lines.size(), 2u);
        QCOMPARE(lines.lines[0].text, std::string("Speed = 0.500000"));
        QVERIFY(lines.lines[1].text.starts_with("command refused")); // and the run continues
        QCOMPARE(lines.lines[1].severity, int(TRUNDLE_ERROR));
    }

    void consoleLinesWaitInABoundedQueue() {
        m_lines = 50;
        LiveRun run(maker(), fast());
        run.step(500); // 25,000 lines, room for 10,000
        EVENTUALLY_EQUAL(tickOf(run), 500u);
        const LiveLines taken = run.takeLines();
        QCOMPARE(taken.lines.size(), 10'000u);
        QCOMPARE(taken.dropped, 15'000u);
        QCOMPARE(taken.lines.back().text, std::string("tick 499")); // the newest lines are kept
        QCOMPARE(taken.lines.front().text, std::string("tick 300"));
        QCOMPARE(taken.lines.front().who, std::string("robot0"));
        QVERIFY(run.takeLines().lines.empty());
    }

    void publishesContactsWhenEnabled() {
        LiveRun run(maker(), fast());
        run.step();
        EVENTUALLY_EQUAL(tickOf(run), 1u);
        QVERIFY(!run.snapshot()->contacts);
        QCOMPARE(run.snapshot()->contactCount, 1u);
        run.setContactsEnabled(true); // also for the tick already done
        EVENTUALLY(run.snapshot()->contacts);
        QCOMPARE(tickOf(run), 1u);
        QCOMPARE(run.snapshot()->contacts->at(0).second, std::string("arena/north"));
    }

    void reportsBlowUpWithTime() {
        m_faultAt = 7;
        LiveRun::Options options = fast();
        options.startsRunning = true;
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QCOMPARE(run.end()->failure->code, Code::BlowUp);
        QCOMPARE(run.end()->body, std::string("robot0/chassis"));
        QCOMPARE(run.end()->time, 0.07);
        QCOMPARE(tickOf(run), 7u);
    }

    void aFailedControllerEndsTheRun() {
        m_failAt = 3;
        LiveRun::Options options = fast();
        options.startsRunning = true;
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QCOMPARE(run.end()->failure->code, Code::ControllerFailed);
        QVERIFY(run.end()->body.empty());
        run.run(); // ignored after the end
        run.step();
        run.command(SignalCommand{"robot0/base/linearVelocity", 1});
        QVERIFY(run.waitUntilGone(10s));
        QCOMPARE(tickOf(run), 3u);
    }

    void aControllerMayFinishTheRun() {
        m_finishAt = 3;
        LiveRun::Options options = fast();
        options.startsRunning = true;
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        const std::optional<LiveEnd> end = run.end();
        QVERIFY(!end->failure);
        QVERIFY(end->finish);
        QCOMPARE(end->finish->robot + " " + end->finish->controller + " " + end->finish->reason,
                 std::string("robot0 brain reached"));
        QCOMPARE(end->finish->time, 0.04);
        QCOMPARE(tickOf(run), 4u);
    }

    void buildFailureReportsProblems() {
        LiveRun run(
            [](RunOptions, Diagnostics& problems) -> std::unique_ptr<Runner> {
                problems.warning(Code::ModuleDescriptionStale, {}, "old");
                problems.error(Code::KindNotLoaded, {}, "no code is loaded for the kind Sonar");
                return nullptr;
            },
            fast());
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QCOMPARE(run.end()->problems.size(), 2u);
        QCOMPARE(run.end()->failure->code, Code::KindNotLoaded);
        QVERIFY(!run.layout());
        QVERIFY(!run.snapshot());
    }

    void exceptionEndsRun() {
        LiveRun run([](RunOptions, Diagnostics&) -> std::unique_ptr<Runner> { throw std::runtime_error("out of luck"); }, fast());
        EVENTUALLY_EQUAL(run.phase(), LivePhase::Ended);
        QVERIFY(run.end()->failure->message.find("out of luck") != std::string::npos);
        QVERIFY(run.waitUntilGone(10s));
    }

    void doesNotWaitForUnresponsiveController() {
        m_door.set(false);
        const int threads = threadCount();
        LiveRun::Options options = fast();
        options.startsRunning = true;
        options.logFolder = m_folder.filePath("blocked").toStdString();
        auto run = std::make_unique<LiveRun>(maker(), options);
        EVENTUALLY_EQUAL(m_door.waiting.load(), 1);
        QVERIFY(run->busyS() > 0);
        run->stop();
        QVERIFY(!run->waitUntilGone(1ms));

        // The next run must not overwrite its logs.
        options.after = run.get();
        options.timeout = 1ms;
        options.startsRunning = false;
        LiveRun next(maker(), options);
        EVENTUALLY_EQUAL(next.phase(), LivePhase::Paused);
        QVERIFY(next.takeLines().lines.at(0).text.find("writes no logs") != std::string::npos);

        run.reset(); // returns at once
        QCOMPARE(m_door.waiting.load(), 1);
        m_door.set(true);
        next.stop();
        QVERIFY(next.waitUntilGone(10s));
        EVENTUALLY(threadCount() <= threads + 1); // the abandoned thread has ended
    }

    void theNextRunWaitsForTheLogsOfTheFormer() { // or, if that hangs, writes none
        for (const bool hangs : {false, true}) {
            m_door.set(false);
            LiveRun::Options options = fast();
            options.startsRunning = true;
            options.logFolder = m_folder.filePath("waits").toStdString();
            LiveRun first(maker(), options);
            EVENTUALLY_EQUAL(m_door.waiting.load(), 1);
            first.stop();
            options = {.logFolder = options.logFolder, .speed = 0, .after = &first, .timeout = hangs ? 1ms : 60s};
            LiveRun second(maker(), options);
            m_door.set(!hangs);
            EVENTUALLY_EQUAL(second.phase(), LivePhase::Paused);
            QCOMPARE(first.gone(), !hangs);
            QCOMPARE(second.takeLines().lines.size(), std::size_t(hangs));
            second.stop();
            m_door.set(true);
            QVERIFY(second.waitUntilGone(10s) && second.end()->logFiles.empty() == hangs);
        }
    }

    void notifiesEveryChange() {
        std::atomic<int> reported = 0;
        LiveRun::Options options = fast();
        options.changed = [&reported] { ++reported; };
        LiveRun run(maker(), options);
        EVENTUALLY_EQUAL(reported.load(), 1); // built
        run.step();
        EVENTUALLY_EQUAL(reported.load(), 2);
        run.run();
        EVENTUALLY_EQUAL(reported.load(), 3);
        run.pause();
        EVENTUALLY_EQUAL(reported.load(), 4);
        run.stop();
        QVERIFY(run.waitUntilGone(10s));
        EVENTUALLY_EQUAL(reported.load(), 6); // the end of the run and of its thread
    }

    void leavesNoThreadAndNoDescriptor() {
        const int rounds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 200 : 20;
        const int threads = threadCount(), descriptors = descriptorCount();
        for (int i = 0; i < rounds; ++i) {
            LiveRun::Options options = fast();
            options.startsRunning = true;
            options.logFolder = m_folder.filePath("rounds").toStdString();
            LiveRun run(maker(), options);
            if (i % 3) EVENTUALLY(tickOf(run) > 0);
        }
        EVENTUALLY_EQUAL(threadCount(), threads);
        EVENTUALLY_EQUAL(descriptorCount(), descriptors);
    }
};

QTEST_GUILESS_MAIN(LiveRunTest)
#include "live_run_test.moc"
