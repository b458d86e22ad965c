// trundle-cli: exit codes and messages for every kind of end, usage error and failed write.
#include "flow/cli.h"

namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRUNDLE_SANITIZED // the shadow memory of sanitizers exceeds any limit
#endif
#endif
#ifdef TRUNDLE_SANITIZED
const QString kMemoryLimit;
#else
const QString kMemoryLimit = QStringLiteral("ulimit -v 300000; "); // KiB of address space
#endif

} // namespace

class ExitCodesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString experiment(const char* name, const QByteArray& robot, const QByteArray& settings = "Duration = 0.1") {
        const QString path = m_folder.filePath(name);
        if (!writeFile(
                path,
                settings +
                    "\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule controllers/linear_motion\n"
                    "Static floor { Config=OpenFloor }\nRobot robot0 { Config=SimpleRobot " +
                    robot + " }\n"))
            return {};
        return path;
    }

private Q_SLOTS:
    void everyEndHasItsCode_data();
    void everyEndHasItsCode();
    void everyMisuseIsNamed_data();
    void everyMisuseIsNamed();
    void everyHelpHasExamples_data();
    void everyHelpHasExamples();
    void theVersionIsOneLine();
    void missingModuleListsSearchedFolders();
    void aModuleThatIsNotTrustedDoesNotRun();
    void aFullDiskEndsTheRunHonestly();
    void jsonIsCompleteWhenTheTextIsWrong();
    void jsonNamesTheFileThatCannotBeRead();
    void reportsCrashInModule();
    void anExitInAModuleIsNoSuccess_data();
    void anExitInAModuleIsNoSuccess();
    void reportsFullStandardOutput_data();
    void reportsFullStandardOutput();
    void limitsDiagnosticsOutput();
    void sixtyFourMebibytesOfMistakesFitIntoLittleMemory_data();
    void sixtyFourMebibytesOfMistakesFitIntoLittleMemory();
    void checkReportsRunErrors();
    void fileNamesCannotRedirectLogs();
    void checkAndRunReportMotorAlike();
};

