// A module that is rebuilt while its controllers run in a process of their own: the robots get the new code where they are.
#include <QDir>
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
    std::unique_ptr<Runner> makeRunner() {
        m_console.clear();
        const QString path = m_folder.filePath("reload.sim");
        OpenOptions options;
        options.modules = {m_folder.filePath("mine").toStdString()};
        if (!writeFile(path, "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule mine/mind\n"
                             "Static floor { Config=OpenFloor }\n"
                             "Robot a { Config=SimpleRobot Pos=0,0,0.1 Rebuilt brain { } }\nRobot b { Config=SimpleRobot "
                             "Pos=0,2,0 Rebuilt brain { } }\n"))
            return nullptr;
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
        QVERIFY2(reported("behind life 1 pace 0.2") == 1 && reported("behind life 2 pace 0.2") == 1, qPrintable(m_console.join('\n')));
        QCOMPARE(reported("has the new code of"), 2);
        QVERIFY(tick(*runner, 44));
        QCOMPARE(runner->world().ticks(), 100u);
        QVERIFY(runner->stoppedControllers().empty());
        const std::uint64_t hash = runner->world().stateHash();
        runner = makeRunner(); // these controllers drive nowhere, so poses and time are those of an undisturbed run
        QVERIFY(runner && tick(*runner, 100));
        QCOMPARE(runner->world().stateHash(), hash);
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
