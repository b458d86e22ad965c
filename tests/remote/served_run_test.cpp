// Commands that wait for the coming tick, of robots whose names begin alike.
#include <QtTest>

#include "remote/served_run.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"
#include "run/scripted_backend.h"

using namespace trundle;

class ServedRunTest : public QObject {
    Q_OBJECT

    std::string m_story;
    std::vector<double> m_gaps;
    std::unique_ptr<ExperimentRunner> m_runner;
    std::unique_ptr<ServedRun> m_run;

    static QString speedOf(const std::string& robot) { return QString::fromStdString(robot + "/base/linearVelocity"); }
    /// What the coming tick is given: signals with their values, other commands by their kind.
    QStringList given() {
        const std::size_t before = m_runner->commands().size();
        m_run->beginTick();
        if (!m_runner->tick()) return {"the tick failed"};
        QStringList all;
        for (const Command& each : std::span(m_runner->commands()).subspan(before)) {
            if (const auto* signal = std::get_if<SignalCommand>(&each.what))
                all += QStringLiteral("%1=%2").arg(QString::fromStdString(signal->path)).arg(signal->value);
            if (const auto* hold = std::get_if<HoldCommand>(&each.what))
                all += QString::fromStdString((hold->held ? "hold " : "release ") + hold->robot);
            if (const auto* place = std::get_if<PlaceCommand>(&each.what)) all += QString::fromStdString("place " + place->robot);
            if (const auto* restart = std::get_if<RestartCommand>(&each.what))
                all += QString::fromStdString("restart " + restart->robot);
        }
        all.sort();
        return all;
    }

private Q_SLOTS:
    void init() {
        const std::shared_ptr<ExperimentSpec> experiment = experimentOf({"robot1", "robot10", "robot", "free", "free2"});
        for (RobotSpec& robot : experiment->robots)
            if (robot.name.starts_with("robot"))
                robot.controllers = {{{"Scripted", "brain", {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}}};
        m_runner = std::make_unique<ExperimentRunner>(std::make_unique<FakeWorld>(experiment), RunOptions());
        Diagnostics diagnostics;
        m_runner->startControllers(
            [this](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                auto backend = std::make_unique<ScriptedBackend>();
                backend->story = &m_story;
                backend->gaps = &m_gaps;
                return std::unique_ptr<ControllerBackend>(std::move(backend));
            },
            diagnostics);
        QVERIFY(!diagnostics.hasErrors());
        m_run = std::make_unique<ServedRun>(*m_runner);
    }
    void cleanup() {
        m_run.reset();
        m_runner.reset();
    }

    void aReleasedRobotLosesItsWaitingSignalsAndNoOtherDoes_data() {
        QTest::addColumn<QString>("released");
        for (const char* robot : {"robot", "robot1", "robot10"}) QTest::newRow(robot) << robot;
    }
    void aReleasedRobotLosesItsWaitingSignalsAndNoOtherDoes() {
        QFETCH(QString, released);
        QStringList expected{"release " + released, "place " + released};
        double speed = 0.1;
        for (const std::string robot : {"robot", "robot1", "robot10"}) {
            QVERIFY(!m_run->setSignal(robot + "/base/linearVelocity", {speed})); // its controller owns it
            QVERIFY(m_run->hold(robot, true));
            QVERIFY(m_run->setSignal(robot + "/base/linearVelocity", {speed}));
            if (released.toStdString() != robot) {
                expected += QStringLiteral("%1=%2").arg(speedOf(robot)).arg(speed);
                expected += QString::fromStdString("hold " + robot);
            }
            speed *= 2;
        }
        QVERIFY(m_run->place(released.toStdString(), Pose()));
        QVERIFY(m_run->hold(released.toStdString(), false));
        for (const std::string robot : {"robot", "robot1", "robot10"}) {
            QCOMPARE(m_run->isHeld(robot), released.toStdString() != robot);
            QCOMPARE(m_run->checkOwner(robot + "/base/linearVelocity").ok(), released.toStdString() != robot);
        }
        expected.sort();
        QCOMPARE(given(), expected);
        QCOMPARE(given(), QStringList()); // each command is for one tick
    }

    /// Nothing takes over the signals of a robot without a controller.
    void aRobotWithoutAControllerKeepsItsSignals() {
        QVERIFY(m_run->hold("free", true) && m_run->hold("robot1", true));
        QVERIFY(m_run->setSignal("free/base/linearVelocity", {0.3}) && m_run->setSignal("free2/base/linearVelocity", {-0.4}));
        QVERIFY(m_run->setSignal("robot1/base/linearVelocity", {0.5}));
        QVERIFY(m_run->hold("free", false) && m_run->hold("robot1", false));
        QStringList expected{"release free", "release robot1", speedOf("free") + "=0.3", speedOf("free2") + "=-0.4"};
        expected.sort();
        QCOMPARE(given(), expected);
    }

    void whatIsUnknownIsNotHeld() {
        for (const std::string name : {"robot2", "robot1/base", ""}) {
            const Status refused = m_run->hold(name, true);
            QVERIFY(!refused && refused.error().code == Code::NoSuchPath);
            QVERIFY(!m_run->isHeld(name));
        }
        QCOMPARE(given(), QStringList());
    }

    /// Of several commands that set the same in one tick the last counts.
    void theLastOfATickCounts() {
        QVERIFY(m_run->hold("robot1", true) && m_run->hold("robot1", false) && m_run->hold("robot1", true));
        QVERIFY(m_run->setSignal("robot1/base/linearVelocity", {0.1}) && m_run->setSignal("robot1/base/linearVelocity", {0.7}));
        QVERIFY(m_run->restart("robot10") && m_run->restart("robot10"));
        QVERIFY(!m_run->restart("free"));
        QStringList expected{"hold robot1", "restart robot10", speedOf("robot1") + "=0.7"};
        expected.sort();
        QCOMPARE(given(), expected);
    }

    /// A signal of several numbers waits as one command for each of them; other counts are refused.
    void eachNumberOfASignalIsACommand() {
        const auto numbersOf = [&] {
            std::map<std::uint32_t, double> numbers;
            const std::size_t before = m_runner->commands().size();
            m_run->beginTick();
            if (!m_runner->tick()) return numbers;
            for (const Command& each : std::span(m_runner->commands()).subspan(before))
                if (const auto* signal = std::get_if<SignalCommand>(&each.what)) numbers[signal->element] = signal->value;
            return numbers;
        };
        QVERIFY(m_run->setSignal("free/base/linearVelocity", {0.25}));
        QCOMPARE(numbersOf(), (std::map<std::uint32_t, double>{{0, 0.25}}));
        for (const std::vector<double>& wrong : {std::vector<double>(), {1, 2}}) {
            const Status refused = m_run->setSignal("free/base/linearVelocity", wrong);
            QVERIFY(!refused && refused.error().code == Code::WrongPlace);
        }
        QVERIFY(!m_run->setSignal("free/touch/pressed", {1})); // measured
        QVERIFY(numbersOf().empty());
    }

    /// Of the run before nothing is left: what was held, what waited, that it ran or was at its Duration.
    void aResetKeepsNothingOfTheRunBefore_data() {
        QTest::addColumn<double>("duration");
        QTest::newRow("without a Duration") << 0.;
        QTest::newRow("with one") << 0.03;
    }
    void aResetKeepsNothingOfTheRunBefore() {
        QFETCH(double, duration);
        std::vector<std::optional<std::uint64_t>> seeds;
        std::shared_ptr<ExperimentRunner> runner;
        ServedRun run([&](std::optional<std::uint64_t> seed) {
            seeds.push_back(seed);
            const auto experiment = experimentOf({"robot", "robot1"});
            experiment->settings.tick = 0.01;
            experiment->settings.duration = duration;
            runner = std::make_shared<ExperimentRunner>(std::make_unique<FakeWorld>(experiment), RunOptions());
            return ServedExperiment{runner, {}, {}};
        });
        QVERIFY(!run.exists() && run.state() == ServedState::Ended);
        const auto tick = [&] {
            run.beginTick();
            run.endTick(runner->tick().ok());
        };
        QVERIFY(run.reset(7) && run.state() == ServedState::Paused);
        for (int round = 0; round < 2; ++round) {
            QVERIFY(run.hold("robot1", true) && run.setSignal("robot1/base/linearVelocity", {0.5}));
            run.run(2.5);
            QVERIFY(run.state() == ServedState::Running && run.speed() == 2.5 && !run.isAtDuration());
            for (int i = 0; i < 3; ++i) tick();
            QCOMPARE(run.isAtDuration(), duration > 0);
            QCOMPARE(run.state(), duration > 0 ? ServedState::Paused : ServedState::Running);
            if (round == 0) run.run(1.5); // on past it, and no second stop
            QVERIFY(!run.isAtDuration() || round == 1);
            tick();
            QVERIFY(!run.isAtDuration());
            QVERIFY(run.hold("robot", true));
            QVERIFY(run.reset(round == 0 ? std::optional<std::uint64_t>() : 9));
            QVERIFY(run.state() == ServedState::Paused && !run.isAtDuration());
            QVERIFY(!run.isHeld("robot") && !run.isHeld("robot1"));
            const std::size_t before = runner->commands().size();
            run.beginTick();
            QCOMPARE(runner->commands().size(), before);
        }
        QCOMPARE(seeds, (std::vector<std::optional<std::uint64_t>>{7, std::nullopt, 9}));
    }

    /// A pause changes what runs alone; a failed tick ends it until a reset.
    void statesOfARun() {
        std::shared_ptr<ExperimentRunner> runner;
        bool isBuilt = true;
        ServedRun run([&](std::optional<std::uint64_t>) {
            runner = std::make_shared<ExperimentRunner>(std::make_unique<FakeWorld>(experimentOf({"robot"})), RunOptions());
            return isBuilt ? ServedExperiment{runner, {}, {}} : ServedExperiment{};
        });
        QVERIFY(run.reset());
        run.run(0);
        run.pause();
        QCOMPARE(run.state(), ServedState::Paused);
        run.endTick(false);
        QCOMPARE(run.state(), ServedState::Ended);
        run.pause();
        run.run(1);
        QCOMPARE(run.state(), ServedState::Ended);
        QVERIFY(run.speed() == 0 && run.reset() && run.state() == ServedState::Paused);
        isBuilt = false;
        QVERIFY(!run.reset() && !run.exists() && run.state() == ServedState::Ended);
        QCOMPARE(run.endReason(), std::string("there is no run"));
        const Status refused = run.hold("robot", true);
        QVERIFY(!refused && refused.error().code == Code::SystemRefused);
    }

    void problemsAreSortedAndPlaced() {
        SourceTable sources;
        const FileId file = sources.add(std::make_shared<const SourceText>("a.sim", "one\n  two three\n"));
        std::vector<Diagnostic> problems;
        for (const auto& [severity, begin] : {std::pair{Severity::Hint, 0u}, {Severity::Error, 6u}, {Severity::Warning, 10u}})
            problems.push_back(
                {severity, Code::OutOfRange, "at " + std::to_string(begin), {file, {begin, begin + 3}}, {}, {}, {}});
        problems.push_back({Severity::Error, Code::BadMass, "elsewhere", {}, {}, {}, {}});
        const auto all = problemsJson(problems, sources);
        QCOMPARE(all.size(), std::size_t(4));
        const std::tuple<const char*, const char*, int, int> expected[] = {
            {"error", "at 6", 2, 3}, {"error", "elsewhere", 0, 0}, {"warning", "at 10", 2, 7}, {"hint", "at 0", 1, 1}};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [severity, message, line, column] = expected[i];
            QVERIFY(all[i]["severity"] == severity && all[i]["message"] == message);
            QVERIFY(all[i]["line"] == line && all[i]["column"] == column);
            QVERIFY(all[i]["file"] == (line > 0 ? "a.sim" : ""));
        }
    }
    /// A controller that finishes the run ends it, also where it is seen later; the first controller of a robot owns its signals.
    void aFinishedRunIsOver() {
        const auto experiment = experimentOf({"robot"});
        for (const char* name : {"brain", "helper"})
            experiment->robots[0].controllers.push_back({{"Scripted", name, {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}});
        ExperimentRunner runner(std::make_unique<FakeWorld>(experiment), RunOptions());
        Diagnostics diagnostics;
        runner.startControllers(
            [this](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                auto backend = std::make_unique<ScriptedBackend>();
                backend->story = &m_story;
                backend->gaps = &m_gaps;
                backend->finishAt = 1;
                return std::unique_ptr<ControllerBackend>(std::move(backend));
            },
            diagnostics);
        ServedRun run(runner);
        QVERIFY(run.checkOwner("robot/base/linearVelocity").error().message.starts_with("the controller brain of robot owns "));
        run.follow(true, 3);
        QVERIFY(run.state() == ServedState::Running && run.speed() == 3 && run.endReason().empty());
        for (int i = 0; i < 3 && !runner.finished(); ++i) run.endTick(runner.tick().ok());
        QCOMPARE(run.state(), ServedState::Ended);
        QCOMPARE(run.endReason(), std::string("the controller brain of robot finished it: reached 1"));
        run.follow(true, 5);
        QVERIFY(run.state() == ServedState::Ended && run.speed() == 3);
        QCOMPARE(ServedRun(runner).state(), ServedState::Ended);
    }

    /// Of robots that are joined, the last that is placed moves all of them.
    void ofJoinedRobotsTheLastPlaceCounts() {
        const auto experiment = experimentOf({"a", "b", "c"});
        experiment->joints.push_back({{}, 0, 1});
        m_runner = std::make_unique<ExperimentRunner>(std::make_unique<FakeWorld>(experiment), RunOptions());
        m_run = std::make_unique<ServedRun>(*m_runner);
        for (const char* name : {"a", "c", "b"}) QVERIFY(m_run->place(name, Pose()));
        QCOMPARE(given(), (QStringList{"place b", "place c"}));
    }

    void ofManyProblemsTheFirstAreShown() {
        std::vector<Diagnostic> problems(101);
        for (Diagnostic& each : problems) each.severity = Severity::Warning;
        problems.back().severity = Severity::Error;
        const auto all = problemsJson(problems, SourceTable());
        QCOMPARE(all.size(), std::size_t(100));
        QVERIFY(all[0]["severity"] == "error" && all[1]["severity"] == "warning");
    }
};

QTEST_APPLESS_MAIN(ServedRunTest)
#include "served_run_test.moc"
