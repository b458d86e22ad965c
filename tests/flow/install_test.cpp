// `cmake --install`, then what a person does who has only the installed tree: build a controller from a copy of the template, run it, give
// the built library away.

#include "flow/cli.h"

class InstallTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        const Outcome installed = callProgram("cmake", {"--install", TRUNDLE_BINARY_DIR, "--prefix", prefix()});
        QVERIFY2(installed.code == 0, shown(installed));
        QVERIFY(QDir().mkpath(at("mine")));
        for (const char* name : {"CMakeLists.txt", "my_controller.cpp"})
            QVERIFY(QFile::copy(prefix("share/trundle/template/") + name, at("mine/") + name));
        const QByteArray robot = "Robot r { Config=SimpleRobot MyController brain { Speed=0.3 TurnRate=0 } }\n";
        QVERIFY(writeFile(at("circle.sim"), "Duration = 2\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                            "#loadModule template\nStatic floor { Config=OpenFloor }\n" +
                                                robot));
    }

    /// The programs use the files installed beside them, not those of the source tree.
    void findsItsOwnFiles() {
        QVERIFY(writeFile(prefix("share/trundle/configs/arenas/only_installed.sim"),
                          "StaticConfig OnlyInstalled { Plane floor { } }\n"));
        QVERIFY(
            writeFile(at("own.sim"), "Duration = 1\n#import arenas/only_installed.sim\nStatic floor { Config=OnlyInstalled }\n"));
        const Outcome own = installedCli({"run", at("own.sim")});
        QVERIFY2(own.code == 0, shown(own));
        QVERIFY(cli({"run", at("own.sim")}).code == 1);
    }

    /// Modules and pictures are installed too.
    void runsAndDrawsASample() {
        const QString sample = prefix("share/trundle/configs/experiments/linear_motion.sim"), picture = at("sample.png");
        const Outcome run = installedCli({"run", sample, "--log-dir", at("logs")});
        QVERIFY2(run.code == 0, shown(run));
        const Outcome drawn = installedCli({"render", sample, "--at", "1", "-o", picture});
        QVERIFY2(drawn.code == 0 && contentOf(picture).startsWith("\x89PNG"), shown(drawn));
    }

    void buildsTheTemplate_data() {
        QTest::addColumn<QString>("package");
        QTest::newRow("from the installed package") << prefix();
        QTest::newRow("from the build folder") << QStringLiteral(TRUNDLE_BINARY_DIR "/sdk");
    }
    /// Without a warning; the program that describes it is found with the package.
    void buildsTheTemplate() {
        QFETCH(QString, package);
        const QString folder = at(QTest::currentDataTag());
        const Outcome configured =
            callProgram("cmake", {"-S", at("mine"), "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                                  "-DCMAKE_PREFIX_PATH=" + package, "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic"});
        QVERIFY2(configured.code == 0, shown(configured));
        const Outcome built = callProgram("cmake", {"--build", folder});
        QVERIFY2(built.code == 0 && !built.out.contains("warning"), shown(built));
        const Outcome run = installedCli({"run", at("circle.sim"), "--modules", folder, "--json"});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonValue driven = QJsonDocument::fromJson(run.out)["robots"]["r"]["pos"][0];
        QVERIFY2(std::abs(driven.toDouble() - 0.6) < 0.1, shown(run)); // 2 s at 0.3 m/s
    }

    /// The library and its description are all that another machine needs.
    void givesTheLibraryAway() {
        QVERIFY(QDir().mkpath(at("given")));
        for (const char* name : {"libtemplate.so", "libtemplate.so.kinds.json"})
            QVERIFY(QFile::copy(at("from the installed package/") + name, at("given/") + name));
        QVERIFY(QDir(at("mine")).removeRecursively() && QDir(at("from the installed package")).removeRecursively());
        const QStringList run{"run", at("circle.sim"), "--modules", at("given")};
        QVERIFY2(installedCli(run).code == 0, shown(installedCli(run)));
        const Outcome faulty = installedCli(run + QStringList{"--set", "r.brain.Speed=9"});
        QVERIFY2(faulty.code == 1 && faulty.err.contains("Speed"), shown(faulty)); // from the description
    }

private:
    [[nodiscard]] QString at(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString prefix(const QString& name = {}) const { return m_folder.filePath("prefix/" + name); }
    [[nodiscard]] Outcome installedCli(const QStringList& arguments) const {
        return callProgram(prefix("bin/trundle-cli"), arguments);
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(InstallTest)
#include "install_test.moc"
