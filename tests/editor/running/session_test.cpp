#include <QProcess>
#include <QSignalSpy>
#include <QtTest>

#include <trundle/abi.h>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

int countIn(const char* folder) {
    return static_cast<int>(QDir(QLatin1String(folder)).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot).size());
}

} // namespace

class SessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void goesThroughItsStates() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        RunSession& s = o.session;
        s.setSpeed(0);
        QCOMPARE(s.state(), RunState::Start);
        QVERIFY(!s.results().experiment);
        QVERIFY(!s.results().poses);
        s.run();
        QCOMPARE(s.state(), RunState::Building);
        EVENTUALLY_EQUAL(s.state(), RunState::Running);
        EVENTUALLY(s.results().time() > 0.5);
        s.pause();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        const std::uint64_t there = o.tick();
        s.step();
        EVENTUALLY_EQUAL(o.tick(), there + 1);
        QCOMPARE(s.state(), RunState::Paused);
        s.run();
        EVENTUALLY(o.tick() > there + 100);
        s.reset();
        QCOMPARE(s.state(), RunState::Start);
        QCOMPARE(s.results().time(), 0.0);
        QVERIFY(!s.results().poses);
        s.step(); // starts the run, makes one tick and pauses
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        QCOMPARE(o.tick(), 1u);
        QCOMPARE(s.results().poses->size(), 3u);
    }

    void isTheSameRunAsThatOfTheCommandLine_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("speed");
        QTest::newRow("line") << "linear_motion.sim" << 0.0;
        QTest::newRow("obstacles") << "obstacle_detection.sim" << 0.0;
        QTest::newRow("swarm") << "swarm.sim" << 0.0;
        QTest::newRow("swarm, slower") << "swarm.sim" << 20.0;
    }
    void isTheSameRunAsThatOfTheCommandLine() {
        QFETCH(QString, name);
        QFETCH(double, speed);
        SessionFixture o;
        QVERIFY(o.openSample(name.toLatin1().constData()));
        QVERIFY(o.document.structure().setValues(u"Shorten"_qs, {{"Duration", "2"}}).ok() && o.document.saving().save().ok());

        QProcess cli;
        cli.start(QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle-cli"),
                  {QStringLiteral("run"), QString::fromStdString(o.document.path()), QStringLiteral("--quiet"),
                   QStringLiteral("--hash"), QStringLiteral("--log-dir"), o.folder.filePath(QStringLiteral("cli"))});
        QVERIFY(cli.waitForFinished(60000));
        QCOMPARE(cli.exitCode(), 0);
        const QString reportOf = QString::fromUtf8(cli.readAllStandardOutput()).trimmed();

        o.session.setSpeed(speed);
        o.session.run();
        QTRY_COMPARE_WITH_TIMEOUT(o.session.state(), RunState::Ended, 60000);
        QVERIFY(!o.session.results().end->failure);
        const auto shot = o.session.results().snapshot;
        QCOMPARE(QStringLiteral("state-hash %1 tick %2").arg(*shot->hash, 16, 16, QLatin1Char('0')).arg(shot->tick), reportOf);

        // The logs are the same, and are in the default folder of the command line.
        const QDir here(o.folder.filePath(QStringLiteral("logs/") + QFileInfo(name).completeBaseName()));
        const QDir there(o.folder.filePath(QStringLiteral("cli")));
        const QStringList files = there.entryList({QStringLiteral("*.csv")});
        QVERIFY(!files.isEmpty());
        for (const QString& file : files) {
            QFile a(here.filePath(file)), b(there.filePath(file));
            QVERIFY(a.open(QIODevice::ReadOnly));
            QVERIFY(b.open(QIODevice::ReadOnly));
            QCOMPARE(a.readAll(), b.readAll());
        }
    }

    void theStampedCommandsGiveTheSameRunAgain() {
        SessionFixture o;
        QVERIFY(o.openSample("obstacle_detection.sim"));
        const std::shared_ptr<const LoadedProject> loaded = o.document.loaded();
        const auto maker = [&](RunOptions options, Diagnostics& problems) {
            return o.application->makeRunner(*loaded, std::move(options), problems);
        };
        LiveRun::Options options;
        options.speed = 10; // fast, but not finished before all commands are given
        LiveRun run(maker, options);
        const auto tick = [&] { return run.snapshot() ? run.snapshot()->tick : 0; };
        run.run();
        EVENTUALLY(tick() > 50); // the following times depend on the machine
        run.keepPushing(PushCommand{"robot0/chassis", {0, 0.5, 0}, {0, 0, 0.1}});
        run.command(PropertyCommand{"robot0/leftMotor", "Resistance", {PropertyType::Number, {4}, {}}});
        run.command(PropertyCommand{"robot0/brain", "Speed", {PropertyType::Number, {0.1}, {}}});
        const std::uint64_t changed = tick();
        EVENTUALLY(tick() > changed + 100);
        run.keepPushing(std::nullopt);
        run.command(PlaceCommand{"robot0", {{0.3, 0.2, 0}, Quat::Identity()}});
        run.command(HoldCommand{"robot0", true});
        const std::uint64_t held = tick();
        QTRY_VERIFY2(tick() > held + 100, run.end() && run.end()->failure ? run.end()->failure->message.c_str() : "slow");
        run.pause();
        EVENTUALLY(run.snapshot() && run.snapshot()->hash);
        for (const LiveLine& line : run.takeLines().lines) QVERIFY2(line.severity != TRUNDLE_ERROR, line.text.c_str());

        const auto again = [&](const std::vector<Command>& commands, std::uint64_t ticks) {
            Diagnostics problems;
            const std::unique_ptr<Runner> runner = maker({}, problems);
            auto next = commands.begin();
            while (runner->world().ticks() < ticks) {
                for (; next != commands.end() && next->tick == runner->world().ticks(); ++next) runner->command(next->what);
                if (!runner->tick()) return std::uint64_t(0);
            }
            return runner->world().stateHash();
        };
        const auto shot = run.snapshot();
        std::vector<Command> commands = run.commands();
        QCOMPARE(again(commands, shot->tick), *shot->hash);
        std::erase_if(commands, [](const Command& c) { return std::holds_alternative<PropertyCommand>(c.what); });
        QVERIFY(again(commands, shot->tick) != *shot->hash); // the motor and the controller took their new values
    }

    void isRefusedWhileTheTextHasErrors() {
        SessionFixture o;
        QVERIFY(o.session.source().refusal().contains(QStringLiteral("open"))); // no document is open
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("SimpleRobot", "SimpleRobt")));
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        o.session.run();
        QCOMPARE(refused.size(), 1);
        QVERIFY(refused[0][0].toString().contains(QStringLiteral("SimpleRobt")));
        o.session.step();
        QCOMPARE(refused.size(), 2);
        QCOMPARE(o.session.state(), RunState::Start);
        QVERIFY(o.document.edits().replaceText(QStringLiteral("Fix"), o.document.path(), kStandingRobot.toStdString()).ok());
        QVERIFY(o.session.source().refusal().isEmpty());
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
    }

    void aModuleThatIsNotDescribedIsNoErrorOfTheText() {
        SessionFixture o;
        QVERIFY(
            QFile::copy(QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle/controllers/librandom_drive.so"), o.path("libalone.so")));
        QVERIFY(o.open("#loadModule alone\n" + kStandingRobot));
        OpenOptions trusting = o.document.options();
        trusting.modules.push_back(o.folder.path().toStdString());
        o.document.setOptions(trusting);
        const QString why = o.session.source().refusal();
        QVERIFY2(why.contains(QStringLiteral("no description file")) && !why.contains(QStringLiteral("error")), qPrintable(why));
    }

    void blowUpStopsRunAndReportsWhere() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        QSignalSpy ended(&o.session, &RunSession::ended);
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        QVERIFY(o.session.robots().push("robot0/chassis", {0, 0, 9e8}, {0, 0, 0}));
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QCOMPARE(ended.size(), 1);
        QVERIFY(o.session.results().end->failure);
        QVERIFY(!o.session.results().end->body.empty());
        QVERIFY(o.session.results().end->time > 0);
        QCOMPARE(o.session.messages().problems().size(), 1u);
        QVERIFY(o.session.messages().problems()[0].range.known()); // a source range to click
        QVERIFY(o.session.results().poses);                        // the last poses are still shown
        o.session.reset();
        QVERIFY(o.session.state() == RunState::Start && o.session.messages().problems().empty());
    }

    void windowStaysResponsiveDuringRun() {
        SessionFixture o;
        QVERIFY(o.openSample("swarm.sim"));
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        int turns = 0; // iterations of the event loop while the run makes 200 ticks
        QTimer idle;
        connect(&idle, &QTimer::timeout, this, [&] { ++turns; });
        idle.start(0);
        QTRY_VERIFY_WITH_TIMEOUT(o.tick() > 200, 60000);
        QVERIFY2(turns > 200, qPrintable(QString::number(turns)));
    }

    void theDocumentStaysAsItIs() {
        SessionFixture o;
        QVERIFY(o.openSample("obstacle_detection.sim"));
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY(o.session.results().time() > 1);
        o.session.reset();
        QVERIFY(!o.document.texts().isModified());
        QCOMPARE(o.document.edits().history().entries().size(), 0u);
    }

    void anotherProjectEndsTheRun() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        QVERIFY(o.open(kStandingRobot, "other.sim"));
        QCOMPARE(o.session.state(), RunState::Start);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        o.document.opening().close();
        QCOMPARE(o.session.state(), RunState::Start);
        QVERIFY(!o.session.source().refusal().isEmpty());
    }

    void keepsPosesAsStart() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("Robot robot0", "// the one\nRobot robot0")));
        QVERIFY(!o.session.robots().keepRefusal().isEmpty()); // there was no run
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        QVERIFY(o.session.robots().place("robot0", {{1.25, -0.5, 0}, Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()))}));
        QCOMPARE(o.session.robots().pose("robot0")->position.x(), 1.25); // shown before the tick that applies it
        QVERIFY((o.session.results().poses->at(0).position - Vec3(1.25, -0.5, 0)).norm() < 0.2);
        o.session.step();
        EVENTUALLY_EQUAL(o.tick(), 2u);
        QVERIFY(std::abs(o.session.robots().pose("robot0")->position.x() - 1.25) < 1e-3);
        QCOMPARE(o.session.robots().keepRefusal(), QString());
        o.session.robots().keepPoses();
        QCOMPARE(o.document.edits().history().entries().size(), 1u);
        const std::string text = *o.document.texts().text(o.document.path());
        QVERIFY2(text.find("// the one\nRobot robot0") != std::string::npos, text.c_str());
        QVERIFY2(text.find("Pos=1.2") != std::string::npos, text.c_str());
        QVERIFY2(text.find("Pos=0,0,0 HPR") == std::string::npos, text.c_str());
        const Pose kept = o.document.loaded()->experiment->robots[0].pose;
        QVERIFY((kept.position - o.session.robots().pose("robot0")->position).norm() < 1e-6);
        QVERIFY(kept.rotation.angularDistance(o.session.robots().pose("robot0")->rotation) < 1e-5);
        o.document.edits().undo();
        QVERIFY(!o.document.texts().isModified());
        QVERIFY(o.session.robots().place("robot0", {{1.25, -0.5, -3.91e-5}, Quat::Identity()}));
        o.session.robots().keepPoses();
        const std::string plain = *o.document.texts().text(o.document.path());
        QVERIFY2(plain.find("Pos=1.25,-0.5,-0.000039 HPR=0,0,0 }") != std::string::npos, plain.c_str()); // no exponent
    }

    void skipsPoseOfRobotWithReusedName() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        o.session.enable(RunSession::Extra::Contacts, true);
        o.session.step();
        EVENTUALLY(o.session.state() == RunState::Paused && o.session.results().snapshot->contacts);
        QVERIFY(o.session.robots().place("robot0", {{1.25, -0.5, 0}, Quat::Identity()}));
        QVERIFY(!o.session.results().snapshot->contacts); // they belonged to the previous pose
        const std::string path = o.document.path();
        const auto put = [&](const QByteArray& robot) {
            const QByteArray text =
                QByteArray(kStandingRobot).replace("Robot robot0 { Config=SimpleRobot Pos=0,0,0 HPR=0,0,0 }", robot);
            return text != kStandingRobot && o.document.edits().replaceText(u"Type"_qs, path, text.toStdString()).ok();
        };
        QVERIFY(put(""));
        QVERIFY(put("Robot robot0 { Config=SimpleRobot Pos=3,0,0 HPR=0,0,0 }"));
        QVERIFY(!o.session.edits().isOfRun("robot0"));
        QVERIFY(!o.session.robots().place("robot0", {{2, 0, 0}, Quat::Identity()}));
        QVERIFY(o.session.robots().keepRefusal().startsWith(QStringLiteral("robot0: new or renamed")));
        for (int i = 0; i < 2; ++i) o.document.edits().undo();
        QVERIFY(o.session.edits().isOfRun("robot0"));
        QVERIFY(put("Robot robot0 { Config=SimpleRobot Pos=0,0,0 HPR=0,0,0 }\nRobot other { Config=SimpleRobot Pos=3,0,0 }"));
        QSignalSpy reportOf(&o.document, &Document::notice);
        o.session.robots().keepPoses();
        QCOMPARE(reportOf.size(), 1);
        QVERIFY(reportOf[0][0].toString().contains(QStringLiteral("except of other")));
        QVERIFY(o.document.texts().text(path)->find("Pos=1.25,-0.5") != std::string::npos);
    }

    void membersOfAGridHaveNoStartOfTheirOwn() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot)
                           .replace("Robot robot0 { Config=SimpleRobot Pos=0,0,0 HPR=0,0,0 }",
                                    "Grid swarm { Config=SimpleRobot Count=2 Spacing=1 }")));
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        QVERIFY(o.session.robots().place("swarm_1", {{2, 0, 0}, Quat::Identity()}));
        QVERIFY(o.session.robots().keepRefusal().contains(QStringLiteral("Replace swarm by single instances")));
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        o.session.robots().keepPoses();
        QCOMPARE(refused.size(), 1);
        QVERIFY(!o.document.texts().isModified());
    }

    void aRobotIsDrivenWhileItsControllerWaits() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot)
                           .replace("#import arenas", "#loadModule controllers/random_drive\n#import arenas")
                           .replace("HPR=0,0,0 }", "HPR=0,0,0 RandomDrive brain { Speed=1 Period=0.05 } }")));
        RunSession& s = o.session;
        s.setSpeed(0);
        QVERIFY(!s.robots().drive("robot0", 0.2, 0)); // only during a run
        s.step();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        QVERIFY(!s.robots().drive("arena", 0.2, 0));
        QVERIFY(s.robots().drive("robot0", 0.2, 0));
        const auto speed = [&] {
            return s.results().snapshot->block->slots()[s.results().layout->find("robot0/base/linearVelocity")->offset];
        };
        const std::uint64_t from = o.tick();
        for (std::uint64_t i = 1; i <= 30; ++i) {
            s.step();
            EVENTUALLY_EQUAL(o.tick(), from + i);
            QCOMPARE(speed(), 0.2); // the controller would have changed it
        }
        s.robots().stopDriving();
        QVERIFY(s.robots().driven().empty());
        for (int i = 0; i < 10; ++i) s.step();
        EVENTUALLY_EQUAL(o.tick(), from + 40);
        QVERIFY(speed() != 0.2);
    }

    void liveValuesReachTheRunAtOnceAndOthersWait() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        RunSession& s = o.session;
        s.step();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        const auto resistance = [&] { return s.results().experiment->robots[0].config->devices[0].number("Resistance"); };
        QCOMPARE(resistance(), 2.0);

        QVERIFY(o.document.structure().setValues(QStringLiteral("Resistance"), {{"robot0.leftMotor.Resistance", "3"}}).ok());
        QVERIFY(!s.edits().needsReset());
        QCOMPARE(resistance(), 3.0);
        QCOMPARE(s.results().built->experiment->robots[0].config->devices[0].number("Resistance"), 2.0);

        QVERIFY(
            o.document.structure().setValues(u"Set"_qs, {{"robot0.leftMotor.GearRatio", "20"}, {"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(s.edits().needsReset());
        QVERIFY(s.edits().waitsForReset("robot0.leftMotor.GearRatio"));
        QVERIFY(s.edits().waitsForReset("robot0.Pos"));
        QVERIFY(!s.edits().waitsForReset("robot0.leftMotor.Resistance"));
        QVERIFY(!s.edits().waitsForReset("robot0.HPR"));
        o.document.edits().undo();
        QVERIFY(!s.edits().needsReset());
        o.document.edits().undo(); // undo changes the running world too
        QCOMPARE(resistance(), 2.0);

        QVERIFY(o.document.structure().setValues(QStringLiteral("Tick"), {{"Tick", "0.02"}}).ok());
        QCOMPARE(s.edits().waiting(), std::vector<std::string>{"Tick"});
        s.reset();
        QVERIFY(!s.edits().needsReset());
    }

    void aNewObjectWaitsAsAWhole() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        RunSession& s = o.session;
        s.step();
        EVENTUALLY_EQUAL(s.state(), RunState::Paused);
        const std::string more = kStandingRobot.toStdString() + "Robot robot1 { Config=SimpleRobot Pos=1,1,0 }\n";
        QVERIFY(o.document.edits().replaceText(QStringLiteral("Add"), o.document.path(), more).ok());
        QCOMPARE(s.edits().waiting(), std::vector<std::string>{"robot1"});
        QVERIFY(s.edits().waitsForReset("robot1.Pos") && !s.edits().waitsForReset("robot10") &&
                !s.edits().waitsForReset("robot10.Pos"));
    }

    void slipperySurfaceTakesEffectInRun() {
        // A force below the friction of rubber moves nothing; on ice the robot moves.
        const QByteArray text = R"(Tick = 0.01
Surface skin { Friction = 0.9 }
StaticConfig Floor { Plane ground { Surface=skin } }
RobotConfig Block { Body block { Box box { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=1 Surface=skin } } }
Static floor { Config=Floor Pos=0,0,0 }
Robot crate { Config=Block Pos=0,0,0 }
)";
        SessionFixture o;
        QVERIFY(o.open(text));
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        o.session.step();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        const auto pushed = [&] {
            o.session.robots().push("crate/block", {4, 0, 0}, {0, 0, 0.02});
            const std::uint64_t until = o.tick() + 50;
            for (int i = 0; i < 50; ++i) o.session.step();
            [&] { EVENTUALLY_EQUAL(o.tick(), until); }();
            return o.session.robots().pose("crate")->position.x();
        };
        const double held = pushed();
        QVERIFY2(std::abs(held) < 0.02, qPrintable(QString::number(held)));
        QVERIFY(o.document.structure().setValues(QStringLiteral("Ice"), {{"Surface.skin.Friction", "0.01"}}).ok());
        QVERIFY(!o.session.edits().needsReset() && pushed() > held + 0.1);
    }

    void reportsBuildFailureAndKeepsStart() {
        SessionFixture o;
        // Two motors on one drive of a joint: detected only when the world is built.
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("HPR=0,0,0 }", "HPR=0,0,0 base.RightMotor=leftMotor }")));
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        QSignalSpy ended(&o.session, &RunSession::ended);
        std::vector<std::string> lines;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& more) {
            for (const LiveLine& line : more) lines.push_back(line.text);
        });
        o.session.run();
        EVENTUALLY_EQUAL(ended.size(), 1);
        QCOMPARE(o.session.state(), RunState::Start);
        QCOMPARE(o.session.messages().problems().size(), 1u);
        QCOMPARE(lines.size(), 1u);
        QVERIFY(lines[0].find("same motor") != std::string::npos);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(o.session.messages().problems().empty());
    }

    void openRunCloseLeaksNothing() {
        const int rounds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 200 : 20;
        int threads = 0, descriptors = 0;
        for (int i = 0; i < rounds; ++i) {
            {
                SessionFixture o;
                QVERIFY(o.openSample("linear_motion.sim"));
                o.session.setSpeed(0);
                o.session.run();
                if (i % 4) EVENTUALLY(o.tick() > 5);
                if (i % 3) o.session.reset();
            }
            if (i == 0) { // permanent caches of Qt and libraries exist by now
                QTest::qWait(0);
                threads = countIn("/proc/self/task");
                descriptors = countIn("/proc/self/fd");
            }
        }
        EVENTUALLY(countIn("/proc/self/task") <= threads);
        EVENTUALLY(countIn("/proc/self/fd") <= descriptors);
    }
};

QTEST_MAIN(SessionTest)
#include "session_test.moc"
