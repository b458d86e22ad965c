// The radio navigation experiments, run by the CLI: the bearing is correct and the robot reaches its target.

#include "flow/cli.h"

namespace {

/// Cells of a log by row, without the header.
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

    void robotUsesRadioWheelsAndTouchOnly() {
        // A controller can only read the signals that it binds.
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
        const QJsonObject result = QJsonDocument::fromJson(run.out).object(), robots = result["robots"].toObject();
        const QJsonObject finished = result["finished"].toObject();
        QCOMPARE(finished["robot"].toString() + "/" + finished["controller"].toString() + ": " + finished["reason"].toString(),
                 QString("robot_0/brain: reached"));
        QCOMPARE(finished["time"].toDouble(), result["simulated_s"].toDouble());
        QVERIFY2(finished["time"].toDouble() < 299, "it idled to its end");
        const QJsonArray there = robots["robot_0"].toObject()["pos"].toArray(),
                         target = robots["target_0"].toObject()["pos"].toArray();
        const double away = std::hypot(there[0].toDouble() - target[0].toDouble(), there[1].toDouble() - target[1].toDouble());
        const QList<QByteArrayList> legs = linesOf(logs.filePath("navigation.csv"));
        QVERIFY2(!legs.isEmpty() && legs.last()[1] == "arrived", shown(run));
        QVERIFY2(away < 1.4, qPrintable(QString("%1 m away").arg(away)));
        QVERIFY2(legs.size() > 3, "it heard the target from the start");
    }

    /// Thesis 4.2.2. The mote in the target's corner of the square hears it; the hop count grows with the distance.
    void eachMotesHopsAndCostAreLogged() {
        QTemporaryDir logs;
        const Outcome run = cli({"run", configPath("experiments/network_navigation.sim"), "--seed", "20261122", "--duration",
                                 "10", "--json", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        const QList<QByteArrayList> rows = linesOf(logs.filePath("gradient.csv"));
        QCOMPARE(rows.size(), 11);
        QCOMPARE(rows[0].size(), 1 + 16 * 2);
        const QByteArray head = contentOf(logs.filePath("gradient.csv")).split('\n')[0];
        QVERIFY2(head.startsWith("time [s],motes_0/brain/hops,motes_0/brain/cost,motes_1/brain/hops,"), head.constData());
        for (int i = 1; i < rows[0].size(); ++i) QCOMPARE(rows[0][i], QByteArray("-1")); // no mote has a route yet
        const QByteArrayList& last = rows.last();
        for (int mote = 0; mote < 16; ++mote) {
            const int hops = last[1 + 2 * mote].toInt(), cost = last[2 + 2 * mote].toInt();
            QVERIFY2(hops >= 1 && hops <= 6 && cost >= 10 * hops, last.join(',').constData());
        }
        QCOMPARE(last[1 + 2 * 15], QByteArray("1"));
        QVERIFY(last[1].toInt() > 1);
        const QJsonObject robots = QJsonDocument::fromJson(run.out).object()["robots"].toObject();
        QCOMPARE(robots["target_0"].toObject()["signals"].toObject()["brain/hops"].toInt(-5), 0);
    }

    /// A robot of 30 kg drives into both with a wheel and a slider.
    void motesStayWhereTheyArePlaced() {
        QTemporaryDir folder;
        QFile text(folder.filePath("push.sim"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write(
            "Tick = 0.02   Duration = 8\n#import robots/amr.sim\n#import robots/tmote_sky.sim\n#import arenas/open_floor.sim\n"
            "#loadModule controllers/linear_motion\nStatic floor { Config=OpenFloor }\n"
            "Robot robot0 { Config=Amr  Pos=-1,0,0  LinearMotion brain { Distance=3 Speed=0.5 } }\n"
            "Robot mote0 { Config=TmoteSky  Pos=0,0.14,0 }\nRobot mote1 { Config=TmoteSky  Pos=0,-0.23,0 }\n");
        text.close();
        const Outcome run = cli({"run", text.fileName(), "--json"});
        QVERIFY2(run.code == 0, shown(run));
        const QJsonObject robots = QJsonDocument::fromJson(run.out).object()["robots"].toObject();
        QVERIFY(robots["robot0"].toObject()["pos"].toArray()[0].toDouble() > 1); // it drove past them
        for (const char* mote : {"mote0", "mote1"}) {
            const QJsonArray pos = robots[mote].toObject()["pos"].toArray();
            QVERIFY2(std::abs(pos[0].toDouble()) < 0.001 && std::abs(pos[2].toDouble()) < 0.001, shown(run));
        }
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

    /// 100 networks of each layout with new seeds; the script fails where too few robots arrive.
    void aHundredRunsOfEach() {
        if (!isLong()) return; // to run it by hand: tests/bench/radio_series.py
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
