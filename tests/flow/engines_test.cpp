// Engine = wheeled and planar through the program: shipped experiments do what they do in the general engine, what does not fit is refused at
// its place, and auto chooses.

#include <QThread>

#include "flow/cli.h"

namespace {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRUNDLE_SANITIZED
#endif
#endif
#ifdef TRUNDLE_SANITIZED
constexpr bool kSanitized = true; // the shadow memory of sanitizers exceeds any limit
#else
constexpr bool kSanitized = false;
#endif

QJsonObject run(const QString& experiment, const QString& engine, const QString& seconds, const QStringList& more = {}) {
    QTemporaryDir logs;
    const QString file = experiment.startsWith('/') ? experiment : configPath("experiments/" + experiment);
    const Outcome outcome = cli(
        QStringList{"run", file, "--set", "Engine=" + engine, "--duration", seconds, "--json", "--log-dir", logs.path()} + more);
    if (outcome.code != 0) qWarning("%s", shown(outcome).constData());
    return QJsonDocument::fromJson(outcome.out).object();
}

QJsonArray poseOf(const QJsonObject& run, const QString& robot) {
    return run["robots"].toObject()[robot].toObject()["pos"].toArray();
}

double apart(const QJsonArray& a, const QJsonArray& b) {
    return std::hypot(a[0].toDouble() - b[0].toDouble(), a[1].toDouble() - b[1].toDouble());
}

} // namespace

class EnginesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString write(const QByteArray& text) {
        const QString file = m_folder.filePath("world.sim");
        return writeFile(file, text) ? file : QString();
    }

