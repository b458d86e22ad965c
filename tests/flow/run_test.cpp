// trundle-cli run: summary, JSON, determinism, interruption, seeds, and runs that controllers end.
#include <csignal>
#include <future>

#include <sys/prctl.h>
#include <sys/wait.h>

#include "flow/cli.h"

class RunFlowTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    Outcome runLinear(QStringList more = {}) {
        return cli(QStringList{"run", configPath("experiments/linear_motion.sim"), "--log-dir", m_folder.filePath("logs")} +
                   more);
    }
    static QByteArray hashLine(const Outcome& outcome) { return outcome.out.split('\n').value(outcome.out.count('\n') - 1); }

private Q_SLOTS:
    void summaryShowsFinalPoseAndDriveError();
    void summaryShowsTurns();
    void summaryLeavesOutRefusedAmounts();
    void jsonIsOneObjectOfTheKnownShape();
    void theSameInputGivesTheSameBits();
    void logsChangeNothing();
    void ctrlCEndsWithEverythingComplete();
    void manyRobotsAreSummedUp();
    void errorsOfSeveralTurnsAreSummedUp();
    void quietRunPrintsNothing();
    void leavesNoProcess();
    void seedAndSetReachTheExperiment();
    void exitCodesOfSeveralFiles();
    void quickSolverTakesWhatTheExactOneCannot();
    void anEndedObjectLeavesTheOthersRunning();
    void aControllerEndsTheRun_data();
    void aControllerEndsTheRun();
    void theThesisExperimentRuns();
    void aWalkTouchesEveryWallAndNeverStays_data();
    void aWalkTouchesEveryWallAndNeverStays();
};

void RunFlowTest::summaryShowsFinalPoseAndDriveError() {
    const Outcome run = runLinear();
    QVERIFY2(run.code == 0, shown(run));
    QVERIFY2(run.out.contains("1200 ticks"), shown(run));
    QVERIFY2(run.out.contains("x real time"), shown(run));
    const QRegularExpressionMatch ended = QRegularExpression("robot0 +at x (-?[0-9.]+) m, y (-?[0-9.]+) m").match(run.out);
    QVERIFY2(ended.hasMatch(), shown(run));
    QVERIFY(qAbs(ended.captured(1).toDouble() + 0.5) < 0.002);
    QVERIFY(qAbs(ended.captured(2).toDouble()) < 0.002);
    const QRegularExpressionMatch drove = QRegularExpression("drove +([0-9.]+) m of 1 m commanded").match(run.out);
    QVERIFY2(drove.hasMatch(), shown(run));
    QVERIFY(qAbs(drove.captured(1).toDouble() - 1) < 5e-5);
    // What is derived from other numbers fits them.
    const QRegularExpressionMatch off =
        QRegularExpression("drove +([0-9.]+) m of 1 m commanded \\(([-+][0-9.]+) mm\\)").match(run.out);
    QVERIFY2(off.hasMatch(), shown(run));
    QVERIFY2(qAbs(off.captured(2).toDouble() - (off.captured(1).toDouble() - 1) * 1000) < 1e-3, shown(run));
    const QRegularExpressionMatch took = QRegularExpression("took +([0-9.]+) s, ([0-9.]+) x real time").match(run.out);
    QVERIFY2(took.hasMatch() && qAbs(took.captured(1).toDouble() * took.captured(2).toDouble() / 12 - 1) < 0.02, shown(run));
    QVERIFY2(!run.out.contains("turned") && !run.out.contains("under way"), shown(run));
    QVERIFY2(run.out.contains("linear_motion.csv"), shown(run));
    QVERIFY2(run.err.contains("[") && run.err.contains(" robot0] done"), shown(run)); // printed by the controller
}

