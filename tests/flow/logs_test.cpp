// trundle-cli run: pose, energy and signal logs, and errors in their blocks.
#include "flow/cli.h"

class LogsFlowTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString experiment(const QByteArray& logs) {
        const QString path = m_folder.filePath("x.sim");
        return writeFile(
                   path,
                   "Tick = 0.01  Duration = 1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nStatic floor { "
                   "Config=OpenFloor }\n"
                   "Robot robot0 { Config=SimpleRobot Pos=0,0,0.1 }\nRobot robot1 { Config=SimpleRobot Pos=2,0,0 HPR=90,0,0 }\n" +
                       logs)
                   ? path
                   : QString();
    }
    QList<QByteArray> lines(const char* name) const { return contentOf(m_folder.filePath(QString("out/") + name)).split('\n'); }
    Outcome run(const QString& path) const { return cli({"run", path, "--quiet", "--log-dir", m_folder.filePath("out")}); }

private Q_SLOTS:
    void aPoseLogHasTheInitialStateAndARowPerInterval() {
        const Outcome done = run(experiment("PoseLog path { Robot=robot1 Interval=0.25 }\n"));
        QVERIFY2(done.code == 0, shown(done));
        const QList<QByteArray> rows = lines("path.csv");
        QCOMPARE(rows[0], QByteArray("time [s],robot,x [m],y [m],z [m],heading [deg],pitch [deg],roll [deg]"));
        QCOMPARE(rows[1], QByteArray("0,robot1,2,0,0,90,0,0"));
        QCOMPARE(rows.size(), 1 + 5 + 1); // 0, 0.25 .. 1, and the empty part after the last LF
        QVERIFY(rows[2].startsWith("0.25,robot1,"));
        QVERIFY(rows[5].startsWith("1,robot1,"));
        QVERIFY(!contentOf(m_folder.filePath("out/path.csv")).contains('\r'));
    }
    void aRunThatIsRefusedLeavesTheLastLogs() {
        const Outcome done = run(experiment("PoseLog path { Interval=0.1 }\n"));
        QVERIFY2(done.code == 0, shown(done));
        const QByteArray before = contentOf(m_folder.filePath("out/path.csv"));
        QVERIFY(before.count('\n') > 10);
        const Outcome refused = run(experiment("PoseLog path { Interval=0.1 }\nSignalLog s { Signals=robot0/nothing }\n"));
        QVERIFY2(refused.code != 0 && refused.err.contains("robot0/nothing"), shown(refused));
        QCOMPARE(contentOf(m_folder.filePath("out/path.csv")), before);
    }
    void twoRunsWriteTheSameBytes() {
        const QString path = experiment("PoseLog p { }\nContactLog c { }\nEnergyLog e { }\nSignalLog s { Signals=\"*\" }\n");
        QMap<QString, QByteArray> first;
        for (int time = 0; time < 2; ++time) {
            const Outcome done = run(path);
            QVERIFY2(done.code == 0, shown(done));
            for (const char* name : {"p.csv", "c.csv", "e.csv", "s.csv"}) {
                const QByteArray content = contentOf(m_folder.filePath(QString("out/") + name));
                QVERIFY(content.count('\n') > 100);
                if (time == 0) first[name] = content;
                QCOMPARE(content, first[name]);
            }
        }
    }
    void energyOnlyGetsLessAsARobotLands() {
        const Outcome done = run(experiment("EnergyLog e { Robot=robot0 Interval=0.5 }\n"));
        QVERIFY2(done.code == 0, shown(done));
        const QList<QByteArray> rows = lines("e.csv");
        const auto total = [&](int row) { return rows[row].split(',').value(4).toDouble(); };
        QVERIFY2(total(1) > total(2) && total(2) >= total(3) - 1e-6, rows[1] + "\n" + rows[2] + "\n" + rows[3]);
    }
    /// A device of a module and the controller that commands it through the port of the same table.
    void signalsOfAModulesTableAreLogged() {
        const QString path = m_folder.filePath("thruster.sim");
        QVERIFY(writeFile(path, "Tick = 0.01  Duration = 1  Gravity = 0,0,0\n#loadModule shared_table\nRobotConfig Probe { "
                                "Body hull { Sphere s { Radius=0.1 Mass=1 } } Thruster thruster { Body=hull } }\n"
                                "Robot probe { Config=Probe Pos=0,0,1 Pilot pilot { Speed=0.5 } }\n"
                                "SignalLog s { Signals=\"probe/thruster/*\",\"probe/pilot/*\" }\n"));
        const Outcome done =
            cli({"run", path, "--quiet", "--modules", QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/shared_table"),
                 "--log-dir", m_folder.filePath("out")});
        QVERIFY2(done.code == 0, shown(done));
        const QList<QByteArray> rows = lines("s.csv");
        QCOMPARE(rows[0],
                 QByteArray("time [s],probe/thruster/thrust [N],probe/thruster/speed/0 [m/s],probe/thruster/speed/1 [m/s],"
                            "probe/thruster/burning,probe/pilot/arrived"));
        QCOMPARE(rows[1], QByteArray("0,0,0,0,0,0"));
        QCOMPARE(rows[2], QByteArray("0.01,2,0.02,0,1,0")); // 2 N on 1 kg
        const QList<QByteArray> last = rows[rows.size() - 2].split(',');
        QVERIFY2(last[1] == "0" && std::abs(last[2].toDouble() - 0.5) < 0.03 && last[4] == "0" && last[5] == "1",
                 rows[rows.size() - 2]);
    }
    void reportsLogErrorsBeforeRun_data() {
        QTest::addColumn<QByteArray>("logs");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("unknown robot") << QByteArray("PoseLog p { Robot=robbot0 }\n") << QByteArray("robot0");
        QTest::newRow("unknown signal") << QByteArray("SignalLog s { Signals=robot0/leftEncoder/cuont }\n")
                                        << QByteArray("robot0/leftEncoder/count");
        QTest::newRow("a Grid's name") << QByteArray("Grid g { Config=SimpleRobot Pos=9,9,0 Count=2 Spacing=1 }   SignalLog s { "
                                                     "Signals=\"g/leftEncoder/count\" }\n")
                                       << QByteArray("g_*/leftEncoder/count");
        QTest::newRow("leaves the folder") << QByteArray("PoseLog p { File=\"../p.csv\" }\n") << QByteArray("E503");
        QTest::newRow("absolute") << QByteArray("PoseLog p { File=\"/tmp/p.csv\" }\n") << QByteArray("E503");
        QTest::newRow("two of one name") << QByteArray("PoseLog p { File=a.csv }\nEnergyLog e { File=a.csv }\n")
                                         << QByteArray("a.csv");
        QTest::newRow("no signals") << QByteArray("SignalLog s { }\n") << QByteArray("Signals");
    }
    void reportsLogErrorsBeforeRun() {
        QFETCH(QByteArray, logs);
        QFETCH(QByteArray, said);
        const Outcome done = run(experiment(logs));
        QVERIFY2(done.code == 1, shown(done));
        QVERIFY2(done.err.contains("x.sim:7:"), shown(done));
        QVERIFY2(done.err.contains(said), shown(done));
        QVERIFY(!QFileInfo::exists(m_folder.filePath("p.csv")));
        const Outcome checked = cli({"check", m_folder.filePath("x.sim")}); // the check reports the same without building a world
        QVERIFY2(checked.code == 1 && checked.err == done.err.left(checked.err.size()), shown(checked) + shown(done));
    }

    void aWrongLogHidesNoOtherProblem() {
        const QString path = m_folder.filePath("sunk.sim");
        QVERIFY(writeFile(
            path, "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                  "Robot r { Config=SimpleRobot Pos=0,0,-0.04 }\nPoseLog p { Robot=s }\nSignalLog q { Signals=\"r/speed\" }\n"));
        const Outcome checked = cli({"check", path});
        QVERIFY2(checked.code == 1 && checked.err.contains("no robot is called 's'"), shown(checked));
        QVERIFY2(checked.err.contains("r/speed") && checked.err.contains("warning E325"), shown(checked));
    }
};

QTEST_GUILESS_MAIN(LogsFlowTest)
#include "logs_test.moc"
