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
};

QTEST_APPLESS_MAIN(ServedRunTest)
#include "served_run_test.moc"
