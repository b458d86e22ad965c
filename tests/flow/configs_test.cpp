// The shipped texts in configs/: printed byte for byte, loaded without diagnostics, well formatted, and run.
#include "flow/cli.h"

class ConfigsTest : public QObject {
    Q_OBJECT

    static void rows() {
        QTest::addColumn<QString>("path");
        for (const QString& path : allConfigs())
            QTest::newRow(qPrintable(QDir(TRUNDLE_SOURCE_DIR "/configs").relativeFilePath(path))) << path;
    }

private Q_SLOTS:
    void printsBackByteForByte_data() { rows(); }
    void printsBackByteForByte() {
        QFETCH(QString, path);
        const Outcome print = cli({"print", path});
        QCOMPARE(print.code, 0);
        QCOMPARE(print.out, contentOf(path));
    }
    void loadsAloneWithoutDiagnostics_data() { rows(); }
    void loadsAloneWithoutDiagnostics() {
        QFETCH(QString, path);
        const Outcome check = cli({"check", path, "--json"});
        QVERIFY2(check.code == 0, shown(check));
        QCOMPARE(QJsonDocument::fromJson(check.out).array(), QJsonArray());
        QCOMPARE(check.err, QByteArray());
    }
    void isInTheHouseStyle_data() { rows(); }
    void isInTheHouseStyle() {
        QFETCH(QString, path);
        const Outcome format = cli({"format", path, "--check"});
        QVERIFY2(format.code == 0, shown(format));
    }
    void everyExperimentRuns_data() {
        QTest::addColumn<QString>("path");
        for (const QString& path : allConfigs())
            if (contentOf(path).contains("#loadModule")) QTest::newRow(qPrintable(QFileInfo(path).fileName())) << path;
    }
    void everyExperimentRuns() {
        QFETCH(QString, path);
        QTemporaryDir logs;
        const Outcome run = cli({"run", path, "--duration", "1", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(run.out.contains("x real time"), shown(run));
    }
    void checkReportsErrorsAsJson() {
        QTemporaryDir folder;
        const QString path = folder.filePath("wrong.sim");
        QVERIFY(writeFile(path, "Surface rubber { Frictoin=0.8 }\n"));
        const Outcome check = cli({"check", path, "--json"});
        QCOMPARE(check.code, 1);
        const QJsonObject entry = QJsonDocument::fromJson(check.out).array().first().toObject();
        QStringList keys = entry.keys();
        keys.sort();
        QCOMPARE(keys, (QStringList{"code", "column", "end_column", "end_line", "file", "fixes", "line", "message", "severity",
                                    "suggestions"}));
        QCOMPARE(entry["line"].toInt(), 1);
        QCOMPARE(entry["column"].toInt(), 18);
        QCOMPARE(entry["end_line"].toInt(), 1);
        QCOMPARE(entry["end_column"].toInt(), 26); // exclusive
        QCOMPARE(entry["code"].toString(), QString("E201"));
        QCOMPARE(entry["suggestions"].toArray().first().toString(), QString("Friction"));
    }
    void manualListsBuiltInAndModuleKinds() {
        for (const char* kind : {"RotaryMotor", "PoseLog", "Body", "LinearMotion"}) {
            const Outcome page = cli({"describe", kind});
            QVERIFY2(page.code == 0, shown(page));
            QVERIFY2(page.out.startsWith(kind), shown(page));
            QVERIFY(QJsonDocument::fromJson(cli({"describe", kind, "--json"}).out).object()["properties"].isArray());
            QVERIFY(cli({"describe"}).out.contains(kind));
        }
    }
};

QTEST_GUILESS_MAIN(ConfigsTest)
#include "configs_test.moc"
