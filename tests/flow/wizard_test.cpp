// Robots from dimensions: the experiment that `trundle-cli new robot` writes drives its square, measured by the true pose of the robot.

#include "flow/cli.h"
#include "square_path.h"

class WizardFlowTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

private Q_SLOTS:
    void drivesItsSquare_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<double>("side");
        QTest::addColumn<double>("radius"); // of its corners
        for (const auto& [base, radius] :
             {std::pair{"differential", 0.}, {"skid-steer", 0.}, {"omni", 0.}, {"mecanum", 0.}, {"ackermann", 0.65}})
            QTest::newRow(base) << QStringList{"--base", base} << (radius > 0 ? 2. : 1.) << radius;
        QTest::newRow("small differential") << QStringList{"--length",           "0.12", "--width",        "0.08",
                                                           "--height",           "0.05", "--wheel-radius", "0.02",
                                                           "--wheel-separation", "0.1",  "--mass",         "0.4",
                                                           "--top-speed",        "0.3"}
                                            << 1. << 0.;
        QTest::newRow("long skid-steered") << QStringList{"--base",      "skid-steer", "--length", "0.4",
                                                          "--wheelbase", "0.3",        "--mass",   "6"}
                                           << 1. << 0.;
        QTest::newRow("heavy mecanum")
            << QStringList{"--base",         "mecanum", "--length",           "0.8", "--width",     "0.5", "--height", "0.3",
                           "--wheel-radius", "0.1",     "--wheel-separation", "0.6", "--wheelbase", "0.5", "--mass",   "60",
                           "--top-speed",    "1.5"}
            << 1. << 0.;
    }
    void drivesItsSquare() {
        QFETCH(QStringList, options);
        QFETCH(double, side);
        QFETCH(double, radius);
        const QString name = QString("R%1").arg(QString(QTest::currentDataTag()).remove(QRegularExpression("[^a-z]")));
        const Outcome made = cli(QStringList{"new", "robot", name, "--in", m_folder.path()} + options);
        QVERIFY2(made.code == 0, shown(made));
        const QString file = name.toLower(), at = m_folder.filePath(file), experiment = at + "/" + file + "_square.sim";
        const QRegularExpression slope("slopes of up to [0-9]+ degrees");
        const QString climbed = slope.match(made.out).captured();
        QVERIFY2(!climbed.isEmpty() && contentOf(at + "/" + file + ".sim").contains(climbed.toUtf8()), shown(made));
        const Outcome checked = cli({"check", "--trust", experiment});
        QVERIFY2(checked.code == 0 && !checked.err.contains("warning"), shown(checked));
        for (const char* end : {".sim", "_square.sim"}) {
            const Outcome formatted = cli({"format", "--check", at + "/" + file + end});
            QVERIFY2(formatted.code == 0, shown(formatted));
        }
        const Outcome run = cli({"run", "--trust", experiment, "--log-dir", at + "/logs"});
        QVERIFY2(run.code == 0 && !run.err.contains("warning"), shown(run));

        const SquarePath path(contentOf(at + "/logs/" + file + "_square.csv"), side, radius);
        QVERIFY(path.places.size() > 100);
        qInfo("%s: at most %.1f mm beside a corner, %.4f m from edge to edge", QTest::currentDataTag(), path.worst * 1e3,
              path.across);
        QVERIFY2(path.worst < 0.02 * side, shown(run));
        QVERIFY2(std::abs(path.across - side) < 0.02 * side, shown(run));
    }

    void aSecondOneOfTheSameNameIsRefused() {
        QVERIFY(cli({"new", "robot", "Twin", "--in", m_folder.path()}).code == 0);
        const QByteArray before = contentOf(m_folder.filePath("twin/twin.sim"));
        const Outcome again = cli({"new", "robot", "Twin", "--in", m_folder.path(), "--mass", "9"});
        QVERIFY2(again.code == 2 && again.err.contains("it exists"), shown(again));
        QCOMPARE(contentOf(m_folder.filePath("twin/twin.sim")), before);
    }

    /// The robot of the experiment has another name where its own is a word of the language or used in the experiment.
    void namesThatTheExperimentUses_data() {
        QTest::addColumn<QString>("robot");
        for (const char* name : {"Floor", "Overview", "Path", "World", "True", "False"}) QTest::newRow(name) << "robot0";
        QTest::newRow("My_Rover") << "my_Rover";
    }
    void namesThatTheExperimentUses() {
        QFETCH(QString, robot);
        const QString name = QTest::currentDataTag(), file = name.toLower();
        const Outcome made = cli({"new", "robot", name, "--in", m_folder.path()});
        QVERIFY2(made.code == 0, shown(made));
        const QString experiment = m_folder.filePath(file + "/" + file + "_square.sim");
        const Outcome checked = cli({"check", "--trust", experiment});
        QVERIFY2(checked.code == 0 && !checked.err.contains("warning"), shown(checked));
        QVERIFY2(contentOf(experiment).contains("\nRobot " + robot.toUtf8() + " {"), contentOf(experiment));
    }

    void refusedNamesAndOptions_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("why");
        const auto row = [](const char* name, const QStringList& words, const char* why) {
            QTest::newRow(name) << words << QByteArray(why);
        };
        row("the floor of a robot", {"robot", "OpenFloor"}, "its experiment imports a config of that name");
        row("the robot of an arena", {"arena", "SimpleRobot"}, "its experiment imports a config of that name");
        row("the robot of a maze", {"arena", "SimpleRobot", "--maze", "3", "3"}, "its experiment imports a config of that name");
        row("reserved, of a robot", {"robot", "Param"}, "a reserved word");
        row("reserved, of an arena", {"arena", "Param"}, "a reserved word");
        row("a sign", {"arena", "My-Room"}, "letters, digits and _, like Office");
        row("a maze of a robot", {"robot", "Never", "--maze", "3", "3"}, "--maze: it is for `new arena`, not for `new robot`");
        row("two axles of one", {"robot", "Never", "--wheelbase", "0.3"}, "--wheelbase: a base that is differential has no two axles");
        row("a wheel of an arena", {"arena", "Never", "--wheel-radius", "0.1"}, "it is for `new robot`, not for `new arena`");
        row("walls of a controller", {"controller", "Never", "--light-walls"}, "it is for `new arena`, not for `new controller`");
        row("a base of a component", {"component", "Never", "--base", "omni"}, "it is for `new robot`, not for `new component`");
    }
    void refusedNamesAndOptions() {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, why);
        const QTemporaryDir folder;
        const Outcome refused = cli(QStringList{"new"} + words + QStringList{"--in", folder.path()});
        QVERIFY2(refused.code == 2 && refused.err.contains(why), shown(refused));
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void nothingIsWrittenWithoutAMotor() {
        const Outcome fast = cli({"new", "robot", "Racer", "--in", m_folder.path(), "--top-speed", "12"});
        QVERIFY2(fast.code == 2 && fast.err.contains("No motor is fast enough"), shown(fast));
        QVERIFY(!QFileInfo::exists(m_folder.filePath("racer")));
        const Outcome named = cli({"new", "robot", "no name", "--in", m_folder.path()});
        QVERIFY2(named.code == 2 && named.err.contains("like Rover"), shown(named));
    }
};

QTEST_APPLESS_MAIN(WizardFlowTest)
#include "wizard_test.moc"
