// `cmake --install`, then what a person does who has only the installed tree: build a controller from a copy of the template, run it, give
// the built library away.

#include "flow/cli.h"

class InstallTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        const Outcome installed = callProgram("cmake", {"--install", TRUNDLE_BINARY_DIR, "--prefix", prefix()});
        QVERIFY2(installed.code == 0, shown(installed));
        const QByteArray robots =
            "Robot r { Config=SimpleRobot WallRun brain { Speed=0.3 TurnRate=0 } }\n"
            "RobotConfig Scout { Body chassis { Box b { Material=red Size=0.1,0.1,0.1 Pos=0,0,0.1 Mass=1 } } "
            "FrontSonar eye { Body=chassis Pos=0,0,0.1 } }\n"
            "Robot s { Config=Scout Pos=0,2,0 }\nSignalLog seen { Signals=s/eye/distance }\n";
        QVERIFY(writeFile(at("circle.sim"), "Duration = 2\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
                                            "#loadModule wall_run\n#loadModule front_sonar\nStatic floor { Config=OpenFloor }\n" +
                                                robots));
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

    void startsModules_data() {
        QTest::addColumn<bool>("installed");
        QTest::newRow("installed") << true;
        QTest::newRow("in the build folder") << false;
    }
    /// What `new` writes builds without a warning, by the printed commands, and runs as printed.
    void startsModules() {
        QFETCH(bool, installed);
        const QString folder = at("my 'own' " + QString(QTest::currentDataTag()));
        QVERIFY(QDir().mkpath(folder));
        for (const QStringList& what : {QStringList{"controller", "WallRun"}, {"component", "FrontSonar"}}) {
            const QStringList words = QStringList{"new"} + what + QStringList{"--in", folder};
            const Outcome made = installed ? installedCli(words) : cli(words);
            QVERIFY2(made.code == 0 && made.out.startsWith("wrote "), shown(made));
            QStringList commands;
            for (const QString& line : QString::fromUtf8(made.out).split('\n'))
                if (line.startsWith("  cmake ")) commands += line.trimmed();
            QCOMPARE(commands.size(), 2);
            commands[0] += " -G Ninja -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic'";
            for (const QString& command : commands) {
                const Outcome built = callProgram("sh", {"-c", command});
                QVERIFY2(built.code == 0 && !built.out.contains("warning") && !built.err.contains("warning"), shown(built));
            }
        }
        const QString text = QString::fromUtf8(contentOf(at("circle.sim")));
        QVERIFY(
            writeFile(folder + "/circle.sim", QString(text)
                                                  .replace("#loadModule wall_run", "#loadModule wall_run/build/wall_run")
                                                  .replace("#loadModule front_sonar", "#loadModule front_sonar/build/front_sonar")
                                                  .toUtf8()));
        const Outcome run = installedCli({"run", folder + "/circle.sim", "--trust", "--json"});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonValue driven = QJsonDocument::fromJson(run.out)["robots"]["r"]["pos"][0];
        QVERIFY2(std::abs(driven.toDouble() - 0.6) < 0.1, shown(run)); // 2 s at 0.3 m/s
        const QList<QByteArray> rows = contentOf(folder + "/logs/circle/seen.csv").trimmed().split('\n');
        QVERIFY2(rows.size() > 2 && rows.last().endsWith(",2"), rows.last().constData()); // nothing is nearer than MaxRange
    }

    /// The sources that the guide shows are built in place of those of the templates: without a warning, and they do what it says.
    void sourcesOfTheGuideBuild() {
        const QString folder = at("guide");
        QVERIFY(QDir().mkpath(folder));
        int built = 0;
        for (const char* page : {"controllers.md", "components.md"}) {
            const QString text = QString::fromUtf8(contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/resources/guide/") + page));
            for (const QString& part : text.split("```cpp\n").mid(1)) {
                const QString source = part.section("```", 0, 0), name = source.section("struct ", 1, 1).section(' ', 0, 0);
                const QString what = source.contains("trundle/controller.h") ? "controller" : "component";
                const Outcome made = installedCli({"new", what, name, "--in", folder});
                QVERIFY2(made.code == 0, shown(made));
                const QString file =
                    QString::fromUtf8(made.out).section("wrote ", 1).section('\n', 0, 0).split(' ').filter(".cpp").value(0);
                QVERIFY2(QFile::exists(file) && writeFile(file, source.toUtf8()), shown(made));
                const QString at = QFileInfo(file).path();
                const Outcome configured =
                    callProgram("cmake", {"-S", at, "-B", at + "/build", "-G", "Ninja", "-DCMAKE_PREFIX_PATH=" + prefix(),
                                          "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic"});
                QVERIFY2(configured.code == 0, shown(configured));
                const Outcome compiled = callProgram("cmake", {"--build", at + "/build"}, {}, 600);
                QVERIFY2(compiled.code == 0 && !compiled.out.contains("warning"), name.toUtf8() + shown(compiled));
                ++built;
            }
        }
        QCOMPARE(built, 3);
        QVERIFY(writeFile(folder + "/push.py", "import trundle\n\n\nclass Push(trundle.Controller):\n    \"\"\"Pushes.\"\"\"\n\n"
                                               "    def setup(self, robot):\n        self.engine = robot.port(\"engine\")\n\n"
                                               "    def update(self, since_last):\n        self.engine.set(\"force\", 2)\n"));
        QVERIFY(writeFile(
            folder + "/all.sim",
            "Duration = 1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule circler/build/circler\n"
            "#loadModule front_sonar/build/front_sonar\n#loadModule thruster/build/thruster\n#loadModule push.py\n"
            "RobotConfig Puck { Body hull { Box box { Size=0.2,0.2,0.1 Pos=0,0,0.06 Mass=1 Material=red Surface=slick } }\n"
            "  FrontSonar eye { Body=hull Pos=0.1,0,0.06 MaxRange=3 }  Thruster engine { Body=hull MaxForce=1.5 } }\n"
            "Static floor { Config=OpenFloor }\nRobot round { Config=SimpleRobot Pos=0,3,0 Circler brain { Speed=0.3 } }\n"
            "Robot puck { Config=Puck Push brain { } }\nRobot wall { Config=Puck Pos=2,0,0 }\n"));
        const Outcome run = installedCli({"run", folder + "/all.sim", "--trust", "--json"});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonValue robots = QJsonDocument::fromJson(run.out)["robots"];
        const QJsonValue signal = robots["puck"]["signals"];
        QCOMPARE(signal["engine/thrust"].toDouble(), 1.5);
        QVERIFY2(robots["puck"]["pos"][0].toDouble() > 0.1, shown(run));
        const double gap = 2 - 0.2 - robots["puck"]["pos"][0].toDouble();
        QVERIFY2(std::abs(signal["eye/distance"].toDouble() - gap) < 0.05, shown(run));
        QVERIFY2(robots["round"]["pos"][0].toDouble() > 0.1, shown(run));
    }

    void startsPythonController() {
        const QString folder = at("snakes");
        QVERIFY(QDir().mkpath(folder));
        const Outcome made = installedCli({"new", "controller", "WallRun", "--python", "--in", folder});
        QVERIFY2(made.code == 0 && !made.out.contains("cmake"), shown(made));
        QByteArray text = contentOf(at("circle.sim"));
        text = text.left(text.indexOf("RobotConfig Scout")).replace("#loadModule wall_run", "#loadModule wall_run/wall_run.py");
        QVERIFY(made.out.contains("#loadModule wall_run/wall_run.py\n"));
        QVERIFY(writeFile(folder + "/circle.sim", text.replace("#loadModule front_sonar\n", "")));
        const Outcome run = installedCli({"run", folder + "/circle.sim", "--trust", "--json"});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonValue driven = QJsonDocument::fromJson(run.out)["robots"]["r"]["pos"][0];
        QVERIFY2(std::abs(driven.toDouble() - 0.6) < 0.1, shown(run));
    }

    void startsPythonComponent() {
        const QString folder = at("snakes");
        QVERIFY(QDir().mkpath(folder));
        const Outcome made = installedCli({"new", "component", "Whisker", "--python", "--in", folder});
        QVERIFY2(made.code == 0 && made.out.contains("#loadModule whisker/whisker.py\n"), shown(made));
        QVERIFY(writeFile(folder + "/whisker.sim",
                          "Duration = 0.1\n#loadModule whisker/whisker.py\nRobotConfig R { Body b { Box hull { "
                          "Size=0.1,0.1,0.1 Mass=1 } }\n  Whisker eye { Body=b MaxRange=3 } }\nRobot r { Config=R }\n"));
        const Outcome run = installedCli({"run", folder + "/whisker.sim", "--trust", "--json"});
        QVERIFY2(run.code == 0 && QJsonDocument::fromJson(run.out)["robots"]["r"]["signals"]["eye/distance"].toDouble() == 3,
                 shown(run));
    }

    void refusesNewModules_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("why");
        const QString folder = at("my 'own' installed");
        QTest::newRow("folder exists") << QStringList{"controller", "WallRun", "--in", folder} << QByteArray("it exists");
        QTest::newRow("small letter") << QStringList{"controller", "wallRun"} << QByteArray("a capital letter");
        QTest::newRow("a robot in Python") << QStringList{"robot", "Wall", "--python"}
                                           << QByteArray("only controllers and components");
        QTest::newRow("a path") << QStringList{"component", "../Wall"} << QByteArray("a capital letter");
        QTest::newRow("built-in kind") << QStringList{"component", "Lidar"} << QByteArray("has a kind Lidar");
        QTest::newRow("kind of a shipped module")
            << QStringList{"controller", "WallFollow"} << QByteArray("has a kind WallFollow");
        QTest::newRow("no such word") << QStringList{"gadget", "Wall"} << QByteArray("controller");
        QTest::newRow("no such folder") << QStringList{"controller", "Wall", "--in", at("none")} << QByteArray("none");
    }
    void refusesNewModules() {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, why);
        const Outcome refused = installedCli(QStringList{"new"} + words);
        QVERIFY2(refused.code == 2 && refused.err.contains(why), shown(refused));
    }

    /// The library and its description are all that another machine needs.
    void givesTheLibraryAway() {
        QVERIFY(QDir().mkpath(at("given")));
        const QString folder = at("my 'own' installed/");
        for (const QString& name : {"wall_run", "front_sonar"})
            for (const char* file : {"/build/lib%1.so", "/build/lib%1.so.kinds.json"})
                QVERIFY(QFile::copy(folder + name + QString(file).arg(name),
                                    at("given/") + QString(file).arg(name).section('/', -1)));
        QVERIFY(QDir(folder).removeRecursively());
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
