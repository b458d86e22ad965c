// Other programs take part in the runs of the window: the Python client, in a process of its own.
#include <QProcess>
#include <QtTest>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kDriven = R"(Tick = 0.01  Duration = 100
#import robots/simple_robot.sim
#import arenas/open_floor.sim
Static floor { Config=OpenFloor }
Robot robot0 { Config=SimpleRobot Pos=0,0,0.1 }
)";

/// A Python program with `run` connected; what it prints and its errors.
class Program {
public:
    Program(const RemoteAccess& access, const QByteArray& code, const QString& token = {}) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("PYTHONPATH"), QStringLiteral(TRUNDLE_SOURCE_DIR "/core/sdk/python"));
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        const QString connect = QStringLiteral("import trundle\nrun = trundle.connect(%1, '%2')\n")
                                    .arg(access.port())
                                    .arg(token.isEmpty() ? access.token() : token);
        m_process.start(QStringLiteral("python3"),
                        {QStringLiteral("-B"), QStringLiteral("-c"), connect + QString::fromUtf8(code)});
    }
    ~Program() {
        m_process.kill();
        m_process.waitForFinished();
    }
    [[nodiscard]] bool ends() {
        return QTest::qWaitFor([this] { return m_process.state() == QProcess::NotRunning; }, 60000);
    }
    [[nodiscard]] QByteArray printed() {
        m_printed += m_process.readAll();
        return m_printed.trimmed();
    }
    bool write(const QByteArray& line) { return m_process.write(line + '\n') > 0; }

private:
    QProcess m_process;
    QByteArray m_printed;
};

} // namespace

class RemoteTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_fixture = std::make_unique<SessionFixture>();
        QVERIFY(m_fixture->open(kDriven));
    }
    void cleanup() { m_fixture.reset(); }

    void isOffUntilItIsSwitchedOn() {
        const RemoteAccess& access = remote();
        QVERIFY(!access.isOn() && !access.guestFor("x") && access.clientCount() == 0);
        session().step();
        EVENTUALLY(session().state() == RunState::Paused);
        QVERIFY(!access.isOn());
    }

    /// Switching it on builds the experiment, which waits at its start.
    void aProgramStepsAndReads() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        QCOMPARE(m_fixture->tick(), 0u);
        Program program(remote(), "run.hold('robot0')\nrun.step(1)\nrun['robot0/base/linearVelocity'] = 0.2\nrun.step(199)\n"
                                  "print(run.tick, run.state, round(run['robot0/base/linearVelocity'], 3))\nprint(run.hash())\n");
        QVERIFY(program.ends());
        EVENTUALLY(m_fixture->tick() == 200 && session().state() == RunState::Paused);
        const QList<QByteArray> lines = program.printed().split('\n');
        QVERIFY2(lines.size() == 2, program.printed());
        QCOMPARE(lines[0], QByteArray("200 paused 0.2"));
        const std::shared_ptr<const LiveSnapshot> snapshot = session().results().snapshot;
        QVERIFY(snapshot->hash);
        QCOMPARE(lines[1], QByteArray::number(qulonglong(*snapshot->hash), 16).rightJustified(16, '0'));
        const auto pose = session().results().layout->find("robot0/pose");
        QVERIFY(pose && snapshot->block->slots()[pose->offset] > 0.2); // it has driven
    }

    /// It asks for the pace as the buttons do.
    void aProgramRunsAndPauses() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        Program program(remote(),
                        "import sys\nrun.run(speed=4)\nprint(run.state)\nsys.stdout.flush()\nsys.stdin.readline()\nrun.pause()\n"
                        "print(run.state)\n");
        EVENTUALLY(session().state() == RunState::Running && session().speed() == 4);
        EVENTUALLY(m_fixture->tick() > 20);
        QVERIFY(program.write("go on"));
        QVERIFY(program.ends());
        QCOMPARE(program.printed(), QByteArray("running\npaused"));
        EVENTUALLY(session().state() == RunState::Paused);
        const std::uint64_t tick = m_fixture->tick();
        session().step(); // the window's own buttons work beside it
        EVENTUALLY(m_fixture->tick() == tick + 1 && session().state() == RunState::Paused);
    }

    void aProgramFollowsARunOfTheWindow() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        session().setSpeed(0);
        Program program(remote(), "s = run.subscribe('robot0/pose', every=10)\nprint('ready', flush=True)\n"
                                  "print([run.next(s).tick for _ in range(5)])\n");
        EVENTUALLY(program.printed() == "ready");
        EVENTUALLY(remote().clientCount() == 1);
        session().run();
        QVERIFY(program.ends());
        QCOMPARE(program.printed(), QByteArray("ready\n[10, 20, 30, 40, 50]"));
        EVENTUALLY(remote().clientCount() == 0);
        session().pause();
        EVENTUALLY(session().state() == RunState::Paused);
    }

    void whatIsRefused() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        Program wrong(remote(), "", QStringLiteral("not the token"));
        QVERIFY(wrong.ends());
        QVERIFY2(wrong.printed().contains("the token is wrong"), wrong.printed());
        Program program(remote(), "try:\n    run.reset()\nexcept trundle.RemoteError as e:\n    print(e)\n");
        QVERIFY(program.ends());
        QCOMPARE(program.printed(), QByteArray("the run is one of a window, which resets it"));
    }

    /// The port and the token stay; the connection is that of one run.
    void aResetEndsTheConnection() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        Program program(remote(), "import sys\nprint('ready', flush=True)\nsys.stdin.readline()\ntry:\n    run.step()\n"
                                  "except trundle.Disconnected:\n    print('gone', flush=True)\nsys.stdin.readline()\n"
                                  "run = trundle.connect(" +
                                      QByteArray::number(remote().port()) + ", '" + remote().token().toUtf8() +
                                      "')\nrun.step(3)\nprint(run.tick)\n");
        EVENTUALLY(program.printed() == "ready");
        session().reset();
        EVENTUALLY(session().endRuns());
        QVERIFY(program.write("again"));
        EVENTUALLY(program.printed() == "ready\ngone");
        session().step();
        EVENTUALLY(m_fixture->tick() == 1);
        QVERIFY(program.write("again"));
        QVERIFY(program.ends());
        QCOMPARE(program.printed(), QByteArray("ready\ngone\n4"));
    }

    void switchingOffEndsTheConnection() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        Program program(remote(), "import sys\nprint('ready', flush=True)\nsys.stdin.readline()\ntry:\n    run.step()\n"
                                  "except trundle.Disconnected:\n    print('gone')\n");
        EVENTUALLY(program.printed() == "ready");
        const std::uint16_t port = remote().port();
        const QString token = remote().token();
        remote().stop();
        QVERIFY(!remote().isOn());
        EVENTUALLY(remote().clientCount() == 0);
        QVERIFY(program.write("again"));
        QVERIFY(program.ends());
        QCOMPARE(program.printed(), QByteArray("ready\ngone"));
        session().step(); // the run goes on
        EVENTUALLY(m_fixture->tick() == 1);
        QCOMPARE(remote().start(port), QString());
        QVERIFY(remote().token() != token);
    }

    void switchingOffReleasesTheRobotsOfPrograms() {
        QCOMPARE(remote().start(0), QString());
        EVENTUALLY(session().state() == RunState::Paused);
        Program program(remote(), "import sys\nrun.hold('robot0')\nrun.step(1)\nprint('ready', flush=True)\n"
                                  "sys.stdin.readline()\n");
        EVENTUALLY(program.printed() == "ready");
        EVENTUALLY(remote().clientCount() == 1);
        remote().stop();
        EVENTUALLY(remote().clientCount() == 0);
        session().step();
        EVENTUALLY(m_fixture->tick() == 2);
        std::vector<HoldCommand> holds;
        for (const Command& command : session().robots().all())
            if (const auto* hold = std::get_if<HoldCommand>(&command.what)) holds.push_back(*hold);
        QCOMPARE(holds.size(), std::size_t(2));
        QVERIFY(holds[0].held && !holds[1].held && holds[1].robot == "robot0");
        QVERIFY(holds[0].holder == Holder::Guest && holds[1].holder == Holder::Guest);
    }

    void aTakenPortIsSaid() {
        QCOMPARE(remote().start(0), QString());
        SessionFixture other;
        const QString problem = other.session.remote().start(remote().port());
        QVERIFY2(problem.contains(QString::number(remote().port())), qPrintable(problem));
        QVERIFY(!other.session.remote().isOn());
    }

private:
    [[nodiscard]] RunSession& session() const { return m_fixture->session; }
    [[nodiscard]] RemoteAccess& remote() const { return m_fixture->session.remote(); }

    std::unique_ptr<SessionFixture> m_fixture;
};

QTEST_MAIN(RemoteTest)
#include "remote_test.moc"