void ExitCodesTest::everyEndHasItsCode_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("said");
    const QString good = experiment("good.sim", "");
    const QString wrong = experiment("wrong.sim", "Possition=1,2,3");
    QTest::newRow("done") << QStringList{"run", good} << 0 << QByteArray("");
    QTest::newRow("no command") << QStringList{} << 2 << QByteArray("");
    QTest::newRow("unknown command") << QStringList{"runn", good} << 2 << QByteArray("runn");
    QTest::newRow("unknown option") << QStringList{"run", good, "--fast"} << 2 << QByteArray("--fast");
    QTest::newRow("no file named") << QStringList{"run"} << 2 << QByteArray("FILE");
    QTest::newRow("no such file") << QStringList{"run", m_folder.filePath("none.sim")} << 2 << QByteArray("none.sim");
    QTest::newRow("a folder") << QStringList{"run", m_folder.path()} << 2 << QByteArray("folder");
    QTest::newRow("duration is no number") << QStringList{"run", good, "--duration", "long"} << 2 << QByteArray("duration");
    QTest::newRow("duration is negative") << QStringList{"run", good, "--duration", "-1"} << 2 << QByteArray("duration");
    QTest::newRow("duration is nan") << QStringList{"run", good, "--duration", "nan"} << 2 << QByteArray("duration");
    QTest::newRow("seed is no number") << QStringList{"run", good, "--seed", "x"} << 2 << QByteArray("seed");
    QTest::newRow("duration is empty") << QStringList{"run", good, "--duration", ""} << 2 << QByteArray("duration");
    QTest::newRow("duration has a unit") << QStringList{"run", good, "--duration", "5s"} << 2
                                         << QByteArray("a number of seconds");
    QTest::newRow("duration is beyond the setting's range")
        << QStringList{"run", good, "--duration", "1e18"} << 2 << QByteArray("from 0 to 1e9");
    QTest::newRow("seed is negative") << QStringList{"run", good, "--seed", "-1"} << 2
                                      << QByteArray("from 0 to 9007199254740992");
    QTest::newRow("seed is empty") << QStringList{"run", good, "--seed", ""} << 2 << QByteArray("seed");
    QTest::newRow("seed is too large to be exact")
        << QStringList{"run", good, "--seed", "9007199254740993"} << 2 << QByteArray("seed");
    QTest::newRow("seed is far too large") << QStringList{"run", good, "--seed", "99999999999999999999"} << 2
                                           << QByteArray("seed");
    QTest::newRow("no such module folder") << QStringList{"run", good, "--modules", m_folder.filePath("none")} << 2
                                           << QByteArray("none");
    QTest::newRow("a module folder that is a file") << QStringList{"describe", "--modules", good} << 2 << QByteArray("good.sim");
    QTest::newRow("no such import folder") << QStringList{"check", good, "-I", m_folder.filePath("none")} << 2
                                           << QByteArray("none");
    QTest::newRow("no Duration anywhere") << QStringList{"run", experiment("endless.sim", "", "")} << 2
                                          << QByteArray("give --duration S");
    QTest::newRow("errors in the text") << QStringList{"run", wrong} << 1 << QByteArray("E201");
    QTest::newRow("a --set without a value")
        << QStringList{"run", good, "--set", "Duration"} << 2 << QByteArray("give PATH=VALUE");
    QVERIFY(QFile::link("loop.sim", m_folder.filePath("loop.sim")));
    QTest::newRow("a link to itself") << QStringList{"check", m_folder.filePath("loop.sim")} << 2
                                      << QByteArray("leads back to itself");
    QTest::newRow("errors in a --set") << QStringList{"run", good, "--set", "robot0.leftMotor.Resistance=-3"} << 1
                                       << QByteArray("--set#1");
    QTest::newRow("controller cannot start")
        << QStringList{"run", experiment("port.sim", "LinearMotion brain { Drive=legs }")} << 4 << QByteArray("legs");
    QTest::newRow("blown up") << QStringList{"run", experiment("up.sim", "", "Duration = 5\nGravity = 0,0,1000")} << 3
                              << QByteArray("E501");
    QTest::newRow("check: fine") << QStringList{"check", good} << 0 << QByteArray("");
    QTest::newRow("check: errors") << QStringList{"check", good, wrong} << 1 << QByteArray("Possition");
    QTest::newRow("check: no such file") << QStringList{"check", m_folder.filePath("none.sim")} << 2 << QByteArray("none.sim");
    const QString far = experiment("far.sim", "Pos=1e5,1e5,0");
    QTest::newRow("what only the engine refuses") << QStringList{"run", far} << 1 << QByteArray("E203");
    QTest::newRow("check: what only the engine refuses") << QStringList{"check", far} << 1 << QByteArray("E203");
    QTest::newRow("print: a broken text too") << QStringList{"print", wrong} << 0 << QByteArray("");
    QTest::newRow("print: no such file") << QStringList{"print", m_folder.filePath("none.sim")} << 2 << QByteArray("none.sim");
    QTest::newRow("format: no such file") << QStringList{"format", m_folder.filePath("none.sim")} << 2 << QByteArray("none.sim");
    QTest::newRow("describe: unknown kind") << QStringList{"describe", "RotaryMoter"} << 2 << QByteArray("RotaryMotor");
}

void ExitCodesTest::everyEndHasItsCode() {
    QFETCH(QStringList, arguments);
    QFETCH(int, code);
    QFETCH(QByteArray, said);
    const Outcome outcome = cli(arguments);
    QVERIFY2(outcome.code == code, shown(outcome));
    QVERIFY2(outcome.err.contains(said), shown(outcome));
}

