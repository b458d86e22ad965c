// Controllers in Python: the same numbers as in C++, their faults, their descriptions, trust.
#include "flow/cli.h"

namespace {

const QString kSick = QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/flow/python");

/// The number of the line of sick.py with this text, from 1.
int lineOf(const QByteArray& text) {
    const QList<QByteArray> lines = contentOf(kSick + "/sick.py").split('\n');
    for (int i = 0; i < lines.size(); ++i)
        if (lines[i].contains(text)) return i + 1;
    return 0;
}

QJsonObject jsonOf(const Outcome& outcome) { return QJsonDocument::fromJson(outcome.out).object(); }

} // namespace

class PythonTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder, m_copied;
    QByteArray m_trace, m_otherTrace; ///< of the sound robots beside one that does nothing bad, and of the one of another module

    QString at(const QString& name) const { return m_folder.filePath(name); }
    /// The folder of the shipped modules with Copied before the name of each controller.
    QString copiedModules() const {
        const QDir shipped(TRUNDLE_SOURCE_DIR "/plugins/python"), folder(m_copied.path());
        if (!folder.isEmpty()) return folder.path();
        static const QRegularExpression definition(QStringLiteral("class ([A-Z]\\w*)\\((?!NamedTuple)"));
        for (const QString& name : shipped.entryList({"*.py"})) {
            QString text = QString::fromUtf8(contentOf(shipped.filePath(name)));
            text.replace(definition, QStringLiteral("class Copied\\1("));
            if (!writeFile(folder.filePath(name), text.toUtf8())) return {};
        }
        return folder.path();
    }

    /// `isolation` of the robot that is bad; with "module" it shares its process with `second`, which is not logged then.
    QString experiment(const QByteArray& settings, const QByteArray& isolation = "robot") {
        const QString path = at("sick.sim");
        const bool written = writeFile(path, "Duration = 1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                             "#loadModule controllers/linear_motion\n#loadModule sick.py\n"
                                             "Static floor { Config=OpenFloor }\n"
                                             "Robot good { Config=SimpleRobot LinearMotion brain { } }\n"
                                             "Robot bad { Config=SimpleRobot Pos=0,2,0 Sick brain { Isolation=" +
                                                 isolation + " " + settings +
                                                 " } }\n"
                                                 "Robot second { Config=SimpleRobot Pos=0,-2,0 Sound brain { Isolation=none } }\n"
                                                 "PoseLog path { Robot=good }\nPoseLog other { Robot=" +
                                                 (isolation == "module" ? "good" : "second") + " }\n");
        return written ? path : QString();
    }
    Outcome run(const QString& path, const QStringList& more = {}) {
        QDir(at("logs")).removeRecursively();
        return cli(QStringList{"run", path, "--json", "--quiet", "--modules", kSick, "--log-dir", at("logs")} + more);
    }
    QByteArray trace() const { return contentOf(at("logs/path.csv")); }
    QByteArray otherTrace() const { return contentOf(at("logs/other.csv")); }
    /// An experiment with a module of this text beside it.
    QString withModule(const QByteArray& python, const QByteArray& block = "Mine brain { }") {
        const bool written = writeFile(at("mine.py"), python) &&
                             writeFile(at("mine.sim"), "Duration = 1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                                       "#loadModule mine.py\nStatic floor { Config=OpenFloor }\n"
                                                       "Robot r { Config=SimpleRobot " +
                                                           block + " }\n");
        return written ? at("mine.sim") : QString();
    }

