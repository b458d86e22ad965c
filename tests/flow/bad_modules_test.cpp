// Faults in a module's code, and what `run` guarantees then: it ends, with the right exit code, a message that names robot and
// module, complete logs and the --json object.
#include <csignal>
#include <future>
#include <set>

#include "flow/cli.h"

namespace {

constexpr int kTicks = 100, kAt = 50;
constexpr int kRowsWhole = 1 + 1 + kTicks, kRowsCut = 1 + kAt; // a header, the start, one row per tick

} // namespace

class BadModulesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QByteArray m_hash; ///< of a run without faults
    QStringList m_keys; ///< of its results

    QString experiment(const QByteArray& controller, const QByteArray& device, const QByteArray& settings = {}) {
        const QString path = m_folder.filePath("zoo.sim");
        const bool written = writeFile(
            path, "Duration = 1\n" + settings +
                      "\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule controllers/linear_motion\n"
                      "#loadModule zoo\nStatic floor { Config=OpenFloor }\n"
                      "RobotConfig Cart { Body hull { Box box { Size=0.2,0.2,0.1 Pos=0,0,0.06 Mass=1 Surface=plastic } }\n"
                      "  ZooDevice thing { " +
                      device +
                      " } }\n"
                      "Robot good { Config=SimpleRobot LinearMotion brain { } }\n"
                      "Robot bad { Config=SimpleRobot Pos=0,2,0 Zoo brain { " +
                      controller + " } }\nRobot cart { Config=Cart Pos=0,-2,0 }\nPoseLog path { Robot=good }\n");
        return written ? path : QString();
    }
    QStringList arguments(const QString& path) const {
        return {"run",       path,
                "--json",    "--quiet",
                "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo"),
                "--log-dir", m_folder.filePath("logs")};
    }
    /// In a folder of its own, and without core files.
    Outcome runZoo(const QString& path, const QStringList& environment = {}, const QString& shell = {}) {
        QStringList words{"ASAN_OPTIONS=" + kOwnHandlers, "TSAN_OPTIONS=" + kOwnHandlers, "UBSAN_OPTIONS=" + kOwnHandlers};
        words += environment;
        if (!shell.isEmpty()) words += {"/bin/sh", "-c", shell};
        words += programPath();
        return callProgram("/usr/bin/env", words + arguments(path), m_folder.path(), 60);
    }
    /// Sends the signal once the module reports that it loops. Returns the outcome of the process.
    Outcome interruptZoo(const QString& path, int signal, const QStringList& environment = {}) {
        const QString pid = m_folder.filePath("pid"), err = m_folder.filePath("err");
        QFile::remove(pid);
        QFile::remove(err);
        auto running = std::async(std::launch::async, [&] {
            return runZoo(path, environment, "echo $$ > '" + pid + "'; exec \"$0\" \"$@\" 2> '" + err + "'");
        });
        const auto begins = [&] { return contentOf(err).contains("zoo: begun") && !ignores(contentOf(pid).trimmed(), signal); };
        const bool begun = QTest::qWaitFor(begins, 60'000);
        ::kill(contentOf(pid).trimmed().toInt(), begun ? signal : SIGKILL);
        Outcome outcome = running.get();
        outcome.err = contentOf(err);
        return outcome;
    }
    /// True if a module has set the signal to be ignored and the program has not restored its handler yet.
    static bool ignores(const QByteArray& pid, int signal) {
        const QByteArray status = contentOf("/proc/" + pid + "/status");
        const qsizetype at = status.indexOf("SigIgn:\t");
        return at >= 0 && (status.mid(at + 8, 16).toULongLong(nullptr, 16) >> (signal - 1) & 1) != 0;
    }
    int rows() const { return static_cast<int>(contentOf(m_folder.filePath("logs/path.csv")).count('\n')); }

private Q_SLOTS:
    void initTestCase();
    void reportsEveryModuleFault_data();
    void reportsEveryModuleFault();
    void aWriteThroughAllMemoryIsReported();
    void oneSignalEndsWhatLoops_data();
    void oneSignalEndsWhatLoops();
    void aLongStepOfTheSolverEndsWithWordsOfItsCluster();
    void reportsFaultsOnLoadAndUnload_data();
    void reportsFaultsOnLoadAndUnload();
    void describingWhatLoopsEndsWithASignal();
    void reportsCrashWhileDescribing_data();
    void reportsCrashWhileDescribing();
    void closedDescriptorsCorruptNoFile_data();
    void closedDescriptorsCorruptNoFile();
    void aKilledRunLosesASecondAtMost();
    void aRunForAPictureEndsLikeAnyOther();
};