void ExitCodesTest::everyMisuseIsNamed_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("said");
    const QString good = experiment("good.sim", "");
    const auto row = [](const QStringList& arguments, const QByteArray& said) {
        QTest::newRow(arguments.join(' ').section('/', -1).prepend(arguments.value(0) + ": ").toUtf8().constData())
            << arguments << said;
    };
    row({}, "subcommand");
    row({"runn", good}, "did you mean run?");
    row({"\x1b[31mrun"}, "there is no command");
    row({"--fast"}, "--fast");
    row({"run"}, "FILE");
    row({"run", ""}, "");
    row({"run", m_folder.filePath("none.sim")}, "none.sim");
    row({"run", m_folder.path()}, "folder");
    row({"run", "/dev/null/x.sim"}, "x.sim");
    row({"run", good, good}, "good.sim");
    row({"run", good, "--fast"}, "--fast");
    row({"run", good, "-x"}, "-x");
    row({"run", good, "--duration"}, "--duration");
    for (const char* wrong : {"long", "-1", "nan", "inf", "1e18", "5s", "", "0x10"})
        row({"run", good, "--duration", wrong}, "duration");
    row({"run", good, "--duration", "1", "--duration", "2"}, "--duration");
    for (const char* wrong : {"x", "-1", "1.5", "", "9007199254740993"}) row({"run", good, "--seed", wrong}, "seed");
    for (const char* wrong : {"Duration", "=5", ""}) row({"run", good, "--set", wrong}, "PATH=VALUE");
    row({"run", good, "--log-dir", ""}, "--log-dir");
    row({"run", good, "--log-dir"}, "--log-dir");
    row({"run", good, "--modules", m_folder.filePath("none")}, "none");
    row({"run", good, "--modules", good}, "good.sim");
    row({"run", good, "-I", m_folder.filePath("none")}, "none");
    row({"run", good, "--movie", "my.avi"}, ".mp4");
    row({"run", good, "--fps", "30"}, "--movie");
    row({"run", good, "--movie", "m.mp4", "--fps", "0"}, "--fps");
    row({"run", good, "--movie", "m.mp4", "--view", "a", "--camera", "b"}, "--view");
    row({"run", good, "--movie", "m.mp4", "--size", "0x720"}, "size");
    row({"run", good, "--look", "pretty"}, "--look");
    row({"run", good, "--quiet=perhaps"}, "quiet");
    row({"check"}, "FILE");
    row({"check", m_folder.filePath("none.sim")}, "none.sim");
    row({"check", good, "--set", "x"}, "PATH=VALUE");
    row({"print"}, "FILE");
    row({"print", m_folder.filePath("none.sim")}, "none.sim");
    row({"format"}, "FILE");
    row({"format", good, "--check", "--write"}, "--check");
    row({"format", m_folder.filePath("none.sim"), "--write"}, "none.sim");
    row({"edit", good}, "--set");
    row({"edit", "--set", "Duration=2"}, "FILE");
    row({"edit", m_folder.filePath("none.sim"), "--set", "Duration=2", "--write"}, "none.sim");
    row({"render", good}, "--output");
    row({"render", good, "-o", "out.png", "--at", "-1"}, "--at");
    row({"render", good, "-o", "out.png", "--target", "0,0,0"}, "--eye");
    row({"render", good, "-o", "out.png", "--eye", "1,2"}, "--eye");
    row({"render", m_folder.filePath("none.sim"), "-o", "out.png"}, "none.sim");
    row({"describe", "RotaryMoter"}, "did you mean RotaryMotor?");
    row({"describe", ""}, "name");
    row({"describe", "Box", "Sphere"}, "Sphere");
    row({"describe", "--output", "x.json"}, "--module");
    row({"describe", "--modules", m_folder.filePath("none")}, "none");
}

