// A module that is rebuilt while its controllers run in a process of their own: the robots get the new code where they are.
#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include "app/application.h"
#include "flow/cli.h"

using namespace trundle;

class ReloadTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication(findLocations(), Isolation::Module);
    std::shared_ptr<const LoadedProject> m_loaded;
    QStringList m_console;

    [[nodiscard]] QString library() const { return m_folder.filePath("mine/libmind.so"); }
    /// Writes the library as if it was built with another text to print, or from a changed interface.
    [[nodiscard]] bool build(const char* from, const QByteArray& word, double part = 1) {
        const QString source = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/rebuilt/lib%1.so").arg(QLatin1String(from));
        QByteArray bytes = contentOf(source);
        bytes.replace(QByteArray(from) + '\0', word + '\0');
        QDir(m_folder.path()).mkpath("mine");
        QFile::remove(library()); // as a linker does
        return !bytes.isEmpty() && word.size() == qsizetype(strlen(from)) &&
               writeFile(library(), bytes.left(qsizetype(double(bytes.size()) * part))) &&
               writeFile(m_folder.filePath("mine/libmind.so.kinds.json"), contentOf(source + ".kinds.json"));
    }
    std::unique_ptr<Runner> makeRunner(const QByteArray& state = "none") {
        return runnerOf("#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule mine/mind\n"
                        "Static floor { Config=OpenFloor }\n"
                        "Robot a { Config=SimpleRobot Pos=0,0,0.1 Rebuilt brain { State=" +
                        state + " } }\nRobot b { Config=SimpleRobot Pos=0,2,0 Rebuilt brain { State=saved } }\n");
    }
    std::unique_ptr<Runner> runnerOf(const QByteArray& text) {
        m_console.clear();
        const QString path = m_folder.filePath("reload.sim");
        OpenOptions options;
        options.modules = {m_folder.filePath("mine").toStdString()};
        if (!writeFile(path, text)) return nullptr;
        auto loaded = m_application->open(path.toStdString(), options);
        if (!loaded) return nullptr;
        m_loaded = loaded.value();
        RunOptions run;
        run.console = [this](double, const std::string& who, int, const std::string& text) {
            m_console.append(QString::fromStdString(who + ": " + text));
        };
        Diagnostics problems;
        std::unique_ptr<Runner> runner = m_application->makeRunner(*m_loaded, std::move(run), problems);
        for (const Diagnostic& problem : problems.all()) qWarning("%s", problem.message.c_str());
        return runner;
    }
    [[nodiscard]] bool tick(Runner& runner, int ticks) {
        for (int i = 0; i < ticks; ++i)
            if (!runner.tick().ok()) return false;
        return true;
    }
    [[nodiscard]] bool reload(Runner& runner) {
        runner.command(ReloadCommand{library().toStdString()});
        return tick(runner, 1);
    }
    [[nodiscard]] qsizetype reported(const QString& text) const { return m_console.filter(text).size(); }
    /// Open files, mapped segments of hosts, and children of this process.
    static QString resources() {
        const QList<QByteArray> maps = contentOf("/proc/self/maps").split('\n');
        const auto segments =
            std::count_if(maps.begin(), maps.end(), [](const QByteArray& line) { return line.contains("trundle-"); });
        const QByteArray children = contentOf(QStringLiteral("/proc/self/task/%1/children").arg(getpid()));
        return QStringLiteral("%1 files, %2 segments, %3 children")
            .arg(QString::number(QDir("/proc/self/fd").entryList(QDir::Files | QDir::System).size()), QString::number(segments),
                 QString::number(children.simplified().split(' ').size()));
    }

