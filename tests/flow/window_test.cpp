// The program trundle called with options and without a screen, as documentation and checks call it.

#include <csignal>
#include <future>

#include <QDataStream>
#include <QImage>
#include <QRect>
#include <QSettings>
#include <QtEndian>

#include "flow/cli.h"

class WindowProgramTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { qputenv("XDG_RUNTIME_DIR", m_folder.path().toUtf8()); } // Qt warns if it is not set

    void takesAPicture() {
        const QString picture = m_folder.filePath(QStringLiteral("driven.png"));
        const Outcome outcome =
            call({"--open", configPath("experiments/arc_motion.sim"), "--run-for", "0.5", "--select", "robot0.chassis", "--view",
                  "follow", "--layout", "run", "--theme", "dark", "--size", "1000x700", "--screenshot", picture, "--quit"});
        QVERIFY2(outcome.code == 0, shown(outcome));
        QVERIFY2(outcome.err.isEmpty(), shown(outcome));
        const QByteArray png = contentOf(picture);
        QVERIFY(png.startsWith("\x89PNG") && png.size() > 1000);
        QCOMPARE(qFromBigEndian<quint32>(png.constData() + 16), 1000u);
        QCOMPARE(qFromBigEndian<quint32>(png.constData() + 20), 700u);
    }

    /// Words in capitals, FILE without --open, limits themselves.
    void takesWhatIsAllowed_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << QStringList{"--theme", "LIGHT", "--layout", "Edit", "--look", "RICH", "--run-for", "0"}
                               << false;
        QTest::newRow("dark") << QStringList{"--theme", "Dark", "--layout", "RUN", "--look", "Fast", "--size", "8192x240"}
                              << true;
    }
    void takesWhatIsAllowed() {
        QFETCH(QStringList, options);
        QFETCH(bool, dark);
        const QString picture = m_folder.filePath(QStringLiteral("allowed.png"));
        const Outcome outcome =
            call(options + QStringList{configPath("experiments/arc_motion.sim"), "--screenshot", picture, "--quit"});
        QVERIFY2(outcome.code == 0 && outcome.err.isEmpty(), shown(outcome));
        const QImage image(picture);
        QVERIFY(image.width() == 8192 || !dark);
        QCOMPARE(qGray(image.pixel(3, image.height() - 3)) < 128, dark); // the status line
    }

    void takesModulesAndSearchFolders() {
        QVERIFY(QDir().mkpath(m_folder.filePath("shared")));
        QVERIFY(writeFile(m_folder.filePath("shared/given.sim"), "#import robots/simple_robot.sim\n#loadModule controllers/good\n"
                                                                 "Robot r { Config=SimpleRobot Driver brain { } }\n"));
        const QString modules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules");
        QVERIFY(QDir().mkpath(m_folder.filePath("given")));
        QVERIFY(writeFile(m_folder.filePath("given/given_test.sim"), "Duration = 1\n#import given.sim\n"));
        const QStringList open{m_folder.filePath("given/given_test.sim"), "--run-for", "0.1", "--quit"};
        const QStringList folders{"-I", m_folder.filePath("shared"), "--modules", modules};
        const Outcome without = call(open), with = call(folders + open);
        QVERIFY2(without.code == 1, shown(without));
        QVERIFY2(with.code == 0 && with.err.isEmpty(), shown(with));
        const Outcome missing = call(QStringList{"--modules", m_folder.filePath("none")} + open);
        QVERIFY2(missing.code == 2 && missing.err.contains("--modules: there is no folder"), shown(missing));
    }

    void takesAPictureOfAViewBlock() {
        const QString experiment = m_folder.filePath(QStringLiteral("views.sim")),
                      picture = m_folder.filePath(QStringLiteral("views.png"));
        QVERIFY(writeFile(experiment, "View Corner { Eye=2,2,2 Target=0,0,0 }\n"));
        const Outcome outcome = call({"--open", experiment, "--view", "Corner", "--screenshot", picture, "--quit"});
        QVERIFY2(outcome.code == 0 && outcome.err.isEmpty(), shown(outcome));
        QVERIFY(contentOf(picture).startsWith("\x89PNG"));
    }

    /// Without EGL the window reports that images are unavailable, and its picture is still saved.
    void takesAPictureWhereThereAreNone() {
        const QString picture = m_folder.filePath(QStringLiteral("blind.png"));
        qputenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/none.json");
        const Outcome outcome = call({"--open", configPath("experiments/camera_swarm.sim"), "--screenshot", picture, "--quit"});
        qunsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
        QVERIFY2(outcome.code == 0, shown(outcome));
        QVERIFY(contentOf(picture).startsWith("\x89PNG"));
    }

    /// Otherwise the display's socket or a file would get descriptor 1 or 2, and a module that prints would write into it.
    void toleratesClosedDescriptor() {
        const QString experiment = m_folder.filePath(QStringLiteral("closed.sim")),
                      pid = m_folder.filePath(QStringLiteral("closed.pid"));
        QVERIFY(writeFile(experiment, "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                      "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot }\nPoseLog path { }\n"));
        auto running = std::async(std::launch::async, [&] {
            return callProgram("/usr/bin/env", {"QT_QPA_PLATFORM=offscreen", "/bin/sh", "-c",
                                                "echo $$ > \"$1\"; exec \"$0\" --open \"$2\" --run-for 1e6 <&- >&- 2>&-",
                                                QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle"), pid, experiment});
        });
        const QString log = m_folder.filePath(QStringLiteral("logs/closed/path.csv"));
        const bool runs = QTest::qWaitFor([&] { return contentOf(log).count('\n') > 20; }, 60'000);
        const QByteArray id = contentOf(pid).trimmed();
        QStringList targets;
        for (const char* descriptor : {"0", "1", "2"})
            targets << QFile::symLinkTarget(
                QStringLiteral("/proc/%1/fd/%2").arg(QString::fromLatin1(id), QLatin1String(descriptor)));
        ::kill(id.toInt(), runs ? SIGTERM : SIGKILL);
        (void)running.get();
        QVERIFY(runs);
        QCOMPARE(targets[0], QStringLiteral("/dev/null"));
        QVERIFY2(targets[1].contains("/pipe:[") && targets[1] == targets[2], qPrintable(targets.join(' '))); // to the cleaner
    }

    void signalEndsProgramAndKeepsLogs_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGHUP") << SIGHUP;
        QTest::newRow("SIGUSR1") << SIGUSR1; // would end it without the last rows
    }
    void signalEndsProgramAndKeepsLogs() {
        QFETCH(int, signal);
        const QString experiment = m_folder.filePath(QStringLiteral("marker/marker.sim")),
                      pid = m_folder.filePath(QStringLiteral("marker/pid"));
        QDir().mkpath(m_folder.filePath(QStringLiteral("marker")));
        QFile::remove(pid);
        QVERIFY(writeFile(experiment, "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                      "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot }\nPoseLog path { }\n"));
        auto running = std::async(std::launch::async, [&] {
            return callProgram("/usr/bin/env", {"QT_QPA_PLATFORM=offscreen", "/bin/sh", "-c",
                                                "echo $$ > \"$1\"; exec \"$0\" --open \"$2\" --run-for 1e6",
                                                QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle"), pid, experiment});
        });
        const QString log = m_folder.filePath(QStringLiteral("marker/logs/marker/path.csv"));
        const bool runs = QTest::qWaitFor([&] { return contentOf(log).count('\n') > 20; }, 60'000);
        ::kill(contentOf(pid).trimmed().toInt(), runs ? signal : SIGKILL);
        const Outcome outcome = running.get();
        QVERIFY2(runs && outcome.code == 128 + signal && outcome.err.isEmpty(), shown(outcome));
        QVERIFY(contentOf(log).endsWith('\n'));
        QFile::remove(log);
    }

    void helpNeedsNoDisplay() {
        for (const QString& word : {QStringLiteral("--help"), QStringLiteral("--version")}) {
            const Outcome outcome = callWithoutDisplay({word});
            QVERIFY2(outcome.code == 0 && outcome.err.isEmpty() && outcome.out.contains("Trundle"), shown(outcome));
        }
        const Outcome refused = callWithoutDisplay({});
        QVERIFY2(refused.code == 2 && refused.err.contains("QT_QPA_PLATFORM=offscreen"), shown(refused));
        QCOMPARE(refused.err.count('\n'), 1);
    }

    /// Making images for a manual changes neither the list of recent files nor the saved window size.
    void screenshotChangesNoSettings() {
        const QString home = m_folder.filePath(QStringLiteral("home"));
        qputenv("XDG_CONFIG_HOME", home.toUtf8());
        const QString picture = m_folder.filePath(QStringLiteral("still.png"));
        const Outcome outcome =
            call({"--open", configPath("experiments/arc_motion.sim"), "--size", "640x480", "--screenshot", picture, "--quit"});
        qunsetenv("XDG_CONFIG_HOME");
        QVERIFY2(outcome.code == 0, shown(outcome));
        QFile kept(home + QStringLiteral("/Trundle/Trundle.conf"));
        if (!kept.open(QIODevice::ReadOnly)) return;
        const QByteArray settings = kept.readAll();
        QVERIFY2(!settings.contains("arc_motion") && !settings.contains("layouts") && !settings.contains("windowGeometry"),
                 settings);
    }

    void keepsSizeAfterMaximizedWindow() {
        const QString home = m_folder.filePath(QStringLiteral("maximized"));
        QByteArray geometry; // in the format of QWidget::saveGeometry()
        QDataStream stream(&geometry, QIODevice::WriteOnly);
        stream.setVersion(QDataStream::Qt_4_0);
        const QRect plain(20, 40, 640, 480), whole(0, 0, 800, 800);
        stream << quint32(0x1D9D0CB) << quint16(3) << quint16(0) << plain << plain << qint32(0) << quint8(1) << quint8(0)
               << qint32(800) << whole;
        QDir().mkpath(home + QStringLiteral("/Trundle"));
        QSettings(home + QStringLiteral("/Trundle/Trundle.conf"), QSettings::IniFormat)
            .setValue(QStringLiteral("windowGeometry"), geometry);
        qputenv("XDG_CONFIG_HOME", home.toUtf8());
        const QString picture = m_folder.filePath(QStringLiteral("sized.png"));
        const Outcome outcome =
            call({"--open", configPath("experiments/arc_motion.sim"), "--size", "1000x700", "--screenshot", picture, "--quit"});
        qunsetenv("XDG_CONFIG_HOME");
        QVERIFY2(outcome.code == 0, shown(outcome));
        const QByteArray png = contentOf(picture);
        QCOMPARE(qFromBigEndian<quint32>(png.constData() + 16), 1000u);
        QCOMPARE(qFromBigEndian<quint32>(png.constData() + 20), 700u);
    }

    /// File names, messages of modules and arguments are printed without terminal control sequences.
    void cleansItsOutput_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString name = QString::fromUtf8(kHostileName);
        QTest::newRow("no file") << QStringList{"--open", "/nowhere/" + name};
        QTest::newRow("a file with an error") << QStringList{"--open", m_folder.filePath(name), "--run-for", "1"};
        QTest::newRow("no object") << QStringList{"--open", configPath("experiments/arc_motion.sim"), "--select", name};
        QTest::newRow("no view") << QStringList{"--view", name};
        QTest::newRow("no option") << QStringList{"--" + name};
        QTest::newRow("no picture") << QStringList{"--screenshot", "/nowhere/" + name};
    }
    void cleansItsOutput() {
        QFETCH(QStringList, arguments);
        QVERIFY(writeFile(m_folder.filePath(QString::fromUtf8(kHostileName)), "Robot r { Config=None }\n"));
        const Outcome outcome = call(arguments + QStringList{"--quit"});
        QVERIFY2(outcome.code != 0 && !outcome.err.isEmpty(), shown(outcome));
        QCOMPARE(controlCharacters(outcome), QByteArray());
    }

    void reportsMissingDisplay_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("reason");
        const QString sample = configPath("experiments/arc_motion.sim");
        QTest::newRow("no file") << QStringList{"--open", "/nowhere/a.sim"} << QByteArray("/nowhere/a.sim does not exist");
        QTest::newRow("no object") << QStringList{"--open", sample, "--select", "robot7"} << QByteArray("no robot7");
        QTest::newRow("no view") << QStringList{"--open", sample, "--view", "upside"} << QByteArray("perspective");
        QTest::newRow("no time") << QStringList{"--open", sample, "--run-for", "soon"} << QByteArray("seconds");
        QTest::newRow("nothing to run") << QStringList{"--run-for", "3"} << QByteArray("needs a FILE");
        QTest::newRow("no option") << QStringList{"--nonsense"} << QByteArray("nonsense");
        for (const char* size : {"10x10", "319x240", "320x239", "8193x240", "320x8193", "320", "320x240x1", "320 x 240 px"})
            QTest::addRow("size %s", size) << QStringList{"--size", size}
                                           << "--size takes WIDTHxHEIGHT from 320x240 to 8192x8192, not " + QByteArray(size);
        QTest::newRow("layout") << QStringList{"--layout", "Wide"} << QByteArray("--layout is one of edit, run, not wide");
        QTest::newRow("theme") << QStringList{"--theme", "grey"} << QByteArray("--theme is one of light, dark, not grey");
        QTest::newRow("look") << QStringList{"--look", "best"} << QByteArray("--look is one of automatic, fast, rich, not best");
        QTest::newRow("two files") << QStringList{sample, sample} << QByteArray("one FILE at a time");
        for (const char* seconds : {"-1", "nan", "1.1e9", "2s", ""})
            QTest::addRow("run for '%s'", seconds)
                << QStringList{"--open", sample, "--run-for", seconds} << QByteArray("--run-for takes seconds from 0 to 1e9");
    }
    void reportsMissingDisplay() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, reason);
        const QString picture = m_folder.filePath(QStringLiteral("none.png"));
        const Outcome outcome = call(arguments + QStringList{"--screenshot", picture, "--quit"});
        QVERIFY2(outcome.code == 2, shown(outcome));
        QVERIFY2(outcome.err.startsWith("trundle: ") && outcome.err.contains(reason), shown(outcome));
        QCOMPARE(outcome.err.count('\n'), 1);
        QVERIFY(!QFile::exists(picture));
    }

    /// The image is written, and the exit code shows that it is not of a run.
    void reportsMissingRun_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("reason");
        const QByteArray team = "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                "Static floor { Config=OpenFloor }\n";
        QTest::newRow("errors") << QByteArray(team + "Robot r { Config=SimpleRobot Possition=1,2,3 }\n") << 1
                                << QByteArray("did not run: The text has an error");
        QTest::newRow("nothing") << QByteArray("StaticConfig Lone { Box { Size=1,1,1 } }\n") << 1
                                 << QByteArray("did not run: There is nothing to run");
        QTest::newRow("not trusted") << QByteArray("#loadModule mine\n" + team +
                                                   "Robot r { Config=SimpleRobot Failing brain { } }\n")
                                     << 1 << QByteArray("trust the folder");
        QTest::newRow("fails in setup") << QByteArray("#loadModule \"" TRUNDLE_BINARY_DIR "/tests/modules/controllers/good\"\n" +
                                                      team + "Robot r { Config=SimpleRobot Failing brain { Where=\"setup\" } }\n")
                                        << 1 << QByteArray("no battery");
        QTest::newRow("fails in a turn") << QByteArray("#loadModule \"" TRUNDLE_BINARY_DIR "/tests/modules/controllers/good\"\n" +
                                                       team +
                                                       "Robot r { Config=SimpleRobot Failing brain { Where=\"give up\" } }\n")
                                         << 3 << QByteArray("the map is empty");
    }
    void reportsMissingRun() {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(QByteArray, reason);
        const QString modules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/controllers/");
        for (const char* ending : {".so", ".so.kinds.json"})
            QFile::copy(modules + "libgood" + ending, m_folder.filePath(QStringLiteral("libmine")) + ending);
        const QString home = m_folder.filePath(QStringLiteral("trusting"));
        QDir().mkpath(home + "/Trundle");
        QVERIFY(writeFile(home + "/Trundle/Trundle.conf", "[General]\ntrustedFolders=" + modules.toUtf8() + "\n"));
        qputenv("XDG_CONFIG_HOME", home.toUtf8());
        const QString file = m_folder.filePath(QStringLiteral("norun.sim")),
                      picture = m_folder.filePath(QStringLiteral("norun.png"));
        QVERIFY(writeFile(file, text));
        const Outcome outcome = call({"--open", file, "--run-for", "3", "--screenshot", picture, "--quit"});
        qunsetenv("XDG_CONFIG_HOME");
        QVERIFY2(outcome.code == code, shown(outcome));
        QVERIFY2(outcome.err.startsWith("trundle: ") && outcome.err.contains(reason), shown(outcome));
        QCOMPARE(outcome.err.count('\n'), 1);
        QVERIFY(contentOf(picture).startsWith("\x89PNG"));
        QVERIFY(QFile::remove(picture));
    }

    /// A crash or exit() in code of a module, in the run's thread or in one of its own: the window names the module and the logs are
    /// complete.
    void reportsCrashInModule_data() {
        QTest::addColumn<QByteArray>("brain");
        QTest::addColumn<QByteArray>("said");
        const QByteArray library = TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so",
                         thread = "a thread of the module " + library, controller = "the controller Zoo of r (" + library + ") ";
        const auto row = [](const char* action, const char* phase, const QByteArray& said) {
            const QByteArray name = QByteArray(action) + " in " + phase;
            QTest::newRow(name.constData()) << QByteArray("Action=\"" + QByteArray(action) + "\" Phase=" + phase) << said;
        };
        row("segv", "update", controller + "crashed in update at t = 0.49 s: Segmentation fault; unsaved edits");
        row("overflow", "update", controller + "crashed in update at t = 0.49 s: Segmentation fault; unsaved edits");
        row("terminate", "update", controller + "crashed in update at t = 0.49 s: Aborted; unsaved edits");
        row("throw past noexcept", "update",
            "trundle: an uncaught exception: no ?[31mbattery??\ntrundle: " + controller + "crashed in update");
        row("segv", "setup", controller + "crashed in setup");
        row("abort", "destructor", controller + "crashed in destructor");
        row("exit", "update", controller + "ended the program in update at t = 0.49 s, by exit() or the like; unsaved edits");
        row("_exit", "update", controller + "ended the program in update");
        row("thread crashes", "update", "crashed in the middle of the run at t = 0.49 s: Segmentation fault, in " + thread);
        row("thread overflows", "update", "crashed in the middle of the run at t = 0.49 s: Segmentation fault, in " + thread);
        row("library code crashes in a thread", "update", "Segmentation fault, in " + thread);
        row("thread exits", "update", thread + " ended the program in the middle of the run at t = 0.49 s");
        row("thread _exits", "update", thread + " ended the program in the middle of the run at t = 0.49 s");
    }
    void reportsCrashInModule() {
        QFETCH(QByteArray, brain);
        QFETCH(QByteArray, said);
        const Outcome outcome = callWithZoo(brain, {"--quit"});
        QVERIFY2(outcome.code == 4, shown(outcome));
        QVERIFY2(outcome.err.startsWith("trundle: ") && outcome.err.contains(said), shown(outcome));
        QVERIFY2(outcome.err.endsWith("; unsaved edits are offered at the next start\n"), shown(outcome));
        QCOMPARE(outcome.err.count('\n'), brain.contains("noexcept") ? 2 : 1);
        const qsizetype rows = contentOf(m_folder.filePath("crashes/logs/crashes/path.csv")).count('\n');
        QCOMPARE(rows, brain.endsWith("update")       ? 51
                       : brain.endsWith("destructor") ? 102
                                                      : rows); // a header, the start, the ticks
    }

    void cleansWhatAModulePrintsItself() {
        for (const QByteArray action : {"print escapes", "print escapes and crash"}) {
            const Outcome outcome = callWithZoo("Action=\"" + action + "\" Phase=update", {"--quit"});
            QCOMPARE(outcome.code, action.endsWith("crash") ? 4 : 0);
            for (const char* end : {"cout \uFFFD[2J end\n", "fprintf \uFFFD31m end\n", "h\u00e9 end\n"})
                QVERIFY2(outcome.err.contains(end), shown(outcome));
            QCOMPARE(controlCharacters(outcome), QByteArray());
        }
    }

    /// For the dialog at the next start; a program that ends by --quit is a script's, which reads standard error.
    void keepsCrashReport_data() {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<QByteArray>("said");
        const QByteArray library = TRUNDLE_BINARY_DIR "/tests/modules/zoo/libzoo.so";
        QTest::newRow("crash") << QByteArray("segv")
                               << "the controller Zoo of r (" + library +
                                      ") crashed in update at t = 0.49 s: Segmentation fault\n";
        QTest::newRow("exception") << QByteArray("throw past noexcept")
                                   << "the controller Zoo of r (" + library +
                                          ") crashed in update at t = 0.49 s: Aborted; uncaught exception: no ?[31mbattery??\n";
        QTest::newRow("stack overflow in a thread of clone()")
            << QByteArray("bare thread overflows")
            << "the controller Zoo of r (" + library + ") crashed in update at t = 0.49 s: Segmentation fault\n";
        QTest::newRow("exit") << QByteArray("exit")
                              << "the controller Zoo of r (" + library +
                                     ") ended the program in update at t = 0.49 s, by exit() or the like\n";
        QTest::newRow("stack overflow in a thread")
            << QByteArray("thread overflows")
            << "crashed in the middle of the run at t = 0.49 s: Segmentation fault, in a thread of the module " + library + "\n";
    }
    void keepsCrashReport() {
        QFETCH(QByteArray, action);
        QFETCH(QByteArray, said);
        const QTemporaryDir state;
        qputenv("XDG_STATE_HOME", state.path().toUtf8());
        const QByteArray brain = "Action=\"" + action + "\" Phase=update";
        const Outcome scripted = callWithZoo(brain, {"--quit"});
        const QDir folder(state.filePath("trundle/crashes"));
        const QStringList none = folder.entryList(QDir::Files);
        const Outcome outcome = callWithZoo(brain, {});
        qunsetenv("XDG_STATE_HOME");
        QCOMPARE(none, QStringList());
        QVERIFY2(scripted.code == 4 && outcome.code == 4, shown(outcome));
        const QStringList reports = folder.entryList(QDir::Files);
        QCOMPARE(reports.size(), 1);
        QCOMPARE(contentOf(folder.filePath(reports[0])), said);
    }

    /// A window that stays open after its picture has a user.
    void keepsCrashReportBesideAPicture() {
        const QTemporaryDir state;
        qputenv("XDG_STATE_HOME", state.path().toUtf8());
        const Outcome outcome = callWithZoo("Action=segv Phase=update", {"--screenshot", state.filePath("window.png")});
        qunsetenv("XDG_STATE_HOME");
        QVERIFY2(outcome.code == 4, shown(outcome));
        QCOMPARE(QDir(state.filePath("trundle/crashes")).entryList(QDir::Files).size(), 1);
    }

private:
    /// Runs an experiment in a window whose controller has a fault.
    Outcome callWithZoo(const QByteArray& brain, const QStringList& options) {
        const QString modules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo/"), home = m_folder.filePath("trusting"),
                      file = m_folder.filePath("crashes/crashes.sim");
        QDir().mkpath(home + "/Trundle");
        QDir().mkpath(m_folder.filePath("crashes"));
        bool written = writeFile(home + "/Trundle/Trundle.conf", "[General]\ntrustedFolders=" + modules.toUtf8() + "\n");
        written = written &&
                  writeFile(file, "Duration = 1  Isolation = none\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule \"" +
                                      modules.toUtf8() +
                                      "zoo\"\nStatic floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot Zoo brain { " +
                                      brain + " } }\nPoseLog path { }\n");
        if (!written) return {};
        qputenv("XDG_CONFIG_HOME", home.toUtf8());
        const Outcome outcome = callProgram("/bin/sh", QStringList{"-c", "ulimit -c 0; exec \"$@\"", "sh", "/usr/bin/env",
                                                                   "ASAN_OPTIONS=handle_segv=0:handle_abort=0:use_sigaltstack=0",
                                                                   "TSAN_OPTIONS=handle_segv=0:handle_abort=0:use_sigaltstack=0",
                                                                   QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle"), "--open",
                                                                   file, "--run-for", "3"} +
                                                           options);
        qunsetenv("XDG_CONFIG_HOME");
        return outcome;
    }
    static Outcome call(const QStringList& arguments) {
        return callProgram(QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle"), arguments);
    }
    static Outcome callWithoutDisplay(const QStringList& arguments) {
        const QByteArray platform = qgetenv("QT_QPA_PLATFORM"), display = qgetenv("DISPLAY"),
                         wayland = qgetenv("WAYLAND_DISPLAY");
        for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) qunsetenv(name);
        const Outcome outcome = call(arguments);
        if (!platform.isNull()) qputenv("QT_QPA_PLATFORM", platform);
        if (!display.isNull()) qputenv("DISPLAY", display);
        if (!wayland.isNull()) qputenv("WAYLAND_DISPLAY", wayland);
        return outcome;
    }
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(WindowProgramTest)
#include "window_test.moc"