/// --json is accepted at any position; nothing is written.
void ExitCodesTest::everyMisuseIsNamed() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, said);
    QTemporaryDir here;
    const Outcome plain = callProgram(programPath(), arguments, here.path());
    QVERIFY2(plain.code == 2, shown(plain));
    QVERIFY2(plain.err.startsWith("trundle-cli: ") && plain.err.contains(said), shown(plain));
    QVERIFY2(plain.out.isEmpty() && !plain.err.contains('\x1b') && !plain.err.contains("runn --help"), shown(plain));
    for (const qsizetype place : {qsizetype(0), qsizetype(1), arguments.size()}) {
        if (place > arguments.size()) continue;
        const Outcome json =
            callProgram(programPath(), arguments.mid(0, place) + QStringList("--json") + arguments.mid(place), here.path());
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(json.out, &error);
        QVERIFY2(json.code == 2 && error.error == QJsonParseError::NoError, shown(json));
        const QJsonArray list = document.isArray() ? document.array() : document.object()["diagnostics"].toArray();
        QVERIFY2(list.size() == 1 && !list[0].toObject()["message"].toString().isEmpty(), shown(json));
        const bool known = place > 0; // false: the command is at the wrong position
        if (known && arguments.value(0) == "run") QVERIFY2(document.object().contains("ticks"), shown(json));
        QCOMPARE(document.isArray(), known && arguments.value(0) == "check");
    }
    QCOMPARE(QDir(here.path()).entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden), QStringList());
}

void ExitCodesTest::everyHelpHasExamples_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("program") << QStringList{"--help"};
    for (const char* command : {"run", "check", "print", "format", "edit", "describe"})
        QTest::newRow(command) << QStringList{command, "--help"};
}

void ExitCodesTest::everyHelpHasExamples() {
    QFETCH(QStringList, arguments);
    const Outcome help = cli(arguments);
    QVERIFY2(help.code == 0, shown(help));
    QVERIFY2(help.out.contains("Example") && help.out.contains("  trundle-cli "), shown(help));
}

void ExitCodesTest::theVersionIsOneLine() {
    const Outcome version = cli({"--version"});
    QCOMPARE(version.code, 0);
    QVERIFY2(QRegularExpression("^trundle-cli [0-9.]+ \\(SDK [0-9.]+\\)\n$").match(version.out).hasMatch(), shown(version));
}

void ExitCodesTest::missingModuleListsSearchedFolders() {
    // The same program in a folder without lib/trundle beside it.
    QVERIFY(QDir(m_folder.path()).mkpath("elsewhere/bin"));
    const QString program = m_folder.filePath("elsewhere/bin/trundle-cli");
    QVERIFY(QFile::copy(programPath(), program));
    const Outcome run =
        callProgram(program, {"run", configPath("experiments/linear_motion.sim"), "--log-dir", m_folder.filePath("logs")});
    QVERIFY2(run.code == 1, shown(run));
    QVERIFY2(run.err.contains("E401"), shown(run));
    QVERIFY2(run.err.contains("liblinear_motion.so"), shown(run));
    QVERIFY2(run.err.contains("linear_motion.sim:5:"), shown(run)); // the #loadModule line
    const Outcome found =
        callProgram(program, {"run", configPath("experiments/linear_motion.sim"), "--log-dir", m_folder.filePath("logs"),
                              "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle")});
    QVERIFY2(found.code == 0, shown(found));
}

void ExitCodesTest::aModuleThatIsNotTrustedDoesNotRun() {
    const QString library = QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle/controllers/liblinear_motion.so");
    for (const char* ending : {"", ".kinds.json"})
        QVERIFY(QFile::copy(library + ending, m_folder.filePath("libmine.so") + ending));
    QVERIFY(writeFile(m_folder.filePath("mine.sim"),
                      "Duration = 0.1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule mine\n"
                      "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot LinearMotion brain { } }\n"));
    const Outcome refused = cli({"run", m_folder.filePath("mine.sim")});
    QVERIFY2(refused.code == 1, shown(refused));
    QVERIFY2(refused.err.contains("--trust"), shown(refused));
    const Outcome trusted = cli({"run", m_folder.filePath("mine.sim"), "--trust"});
    QVERIFY2(trusted.code == 0, shown(trusted));
    const Outcome named = cli({"run", m_folder.filePath("mine.sim"), "--modules", m_folder.path()});
    QVERIFY2(named.code == 0, shown(named));
}