void RunFlowTest::summaryShowsTurns() {
    const QStringList arc{"run", configPath("experiments/arc_motion.sim"), "--log-dir", m_folder.filePath("arc")};
    const Outcome whole = cli(arc);
    const QRegularExpressionMatch turned =
        QRegularExpression("turned +([0-9.]+) deg of 360 deg commanded \\(([-+][0-9.]+) deg\\)").match(whole.out);
    QVERIFY2(turned.hasMatch() && qAbs(turned.captured(1).toDouble() - 360) < 0.1, shown(whole));
    QVERIFY2(qAbs(turned.captured(2).toDouble() - (turned.captured(1).toDouble() - 360)) < 1e-3, shown(whole));
    // A circle of radius 0.3 m: the distance follows from the angle and both speeds.
    const QRegularExpressionMatch drove = QRegularExpression("drove +([0-9.]+) m of ([0-9.]+) m commanded").match(whole.out);
    QVERIFY2(drove.hasMatch() && qAbs(drove.captured(2).toDouble() - 1.88496) < 1e-4, shown(whole));
    QVERIFY2(qAbs(drove.captured(1).toDouble() - 1.88496) < 1e-3, shown(whole));
    const Outcome part = cli(arc + QStringList{"--duration", "2"});
    QVERIFY2(part.out.contains("the last command was still under way"), shown(part));
}

/// Those are refused in the run, with a warning each.
void RunFlowTest::summaryLeavesOutRefusedAmounts() {
    QVERIFY(writeFile(m_folder.filePath("refused.py"), "import math, trundle\nclass Refused(trundle.Controller):\n"
                                                       "    def setup(self, robot):\n"
                                                       "        self.base, self.n = robot.differential_drive('base'), 0\n"
                                                       "    def update(self, dt):\n        self.n += 1\n"
                                                       "        if self.n == 1: self.base.drive(0.2, 0, 0.1, 0)\n"
                                                       "        if self.n == 200: self.base.drive(math.nan, 0, 1, 0)\n"
                                                       "        if self.n == 210: self.base.drive(0.2, 0, math.inf, 0)\n"
                                                       "        if self.n == 220: self.base.drive(-0.2, 0, 1, 0)\n"
                                                       "        if self.n == 230: self.base.turn(0, 1)\n"));
    QVERIFY(writeFile(m_folder.filePath("refused.sim"),
                      "Tick = 0.01 Duration = 3\n#import arenas/open_floor.sim\n#import robots/simple_robot.sim\n"
                      "#loadModule refused.py\nStatic floor { Config=OpenFloor }\n"
                      "Robot r { Config=SimpleRobot Refused mind { } }\n"));
    const Outcome run = cli({"run", m_folder.filePath("refused.sim"), "--modules", m_folder.path()});
    QVERIFY2(run.code == 0 && run.out.contains(" m of 0.1 m commanded") && !run.out.contains("nan"), shown(run));
    QVERIFY2(!run.out.contains("turned") && !run.out.contains("under way"), shown(run));
}

void RunFlowTest::jsonIsOneObjectOfTheKnownShape() {
    const Outcome run = runLinear({"--json"});
    QVERIFY2(run.code == 0, shown(run));
    QJsonParseError error;
    const QJsonObject json = QJsonDocument::fromJson(run.out, &error).object();
    QCOMPARE(error.error, QJsonParseError::NoError);
    QStringList keys = json.keys();
    keys.sort();
    QStringList expected{"ticks",          "simulated_s", "wall_s",        "real_time_factor",
                         "peak_memory_kb", "state_hash",  "quick_ticks",   "interrupted",
                         "robots",         "diagnostics", "rescued_ticks", "finished",
                         "objects",        "ended",       "stopped",       "engine",      "threads"};
    expected.sort();
    QCOMPARE(keys, expected);
    QCOMPARE(json["ticks"].toInt(), 1200);
    QCOMPARE(json["simulated_s"].toDouble(), 12.0);
    QCOMPARE(json["interrupted"].toBool(true), false);
    QVERIFY(json["finished"].isNull());
    QVERIFY(json["peak_memory_kb"].toInt() > 1000);
    QVERIFY(QRegularExpression("^[0-9a-f]{16}$").match(json["state_hash"].toString()).hasMatch());
    QCOMPARE(json["diagnostics"].toArray().size(), 0);
    const QJsonObject robot = json["robots"].toObject()["robot0"].toObject();
    QCOMPARE(robot["pos"].toArray().size(), 3);
    QCOMPARE(robot["hpr"].toArray().size(), 3);
    const QJsonObject signalsOf = robot["signals"].toObject();
    // One metre on a wheel of radius 5 cm is 20 rad: 1629 counts at 512 a turn, less a small amount for contact slip.
    QVERIFY2(qAbs(signalsOf["leftEncoder/count"].toInt() - 1629) <= 2, shown(run));
    QCOMPARE(signalsOf["frontTouch/pressed"].toBool(true), false);
    QVERIFY2(signalsOf.contains("base/odometry"), shown(run));
}

