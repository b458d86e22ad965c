// Faults of controllers in processes of their own: the run goes on, all other robots move as without the sick one, and the report
// names robot, module, function and line.
#include <csignal>
#include <set>

#include "flow/cli.h"

namespace {

bool isLong() { return qEnvironmentVariableIsSet("TRUNDLE_LONG"); }

const QString kZoo = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo"),
              kRogue = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/rogue");

} // namespace

class IsolatedModulesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QByteArray m_trace; ///< of the sound robots beside one that does nothing bad

    /// Beside a robot of another module and one of the same module. `controller`: "Zoo" or "Rogue".
    QString experiment(const QByteArray& isolation, const QByteArray& kind, const QByteArray& settings) {
        const QString path = m_folder.filePath("isolated.sim");
        const QByteArray module = kind.toLower(), count = isolation == "robot" ? "second" : "good";
        const bool written =
            writeFile(path, "Duration = 1  Isolation = " + isolation +
                                "\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                "#loadModule controllers/linear_motion\n#loadModule zoo\n#loadModule rogue\n"
                                "Static floor { Config=OpenFloor }\n"
                                "Robot good { Config=SimpleRobot LinearMotion brain { } }\n"
                                "Robot bad { Config=SimpleRobot Pos=0,2,0 " +
                                kind + " brain { " + settings +
                                " } }\nRobot second { Config=SimpleRobot Pos=0,-2,0 Rogue brain { } }\n"
                                "PoseLog path { Robot=good }\nPoseLog other { Robot=" +
                                count + " }\n");
        return written ? path : QString();
    }
    Outcome run(const QString& path, const QStringList& more = {}) {
        QDir(m_folder.filePath("logs")).removeRecursively();
        QStringList words{"ASAN_OPTIONS=" + kOwnHandlers, "TSAN_OPTIONS=" + kOwnHandlers, "UBSAN_OPTIONS=" + kOwnHandlers};
        words << programPath() << "run" << path << "--json" << "--quiet" << "--modules" << kZoo << "--modules" << kRogue
              << "--log-dir" << m_folder.filePath("logs");
        return callProgram("/usr/bin/env", words + more, m_folder.path(), 120);
    }
    QByteArray trace() const { return contentOf(m_folder.filePath("logs/path.csv")); }
    QByteArray otherTrace() const { return contentOf(m_folder.filePath("logs/other.csv")); }

private Q_SLOTS:
    void initTestCase();
    void everyFaultStaysInItsProcess_data();
    void everyFaultStaysInItsProcess();
    void aFaultInSetupIsAnErrorOfTheText_data();
    void aFaultInSetupIsAnErrorOfTheText();
    void aFaultOnLoadIsAnErrorOfItsLine();
    void otherRobotsOfTheProcessGoOn();
    void reportsFunctionAndLine();
    void anExceptionIsReportedWithItsLine();
    void aHangIsReportedWithItsLine();
    void aHangTakesNoTimeOfOtherProcesses();
    void aRecursionIsFolded();
    void theReportIsWholeAndInOrder();
    void whatWasSaidBeforeACrashCounts();
    void aCrashOnUnloadIsReported();
    void anInterruptedHangEndsWithResults_data();
    void anInterruptedHangEndsWithResults();
    void commandsOfAStoppedRobotAreZero();
    void failEndsTheRun();
    void isolationOfABlockHoldsForItAlone();
    void givesTheSameStateInAnyProcess_data();
    void givesTheSameStateInAnyProcess();
    void aSlowUpdateIsReported();
};

void IsolatedModulesTest::initTestCase() {
    for (const char* isolation : {"none", "module", "robot"}) {
        const Outcome outcome = run(experiment(isolation, "Zoo", {}));
        QVERIFY2(outcome.code == 0, shown(outcome));
        QVERIFY2(m_trace.isEmpty() || trace() == m_trace, isolation);
        m_trace = trace();
        QCOMPARE(m_trace.count('\n'), 102);
    }
}

