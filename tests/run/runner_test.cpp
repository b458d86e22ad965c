// The run loop: controllers, logs, console and ends of a run.
#include <csignal>

#include <QtTest>
#ifdef Q_OS_UNIX
#include <sys/resource.h>
#endif

#include "run/experiment_runner.h"
#include "run/fake_world.h"
#include "run/scripted_backend.h"

using namespace trundle;

class RunnerTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::shared_ptr<ExperimentSpec> m_experiment;
    FakeWorld* m_world = nullptr;
    ScriptedBackend* m_backend = nullptr;
    std::vector<double> m_gaps;
    std::vector<std::string> m_console;
    std::unique_ptr<ExperimentRunner> m_runner;
    Diagnostics m_diagnostics;
    bool m_failStart = false;

    void build() {
        auto world = std::make_unique<FakeWorld>(m_experiment);
        m_world = world.get();
        RunOptions options;
        options.logFolder = m_folder.filePath("logs").toStdString();
        options.console = [this](double time, const std::string& who, int, const std::string& text) {
            m_console.push_back("[" + QString::number(time, 'g', QLocale::FloatingPointShortest).toStdString() + " " + who +
                                "] " + text);
        };
        m_runner = std::make_unique<ExperimentRunner>(std::move(world), std::move(options));
        m_runner->startControllers(
            [this](const ControllerRequest& request) -> Result<std::unique_ptr<ControllerBackend>> {
                if (request.library == "broken.so") return Error{Code::ModuleUnreadable, "broken.so is no library"};
                auto backend = std::make_unique<ScriptedBackend>();
                backend->kind = request.robot->controllers[request.controller].kind;
                backend->story = &m_world->story;
                backend->gaps = &m_gaps;
                backend->failStart = m_failStart;
                m_backend = backend.get();
                return std::unique_ptr<ControllerBackend>(std::move(backend));
            },
            m_diagnostics);
        if (!m_diagnostics.hasErrors()) m_runner->openLogs(m_diagnostics);
    }
    void giveController(double updatePeriod = 0) {
        m_experiment->robots[0].controllers = {{{"Scripted", "brain", {{"UpdatePeriod", numberValue(updatePeriod)}}, {}, {}}, {}}};
    }
    QByteArray log(const char* name) const {
        QFile file(m_folder.filePath(QString("logs/") + name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(missing)");
    }

private Q_SLOTS:
    void init() {
        QDir(m_folder.filePath("logs")).removeRecursively();
        m_experiment = experimentOf({"robot0", "robot1"});
        m_gaps.clear();
        m_console.clear();
        m_diagnostics = {};
        m_failStart = false;
    }
    void cleanup() { m_runner.reset(); }

    void commandsThenThinkThenStep();
    void aControllerIsCalledAtItsPeriod();
    void stampsAndStoresCommands();
    void reportsBadCommandAndContinues();
    void aSignalCommandReachesItsSlotOnly();
    void aFailedControllerEndsTheRun();
    void theFirstFinishEndsTheRunAfterItsTick();
    void aTickThatFailsFinishesNothing();
    void anotherControllerTakesThePlace();
    void aFailedStartIsADiagnostic();
    void blowUpEndsRunAndKeepsLogs();
    void reportsLargeClusterOnce();
    void reportsAnIteratedPileOnce();
    void saysNothingOfPilesWhereAllIsQuick();
    void reportsEachPassageOnce();
    void reportsUnwritableFolderOnce();
    void logsHaveTheInitialStateAndEveryInterval();
    void rowsCountTicksNotFloatingPointTime();
    void noLogFolderMeansNoLogs();
    void controllerLogIsInLogFolder();
    void aLogThatFailedIsNotNamed();
    void aControllersLogCannotLeaveTheLogFolder();
    void limitsConsoleOutput();
};

void RunnerTest::commandsThenThinkThenStep() {
    giveController();
    build();
    m_runner->command(PushCommand{"robot0/chassis"});
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->finish().ok());
    QCOMPARE(m_world->story, std::string("push robot0/chassis think step think step stop "));
    QCOMPARE(m_console.at(0), std::string("[0 robot0] t=0.000000"));
}