void RunFlowTest::theSameInputGivesTheSameBits() {
    const Outcome first = runLinear({"--hash", "--duration", "2"});
    QVERIFY2(first.code == 0, shown(first));
    QVERIFY2(QRegularExpression("^state-hash [0-9a-f]{16} tick 200$").match(hashLine(first)).hasMatch(), shown(first));
    for (const QStringList& how : {QStringList{}, QStringList{"--quiet"}, QStringList{"--realtime"}})
        QCOMPARE(hashLine(runLinear(QStringList{"--hash", "--duration", "2"} + how)), hashLine(first));
    const Outcome json = runLinear({"--json", "--duration", "2"});
    QVERIFY(hashLine(first).contains(QJsonDocument::fromJson(json.out).object()["state_hash"].toString().toLatin1()));
    QVERIFY(hashLine(runLinear({"--hash", "--duration", "2.01"})) != hashLine(first));
}

void RunFlowTest::logsChangeNothing() {
    QByteArray text = contentOf(configPath("experiments/linear_motion.sim"));
    const qsizetype log = text.indexOf("PoseLog");
    QVERIFY(log > 0);
    QVERIFY(writeFile(m_folder.filePath("without.sim"), text.left(log)));
    QVERIFY(
        writeFile(m_folder.filePath("with.sim"), text + "\nContactLog c { }\nEnergyLog e { }\nSignalLog s { Signals=\"*\" }\n"));
    const Outcome without = cli({"run", m_folder.filePath("without.sim"), "--hash"});
    const Outcome with = cli({"run", m_folder.filePath("with.sim"), "--hash"});
    QVERIFY2(without.code == 0 && with.code == 0, shown(without) + shown(with));
    QCOMPARE(hashLine(with), hashLine(without));
    QVERIFY(QFileInfo::exists(m_folder.filePath("logs/with/e.csv"))); // the default log folder
    QVERIFY(!QFileInfo::exists(m_folder.filePath("logs/without")));
}