private Q_SLOTS:
    /// Heavy robots whose wheels slip while their motors are at their limits, which short ticks make more likely: a square with turns
    /// on the spot, of a robot as the wizard makes it.
    void slipsAlike_data() {
        QTest::addColumn<QString>("base");
        QTest::addColumn<QString>("mass");
        QTest::addColumn<QString>("tick");
        for (const char* tick : {"0.002", "0.005", "0.01"})
            for (const char* mass : {"10", "60"})
                QTest::addRow("skid-steer, %s kg, %s s", mass, tick) << "skid-steer" << mass << tick;
        QTest::newRow("differential, 60 kg, 0.005 s") << "differential"
                                                      << "60"
                                                      << "0.005";
    }
    void slipsAlike() {
        QFETCH(QString, base);
        QFETCH(QString, mass);
        QFETCH(QString, tick);
        const QTemporaryDir folder;
        const Outcome made = cli({"new", "robot", "Hauler", "--in", folder.path(), "--base", base, "--mass", mass,
                                  "--wheel-radius", "0.1", "--top-speed", "1.5", "--length", "0.7", "--width", "0.5"});
        QVERIFY2(made.code == 0, shown(made));
        const QString file = folder.filePath("hauler/hauler_square.sim");
        const QStringList more{"--trust", "--set", "Tick=" + tick};
        const QJsonObject general = run(file, "general", "10", more);
        for (const char* engine : {"wheeled", "planar"}) {
            const QJsonObject other = run(file, engine, "10", more);
            for (const QString& robot : general["robots"].toObject().keys()) {
                const double off = apart(poseOf(general, robot), poseOf(other, robot));
                QVERIFY2(off < 0.005, qPrintable(QString("%1: %2 m").arg(engine).arg(off)));
            }
            QVERIFY(!general["robots"].toObject().isEmpty());
        }
    }

    void drivesAlike_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("seconds");
        QTest::addColumn<double>("mostMm"); // in either engine
        QTest::newRow("straight") << "linear_motion.sim"
                                  << "robot0"
                                  << "8" << 0.1;
        QTest::newRow("a circle") << "arc_motion.sim"
                                  << "robot0"
                                  << "10" << 0.5;
        QTest::newRow("by radio") << "directional_antenna.sim"
                                  << "robot0"
                                  << "14" << 1.0;
        QTest::newRow("among motes") << "sensor_network_amr.sim"
                                     << "robot0"
                                     << "20" << 1.0;
        QTest::newRow("along a wall, by lidar") << "wall_follow.sim"
                                                << "seeker_0"
                                                << "12" << 20.0;
        QTest::newRow("towards light") << "braitenberg.sim"
                                       << "seeker_0"
                                       << "8" << 20.0;
        QTest::newRow("along a line") << "line_follow.sim"
                                      << "seeker_0"
                                      << "8" << 20.0;
    }
    void drivesAlike() {
        QFETCH(QString, file);
        QFETCH(QString, robot);
        QFETCH(QString, seconds);
        QFETCH(double, mostMm);
        const QJsonObject general = run(file, "general", seconds);
        QCOMPARE(general["engine"].toString(), "general");
        for (const char* engine : {"wheeled", "planar"}) {
            const QJsonObject other = run(file, engine, seconds);
            QCOMPARE(other["engine"].toString(), engine);
            QVERIFY(other["ended"].toArray().isEmpty());
            const QJsonArray a = poseOf(general, robot), b = poseOf(other, robot);
            QVERIFY(a.size() == 3 && b.size() == 3);
            qInfo("%s: %.3f mm apart", engine, 1e3 * apart(a, b));
            QVERIFY(1e3 * apart(a, b) < mostMm);
        }
    }

    /// Of robots that wander and bump, the numbers of contacts and of metres are alike, not the paths.
    void bumpsAlike() {
        const QByteArray text =
            "#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\n#loadModule controllers/bump_and_turn\n"
            "Static arena { Config=MediumArena }\nRobot r { Config=SimpleRobot Pos=0.3,0.2,0 BumpAndTurn b { Speed=0.3 } }\n"
            "PoseLog log { Robot=r Interval=0.1 File=path.csv }\n";
        const QString file = write(text);
        const int seeds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 100 : 8;
        const char* const engines[3] = {"Engine=general", "Engine=wheeled", "Engine=planar"};
        double metres[3] = {0, 0, 0}, turns[3] = {0, 0, 0};
        for (int engine = 0; engine < 3; ++engine)
            for (int seed = 1; seed <= seeds; ++seed) {
                QTemporaryDir logs;
                const Outcome outcome = cli({"run", file, "--set", engines[engine], "--seed", QString::number(1000 + seed),
                                             "--duration", "60", "--quiet", "--log-dir", logs.path()});
                QVERIFY2(outcome.code == 0, shown(outcome));
                const QList<QByteArray> lines = contentOf(logs.filePath("path.csv")).split('\n');
                const QList<QByteArray> names = lines[0].split(',');
                const auto column = [&](const char* name) { return names.indexOf(QByteArray(name)); };
                const auto x = column("x [m]"), y = column("y [m]"), heading = column("heading [deg]");
                QVERIFY2(x >= 0 && y >= 0 && heading >= 0, lines[0]);
                for (qsizetype i = 2; i + 1 < lines.size(); ++i) {
                    const auto a = lines[i - 1].split(','), b = lines[i].split(',');
                    metres[engine] += std::hypot(b[x].toDouble() - a[x].toDouble(), b[y].toDouble() - a[y].toDouble());
                    turns[engine] += std::abs(std::remainder(b[heading].toDouble() - a[heading].toDouble(), 360.0)) / 360;
                }
            }
        for (int engine = 0; engine < 3; ++engine)
            qInfo("%s: %.3f m and %.3f turns", engines[engine], metres[engine], turns[engine]);
        for (const int engine : {1, 2}) {
            const double few = engine == 1 ? 1 : 2; // chance: the paths part at the first bump
            QVERIFY(std::abs(metres[engine] / metres[0] - 1) < (seeds > 50 ? 0.01 : 0.05 * few));
            QVERIFY(std::abs(turns[engine] / turns[0] - 1) < (seeds > 50 ? 0.05 : 0.2 * few));
        }
    }

    void tasksSucceed_data() {
        QTest::addColumn<QString>("engine");
        for (const char* engine : {"wheeled", "planar"}) QTest::newRow(engine) << engine;
    }
    void tasksSucceed() {
        QFETCH(QString, engine);
        const QJsonObject light = run("braitenberg.sim", engine, "60"), map = run("lidar_map.sim", engine, "300");
        QCOMPARE(light["finished"].toObject()["reason"].toString(), "reached the light");
        QCOMPARE(map["finished"].toObject()["reason"].toString(), "mapped");
    }

    /// Again, and on any number of threads.
    void sameHash() {
        for (const char* engine : {"Engine=wheeled", "Engine=planar"}) {
            QSet<QByteArray> hashes;
            for (const char* threads : {"Threads=1", "Threads=1", "Threads=2", "Threads=5"})
                hashes << cli({"run", configPath("experiments/swarm.sim"), "--set", engine, "--set", threads, "--duration", "3",
                               "--quiet", "--hash", "--log-dir", m_folder.path()})
                              .out;
            QVERIFY(hashes.size() == 1 && hashes.begin()->startsWith("state-hash"));
        }
    }

    void refuses() {
        const QString file = configPath("experiments/collect.sim");
        for (const char* engine : {"wheeled", "planar"}) {
            const QByteArray name = QByteArray("Engine = ") + engine + " is not possible";
            const Outcome outcome =
                cli({"run", file, "--set", QString("Engine=") + engine, "--duration", "1", "--log-dir", m_folder.path()});
            QVERIFY(outcome.code != 0);
            QVERIFY2(outcome.err.contains("research_base.sim:") && outcome.err.contains("the Slider rail"), shown(outcome));
            QVERIFY2(outcome.err.contains(name), shown(outcome));
        }
        const QJsonObject chosen = run("collect.sim", "auto", "0.1"), fitting = run("swarm.sim", "auto", "0.1");
        QCOMPARE(chosen["engine"].toString(), "general");
        QVERIFY2(chosen["engine_reason"].toString().contains("the Slider rail"), qPrintable(chosen["engine_reason"].toString()));
        QCOMPARE(fitting["engine"].toString(), "wheeled");
        QVERIFY(!fitting.contains("engine_reason"));
        const Outcome summary = cli({"run", file, "--set", "Engine=auto", "--duration", "0.1", "--log-dir", m_folder.path()});
        QVERIFY2(summary.out.contains("engine      general") && summary.out.contains("not wheeled: "), shown(summary));
    }

    /// What only the general engine has: auto takes that one, and the others name the place.
    void refusesSurfacesAndSensors_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("said");
        const QByteArray floor = "Surface dryFloor { Friction=1 }\nSurface runner { Friction=0.05 Friction2=0.6 }\nSurface "
                                 "wetFloor { Friction=0.1 }\n"
                                 "Static floor { Config=F }\n",
                         robot = "Robot r { Config=SimpleRobot }\n";
        QTest::newRow("two floors")
            << floor + robot +
                   "StaticConfig F { Box dry { Size=9,9,1 Pos=0,0,-0.5 Surface=dryFloor } Box wet { Size=9,9,1 "
                   "Pos=9,0,-0.5 Surface=wetFloor } }\n"
            << QByteArray("floor: geom wet is level with the rest of the ground and has another surface");
        QTest::newRow("Friction2 of the floor") << floor + robot + "StaticConfig F { Plane ground { Surface=runner } }\n"
                                                << QByteArray("floor: geom ground has a surface with a Friction2");
        const QByteArray plain = floor + "StaticConfig F { Plane ground { Surface=dryFloor } }\n";
        QTest::newRow("Friction2 of a thing") << plain + robot +
                                                     "RobotConfig C { Body b { Box x { Size=0.2,0.2,0.2 Pos=0,0,0.1 Mass=1 "
                                                     "Surface=runner } } }\nRobot c { Config=C Pos=2,0,0 }\n"
                                              << QByteArray("c: geom x has a surface with a Friction2");
        QTest::newRow("a force sensor")
            << plain + "RobotConfig K { Config=SimpleRobot Body plate { Pos=0,0,0.3 Box p { Size=0.05,0.05,0.01 Mass=0.01 } } "
                       "Fixed mount { Parent=chassis Child=plate } ForceSensor cell { Joint=mount Body=plate } }\nRobot r { "
                       "Config=K }\n"
            << QByteArray("cell is a ForceSensor, which measures in a joint");
    }
    void refusesSurfacesAndSensors() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, said);
        const QString file = write("#import robots/simple_robot.sim\n" + text);
        QCOMPARE(run(file, "auto", "0.1")["engine"].toString(), "general");
        const Outcome refused = cli({"run", file, "--set", "Engine=wheeled", "--duration", "0.1", "--log-dir", m_folder.path()});
        QVERIFY2(refused.code == 1 && refused.err.contains(said), shown(refused));
    }

    void takesThreadsForManyRobots() {
        const auto threads = [](const QString& experiment, const QStringList& more) {
            return run(experiment, "general", "0.1", more)["threads"].toInt();
        };
        QCOMPARE(threads("swarm.sim", {}), std::clamp(QThread::idealThreadCount(), 1, 8));
        QCOMPARE(threads("linear_motion.sim", {}), 1);
        QCOMPARE(threads("linear_motion.sim", {"--set", "Threads=3"}), 3);
        QCOMPARE(threads(write("#import robots/tmote_sky.sim\nGrid motes { Config=TmoteSky Count=8,8 Spacing=1 }\n"), {}),
                 1); // without wheels
        QCOMPARE(run("swarm.sim", "wheeled", "0.1", {"--set", "Threads=5"})["threads"].toInt(), 5);
    }

    void reportsThatMemoryIsShort() {
        if (kSanitized) return;
        const QString file =
            write("#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                  "Grid crowd { Config=SimpleRobot Count=90,90 Spacing=1 }\n");
        const Outcome outcome =
            callProgram("/bin/sh", {"-c", "ulimit -v 300000; exec \"$0\" run \"$1\" --duration 0.1 --json", programPath(), file});
        QVERIFY2(outcome.code == 1, shown({outcome.code, outcome.out.left(2000), outcome.err.left(2000)}));
        QVERIFY2(outcome.err.contains("there is not enough memory") && !outcome.err.contains("bad_alloc"),
                 outcome.err.right(2000));
        const QJsonArray messages = QJsonDocument::fromJson(outcome.out).object()["diagnostics"].toArray();
        QVERIFY2(messages.last().toObject()["message"].toString().contains("there is not enough memory"), outcome.out.left(2000));
    }
};

QTEST_GUILESS_MAIN(EnginesTest)
#include "engines_test.moc"