void RunnerTest::aControllerIsCalledAtItsPeriod() {
    giveController(0.025); // of 0.01: at ticks 0, 3, 5, 8
    build();
    for (int i = 0; i < 9; ++i) QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_world->story, std::string("think step step step think step step think step step step think step "));
    QCOMPARE(m_gaps.size(), std::size_t(4));
    QCOMPARE(m_gaps[0], 0.0);
    QCOMPARE(m_gaps[1], 0.03);
    QVERIFY(qAbs(m_gaps[2] - 0.02) < 1e-12);
}

void RunnerTest::stampsAndStoresCommands() {
    build();
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->tick().ok());
    m_runner->command(PlaceCommand{"robot1", {}});
    m_runner->command(PushCommand{"robot0/chassis"});
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_world->story, std::string("step step place robot1 push robot0/chassis step step "));
    QCOMPARE(m_runner->commands().size(), std::size_t(2));
    QCOMPARE(m_runner->commands()[0].tick, std::uint64_t(2));
}

void RunnerTest::reportsBadCommandAndContinues() {
    build();
    m_runner->command(PushCommand{"nobody"});
    m_runner->command(SignalCommand{"robot0/base/linearVelocty", 1});
    m_runner->command(SignalCommand{"robot0/touch/pressed", 1});
    m_runner->command(SignalCommand{"robot0/base/linearVelocity", std::nan("")});
    QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_console.size(), std::size_t(4));
    QCOMPARE(m_console[1], std::string("[0 ] command refused: there is no signal robot0/base/linearVelocty"));
    QCOMPARE(m_world->story, std::string("step "));
}

void RunnerTest::aSignalCommandReachesItsSlotOnly() {
    build();
    m_runner->command(SignalCommand{"robot1/base/linearVelocity", 0.5});
    QVERIFY(m_runner->tick().ok());
    for (const SignalEntry& entry : m_world->layout().entries())
        QCOMPARE(m_world->block().slots()[entry.offset], entry.path == "robot1/base/linearVelocity" ? 0.5 : 0.0);
}

void RunnerTest::aFailedControllerEndsTheRun() {
    giveController();
    build();
    m_backend->failAt = 2;
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->tick().ok());
    QVERIFY(!m_runner->failure());
    QVERIFY(!m_runner->tick().ok());
    QCOMPARE(m_runner->failure()->code, Code::ControllerFailed);
    QVERIFY(!m_runner->tick().ok());
    QCOMPARE(m_world->ticks(), std::uint64_t(2));
}

void RunnerTest::theFirstFinishEndsTheRunAfterItsTick() {
    giveController();
    m_experiment->logs.push_back(logSpec("PoseLog", "path", {{"Robot", textValue({"robot0"})}}));
    build();
    m_backend->finishAt = 1;
    QVERIFY(m_runner->tick().ok());
    QVERIFY(!m_runner->finished());
    QVERIFY(m_runner->tick().ok());
    const RunFinish* finish = m_runner->finished();
    QVERIFY(finish);
    QCOMPARE(finish->robot + " " + finish->controller + " " + finish->reason, std::string("robot0 brain reached 1"));
    QCOMPARE(finish->time, 0.02);
    QCOMPARE(m_world->ticks(), std::uint64_t(2));
    QVERIFY(m_runner->finish().ok());
    QVERIFY(!m_runner->failure());
    QCOMPARE(log("path.csv").count('\n'), 4); // heading, start, both ticks
    QVERIFY(m_runner->finished());            // still reported after the logs are closed
}

void RunnerTest::aTickThatFailsFinishesNothing() {
    giveController();
    build();
    m_backend->finishAt = 0;
    m_world->faultAt = 0;
    QVERIFY(!m_runner->tick().ok());
    QVERIFY(m_runner->failure());
    QVERIFY(!m_runner->finished());
}