private Q_SLOTS:
    void initTestCase() {
        const Outcome outcome = run(experiment({}));
        QVERIFY2(outcome.code == 0, shown(outcome));
        m_trace = trace();
        m_otherTrace = otherTrace();
        QCOMPARE(m_trace.count('\n') + m_otherTrace.count('\n'), 2 * 102);
    }

    void givesTheSameStateAsInCpp_data() {
        QTest::addColumn<QString>("duration");
        QTest::newRow("turn_angle") << "15";
        const bool isLong = qEnvironmentVariableIsSet("TRUNDLE_LONG");
        QTest::newRow("network_navigation") << (isLong ? "300" : "40"); // it ends when it has arrived, after 105 s
        QTest::newRow("blob_follow") << "14";                           // it is there after 13 s
        QTest::newRow("collect") << (isLong ? "600" : "40");            // the first can is home after 34 s
        QTest::newRow("wall_follow") << (isLong ? "300" : "20");
        QTest::newRow("line_follow") << (isLong ? "150" : "20");
        QTest::newRow("braitenberg") << (isLong ? "60" : "20");
        QTest::newRow("lidar_map") << (isLong ? "600" : "20");          // it ends when all is mapped, after some minutes
        QTest::newRow("docking") << (isLong ? "600" : "60");
        QTest::newRow("soccer") << "8"; // the ball is in the goal
    }
    void givesTheSameStateAsInCpp() {
        QFETCH(QString, duration);
        const QString name = QStringLiteral("%1.sim").arg(QTest::currentDataTag());
        const QStringList more{"--duration", duration};
        const QJsonObject cpp = jsonOf(run(configPath("experiments/" + name), more));
        const Outcome outcome = run(configPath("experiments/python/" + name), more);
        const QJsonObject python = jsonOf(outcome);
        QVERIFY2(outcome.code == 0, shown(outcome).right(4000));
        QVERIFY(python["ticks"].toInt() >= 1000);
        for (const char* key : {"ticks", "state_hash", "finished", "robots"}) QCOMPARE(python[key], cpp[key]);
    }

    /// Ten robots that meet and turn away, in C++ and Python, inside the program and in any process.
    void tenRobotsGiveOneState() {
        QString first;
        for (const char* isolation : {"none", "module", "robot"})
            for (const char* module : {"controllers/braitenberg", "python/braitenberg.py"}) {
                const bool written =
                    writeFile(at("ten.sim"),
                              QByteArray("Tick = 0.01  Seed = 3  Isolation = ") + isolation +
                                  "\n#import robots/round_robot.sim\n#import arenas/medium_arena.sim\n#loadModule " + module +
                                  "\nLight sun { Intensity=0 }\nLight lamp { Mode=lamp Pos=1,0.4,0.12 Intensity=0.15 }\n"
                                  "Static arena { Config=MediumArena }\nGrid g { Config=RoundRobot Count=5,2 Spacing=0.5 "
                                  "Braitenberg brain { Vehicle=explorer Speed=0.2 Reference=100 } }\n");
                QVERIFY(written);
                const bool isLong = qEnvironmentVariableIsSet("TRUNDLE_LONG");
                const Outcome outcome = run(at("ten.sim"), {"--duration", isLong ? "100" : "4"});
                QVERIFY2(outcome.code == 0, shown(outcome).right(4000));
                QCOMPARE(jsonOf(outcome)["ticks"].toInt(), isLong ? 10'000 : 400);
                const QString hash = jsonOf(outcome)["state_hash"].toString();
                if (first.isEmpty()) first = hash;
                QCOMPARE(hash, first);
            }
    }

    /// The kinds of a module in Python and of one in C++ are described alike.
    void isDescribedAsInCpp_data() {
        QTest::addColumn<QString>("kind");
        QTest::newRow("mote") << "Mote";
        QTest::newRow("network_navigator") << "NetworkNavigator";
        QTest::newRow("network_navigator, sweep") << "BearingSweep";
        QTest::newRow("blob_follow") << "BlobFollow";
        QTest::newRow("collect") << "Collect";
        QTest::newRow("wall_follow") << "WallFollow";
        QTest::newRow("line_follow") << "LineFollow";
        QTest::newRow("braitenberg") << "Braitenberg";
        QTest::newRow("lidar_map") << "LidarMap";
        QTest::newRow("docking") << "Docking";
        QTest::newRow("striker") << "Striker";
    }
    void isDescribedAsInCpp() {
        QFETCH(QString, kind);
        const QString file = QStringLiteral(TRUNDLE_SOURCE_DIR "/plugins/python/%1.py").arg(QString(QTest::currentDataTag()).section(',', 0, 0));
        QVERIFY(QFile::exists(file));
        const auto described = [&](const QStringList& more) {
            QJsonObject page = QJsonDocument::fromJson(cli(QStringList{"describe", kind, "--json"} + more).out).object();
            page.remove("module");
            return page;
        };
        const QJsonObject cpp = described({});
        QVERIFY(cpp["properties"].toArray().size() > 3);
        // Under another name, as the kind of the library comes first.
        QJsonObject python =
            QJsonDocument::fromJson(cli({"describe", "Copied" + kind, "--json", "--modules", copiedModules()}).out).object();
        python.remove("module");
        python["name"] = kind;
        QCOMPARE(python, cpp);
    }

    void everyFaultStaysInItsProcess_data();
    void everyFaultStaysInItsProcess();

    /// They have one block, and fail in the same tick.
    void membersOfAGridHaveTheirOwnCalls() {
        QVERIFY(writeFile(at("mine.py"), "import trundle\nclass Mine(trundle.Controller):\n"
                                         "    number = trundle.field('Number', 0, trundle.number(), 'x')\n"
                                         "    def update(self, t):\n        self.second() if self.number else self.first()\n"
                                         "    def first(self):\n        raise ValueError('one')\n"
                                         "    def second(self):\n        raise ValueError('two')\n"));
        QVERIFY(writeFile(at("mine.sim"), "Duration = 0.1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                          "#loadModule mine.py\nStatic floor { Config=OpenFloor }\n"
                                          "Grid row { Config=SimpleRobot Count=2 Spacing=1 Mine brain { Number=$index } }\n"));
        const Outcome outcome = run(at("mine.sim"), {"--modules", m_folder.path()});
        QVERIFY2(outcome.code == 4, shown(outcome));
        QVERIFY2(outcome.err.contains("[0 row_0] error:   first at "), shown(outcome));
        QVERIFY2(outcome.err.contains("[0 row_1] error:   second at "), shown(outcome));
    }

    /// Their lines have no place: that is said once.
    void linesOfOtherThreadsAreIgnored() {
        const Outcome outcome =
            run(withModule("import threading\nimport trundle\n\n\nclass Mine(trundle.Controller):\n"
                           "    def update(self, t):\n        for _ in range(2):\n"
                           "            other = threading.Thread(target=lambda: self.print('lost'))\n"
                           "            other.start()\n            other.join()\n        self.print('kept')\n"),
                {"--modules", m_folder.path()});
        QVERIFY2(outcome.code == 0 && outcome.err.contains("kept") && !outcome.err.contains("lost"), shown(outcome));
        QCOMPARE(outcome.err.count("what other threads of the module ask for is ignored"), 1);
    }

    void aLogIsWrittenAsTextOrBytes() {
        const Outcome outcome =
            run(withModule("import trundle\n\n\nclass Mine(trundle.Controller):\n    def setup(self, robot):\n"
                           "        self.log = self.open_log('mine.csv')\n    def update(self, t):\n        self.log.write(5)\n"),
                {"--modules", m_folder.path()});
        QVERIFY2(outcome.code == 4 && outcome.err.contains("TypeError: a log is written as text or bytes, not as int"),
                 shown(outcome));
        QCOMPARE(contentOf(at("logs/mine.csv")), QByteArray());
    }

    void aFaultInSetupIsAnErrorOfTheText() {
        const Outcome outcome = run(experiment("Phase=setup Action=divide"));
        QVERIFY2(outcome.code == 4, shown(outcome));
        QVERIFY2(outcome.err.contains("sick.sim:8:"), shown(outcome)); // the line of its block
        QVERIFY2(outcome.err.contains("the controller Sick of bad failed in setup: ZeroDivisionError: division by zero, in divide at "
                                      "sick.py:" +
                                      QByteArray::number(lineOf("return 1 / 0"))),
                 shown(outcome));
    }

    void anUnknownPortNamesThoseThatAreThere() {
        const Outcome outcome = run(withModule("import trundle\n\n\nclass Mine(trundle.Controller):\n    def setup(self, robot):\n"
                                               "        robot.motor('leftMoter')\n    def update(self, t):\n        pass\n"),
                                    {"--modules", m_folder.path()});
        QVERIFY2(outcome.code == 4 && outcome.err.contains("error E411: r has no RotaryMotor port 'leftMoter'; did you mean "
                                                           "'leftMotor'? (its RotaryMotor ports: leftMotor, rightMotor)"),
                 shown(outcome));
    }

    void aFileThatDoesNotLoadIsAnErrorOfItsLine_data() {
        QTest::addColumn<QByteArray>("python");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("syntax") << QByteArray("import trundle\nclass Mine(:\n    pass\n") << QByteArray("cannot be loaded: SyntaxError: invalid syntax, at mine.py:2");
        QTest::newRow("import") << QByteArray("import trundle\nimport no_such_package\n")
                                << QByteArray("ModuleNotFoundError: No module named 'no_such_package', in <module> at mine.py:2");
        QTest::newRow("none") << QByteArray("import trundle\n") << QByteArray("it has no class that is derived from trundle.Controller");
        QTest::newRow("field") << QByteArray("import trundle\nclass Mine(trundle.Controller):\n    a = trundle.field('A', 1.0, 'm', 'x')\n")
                               << QByteArray("TypeError: the field A needs a quantity, such as metres(), in Mine at mine.py:3");
        const QByteArray mine = "import trundle\nclass Mine(trundle.Controller):\n";
        const QByteArray update = "    def update(self, since_last):\n        pass\n";
        const auto field = [&](const char* name, const char* arguments, const char* said) {
            QTest::newRow(name) << mine + "    a = trundle.field('A', " + arguments + ", 'x')\n" + update << QByteArray(said) + ", in Mine at mine.py:3";
        };
        field("below", "-1.0, trundle.metres().at_least(0)", "ValueError: the default of the field A is -1 m, it must be at least 0 m");
        field("not above", "0.0, trundle.metres().above(0)", "ValueError: the default of the field A is 0 m, it must be above 0 m");
        field("above", "3.5, trundle.degrees().at_most(180)", "ValueError: the default of the field A is 200.535 deg, it must be at most 180 deg");
        field("choice", "'up', trundle.one_of('left|right')", "ValueError: the default 'up' of the field A is not one of left, right");
        field("count", "(1.0, 2.0), trundle.metres().counted(3, 3)",
              "ValueError: the default of the field A has 2 elements, its quantity wants 3 to 3");
        QTest::newRow("no update") << mine + "    pass\n" << QByteArray("TypeError: Mine has no update(self, since_last)");
        QTest::newRow("other update") << mine + "    def update(self):\n        pass\n"
                                      << QByteArray("TypeError: Mine.update is called as update(self, since_last), and does not take that");
        QTest::newRow("other setup") << mine + "    def setup(self):\n        pass\n" + update
                                     << QByteArray("TypeError: Mine.setup is called as setup(self, robot), and does not take that");
        QTest::newRow("yields")
            << mine + "    def update(self, since_last):\n        yield\n"
            << QByteArray("TypeError: Mine.update would not run when it is called: it has a yield or is async, at mine.py:3");
        QTest::newRow("is async") << mine + "    async def setup(self, robot):\n        pass\n" + update
                                  << QByteArray(
                                         "Mine.setup would not run when it is called: it has a yield or is async, at mine.py:3");
        QTest::newRow("exits") << QByteArray("import os\nos._exit(3)\n") << QByteArray("ended its process in load with exit code 3, in <module> at mine.py:2");
        QTest::newRow("crashes") << QByteArray("import ctypes\nctypes.string_at(1)\n")
                                 << QByteArray("crashed in load: Segmentation fault, in <module> at mine.py:2");
    }
    void aFileThatDoesNotLoadIsAnErrorOfItsLine() {
        QFETCH(QByteArray, python);
        QFETCH(QByteArray, said);
        const Outcome check = cli({"check", withModule(python), "--modules", m_folder.path()});
        QVERIFY2(check.code == 1 && check.err.contains("mine.sim:4:13: error E414: ") && check.err.contains(said), shown(check));
    }

    void aMissingPythonIsAnErrorOfItsLine() {
        const Outcome check = callProgram("/usr/bin/env", {"PATH=/nowhere", "XDG_CACHE_HOME=" + at("empty"), programPath(), "check",
                                                           experiment({}), "--modules", kSick});
        QVERIFY2(check.code == 1 && check.err.contains("sick.sim:5:13: error E414: ") &&
                     check.err.contains("needs the program python3, which cannot be run; install Python 3"),
                 shown(check));
    }

    /// Of a python3 that says to be 3.7.
    void anOldPythonIsAnErrorOfItsLine() {
        QVERIFY(QDir(m_folder.path()).mkpath("old"));
        QVERIFY(writeFile(at("old/python3"),
                          "#!/bin/sh\nshift 3\nPATH=${PATH#*:} exec python3 -c 'import runpy, sys\nsys.argv.pop(0)\n"
                          "sys.version_info = (3, 7, 16)\nrunpy.run_path(sys.argv[0])' \"$@\"\n"));
        QVERIFY(QFile::setPermissions(at("old/python3"), QFile::ReadOwner | QFile::ExeOwner));
        const Outcome check =
            callProgram("/usr/bin/env", {"PATH=" + at("old:") + qEnvironmentVariable("PATH"), programPath(), "check",
                                         withModule("import trundle\n"), "--modules", m_folder.path()});
        QVERIFY2(check.code == 1 && check.err.contains("mine.sim:4:13: error E414: ") &&
                     check.err.contains("Trundle needs Python 3.8 or newer, and the first python3 in PATH is 3.7.16: ") &&
                     !check.err.contains("Traceback"),
                 shown(check));
    }

    /// Neither a check nor a run executes a file of a folder that is not trusted.
    void runsNoCodeOfAnUntrustedFolder() {
        const QString mark = at("mark");
        const QString path = withModule("import trundle\nopen('" + mark.toUtf8() +
                                        "', 'a').write('x')\nclass Mine(trundle.Controller):\n    def update(self, t):\n        pass\n");
        for (const char* command : {"check", "run"}) {
            const Outcome outcome = cli({command, path});
            QVERIFY2(outcome.code == 1 && outcome.err.contains("mine.sim:4:13: ") && outcome.err.contains("E402"),
                     shown(outcome));
            QVERIFY(!QFile::exists(mark));
        }
        QCOMPARE(cli({"check", path, "--trust"}).code, 0);
        QCOMPARE(contentOf(mark), QByteArray("xx")); // for the description, and as modules are loaded by a check
        QCOMPARE(cli({"check", path, "--trust"}).code, 0);
        QCOMPARE(contentOf(mark), QByteArray("xxx")); // the description was kept
    }

    /// A changed file, or one that it imports, is described again.
    void seesChanges() {
        const QByteArray mine = "import trundle\nimport more\n\n\nclass Mine(trundle.Controller):\n"
                                "    speed = trundle.field('Speed', 1.0, more.quantity(), 'x')\n    def update(self, t):\n        pass\n";
        QVERIFY(writeFile(at("more.py"), "from trundle import metres as quantity\n"));
        const QString path = withModule(mine, "Mine brain { Speed = 2 m }");
        const QStringList check{"check", path, "--modules", m_folder.path()};
        QVERIFY2(cli(check).code == 0, shown(cli(check)));
        QVERIFY(writeFile(at("more.py"), "from trundle import degrees as quantity\n"));
        QVERIFY2(cli(check).code == 1 && cli(check).err.contains("E206"), shown(cli(check)));
    }

    void aLiveFieldAndPublishedValues() {
        const Outcome outcome = run(withModule("import trundle\nclass Mine(trundle.Controller):\n"
                                               "    turns = trundle.output('turns', '', 'x', type=int)\n"
                                               "    goal = trundle.output('goal', 'm', 'x', count=2)\n"
                                               "    def update(self, t):\n        self.turns += 1\n        self.goal = (self.time, -1)\n"
                                               "        if self.turns == 50: self.finish('enough')\n"),
                                    {"--modules", m_folder.path()});
        QVERIFY2(outcome.code == 0, shown(outcome));
        const QJsonObject json = jsonOf(outcome), signal = json["robots"]["r"]["signals"].toObject();
        QCOMPARE(json["finished"]["reason"].toString(), QStringLiteral("enough"));
        QCOMPARE(signal["brain/turns"].toInt(), 50);
        QCOMPARE(signal["brain/goal"].toArray(), (QJsonArray{0.49, -1.0}));
    }
    /// At the time of the call: in setup before the first tick, in an update at the end of its tick.
    void whereItFinishesTheRunEnds_data() {
        QTest::addColumn<QByteArray>("python");
        QTest::addColumn<int>("ticks");
        QTest::newRow("in setup") << QByteArray("    def setup(self, robot):\n        self.finish('enough')\n") << 0;
        QTest::newRow("in setup, twice")
            << QByteArray("    def setup(self, robot):\n        self.finish('enough')\n        self.finish('more')\n") << 0;
        QTest::newRow("in the first update") << QByteArray("    def update(self, t):\n        self.finish('enough')\n") << 1;
        QTest::newRow("in the second update")
            << QByteArray("    def update(self, t):\n        if self.time > 0: self.finish('enough')\n") << 31;
        QTest::newRow("never") << QByteArray() << 100;
    }
    void whereItFinishesTheRunEnds() {
        QFETCH(QByteArray, python);
        QFETCH(int, ticks);
        if (!python.contains("update")) python += "    def update(self, t):\n        pass\n";
        for (const char* isolation : {"robot", "module"}) {
            const Outcome outcome = run(withModule("import trundle\nclass Mine(trundle.Controller):\n" + python,
                                                   QByteArray("Mine brain { UpdatePeriod=0.3 Isolation=") + isolation + " }"),
                                        {"--modules", m_folder.path()});
            QVERIFY2(outcome.code == 0, shown(outcome));
            const QJsonObject json = jsonOf(outcome);
            QCOMPARE(json["ticks"].toInt(), ticks);
            QCOMPARE(json["finished"].isNull(), ticks == 100);
            if (ticks == 100) continue;
            QCOMPARE(json["finished"]["reason"].toString(), QStringLiteral("enough"));
            QCOMPARE(json["finished"]["time"].toDouble(), ticks * 0.01);
        }
    }
    void aPublishedWholeNumberIsOne() {
        for (const QByteArray value : {"2.7", "float('nan')"}) {
            const Outcome outcome = run(withModule("import trundle\nclass Mine(trundle.Controller):\n"
                                                   "    turns = trundle.output('turns', '', 'x', type=int)\n"
                                                   "    def update(self, t):\n        self.turns = 2.0\n        self.turns = " +
                                                   value + "\n"),
                                        {"--modules", m_folder.path()});
            QVERIFY2((outcome.out + outcome.err).contains(": an output of type int takes whole numbers, not "), shown(outcome));
        }
    }
};