void ExitCodesTest::aFullDiskEndsTheRunHonestly() {
    const QString path = experiment("much.sim", "", "Duration = 60\nSignalLog all { Signals=\"*\" }");
    // A shell with a file size limit of 100 blocks stands in for a full disk.
    const Outcome run = callProgram("/bin/sh", {"-c", "ulimit -f 100; exec \"$0\" run \"$1\" --json", programPath(), path});
    QVERIFY2(run.code == 1, shown(run));
    QVERIFY2(run.err.contains("E503") && run.err.contains("all.csv"), shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QVERIFY(json["ticks"].toInt() > 0 && json["ticks"].toInt() < 6000);
    QCOMPARE(json["diagnostics"].toArray().last().toObject()["code"].toString(), QString("E503"));
}

void ExitCodesTest::jsonIsCompleteWhenTheTextIsWrong() {
    const Outcome run = cli({"run", experiment("wrong2.sim", "Possition=1,2,3"), "--json"});
    QCOMPARE(run.code, 1);
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QCOMPARE(json["ticks"].toInt(-1), 0);
    const QJsonObject diagnostic = json["diagnostics"].toArray().first().toObject();
    QCOMPARE(diagnostic["severity"].toString(), QString("error"));
    QCOMPARE(diagnostic["line"].toInt(), 6);
    QCOMPARE(diagnostic["suggestions"].toArray().first().toString(), QString("Pos"));
}

void ExitCodesTest::jsonNamesTheFileThatCannotBeRead() {
    const QString none = m_folder.filePath("none.sim");
    const Outcome run = cli({"run", none, "--json"});
    QCOMPARE(run.code, 2);
    QCOMPARE(QJsonDocument::fromJson(run.out).object()["diagnostics"].toArray().first().toObject()["file"].toString(), none);
}

void ExitCodesTest::reportsCrashInModule() {
    const QString path = m_folder.filePath("crash.sim");
    QVERIFY(writeFile(path, "Duration = 1\n#import robots/simple_robot.sim\n#loadModule exits\nRobot r { Config=SimpleRobot "
                            "Exits brain { Recurse=true } }\n"));
    const Outcome run = cli({"run", path, "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules")});
    const bool sanitizer = run.err.contains("Sanitizer"); // the sanitizer handles the signal first and exits with its own code
    QVERIFY2(sanitizer || run.err.contains("the controller Exits of r "), shown(run));
    if (!sanitizer) QCOMPARE(run.code, 4);
}

void ExitCodesTest::anExitInAModuleIsNoSuccess_data() {
    QTest::addColumn<QByteArray>("early");
    QTest::newRow("in update") << QByteArray("false");
    QTest::newRow("in setup") << QByteArray("true");
}

void ExitCodesTest::anExitInAModuleIsNoSuccess() {
    QFETCH(QByteArray, early);
    const QString path = m_folder.filePath("exits.sim");
    QVERIFY(writeFile(
        path,
        "Duration = 1\n#import robots/simple_robot.sim\n#loadModule exits\nRobot r { Config=SimpleRobot Exits brain { Early=" +
            early + " } }\n"));
    const Outcome run = cli({"run", path, "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules")});
    QVERIFY2(run.code == 4, shown(run));
    QVERIFY2(run.err.contains("ended the program"), shown(run));
}

void ExitCodesTest::reportsFullStandardOutput_data() {
    QTest::addColumn<QString>("command");
    const QString good = experiment("full.sim", "");
    for (const char* command :
         {"run '%1'", "run '%1' --json", "check '%1' --json", "print '%1'", "format '%1'", "describe", "describe Box --json"})
        QTest::newRow(command) << QString(command).replace("%1", good);
}