void RunFlowTest::ctrlCEndsWithEverythingComplete() {
    const QString pid = m_folder.filePath("pid"), err = m_folder.filePath("err");
    auto running = std::async(std::launch::async, [&] {
        return callProgram("/bin/sh",
                           {"-c", "echo $$ > \"$1\"; exec \"$0\" run \"$2\" --duration 1e7 --json --log-dir \"$3\" 2> \"$4\"",
                            programPath(), pid, configPath("experiments/linear_motion.sim"), m_folder.filePath("ctrlc"), err});
    });
    QTRY_VERIFY_WITH_TIMEOUT(contentOf(err).contains("simulated"), 60'000); // the first progress line: it is running
    QCOMPARE(::kill(contentOf(pid).trimmed().toInt(), SIGINT), 0);
    const Outcome ended = running.get();
    QCOMPARE(ended.code, 130);
    const QJsonObject json = QJsonDocument::fromJson(ended.out).object();
    QVERIFY(json["interrupted"].toBool());
    QVERIFY(json["ticks"].toInteger() > 0);
    const QByteArray csv = contentOf(m_folder.filePath("ctrlc/linear_motion.csv"));
    QVERIFY(csv.endsWith('\n'));
    QCOMPARE(csv.count('\n'), 1 + (json["ticks"].toInteger() / 10 + 1));
}

void RunFlowTest::manyRobotsAreSummedUp() {
    const QString path = m_folder.filePath("many.sim");
    QVERIFY(writeFile(
        path,
        "Duration = 4\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule controllers/linear_motion\n"
        "Static floor { Config=OpenFloor }\n"
        "Grid g { Config=SimpleRobot Count=3,3 Spacing=1 LinearMotion brain { Distance=0.2 } }\n"));
    const Outcome run = cli({"run", path});
    QVERIFY2(run.code == 0, shown(run));
    QVERIFY2(QRegularExpression(
                 "9 drives with commanded amounts: at most 0\\.[0-9]+ mm off \\(g_[0-8]\\), [0-9.]+ deg off \\(g_[0-8]\\)")
                 .match(run.out)
                 .hasMatch(),
             shown(run));
}

/// Each turn is compared with its own amount, not with those before.
void RunFlowTest::errorsOfSeveralTurnsAreSummedUp() {
    const QString path = m_folder.filePath("turns.sim");
    QVERIFY(writeFile(m_folder.filePath("turner.py"), "import trundle\nclass Turner(trundle.Controller):\n"
                                                      "    def setup(self, robot):\n"
                                                      "        self.drive = robot.differential_drive('base')\n"
                                                      "        self.angles, self.turning = [1.5, -1.0, 0.7], False\n"
                                                      "    def update(self, since_last):\n"
                                                      "        if self.turning and not self.drive.done():\n"
                                                      "            return\n"
                                                      "        self.turning = bool(self.angles)\n"
                                                      "        if self.angles:\n"
                                                      "            self.drive.turn(2.0, self.angles.pop(0))\n"));
    QVERIFY(writeFile(
        path,
        "Duration = 5\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule controllers/linear_motion\n"
        "#loadModule turner.py\nStatic floor { Config=OpenFloor }\n"
        "Grid g { Config=SimpleRobot Count=4,2 Spacing=1 LinearMotion brain { Distance=0.2 } }\n"
        "Robot turner { Config=SimpleRobot Pos=0,5,0 Turner brain { } }\n"));
    const Outcome run = cli({"run", path, "--modules", m_folder.path()});
    QVERIFY2(run.code == 0, shown(run));
    const QRegularExpressionMatch off =
        QRegularExpression("9 drives with commanded amounts: at most [0-9.]+ mm off \\([a-z0-9_]+\\), ([0-9.]+) deg off")
            .match(run.out);
    QVERIFY2(off.hasMatch() && off.captured(1).toDouble() < 5, shown(run));
}

/// The process that passes on what modules print has ended before the run does.
void RunFlowTest::leavesNoProcess() {
    QVERIFY(::prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
    const Outcome outcome = runLinear({"--duration", "0.05"});
    QVERIFY2(outcome.code == 0, outcome.err.constData());
    const int left = ::waitpid(-1, nullptr, __WALL);
    const int reason = errno;
    QVERIFY(::prctl(PR_SET_CHILD_SUBREAPER, 0) == 0);
    QCOMPARE(left, -1);
    QCOMPARE(reason, ECHILD);
}

void RunFlowTest::quietRunPrintsNothing() {
    const Outcome run = runLinear({"--quiet"});
    QCOMPARE(run.code, 0);
    QCOMPARE(run.out, QByteArray());
    QVERIFY2(!run.err.contains("simulated"), shown(run));
}

/// The worst of several files decides: unreadable (2) before faulty (1), in any order. A --set without a path is a usage error.
void RunFlowTest::exitCodesOfSeveralFiles() {
    const QString bad = m_folder.filePath("bad.sim"), good = m_folder.filePath("good.sim"), none = m_folder.filePath("none.sim");
    QVERIFY(writeFile(bad, "Tick = fast\n") && writeFile(good, "Tick = 0.01\n"));
    for (const auto& [files, code] : {std::pair{QStringList{good}, 0},
                                      {{good, bad}, 1},
                                      {{bad, good}, 1},
                                      {{none, bad}, 2},
                                      {{bad, none}, 2},
                                      {{none, good, bad, good}, 2},
                                      {{good, none, good}, 2}})
        QCOMPARE(cli(QStringList{"check"} + files).code, code);
    for (const char* set : {"=3", "Tick", ""})
        for (const char* command : {"check", "run"}) QCOMPARE(cli({command, good, "--set", set}).code, 2);
    QCOMPARE(cli({"check", good, "--set", "Tick=fast"}).code, 1);
}

void RunFlowTest::seedAndSetReachTheExperiment() {
    const auto walk = [&](const QStringList& more) {
        return cli(QStringList{"run", configPath("experiments/obstacle_detection.sim"), "--duration", "20", "--quiet", "--hash",
                               "--log-dir", m_folder.filePath("w")} +
                   more);
    };
    const Outcome first = walk({"--seed", "1"});
    QVERIFY2(first.code == 0, shown(first));
    QCOMPARE(walk({}).out, first.out); // the text sets seed 1
    const QByteArray second = walk({"--seed", "2"}).out;
    QVERIFY(second != first.out);
    QCOMPARE(walk({"--set", "Seed=3", "--seed", "2"}).out, second); // --seed is the last word, wherever it stands
    QCOMPARE(walk({"--seed", "2", "--set", "Seed=3"}).out, second);
    QVERIFY(walk({"--set", "robot0.brain.Speed=0.25"}).out != first.out);
    const Outcome wrong = walk({"--set", "robot0.brain.Sped=0.25"});
    QCOMPARE(wrong.code, 1);
    QVERIFY2(wrong.err.contains("--set#1:1:") && wrong.err.contains("Speed"), shown(wrong));
}

void RunFlowTest::quickSolverTakesWhatTheExactOneCannot() {
    // Four equal hinges with friction hold a body of 1e-8 kg: their rows are singular in every tick.
    const QString knot = m_folder.filePath("knot.sim");
    QByteArray text = "RobotConfig Knot {\n  Body b { Pos=0,0,1 Box k { Size=0.1,0.2,0.3 Mass=0.00000001 } }\n";
    for (const char name : {'a', 'b', 'c', 'd'})
        text += QByteArray("  Hinge h") + name + " { Parent=world Child=b Anchor=0.1,0,1 Axis=0,1,0 Friction=1 }\n";
    QVERIFY(writeFile(knot, text + "}\nRobot r { Config=Knot }\n"));
    const Outcome run = cli({"run", knot, "--duration", "0.1", "--json"});
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QVERIFY2(json["rescued_ticks"].toInt() == 10 && json["quick_ticks"].toInt() >= 1, shown(run));
    QCOMPARE(json["ticks"].toInt(), 10);
    const Outcome reported = cli({"run", knot, "--duration", "0.1"});
    QVERIFY2(reported.out.contains("solved by the quick solver") && reported.out.contains("repeated with softer constraints"),
             shown(reported));
}

/// A stone falls from 30 km and is too fast after 20.4 s; the robot drives on. The summary, the JSON, the messages and the logs show it.
void RunFlowTest::anEndedObjectLeavesTheOthersRunning() {
    const QString path = m_folder.filePath("stone.sim"), logs = m_folder.filePath("stone_logs");
    QVERIFY(writeFile(
        path, "Tick=0.02 Duration=21\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
              "#loadModule controllers/linear_motion\nStatic floor { Config=OpenFloor }\n"
              "RobotConfig Stone { Body body { Sphere s { Radius=0.1 Mass=1 } } }\nRobot stone { Config=Stone Pos=3,0,30000 }\n"
              "Robot robot0 { Config=SimpleRobot LinearMotion brain { Distance=0.5 Speed=0.2 } }\n"
              "PoseLog path { Interval=7 }\nSignalLog s { Signals=stone/pose,robot0/pose Interval=7 }\n"));
    const QStringList command{"run", path, "--log-dir", logs, "-I", configPath("")};
    const Outcome json = cli(command + QStringList{"--json"});
    QVERIFY2(json.code == 0, shown(json));
    const QJsonObject result = QJsonDocument::fromJson(json.out).object();
    QCOMPARE(result["ticks"].toInt(), 1050);
    const QJsonArray ended = result["ended"].toArray();
    QCOMPARE(ended.size(), 1);
    QCOMPARE(ended[0].toObject()["robot"].toString(), QStringLiteral("stone"));
    QCOMPARE(ended[0].toObject()["body"].toString(), QStringLiteral("stone/body"));
    QVERIFY2(qAbs(ended[0].toObject()["time"].toDouble() - 20.4) < 0.021, shown(json));
    int warnings = 0;
    for (const QJsonValue& message : result["diagnostics"].toArray()) warnings += message.toObject()["code"] == "E501";
    QCOMPARE(warnings, 1);
    const Outcome plain = cli(command);
    QVERIFY2(QRegularExpression("ended +stone/body at t = 20.4 s: it moves at 200").match(plain.out).hasMatch(), shown(plain));
    QVERIFY2(plain.err.contains("stone has ended, all others continue"), shown(plain));
    const auto linesOf = [&](const char* name) {
        QFile file(logs + "/" + name);
        return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n') : QList<QByteArray>();
    };
    const auto poses = linesOf("path.csv"), signalRows = linesOf("s.csv");
    QCOMPARE(poses.size(), 1 + 3 * 2 + 1); // at 0, 7 and 14 s both, at 21 s the robot alone
    QVERIFY(poses.back().startsWith("21,robot0,"));
    QVERIFY2(signalRows.back().startsWith("21,,,,,,,0."), signalRows.back().constData());
}

void RunFlowTest::aControllerEndsTheRun_data() {
    QTest::addColumn<QByteArray>("robots");
    QTest::addColumn<QString>("who");
    QTest::addColumn<int>("ticks");
    QTest::newRow("after some ticks") << QByteArray("Robot a { Config=SimpleRobot Counter brain { End=7 } }\n") << "a" << 7;
    QTest::newRow("the first of two") << QByteArray("Robot a { Config=SimpleRobot Counter brain { End=9 } }\n"
                                                    "Robot b { Config=SimpleRobot Pos=2,0,0 Counter brain { End=4 } }\n")
                                      << "b" << 4;
    QTest::newRow("two in one tick") << QByteArray("Robot b { Config=SimpleRobot Counter brain { End=5 } }\n"
                                                   "Robot a { Config=SimpleRobot Pos=2,0,0 Counter brain { End=5 } }\n")
                                     << "b" << 5; // in the order of the text
    QTest::newRow("in setup") << QByteArray("Robot a { Config=SimpleRobot Counter brain { Early=true } }\n") << "a" << 0;
    QTest::newRow("not before the duration")
        << QByteArray("Robot a { Config=SimpleRobot Counter brain { End=500 } }\n") << "" << 20;
}

void RunFlowTest::aControllerEndsTheRun() {
    QFETCH(QByteArray, robots);
    QFETCH(QString, who);
    QFETCH(int, ticks);
    robots.replace("Counter brain {", "Counter brain { Reason=\"a\\nb \x1b[31mred\xc2\x9b\"");
    const QString text = m_folder.filePath("ends.sim");
    QVERIFY(writeFile(text, "Duration = 0.2\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                            "#loadModule publishing/publishing\nStatic floor { Config=OpenFloor }\n" +
                                robots + "SignalLog counts { Signals=\"*/brain/count\" }\n"));
    const QString logs = m_folder.filePath("ends"), modules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules");
    const QStringList words{"run", text, "--modules", modules, "--log-dir", logs};
    const Outcome run = cli(words + QStringList{"--json"});
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object(), finished = json["finished"].toObject();
    QCOMPARE(json["ticks"].toInt(), ticks);
    QCOMPARE(finished["robot"].toString(), who);
    QCOMPARE(contentOf(logs + "/counts.csv").count('\n'), ticks + 2); // header and start
    const Outcome reported = cli(words);
    QCOMPARE(reported.code, 0);
    QCOMPARE(reported.out.contains("finished    by "), !who.isEmpty());
    QVERIFY2(!reported.out.contains('\x1b') && !reported.out.contains("\xc2\x9b"),
             shown(reported)); // no terminal control sequence from a module
    if (who.isEmpty()) return;
    QCOMPARE(finished["time"].toDouble(), ticks * 0.01);
    QCOMPARE(finished["controller"].toString(), QString("brain"));
    QVERIFY2(reported.out.contains("finished    by " + who.toUtf8() + "/brain at t = "), shown(reported));
}

void RunFlowTest::theThesisExperimentRuns() {
    // Every line and value known from figure 3.4; robot, arena, materials and surfaces are our own files.
    const QByteArray text = contentOf(configPath("experiments/thesis_figure_3_4.txt"));
    for (const char* line : {"Tick = 0.03", "#import Surfaces.txt", "#import Materials.txt", "#import Robots/MyRobot.txt",
                             "#import Statics/MyRobotArena.txt", "#loadModule Controllers/MyRobotController.dll",
                             "MyRobotController controller { RobotControllerVar=5 }", "Pos = 0,0,0", "Pos = 0,0,0.3"})
        QVERIFY2(text.contains(line), line);
    QVERIFY(!text.contains("//")); // no comments of ours among them
    const Outcome run = cli({"run", configPath("experiments/thesis_figure_3_4.txt"), "--duration", "9", "--json", "--log-dir",
                             m_folder.filePath("t")});
    QVERIFY2(run.code == 0, shown(run));
    const QJsonObject robot = QJsonDocument::fromJson(run.out).object()["robots"].toObject()["robot0"].toObject();
    QVERIFY2(qAbs(robot["pos"].toArray()[2].toDouble()) < 0.002, shown(run)); // landed on its wheels
    QVERIFY2(robot["pos"].toArray()[0].toDouble() > 0.5, shown(run));         // and drove off
}

void RunFlowTest::aWalkTouchesEveryWallAndNeverStays_data() {
    QTest::addColumn<QString>("seed");
    for (int seed = 1; seed <= 10; ++seed) QTest::addRow("seed %d", seed) << QString::number(seed);
}

void RunFlowTest::aWalkTouchesEveryWallAndNeverStays() {
    QFETCH(QString, seed);
    const QString logs = m_folder.filePath("walk");
    const Outcome run =
        cli({"run", configPath("experiments/obstacle_detection.sim"), "--quiet", "--log-dir", logs, "--seed", seed});
    QVERIFY2(run.code == 0, shown(run));
    double low[2] = {9, 9}, high[2] = {-9, -9};
    for (const QByteArray& line : contentOf(logs + "/obstacle_detection.csv").split('\n').mid(1)) {
        const QList<QByteArray> cells = line.split(',');
        for (int i = 0; i < 2 && cells.size() > 3; ++i) {
            low[i] = std::min(low[i], cells[2 + i].toDouble());
            high[i] = std::max(high[i], cells[2 + i].toDouble());
        }
    }
    // The bumper is 17 cm in front: a wall 2 m from the origin is touched at 1.83 m at most, a slanted one earlier.
    for (int i = 0; i < 2; ++i) QVERIFY2(low[i] < -1.6 && high[i] > 1.6, qPrintable(QString("%1 %2").arg(low[i]).arg(high[i])));
    int held = 0, longest = 0;
    for (const QByteArray& line : contentOf(logs + "/touch.csv").split('\n').mid(1)) {
        held = line.endsWith(",1") ? held + 1 : 0;
        longest = std::max(longest, held);
    }
    QVERIFY2(longest > 0 && longest <= 100, qPrintable(QString("pressed for %1 ticks").arg(longest)));
}

QTEST_GUILESS_MAIN(RunFlowTest)
#include "run_test.moc"