void RunnerTest::anotherControllerTakesThePlace() {
    giveController();
    build();
    QVERIFY(m_runner->tick().ok());
    const auto swap = [&](const char* from, std::optional<const char*> to, const char* library = "other.so") {
        SwapCommand command{"robot0", from, {}, library};
        if (to) command.to = ControllerSpec{{*to, "mind", {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}};
        m_runner->command(command);
        return m_runner->tick().ok();
    };
    const auto velocity = m_world->layout().find("robot0/base/linearVelocity");
    m_world->block().slots()[velocity->offset] = 0.3;
    m_world->story.clear();
    m_console.clear();
    QVERIFY(swap("brain", "Other"));
    QCOMPARE(m_world->story, std::string("stop think step ")); // the old one is stopped, the new one is called in the same tick
    QCOMPARE(m_backend->kind, std::string("Other"));
    QCOMPARE(m_world->block().slots()[velocity->offset], 0.0);
    QCOMPARE(m_console.at(0), std::string("[0.01 robot0] the controller mind is Other now"));
    QCOMPARE(m_runner->controllerCosts().size(), std::size_t(1));
    QCOMPARE(m_runner->controllerCosts()[0].controller, std::string("mind"));

    m_world->story.clear();
    m_console.clear();
    QVERIFY(swap("mind", "Third", "broken.so")); // that it has stays
    QCOMPARE(m_world->story, std::string("think step "));
    QCOMPARE(m_console.at(0), std::string("[0.02 ] command refused: broken.so is no library"));
    QVERIFY(swap("", "Third"));
    QVERIFY(m_console.at(2).ends_with("command refused: robot0 has a controller mind already"));

    m_world->story.clear();
    QVERIFY(swap("mind", {}));
    QCOMPARE(m_world->story, std::string("stop step "));
    QVERIFY(m_runner->controllerCosts().empty());
    m_world->story.clear();
    QVERIFY(swap("", "Fourth"));
    QCOMPARE(m_world->story, std::string("think step "));
    QCOMPARE(m_backend->kind, std::string("Fourth"));
    m_world->story.clear();
    QVERIFY(m_runner->finish().ok());
    QCOMPARE(m_world->story, std::string("stop ")); // of the one that it has, once
}

void RunnerTest::aFailedStartIsADiagnostic() {
    m_failStart = true;
    giveController();
    m_experiment->robots[1].controllers = m_experiment->robots[0].controllers;
    build();
    QCOMPARE(m_diagnostics.errorCount(), std::size_t(1)); // the same message is kept once for all robots
    QCOMPARE(m_diagnostics.all()[0].code, Code::UnknownPort);
}

void RunnerTest::blowUpEndsRunAndKeepsLogs() {
    m_experiment->logs = {logSpec("PoseLog", "path", {{"Robot", textValue({"robot0"})}})};
    build();
    m_world->faultAt = 1;
    QVERIFY(m_runner->tick().ok());
    QVERIFY(!m_runner->tick().ok());
    QCOMPARE(m_runner->failure()->code, Code::BlowUp);
    QVERIFY(!m_runner->finish().ok());
    QCOMPARE(log("path.csv").count('\n'), 3);
}

void RunnerTest::reportsLargeClusterOnce() {
    m_experiment->settings.solver = SolverChoice::Exact;
    m_experiment->settings.solverRange = {0, {7, 12}};
    build();
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->warnings().empty());
    m_world->cluster = 143;
    for (int i = 0; i < 3; ++i) QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_runner->warnings().size(), std::size_t(1));
    const Diagnostic& said = m_runner->warnings()[0];
    QCOMPARE(said.code, Code::BigCluster);
    QCOMPARE(said.severity, Severity::Warning);
    QCOMPARE(QString::fromStdString(said.message),
             QString("at t = 0.02 s 143 contacts hang together; Solver = exact gets very slow with so many, auto takes the quick "
                     "solver then"));
    QCOMPARE(said.range, m_experiment->settings.solverRange);
    QCOMPARE(QString::fromStdString(said.fixes.at(0).title), QString("auto"));
}