void BadModulesTest::initTestCase() {
    const Outcome run = runZoo(experiment({}, {}));
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    m_keys = json.keys();
    m_hash = json["state_hash"].toString().toLatin1();
    QCOMPARE(m_hash.size(), 16);
    QCOMPARE(rows(), kRowsWhole);
}

void BadModulesTest::reportsEveryModuleFault_data() {
    QTest::addColumn<QByteArray>("controller");
    QTest::addColumn<QByteArray>("device");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("said");  ///< expected in the message
    QTest::addColumn<QByteArray>("robot"); ///< in "crashed"; "": absent, "?": unknown
    QTest::addColumn<int>("rows");
    const QByteArray brain = "the controller Zoo of bad ", thing = "the device ZooDevice cart/thing ";
    std::set<QByteArray> inputs; // each row is another case
    const auto row = [&](const char* name, const QByteArray& controller, const QByteArray& device, int code,
                         const QByteArray& said, const QByteArray& robot, int rows) {
        QVERIFY2(inputs.insert(controller + '|' + device).second, name);
        QTest::newRow(name) << controller << device << code << said << robot << rows;
    };
    const auto action = [](const QByteArray& name, const QByteArray& phase = "update") {
        return "Action=\"" + name + "\" Phase=" + phase;
    };
    // A crash ends the run.
    const auto crash = [&](const char* name, const QByteArray& why) {
        row(name, action(name), {}, 4, "crashed in update at t = 0.49 s: " + why, "bad", kRowsCut);
    };
    crash("segv", "Segmentation fault");
    crash("jump", "Segmentation fault");
    crash("divide", "Arithmetic exception");
    crash("trap", "Illegal instruction");
    crash("bus", "Bus error");
    crash("abort", "Aborted");
    crash("overflow", "Segmentation fault");
    crash("double free", "Aborted");
    crash("terminate", "Aborted");
    crash("throw past noexcept", "Aborted");
    crash("leave thread", "Aborted");
    crash("trapped division", "Arithmetic exception");
    for (const char* exit : {"exit", "_exit", "_Exit", "quick_exit"})
        row(exit, action(exit), {}, 4,
            brain + "(" + TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so) ended the program in update", "bad", kRowsCut);
    const QByteArray thread = "a thread of the module " TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so";
    for (const char* name : {"thread crashes", "thread throws", "thread aborts", "thread jumps", "thread of a thread crashes",
                             "thread overflows", "thread overflows in the C library", "standard thread overflows",
                             "library code crashes in a thread", "bare thread crashes", "bare thread overflows"})
        row(name, action(name), {}, 4, ", in " + thread + "\n", "?", kRowsCut);
    for (const char* name : {"thread exits", "thread _exits", "thread quick_exits"})
        row(name, action(name), {}, 4,
            thread + " ended the program in the middle of the run at t = 0.49 s, by exit() or the like", "?", kRowsCut);
    row("segv in setup", action("segv", "setup"), {}, 4, brain, "bad", 0);
    row("exit in setup", action("exit", "setup"), {}, 4, brain, "bad", 0);
    row("segv in a destructor", action("segv", "destructor"), {}, 4, "crashed in destructor", "bad", kRowsWhole);
    row("exit in a destructor", action("exit", "destructor"), {}, 4, "ended the program in destructor", "bad", kRowsWhole);
    row("a device: segv in setup", {}, action("segv", "setup"), 4, thing, "cart", 0);
    row("a device: segv in act", {}, action("segv", "act"), 4, "crashed in act at t = 0.49 s", "cart", kRowsCut);
    row("a device: abort in sense", {}, action("abort", "sense"), 4, "crashed in sense", "cart", kRowsCut);
    row("a device: segv in a destructor", {}, action("segv", "destructor"), 4, "crashed in destructor", "", kRowsWhole);
    row("a device: throw in act", {}, action("throw", "act"), 4, "cart/thing", "", kRowsCut);
    // An exception stops the controller, and the run with it.
    for (const char* thrown : {"throw", "throw int", "throw other", "throw much", "allocate"})
        row(thrown, action(thrown), {}, 4, "E410", "", kRowsCut);
    // Names without a terminating zero byte are rejected.
    for (const char* name : {"unended port", "filled port", "port from nowhere", "unended signal", "unended publish"})
        row(name, action(name, "setup"), {}, 4, "a name without a terminating zero byte", "", 0);
    row("unended has", action("unended has", "setup"), {}, 0, {}, "", kRowsWhole);
    for (const char* name : {"unended signal", "filled signal"})
        row((QByteArray("a device: ") + name).constData(), {}, action(name, "setup"), 4, "a name without a terminating zero byte",
            "", 0);
    row("a device: unended field", {}, action("unended field", "setup"), 0, {}, "", kRowsWhole);
    row("fail badly", action("fail badly"), {}, 4, "E410", "", kRowsCut);
    // All other faults have no effect on the run.
    const auto harmless = [&](const char* name, const QByteArray& said = {}) {
        row(name, action(name), {}, 0, said, "", kRowsWhole);
    };
    for (const char* phase : {"setup", "update", "destructor"})
        for (const char* mode : {"round up", "round down", "round to zero", "flush denormals", "trap floats"})
            row((QByteArray(mode) + " in " + phase).constData(), action(mode, phase), {}, 0, {}, "", kRowsWhole);
    for (const char* phase : {"setup", "act", "sense"})
        row((QByteArray("a device: round up in ") + phase).constData(), {}, action("round up", phase), 0, {}, "", kRowsWhole);
    harmless("replace standard");
    harmless("close standard");
    harmless("flood", "write");
    harmless("ignore signals");
    harmless("handle signals");
    harmless("block signals");
    harmless("change folder");
    row("change folder in setup", action("change folder", "setup"), {}, 0, {}, "", kRowsWhole);
    harmless("set locale");
    harmless("umask");
    row("umask in setup", action("umask", "setup"), {}, 0, {}, "", kRowsWhole);
    harmless("fork without leave");
    harmless("fork", "a copy of the program that code of a module made by fork() was ended");
    harmless("break pipe");
    harmless("command nan");
    harmless("command infinity");
    harmless("print badly", "ok");
    harmless("print much", "E506");
    harmless("print long");
    harmless("log badly", "cannot be called");
    row("write outputs", action("write outputs"), {}, 0, {}, "", kRowsWhole);
    harmless("bare thread ends");
    const QByteArray copy = "a copy of the program that code of a module made by fork() was ended";
    row("fork in a destructor", action("fork", "destructor"), {}, 0, copy, "", kRowsWhole);
    row("terminate itself", action("terminate itself"), {}, 130, {}, "", kRowsCut + 1);
    row("crash after all", action("crash after all"), {}, 4, "ended after its results by a damage of memory", "", kRowsWhole);
    row("quit", action("quit"), {}, 130, "the signal SIGQUIT ended the run", "", kRowsCut + 1);
    row("user signal", action("user signal"), {}, 130, "the signal SIGUSR1 ended the run", "", kRowsCut + 1);
    row("real-time signal", action("real-time signal"), {}, 130, "ended the run", "", kRowsCut + 1);
    // Without its descriptors the program cannot report; a file that has taken their numbers is not written to.
    for (const char* name : {"close all", "replace all"}) row(name, action(name), {}, 1, "E503", "", 0);
}