void PythonTest::everyFaultStaysInItsProcess_data() {
    QTest::addColumn<QByteArray>("settings");
    QTest::addColumn<QByteArray>("said"); ///< part of the reason; empty: it is not stopped
    QTest::addColumn<QByteArray>("line"); ///< of sick.py, which the reason names
    QTest::addColumn<QByteArray>("isolation");
    const bool isLong = qEnvironmentVariableIsSet("TRUNDLE_LONG");
    auto add = [isLong, rows = 0](const char* name, const QByteArray& settings, const QByteArray& said,
                                  const QByteArray& line) mutable {
        const char* const one = ++rows % 3 == 0 ? "module" : "robot";
        for (const char* isolation : {"robot", "module"})
            if (isLong || isolation == QByteArray(one))
                QTest::addRow("%s, %s", name, isolation) << settings << said << line << QByteArray(isolation);
    };
    const auto row = [&](const char* action, const QByteArray& said, const QByteArray& line = {}, const QByteArray& more = {}) {
        add(action, "Action=" + QByteArray(action) + " " + more, said, line);
    };
    const QByteArray failed = "the controller Sick of bad failed: ", crashed = "crashed in update: ";
    row("divide", failed + "ZeroDivisionError: division by zero, in divide at sick.py:", "return 1 / 0");
    row("raise_exit", failed + "SystemExit: 5, in raise_exit at sick.py:", "sys.exit(5)");
    row("recurse", failed + "RecursionError: maximum recursion depth exceeded", "return recurse()");
    row("fork", failed + "BlockingIOError: ", "os.fork()");
    row("execute", failed + "PermissionError: ", "os.execv(");
    row("kill_parent", failed + "PermissionError: ", "os.getppid()");
    row("segv", crashed + "Segmentation fault, in segv at sick.py:", "ctypes.string_at(1)");
    row("abort", crashed + "Aborted, in abort at sick.py:", "CDLL(None).abort()");
    row("leave", "ended its process in update with exit code 3, in leave at sick.py:", "os._exit(3)");
    row("kill", "ended its process in update: SIGKILL");
    for (const char* action : {"loop", "sleep", "print_without_end"})
        row(action, "did not return from update within 1.0 s and was stopped, in " + QByteArray(action) + " at sick.py:", {}, "Budget=20");
    for (const char* action : {"thread", "thread_fails", "close_all", "change_folder", "nothing"}) row(action, {});
    add("eat memory", "Action=eat_memory", failed + "MemoryError, in ", "range(1000)");
    add("write sensor", "Phase=\"write sensor\"", failed + "TypeError: cannot modify read-only memory", "_sensors[0] = ");
    add("misspelt signal", "Phase=\"misspelt signal\"", "the port has no signal 'linearVelocty'; did you mean 'linearVelocity'?", "linearVelocty");
    add("word", "Phase=word", failed + "TypeError: a signal takes a number, not 'fast'", {});
    add("overwrite commands", "Phase=\"overwrite commands\"", {}, {});
}