void RunnerTest::reportsAnIteratedPileOnce() {
    build();
    m_world->quick = m_world->rescued = 1; // the exact solver failed in a tick
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->warnings().empty());
    for (int i = 0; i < 3; ++i) {
        ++m_world->quick;
        QVERIFY(m_runner->tick().ok());
    }
    QCOMPARE(m_runner->warnings().size(), std::size_t(1));
    const Diagnostic& said = m_runner->warnings()[0];
    QCOMPARE(said.code, Code::BigCluster);
    QCOMPARE(said.severity, Severity::Warning);
    QVERIFY2(said.message.starts_with("at t = 0.02 s more than 60 contacts hang together in a pile"), said.message.c_str());
}

void RunnerTest::saysNothingOfPilesWhereAllIsQuick() {
    m_experiment->settings.solver = SolverChoice::Quick;
    build();
    m_world->quick = 1;
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->warnings().empty());
}

void RunnerTest::reportsEachPassageOnce() {
    build();
    QVERIFY(m_runner->tick().ok());
    m_world->swept = {7, {{"a/body/ball", "b/body/box"}}};
    for (int i = 0; i < 3; ++i) QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_runner->warnings().size(), std::size_t(1));
    m_world->swept.passed.emplace_back("c/body/ball", "d/body/box");
    for (int i = 0; i < 3; ++i) QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_runner->warnings().size(), std::size_t(2));
    const Diagnostic& first = m_runner->warnings()[0];
    QCOMPARE(first.code, Code::PassedThrough);
    QCOMPARE(first.severity, Severity::Warning);
    QCOMPARE(
        QString::fromStdString(first.message),
        QString("at t = 0.02 s a/body/ball passed through b/body/box: fast bodies stop at the scenery, but not at each other. A "
                "Tick below 0.01 s or larger bodies help"));
    QVERIFY(m_runner->warnings()[1].message.find("at t = 0.05 s c/body/ball passed through d/body/box") == 0);
}

void RunnerTest::reportsUnwritableFolderOnce() {
    m_experiment->logs = {logSpec("PoseLog", "a", {}), logSpec("EnergyLog", "b", {}), logSpec("ContactLog", "c", {})};
    QFile file(m_folder.filePath("taken"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    RunOptions options;
    options.logFolder = m_folder.filePath("taken/logs").toStdString();
    ExperimentRunner runner(std::make_unique<FakeWorld>(m_experiment), options);
    Diagnostics diagnostics;
    runner.openLogs(diagnostics);
    QCOMPARE(diagnostics.all().size(), std::size_t(1));
    QCOMPARE(diagnostics.all()[0].code, Code::LogUnwritable);
}

void RunnerTest::logsHaveTheInitialStateAndEveryInterval() {
    m_experiment->logs = {
        logSpec("PoseLog", "path",
                {{"Robot", textValue({"robot1"})}, {"Interval", numberValue(0.03)}, {"File", textValue({"sub/p.csv"})}})};
    build();
    for (int i = 0; i < 7; ++i) QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->finish().ok());
    QCOMPARE(log("sub/p.csv"), QByteArray("time [s],robot,x [m],y [m],z [m],heading [deg],pitch [deg],roll [deg]\n"
                                          "0,robot1,0,1,0,0,0,0\n0.03,robot1,0.03,1,0,0,0,0\n0.06,robot1,0.06,1,0,0,0,0\n"));
    QCOMPARE(m_runner->logFiles().size(), std::size_t(1));
    QVERIFY(m_runner->logFiles()[0].ends_with("logs/sub/p.csv"));
}

/// 3 * 0.1 is 0.30000000000000004: logs, console and the end of the run say 0.3.
void RunnerTest::rowsCountTicksNotFloatingPointTime() {
    m_experiment->settings.tick = 0.1;
    giveController();
    m_experiment->logs = {logSpec("PoseLog", "pose", {{"Interval", numberValue(0.3)}}), logSpec("EnergyLog", "energy", {}),
                          logSpec("ContactLog", "contact", {}),
                          logSpec("SignalLog", "signal", {{"Signals", textValue({"robot0/*"})}})};
    build();
    m_world->touching = {{"robot0/chassis/bumper", "arena/north", {1, 2, 3}, {0, -1, 0}, 0.001, 5}};
    m_backend->finishAt = 2;
    for (int i = 0; i < 3; ++i) QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->finished()->time == 0.3); // QCOMPARE would take a rounding error for equal
    m_backend->outputs.print(TRUNDLE_INFO, "now");
    QCOMPARE(m_console.back(), std::string("[0.3 robot0] now"));
    QVERIFY(m_runner->finish().ok());
    for (const char* name : {"pose.csv", "energy.csv", "contact.csv", "signal.csv"}) {
        const QList<QByteArray> rows = log(name).trimmed().split('\n');
        QVERIFY2(rows.size() > 1 && rows.last().startsWith("0.3,"), rows.last().constData());
    }
}

