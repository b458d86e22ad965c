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