void ExitCodesTest::reportsFullStandardOutput() {
    QFETCH(QString, command);
    const Outcome outcome = callProgram("/bin/sh", {"-c", "'" + programPath() + "' " + command + " > /dev/full"});
    QVERIFY2(outcome.code == 1, shown(outcome));
    QVERIFY2(outcome.err.contains("standard output"), shown(outcome));
}

void ExitCodesTest::limitsDiagnosticsOutput() {
    const QString path = m_folder.filePath("many.sim");
    QByteArray text;
    for (int i = 0; i < 1000; ++i) text += "Nonsense" + QByteArray::number(i) + " = 1\n";
    QVERIFY(writeFile(path, text));
    const Outcome check = cli({"check", path});
    QVERIFY2(check.code == 1, shown(check));
    QCOMPARE(check.err.count("error E201"), 100);
    QVERIFY2(check.err.endsWith("... and 900 more messages\n"), shown(check));
    QVERIFY2(check.out.contains("1000 errors"), shown(check));
    QCOMPARE(QJsonDocument::fromJson(cli({"check", path, "--json"}).out).array().size(), 1000);
}

void ExitCodesTest::sixtyFourMebibytesOfMistakesFitIntoLittleMemory_data() {
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<QByteArray>("piece");
    QTest::newRow("unknown settings") << QByteArray() << QByteArray("a=1\n");
    QTest::newRow("unknown blocks") << QByteArray() << QByteArray("Foo x { A=1 }\n");
    QTest::newRow("no values") << QByteArray() << QByteArray("a=\n");
    QTest::newRow("braces") << QByteArray() << QByteArray("{");
    QTest::newRow("one line") << QByteArray("Tick=") << QByteArray("1,");
    QTest::newRow("one name") << QByteArray("Robot ") << QByteArray("a");
    QTest::newRow("bytes") << QByteArray() << QByteArray("\x01\xfe{\xff=");
    QTest::newRow("blank lines") << QByteArray("Foo { }\n") << QByteArray("\n");
    QTest::newRow("lines of blanks") << QByteArray("Foo { }\n") << QByteArray("  \r\n");
}

/// The text itself takes 64 MiB; the program with its libraries takes another 100 MiB.
void ExitCodesTest::sixtyFourMebibytesOfMistakesFitIntoLittleMemory() {
    QFETCH(QByteArray, head);
    QFETCH(QByteArray, piece);
    const QString path = m_folder.filePath("large.sim");
    QVERIFY(writeFile(path, head + piece.repeated(((64 << 20) - 100) / int(piece.size()))));
    const Outcome check =
        callProgram("/bin/sh", {"-c", kMemoryLimit + QStringLiteral("exec \"$0\" check \"$1\" --json"), programPath(), path});
    QVERIFY2(check.code == 1, shown({check.code, check.out.left(2000), check.err.left(2000)}));
    const QJsonArray messages = QJsonDocument::fromJson(check.out).array();
    QVERIFY2(!messages.isEmpty() && messages.size() <= 2002, check.out.left(2000));
    QVERIFY(check.out.size() < 4'000'000);
    QFile::remove(path);
}

