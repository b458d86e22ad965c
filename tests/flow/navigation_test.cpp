// The radio experiments as a user runs them: is the bearing right, does the robot get there.

#include "flow/cli.h"

namespace {

/// Cells of a log by line, the head left out.
QList<QByteArrayList> linesOf(const QString& path) {
    QList<QByteArrayList> lines;
    for (const QByteArray& line : contentOf(path).trimmed().split('\n')) lines << line.split(',');
    if (!lines.isEmpty()) lines.removeFirst();
    return lines;
}

bool isLong() { return qEnvironmentVariableIsSet("TRUNDLE_LONG"); }

} // namespace

class NavigationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bearingsAreFound() {
        QList<double> errors;
        const double step = isLong() ? 5 : 45;
        for (double angle = -180; angle < 180; angle += step) {
            QTemporaryDir logs;
            const Outcome run = cli({"run", configPath("experiments/turn_angle.sim"), "--set",
                                     QString("angle=%1").arg(angle + 3.3), "--log-dir", logs.path()});
            QVERIFY2(run.code == 0, shown(run));
            const QList<QByteArrayList> found = linesOf(logs.filePath("bearings.csv"));
            QCOMPARE(found.size(), 5);
            for (const QByteArrayList& line : found) {
                const double truth = angle + 3.3 + 72 * (line[0].toInt() - 1);
                errors << std::abs(std::remainder(line[2].toDouble() - truth, 360));
            }
        }
        std::sort(errors.begin(), errors.end());
        const double median = errors[errors.size() / 2], most = errors[errors.size() * 95 / 100];
        qInfo("%lld bearings: median error %.2f deg, 95 %% within %.2f deg", static_cast<long long>(errors.size()), median, most);
        QVERIFY(median <= 3);
        QVERIFY(most <= 10);
    }

    void theRobotKnowsRadioWheelsAndTouchOnly() {
        // what the controllers bind is all they can know
        for (const char* source :
             {"network_navigator/network_navigator.cpp", "network_navigator/bearing_sweep.h", "network_navigator/listener.h",
              "network_navigator/sweep.cpp", "mote/mote.cpp", "mote/beacon.h"}) {
            const QByteArray text = contentOf(QStringLiteral(TRUNDLE_SOURCE_DIR "/plugins/controllers/") + source);
            QVERIFY2(!text.startsWith("(cannot read"), source);
            for (const char* word : {"groundTruth", "signal(", "camera(", "motor("})
                QVERIFY2(!text.contains(word), qPrintable(QString("%1 uses %2").arg(source, word)));
        }
    }

    void theTargetIsReached_data() {
        QTest::addColumn<QString>("layout");
        QTest::newRow("square") << "network_navigation.sim";
        for (const char* layout : {"scattered", "walls"})
            QTest::newRow(layout) << QString("network_navigation/%1.sim").arg(layout);
    }
    void theTargetIsReached() {
        QFETCH(QString, layout);
        QTemporaryDir logs;
        const Outcome run =
            cli({"run", configPath("experiments/" + layout), "--seed", "20261122", "--json", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject robots = QJsonDocument::fromJson(run.out).object()["robots"].toObject();
        const QJsonArray there = robots["robot_0"].toObject()["pos"].toArray(),
                         target = robots["target_0"].toObject()["pos"].toArray();
        const double away = std::hypot(there[0].toDouble() - target[0].toDouble(), there[1].toDouble() - target[1].toDouble());
        const QList<QByteArrayList> legs = linesOf(logs.filePath("navigation.csv"));
        QVERIFY2(!legs.isEmpty() && legs.last()[1] == "arrived", shown(run));
        QVERIFY2(away < 1.4, qPrintable(QString("%1 m away").arg(away)));
        QVERIFY2(legs.size() > 3, "it heard the target from the start");
    }

    void twoRunsAreTheSameRun() {
        QByteArray first;
        for (int i = 0; i < 2; ++i) {
            QTemporaryDir logs;
            const Outcome run = cli({"run", configPath("experiments/network_navigation/scattered.sim"), "--duration", "20",
                                     "--hash", "--quiet", "--log-dir", logs.path()});
            QVERIFY2(run.code == 0, shown(run));
            const QByteArray story = run.out + contentOf(logs.filePath("navigation.csv"));
            QVERIFY(story.contains("state-hash"));
            if (i == 0) first = story;
            QCOMPARE(story, first);
        }
    }

    /// 100 networks of each layout with seeds that nobody has seen; the script fails where too few arrive.
    void aHundredRunsOfEach() {
        if (!isLong()) return; // by hand: tests/bench/radio_series.py
        const Outcome series =
            callProgram("python3",
                        {QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/bench/radio_series.py"), "--build",
                         QStringLiteral(TRUNDLE_BINARY_DIR), "--model", "ideal", "--only", "navigation", "--dry"},
                        {}, 50 * 60);
        QVERIFY2(series.code == 0, shown(series));
        qInfo("%s", series.out.constData());
    }
};

QTEST_GUILESS_MAIN(NavigationTest)
#include "navigation_test.moc"