void BadModulesTest::reportsEveryModuleFault() {
    QFETCH(QByteArray, controller);
    QFETCH(QByteArray, device);
    QFETCH(int, code);
    QFETCH(QByteArray, said);
    QFETCH(QByteArray, robot);
    QFETCH(int, rows);
    QDir(m_folder.filePath("logs")).removeRecursively();
    const Outcome run = runZoo(experiment(controller, device));
    QVERIFY2(run.code == code, shown(run).left(4000));
    QVERIFY2(run.err.contains(said), shown(run).left(4000));
    QVERIFY2(!run.err.contains("left its floating-point settings"), shown(run).left(4000));
    QVERIFY2(!run.err.contains('\x1b') && !run.err.contains('\x07'), shown(run).left(4000));
    if (rows > 0) QCOMPARE(this->rows(), rows);
    if (code == 1 && !controller.isEmpty()) { // standard output is closed
        QVERIFY2(run.err.contains("cannot write to standard output"), shown(run));
        return;
    }
    QJsonParseError error;
    const QJsonObject json = QJsonDocument::fromJson(run.out, &error).object();
    QVERIFY2(error.error == QJsonParseError::NoError, shown(run).left(4000));
    QCOMPARE(json.contains("crashed"), !robot.isEmpty());
    for (const QString& key : m_keys) QVERIFY2(json.contains(key), qPrintable(key));
    if (!robot.isEmpty() && rows > 0 && rows < kRowsWhole) { // the positions are at most a second old
        const QJsonObject robots = json["robots"].toObject();
        QVERIFY2(robots.keys() == (QStringList{"bad", "cart", "good"}) && robots["bad"]["pos"].toArray().size() == 3, shown(run));
        QVERIFY2(json["robots_time_s"].isDouble() && qAbs(robots["cart"]["pos"][1].toDouble() + 2) < 0.1, shown(run));
    }
    if (robot == "?") {
        QVERIFY(json["crashed"].toObject()["robot"].isNull());
        QCOMPARE(json["crashed"].toObject()["during"].toString(), QStringLiteral("thread"));
        QVERIFY2(json["crashed"].toObject()["module"].toString().endsWith("/libzoo.so"), shown(run));
    } else if (!robot.isEmpty()) {
        QCOMPARE(json["crashed"].toObject()["robot"].toString().toLatin1(), robot);
        QVERIFY2(json["crashed"].toObject()["module"].toString().endsWith("/libzoo.so"), shown(run));
    }
    if (code == 0) QCOMPARE(json["state_hash"].toString().toLatin1(), m_hash);
    else QVERIFY2(code == 130 || !json["diagnostics"].toArray().isEmpty() || rows == kRowsWhole, shown(run).left(4000));
}