void IsolatedModulesTest::everyFaultStaysInItsProcess_data() {
    QTest::addColumn<QByteArray>("kind");
    QTest::addColumn<QByteArray>("settings");
    QTest::addColumn<QByteArray>("isolation");
    QTest::addColumn<QByteArray>("said"); ///< part of the reason; empty: it is not stopped
    std::set<QByteArray> names;
    const auto row = [&](const QByteArray& kind, const QByteArray& action, const QByteArray& said, const QByteArray& more = {}) {
        for (const char* isolation : {"module", "robot"}) {
            if (!isLong() && kind == "Zoo" && (isolation == QByteArray("robot")) != (names.size() % 4 == 0)) continue;
            const QByteArray name = kind + ": " + action + ", " + isolation;
            QVERIFY2(names.insert(name).second, name);
            QTest::newRow(name.constData()) << kind << "Action=\"" + action + "\" " + more << QByteArray(isolation) << said;
        }
    };
    const QByteArray crashed = "the controller Zoo of bad (" + kZoo.toUtf8() + "/libzoo.so) crashed in update: ";
    const auto crash = [&](const char* action, const QByteArray& why) { row("Zoo", action, crashed + why); };
    crash("segv", "Segmentation fault");
    crash("jump", "Segmentation fault");
    crash("divide", "Arithmetic exception");
    crash("trap", "Illegal instruction");
    crash("bus", "Bus error");
    crash("abort", "Aborted");
    crash("overflow", "Segmentation fault");
    crash("double free", "Aborted");
    crash("terminate", "Aborted");
    crash("throw past noexcept", "Aborted, uncaught exception: no ");
    crash("leave thread", "Aborted");
    crash("trapped division", "Arithmetic exception");
    for (const char* exit : {"exit", "_exit", "_Exit", "quick_exit"})
        row("Zoo", exit, "ended its process in update, by exit() or the like");
    const QByteArray thread = "a thread of the module " + kZoo.toUtf8() + "/libzoo.so ";
    for (const char* action : {"thread crashes", "thread throws", "thread aborts", "thread jumps", "thread of a thread crashes",
                               "thread overflows", "thread overflows in the C library", "standard thread overflows",
                               "library code crashes in a thread", "bare thread crashes", "bare thread overflows"})
        row("Zoo", action, thread + "crashed in update: ");
    for (const char* action : {"thread exits", "thread _exits", "thread quick_exits"}) row("Zoo", action, thread + "ended its ");
    for (const char* action : {"throw", "throw int", "throw other", "throw much"}) row("Zoo", action, "the controller Zoo of bad failed: ");
    row("Zoo", "print escapes and be killed", "ended its process in update: SIGKILL");
    row("Zoo", "print escapes and leave", "ended its process in update with exit code 7");
    row("Zoo", "terminate itself", "ended its process in update: SIGTERM");
    row("Zoo", "user signal", "ended its process in update: SIGUSR1");
    for (const char* action : {"loop", "ignore and loop", "block and loop"})
        row("Zoo", action, "did not return from update within 1.0 s and was stopped", "Budget=20");
    for (const char* action :
         {"round up", "trap floats", "flush denormals", "replace standard", "close standard", "close all", "replace all", "flood",
          "ignore signals", "handle signals", "block signals", "change folder", "set locale", "umask", "fork without leave", "fork",
          "wait for all children", "break pipe", "command nan", "command infinity", "print badly", "print much", "print long",
          "log badly", "write outputs", "bare thread ends", "print escapes"})
        row("Zoo", action, {});
    row("Rogue", "write a sensor", "wrote to a sensor value in update, which only the simulation may set");
    for (const char* action : {"stop itself", "print without end", "open logs without end"})
        row("Rogue", action, "did not return from update within 1.0 s", "Budget=20");
    row("Rogue", "leave", "ended its process in update with exit code 0");
    row("Rogue", "kill itself", "ended its process in update: SIGKILL");
    row("Rogue", "overwrite control", "damaged the messages");
    row("Rogue", "unmap control", "ended its process in update with exit code 1"); // without the page it cannot report why
    row("Rogue", "eat memory", "the controller Rogue of bad failed: std::bad_alloc");
    for (const char* action :
         {"kill the parent", "kill all", "kill the group", "trace me", "trace the parent", "execute", "system", "fork bomb",
          "thread bomb", "keep a thread", "keep writing", "close 0 to 63", "raise limits", "outlive the parent",
          "read the input", "change folder", "make sensors writable", "overwrite commands", "shrink segments"})
        row("Rogue", action, {});
}