private Q_SLOTS:
    void runningRobotsGetTheNewCode() {
        QVERIFY(build("before", "before"));
        std::unique_ptr<Runner> runner = makeRunner();
        QVERIFY(runner && tick(*runner, 50));
        QCOMPARE(reported("before life"), 2);
        QVERIFY(build("before", "behind"));
        QVERIFY(tick(*runner, 5));
        QCOMPARE(reported("behind life"), 0); // only when asked
        QVERIFY(reload(*runner));
        QVERIFY2(reported("behind life 1 pace 0.2") == 1 && reported("behind life 2 pace 0.2") == 1,
                 qPrintable(m_console.join('\n')));
        QCOMPARE(reported("has the new code of"), 2);
        QVERIFY(tick(*runner, 44));
        QCOMPARE(runner->world().ticks(), 100u);
        QVERIFY(runner->stoppedControllers().empty());
        const std::uint64_t hash = runner->world().stateHash();
        runner = makeRunner(); // these controllers drive nowhere, so poses and time are those of an undisturbed run
        QVERIFY(runner && tick(*runner, 100));
        QCOMPARE(runner->world().stateHash(), hash);
    }

    void anotherControllerTakesThePlace_data() {
        QTest::addColumn<QByteArray>("isolation");
        for (const char* isolation : {"none", "module", "robot"}) QTest::newRow(isolation) << QByteArray(isolation);
    }
    /// A library, then a file in Python, then the library again, then no controller: the robot stays where it is.
    void anotherControllerTakesThePlace() {
        QFETCH(QByteArray, isolation);
        QVERIFY(QDir(m_folder.path()).mkpath("mine"));
        QVERIFY(writeFile(m_folder.filePath("mine/turner.py"), "import trundle\n\n\nclass Turner(trundle.Controller):\n"
                                                               "    \"\"\"Turns.\"\"\"\n"
                                                               "    turns = trundle.output(\"turns\", \"\", \"So far.\", type=int)\n\n"
                                                               "    def setup(self, robot):\n"
                                                               "        self.drive = robot.differential_drive(\"base\")\n"
                                                               "        self.calls = 0\n\n"
                                                               "    def update(self, since_last):\n"
                                                               "        self.calls += 1\n        self.turns = self.calls\n"
                                                               "        self.drive.move(0, 1)\n"));
        const QByteArray world = "Isolation = " + isolation +
                                 "\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                 "#loadModule controllers/linear_motion\n#loadModule turner.py\nStatic floor { Config=OpenFloor }\n";
        QVERIFY(runnerOf(world + "Robot a { Config=SimpleRobot Turner other { } }\n"));
        const ControllerSpec turner = m_loaded->experiment->robots.at(0).controllers.at(0);
        const std::string file = m_loaded->registry->find("Turner")->module;
        const std::unique_ptr<Runner> runner = runnerOf(world + "Robot a { Config=SimpleRobot LinearMotion brain { Distance=5 } }\n");
        QVERIFY(runner && tick(*runner, 100));
        const ControllerSpec ahead = m_loaded->experiment->robots.at(0).controllers.at(0);
        const std::string library = m_loaded->registry->find("LinearMotion")->module;
        const auto heading = [&] { return hprFromRotation(runner->world().robotPose(0).rotation).x(); };
        const auto way = [&] { return runner->world().robotPose(0).position.norm(); };
        const double first = way();
        QVERIFY(first > 0.05 && std::abs(heading()) < 1e-3);

        runner->command(SwapCommand{"a", "brain", turner, file});
        QVERIFY2(tick(*runner, 100), qPrintable(m_console.join('\n')));
        QVERIFY2(reported("a: the controller other is Turner now") == 1, qPrintable(m_console.join('\n')));
        QVERIFY2(heading() > 0.5, qPrintable(QString::number(heading())));
        const double turned = heading();
        runner->command(SwapCommand{"a", "other", ahead, library});
        QVERIFY(tick(*runner, 100));
        QVERIFY(way() > first + 0.05);
        QVERIFY(heading() < turned + 0.2); // it drives where it looks
        QCOMPARE(runner->controllerCosts().size(), std::size_t(1));
        runner->command(SwapCommand{"a", "brain", {}, {}});
        QVERIFY(tick(*runner, 100));
        const double end = way();
        QVERIFY(tick(*runner, 50));
        QVERIFY(std::abs(way() - end) < 1e-3);
        QVERIFY(runner->stoppedControllers().empty());
        QVERIFY(runner->controllerCosts().empty());
    }

    void newCodeContinuesFromTheStateOfTheOld_data() {
        QTest::addColumn<QByteArray>("state"); // of robot a; b saves its own
        QTest::addColumn<QString>("message");
        QTest::addColumn<int>("lives"); // setups of a after the reload
        QTest::newRow("saved") << QByteArray("saved") << "a: behind continues from before after 50 of 17" << 1;
        QTest::newRow("none") << QByteArray("none") << "" << 1;
        QTest::newRow("save throws")
            << QByteArray("throws")
            << "a: no state is handed over: the controller Rebuilt of a failed in saveState: nothing is saved" << 1;
        QTest::newRow("load throws")
            << QByteArray("refused")
            << "a: the state of the old code is not used: the controller Rebuilt of a failed in loadState: too old" << 2;
    }
    void newCodeContinuesFromTheStateOfTheOld() {
        QFETCH(QByteArray, state);
        QFETCH(QString, message);
        QFETCH(int, lives);
        QVERIFY(build("before", "before"));
        const std::unique_ptr<Runner> runner = makeRunner(state);
        QVERIFY(runner && tick(*runner, 50));
        QVERIFY(build("before", "behind"));
        QVERIFY(reload(*runner));
        const QString all = m_console.join('\n');
        QVERIFY2(message.isEmpty() || reported(message) == 1, qPrintable(all));
        QCOMPARE(m_console.filter(QRegularExpression("^a: behind life")).size(), lives);
        QVERIFY2(reported("b: behind continues from before after 50 of 17") == 1, qPrintable(all));
        QCOMPARE(reported("continues from"), state == "saved" ? 2 : 1);
        QVERIFY(tick(*runner, 10) && runner->stoppedControllers().empty());
    }

    /// Its process is shared, so what the others had stored is lost too.
    void aCrashInSaveStateLosesTheState() {
        QVERIFY(build("before", "before"));
        const std::unique_ptr<Runner> runner = makeRunner("crashes");
        QVERIFY(runner && tick(*runner, 50));
        QVERIFY(build("before", "behind"));
        QVERIFY(reload(*runner));
        QVERIFY2(reported("a: no state is handed over: ") == 1 && reported("crashed in saveState") >= 1,
                 qPrintable(m_console.join('\n')));
        QCOMPARE(reported("has the new code of"), 2);
        QVERIFY(tick(*runner, 10) && runner->stoppedControllers().empty());
        QCOMPARE(runner->world().ticks(), 61u);
    }

    void aPythonFileContinuesFromItsStateToo() {
        const auto code = [](const QByteArray& word, const QByteArray& load) {
            return "import trundle\n\n\nclass Mind(trundle.Controller):\n    updates = 0\n\n    def update(self, since_last):\n"
                   "        self.updates += 1\n\n    def save_state(self):\n        return {\"of\": \"" +
                   word + "\", \"updates\": self.updates}\n\n    def load_state(self, state):\n        " + load + "\n";
        };
        const QString file = m_folder.filePath("mine/own.py");
        QDir(m_folder.path()).mkpath("mine");
        QVERIFY(writeFile(file, code("first", "pass")));
        const std::unique_ptr<Runner> runner =
            runnerOf("#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule mine/own.py\n"
                     "Static floor { Config=OpenFloor }\nRobot a { Config=SimpleRobot Pos=0,0,0.1 Mind brain { } }\n");
        QVERIFY(runner && tick(*runner, 50));
        QVERIFY(writeFile(file, code("second", "self.print(state['of'], ' ', state['updates'])")));
        runner->command(ReloadCommand{});
        QVERIFY(tick(*runner, 10));
        QVERIFY2(reported("a: first 50") == 1, qPrintable(m_console.join('\n')));
        QVERIFY(writeFile(file, code("third", "raise KeyError('of')")));
        runner->command(ReloadCommand{});
        QVERIFY(tick(*runner, 10) && runner->stoppedControllers().empty());
        QVERIFY2(
            reported("the state of the old code is not used: the controller Mind of a failed in load_state: KeyError: 'of'") == 1,
            qPrintable(m_console.join('\n')));
    }

    void aBadLibraryIsRefusedAndTheOldCodeGoesOn() {
        QVERIFY(build("before", "before"));
        const std::unique_ptr<Runner> runner = makeRunner();
        QVERIFY(runner && tick(*runner, 10));
        for (const double part : {0.0, 0.1, 0.5, 0.99}) {
            QVERIFY(build("before", "behind", part));
            QVERIFY(reload(*runner));
        }
        QCOMPARE(reported("continues with its old code"), 4);
        QVERIFY(build("after", "after"));
        QVERIFY(reload(*runner));
        QVERIFY2(m_console.last().contains("has other properties or published values now"), qPrintable(m_console.last()));
        QCOMPARE(reported("life"), 2);
        QVERIFY(runner->stoppedControllers().empty());
        QVERIFY(build("before", "behind"));
        QVERIFY(reload(*runner));
        QCOMPARE(reported("behind life"), 2);
    }

    void reloadsLeaveNothingBehind() {
        QVERIFY(build("before", "before"));
        const std::unique_ptr<Runner> runner = makeRunner();
        QVERIFY(runner && tick(*runner, 1) && reload(*runner));
        const QString before = resources();
        QVERIFY2(before.endsWith(" 1 children"), qPrintable(before));
        const int count = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 1000 : 20;
        for (int i = 0; i < count; ++i) QVERIFY(reload(*runner));
        QCOMPARE(resources(), before);
        QCOMPARE(reported("has the new code of"), 2 * (count + 1));
    }
};

QTEST_GUILESS_MAIN(ReloadTest)
#include "reload_test.moc"