void RunnerTest::noLogFolderMeansNoLogs() {
    m_experiment->logs = {logSpec("PoseLog", "path", {})};
    m_runner = std::make_unique<ExperimentRunner>(std::make_unique<FakeWorld>(m_experiment), RunOptions{});
    m_runner->openLogs(m_diagnostics);
    QVERIFY(!m_diagnostics.hasErrors());
    QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->logFiles().empty());
}

void RunnerTest::controllerLogIsInLogFolder() {
    giveController();
    build();
    const int id = m_backend->outputs.openLog("mine.txt");
    QVERIFY(id >= 0);
    m_backend->outputs.writeLog(id, "hello\n");
    m_backend->outputs.writeLog(id + 1, "nowhere\n");
    m_backend->outputs.writeLog(-1, "nowhere\n");
    QVERIFY(m_backend->outputs.openLog("sub/mine.txt") >= 0);
    QVERIFY(m_runner->finish().ok());
    QCOMPARE(log("mine.txt"), QByteArray("hello\n"));
}

void RunnerTest::aLogThatFailedIsNotNamed() {
#ifdef Q_OS_UNIX
    giveController();
    build();
    const int id = m_backend->outputs.openLog("mine.txt");
    m_backend->outputs.writeLog(id, "hello\n");
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit none{0, before.rlim_max}; // acts like a full disk
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &none), 0);
    const bool done = m_runner->finish().ok();
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!done);
    QVERIFY(m_runner->logFiles().empty());
#endif
}

void RunnerTest::aControllersLogCannotLeaveTheLogFolder() {
    giveController();
    build();
    QCOMPARE(m_backend->outputs.openLog("../mine.txt"), -1);
    QVERIFY(!QFileInfo::exists(m_folder.filePath("mine.txt")));
    QCOMPARE(m_console.size(), std::size_t(1));
}

void RunnerTest::limitsConsoleOutput() {
    giveController();
    build();
    for (int i = 0; i < 100; ++i) QVERIFY(m_runner->tick().ok()); // one line each
    m_console.clear();
    for (int i = 0; i < 1000; ++i) m_backend->outputs.print(TRUNDLE_INFO, "chatter");
    QCOMPARE(m_console.size(), std::size_t(100));
    m_console.clear();
    m_backend->outputs.print(TRUNDLE_INFO, "a\nb\nc\n");
    for (int i = 0; i < 99; ++i) QVERIFY(m_runner->tick().ok());
    QVERIFY(m_runner->tick().ok());
    QCOMPARE(m_console.size(), std::size_t(100)); // of 99 updates and the count of dropped lines
    QCOMPARE(m_console.back(), std::string("[2 robot0] E506: \u2026 904 lines dropped"));
    m_backend->outputs.print(TRUNDLE_INFO, QByteArray("x\n").repeated(101).toStdString());
    QCOMPARE(m_console.back().size(), std::string("[2 robot0] ").size() + 200);
    QVERIFY(m_runner->finish().ok());
    QCOMPARE(m_console.back(), std::string("[2 robot0] E506: \u2026 1 line dropped"));
}

QTEST_APPLESS_MAIN(RunnerTest)
#include "runner_test.moc"