void IsolatedModulesTest::everyFaultStaysInItsProcess() {
    QFETCH(QByteArray, kind);
    QFETCH(QByteArray, settings);
    QFETCH(QByteArray, isolation);
    QFETCH(QByteArray, said);
    const Outcome outcome = run(experiment(isolation, kind, settings));
    QCOMPARE(trace(), m_trace);
    QVERIFY2(outcome.code == (said.isEmpty() ? 0 : 4), shown(outcome).left(4000));
    const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
    QCOMPARE(json["ticks"].toInt(), 100);
    QVERIFY(!json.contains("crashed"));
    const QJsonArray stopped = json["stopped"].toArray();
    if (said.isEmpty()) QCOMPARE(stopped.size(), 0);
    else QVERIFY2(!stopped.isEmpty() && stopped[0]["reason"].toString().toUtf8().contains(said), shown(outcome).left(4000));
    if (!said.isEmpty()) {
        QCOMPARE(stopped[0]["robot"].toString(), QStringLiteral("bad"));
        QCOMPARE(stopped[0]["time"].toDouble(), 0.49);
        QVERIFY2(outcome.err.contains("error E410: at t = 0.49 s "), shown(outcome).left(4000));
    }
    if (isolation == "robot") QVERIFY2(stopped.size() <= 1, shown(outcome).left(4000)); // also not the one of the same module
    QCOMPARE(controlCharacters(outcome.err), QByteArray());
}

void IsolatedModulesTest::aFaultInSetupIsAnErrorOfTheText_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("segv") << QByteArray("crashed in setup: Segmentation fault");
    QTest::newRow("exit") << QByteArray("ended its process in setup");
    QTest::newRow("throw") << QByteArray("failed in setup: no ");
    QTest::newRow("unended port") << QByteArray("a name without a terminating zero byte");
}

void IsolatedModulesTest::aFaultInSetupIsAnErrorOfTheText() {
    QFETCH(QByteArray, said);
    const Outcome outcome = run(experiment("module", "Zoo", QByteArray("Phase=setup Action=\"") + QTest::currentDataTag() + "\""));
    QVERIFY2(outcome.code == 4 && outcome.err.contains(said), shown(outcome));
    QVERIFY2(outcome.err.contains("isolated.sim:9:"), shown(outcome)); // the line of its block
}

void IsolatedModulesTest::aFaultOnLoadIsAnErrorOfItsLine() {
    QDir(m_folder.filePath("logs")).removeRecursively();
    const Outcome outcome =
        callProgram("/usr/bin/env", {"TRUNDLE_ZOO_LOAD=segv", programPath(), "run", experiment("module", "Zoo", {}), "--json",
                                     "--modules", kZoo, "--modules", kRogue});
    QVERIFY2(outcome.code == 1, shown(outcome));
    QVERIFY2(outcome.err.contains("isolated.sim:5:13: error E403: " + kZoo.toUtf8() + "/libzoo.so crashed in load: Segmentation"),
             shown(outcome));
}

/// They start again in a new process; the one at fault stays stopped.
void IsolatedModulesTest::otherRobotsOfTheProcessGoOn() {
    for (const char* isolation : {"module", "robot"}) {
        const Outcome outcome = run(experiment(isolation, "Rogue", "Action=\"leave\""));
        QVERIFY2(outcome.code == 4, shown(outcome));
        const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
        QCOMPARE(json["ticks"].toInt(), 100);
        QCOMPARE(json["stopped"].toArray().size(), 1);
        QCOMPARE(json["stopped"].toArray()[0].toObject()["robot"].toString(), QStringLiteral("bad"));
        QCOMPARE(outcome.err.count("of second shares its process with that of bad: "), isolation == QByteArray("module") ? 1 : 0);
        QCOMPARE(outcome.err.count("it was started again in a new process"), isolation == QByteArray("module") ? 1 : 0);
    }
}

