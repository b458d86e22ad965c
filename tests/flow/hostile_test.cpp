// Untrusted projects, modules and names: no file of the user is changed, and no control sequence reaches the terminal.

#include "flow/cli.h"

namespace {

const QString kModules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/hostile");

} // namespace

class HostileFlowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] QString experiment(const QByteArray& rest, const QByteArray& name = "x.sim") const {
        const QString file = path("project/" + QString::fromUtf8(name));
        return writeFile(file, "Tick = 0.01  Duration = 0.1\n#import robots/simple_robot.sim\n" + rest) ? file : QString();
    }
    [[nodiscard]] static Outcome runZoo(const QString& file) {
        const QString zoo = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo");
        return callProgram("/usr/bin/env", {"ASAN_OPTIONS=" + kOwnHandlers, programPath(), "run", file, "--modules", zoo});
    }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath("project/.trundle") && QDir(m_folder->path()).mkpath("outside"));
        QVERIFY(writeFile(path("outside/authorized_keys"), "mine"));
    }

    void aLinkedLogFolderIsRefused_data() {
        QTest::addColumn<QString>("link");
        QTest::newRow("logs") << "logs";
        QTest::newRow("logs of the experiment") << "logs/x";
    }
    void aLinkedLogFolderIsRefused() {
        QFETCH(QString, link);
        if (link.contains('/')) QVERIFY(QDir(m_folder->path()).mkpath("project/logs"));
        QVERIFY(QFile::link(path("outside"), path("project/" + link)));
        const QString file = experiment("Robot r { Config=SimpleRobot }\nPoseLog p { File=authorized_keys }\n");
        const Outcome run = cli({"run", file});
        QVERIFY2(run.code == 1 && run.err.contains("E503") && run.err.contains("symbolic link"), shown(run));
        QVERIFY2(run.err.contains("--log-dir"), shown(run));
        QCOMPARE(contentOf(path("outside/authorized_keys")), QByteArray("mine"));
        QCOMPARE(QDir(path("outside")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 1);
        // A folder given by the user is used, even through a link.
        const Outcome named = cli({"run", file, "--log-dir", path("project/" + link)});
        QVERIFY2(named.code == 0, shown(named));
        QVERIFY(contentOf(path("outside/authorized_keys")).startsWith("time"));
    }

    void cleansModuleText_data() {
        QTest::addColumn<bool>("fails");
        QTest::newRow("said") << false;
        QTest::newRow("failed with") << true;
    }
    void cleansModuleText() {
        QFETCH(bool, fails);
        const QString file = experiment("#loadModule hostile\nRobot r { Config=SimpleRobot Hostile brain { Fails=" +
                                        QByteArray(fails ? "true" : "false") + " } }\n");
        for (const bool json : {false, true}) {
            const Outcome run =
                cli(QStringList{"run", file, "--modules", kModules} + (json ? QStringList{"--json"} : QStringList{}));
            QVERIFY2(run.code == (fails ? 4 : 0), shown(run));
            QVERIFY2(run.err.contains("mis.exe"), shown(run));
            QVERIFY2(run.err.contains("cannot be called"), shown(run));          // the log that it names
            QVERIFY2(!run.err.contains("\n[0 robot1] all is well"), shown(run)); // each line has a prefix with its origin
            QCOMPARE(controlCharacters(run), QByteArray());
        }
    }
    void cleansWhatAModulePrintsItself_data() {
        QTest::addColumn<int>("code"); ///< -2: killed
        QTest::newRow("print escapes") << 0;
        QTest::newRow("print escapes and crash") << 4;
        QTest::newRow("print escapes and be killed") << -2;
        QTest::newRow("print escapes and leave") << 7;
        QTest::newRow("close all and print escapes") << 1; // the results have no descriptor left
    }
    void cleansWhatAModulePrintsItself() {
        QFETCH(int, code);
        const QString file = experiment("#loadModule zoo\nRobot r { Config=SimpleRobot Zoo brain { At=3 Action=\"" +
                                        QByteArray(QTest::currentDataTag()) + "\" } }\n");
        const Outcome run = runZoo(file);
        QVERIFY2(run.code == code, shown(run));
        QCOMPARE(controlCharacters(run), QByteArray());
        for (const QByteArray& line :
             {"printf \uFFFD]0;mine\uFFFD \uFFFD\uFFFD end", "cout \uFFFD[2J end", "fprintf \uFFFD31m end", "h\u00e9 end"})
            QVERIFY2(run.err.count(line + '\n') == 1, shown(run));
        const qsizetype report = run.err.indexOf("trundle-cli: ");
        QVERIFY2(report < 0 || report > run.err.indexOf("h\u00e9 end"), shown(run)); // in the order in which they were written
    }
    void aModuleCanWaitForAllItsChildProcesses() {
        const QString file = experiment("#loadModule zoo\nRobot r { Config=SimpleRobot Zoo brain { At=3 "
                                        "Action=\"wait for all children\" } }\n");
        const Outcome run = runZoo(file);
        QVERIFY2(run.code == 0 && run.err.contains("none left\n"), shown(run));
    }
    void theHelpOfAModuleIsClean() {
        for (const QStringList& more : {QStringList{}, {"--json"}, {"Hostile"}, {"Hostile", "--json"}}) {
            const Outcome reported = cli(QStringList{"describe", "--modules", kModules} + more);
            QVERIFY2(reported.code == 0 && reported.out.contains("Hostile"), shown(reported));
            QCOMPARE(controlCharacters(reported), QByteArray());
        }
    }

    /// The path of a module, in what is said of its crash.
    void theCrashOfAModuleIsReportedCleanly() {
        const QString modules = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo/"),
                      folder = path(QString::fromUtf8(kHostileName));
        QDir().mkpath(folder);
        for (const char* ending : {".so", ".so.kinds.json"})
            QVERIFY(QFile::copy(modules + "libzoo" + ending, folder + "/libzoo" + ending));
        for (const char* action : {"exit", "thread exits"})
            for (const QStringList& json : {QStringList{}, {"--json"}}) {
                const QString file = experiment("#loadModule zoo\nRobot r { Config=SimpleRobot Zoo brain { Action=\"" +
                                                    QByteArray(action) + "\" At=3 } }\n",
                                                "crash.sim");
                const Outcome run = cli(QStringList{"run", file, "--modules", folder} + json);
                QVERIFY2(run.code == 4 && run.err.contains("libzoo.so"), shown(run));
                QCOMPARE(controlCharacters(run), QByteArray());
                if (!json.isEmpty()) QVERIFY2(QJsonDocument::fromJson(run.out).object().contains("crashed"), shown(run));
            }
    }

    void namesOfFilesAreClean() {
        const QString file = experiment("Robot r { Config=SimpleRobot Sped=1 }\n", kHostileName),
                      none = path("none") + QString::fromUtf8(kHostileName);
        const QString importing =
            experiment("#import \"" + kHostileName + "\"\n#import \"none" + kHostileName + "\"\n", "importing.sim");
        for (const QString& each : {file, none, importing})
            for (const QStringList& before :
                 {QStringList{"check"}, {"run"}, {"check", "--json"}, {"run", "--json"}, {"render", "-o", "x.png"}}) {
                const Outcome said = cli(before + QStringList{each});
                QVERIFY2(said.err.size() + said.out.size() > 0, shown(said));
                QCOMPARE(controlCharacters(said), QByteArray());
            }
    }
    void cleansCommandLineText() {
        const QString name = QString::fromUtf8(kHostileName);
        for (const QStringList& words : {QStringList{name},
                                         {"run", "--" + name},
                                         {"run", "x.sim", name},
                                         {"describe", name},
                                         {"run", "x.sim", "--fps", name},
                                         {"describe", "--modules", name}}) {
            const Outcome said = cli(words, m_folder->path());
            QVERIFY2(said.code == 2 && !said.err.isEmpty(), shown(said));
            QCOMPARE(controlCharacters(said), QByteArray());
        }
    }
};

QTEST_GUILESS_MAIN(HostileFlowTest)
#include "hostile_test.moc"