void PythonTest::everyFaultStaysInItsProcess() {
    QFETCH(QByteArray, settings);
    QFETCH(QByteArray, said);
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, isolation);
    const Outcome outcome = run(experiment(settings, isolation));
    QCOMPARE(trace(), m_trace);
    if (isolation == "robot") QCOMPARE(otherTrace(), m_otherTrace);
    QVERIFY2(outcome.code == (said.isEmpty() ? 0 : 4), shown(outcome).left(4000));
    QCOMPARE(jsonOf(outcome)["ticks"].toInt(), 100);
    const QJsonArray stopped = jsonOf(outcome)["stopped"].toArray();
    QCOMPARE(stopped.size(), said.isEmpty() ? 0 : 1);
    if (said.isEmpty()) return;
    const QByteArray reason = stopped[0]["reason"].toString().toUtf8();
    QCOMPARE(stopped[0]["robot"].toString(), QStringLiteral("bad"));
    QVERIFY2(reason.contains(said), reason);
    if (!line.isEmpty()) QVERIFY2(reason.contains("sick.py:" + QByteArray::number(lineOf(line.trimmed()))), reason);
    if (!reason.contains("SIGKILL")) QVERIFY2(stopped[0]["backtrace"][0].toString().contains(" at "), shown(outcome).left(4000));
    QCOMPARE(controlCharacters(outcome.err), QByteArray());
}

QTEST_GUILESS_MAIN(PythonTest)
#include "python_test.moc"