/// In a sanitizer build its own frames are on the stack too.
void IsolatedModulesTest::reportsFunctionAndLine() {
    const Outcome outcome = run(experiment("module", "Zoo", "Action=\"bus\""));
    const QJsonObject stopped = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray()[0].toObject();
    const QFile source(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/control/modules/zoo.cpp"));
    const QList<QByteArray> lines = contentOf(source.fileName()).split('\n');
    const QRegularExpressionMatch place =
        QRegularExpression("busError\\(\\) at (\\S+/zoo\\.cpp):(\\d+)$").match(stopped["backtrace"].toArray()[0].toString());
    QVERIFY2(place.hasMatch(), shown(outcome));
    QCOMPARE(place.captured(1), source.fileName());
    QVERIFY2(lines.value(place.captured(2).toInt() - 1).contains("SIGBUS"), shown(outcome)); // the comment of that line
    QVERIFY2(stopped["reason"].toString().contains("busError() at zoo.cpp:" + place.captured(2)), shown(outcome));
    QVERIFY2(outcome.err.contains("bad] error:   (anonymous namespace)::Zoo::update"), shown(outcome));
}

void IsolatedModulesTest::anExceptionIsReportedWithItsLine() {
    const QList<QByteArray> lines = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/control/modules/zoo.cpp")).split('\n');
    static const QRegularExpression place("no [\\s\\S]*, in .* at zoo\\.cpp:(\\d+)");
    for (const char* isolation : {"module", "robot"}) {
        const Outcome outcome = run(experiment(isolation, "Zoo", "Action=throw"));
        const QJsonObject stopped = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray()[0].toObject();
        const QRegularExpressionMatch found = place.match(stopped["reason"].toString());
        QVERIFY2(found.hasMatch(), shown(outcome));
        QVERIFY2(lines.value(found.captured(1).toInt() - 1).contains("throw std::runtime_error"), shown(outcome));
        QVERIFY2(outcome.err.contains("bad] error:   (anonymous namespace)::Zoo::update"), shown(outcome));
    }
    const Outcome setup = run(experiment("module", "Zoo", "Phase=setup Action=throw"));
    QVERIFY2(place.match(QString::fromUtf8(setup.err)).hasMatch(), shown(setup));
    QVERIFY2(setup.err.contains("Zoo::setup"), shown(setup));
    // One that the controller catches, and gives up, is no place of a fault.
    const Outcome caught = run(experiment("module", "Zoo", "Action=\"catch and fail\""));
    QVERIFY2(caught.err.contains("gave up: caught it") && !caught.err.contains("zoo.cpp:"), shown(caught));
}

void IsolatedModulesTest::aHangIsReportedWithItsLine() {
    const Outcome outcome = run(experiment("module", "Zoo", "Action=loop Budget=20"));
    const QJsonObject stopped = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray()[0].toObject();
    const QList<QByteArray> lines = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/control/modules/zoo.cpp")).split('\n');
    const QRegularExpressionMatch place =
        QRegularExpression("did not return .* was stopped, in .*loop\\(\\) at zoo\\.cpp:(\\d+)$").match(stopped["reason"].toString());
    QVERIFY2(place.hasMatch(), shown(outcome));
    const int line = place.captured(1).toInt();
    QVERIFY2(lines.mid(line - 3, 5).join('\n').contains("loop"), qPrintable(place.captured(1)));
}

/// Their limits may be shorter than the time that the run waited for it.
void IsolatedModulesTest::aHangTakesNoTimeOfOtherProcesses() {
    const QString path = m_folder.filePath("hang.sim");
    QVERIFY(writeFile(path, "Duration = 0.5  Isolation = robot\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                            "#loadModule zoo\n#loadModule rogue\nStatic floor { Config=OpenFloor }\n"
                            "Robot bad { Config=SimpleRobot Zoo brain { Action=loop Budget=100 } }\n"
                            "Robot good { Config=SimpleRobot Pos=0,2,0 Rogue brain { Budget=20 } }\n"));
    const Outcome outcome = run(path);
    const QJsonArray stopped = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray();
    QVERIFY2(stopped.size() == 1, shown(outcome));
    QCOMPARE(stopped[0].toObject()["robot"].toString(), QStringLiteral("bad"));
}

void IsolatedModulesTest::aRecursionIsFolded() {
    const Outcome outcome = run(experiment("module", "Zoo", "Action=overflow"));
    const QJsonArray frames = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray()[0].toObject()["backtrace"].toArray();
    QVERIFY2(frames.size() >= 2 && frames.size() < 10, shown(outcome));
    const auto isFolded = [](const QJsonValue& frame) { return frame.toString().contains("more of the same"); };
    QCOMPARE(std::count_if(frames.begin(), frames.end(), isFolded), 1);
}

/// Nothing of it is dropped by the limit of lines, and no frame of the SDK is in it.
void IsolatedModulesTest::theReportIsWholeAndInOrder() {
    const Outcome outcome = run(experiment("module", "Zoo", "Action=\"print lines and crash\" Budget=0.000001"));
    const QJsonArray frames = QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray()[0].toObject()["backtrace"].toArray();
    QVERIFY2(!frames.isEmpty(), shown(outcome));
    QVERIFY2(outcome.err.contains("bad] warning: an update of the controller brain took "), shown(outcome).left(3000));
    qsizetype at = outcome.err.indexOf("error E410: ");
    for (const QJsonValue& frame : frames) {
        QVERIFY2(!frame.toString().contains("/include/trundle/"), qPrintable(frame.toString()));
        at = outcome.err.indexOf("bad] error:   " + frame.toString().toUtf8(), at);
        QVERIFY2(at > 0, qPrintable(frame.toString()));
    }
}

void IsolatedModulesTest::whatWasSaidBeforeACrashCounts() {
    const Outcome failed = run(experiment("module", "Zoo", "Action=\"fail and crash\""));
    QVERIFY2(failed.code == 4 && failed.err.contains("; it had called fail(): no way out"), shown(failed));
    const Outcome finished = run(experiment("module", "Zoo", "Action=\"finish and crash\""));
    QVERIFY2(finished.code == 4, shown(finished));
    const QJsonObject json = QJsonDocument::fromJson(finished.out).object();
    QCOMPARE(json["finished"].toObject()["reason"].toString(), QStringLiteral("all found"));
    QCOMPARE(json["ticks"].toInt(), 50);
    QCOMPARE(json["stopped"].toArray().size(), 1);
    const Outcome printed = run(experiment("module", "Zoo", "Action=\"print from a thread\""));
    QVERIFY2(printed.code == 0 && printed.err.count("what other threads of the module ask for is ignored") == 1, shown(printed));
}

void IsolatedModulesTest::aCrashOnUnloadIsReported() {
    const Outcome outcome = run(experiment("module", "Zoo", "Action=\"crash at exit\""));
    QVERIFY2(outcome.code == 4 && outcome.err.contains("libzoo.so crashed in unload: Segmentation fault"), shown(outcome));
    const Outcome thrown = callProgram("/usr/bin/env", {"TRUNDLE_ZOO_DESCRIBE=throw", programPath(), "run", experiment("module", "Zoo", {}),
                                                        "--json", "--modules", kZoo, "--modules", kRogue});
    QVERIFY2(thrown.code == 1 && thrown.err.contains("isolated.sim:5:13: error E405: "), shown(thrown));
    QVERIFY2(thrown.err.contains("gives no description of itself"), shown(thrown));
    QVERIFY2(!thrown.err.contains("damaged the messages"), shown(thrown));
}

void IsolatedModulesTest::anInterruptedHangEndsWithResults_data() {
    QTest::addColumn<QByteArray>("settings");
    QTest::newRow("update") << QByteArray("Action=loop");
    QTest::newRow("update, all signals blocked") << QByteArray("Action=\"block and loop\"");
}

void IsolatedModulesTest::anInterruptedHangEndsWithResults() {
    QFETCH(QByteArray, settings);
    const QString path = experiment("module", "Zoo", settings), pid = m_folder.filePath("pid"), logs = m_folder.filePath("logs");
    QFile::remove(pid);
    QDir(logs).removeRecursively();
    QProcess program;
    program.setWorkingDirectory(m_folder.path());
    program.start("/bin/sh", {"-c", "echo $$ > \"$1\"; shift; exec \"$@\"", "sh", pid, programPath(), "run", path, "--json", "--quiet",
                              "--modules", kZoo, "--modules", kRogue, "--log-dir", logs});
    QVERIFY(program.waitForStarted());
    QByteArray errors;
    const auto waits = [&] { return (errors += program.readAllStandardError()).contains("waiting for the controller Zoo of bad in update"); };
    const bool begun = QTest::qWaitFor(waits, 30'000);
    ::kill(contentOf(pid).trimmed().toInt(), begun ? SIGTERM : SIGKILL);
    QVERIFY(program.waitForFinished(30'000));
    QVERIFY2(begun && program.exitStatus() == QProcess::NormalExit, errors);
    QCOMPARE(program.exitCode(), 130);
    const QJsonObject json = QJsonDocument::fromJson(program.readAllStandardOutput()).object();
    QVERIFY(json["interrupted"].toBool());
    QVERIFY(json["state_hash"].isString());
    QVERIFY(json["stopped"].toArray()[0].toObject()["reason"].toString().contains("s of the request to end and was stopped"));
}

void IsolatedModulesTest::commandsOfAStoppedRobotAreZero() {
    const Outcome outcome = run(experiment("module", "Rogue", "Action=\"leave\""));
    const QJsonObject robots = QJsonDocument::fromJson(outcome.out).object()["robots"].toObject();
    const QJsonObject signal = robots["bad"].toObject()["signals"].toObject();
    QCOMPARE(signal["base/linearVelocity"].toDouble(-1), 0.0);
    QCOMPARE(signal["base/angularVelocity"].toDouble(-1), 0.0);
    QVERIFY(qAbs(signal["velocity"].toArray()[0].toDouble(1)) < 1e-3);
}

/// A controller that calls fail() asks for the end of the run, in any process.
void IsolatedModulesTest::failEndsTheRun() {
    for (const char* isolation : {"none", "module"}) {
        const Outcome outcome = run(experiment(isolation, "Zoo", "Action=\"fail badly\""));
        QVERIFY2(outcome.code == 4, shown(outcome));
        QCOMPARE(QJsonDocument::fromJson(outcome.out).object()["ticks"].toInt(), 49);
        QVERIFY2(outcome.err.contains("error E410: at t = 0.49 s the controller "), shown(outcome));
    }
}

void IsolatedModulesTest::isolationOfABlockHoldsForItAlone() {
    const Outcome outcome = run(experiment("none", "Zoo", "Action=segv Isolation=robot"));
    QVERIFY2(outcome.code == 4, shown(outcome));
    QCOMPARE(trace(), m_trace);
    QCOMPARE(QJsonDocument::fromJson(outcome.out).object()["stopped"].toArray().size(), 1);
    const Outcome inside = run(experiment("robot", "Zoo", "Action=segv Isolation=none"));
    QVERIFY2(inside.code == 4 && QJsonDocument::fromJson(inside.out).object().contains("crashed"), shown(inside));
}

void IsolatedModulesTest::givesTheSameStateInAnyProcess_data() {
    QTest::addColumn<QByteArray>("text");
    const QByteArray head = "#import robots/simple_robot.sim\n#import robots/amr.sim\n#import arenas/medium_arena.sim\n"
                            "#loadModule controllers/linear_motion\n#loadModule controllers/bump_and_turn\n"
                            "#loadModule controllers/random_drive\nStatic arena { Config=MediumArena }\n";
    QTest::newRow("ten robots") << head + "Grid g { Config=SimpleRobot Count=5,2 Spacing=0.7 RandomDrive b { Speed=0.5 } }\n";
    QTest::newRow("three kinds") << head + "Robot a { Config=SimpleRobot Pos=-1,0,0 RandomDrive b { } }\n"
                                           "Robot c { Config=SimpleRobot Pos=1,0,0 BumpAndTurn b { Speed=0.4 } }\n"
                                           "Robot d { Config=Amr Pos=0,1,0 LinearMotion b { Distance=1 Speed=0.3 } }\n";
    QTest::newRow("radios") << contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/sensor_network_amr.sim"));
}

void IsolatedModulesTest::givesTheSameStateInAnyProcess() {
    QFETCH(QByteArray, text);
    const QString path = m_folder.filePath("same.sim");
    QVERIFY(writeFile(path, text));
    QJsonObject first;
    for (const char* isolation : {"none", "module", "robot"}) {
        const Outcome outcome = run(path, {"--duration", isLong() ? "100" : "5", "--set", QStringLiteral("Isolation=%1").arg(isolation)});
        QVERIFY2(outcome.code == 0, shown(outcome));
        const QJsonObject json = QJsonDocument::fromJson(outcome.out).object();
        if (first.isEmpty()) first = json;
        QCOMPARE(json["state_hash"].toString(), first["state_hash"].toString());
        QCOMPARE(json["robots"], first["robots"]); // with all signals, also published ones
        const bool ends = json["finished"].isObject(); // a controller reached its target
        QVERIFY2(json["ticks"].toInt() >= (!isLong() ? 500 : ends ? 5'000 : 10'000), shown(outcome));
    }
}

void IsolatedModulesTest::aSlowUpdateIsReported() {
    for (const char* isolation : {"none", "module"}) {
        const Outcome outcome = run(experiment(isolation, "Rogue", "Budget=0.000001"));
        QVERIFY2(outcome.code == 0, shown(outcome));
        QCOMPARE(outcome.err.count("an update of the controller brain took "), 1); // once
        QVERIFY2(outcome.err.contains("bad] warning: an update of the controller brain took "), shown(outcome));
    }
}

QTEST_GUILESS_MAIN(IsolatedModulesTest)
#include "isolated_modules_test.moc"