/// Whatever it has overwritten, also what the report and the logs need.
void BadModulesTest::aWriteThroughAllMemoryIsReported() {
    for (const char* phase : {"setup", "update", "destructor"}) {
        const Outcome run = runZoo(experiment(QByteArray("Action=overrun Phase=") + phase, {}));
        QVERIFY2(run.code == 4 && run.err.contains("crashed"), shown(run).left(4000));
        const QJsonObject json = QJsonDocument::fromJson(run.out).object();
        for (const QString& key : m_keys) QVERIFY2(json.contains(key), shown(run).left(4000));
        QCOMPARE(json["crashed"].toObject()["reason"].toString(), QStringLiteral("Segmentation fault"));
    }
}

void BadModulesTest::oneSignalEndsWhatLoops_data() {
    QTest::addColumn<QByteArray>("controller");
    QTest::addColumn<QByteArray>("device");
    QTest::addColumn<int>("signal");
    QTest::addColumn<QByteArray>("said");
    QTest::addColumn<int>("rows");
    const QByteArray brain = "the controller Zoo of bad (", thing = "the device ZooDevice cart/thing (";
    QTest::newRow("update") << QByteArray("Action=loop") << QByteArray() << SIGTERM << brain << kRowsCut;
    QTest::newRow("update, hung up") << QByteArray("Action=loop") << QByteArray() << SIGHUP << brain << kRowsCut;
    QTest::newRow("setup") << QByteArray("Action=loop Phase=setup") << QByteArray() << SIGINT << brain << 0;
    QTest::newRow("destructor") << QByteArray("Action=loop Phase=destructor") << QByteArray() << SIGTERM << brain << kRowsWhole;
    QTest::newRow("act") << QByteArray() << QByteArray("Action=loop Phase=act") << SIGTERM << thing << kRowsCut;
    QTest::newRow("with signals ignored") << QByteArray("Action=\"ignore and loop\"") << QByteArray() << SIGTERM << brain
                                          << kRowsCut;
    QTest::newRow("with signals blocked") << QByteArray("Action=\"block and loop\"") << QByteArray() << SIGTERM << brain
                                          << kRowsCut;
}