void ExitCodesTest::checkReportsRunErrors() {
    const auto text = [this](const char* name, const QByteArray& robot) {
        const QString path = m_folder.filePath(name);
        (void)writeFile(path, "Duration = 0.1\n#import arenas/open_floor.sim\n#loadModule controllers/linear_motion\n"
                              "Static floor { Config=OpenFloor }\n"
                              "RobotConfig Crate { Body b { Box g { Size=0.2,0.2,0.2 Mass=1 } } }\n" +
                                  robot);
        return path;
    };
    // A port that the robot does not have is reported before the run starts.
    const QString lacking = text("lacking.sim", "Robot r { Config=Crate Pos=0,0,0.1 LinearMotion brain { } }\n");
    const Outcome refused = cli({"check", lacking});
    QVERIFY2(refused.code == 1 && refused.err.contains("E411"), shown(refused));
    QCOMPARE(cli({"run", lacking}).code, 4);
    // A robot that starts inside the floor is reported as a warning with a fix, in all three formats; it does not prevent a run.
    const QString deep = text("deep.sim", "Robot r { Config=Crate Pos=0,0,0.03 }\n");
    const Outcome warned = cli({"check", deep});
    QVERIFY2(warned.code == 0 && warned.err.contains("warning E325") && warned.err.contains("fix: Pos=0,0,0.1"), shown(warned));
    const QJsonArray messages = QJsonDocument::fromJson(cli({"check", deep, "--json"}).out).array();
    QVERIFY(std::any_of(messages.begin(), messages.end(), [](const QJsonValue& m) {
        return m["code"].toString() == "E325" && m["fixes"].toArray().size() == 1 && m["line"].toInt() == 6;
    }));
    const Outcome ran = cli({"run", deep, "--quiet"});
    QVERIFY2(ran.code == 0 && ran.err.contains("warning E325"), shown(ran));
    // A robot that starts above the floor is reported as a hint, in a run too, once each.
    const QString high = text("high.sim", "Robot r { Config=Crate Pos=0,0,2 }\n"
                                          "Grid g { Config=Crate Count=20,20 Spacing=1 Pos=9,9,3 }\n");
    const Outcome fell = cli({"run", high, "--json"});
    QVERIFY2(fell.code == 0 && fell.err.count("hint E327") == cli({"check", high}).err.count("hint E327"), shown(fell));
    const QJsonArray said = QJsonDocument::fromJson(fell.out)["diagnostics"].toArray();
    QCOMPARE(std::count_if(said.begin(), said.end(), [](const QJsonValue& m) { return m["code"].toString() == "E327"; }),
             fell.err.count("hint E327"));
    QVERIFY(fell.err.contains("hint E327"));
}

/// The diagnostic has the same source range and the same fix from check and from run.
void ExitCodesTest::checkAndRunReportMotorAlike() {
    const QString path = m_folder.filePath("one_motor.sim");
    writeFile(path, "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nDuration = 0.1\n"
                    "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot base.RightMotor=leftMotor }\n");
    const Outcome checked = cli({"check", path}), ran = cli({"run", path, "--json"});
    QVERIFY2(checked.code == 1 && checked.err.contains("one_motor.sim:5:"), shown(checked));
    QCOMPARE(checked.err.count("same motor"), 1);
    QVERIFY2(checked.err.contains("fix: rightMotor"), shown(checked));
    const qsizetype last = ran.err.trimmed().lastIndexOf('\n');
    QCOMPARE(ran.err.left(last + 1), checked.err);
    QVERIFY2(ran.err.mid(last).contains("not run"), shown(ran));
    QVERIFY2(ran.code == 4 || ran.code == 1, shown(ran));
    const QJsonArray said = QJsonDocument::fromJson(ran.out)["diagnostics"].toArray();
    QCOMPARE(said.size(), 1);
    QCOMPARE(said[0]["line"].toInt(), 5);
}

void ExitCodesTest::fileNamesCannotRedirectLogs() {
    QVERIFY(QDir(m_folder.path()).mkpath("dots"));
    const QString folder = m_folder.filePath("dots/");
    for (const char* name : {"...", "..sim"}) {
        QVERIFY(QFile::copy(experiment("log.sim", "", "Duration = 0.1\nPoseLog path { }"), folder + name));
        const Outcome run = cli({"run", folder + name});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(QFile::exists(folder + "logs/experiment/path.csv"), shown(run));
        QVERIFY(!QFile::exists(folder + "path.csv") && !QFile::exists(folder + "logs/path.csv"));
    }
}

QTEST_GUILESS_MAIN(ExitCodesTest)
#include "exit_codes_test.moc"