void BadModulesTest::oneSignalEndsWhatLoops() {
    QFETCH(QByteArray, controller);
    QFETCH(QByteArray, device);
    QFETCH(int, signal);
    QFETCH(QByteArray, said);
    QFETCH(int, rows);
    QDir(m_folder.filePath("logs")).removeRecursively();
    const QString path = experiment(controller, device);
    const Outcome run = interruptZoo(path, signal);
    QVERIFY2(run.code == 4, shown(run));
    QVERIFY2(run.err.contains(said) && run.err.contains("is not responding"), shown(run));
    QVERIFY2(run.err.contains("did not return within 3 s of the request to end"), shown(run));
    if (rows > 0) QCOMPARE(this->rows(), rows);
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QVERIFY2(json["interrupted"].toBool() || rows == kRowsWhole, shown(run));
    QVERIFY2(json["not_responding"].toObject()["module"].toString().endsWith("/libzoo.so"), shown(run));
}

void BadModulesTest::aLongStepOfTheSolverEndsWithWordsOfItsCluster() {
    const QString path = experiment({}, "Action=say Phase=act At=1", "Solver = exact");
    QFile file(path);
    QVERIFY(file.open(QIODevice::Append));
    file.write("RobotConfig Brick { Body body { Box box { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=1 Surface=plastic } } }\n"
               "Grid wall { Config=Brick Count=13,13 Spacing=0.1995 Pos=5,5,0 }\n");
    file.close();
    const Outcome run = interruptZoo(path, SIGTERM);
    QVERIFY2(run.code == 130, shown(run));
    QVERIFY2(run.err.contains("one step of the solver at t = 0 s did not end within 3 s") &&
                 run.err.contains("contacts hang together") && run.err.contains("wall_"),
             shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QVERIFY2(json["interrupted"].toBool(), shown(run));
    const QJsonObject where = json["not_responding"].toObject();
    QVERIFY2(where["during"] == "solver" && where["contacts"].toInt() > 500 && where["body"].toString().startsWith("wall_"),
             shown(run));
    QCOMPARE(rows(), 2); // the log contains the start
}

void BadModulesTest::reportsFaultsOnLoadAndUnload_data() {
    QTest::addColumn<QString>("environment");
    QTest::addColumn<int>("signal"); ///< 0: it ends without a signal
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("crash when loaded") << "TRUNDLE_ZOO_LOAD=segv" << 0 << 4 << QByteArray("crashed while it was loaded");
    QTest::newRow("crash in describe") << "TRUNDLE_ZOO_DESCRIBE=abort" << 0 << 4 << QByteArray("crashed while it was loaded");
    QTest::newRow("exit when loaded") << "TRUNDLE_ZOO_LOAD=exit" << 0 << 4 << QByteArray("ended the program while it was loaded");
    QTest::newRow("loop when loaded") << "TRUNDLE_ZOO_LOAD=loop" << SIGTERM << 4
                                      << QByteArray("is not responding while it was loaded");
    QTest::newRow("crash when unloaded") << "TRUNDLE_ZOO_UNLOAD=segv" << 0 << 4 << QByteArray("crashed while it was unloaded");
    QTest::newRow("loop when unloaded") << "TRUNDLE_ZOO_UNLOAD=loop" << SIGHUP << 4
                                        << QByteArray("is not responding while it was unloaded");
    QTest::newRow("rounding when loaded") << "TRUNDLE_ZOO_LOAD=round up" << 0 << 0 << QByteArray();
    QTest::newRow("a library built with -ffast-math") << "TRUNDLE_ZOO_LOAD=flush denormals" << 0 << 0 << QByteArray();
    QTest::newRow("print when loaded") << "TRUNDLE_ZOO_LOAD=flood" << 0 << 0 << QByteArray("printf");
}

void BadModulesTest::reportsFaultsOnLoadAndUnload() {
    QFETCH(QString, environment);
    QFETCH(int, signal);
    QFETCH(int, code);
    QFETCH(QByteArray, said);
    const QString path = experiment({}, {});
    const Outcome run = signal ? interruptZoo(path, signal, {environment}) : runZoo(path, {environment});
    QVERIFY2(run.code == code, shown(run).left(4000));
    QVERIFY2(run.err.contains(said), shown(run).left(4000));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QVERIFY2(!json.isEmpty(), shown(run).left(4000));
    const bool whole = code == 0 || environment.contains("UNLOAD");
    if (whole) QCOMPARE(json["state_hash"].toString().toLatin1(), m_hash);
    else QVERIFY2(json[signal ? "not_responding" : "crashed"].toObject()["module"].toString().endsWith("/libzoo.so"), shown(run));
}

void BadModulesTest::describingWhatLoopsEndsWithASignal() {
    const QString library = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so"),
                  err = m_folder.filePath("describe.err"), pid = m_folder.filePath("describe.pid"),
                  out = m_folder.filePath("describe.json");
    QFile::remove(err);
    auto running = std::async(std::launch::async, [&] {
        return callProgram("/usr/bin/env", {"ASAN_OPTIONS=" + kOwnHandlers, "TRUNDLE_ZOO_DESCRIBE=loop", "/bin/sh", "-c",
                                            "echo $$ > '" + pid + "'; exec \"$0\" \"$@\" 2> '" + err + "'", programPath(),
                                            "describe", "--module", library, "--output", out});
    });
    const bool begun = QTest::qWaitFor([&] { return contentOf(err).contains("zoo: begun"); }, 60'000);
    ::kill(contentOf(pid).trimmed().toInt(), begun ? SIGTERM : SIGKILL);
    const Outcome run = running.get();
    const QByteArray said = contentOf(err);
    QVERIFY2(run.code == 130, said); // no data can be lost, so there is no timeout
    QVERIFY2(said.contains("trundle-cli: interrupted: ended at once, while waiting for the module " + library.toUtf8() + "\n"),
             said);
    QVERIFY(!QFile::exists(out));
}

void BadModulesTest::reportsCrashWhileDescribing_data() {
    QTest::addColumn<QString>("environment");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("when loaded") << "TRUNDLE_ZOO_LOAD=segv"
                                 << QByteArray("crashed while it was loaded and described: Segmentation");
    QTest::newRow("in describe") << "TRUNDLE_ZOO_DESCRIBE=divide"
                                 << QByteArray("crashed while it was loaded and described: Arithmetic");
    QTest::newRow("exit") << "TRUNDLE_ZOO_LOAD=exit" << QByteArray("ended the program while it was loaded and described");
    QTest::newRow("_exit") << "TRUNDLE_ZOO_DESCRIBE=_exit" << QByteArray("ended the program while it was loaded and described");
    QTest::newRow("when unloaded") << "TRUNDLE_ZOO_UNLOAD=abort" << QByteArray("crashed while it was unloaded: Aborted");
}

void BadModulesTest::reportsCrashWhileDescribing() {
    QFETCH(QString, environment);
    QFETCH(QByteArray, said);
    const QString library = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so"),
                  out = m_folder.filePath("out.json");
    QFile::remove(out);
    const Outcome run = callProgram("/usr/bin/env", {"ASAN_OPTIONS=" + kOwnHandlers, environment, programPath(), "describe",
                                                     "--module", library, "--output", out});
    QVERIFY2(run.code == 4, shown(run));
    QVERIFY2(run.err.contains("the module " + library.toUtf8() + " ") && run.err.contains(said), shown(run));
    QCOMPARE(QFile::exists(out), environment.contains("UNLOAD")); // written before the module was unloaded
}

void BadModulesTest::closedDescriptorsCorruptNoFile_data() {
    QTest::addColumn<QString>("closing");
    QTest::addColumn<int>("code");
    QTest::newRow("standard input") << "<&-" << 0;
    QTest::newRow("standard output") << ">&-" << 1; // the JSON object cannot be written
    QTest::newRow("standard error") << "2>&-" << 0;
    QTest::newRow("all") << "<&- >&- 2>&-" << 1;
}

void BadModulesTest::closedDescriptorsCorruptNoFile() {
    QFETCH(QString, closing);
    QFETCH(int, code);
    const Outcome run = runZoo(experiment("Action=flood", {}), {}, "exec \"$0\" \"$@\" " + closing);
    QVERIFY2(run.code == code, shown(run).left(4000));
    if (code == 0) QCOMPARE(QJsonDocument::fromJson(run.out).object()["state_hash"].toString().toLatin1(), m_hash);
    QCOMPARE(rows(), kRowsWhole);
    QVERIFY(!contentOf(m_folder.filePath("logs/path.csv")).contains("printf"));
}

void BadModulesTest::aKilledRunLosesASecondAtMost() {
    QDir(m_folder.filePath("logs")).removeRecursively();
    const QString path = experiment({}, {}), pid = m_folder.filePath("pid");
    auto running = std::async(std::launch::async, [&] {
        return runZoo(path, {}, "echo $$ > '" + pid + "'; exec \"$0\" \"$@\" --realtime --duration 50");
    });
    // Far less than a buffer: these rows were flushed by the timer.
    const bool flushed = QTest::qWaitFor([&] { return rows() > 150; }, 60'000);
    ::kill(contentOf(pid).trimmed().toInt(), SIGKILL);
    (void)running.get();
    QVERIFY(flushed);
    QVERIFY(contentOf(m_folder.filePath("logs/path.csv")).size() < 32 * 1024);
}

/// A copy of the process made by fork() draws nothing; a signal is named.
void BadModulesTest::aRunForAPictureEndsLikeAnyOther() {
    const auto render = [&](const QByteArray& action) {
        const QString path = experiment("Action=\"" + action + "\"", {}), out = m_folder.filePath("out.png");
        QFile::remove(out);
        return callProgram(programPath(), {"render", path, "--at", "1", "--size", "32x24", "-o", out, "--modules",
                                           QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo")});
    };
    const Outcome forked = render("fork");
    QVERIFY2(forked.code == 0 && QFile::exists(m_folder.filePath("out.png")), shown(forked));
    QVERIFY2(forked.err.contains("a copy of the program that code of a module made by fork() was ended"), shown(forked));
    const Outcome ended = render("user signal");
    QVERIFY2(ended.code == 130 && !QFile::exists(m_folder.filePath("out.png")), shown(ended));
    QVERIFY2(ended.err.contains("the signal SIGUSR1 ended the run"), shown(ended));
}

QTEST_GUILESS_MAIN(BadModulesTest)
#include "bad_modules_test.moc"
